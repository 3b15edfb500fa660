//! The height field as the rays of one direction see it.

use barchan_field::{Edge, HeightField};

use super::direction::Octant;

/// Heights turned so that rays run towards larger columns and, more slowly, larger rows.
///
/// "Column" and "row" here count along the ray's longer and shorter component, whatever those are in the picture.
pub(crate) struct Relief {
    pub(crate) octant: Octant,
    pub(crate) edge: Edge,
    heights: Vec<f32>,
    stride: usize,
}

impl Relief {
    /// `margin` further columns and rows are kept beyond the far edges, so that what lies near a texel has a fixed
    /// place from it: [`Relief::near`].
    pub(crate) fn new(field: &HeightField, octant: Octant, margin: usize) -> Self {
        /// Side of the square tiles copied, so that turning by 90° does not miss the cache at every texel.
        const TILE: usize = 32;
        let edge = field.grid().edge;
        let (columns, rows) = (octant.majors + margin, octant.minors + margin);
        let mut heights = vec![0.0; columns * rows];
        for row_tile in (0..rows).step_by(TILE) {
            for column_tile in (0..columns).step_by(TILE) {
                for row in row_tile..(row_tile + TILE).min(rows) {
                    for column in column_tile..(column_tile + TILE).min(columns) {
                        let (major, minor) = (resolve(edge, column, octant.majors), resolve(edge, row, octant.minors));
                        heights[row * columns + column] = field.samples()[octant.index(major, minor)];
                    }
                }
            }
        }
        Self { octant, edge, heights, stride: columns }
    }

    /// Where a texel of the field lies in the copy; [`Relief::near`] takes offsets from it.
    #[inline]
    pub(crate) fn place(&self, column: usize, row: usize) -> usize {
        row * self.stride + column
    }

    /// The height at a place, plus an offset within the margin.
    #[inline]
    pub(crate) fn near(&self, place: usize) -> f64 {
        f64::from(self.heights[place])
    }

    /// A row at or after `row` that stands for it: beyond the first row, a wrapped field repeats.
    pub(crate) fn first_row(&self, row: i64) -> i64 {
        match self.edge {
            Edge::Clamp => row,
            Edge::Wrap => row.rem_euclid(self.octant.minors as i64),
        }
    }

    /// The heights of a column at a row and the next. Only a clamped field has rows before the first.
    #[inline]
    pub(crate) fn row_pair(&self, column: usize, row: i64) -> (f64, f64) {
        let clamped = |row: i64| self.height(column, row.max(0) as usize);
        (clamped(row), clamped(row + 1))
    }

    /// The height at a texel that may lie any distance beyond the far edges.
    #[inline]
    pub(crate) fn height(&self, column: usize, row: usize) -> f64 {
        let (column, row) =
            (resolve(self.edge, column, self.octant.majors), resolve(self.edge, row, self.octant.minors));
        f64::from(self.heights[row * self.stride + column])
    }
}

/// The index on an axis that stands for one at or beyond its start; rays never run towards smaller ones.
#[inline]
fn resolve(edge: Edge, index: usize, size: usize) -> usize {
    match edge {
        Edge::Clamp => index.min(size - 1),
        Edge::Wrap if index < size => index,
        Edge::Wrap if index < 2 * size => index - size,
        Edge::Wrap => index % size,
    }
}
