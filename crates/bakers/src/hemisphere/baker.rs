//! Layers handed to threads, whatever the mode.

use std::ops::Range;

use barchan_asset::{DepthMode, ReliefRange};
use barchan_field::HeightField;

use super::conservative::{self, ConservativeBaker};
use super::depths::Depths;
use super::nearest::{self, NearestBaker};
use super::{HemisphereMap, HemisphereParams};
use crate::memory::zeros;
use crate::{BakeError, Exec};

/// Rows of the table that one thread fills where a single layer of the nearest mode is baked: few enough to keep several threads busy.
const BAND_ROWS: usize = 4;

/// Bakes all directions at once: the same bytes for any number of threads.
pub fn bake(field: &HeightField, params: &HemisphereParams, exec: &Exec) -> Result<HemisphereMap, BakeError> {
    params.check(field)?;
    let texels = params.texels();
    let values = texels as u64 * u64::from(params.directions.layers());
    let mut depths = zeros("the hemisphere map", values)?;
    let baker = HemisphereBaker::new(field, *params, exec)?;
    let layers = depths.chunks_exact_mut(texels).collect();
    exec.for_each(layers, |layer, values: &mut [f32]| baker.bake_rows(layer as u32, 0..params.height, values));
    Ok(HemisphereMap { params: *params, relief: baker.relief(), depths })
}

/// A baker of hemisphere depths of one field, one layer at a time: for tables too large to hold in all directions.
pub struct HemisphereBaker {
    params: HemisphereParams,
    relief: ReliefRange,
    mode: Mode,
}

/// What each mode prepares once for all layers.
enum Mode {
    Nearest(NearestBaker),
    Conservative(ConservativeBaker),
}

impl HemisphereBaker {
    /// Checks the parameters and prepares what all layers share.
    pub fn new(field: &HeightField, params: HemisphereParams, exec: &Exec) -> Result<Self, BakeError> {
        params.check(field)?;
        let depths = Depths::of(field)?;
        let relief = depths.relief;
        let mode = match params.mode {
            DepthMode::Nearest => Mode::Nearest(NearestBaker::new(depths, &params)?),
            // A mode that is not known here gets the depths that are never too great.
            _ => Mode::Conservative(ConservativeBaker::new(&depths, &params, exec)?),
        };
        Ok(Self { params, relief, mode })
    }

    /// What depths are measured in.
    #[must_use]
    pub fn relief(&self) -> ReliefRange {
        self.relief
    }

    /// Fills `values`, `[row][column]`, with the depths of one layer, 0..1: the same bytes for any number of threads.
    ///
    /// # Panics
    /// If there is no such layer, or `values` are not one for every texel of the table.
    pub fn bake_layer(&self, layer: u32, exec: &Exec, values: &mut [f32]) {
        assert!(layer < self.params.directions.layers(), "a layer of the directions");
        assert_eq!(values.len(), self.params.texels(), "one value for every texel of the table");
        let (width, height) = (self.params.width as usize, self.params.height);
        let band_rows = match &self.mode {
            Mode::Nearest(_) => BAND_ROWS,
            // Every band forms masks of all rows that its rays reach.
            Mode::Conservative(_) => (height as usize).div_ceil(exec.threads()),
        };
        let bands = values.chunks_mut(width * band_rows).collect();
        exec.for_each_quietly(bands, |band, values: &mut [f32]| {
            let start = (band * band_rows) as u32;
            self.bake_rows(layer, start..height.min(start + band_rows as u32), values);
        });
    }

    fn bake_rows(&self, layer: u32, rows: Range<u32>, values: &mut [f32]) {
        match &self.mode {
            Mode::Nearest(baker) => nearest::bake_rows(baker, layer, rows, values),
            Mode::Conservative(baker) => conservative::bake_rows(baker, layer, rows, values),
        }
    }
}
