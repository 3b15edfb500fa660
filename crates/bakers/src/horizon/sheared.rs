//! A block of lines as the kernel wants it: one column after the other, each line's texel at the same place in all of them.

use barchan_field::{Edge, HeightField};

use super::direction::Octant;
use super::lines::{LINES, Lines, MARGIN, STRIDE};

/// Columns moved at a time where the block lies across the picture's rows, so that each row is touched in runs.
pub(crate) const TILE: usize = 16;

/// Heights times a power of two, so that neither the least nor the largest of floats takes the kernel to infinity or
/// to zero. Exact but for heights 2¹⁸⁰ times lower than the highest.
#[derive(Debug, Clone, Copy)]
pub(crate) struct HeightScale {
    pub(crate) factor: f32,
    /// The height nearest to 0, scaled: what profiles are taken relative to, so that relief far above 0 keeps its digits.
    pub(crate) datum: f32,
}

impl HeightScale {
    pub(crate) fn of(field: &HeightField) -> Self {
        /// Highest scaled height.
        const HIGH: f32 = (1_u64 << 60) as f32;
        let (lowest, highest) = field.range();
        let extreme = highest.abs().max(lowest.abs());
        let mut factor = 1.0;
        while extreme * factor > HIGH {
            factor *= 0.5;
        }
        if extreme > 0.0 && extreme < 1.0 / HIGH {
            // 2^60 twice at most: the least of floats is 2^-149.
            factor = if extreme * HIGH < 1.0 / HIGH { HIGH * 65_536.0 } else { HIGH };
        }
        Self { factor, datum: 0.0_f32.clamp(lowest, highest) * factor }
    }
}

/// Scaled heights of a block of lines and of [`MARGIN`] rows on both sides: row `line + MARGIN` of column `c` is at
/// `c · STRIDE + line + MARGIN`, where line `i`'s texel is.
#[derive(Default)]
pub(crate) struct Sheared {
    pub(crate) heights: Vec<f32>,
}

impl Sheared {
    pub(crate) fn take(&mut self, field: &HeightField, lines: &Lines, first_line: i64, columns: usize, scale: f32) {
        self.heights.resize(columns * STRIDE, 0.0);
        let source = Source { field, lines, scale };
        if lines.octant.runs_along_rows() {
            for start in (0..columns).step_by(TILE) {
                source.copy_across(&mut self.heights, first_line, start..(start + TILE).min(columns));
            }
        } else {
            for (column, heights) in self.heights.chunks_exact_mut(STRIDE).enumerate() {
                source.copy_along(heights, first_line, column);
            }
        }
    }
}

struct Source<'a> {
    field: &'a HeightField,
    lines: &'a Lines,
    scale: f32,
}

impl Source<'_> {
    /// One column whose rows lie side by side in the field.
    fn copy_along(&self, heights: &mut [f32], first_line: i64, column: usize) {
        let Octant { majors, minors, .. } = self.lines.octant;
        let column_in_field = resolve(self.lines.edge, column as i64, majors);
        let first_row = first_line + i64::from(self.lines.drop[column]) - MARGIN as i64;
        let samples = self.field.samples();
        if first_row >= 0 && first_row + STRIDE as i64 <= minors as i64 {
            let ends = [0, STRIDE - 1].map(|row| self.lines.octant.index(column_in_field, first_row as usize + row));
            let run = &samples[ends[0].min(ends[1])..=ends[0].max(ends[1])];
            if ends[0] < ends[1] {
                heights.iter_mut().zip(run).for_each(|(height, sample)| *height = sample * self.scale);
            } else {
                heights.iter_mut().zip(run.iter().rev()).for_each(|(height, sample)| *height = sample * self.scale);
            }
        } else {
            for (row, height) in (first_row..).zip(heights) {
                let row = resolve(self.lines.edge, row, minors);
                *height = samples[self.lines.octant.index(column_in_field, row)] * self.scale;
            }
        }
    }

    /// A few columns whose rows lie far apart in the field: row by row, each in one run.
    fn copy_across(&self, heights: &mut [f32], first_line: i64, columns: std::ops::Range<usize>) {
        let Octant { majors, minors, .. } = self.lines.octant;
        let slant = Slant::new(self.lines, first_line - MARGIN as i64, columns.clone());
        let heights = &mut heights[columns.start * STRIDE..columns.end * STRIDE];
        let inside = columns.end <= majors && columns.len() == TILE;
        for row in slant.rows(STRIDE) {
            let row_in_field = resolve(self.lines.edge, row, minors);
            if inside && slant.whole(STRIDE).contains(&row) {
                let run = self.run(columns.start, row_in_field);
                for (column, sample) in run.into_iter().enumerate() {
                    heights[column * STRIDE + slant.place(row, column)] = sample * self.scale;
                }
                continue;
            }
            for (step, column) in columns.clone().enumerate() {
                if slant.has(row, step, STRIDE) {
                    let column_in_field = resolve(self.lines.edge, column as i64, majors);
                    let sample = self.field.samples()[self.lines.octant.index(column_in_field, row_in_field)];
                    heights[step * STRIDE + slant.place(row, step)] = sample * self.scale;
                }
            }
        }
    }

    /// The samples of [`TILE`] columns of a row that lies along the picture's.
    #[inline]
    fn run(&self, column: usize, row: usize) -> [f32; TILE] {
        let octant = &self.lines.octant;
        let (first, last) = (octant.index(column, row), octant.index(column + TILE - 1, row));
        let samples = &self.field.samples()[first.min(last)..=first.max(last)];
        let mut run: [f32; TILE] = samples.try_into().expect("a run along a row");
        if last < first {
            run.reverse();
        }
        run
    }
}

/// How some columns of a block lie against the rows: each a little lower than the last.
pub(crate) struct Slant {
    first_rows: [i64; TILE],
    columns: usize,
}

impl Slant {
    /// Of columns in which line 0's place is `first_line` rows below the line's own.
    pub(crate) fn new(lines: &Lines, first_line: i64, columns: std::ops::Range<usize>) -> Self {
        let row = |column: usize| first_line + i64::from(lines.drop[column]);
        Self {
            first_rows: std::array::from_fn(|step| row((columns.start + step).min(columns.end - 1))),
            columns: columns.len(),
        }
    }

    /// The rows that any of the columns has, if each has `count`.
    pub(crate) fn rows(&self, count: usize) -> std::ops::Range<i64> {
        self.first_rows[0]..self.first_rows[self.columns - 1] + count as i64
    }

    /// The rows that all of them have.
    pub(crate) fn whole(&self, count: usize) -> std::ops::Range<i64> {
        self.first_rows[self.columns - 1]..self.first_rows[0] + count as i64
    }

    #[inline]
    pub(crate) fn has(&self, row: i64, column: usize, count: usize) -> bool {
        (0..count as i64).contains(&(row - self.first_rows[column]))
    }

    /// Where a row stands in a column.
    #[inline]
    pub(crate) fn place(&self, row: i64, column: usize) -> usize {
        (row - self.first_rows[column]) as usize
    }
}

/// The index on an axis that stands for one beyond it.
#[inline]
fn resolve(edge: Edge, index: i64, size: usize) -> usize {
    let size = size as i64;
    match edge {
        Edge::Clamp => index.clamp(0, size - 1) as usize,
        Edge::Wrap if (0..size).contains(&index) => index as usize,
        Edge::Wrap => index.rem_euclid(size) as usize,
    }
}

/// Results of a block, [`TILE`] columns at a time: `[column][line]`.
pub(crate) type ResultTile = [[f32; LINES]; TILE];
