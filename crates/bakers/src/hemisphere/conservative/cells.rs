//! The cells of the bilinear surface, cut into s × s parts, ordered by the first slab in which each part is high enough.
//!
//! Part i along an axis lies from i/s to (i + 1)/s texels beyond the centre of texel 0. A wrapped axis has s parts for each texel. A clamped
//! one has s between neighbouring centres, and two more: −1 stands for all before the first centre and the last one for all beyond the
//! last, for there the surface does not change along the axis.

use barchan_field::Edge;

use super::slabs;
use crate::hemisphere::depths::Depths;
use crate::memory::zeros;
use crate::{BakeError, Exec};

/// No field is longer in parts, unless it is in texels: cells cut in two along each axis take 3 times the time of whole ones, cut in four
/// about 10.
const LONGEST: u64 = 512;

/// All parts of a field's cells.
pub(super) struct Cells {
    columns: Axis,
    rows: Axis,
    /// Row by row.
    parts: Vec<CellRow>,
}

/// Parts of cells along one axis.
#[derive(Debug, Clone, Copy)]
pub(super) struct Axis {
    pub(super) edge: Edge,
    /// Texels.
    texels: u32,
    /// Into how many parts a cell is cut.
    pub(super) parts: u32,
}

/// The parts of one row.
#[derive(Clone, Default)]
pub(super) struct CellRow {
    /// Column − first column of every part, those that are high enough first leading.
    order: Vec<u32>,
    /// How many are high enough, slab by slab.
    high_enough: Vec<u32>,
}

impl Cells {
    pub(super) fn new(depths: &Depths, exec: &Exec) -> Result<Self, BakeError> {
        let grid = depths.grid;
        let count = parts(grid.width.max(grid.height));
        let axis = |texels| Axis { edge: grid.edge, texels, parts: count };
        let (columns, rows) = (axis(grid.width), axis(grid.height));
        let mut parts = zeros("the cells of the relief", rows.count() as u64)?;
        for row in &mut parts {
            *row = CellRow::zeros(columns.count())?;
        }
        exec.for_each_quietly(parts.iter_mut().collect(), |row, parts: &mut CellRow| {
            parts.sort(&least_corners(depths, columns, rows, row as i64 + rows.first()));
        });
        Ok(Self { columns, rows, parts })
    }

    pub(super) fn columns(&self) -> Axis {
        self.columns
    }

    pub(super) fn rows(&self) -> Axis {
        self.rows
    }

    /// The row of parts `offset` below another one, by its place in memory.
    pub(super) fn row_index(&self, row: u32, offset: i64) -> usize {
        let (row, count) = (i64::from(row) + offset, self.parts.len() as i64);
        match self.rows.edge {
            Edge::Wrap => row.rem_euclid(count) as usize,
            Edge::Clamp => (row + 1).clamp(0, count - 1) as usize,
        }
    }

    pub(super) fn row(&self, index: usize) -> &CellRow {
        &self.parts[index]
    }
}

impl Axis {
    /// The field's length in parts.
    pub(super) fn length(self) -> u32 {
        self.parts * self.texels
    }

    /// How many parts there are.
    pub(super) fn count(self) -> usize {
        match self.edge {
            Edge::Wrap => self.length() as usize,
            Edge::Clamp => (self.length() - self.parts) as usize + 2,
        }
    }

    /// The first of them.
    pub(super) fn first(self) -> i64 {
        if self.edge == Edge::Clamp { -1 } else { 0 }
    }

    /// The texels on both sides of where a part begins, and how far it is from the first to the second.
    fn around(self, part: i64) -> ([usize; 2], f64) {
        let parts = i64::from(self.parts);
        let texel = part.div_euclid(parts);
        let resolve = |texel| self.edge.resolve(texel, self.texels);
        ([resolve(texel), resolve(texel + 1)], part.rem_euclid(parts) as f64 / f64::from(self.parts))
    }
}

impl CellRow {
    fn zeros(parts: usize) -> Result<Self, BakeError> {
        let what = "the cells of the relief";
        Ok(Self { order: zeros(what, parts as u64)?, high_enough: zeros(what, slabs::COUNT as u64)? })
    }

    /// Counts and places the parts, slab by slab, from left to right within one.
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

    /// The parts that are high enough in a slab, as columns counted from the first one.
    pub(super) fn high_enough(&self, slab: usize) -> &[u32] {
        &self.order[..self.high_enough[slab] as usize]
    }

    pub(super) fn is_full(&self, slab: usize) -> bool {
        self.high_enough[slab] as usize == self.order.len()
    }
}

/// Into how many parts the cells of a field are cut along each axis; `texels` are those along its longer side. It must not depend on the
/// table's size, or a larger table might start shallower.
fn parts(texels: u32) -> u32 {
    [4, 2].into_iter().find(|parts| parts * u64::from(texels) <= LONGEST).unwrap_or(1) as u32
}

/// The slab in which each part of a row is first high enough.
fn least_corners(depths: &Depths, columns: Axis, rows: Axis, row: i64) -> Vec<u8> {
    let (upper, lower) = (corner_depths(depths, columns, rows, row), corner_depths(depths, columns, rows, row + 1));
    let least: Vec<_> = upper.iter().zip(&lower).map(|(upper, lower)| f64::min(*upper, *lower)).collect();
    least.windows(2).map(|pair| slabs::first_reaching(pair[0].min(pair[1]))).collect()
}

/// The depths of the corners along the upper side of a row of parts.
fn corner_depths(depths: &Depths, columns: Axis, rows: Axis, row: i64) -> Vec<f64> {
    let width = depths.grid.width as usize;
    let ([upper, lower], down) = rows.around(row);
    let mix = |from: f64, to: f64, part: f64| from * (1.0 - part) + to * part;
    let depth = |texel_row: usize, column: usize| f64::from(depths.values[texel_row * width + column]);
    let between_rows = |column| mix(depth(upper, column), depth(lower, column), down);
    let corners = columns.first()..=columns.first() + columns.count() as i64;
    let corner = |column| {
        let ([left, right], along) = columns.around(column);
        mix(between_rows(left), between_rows(right), along)
    };
    corners.map(corner).collect()
}
