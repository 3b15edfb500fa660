//! The least depth of square windows, beginning at every texel.
//!
//! A plane holds one window size, row by row and with a margin of what lies beyond the edge, so that sixteen neighbours are read at once
//! wherever a ray has led them. The plane of windows of one texel is the depths themselves.

use barchan_field::{Edge, Grid};
use fearless_simd::{Simd, f32x16, prelude::*};

use super::depths::Depths;
use crate::BakeError;
use crate::memory::zeros;

/// Neighbouring rays followed together.
pub(super) const LANES: usize = 16;

/// The sides of the windows in texels, each a multiple of the one before. Sides of 1, 2, 16 or of 1, 2, 4, 16, 64 cost the same
/// within a tenth; all powers of two up to 32 a fifth more.
pub(super) const SIDES: [usize; 4] = [1, 2, 8, 32];

/// Texels kept before the first of a clamped field: a window that begins further out reaches it with no lane.
const BEFORE: usize = LANES + SIDES[SIDES.len() - 1];

/// Columns kept beyond the last: what the lanes and their right-hand neighbours read there.
const BEYOND: usize = LANES + 1;

/// All planes of a field.
pub(super) struct Windows {
    columns: Axis,
    rows: Axis,
    /// From row to row, and from plane to plane.
    stride: usize,
    plane: usize,
    values: Vec<f32>,
}

/// Where a window lies from the texel of the first lane.
#[derive(Debug, Clone, Copy)]
pub(super) struct Offset {
    plane: usize,
    columns: i64,
    rows: i64,
}

impl Windows {
    pub(super) fn new(depths: &Depths) -> Result<Self, BakeError> {
        let Grid { width, height, edge, .. } = depths.grid;
        let (columns, rows) = (Axis::new(edge, width), Axis::new(edge, height));
        let stride = columns.before + width as usize + BEYOND;
        let plane = (rows.before + height as usize + 2) * stride;
        let values = zeros("the least depths of the relief", (SIDES.len() * plane) as u64)?;
        let mut windows = Self { columns, rows, stride, plane, values };
        windows.fill(0, |_, column, row| {
            depths.values[edge.resolve(row, height) * width as usize + edge.resolve(column, width)]
        });
        for (level, sides) in SIDES.windows(2).enumerate() {
            let parts = (0..sides[1]).step_by(sides[0]);
            windows.fill(level + 1, |windows, column, row| {
                let of_row = |down: usize| parts.clone().map(move |along| (column + along as i64, row + down as i64));
                let parts = parts.clone().flat_map(of_row);
                parts.map(|(column, row)| windows.least(level, column, row)).fold(f32::INFINITY, f32::min)
            });
        }
        Ok(windows)
    }

    /// Where a window of [`SIDES`]`[level]` that begins so many columns and rows from a texel is found.
    pub(super) fn offset(&self, level: usize, columns: i64, rows: i64) -> Offset {
        Offset {
            plane: level * self.plane,
            columns: self.columns.within_tile(columns),
            rows: self.rows.within_tile(rows),
        }
    }

    /// Where in memory the window of the first lane is, whose texel is given.
    #[inline(always)]
    pub(super) fn place(&self, texel: (usize, usize), offset: Offset) -> usize {
        let (column, row) = (self.columns.place(texel.0, offset.columns), self.rows.place(texel.1, offset.rows));
        offset.plane + row * self.stride + column
    }

    /// The windows of sixteen neighbours along a row, the first at a place in memory.
    #[inline(always)]
    pub(super) fn load<S: Simd>(&self, simd: S, place: usize) -> f32x16<S> {
        f32x16::from_slice(simd, &self.values[place..][..LANES])
    }

    /// The depths of the four corners of sixteen cells, `[row][column]`.
    #[inline(always)]
    pub(super) fn corners<S: Simd>(&self, simd: S, place: usize) -> [[f32x16<S>; 2]; 2] {
        let below = place + self.stride;
        [[self.load(simd, place), self.load(simd, place + 1)], [self.load(simd, below), self.load(simd, below + 1)]]
    }

    fn fill(&mut self, level: usize, least: impl Fn(&Self, i64, i64) -> f32) {
        let mut row_of_plane = vec![0.0; self.stride];
        for row in 0..self.plane / self.stride {
            for (column, value) in row_of_plane.iter_mut().enumerate() {
                *value = least(self, self.columns.texel(column), self.rows.texel(row));
            }
            self.values[level * self.plane + row * self.stride..][..self.stride].copy_from_slice(&row_of_plane);
        }
    }

    /// The window of a level that begins at any texel.
    fn least(&self, level: usize, column: i64, row: i64) -> f32 {
        self.values[self.place((0, 0), self.offset(level, column, row))]
    }
}

/// How texels along one axis are laid out, and what stands for those beyond the edge.
#[derive(Clone, Copy)]
struct Axis {
    edge: Edge,
    size: i64,
    /// Texels kept before the first.
    before: usize,
}

impl Axis {
    fn new(edge: Edge, size: u32) -> Self {
        let before = if edge == Edge::Clamp { BEFORE } else { 0 };
        Self { edge, size: i64::from(size), before }
    }

    /// The texel at a place.
    fn texel(self, place: usize) -> i64 {
        place as i64 - self.before as i64
    }

    /// An offset that comes to the same and is less than a tile.
    fn within_tile(self, offset: i64) -> i64 {
        if self.edge == Edge::Wrap { offset.rem_euclid(self.size) } else { offset }
    }

    /// The place of what lies an offset, less than a tile, from a texel of the field.
    #[inline(always)]
    fn place(self, texel: usize, offset: i64) -> usize {
        let texel = texel as i64 + offset;
        match self.edge {
            Edge::Wrap if texel >= self.size => (texel - self.size) as usize,
            Edge::Wrap => texel as usize,
            Edge::Clamp => (texel.clamp(-(self.before as i64), self.size) + self.before as i64) as usize,
        }
    }
}
