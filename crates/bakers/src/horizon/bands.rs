//! Results written where they belong. Blocks of lines lie askew in the picture, so threads share its rows: a layer is cut
//! into bands, and one thread at a time writes to a band.

use std::ops::Range;
use std::sync::{Mutex, MutexGuard};

use barchan_field::Edge;

use super::direction::Octant;
use super::lines::{LINES, Lines};
use super::map::LayerMut;
use super::sheared::Slant;

/// Rows of a band.
pub(crate) const BAND_ROWS: usize = 64;

/// A layer that is being filled.
pub(crate) struct Bands<'a, 'layer> {
    pub(crate) bands: &'a [Mutex<LayerMut<'layer>>],
    pub(crate) width: usize,
}

impl Bands<'_, '_> {
    /// Writes the results of some columns of a block, `[column][line]`.
    pub(crate) fn write(
        &self,
        lines: &Lines,
        first_line: i64,
        columns: Range<usize>,
        values: &[[f32; LINES]],
        distances: &[[f32; LINES]],
    ) {
        let tile = Tile { lines, first_line, columns, owned: lines.owned(first_line), values, distances };
        let mut open = OpenBand { bands: self, current: None };
        if lines.octant.runs_along_rows() {
            tile.write_across(&mut open);
        } else {
            tile.write_along(&mut open);
        }
    }
}

struct Tile<'a> {
    lines: &'a Lines,
    first_line: i64,
    columns: Range<usize>,
    /// Lines whose texels are the block's own.
    owned: usize,
    values: &'a [[f32; LINES]],
    distances: &'a [[f32; LINES]],
}

impl Tile<'_> {
    fn first_row(&self, column: usize) -> i64 {
        self.first_line + i64::from(self.lines.drop[column])
    }

    /// Where the field has a row, if it has.
    fn row_in_field(&self, row: i64) -> Option<usize> {
        let minors = self.lines.octant.minors as i64;
        match self.lines.edge {
            Edge::Wrap => Some(row.rem_euclid(minors) as usize),
            Edge::Clamp => (0..minors).contains(&row).then_some(row as usize),
        }
    }

    /// Where the block's rows lie far apart in the picture: row by row.
    fn write_across(&self, open: &mut OpenBand<'_, '_>) {
        let octant = &self.lines.octant;
        let slant = Slant::new(self.lines, self.first_line, self.columns.clone());
        for row in slant.rows(self.owned) {
            let Some(row_in_field) = self.row_in_field(row) else { continue };
            let place = octant.index(self.columns.start, row_in_field);
            let ends = (place, octant.index(self.columns.end - 1, row_in_field));
            let start = ends.0.min(ends.1) % open.bands.width;
            let run = start..start + self.columns.len();
            let (values, distances) = open.row(place);
            self.write_row(&slant, row, &mut values[run.clone()], self.values, ends.1 < ends.0);
            if let Some(distances) = distances {
                self.write_row(&slant, row, &mut distances[run], self.distances, ends.1 < ends.0);
            }
        }
    }

    /// The part of a row that the columns have, which run backwards in the picture if `mirrored`.
    fn write_row(&self, slant: &Slant, row: i64, to: &mut [f32], from: &[[f32; LINES]], mirrored: bool) {
        let whole = slant.whole(self.owned).contains(&row);
        let last = to.len() - 1;
        for (column, values) in from.iter().enumerate().take(to.len()) {
            if whole || slant.has(row, column, self.owned) {
                to[if mirrored { last - column } else { column }] = values[slant.place(row, column) % LINES];
            }
        }
    }

    /// Where they lie side by side: column by column.
    fn write_along(&self, open: &mut OpenBand<'_, '_>) {
        let Octant { minors, .. } = self.lines.octant;
        for (step, column) in self.columns.clone().enumerate() {
            let mut line = 0;
            while line < self.owned {
                let row = self.first_row(column) + line as i64;
                let Some(first) = self.row_in_field(row) else {
                    if row >= minors as i64 {
                        break;
                    }
                    line = (line as i64 - row) as usize;
                    continue;
                };
                let count = (self.owned - line).min(minors - first);
                self.write_run(open, (step, column), line..line + count, first);
                line += count;
            }
        }
    }

    /// Some lines of a column, whose texels begin at a row.
    fn write_run(&self, open: &mut OpenBand<'_, '_>, (step, column): (usize, usize), run: Range<usize>, row: usize) {
        let octant = &self.lines.octant;
        let (first, last) = (octant.index(column, row), octant.index(column, row + run.len() - 1));
        let width = open.bands.width;
        let (values, distances) = open.row(first);
        let place = first.min(last) % width..first.max(last) % width + 1;
        let copy = |from: &[f32], to: &mut [f32]| {
            to.copy_from_slice(from);
            if last < first {
                to.reverse();
            }
        };
        copy(&self.values[step][run.clone()], &mut values[place.clone()]);
        if let Some(distances) = distances {
            copy(&self.distances[step][run], &mut distances[place]);
        }
    }
}

/// The band written to last stays open until another is needed.
struct OpenBand<'a, 'layer> {
    bands: &'a Bands<'a, 'layer>,
    current: Option<(usize, MutexGuard<'a, LayerMut<'layer>>)>,
}

impl OpenBand<'_, '_> {
    /// The row of the picture in which a texel lies.
    fn row(&mut self, texel: usize) -> (&mut [f32], Option<&mut [f32]>) {
        let Bands { bands, width } = *self.bands;
        let (band, row_in_band) = (texel / width / BAND_ROWS, texel / width % BAND_ROWS);
        if self.current.as_ref().is_none_or(|(open, _)| *open != band) {
            // One at a time: a thread that held two could wait for another that waits for it.
            self.current = None;
            self.current = Some((band, bands[band].lock().expect("no writer panics")));
        }
        let layer: &mut LayerMut<'_> = &mut self.current.as_mut().expect("just opened").1;
        let row = row_in_band * width..(row_in_band + 1) * width;
        (&mut layer.values[row.clone()], layer.distance.as_deref_mut().map(|all| &mut all[row]))
    }
}
