//! The heights of a field and of its continuation, one tile to each side.

use barchan_field::{Edge, Grid, HeightField};

use super::patch::Patch;

/// A field whose texels beyond the edge are found without a division.
pub(super) struct Ground<'a> {
    samples: &'a [f32],
    pub(super) grid: Grid,
    /// The column that stands for each, from one tile to the left to one tile to the right.
    columns: Vec<usize>,
    /// The first sample of the row that stands for each, from one tile above to one tile below.
    rows: Vec<usize>,
}

impl<'a> Ground<'a> {
    pub(super) fn new(field: &'a HeightField) -> Self {
        let grid = *field.grid();
        let resolve = |extent: u32, stride: usize| {
            (-i64::from(extent)..=2 * i64::from(extent)).map(|i| grid.edge.resolve(i, extent) * stride).collect()
        };
        Self {
            samples: field.samples(),
            grid,
            columns: resolve(grid.width, 1),
            rows: resolve(grid.height, grid.width as usize),
        }
    }

    /// Columns and rows of bilinear cells that there are: as many as texels where the field repeats. Where it is
    /// clamped, those between texel centres, and one where there is but one texel.
    pub(super) fn cells(&self) -> [u32; 2] {
        [self.grid.width, self.grid.height].map(|texels| match self.grid.edge {
            Edge::Wrap => texels,
            Edge::Clamp => (texels - 1).max(1),
        })
    }

    /// The height of a texel at most one tile beyond the edge.
    pub(super) fn height(&self, column: i64, row: i64) -> f64 {
        let column = self.columns[(column + i64::from(self.grid.width)) as usize];
        f64::from(self.samples[self.rows[(row + i64::from(self.grid.height)) as usize] + column])
    }

    /// A cell at most one tile beyond the edge, its places in lengths from the centre of texel `origin`.
    pub(super) fn cell(&self, [column, row]: [i64; 2], origin: [i64; 2]) -> Patch {
        let ends = |index: i64, length: f64| [index as f64 * length, (index + 1) as f64 * length];
        Patch {
            u: ends(column - origin[0], self.grid.spacing.u()),
            v: ends(row - origin[1], self.grid.spacing.v()),
            heights: [
                [self.height(column, row), self.height(column + 1, row)],
                [self.height(column, row + 1), self.height(column + 1, row + 1)],
            ],
        }
    }
}
