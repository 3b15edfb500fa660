//! The cells of the bilinear surface, ordered by the first slab in which each is high enough.
//!
//! Cell i along an axis lies between the centres of texels i and i + 1. A wrapped axis has as many cells as texels. A clamped one has a
//! further cell −1, which stands for all before the first centre as the last one does for all beyond the last: there the surface does not
//! change along the axis.

use barchan_field::{Edge, Grid};

use super::slabs;
use crate::hemisphere::depths::Depths;
use crate::memory::zeros;
use crate::{BakeError, Exec};

/// All cells of a field.
pub(super) struct Cells {
    grid: Grid,
    rows: Vec<CellRow>,
}

/// The cells of one row.
#[derive(Clone, Default)]
pub(super) struct CellRow {
    /// Column − first column of every cell, those that are high enough first leading.
    order: Vec<u32>,
    /// How many are high enough, slab by slab.
    high_enough: Vec<u32>,
}

impl Cells {
    pub(super) fn new(depths: &Depths, exec: &Exec) -> Result<Self, BakeError> {
        let grid = depths.grid;
        let mut rows = zeros("the cells of the relief", count(grid.edge, grid.height) as u64)?;
        for row in &mut rows {
            *row = CellRow::zeros(count(grid.edge, grid.width))?;
        }
        let first = first(grid.edge);
        exec.for_each_quietly(rows.iter_mut().collect(), |row, cells: &mut CellRow| {
            cells.sort(&least_corners(depths, row as i64 + first));
        });
        Ok(Self { grid, rows })
    }

    pub(super) fn grid(&self) -> &Grid {
        &self.grid
    }

    /// The row of cells `offset` below texel row `row`, by its place in memory.
    pub(super) fn row_index(&self, row: u32, offset: i64) -> usize {
        let (row, height) = (i64::from(row) + offset, i64::from(self.grid.height));
        match self.grid.edge {
            Edge::Wrap => row.rem_euclid(height) as usize,
            Edge::Clamp => (row.clamp(-1, height - 1) + 1) as usize,
        }
    }

    pub(super) fn row(&self, index: usize) -> &CellRow {
        &self.rows[index]
    }

    pub(super) fn row_count(&self) -> usize {
        self.rows.len()
    }
}

impl CellRow {
    fn zeros(cells: usize) -> Result<Self, BakeError> {
        let what = "the cells of the relief";
        Ok(Self { order: zeros(what, cells as u64)?, high_enough: zeros(what, slabs::COUNT as u64)? })
    }

    /// Counts and places the cells, slab by slab, from left to right within one.
    fn sort(&mut self, first_slabs: &[u8]) {
        for &slab in first_slabs {
            self.high_enough[usize::from(slab)] += 1;
        }
        let mut next = vec![0; slabs::COUNT];
        let mut before = 0;
        for (slab, count) in self.high_enough.iter_mut().enumerate() {
            next[slab] = before;
            before += *count;
            *count = before;
        }
        for (column, &slab) in first_slabs.iter().enumerate() {
            let next = &mut next[usize::from(slab)];
            self.order[*next as usize] = column as u32;
            *next += 1;
        }
    }

    /// The cells that are high enough in a slab, as columns counted from the first cell.
    pub(super) fn high_enough(&self, slab: usize) -> &[u32] {
        &self.order[..self.high_enough[slab] as usize]
    }

    pub(super) fn is_full(&self, slab: usize) -> bool {
        self.high_enough[slab] as usize == self.order.len()
    }
}

/// Cells along an axis.
fn count(edge: Edge, size: u32) -> usize {
    size as usize + usize::from(edge == Edge::Clamp)
}

/// The first cell along an axis.
pub(super) fn first(edge: Edge) -> i64 {
    if edge == Edge::Clamp { -1 } else { 0 }
}

/// The slab in which each cell of a row is first high enough.
fn least_corners(depths: &Depths, row: i64) -> Vec<u8> {
    let Grid { width, height, edge, .. } = depths.grid;
    let texels = |row: i64| &depths.values[edge.resolve(row, height) * width as usize..][..width as usize];
    let (upper, lower) = (texels(row), texels(row + 1));
    let least = |column: i64| {
        let column = edge.resolve(column, width);
        upper[column].min(lower[column])
    };
    let first = first(edge);
    let columns = first..first + count(edge, width) as i64;
    columns.map(|column| slabs::first_reaching(least(column).min(least(column + 1)))).collect()
}
