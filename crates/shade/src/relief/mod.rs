//! Rays against relief below a plane: where a ray first meets a height map, and what it costs to find out.
//!
//! # Theory
//!
//! A ray enters the *top plane*, which the highest sample touches, at a place and goes down and away from the eye. It is
//! followed by its *depth* d, 0 on the top plane and 1 at the lowest sample, and stands in texels at place + d · step, the
//! step the same for the whole ray. The relief there has the depth D, bilinear between samples; the ray is outside while
//! D > d, and its *first hit* is the least d with D ≤ d. Every ray has one, as nothing is deeper than 1.
//!
//! A search takes any [`Start`] and says what it [`Found`] and what it fetched on the way. [`TracedRelief`] is the truth:
//! cell by cell, each solved exactly. What steps until it is inside ([`LinearSearch`], [`ParallaxOcclusion`]) can step
//! over a spike; what knows free space ([`ConeSteps`], [`MaximumMipTraversal`]) can not, and neither can a start that is
//! *proven* to lie before the first hit.
//!
//! # The default
//!
//! A conservative [`DepthMapStart`] and [`MaximumMipTraversal`]: exact, nearly free to bake beside the depth map, and on fractal
//! relief and spikes fewer fetches than any search alone that is exact. Mean fetches, heights and tables together, of 256²
//! reliefs 0.15 tile deep with 64² depth maps of 32 rings and 16 azimuths, seen 10 / 35 / 60 / 75° from the normal
//! (`relief_start` in MEASUREMENTS.md):
//!
//! | | fractal | spikes |
//! |---|---|---|
//! | maximum mips | 4.9 / 7.9 / 12 / 17 | 6.8 / 11 / 22 / 44 |
//! | maximum mips from a depth map | 2.7 / 5.3 / 9.4 / 13 | 3.3 / 9.0 / 20 / 40 |
//! | cone steps | 3.9 / 7.4 / 13 / 20 | 6.4 / 17 / 38 / 72 |
//! | cone steps from a depth map | 2.7 / 5.7 / 9.4 / 14 | 3.6 / 14 / 35 / 70 |
//!
//! No combination is best on all relief. Cone steps are the better end on smooth relief, a third fewer fetches at grazing angles,
//! where they need fewer alone, too; mips where little stands out of much that is level, up to half. On bricks either does
//! better alone, cone steps by half, and on white noise, where nearly every footprint has a peak, a start saves little.
//!
//! # Fetches
//!
//! A filtered sample of the heights, or a gather of the four around a place, is one fetch of a height. A filtered sample of a
//! cone map, or one texel of a mip or a depth map, is one fetch of a table.
//!
//! # Conventions
//!
//! `towards` points from the surface to the eye or the light in the frame (u, v up the picture, height); θ is its angle from
//! the normal. Depths are parts of the relief's thickness; ratios of lengths (tangents) are pure numbers. Places are in
//! texels from the centre of texel (0, 0), rows downwards. Beyond the tile the heights' own edge policy holds.

mod cell;
mod cones;
mod depth_map;
mod heat;
mod linear;
mod matching;
mod maximum_mip;
mod occlusion;
mod parallax;
mod quadrature;
mod ray;
mod relaxed_cones;
mod road;
mod shadow;
mod stage;
mod start;
mod surface;
mod traced;
mod view;

pub use cones::ConeSteps;
pub use depth_map::DepthMapStart;
pub use heat::heat_map;
pub use linear::LinearSearch;
pub use matching::MismatchedRelief;
pub use maximum_mip::MaximumMipTraversal;
pub use occlusion::{HemisphereOcclusion, MAP_TOLERANCE, Occlusion};
pub use parallax::ParallaxOcclusion;
pub use quadrature::{HemisphereCell, HemisphereQuadrature};
pub use ray::ReliefRay;
pub use relaxed_cones::RelaxedConeSteps;
pub use road::ReliefRoad;
pub use shadow::{ReliefShadow, SHADOW_TOLERANCE, ShadowAnswer};
pub use stage::{ReliefStage, StageBase, StageEye};
pub use surface::Relief;
pub use traced::TracedRelief;
pub use view::{ReliefLight, ReliefPixel, ReliefPixels, relief_direction};

use std::ops::AddAssign;

/// Most steps of a linear search.
const MOST_STEPS: u32 = 1 << 20;

/// What a search read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Fetches {
    /// Filtered samples and gathers of the heights.
    pub heights: u32,
    /// Samples of the tables beside them: cones, mips, depths.
    pub tables: u32,
}

impl Fetches {
    /// One fetch of a height.
    pub const HEIGHT: Self = Self { heights: 1, tables: 0 };

    /// One fetch of a table.
    pub const TABLE: Self = Self { heights: 0, tables: 1 };

    /// Of heights and tables together.
    #[must_use]
    pub fn total(&self) -> u32 {
        self.heights.saturating_add(self.tables)
    }
}

impl AddAssign for Fetches {
    fn add_assign(&mut self, more: Self) {
        self.heights = self.heights.saturating_add(more.heights);
        self.tables = self.tables.saturating_add(more.tables);
    }
}

/// Where a search ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Found {
    /// The depth of the hit, 0 to 1; [`ReliefRay::at`] tells the place.
    pub depth: f64,
    /// All that was read, that of the start included.
    pub fetches: Fetches,
}

/// Where a search begins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Start {
    /// The depth to begin at, 0 to 1.
    pub depth: f64,
    /// Whether nothing above that depth can be hit. Otherwise a search looks whether it begins inside the relief, and walks
    /// back out.
    pub proven: bool,
    /// What finding the start has read.
    pub fetches: Fetches,
}

impl Start {
    /// The top plane: always proven, and for nothing.
    pub const TOP: Self = Self { depth: 0.0, proven: true, fetches: Fetches { heights: 0, tables: 0 } };
}

/// A way to find the first hit of a ray.
pub trait ReliefSearch {
    /// What the method is called in tables and on pictures.
    fn name(&self) -> &'static str;

    /// Where the ray meets the relief at or behind the start. It ends for every ray.
    fn find(&self, ray: &ReliefRay, start: Start) -> Found;
}
