//! The obvious twin: one ray, walked cell by cell in f64 down to its first hit.
//!
//! Inside one bilinear cell the surface's depth below the ray is a parabola g(s) = g₀ + b s + c s², s from 0 where the ray enters the cell
//! to 1 where it leaves it. The first hit is its least root there. Nothing is sampled: the hit is exact up to f64 rounding.

use barchan_asset::ReliefRange;
use barchan_field::HeightField;
use glam::DVec3;

use super::depths::relief_range;
use super::ray::{Crossing, Crossings, DepthRay};

/// The depth, 0..1, at which a ray that enters the top plane at a place first meets the surface. `x` counts columns and `y` rows from
/// the centre of texel (0, 0), rows downwards; `towards` is where the ray comes from, in the frame (u, v, height), of any length.
///
/// A ray that has crossed 2¹⁷ texels without a hit is left where it is, and the depth of that place returned. A ray that does not come
/// from above, `towards.z` ≤ 0, never gets below the top plane: 0.
#[must_use]
pub fn first_hit(field: &HeightField, x: f64, y: f64, towards: DVec3) -> f64 {
    FirstHits::of(field).find(x, y, towards)
}

/// [`first_hit`] of many rays: the highest and the lowest height of the field are looked for once.
#[derive(Debug, Clone, Copy)]
pub struct FirstHits<'a> {
    field: &'a HeightField,
    relief: ReliefRange,
}

impl<'a> FirstHits<'a> {
    /// Of the rays that meet a field.
    #[must_use]
    pub fn of(field: &'a HeightField) -> Self {
        Self { field, relief: relief_range(field) }
    }

    /// [`first_hit`].
    #[must_use]
    pub fn find(&self, x: f64, y: f64, towards: DVec3) -> f64 {
        let Self { field, relief } = *self;
        if towards.z <= 0.0 || relief.thickness == 0.0 {
            return 0.0;
        }
        let ray = DepthRay::new((towards.x / towards.z, towards.y / towards.z), relief, field.grid().spacing);
        let depth = |column: i64, row: i64| relief.depth(f64::from(field.texel(column, row)));
        let mut crossings = Crossings::new(ray, (x, y));
        crossings.find_map(|crossing| hit(&crossing, depth)).unwrap_or(ray.deepest())
    }
}

/// The first hit on the way through a cell.
fn hit(crossing: &Crossing, depth: impl Fn(i64, i64) -> f64) -> Option<f64> {
    let Crossing { cell: (column, row), start, end, enters, leaves } = *crossing;
    let (d00, d10) = (depth(column, row), depth(column + 1, row));
    let (d01, d11) = (depth(column, row + 1), depth(column + 1, row + 1));
    let surface = |(x, y): (f64, f64)| {
        let (upper, lower) = (d00 * (1.0 - x) + d10 * x, d01 * (1.0 - x) + d11 * x);
        upper * (1.0 - y) + lower * y
    };
    let (above, below) = (surface(enters) - start, surface(leaves) - end);
    let twist = d00 - d10 - d01 + d11;
    let bend = twist * (leaves.0 - enters.0) * (leaves.1 - enters.1);
    first_root(above, below - above - bend, bend).map(|part| start + part * (end - start))
}

/// The least s in 0..1 at which constant + linear s + square s² is 0 or less.
fn first_root(constant: f64, linear: f64, square: f64) -> Option<f64> {
    if constant <= 0.0 {
        return Some(0.0);
    }
    let discriminant = linear * linear - 4.0 * square * constant;
    if discriminant < 0.0 {
        return None;
    }
    // Of both roots, written so that nothing cancels, the least that is positive; if none is, infinite or negative.
    let root = 2.0 * constant / (discriminant.sqrt() - linear);
    (0.0..=1.0).contains(&root).then_some(root)
}
