//! One cell of the bilinear surface under a ray: where the ray leaves it, and where it meets the surface inside.
//!
//! Inside a cell the surface along a ray is a parabola in the ray's depth. Written from one end of the ray's part of the cell
//! to the other, s = 0 to 1, the gap between ray and surface is
//!
//! > G(s) = G₀ + b s + c s², b = G₁ − G₀ − c, c = twist · Δx · Δy,
//!
//! all of it of the size of the depths, so that grazing rays cost no digits. A walk counts the borders it crosses in whole
//! numbers, and does not ask a rounded place on which side of one it is: none can hold it up.

use super::ReliefRay;

/// The cell right of and below a texel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Cell {
    pub(crate) column: i64,
    pub(crate) row: i64,
}

/// Cells side by side: columns and rows from the first up to, but without, the second.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Block {
    pub(crate) columns: (i64, i64),
    pub(crate) rows: (i64, i64),
}

/// The end of a ray's part of a block.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Exit {
    /// At most 1.
    pub(crate) depth: f64,
    /// The cell behind the border.
    pub(crate) next: Cell,
}

impl Cell {
    /// The cell that a ray goes through just behind a depth.
    #[inline]
    pub(crate) fn behind(ray: &ReliefRay, depth: f64) -> Self {
        let (x, y) = ray.at(depth);
        Self { column: index_behind(x, ray.step.0), row: index_behind(y, ray.step.1) }
    }

    /// Where a ray leaves the cell, `from` at the earliest.
    #[inline]
    pub(crate) fn exit(self, ray: &ReliefRay, from: f64) -> Exit {
        Block { columns: (self.column, self.column + 1), rows: (self.row, self.row + 1) }.exit(ray, from)
    }

    /// How far the surface of the cell is below the ray at a depth of it; `corners` are the depths at the cell's.
    #[inline]
    pub(crate) fn gap(self, ray: &ReliefRay, corners: [f64; 4], depth: f64) -> f64 {
        let [d00, d10, d01, _] = corners;
        let (x, y) = ray.at(depth);
        let (x, y) = (x - self.column as f64, y - self.row as f64);
        d00 + (d10 - d00) * x + (d01 - d00) * y + twist(corners) * x * y - depth
    }

    /// The first hit of a ray in its part of the cell, between two depths.
    #[inline]
    pub(crate) fn first_hit(self, ray: &ReliefRay, corners: [f64; 4], (from, to): (f64, f64)) -> Option<f64> {
        let (g0, g1) = (self.gap(ray, corners, from), self.gap(ray, corners, to));
        let part = to - from;
        first_zero(g0, g1, twist(corners) * (part * ray.step.0) * (part * ray.step.1)).map(|s| from + s * part)
    }
}

impl Block {
    /// Where a ray leaves the block, `from` at the earliest, and the cell behind.
    #[inline]
    pub(crate) fn exit(self, ray: &ReliefRay, from: f64) -> Exit {
        let u = border(ray.place.0, ray.step.0, self.columns);
        let v = border(ray.place.1, ray.step.1, self.rows);
        let depth = u.min(v).max(from).min(1.0);
        let mut next = self.cell_behind(ray, depth);
        if u <= v {
            next.column = if ray.step.0 < 0.0 { self.columns.0 - 1 } else { self.columns.1 };
        } else {
            next.row = if ray.step.1 < 0.0 { self.rows.0 - 1 } else { self.rows.1 };
        }
        Exit { depth, next }
    }

    /// The cell of the block that a ray goes through just behind a depth at which it is in the block, whatever rounding says.
    #[inline]
    pub(crate) fn cell_behind(self, ray: &ReliefRay, depth: f64) -> Cell {
        let Cell { column, row } = Cell::behind(ray, depth);
        let within = |index: i64, (low, high): (i64, i64)| index.max(low).min(high - 1);
        Cell { column: within(column, self.columns), row: within(row, self.rows) }
    }
}

/// The cell along one axis that begins at a place, or the one that ends there if that way is gone.
#[inline]
fn index_behind(place: f64, step: f64) -> i64 {
    if step < 0.0 { place.ceil() as i64 - 1 } else { place.floor() as i64 }
}

/// The depth at which a ray reaches the end of a range of texels along one axis.
#[inline]
fn border(place: f64, step: f64, (low, high): (i64, i64)) -> f64 {
    if step == 0.0 {
        return f64::INFINITY;
    }
    let end = if step > 0.0 { high } else { low };
    (end as f64 - place) / step
}

#[inline]
fn twist([d00, d10, d01, d11]: [f64; 4]) -> f64 {
    // 0 where two sides are level, to the bit.
    (d00 - d10) + (d11 - d01)
}

/// The least s in 0..=1 at which the parabola from `g0` to `g1`, with the coefficient `c` of s², is not above 0.
#[inline]
fn first_zero(g0: f64, g1: f64, c: f64) -> Option<f64> {
    if g0 <= 0.0 {
        return Some(0.0);
    }
    let b = g1 - g0 - c;
    let discriminant = b * b - 4.0 * c * g0;
    if g1 > 0.0 && (c <= 0.0 || b >= 0.0 || discriminant < 0.0) {
        // Both ends are outside, and between them the gap has no minimum or one above 0.
        return None;
    }
    let root = discriminant.max(0.0).sqrt();
    // The forms that add what has one sign: nothing cancels.
    let s = if b <= 0.0 { 2.0 * g0 / (root - b) } else { (root + b) / (-2.0 * c) };
    if g1 > 0.0 { (s <= 1.0).then_some(s) } else { Some(s.min(1.0)) }
}
