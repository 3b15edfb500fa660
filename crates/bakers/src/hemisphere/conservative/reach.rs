//! The parts of cells that the rays of a footprint reach in a slab: row by row, from column to column.
//!
//! A place p is reached where p − q lies in the footprint for some way q of the sector. A part is reached where one of its places is. Of
//! a row of parts that is so for the ways between two horizontal lines, as far apart as the part and the footprint are high; between their
//! least and their greatest column, widened by the footprint, lie the parts that are reached. Columns and rows are those of
//! parts throughout: a texel is s of them wide, and its footprint begins s/2 of them before its centre.

use std::ops::Range;

use barchan_field::Edge;

use super::cells::{Axis, Cells};
use super::sector::{Quadrilateral, Sector};
use super::{Target, slabs};

/// By how much a footprint is widened on each side, as a part of a texel of the table.
const MARGIN: f64 = 1.0 / (1 << 10) as f64;

/// In parts: beyond it f64 no longer tells a margin.
const FARTHEST: f64 = (1_u64 << 40) as f64;

/// What the rays of one layer reach.
pub(super) struct Reach {
    edge: Edge,
    width: i64,
    height: i64,
    /// From where the footprint of a texel begins to its centre, in parts.
    half: f64,
    sector: Sector,
    /// In columns and rows.
    margin: (f64, f64),
}

/// Neighbouring parts of one row, relative to the first one of a footprint. Within the field's width of it on both sides.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Span {
    pub(super) row: i64,
    pub(super) first: i64,
    pub(super) last: i64,
}

impl Reach {
    pub(super) fn new(cells: &Cells, target: Target, sector: Sector) -> Self {
        let (columns, rows) = (cells.columns(), cells.rows());
        let margin = |source: Axis, target: u32| MARGIN * f64::from(source.length()) / f64::from(target);
        Self {
            edge: columns.edge,
            width: i64::from(columns.length()),
            height: i64::from(rows.length()),
            half: 0.5 * f64::from(columns.parts),
            sector,
            margin: (margin(columns, target.width), margin(rows, target.height)),
        }
    }

    /// What is reached in a slab from a footprint one part wide and `rows` parts high, in order.
    pub(super) fn spans(&self, slab: usize, rows: u32) -> Vec<Span> {
        let depths = slabs::start(slab)..slabs::end(slab);
        let mut spans = Vec::new();
        for piece in self.sector.pieces(depths) {
            // A row of parts sees ways so much above it and so much below.
            let (above, below) = (f64::from(rows) - self.half + self.margin.1, 1.0 + self.half + self.margin.1);
            let (top, bottom) = piece
                .iter()
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(top, bottom), &(_, row)| (top.min(row), bottom.max(row)));
            let reached = (top - below).ceil() as i64..=(bottom + above).floor() as i64;
            if self.is_too_far(&piece) {
                return self.everything();
            }
            for row in self.clip(*reached.start(), self.height)..=self.clip(*reached.end(), self.height) {
                // On a clamped axis the outermost rows stand for all beyond.
                let lowest = self.edge == Edge::Clamp && row == -self.height;
                let highest = self.edge == Edge::Clamp && row == self.height;
                let start = if lowest { f64::NEG_INFINITY } else { row as f64 - above };
                let end = if highest { f64::INFINITY } else { row as f64 + below };
                spans.extend(columns_between(&piece, start..end).map(|ways| self.span(row, ways)));
            }
        }
        self.joined(spans)
    }

    /// Whether a piece lies so far over a repeated field, or over so many of its repetitions, that its parts are not told apart.
    fn is_too_far(&self, piece: &Quadrilateral) -> bool {
        let rows = || piece.iter().map(|&(_, row)| row);
        let height = rows().fold(f64::NEG_INFINITY, f64::max) - rows().fold(f64::INFINITY, f64::min);
        let farthest = piece.iter().map(|&(column, row)| column.abs().max(row.abs())).fold(0.0, f64::max);
        self.edge == Edge::Wrap && (height > 2.0 * (self.width + self.height) as f64 || farthest > FARTHEST)
    }

    fn span(&self, row: i64, ways: Range<f64>) -> Span {
        let (left, right) = (self.half + self.margin.0, 1.0 - self.half + self.margin.0);
        Span { row, first: (ways.start - left).floor() as i64, last: (ways.end + right).floor() as i64 }
    }

    /// On a clamped axis no part is further than the field is long.
    fn clip(&self, part: i64, size: i64) -> i64 {
        if self.edge == Edge::Clamp { part.clamp(-size, size) } else { part }
    }

    fn everything(&self) -> Vec<Span> {
        (0..self.height).map(|row| Span { row, first: 0, last: self.width - 1 }).collect()
    }

    /// Spans that touch become one; those of a row that are far away come near.
    fn joined(&self, mut spans: Vec<Span>) -> Vec<Span> {
        spans.sort_unstable();
        spans.dedup_by(|next, span| {
            let touch = next.row == span.row && next.first <= span.last.saturating_add(1);
            if touch {
                span.last = span.last.max(next.last);
            }
            touch
        });
        for span in &mut spans {
            *span = self.near(*span);
        }
        spans
    }

    /// The same parts, no further than the field's width.
    fn near(&self, span: Span) -> Span {
        let Span { row, first, last } = span;
        let width = self.width;
        if self.edge == Edge::Clamp {
            return Span { row, first: first.clamp(-width, width), last: last.clamp(-width, width) };
        }
        let length = last.saturating_sub(first).min(width - 1);
        if first >= -width && first + length <= width {
            return Span { row, first, last: first + length };
        }
        let first = first.rem_euclid(width) - width;
        Span { row, first, last: first + length }
    }
}

/// The least and the greatest column of a convex quadrilateral between two rows; none where it is elsewhere.
fn columns_between(corners: &Quadrilateral, rows: Range<f64>) -> Option<Range<f64>> {
    let (mut least, mut greatest) = (f64::INFINITY, f64::NEG_INFINITY);
    let mut take = |column: f64| (least, greatest) = (least.min(column), greatest.max(column));
    for (index, &(x0, y0)) in corners.iter().enumerate() {
        let (x1, y1) = corners[(index + 1) % 4];
        if rows.start <= y0 && y0 <= rows.end {
            take(x0);
        }
        for line in [rows.start, rows.end] {
            if (y0 < line) != (y1 < line) {
                take(x0 + ((line - y0) / (y1 - y0)).clamp(0.0, 1.0) * (x1 - x0));
            }
        }
    }
    (least <= greatest).then_some(least..greatest)
}
