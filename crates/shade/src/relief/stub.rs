//! stub
use super::{ReliefRay, Start};
use barchan_asset::{DepthMode, HemisphereDirections};
/// stub
#[derive(Debug, Clone)]
pub struct DepthMapStart {
    directions: HemisphereDirections,
}
impl DepthMapStart {
    /// stub
    #[must_use]
    pub fn start(&self, _ray: &ReliefRay) -> Start {
        Start::TOP
    }
    /// stub
    #[must_use]
    pub fn mode(&self) -> DepthMode {
        DepthMode::Nearest
    }
    /// stub
    #[must_use]
    pub fn directions(&self) -> &HemisphereDirections {
        &self.directions
    }
}
