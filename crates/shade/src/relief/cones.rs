//! Cone steps that end in an exact cell.
//!
//! # Theory
//!
//! At a place of the surface a cone map holds the ratio r of a cone that opens upwards and holds no surface. A ray a gap g
//! above that place, moving s along the plane per length down, can sink
//!
//! > r g / (s + r)
//!
//! before it leaves the cone: free space, so nothing is stepped over. Such steps shrink towards the surface without
//! reaching it. Where a step does not get out of the cell of four heights it is in, the four are gathered and the cell is
//! solved: a hit without error, or a step to the cell's end.
//!
//! Jonathan Dummer, *Cone Step Mapping: An Iterative Ray-Heightfield Intersection Algorithm*, 2006.
//!
//! # Departures
//!
//! - The paper's cones hold at texels. `barchan_asset`'s hold wherever a texel has weight under bilinear filtering, and gap and
//!   ratio are one filtered sample.
//! - The paper takes a fixed number of steps and stops close to the surface.
//! - After a cell without a hit the gap is known without a fetch. If the ratio last seen says that a step from there would not
//!   get out of the next cell either, that is gathered at once. So is the first behind a start that was looked up, if a hit is
//!   likely to be in it. A guess only costs or saves a fetch, never a hit.

use barchan_asset::{ConeMapView, TableView};

use super::cell::Cell;
use super::matching::{MismatchedRelief, check_range, check_texels};
use super::start::{leave_relief_to, way_ahead};
use super::{Fetches, Found, Relief, ReliefRay, ReliefSearch, Start};
use crate::Texture;

/// A hit that is likely to be nearer than this is looked for in the cell the ray is in.
const NEAR_TEXELS: f64 = 0.5;

/// Cone stepping.
#[derive(Debug, Clone)]
pub struct ConeSteps<'a> {
    relief: Relief<'a>,
    cones: Cones,
}

/// A cone map as it is sampled.
#[derive(Debug, Clone)]
pub(crate) struct Cones {
    depth: Texture,
    ratio: Texture,
}

impl Cones {
    /// Decodes both channels.
    pub(crate) fn new(table: &TableView<'_>) -> Self {
        Self { depth: Texture::of_channel(table, 0, 0), ratio: Texture::of_channel(table, 0, 1) }
    }

    /// The gap below a ray at a depth of it, no greater than it is, and the ratio of the cone there. One fetch of a table.
    #[inline]
    pub(crate) fn sample(&self, ray: &ReliefRay, depth: f64) -> (f64, f64) {
        let (x, y) = ray.at(depth);
        (self.depth.sample(x, y) - depth, self.ratio.sample(x, y))
    }
}

/// How far a ray can sink from a gap above the tip of a cone.
#[inline]
pub(crate) fn step(ray: &ReliefRay, gap: f64, ratio: f64) -> f64 {
    // Along the normal all of the gap is free, whatever the ratio.
    let part = if ray.tangent() > 0.0 { ratio / (ray.tangent() + ratio) } else { 1.0 };
    // A damaged table may hold anything; no gap is wider than the relief is thick.
    if gap > 0.0 && part > 0.0 { (gap * part).min(1.0) } else { 0.0 }
}

impl<'a> ConeSteps<'a> {
    /// Of a cone map and the heights it was baked of.
    ///
    /// # Errors
    /// A table with another size, spacing, edge or range of depths.
    pub fn new(relief: &Relief<'a>, cones: &ConeMapView<'_>) -> Result<Self, MismatchedRelief> {
        check_texels(relief, cones.descriptor(), "cone map")?;
        check_range(relief, cones.relief(), "cone map")?;
        Ok(Self { relief: *relief, cones: Cones::new(&cones.table()) })
    }
}

impl ReliefSearch for ConeSteps<'_> {
    fn name(&self) -> &'static str {
        "cone steps"
    }

    fn find(&self, ray: &ReliefRay, start: Start) -> Found {
        let mut fetches = start.fetches;
        let mut depth = leave_relief_to(&self.relief, ray, start, &mut fetches);
        let mut cell = Cell::behind(ray, depth);
        let (mut sample, mut last_ratio) = (depth <= 0.0 || way_ahead(ray, depth) >= NEAR_TEXELS, 0.0);
        // It ends: every turn leaves the cell, and a ray's way is bounded.
        loop {
            let exit = cell.exit(ray, depth);
            if sample {
                fetches += Fetches::TABLE;
                let (gap, ratio) = self.cones.sample(ray, depth);
                let next = (depth + step(ray, gap, ratio)).min(1.0);
                last_ratio = ratio;
                if next > exit.depth && exit.depth < 1.0 {
                    (depth, cell) = (next, Cell::behind(ray, next));
                    continue;
                }
            }
            fetches += Fetches::HEIGHT;
            let corners = self.relief.corners(cell);
            if let Some(depth) = cell.first_hit(ray, corners, (depth, exit.depth)) {
                return Found { depth, fetches };
            }
            if exit.depth >= 1.0 {
                return Found { depth: 1.0, fetches };
            }
            let gap = cell.gap(ray, corners, exit.depth);
            (depth, cell) = (exit.depth, exit.next);
            sample = depth + step(ray, gap, last_ratio) > cell.exit(ray, depth).depth;
        }
    }
}
