//! How a ray finds relief: where it starts, and how it goes on.

use super::{DepthMapStart, Found, ReliefRay, ReliefSearch, Start};

/// A start and a search.
#[derive(Clone, Copy)]
pub struct ReliefRoad<'a> {
    /// The depth map that says where rays start; nothing starts them at the top plane.
    pub depth_map: Option<&'a DepthMapStart<'a>>,
    /// How they go on.
    pub search: &'a dyn ReliefSearch,
}

impl ReliefRoad<'_> {
    /// Where a ray starts.
    #[must_use]
    pub fn start(&self, ray: &ReliefRay) -> Start {
        self.depth_map.map_or(Start::TOP, |map| map.start(ray))
    }

    /// Where a ray meets the relief; what the start read is counted.
    #[must_use]
    pub fn find(&self, ray: &ReliefRay) -> Found {
        self.search.find(ray, self.start(ray))
    }
}
