//! The way of a ray below the top plane.

use barchan_asset::{Azimuths, HemisphereDirections, ReliefRange};
use barchan_field::Spacing;

use crate::horizon;

/// How far over the grid a ray is followed, in texels of the finer axis. Only a relief of absurd thickness, or a ray within a thousandth of
/// a degree of the horizontal, goes so far without a hit.
pub(super) const MAX_RAY_TEXELS: f64 = (1 << 17) as f64;

/// How far a ray moves over the grid from the top plane down to depth 1: columns, and rows counted downwards.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct DepthRay {
    pub(super) columns: f64,
    pub(super) rows: f64,
}

impl DepthRay {
    /// The ray that comes from the direction whose horizontal part is `(u, v)` times its part along the normal.
    pub(super) fn new((u, v): (f64, f64), relief: ReliefRange, spacing: Spacing) -> Self {
        // It moves away from where it comes from; v points up the picture, rows are counted downwards.
        Self { columns: -u * relief.thickness / spacing.u(), rows: v * relief.thickness / spacing.v() }
    }

    /// The ray of a layer in the nearest mode: at the inner edge of the ring, in the middle of the azimuth.
    pub(super) fn of_layer(
        directions: &HemisphereDirections,
        layer: u32,
        relief: ReliefRange,
        spacing: Spacing,
    ) -> Self {
        let (ring, azimuth) = directions.ring_and_azimuth(layer);
        let tangent = directions.tangent_of_edge(ring);
        let (cos, sin) = azimuth_vector(&directions.azimuths, azimuth);
        Self::new((tangent * cos, tangent * sin), relief, spacing)
    }

    /// Whether it stays where it enters.
    pub(super) fn is_vertical(self) -> bool {
        self.columns == 0.0 && self.rows == 0.0
    }

    /// How deep it is followed.
    pub(super) fn deepest(self) -> f64 {
        (MAX_RAY_TEXELS / self.columns.abs().max(self.rows.abs())).min(1.0)
    }
}

/// Cosine and sine of an azimuth, exact along the axes.
pub(super) fn azimuth_vector(azimuths: &Azimuths, index: u32) -> (f64, f64) {
    let count = azimuths.count();
    let same = if azimuths.is_full_circle() {
        horizon::Azimuths::full_circle(count)
    } else {
        let [first_degrees, last_degrees] = [0, count - 1].map(|index| azimuths.radians(index).to_degrees());
        horizon::Azimuths::Arc { first_degrees, last_degrees, count }
    };
    same.vector(index)
}

/// The cells that a ray crosses from where it enters, one after the other.
pub(super) struct Crossings {
    ray: DepthRay,
    columns: Axis,
    rows: Axis,
    start: f64,
}

/// A ray's way through one cell.
#[derive(Debug, Clone, Copy)]
pub(super) struct Crossing {
    /// The cell's least column and row.
    pub(super) cell: (i64, i64),
    /// The depths at which the ray enters and leaves.
    pub(super) start: f64,
    pub(super) end: f64,
    /// Where it does, in columns and rows from the cell's corner, within 0..1.
    pub(super) enters: (f64, f64),
    pub(super) leaves: (f64, f64),
}

/// One axis of the grid under a ray.
struct Axis {
    origin: f64,
    speed: f64,
    /// The cell the ray is in. Counted, not found from a place on the ray, which near a border may round into the cell beyond.
    cell: i64,
}

impl Axis {
    fn new(origin: f64, speed: f64) -> Self {
        let cell = if speed < 0.0 { origin.ceil() as i64 - 1 } else { origin.floor() as i64 };
        Self { origin, speed, cell }
    }

    /// The depth at which the ray leaves the cell: never, where it does not move along this axis.
    fn end(&self) -> f64 {
        let border = if self.speed < 0.0 { self.cell } else { self.cell + 1 };
        if self.speed == 0.0 { f64::INFINITY } else { (border as f64 - self.origin) / self.speed }
    }

    fn step(&mut self) {
        self.cell += if self.speed < 0.0 { -1 } else { 1 };
    }

    fn in_cell(&self, depth: f64) -> f64 {
        (self.origin + depth * self.speed - self.cell as f64).clamp(0.0, 1.0)
    }
}

impl Crossings {
    /// Of a ray that enters at a place in columns and rows from the centre of texel (0, 0).
    pub(super) fn new(ray: DepthRay, (x, y): (f64, f64)) -> Self {
        Self { ray, columns: Axis::new(x, ray.columns), rows: Axis::new(y, ray.rows), start: 0.0 }
    }
}

impl Iterator for Crossings {
    type Item = Crossing;

    fn next(&mut self) -> Option<Crossing> {
        let (start, deepest) = (self.start, self.ray.deepest());
        if start >= deepest {
            return None;
        }
        let (to_column, to_row) = (self.columns.end(), self.rows.end());
        let end = to_column.min(to_row).clamp(start, deepest);
        let place = |depth: f64| (self.columns.in_cell(depth), self.rows.in_cell(depth));
        let cell = (self.columns.cell, self.rows.cell);
        let crossing = Crossing { cell, start, end, enters: place(start), leaves: place(end) };
        if to_column <= end {
            self.columns.step();
        }
        if to_row <= end {
            self.rows.step();
        }
        self.start = end;
        Some(crossing)
    }
}
