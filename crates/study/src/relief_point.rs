//! Points of a relief that are asked how much light they get.

use barchan_shade::{
    HemisphereOcclusion, HemisphereQuadrature, Relief, ReliefRoad, ReliefShadow, SHADOW_TOLERANCE, TracedRelief,
};
use glam::DVec3;

use crate::sample::unit;

/// Rings and azimuths of the traced truth.
const TRUTH: (u32, u32) = (32, 32);

/// A point of a relief.
pub(crate) struct ReliefPoint {
    /// In texels.
    pub(crate) place: (f64, f64),
    pub(crate) depth: f64,
    pub(crate) normal: DVec3,
}

impl ReliefPoint {
    /// One of many, the same in every run.
    pub(crate) fn anywhere(relief: &Relief<'_>, index: u64) -> Self {
        let surface = relief.surface();
        let along = |part: u64, texels: u32| unit(2 * index + part) * f64::from(texels) - 0.5;
        let (x, y) = (along(0, surface.heights().width()), along(1, surface.heights().height()));
        Self { place: (x, y), depth: relief.depth_at(x, y), normal: surface.normal(x, y) }
    }

    pub(crate) fn occlusion(&self, method: &HemisphereOcclusion<'_>) -> f64 {
        method.at(self.place, self.depth, self.normal).share
    }
}

/// The truth of a relief: rays of equal weight, each traced.
pub(crate) fn traced_occlusion<'a>(relief: &Relief<'a>, traced: &'a TracedRelief<'a>) -> HemisphereOcclusion<'a> {
    let road = ReliefRoad { depth_map: None, search: traced };
    let shadow = ReliefShadow { relief: *relief, road, tolerance: SHADOW_TOLERANCE };
    HemisphereOcclusion::of_rays(HemisphereQuadrature::even(TRUTH.0, TRUTH.1), shadow)
}
