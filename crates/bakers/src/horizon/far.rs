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
    Point,
    /// In every column.
    Columns,
    /// In every column, and where the ray crosses a row: at a slight tilt that lies many columns away, and a wall along the
    /// ray is highest there.
    ColumnsAndRows,
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
            let observer = Points { columns: f32x16::splat(simd, column as f32), heights: eye - self.datum };
            let highest = if part.from_top {
                part.hull.highest_from_top(simd, observer, self.bend)
            } else {
                part.hull.highest_from_bottom(simd, observer, self.bend)
            };
            let ahead: [f32; LANES] = highest.columns.into();
            seen.from = column;
            seen.columns = std::array::from_fn(
                #[inline(always)]
                |l| column + ahead[l] as usize,
            );
        }
        match look.care {
            Care::Point => self.cross::<S, DISTANCE, false>(simd, column, lane, eye, seen.columns, best),
            Care::Columns => self.follow::<S, DISTANCE, false>(simd, column, lane, eye, seen.columns, best),
            Care::ColumnsAndRows => self.follow::<S, DISTANCE, true>(simd, column, lane, eye, seen.columns, best),
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

    /// Each lane's own ray through the columns of the block in which a column was seen.
    #[inline(always)]
    fn follow<S: Simd, const DISTANCE: bool, const ROWS: bool>(
        &self,
        simd: S,
        from: usize,
        lane: usize,
        eye: f32x16<S>,
        seen: [usize; LANES],
        best: &mut Best<S, DISTANCE>,
    ) {
        for step in 0..BLOCK {
            let columns: [usize; LANES] = std::array::from_fn(
                #[inline(always)]
                |l| seen[l] / BLOCK * BLOCK + step,
            );
            self.cross::<S, DISTANCE, ROWS>(simd, from, lane, eye, columns, best);
        }
    }

    /// Each lane's own ray where it crosses a column and, if `ROWS`, where it crosses a row before the next column.
    #[inline(always)]
    fn cross<S: Simd, const DISTANCE: bool, const ROWS: bool>(
        &self,
        simd: S,
        from: usize,
        lane: usize,
        eye: f32x16<S>,
        columns: [usize; LANES],
        best: &mut Best<S, DISTANCE>,
    ) {
        let tilt = self.lines.octant.tilt as f32;
        let (mut down, mut distance) = ([0.0_f32; LANES], [0.0_f32; LANES]);
        let (mut upper, mut lower) = ([0.0_f32; LANES], [0.0_f32; LANES]);
        let mut next = [0.0_f32; LANES];
        for l in 0..LANES {
            let column = columns[l];
            let crossing = self.lines.offset[from] - self.lines.offset[column];
            let row = floor_within_one(crossing);
            let place = column * STRIDE + MARGIN + lane + l - usize::from(crossing < 0.0);
            down[l] = crossing - row;
            distance[l] = (column - from) as f32;
            (upper[l], lower[l]) = (self.heights[place], self.heights[place + 1]);
            if ROWS {
                let drop = (self.lines.drop[column + 1] - self.lines.drop[column]) as usize;
                next[l] = self.heights[place + 1 + STRIDE - drop];
            }
        }
        let vector = |values: [f32; LANES]| -> f32x16<S> { values.simd_into(simd) };
        let (down, distance, upper, lower) = (vector(down), vector(distance), vector(upper), vector(lower));
        let rise = (upper - eye) + (lower - upper) * down;
        // Columns that another texel saw may lie beyond this one's radius.
        let radius = f32x16::splat(simd, self.lines.radius as f32);
        best.raise_these(distance.simd_le(radius), rise / distance - distance * self.bend, distance);
        if ROWS {
            let along = (f32x16::splat(simd, 1.0) - down) * (1.0 / tilt);
            let rise = (lower - eye) + (vector(next) - lower) * along;
            let distance = distance + along;
            let slope = rise / distance - distance * self.bend;
            let crosses = along.simd_lt(f32x16::splat(simd, 1.0)) & distance.simd_le(radius);
            best.raise_these(crosses, slope, distance);
        }
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
    }
}

/// The last knots of the rays of a column.
pub(crate) struct RayEnd {
    knots: [EndKnot; BLOCK + 1],
    count: usize,
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
        let mut end = Self { knots: [EndKnot::default(); BLOCK + 1], count: 0 };
        // Where a clamped field is level for good, its last column stands for all beyond.
        let known = |column: usize| column.min(columns_in_sight - 2);
        let last = from + lines.radius as usize;
        if let Some(after) = after {
            for column in after..=last.min(after + BLOCK - 1) {
                end.add(lines, from, known(column), 0.0, (column - from) as f32);
            }
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
