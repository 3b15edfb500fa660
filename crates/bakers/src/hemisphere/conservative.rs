//! Depths that no ray of the cell can meet the relief above.

use std::ops::Range;

use super::HemisphereParams;
use super::depths::Depths;
use crate::{BakeError, Exec};

/// What the conservative mode keeps of a field.
pub(super) struct ConservativeBaker;

impl ConservativeBaker {
    /// Prepares what all layers share. `params` have been accepted for the field.
    pub(super) fn new(_depths: Depths, _params: &HemisphereParams, _exec: &Exec) -> Result<Self, BakeError> {
        Ok(Self)
    }
}

/// Fills some rows of the table in one layer: `values` are `rows.len()` rows of the target's width. It may be called for any rows of any
/// layer from several threads at once.
pub(super) fn bake_rows(_baker: &ConservativeBaker, _layer: u32, _rows: Range<u32>, values: &mut [f32]) {
    values.fill(0.0);
}
