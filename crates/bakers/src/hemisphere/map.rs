//! The typed table a hemisphere bake returns, before any encoding.

use barchan_asset::ReliefRange;

use super::HemisphereParams;

/// The depths at which rays first meet the relief, for every texel of the top plane and every direction.
#[derive(Debug, Clone, PartialEq)]
pub struct HemisphereMap {
    /// What was baked.
    pub params: HemisphereParams,
    /// What depths are measured in.
    pub relief: ReliefRange,
    /// `[layer][row][column]`, 0 at the top plane and 1 at the lowest point of the relief.
    pub depths: Vec<f32>,
}

impl HemisphereMap {
    /// The depths of one direction, row by row.
    #[must_use]
    pub fn layer(&self, layer: u32) -> &[f32] {
        let texels = self.params.texels();
        &self.depths[layer as usize * texels..][..texels]
    }
}
