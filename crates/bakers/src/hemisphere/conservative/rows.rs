//! Rows of the table on their way from the top plane down, slab by slab.

use std::ops::Range;

use super::cells::Cells;
use super::reach::{Reach, Span};
use super::row_masks::{Answer, RowMasks};
use super::{Target, slabs};
use crate::hemisphere::reduce::footprint;

/// Some rows of the table in one layer.
pub(super) struct TargetRows<'a> {
    cells: &'a Cells,
    target: Target,
    masks: RowMasks<'a>,
    rows: Vec<TargetRow>,
}

/// A row of the table, as many columns as the source has in parts.
struct TargetRow {
    /// The rows of parts that it covers.
    covers: Range<u32>,
    /// How many columns have not been hit.
    open: usize,
    /// One bit for each column that has been.
    hit: Vec<u64>,
    /// The slab of each column's first hit.
    slabs: Vec<u8>,
}

impl<'a> TargetRows<'a> {
    pub(super) fn new(cells: &'a Cells, target: Target, rows: Range<u32>) -> Self {
        let width = cells.columns().length() as usize;
        let row = |row: u32| TargetRow {
            covers: footprint(row, target.height, cells.rows().length()),
            open: width,
            hit: vec![0; width.div_ceil(64)],
            slabs: vec![0; width],
        };
        Self { cells, target, masks: RowMasks::new(cells), rows: rows.map(row).collect() }
    }

    /// Whether every ray has hit.
    pub(super) fn are_done(&self) -> bool {
        self.rows.iter().all(|row| row.open == 0)
    }

    /// Finds the columns whose rays may hit in a slab.
    pub(super) fn hit(&mut self, slab: usize, reach: &Reach) {
        // Footprints are of one height, or of two where the sizes do not divide.
        let heights = self.rows.iter().filter(|row| row.open > 0).map(|row| row.covers.len());
        let (least, greatest) = heights.fold((usize::MAX, 0), |(lo, hi), height| (lo.min(height), hi.max(height)));
        let spans: Vec<_> = (least..=greatest).map(|height| reach.spans(slab, height as u32)).collect();
        self.masks.expect(slab, &spans);
        for row in self.rows.iter_mut().filter(|row| row.open > 0) {
            row.hit(slab, &spans[row.covers.len() - least], self.cells, &mut self.masks);
        }
    }

    /// The depths, row by row.
    pub(super) fn write(&self, values: &mut [f32]) {
        let (width, source) = (self.target.width, self.cells.columns().length());
        for (row, values) in self.rows.iter().zip(values.chunks_exact_mut(width as usize)) {
            for (column, value) in values.iter_mut().enumerate() {
                let covers = footprint(column as u32, width, source);
                let first = row.slabs[covers.start as usize..covers.end as usize].iter().min();
                *value = slabs::stored(first.map_or(0, |&slab| usize::from(slab)));
            }
        }
    }
}

impl TargetRow {
    fn hit(&mut self, slab: usize, spans: &[Span], cells: &Cells, masks: &mut RowMasks) {
        let mut hit = self.hit.clone();
        for span in spans {
            match masks.answer(cells.row_index(self.covers.start, span.row), *span) {
                Answer::Never => {}
                Answer::Always => hit.fill(u64::MAX),
                Answer::Either([one, other]) => {
                    one.or_into(&mut hit);
                    other.or_into(&mut hit);
                }
            }
        }
        self.keep(slab, &hit);
    }

    /// Notes the slab of the columns that had not been hit before.
    fn keep(&mut self, slab: usize, hit: &[u64]) {
        let width = self.slabs.len();
        for (word, (old, &new)) in self.hit.iter_mut().zip(hit).enumerate() {
            let mut columns = new & !*old;
            while columns != 0 {
                let column = 64 * word + columns.trailing_zeros() as usize;
                if column >= width {
                    break;
                }
                self.slabs[column] = slab as u8;
                self.open -= 1;
                columns &= columns - 1;
            }
            *old = new;
        }
    }
}
