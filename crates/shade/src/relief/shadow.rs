//! Shadows of relief by the road that finds it: the light is an eye, and what it does not see is dark.
//!
//! # Theory
//!
//! From a point of the relief one goes up along the light to the top plane, to the entry C, and from there a relief ray comes down
//! again. If it meets the relief before the point, something stands in the light: Takeshi Suzuki, *An Accelerated Relief Mapping
//! Using Depth Maps*, section 4.1. C may lie outside the tile; the relief goes on there as its edge policy says.
//!
//! # Departures
//!
//! - The comparison has a stated tolerance, a depth: the ray comes down through the point itself, which rounding may put on either
//!   side of it.
//! - Where a conservative depth map starts the ray at the point or beyond, nothing can stand before it: the point is lit, proven by
//!   one fetch, and no search is made.

use glam::DVec3;

use super::{Fetches, Relief, ReliefRay, ReliefRoad};

/// By how much of its whole depth relief must stand before a point to shade it, where nobody says otherwise: above what searches of
/// a fixed number of steps leave over, below what is seen.
pub const SHADOW_TOLERANCE: f64 = 1.0 / 4096.0;

/// Shadow rays through one relief.
#[derive(Clone, Copy)]
pub struct ReliefShadow<'a> {
    /// The relief.
    pub relief: Relief<'a>,
    /// How a ray finds it.
    pub road: ReliefRoad<'a>,
    /// How much less than the point's depth is less, as a part of the relief's whole depth; not negative.
    pub tolerance: f64,
}

/// An answer, and what it cost.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ShadowAnswer {
    /// Whether relief comes between the point and the light.
    pub in_shadow: bool,
    /// What was read.
    pub fetches: Fetches,
}

impl ReliefShadow<'_> {
    /// Whether a point of the relief, at `depth` below the top plane at a place in texels, is in the shadow of a light from
    /// `towards`, a unit vector in the relief's frame. A light on the horizon or below reaches nothing, nor one so near to it that
    /// [`Relief::ray`] gives it up.
    #[must_use]
    pub fn at(&self, place: (f64, f64), depth: f64, towards: DVec3) -> ShadowAnswer {
        let Some(ray) = self.relief.ray_through(place, depth, towards) else {
            return ShadowAnswer { in_shadow: true, fetches: Fetches::default() };
        };
        let clear = depth - self.tolerance;
        let start = self.road.start(&ray);
        if start.proven && start.depth >= clear {
            return ShadowAnswer { in_shadow: false, fetches: start.fetches };
        }
        let found = self.road.search.find(&ray, start);
        ShadowAnswer { in_shadow: found.depth < clear, fetches: found.fetches }
    }
}

impl Relief<'_> {
    /// The ray from the top plane down through a point at `depth` below a place in texels; nothing where `towards`, a unit vector to the
    /// eye or the light, does not point up.
    #[must_use]
    pub fn ray_through(&self, (x, y): (f64, f64), depth: f64, towards: DVec3) -> Option<ReliefRay> {
        let (below_x, below_y) = self.ray(x, y, towards)?.at(depth);
        // As far up along the light as a ray from here goes down.
        self.ray(2.0 * x - below_x, 2.0 * y - below_y, towards)
    }
}
