//! Heights as depths below the highest.

use barchan_asset::ReliefRange;
use barchan_field::{Grid, HeightField};

use crate::BakeError;
use crate::memory::zeros;

/// The depth of every texel of a field.
pub(crate) struct Depths {
    /// The field's.
    pub(crate) grid: Grid,
    pub(crate) relief: ReliefRange,
    /// Row by row, 0 at the highest texel and 1 at the lowest, worked out in f64 and rounded to the nearest f32.
    pub(crate) values: Vec<f32>,
}

impl Depths {
    pub(crate) fn of(field: &HeightField) -> Result<Self, BakeError> {
        let relief = relief_range(field);
        let mut values = zeros("the depths of the relief", field.grid().texels() as u64)?;
        for (depth, &height) in values.iter_mut().zip(field.samples()) {
            *depth = relief.depth(f64::from(height)) as f32;
        }
        Ok(Self { grid: *field.grid(), relief, values })
    }
}

/// What depths of a field are measured in.
pub(crate) fn relief_range(field: &HeightField) -> ReliefRange {
    let (lowest, highest) = field.range();
    ReliefRange { top: f64::from(highest), thickness: f64::from(highest) - f64::from(lowest) }
}
