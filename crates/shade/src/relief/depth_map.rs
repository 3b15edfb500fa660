//! A start out of a hemisphere depth map: the depth at which a ray like this one first met the relief.
//!
//! # Theory
//!
//! The table holds a depth for every texel of the top plane and every cell of directions. A ray looks up the texel it enters in
//! and the cell it comes from: its ring by the tangent of its polar angle, rounded towards the normal, and the nearest
//! azimuth. Takeshi Suzuki, *An Accelerated Relief Mapping Using Depth Maps*.
//!
//! - [`DepthMode::Conservative`]: no ray of the cell meets the relief above that depth. The start is that depth on the ray
//!   itself, and proven.
//! - [`DepthMode::Nearest`], the paper's: P′ is the point at that depth h of the ray along the *stored* direction, at the
//!   polar angle θs. Eq 1 projects it onto the ray along V, OP = (OP′ · V) V / |V|², |OP′| = h / cos θs. With tangents t
//!   and ts and the azimuths Δ apart the projected point is at the depth
//!
//!   > h (1 + t ts cos Δ) / (1 + t²),
//!
//!   never deeper than h while ts cos Δ ≤ t, which rounding towards the normal sees to. That the ray meets nothing above it is not
//!   known: the start is not proven.
//!
//! # Departures
//!
//! - Rays are followed by their depth, and h itself would be the depth to begin at: the two are the same along the stored
//!   direction. Eq 1 is kept for what it is worth: on a fractal relief at 10 / 35 / 60 / 75°, h is behind the first hit of
//!   8 / 12 / 33 / 49 % of rays, eq 1 of 4 / 5 / 5 / 12 %.
//! - A ray beyond the cells that were baked, or that enters beyond an edge that clamps, starts at the top, and nothing is
//!   fetched.

use barchan_asset::{DepthMode, HemisphereView, Wrap};
use glam::DVec2;

use super::matching::{MismatchedRelief, check_range, check_tile};
use super::{Fetches, Relief, ReliefRay, Start};

/// Starts of rays through a relief.
#[derive(Debug, Clone)]
pub struct DepthMapStart<'a> {
    view: HemisphereView<'a>,
    /// Texels of the heights along u and v.
    texels: (u32, u32),
    /// Tangents of the polar angles at which rings begin, and where the last one ends.
    edges: Vec<f64>,
    /// Unit vectors towards the middles of the azimuth cells.
    azimuths: Vec<DVec2>,
}

impl<'a> DepthMapStart<'a> {
    /// The depths of a table for rays through the relief it was baked of.
    ///
    /// # Errors
    /// A table with another tile, edge or range of depths.
    pub fn new(relief: &Relief<'_>, depths: &HemisphereView<'a>) -> Result<Self, MismatchedRelief> {
        check_tile(relief, depths.descriptor(), "hemisphere")?;
        check_range(relief, depths.relief(), "hemisphere")?;
        let directions = depths.directions();
        let towards = |azimuth| {
            let (sin, cos) = libm::sincos(directions.azimuths.radians(azimuth));
            DVec2::new(cos, sin)
        };
        let heights = relief.surface().heights();
        Ok(Self {
            view: *depths,
            texels: (heights.width(), heights.height()),
            edges: (0..=directions.rings).map(|ring| directions.tangent_of_edge(ring)).collect(),
            azimuths: (0..directions.azimuths.count()).map(towards).collect(),
        })
    }

    /// The table.
    #[must_use]
    pub fn view(&self) -> &HemisphereView<'a> {
        &self.view
    }

    /// Where to begin to search along a ray.
    #[must_use]
    pub fn start(&self, ray: &ReliefRay) -> Start {
        let Some(((ring, azimuth), (column, row))) = self.cell(ray).zip(self.texel(ray)) else {
            return Start::TOP;
        };
        let layer = self.view.directions().layer(ring, azimuth);
        let depth = f64::from(self.view.depth(layer, column, row));
        match self.view.mode() {
            DepthMode::Conservative => Start { depth, proven: true, fetches: Fetches::TABLE },
            _ => Start { depth: self.projected(ray, (ring, azimuth), depth), proven: false, fetches: Fetches::TABLE },
        }
    }

    /// The ring and the azimuth of a ray.
    fn cell(&self, ray: &ReliefRay) -> Option<(u32, u32)> {
        let beyond = self.edges.partition_point(|&edge| edge <= ray.tangent());
        if beyond == 0 || beyond == self.edges.len() {
            return None;
        }
        // A ray along the normal comes from any azimuth.
        let azimuth =
            if ray.tangent() > 0.0 { self.view.directions().azimuth_cell(ray.azimuth_radians())? } else { 0 };
        Some((beyond as u32 - 1, azimuth))
    }

    /// The texel of the table that a ray enters in.
    fn texel(&self, ray: &ReliefRay) -> Option<(u32, u32)> {
        let (wrap, (x, y)) = (self.view.wrap(), ray.at(0.0));
        Some((
            texel(wrap.0, x, self.texels.0, self.view.width())?,
            texel(wrap.1, y, self.texels.1, self.view.height())?,
        ))
    }

    /// Eq 1.
    fn projected(&self, ray: &ReliefRay, (ring, azimuth): (u32, u32), depth: f64) -> f64 {
        let level = ray.towards().truncate() / ray.towards().z;
        let along_stored = self.edges[ring as usize] * self.azimuths[azimuth as usize].dot(level);
        (depth * (1.0 + along_stored) / (1.0 + level.length_squared())).clamp(0.0, 1.0)
    }
}

/// Which of `count` texels over a tile of `size` a place is in.
fn texel(wrap: Wrap, place: f64, size: u32, count: u32) -> Option<u32> {
    let size = f64::from(size);
    let along = match wrap {
        Wrap::Repeat => (place + 0.5).rem_euclid(size),
        Wrap::Clamp => place + 0.5,
    };
    // Rounding may end a tile that repeats at its end.
    let index = (along / size * f64::from(count)).floor();
    let inside = (0.0..=size).contains(&along);
    inside.then(|| (index as u32).min(count - 1))
}
