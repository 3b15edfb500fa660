//! The paper's mode: the ray of every source texel followed to its first hit.

use std::ops::Range;

use super::HemisphereParams;
use super::depths::Depths;
use crate::BakeError;

/// What the nearest mode keeps of a field.
pub(super) struct NearestBaker;

impl NearestBaker {
    pub(super) fn new(_depths: Depths, _params: &HemisphereParams) -> Result<Self, BakeError> {
        Ok(Self)
    }
}

/// Fills some rows of the table in one layer: `values` are `rows.len()` rows of the target's width.
pub(super) fn bake_rows(_baker: &NearestBaker, _layer: u32, _rows: Range<u32>, values: &mut [f32]) {
    values.fill(0.0);
}
