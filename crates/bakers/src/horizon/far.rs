//! What lies behind the nearest columns: where to look, and what is there.
//!
//! Columns are taken in blocks of four. Each line has a profile, one point per block, and an upper hull of it names the
//! block in which a texel sees its horizon; the texel's *own* ray is then followed through that block. Two profiles miss
//! different things: the highest sample of the surface on the line itself follows smooth relief, and the *ceiling*, the
//! highest texel that any ray of the line's texels may come near, finds what falls between lines, a spike for one.

use fearless_simd::{Simd, f32x16, prelude::*};

use super::best::Best;
use super::lane_hull::{LANES, Points};
use super::lines::{Lines, MARGIN, STRIDE, floor_within_one};
use super::sliding_hull::Part;

/// Columns in a block.
pub(crate) const BLOCK: usize = 4;

/// How closely a ray is looked at in the block that a hull names.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Care {
    /// Only in the column of the hull's point.
    Column,
    /// In every column, and where the ray crosses a row: at a slight tilt that lies many columns away, and a wall along the
    /// ray is highest there.
    Block,
}

/// How to look at what a hull names.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Look {
    pub(crate) care: Care,
    /// How many columns share an answer of the hull, 1, 2 or 4: what one sees highest, its neighbour rarely misses.
    pub(crate) every: usize,
}

/// What a hull named last, and from where it was asked.
pub(crate) struct Seen {
    from: usize,
    columns: [usize; LANES],
}

impl Seen {
    pub(crate) fn nothing() -> Self {
        Self { from: usize::MAX, columns: [0; LANES] }
    }
}

/// The relief as the lines of a block of lines see it.
#[derive(Clone, Copy)]
pub(crate) struct Scene<'a> {
    pub(crate) lines: &'a Lines,
    pub(crate) heights: &'a [f32],
    pub(crate) datum: f32,
    pub(crate) bend: f32,
}

impl Scene<'_> {
    #[inline(always)]
    pub(crate) fn load<S: Simd>(&self, simd: S, place: usize) -> f32x16<S> {
        f32x16::from_slice(simd, &self.heights[place..][..LANES])
    }

    /// The highest sample on the line among the columns of a block, above the datum.
    #[inline(always)]
    pub(crate) fn line_point<S: Simd>(&self, simd: S, lane: usize, block: usize) -> Points<S> {
        highest_of_block(
            simd,
            block,
            #[inline(always)]
            |column| {
                let crossing = -self.lines.offset[column];
                let row = floor_within_one(crossing);
                let place = (column * STRIDE + MARGIN + lane).wrapping_add_signed(row as isize);
                let (upper, lower) = (self.load(simd, place), self.load(simd, place + 1));
                (upper - self.datum) + (lower - upper) * (crossing - row)
            },
        )
    }

    /// The highest texel among those that a ray within half a texel of the line touches in the columns of a block.
    #[inline(always)]
    pub(crate) fn ceiling_point<S: Simd>(&self, simd: S, lane: usize, block: usize) -> Points<S> {
        highest_of_block(
            simd,
            block,
            #[inline(always)]
            |column| {
                let place = column * STRIDE + MARGIN + lane;
                let (before, after) = (self.load(simd, place - 1), self.load(simd, place + 1));
                self.load(simd, place).max(before).max(after) - self.datum
            },
        )
    }

    /// Follows the rays from `column` through the block in which `part` is seen highest, where that can matter.
    #[inline(always)]
    pub(crate) fn consider<S: Simd, const DISTANCE: bool>(
        &self,
        simd: S,
        column: usize,
        lane: usize,
        eye: f32x16<S>,
        part: Option<Part<'_, S>>,
        seen: &mut Seen,
        look: Look,
        best: &mut Best<S, DISTANCE>,
    ) {
        let Some(part) = part else { return };
        if !self.may_be_higher(simd, column, eye, part, best) {
            return;
        }
        if seen.from / look.every != column / look.every {
            let highest = self.highest(simd, column, eye, part);
            let ahead: [f32; LANES] = highest.columns.into();
            seen.from = column;
            seen.columns = std::array::from_fn(
                #[inline(always)]
                |l| column + ahead[l] as usize,
            );
        }
        match look.care {
            Care::Column => self.cross(simd, column, lane, eye, seen.columns, best),
            Care::Block => self.follow(simd, column, lane, eye, seen.columns, best),
        }
    }

    /// Each lane's own ray where it crosses a column.
    #[inline(always)]
    fn cross<S: Simd, const DISTANCE: bool>(
        &self,
        simd: S,
        from: usize,
        lane: usize,
        eye: f32x16<S>,
        columns: [usize; LANES],
        best: &mut Best<S, DISTANCE>,
    ) {
        let (mut upper, mut lower) = ([0.0_f32; LANES], [0.0_f32; LANES]);
        let (mut down, mut distance) = ([0.0_f32; LANES], [0.0_f32; LANES]);
        for l in 0..LANES {
            let crossing = self.lines.offset[from] - self.lines.offset[columns[l]];
            let above = usize::from(crossing < 0.0);
            let taps = &self.heights[columns[l] * STRIDE + MARGIN + lane + l - above..][..2];
            (upper[l], lower[l]) = (taps[0], taps[1]);
            down[l] = crossing + above as f32;
            distance[l] = (columns[l] - from) as f32;
        }
        let vector = |values: [f32; LANES]| -> f32x16<S> { values.simd_into(simd) };
        let (down, distance, upper, lower) = (vector(down), vector(distance), vector(upper), vector(lower));
        let rise = (upper - eye) + (lower - upper) * down;
        // A column that another texel saw may lie beyond this one's radius.
        let within = distance.simd_le(f32x16::splat(simd, self.lines.radius as f32));
        best.raise_these(within, rise / distance - distance * self.bend, distance);
    }

    /// Each lane's own ray through a block: where it crosses the columns, and the rows behind them.
    #[inline(always)]
    fn follow<S: Simd, const DISTANCE: bool>(
        &self,
        simd: S,
        from: usize,
        lane: usize,
        eye: f32x16<S>,
        seen: [usize; LANES],
        best: &mut Best<S, DISTANCE>,
    ) {
        let zeros = [[0.0_f32; LANES]; BLOCK];
        let (mut upper, mut lower, mut next, mut down) = (zeros, zeros, zeros, zeros);
        let mut first = [0.0_f32; LANES];
        let here = self.lines.offset[from];
        for l in 0..LANES {
            let column = seen[l] / BLOCK * BLOCK;
            first[l] = (column - from) as f32;
            let offsets = &self.lines.offset[column..][..BLOCK];
            let drops = &self.lines.drop[column..][..BLOCK + 1];
            let heights = &self.heights[column * STRIDE + MARGIN + lane + l - 1..][..BLOCK * STRIDE + 3];
            for step in 0..BLOCK {
                let crossing = here - offsets[step];
                let row = usize::from(crossing >= 0.0);
                let dropped = usize::from(drops[step + 1] > drops[step]);
                let at = step * STRIDE + row;
                (upper[step][l], lower[step][l]) = (heights[at], heights[at + 1]);
                next[step][l] = heights[at + 1 + STRIDE - dropped];
                down[step][l] = crossing + 1.0 - row as f32;
            }
        }
        let vector = |values: [f32; LANES]| -> f32x16<S> { values.simd_into(simd) };
        let radius = f32x16::splat(simd, self.lines.radius as f32);
        let one = f32x16::splat(simd, 1.0);
        let columns_per_row = 1.0 / self.lines.octant.tilt as f32;
        for step in 0..BLOCK {
            let distance = vector(first) + step as f32;
            let (upper, lower, down) = (vector(upper[step]), vector(lower[step]), vector(down[step]));
            let lower_rise = lower - eye;
            let rise = (upper - eye) + (lower - upper) * down;
            best.raise(rise / distance - distance * self.bend, distance);
            let along = (one - down) * columns_per_row;
            let distance = distance + along;
            let slope = (lower_rise + (vector(next[step]) - lower) * along) / distance - distance * self.bend;
            best.raise_these(along.simd_lt(one) & distance.simd_le(radius), slope, distance);
        }
        if self.rows_lie_far_apart() {
            let eyes: [f32; LANES] = eye.into();
            let (mut slopes, mut distances) = ([0.0; LANES], [0.0; LANES]);
            for l in 0..LANES {
                let column = seen[l] / BLOCK * BLOCK;
                (slopes[l], distances[l]) = self.row_crossings(from, lane + l, eyes[l], (column, column + BLOCK - 1));
            }
            best.raise(vector(slopes), vector(distances));
        }
    }

    /// Whether a ray may cross a block without crossing a row.
    fn rows_lie_far_apart(&self) -> bool {
        let tilt = self.lines.octant.tilt;
        tilt > 0.0 && tilt * BLOCK as f64 <= 1.0
    }

    /// Where one texel's ray crosses the row before a column, and the row behind another: at a slight tilt many columns
    /// away, and a wall along the ray is highest there.
    fn row_crossings(&self, from: usize, line: usize, eye: f32, (first, last): (usize, usize)) -> (f32, f32) {
        let tilt = self.lines.octant.tilt as f32;
        let crossing = |column: usize| self.lines.offset[from] - self.lines.offset[column];
        let row = |column: usize, below: i64| {
            let nearer = floor_within_one(crossing(column)) as i64;
            i64::from(self.lines.drop[column]) + nearer + below
        };
        let down = |column: usize| crossing(column) - floor_within_one(crossing(column));
        let mut best = (f32::NEG_INFINITY, 0.0);
        for (ahead, row) in [
            ((first - from) as f32 - down(first) / tilt, row(first, 0)),
            ((last - from) as f32 + (1.0 - down(last)) / tilt, row(last, 1)),
        ] {
            let column = from + ahead.max(0.0) as usize;
            if ahead >= 1.0 && ahead <= self.lines.radius as f32 && (column + 2) * STRIDE <= self.heights.len() {
                let height = |column: usize| {
                    let place = (column * STRIDE + MARGIN + line) as i64 + row - i64::from(self.lines.drop[column]);
                    self.heights[place as usize]
                };
                let (near, far) = (height(column), height(column + 1));
                let rise = (near - eye) + (far - near) * (ahead - (column - from) as f32);
                let slope = rise / ahead - ahead * self.bend;
                if slope >= best.0 {
                    best = (slope, ahead);
                }
            }
        }
        best
    }

    /// Follows the rays of those texels for which the ceiling's tangent is above all that was found, in a block that the
    /// line did not name: few, so one at a time.
    #[inline(always)]
    pub(crate) fn consider_ceiling<S: Simd, const DISTANCE: bool>(
        &self,
        simd: S,
        column: usize,
        lane: usize,
        eye: f32x16<S>,
        part: Option<Part<'_, S>>,
        line: &Seen,
        every: usize,
        best: &mut Best<S, DISTANCE>,
    ) {
        let Some(part) = part else { return };
        if !self.may_be_higher(simd, column, eye, part, best) {
            return;
        }
        let highest = self.highest(simd, column, eye, part);
        let slope = highest.heights / highest.columns - highest.columns * self.bend;
        let mut above = slope.simd_gt(best.slope).to_bitmask();
        if above == 0 {
            return;
        }
        let (ahead, eyes): ([f32; LANES], [f32; LANES]) = (highest.columns.into(), eye.into());
        let (mut slopes, mut distances): ([f32; LANES], [f32; LANES]) = (best.slope.into(), best.distance.into());
        while above != 0 {
            let l = above.trailing_zeros() as usize % LANES;
            above &= above - 1;
            let block = (column + ahead[l] as usize) / BLOCK;
            if line.from / every != column / every || line.columns[l] / BLOCK != block {
                let found = self.follow_one(column, lane + l, eyes[l], block * BLOCK);
                if found.0 > slopes[l] || (found.0 == slopes[l] && found.1 > distances[l]) {
                    (slopes[l], distances[l]) = found;
                }
            }
        }
        best.slope = slopes.simd_into(simd);
        best.distance = distances.simd_into(simd);
    }

    /// The highest point of one texel's ray in the four columns from `first` on, and where it crosses rows behind them.
    fn follow_one(&self, from: usize, line: usize, eye: f32, first: usize) -> (f32, f32) {
        let tilt = self.lines.octant.tilt as f32;
        let radius = self.lines.radius as f32;
        let mut best = (f32::NEG_INFINITY, 0.0);
        let mut raise = |rise: f32, distance: f32| {
            let slope = rise / distance - distance * self.bend;
            if slope >= best.0 {
                best = (slope, distance);
            }
        };
        for column in first..first + BLOCK {
            let crossing = self.lines.offset[from] - self.lines.offset[column];
            let place = column * STRIDE + MARGIN + line - usize::from(crossing < 0.0);
            let down = crossing - floor_within_one(crossing);
            let (upper, lower) = (self.heights[place], self.heights[place + 1]);
            let distance = (column - from) as f32;
            raise((upper - eye) + (lower - upper) * down, distance);
            let along = (1.0 - down) / tilt;
            if along < 1.0 && distance + along <= radius {
                let drop = (self.lines.drop[column + 1] - self.lines.drop[column]) as usize;
                let next = self.heights[place + 1 + STRIDE - drop];
                raise((lower - eye) + (next - lower) * along, distance + along);
            }
        }
        if self.rows_lie_far_apart() {
            let rows = self.row_crossings(from, line, eye, (first, first + BLOCK - 1));
            if rows.0 > best.0 {
                best = rows;
            }
        }
        best
    }

    #[inline(always)]
    fn highest<S: Simd>(&self, simd: S, column: usize, eye: f32x16<S>, part: Part<'_, S>) -> Points<S> {
        let observer = Points { columns: f32x16::splat(simd, column as f32), heights: eye - self.datum };
        if part.from_top {
            part.hull.highest_from_top(simd, observer, self.bend)
        } else {
            part.hull.highest_from_bottom(simd, observer, self.bend)
        }
    }

    /// Whether a hull's highest point, were it anywhere in its range, would stand above what was found.
    #[inline(always)]
    fn may_be_higher<S: Simd, const DISTANCE: bool>(
        &self,
        simd: S,
        column: usize,
        eye: f32x16<S>,
        part: Part<'_, S>,
        best: &Best<S, DISTANCE>,
    ) -> bool {
        let near = (part.places.0 * BLOCK - column) as f32;
        let far = (part.places.1 * BLOCK + BLOCK - column) as f32;
        let sunk = (self.bend * near * near).min(self.bend * far * far);
        let needed = (best.slope * near).min(best.slope * far) + f32x16::splat(simd, sunk);
        (part.highest - (eye - self.datum)).simd_gt(needed).any_true()
    }

    /// What the rays from `column` meet between the last whole block within the radius and the radius itself.
    #[inline(always)]
    pub(crate) fn consider_end<S: Simd, const DISTANCE: bool>(
        &self,
        simd: S,
        end: &RayEnd,
        lane: usize,
        eye: f32x16<S>,
        best: &mut Best<S, DISTANCE>,
    ) {
        for knot in &end.knots[..end.count] {
            let (upper, lower) = (self.load(simd, knot.place + lane), self.load(simd, knot.place + 1 + lane));
            let near = (upper - eye) + (lower - upper) * knot.down;
            let rise = if knot.along > 0.0 {
                let place = knot.next + lane;
                let (upper, lower) = (self.load(simd, place), self.load(simd, place + 1));
                near + (((upper - eye) + (lower - upper) * knot.down) - near) * knot.along
            } else {
                near
            };
            let slope = rise * (1.0 / knot.distance) - self.bend * knot.distance;
            best.raise(slope, f32x16::splat(simd, knot.distance));
        }
        if let Some(level) = end.level.filter(|_| self.bend > 0.0) {
            // Level ground under a parabola is highest where it touches the sight line: at s² = −z/λ.
            let splat = |value: f32| f32x16::splat(simd, value);
            let rise = self.load(simd, level.place + lane) - eye;
            let touching = (rise * (-1.0 / self.bend)).max(splat(0.0)).sqrt();
            let distance = touching.max(splat(level.distance)).min(splat(self.lines.radius as f32));
            best.raise(rise / distance - distance * self.bend, distance);
        }
    }
}

/// The last knots of the rays of a column.
pub(crate) struct RayEnd {
    knots: [EndKnot; BLOCK + 1],
    count: usize,
    /// Where a clamped field's last known column stands for all beyond.
    level: Option<EndKnot>,
}

#[derive(Clone, Copy, Default)]
struct EndKnot {
    place: usize,
    next: usize,
    down: f32,
    along: f32,
    distance: f32,
}

impl RayEnd {
    /// The columns from `after` on that lie within the radius of `from`, and the radius.
    pub(crate) fn new(lines: &Lines, from: usize, after: Option<usize>, columns_in_sight: usize) -> Self {
        let mut end = Self { knots: [EndKnot::default(); BLOCK + 1], count: 0, level: None };
        // Where a clamped field is level for good, its last column stands for all beyond.
        let known = |column: usize| column.min(columns_in_sight - 2);
        let last = from + lines.radius as usize;
        if let Some(after) = after {
            for column in after..=last.min(after + BLOCK - 1) {
                end.add(lines, from, known(column), 0.0, (column - from) as f32);
            }
        }
        if known(last) < last {
            let distance = (known(last) - from) as f32;
            let place = known(last) * STRIDE + MARGIN;
            end.level = Some(EndKnot { place, distance, ..EndKnot::default() });
        }
        let beyond = (lines.radius - lines.radius.floor()) as f32;
        end.add(lines, from, known(last), beyond, lines.radius as f32);
        end
    }

    fn add(&mut self, lines: &Lines, from: usize, column: usize, along: f32, distance: f32) {
        let crossing = lines.offset[from] - lines.offset[column] + lines.octant.tilt as f32 * along;
        let row = crossing.floor();
        let place = |column: usize, row: isize| (column * STRIDE + MARGIN).wrapping_add_signed(row);
        let drop = (lines.drop[column + 1] - lines.drop[column]) as isize;
        self.knots[self.count] = EndKnot {
            place: place(column, row as isize),
            next: place(column + 1, row as isize - drop),
            down: crossing - row,
            along,
            distance,
        };
        self.count += 1;
    }
}

#[inline(always)]
fn highest_of_block<S: Simd>(simd: S, block: usize, height: impl Fn(usize) -> f32x16<S>) -> Points<S> {
    let first = block * BLOCK;
    let mut highest = height(first);
    let mut column = f32x16::splat(simd, first as f32);
    for other in first + 1..first + BLOCK {
        let other_height = height(other);
        let higher = other_height.simd_gt(highest);
        highest = higher.select(other_height, highest);
        column = higher.select(f32x16::splat(simd, other as f32), column);
    }
    Points { columns: column, heights: highest }
}
