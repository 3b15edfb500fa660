//! Which samples of a picture a triangle covers.
//!
//! Corners are whole numbers, so it is decided exactly. A sample on an edge that two triangles share belongs to one of them:
//! the one that a fixed, infinitely small step away from it leads into. So no crack is left, and nothing is drawn twice.

use std::ops::Range;

/// Steps of a corner's coordinates from one sample to the next; the centre of sample 0 is half as far from 0.
pub(crate) const STEPS: i64 = 256;

/// A sample inside a triangle.
pub(crate) struct Covered {
    pub(crate) column: usize,
    pub(crate) row: i64,
    /// How much of each corner is in it: not negative, 1 together.
    pub(crate) weights: [f64; 3],
}

/// Hands over the samples that a triangle covers, whichever way it runs round, row by row. Corners are (right, down), within
/// ±2³⁰; `columns` is below 2¹⁶.
pub(crate) fn cover(corners: [[i64; 2]; 3], columns: usize, rows: Range<i64>, mut each: impl FnMut(Covered)) {
    let [a, b, c] = corners;
    let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if area == 0 {
        return;
    }
    let sides = [[b, c], [c, a], [a, b]].map(|[from, to]| match area > 0 {
        true => Side::new(from, to),
        false => Side::new(to, from),
    });
    let within = |axis: usize, count: Range<i64>| {
        let [a, b, c] = corners.map(|corner| corner[axis]);
        // The first sample at or behind the least, and the last at or before the greatest.
        let first = -(STEPS / 2 - a.min(b).min(c)).div_euclid(STEPS);
        let last = (a.max(b).max(c) - STEPS / 2).div_euclid(STEPS);
        first.max(count.start)..(last + 1).min(count.end)
    };
    let columns = within(0, 0..columns as i64);
    for row in within(1, rows) {
        let span = sides.iter().fold(columns.clone(), |span, side| side.cut(span, row));
        for column in span {
            let weights = sides.each_ref().map(|side| side.at(column, row) as f64 / area.abs() as f64);
            each(Covered { column: column as usize, row, weights });
        }
    }
}

/// A linear function that is 0 on a side and positive within the triangle.
struct Side {
    at_first_sample: i64,
    per_column: i64,
    per_row: i64,
    /// The least value of a sample that belongs to the triangle: 0 where it owns its edge.
    least: i64,
}

impl Side {
    fn new(from: [i64; 2], to: [i64; 2]) -> Self {
        let (right, down) = (to[0] - from[0], to[1] - from[1]);
        Self {
            at_first_sample: right * (STEPS / 2 - from[1]) - down * (STEPS / 2 - from[0]),
            per_column: -down * STEPS,
            per_row: right * STEPS,
            // Of a side and its reverse exactly one owns the edge.
            least: i64::from(!(down > 0 || (down == 0 && right > 0))),
        }
    }

    fn at(&self, column: i64, row: i64) -> i64 {
        self.at_first_sample + column * self.per_column + row * self.per_row
    }

    /// What of a row's samples lies on the inner side.
    fn cut(&self, span: Range<i64>, row: i64) -> Range<i64> {
        let beyond_least = self.at(0, row) - self.least;
        match self.per_column {
            0 if beyond_least < 0 => 0..0,
            0 => span,
            step if step > 0 => span.start.max(-beyond_least.div_euclid(step))..span.end,
            step => span.start..span.end.min(beyond_least.div_euclid(-step) + 1),
        }
    }
}
