//! The nearest columns of a ray, looked at exactly.
//!
//! All texels of a column look along parallel rays from the same place in a cell, so their rays cross the cells ahead at
//! the same distances: a ray is worked out once per column and followed for sixteen texels at a time.
//!
//! Within a bilinear cell the surface along the ray is a parabola h(s) = A + B s + C s², as in the
//! [reference](mod@super::reference), so the slope (h(s) − h₀)/s is highest at an end of the piece or, where C < 0 and
//! A < h₀, at s² = (A − h₀)/C, where it is B − 2 √((A − h₀) C). A bend λ makes C into C − λ.

use fearless_simd::{Simd, f32x16, prelude::*};

use super::best::Best;
use super::far::{Eyes, Scene};
use super::lane_hull::LANES;
use super::lines::{Lines, MARGIN, STRIDE, floor_within_one};

/// Where a piece of ray ends in its cell.
#[derive(Clone, Copy)]
enum End {
    /// Between the rows of the next column: how far towards the farther row.
    Column(f32),
    /// Between the columns of the next row: how far towards the next column.
    Row(f32),
    /// At the search radius, inside the cell: how far towards the next column and row.
    Inside(f32, f32),
}

/// The part of a ray inside one bilinear cell, the same for every texel of a column.
#[derive(Clone, Copy)]
struct Piece {
    /// Where the cell's corners lie for a block's line 0: the nearer row of either column.
    corner: usize,
    next: usize,
    /// Where it begins and ends, in columns from the texel.
    start: f32,
    end: f32,
    end_in_cell: End,
}

/// Where a ray crosses a column.
#[derive(Clone, Copy)]
struct Knot {
    /// Where the nearer row of the column lies for a block's line 0.
    place: usize,
    /// How far the ray is towards the farther row.
    down: f32,
    /// Columns from the texel.
    distance: f32,
}

/// What every texel of a column sees of its nearest columns: all of the first, and of those behind them where the ray
/// crosses them.
pub(crate) struct NearRay {
    pieces: Vec<Piece>,
    knots: Vec<Knot>,
}

impl NearRay {
    pub(crate) fn new() -> Self {
        Self { pieces: Vec::new(), knots: Vec::new() }
    }

    /// Works out the rays that start in `column`, for `columns` columns or up to the radius, the first `exact` wholly.
    pub(crate) fn follow(&mut self, lines: &Lines, column: usize, exact: usize, columns: usize) {
        self.pieces.clear();
        self.knots.clear();
        for ahead in 0..exact.min(columns) {
            if (ahead as f64) < lines.radius {
                self.cross(lines, column, ahead);
            }
        }
        for ahead in exact + 1..=columns {
            if ahead as f64 <= lines.radius {
                self.knots.push(Knot::new(lines, column, column + ahead));
            }
        }
    }

    /// The one or two pieces between two columns, cut at the radius.
    fn cross(&mut self, lines: &Lines, from: usize, ahead: usize) {
        let column = from + ahead;
        let tilt = lines.octant.tilt as f32;
        let drop = (lines.drop[column + 1] - lines.drop[column]) as isize;
        let enter = lines.offset[from] - lines.offset[column];
        let leave = lines.offset[from] - lines.offset[column + 1];
        let (row, next_row) = (floor_within_one(enter), floor_within_one(leave));
        let place = |column: usize, row: isize| (column * STRIDE + MARGIN).wrapping_add_signed(row);
        let radius = (lines.radius - ahead as f64) as f32;
        let mut add = |row: isize, start: f32, end: f32, end_in_cell: End| {
            let cut = radius < end;
            let (end, end_in_cell) = if cut {
                (radius, End::Inside(radius, enter + tilt * radius - row as f32))
            } else {
                (end, end_in_cell)
            };
            if start < end {
                let base = ahead as f32;
                let (corner, next) = (place(column, row), place(column + 1, row - drop));
                self.pieces.push(Piece { corner, next, start: base + start, end: base + end, end_in_cell });
            }
        };
        let end_of_column = End::Column(leave - next_row);
        if next_row as isize + drop == row as isize {
            add(row as isize, 0.0, 1.0, end_of_column);
        } else {
            let crossing = ((1.0 - (enter - row)) / tilt).clamp(0.0, 1.0);
            add(row as isize, 0.0, crossing, End::Row(crossing));
            add(row as isize + 1, crossing, 1.0, end_of_column);
        }
    }

    /// Raises `best` to the highest point of the rays of sixteen texels.
    #[inline(always)]
    pub(crate) fn consider<S: Simd, const DISTANCE: bool>(
        &self,
        scene: &Scene<'_>,
        eyes: Eyes<S>,
        best: &mut Best<S, DISTANCE>,
    ) {
        let Eyes { simd, lane, height: eye, .. } = eyes;
        let Scene { lines, heights, bend, .. } = *scene;
        let tilt = lines.octant.tilt as f32;
        let splat = |value: f32| f32x16::splat(simd, value);
        let mut start_height = splat(0.0);
        for piece in &self.pieces {
            let height = |place: usize| f32x16::from_slice(simd, &heights[place + lane..][..LANES]) - eye;
            let [h00, h01] = [height(piece.corner), height(piece.corner + 1)];
            let [h10, h11] = [height(piece.next), height(piece.next + 1)];
            let twist = (h11 - h10) - (h01 - h00);
            let surface = match piece.end_in_cell {
                End::Column(down) => h10 + (h11 - h10) * down,
                End::Row(along) => h01 + (h11 - h01) * along,
                End::Inside(along, down) => h00 + (h10 - h00) * along + (h01 - h00) * down + twist * (along * down),
            };
            let Piece { start, end, .. } = *piece;
            let end_height = surface - bend * end * end;
            let curvature = twist * tilt - bend;
            let rise = (end_height - start_height) * (1.0 / (end - start));
            if start == 0.0 {
                // The ray starts on the surface: the slope's limit at the texel itself is the surface's own slope.
                best.raise_farther(rise - curvature * end, splat(0.0));
            } else {
                let origin = start_height - rise * start + curvature * (start * end);
                let peaks = origin.simd_lt(curvature * (start * start)) & origin.simd_gt(curvature * (end * end));
                if peaks.any_true() {
                    let root = (origin * curvature).max(splat(0.0)).sqrt();
                    let slope = rise - curvature * (start + end) - root * 2.0;
                    let distance = if DISTANCE { (origin / curvature).max(splat(0.0)).sqrt() } else { splat(0.0) };
                    best.raise_these(peaks, slope, distance);
                }
            }
            best.raise_farther(end_height * (1.0 / end), splat(end));
            start_height = end_height;
        }
        for knot in &self.knots {
            let height = |place: usize| f32x16::from_slice(simd, &heights[place + lane..][..LANES]);
            let (upper, lower) = (height(knot.place), height(knot.place + 1));
            let rise = (upper - eye) + (lower - upper) * knot.down;
            best.raise_farther(rise * (1.0 / knot.distance) - bend * knot.distance, splat(knot.distance));
        }
    }
}

impl Knot {
    fn new(lines: &Lines, from: usize, column: usize) -> Self {
        let crossing = lines.offset[from] - lines.offset[column];
        let row = floor_within_one(crossing);
        Self {
            place: (column * STRIDE + MARGIN).wrapping_add_signed(row as isize),
            down: crossing - row,
            distance: (column - from) as f32,
        }
    }
}
