//! Heights as depths below their highest.

use glam::DVec3;

use super::ReliefRay;
use super::cell::Cell;
use crate::Surface;

/// A surface as relief below its top plane.
#[derive(Debug, Clone, Copy)]
pub struct Relief<'a> {
    surface: &'a Surface,
    top: f64,
    thickness: f64,
}

impl<'a> Relief<'a> {
    /// The relief of a surface, from its highest sample to its lowest.
    #[must_use]
    pub fn new(surface: &'a Surface) -> Self {
        let (low, high) = surface.heights().range();
        let (low, high) = (f64::from(low), f64::from(high));
        Self { surface, top: high, thickness: high - low }
    }

    /// The surface.
    #[must_use]
    pub fn surface(&self) -> &'a Surface {
        self.surface
    }

    /// The highest sample, and how far the lowest is below it, in the surface's length unit.
    #[must_use]
    pub fn range(&self) -> (f64, f64) {
        (self.top, self.thickness)
    }

    /// The depth of the bilinear surface at a place, 0 to 1; 0 everywhere on a relief without thickness.
    #[inline]
    #[must_use]
    pub fn depth_at(&self, x: f64, y: f64) -> f64 {
        self.depth_of(self.surface.heights().sample(x, y))
    }

    /// The depth of a height.
    #[inline]
    #[must_use]
    pub fn depth_of(&self, height: f64) -> f64 {
        if self.thickness > 0.0 { (self.top - height) / self.thickness } else { 0.0 }
    }

    /// The ray that enters the top plane at a place, in texels, and comes from `towards`.
    ///
    /// None where it does not go down (`towards.z` ≤ 0), or so little that its way to the floor is longer than 2²⁰ texels, and
    /// for a place beyond ±2⁴⁰ texels.
    #[must_use]
    pub fn ray(&self, x: f64, y: f64, towards: DVec3) -> Option<ReliefRay> {
        ReliefRay::new(self.thickness, self.surface.spacing(), (x, y), towards)
    }

    /// How far the surface is below the ray at a depth of it: negative inside the relief. One fetch of a height.
    #[inline]
    pub(crate) fn gap(&self, ray: &ReliefRay, depth: f64) -> f64 {
        let (x, y) = ray.at(depth);
        self.depth_at(x, y) - depth
    }

    /// The depths at the corners of a cell, upper row first. One fetch: a gather.
    #[inline]
    pub(crate) fn corners(&self, cell: Cell) -> [f64; 4] {
        let heights = self.surface.heights();
        [(0, 0), (1, 0), (0, 1), (1, 1)]
            .map(|(i, j)| self.depth_of(f64::from(heights.texel(cell.column + i, cell.row + j))))
    }
}
