//! What lies behind the nearest columns: where to look, and what is there.
//!
//! Columns are taken in blocks of four. Each line has a profile, one point per block, and an upper hull of it names the
//! block in which a texel sees its horizon; the texel's *own* ray is then followed through that block. Two profiles miss
//! different things: the highest sample of the surface on the line itself follows smooth relief, and the *ceiling*, the
//! highest texel that any ray of the line's texels may come near, finds what falls between lines, a spike for one.

use fearless_simd::{Simd, f32x16, prelude::*};

use super::HorizonPoint;
use super::best::Best;
use super::lane_hull::{LANES, Points};
use super::lines::{Lines, MARGIN, STRIDE, floor_within_one};
use super::own_ray::OwnRay;
use super::sliding_hull::Part;

/// Columns in a block.
pub(crate) const BLOCK: usize = 4;

/// How closely a ray is looked at in the block that a hull names.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Care {
    /// Only in the column of the hull's point.
    Column,
    /// In every column of its block.
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

/// Sixteen texels of a column that look along their rays.
#[derive(Clone, Copy)]
pub(crate) struct Eyes<S: Simd> {
    pub(crate) simd: S,
    pub(crate) column: usize,
    /// The first one's line.
    pub(crate) lane: usize,
    pub(crate) height: f32x16<S>,
}

/// The relief as the lines of a block of lines see it.
#[derive(Clone, Copy)]
pub(crate) struct Scene<'a> {
    pub(crate) lines: &'a Lines,
    pub(crate) heights: &'a [f32],
    pub(crate) datum: f32,
    pub(crate) bend: f32,
    /// What a ceiling must stand above a slope to be looked at, in scaled heights per column.
    pub(crate) tolerance: f32,
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

    /// The highest texel among those around the columns of a block that a ray within half a texel of the line touches.
    #[inline(always)]
    pub(crate) fn ceiling_point<S: Simd>(&self, simd: S, lane: usize, block: usize) -> Points<S> {
        let tilt = self.lines.octant.tilt as f32;
        highest_of_block(
            simd,
            block,
            #[inline(always)]
            |column| {
                let middle = -self.lines.offset[column];
                let first = (middle - 0.5 - tilt).floor() as isize;
                let last = (middle + 0.5 + tilt).floor() as isize + 1;
                let place = column * STRIDE + MARGIN + lane;
                let mut highest = self.load(simd, place.wrapping_add_signed(first));
                for row in first + 1..=last {
                    highest = highest.max(self.load(simd, place.wrapping_add_signed(row)));
                }
                highest - self.datum
            },
        )
    }

    /// Follows the rays from `column` through the block in which `part` is seen highest, where that can matter.
    #[inline(always)]
    pub(crate) fn consider<S: Simd, const DISTANCE: bool>(
        &self,
        eyes: Eyes<S>,
        part: Option<Part<'_, S>>,
        seen: &mut Seen,
        look: Look,
        best: &mut Best<S, DISTANCE>,
    ) {
        let column = eyes.column;
        let Some(part) = part else { return };
        if !self.may_be_higher(eyes, part, best) {
            return;
        }
        if seen.from / look.every != column / look.every {
            let highest = self.highest(eyes, part);
            let ahead: [f32; LANES] = highest.columns.into();
            seen.from = column;
            seen.columns = std::array::from_fn(
                #[inline(always)]
                |l| column + ahead[l] as usize,
            );
        }
        match look.care {
            Care::Column => self.cross(eyes, seen.columns, best),
            Care::Block => self.follow(eyes, seen.columns, best),
        }
    }

    /// Each lane's own ray where it crosses a column.
    #[inline(always)]
    fn cross<S: Simd, const DISTANCE: bool>(
        &self,
        eyes: Eyes<S>,
        columns: [usize; LANES],
        best: &mut Best<S, DISTANCE>,
    ) {
        let Eyes { simd, column: from, lane, height: eye } = eyes;
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

    /// Each lane's own ray where it crosses the columns of a block.
    #[inline(always)]
    fn follow<S: Simd, const DISTANCE: bool>(&self, eyes: Eyes<S>, seen: [usize; LANES], best: &mut Best<S, DISTANCE>) {
        let Eyes { simd, column: from, lane, height: eye } = eyes;
        let zeros = [[0.0_f32; LANES]; BLOCK];
        let (mut upper, mut lower, mut down) = (zeros, zeros, zeros);
        let mut first = [0.0_f32; LANES];
        let here = self.lines.offset[from];
        for l in 0..LANES {
            let column = seen[l] / BLOCK * BLOCK;
            first[l] = (column - from) as f32;
            let offsets: &[f32; BLOCK] = self.lines.offset[column..][..BLOCK].try_into().expect("a block");
            let heights = &self.heights[column * STRIDE + MARGIN + lane + l - 1..][..(BLOCK - 1) * STRIDE + 3];
            for step in 0..BLOCK {
                let crossing = here - offsets[step];
                let row = usize::from(crossing >= 0.0);
                let at = step * STRIDE + row;
                (upper[step][l], lower[step][l]) = (heights[at], heights[at + 1]);
                down[step][l] = crossing + 1.0 - row as f32;
            }
        }
        let vector = |values: [f32; LANES]| -> f32x16<S> { values.simd_into(simd) };
        // A block that another texel saw may lie beyond this one's radius.
        let radius = f32x16::splat(simd, self.lines.radius as f32);
        for step in 0..BLOCK {
            let distance = vector(first) + step as f32;
            let (upper, lower, down) = (vector(upper[step]), vector(lower[step]), vector(down[step]));
            let rise = (upper - eye) + (lower - upper) * down;
            best.raise_these(distance.simd_le(radius), rise / distance - distance * self.bend, distance);
        }
    }

    /// Follows the rays of those texels for which the ceiling's tangent stands clearly above all that was found: few, so
    /// one at a time, but wholly.
    #[inline(always)]
    pub(crate) fn consider_ceiling<S: Simd, const DISTANCE: bool>(
        &self,
        eyes: Eyes<S>,
        part: Option<Part<'_, S>>,
        best: &mut Best<S, DISTANCE>,
    ) {
        let Eyes { simd, column, lane, .. } = eyes;
        let Some(part) = part else { return };
        if !self.may_be_higher(eyes, part, best) {
            return;
        }
        let highest = self.highest(eyes, part);
        let slope = highest.heights / highest.columns - highest.columns * self.bend;
        let mut above = slope.simd_gt(best.slope + self.tolerance).to_bitmask();
        if above == 0 {
            return;
        }
        let ahead: [f32; LANES] = highest.columns.into();
        let (mut slopes, mut distances): ([f32; LANES], [f32; LANES]) = (best.slope.into(), best.distance.into());
        while above != 0 {
            let l = above.trailing_zeros() as usize % LANES;
            above &= above - 1;
            let highest = column + ahead[l] as usize;
            (slopes[l], distances[l]) = self.follow_wholly(column, lane + l, highest, (slopes[l], distances[l]));
        }
        best.slope = slopes.simd_into(simd);
        best.distance = distances.simd_into(simd);
    }

    /// Slope and distance of the highest point of one texel's ray on both sides of a column, or of the one known.
    fn follow_wholly(&self, column: usize, line: usize, highest: usize, known: (f32, f32)) -> (f32, f32) {
        let ray = OwnRay::new(*self, column, line);
        let mut best = HorizonPoint { slope: f64::from(known.0), distance: f64::from(known.1) };
        ray.cross_column(highest - 1, &mut best);
        ray.cross_column(highest, &mut best);
        ray.cross_rows_around(highest - 1, highest, &mut best);
        (best.slope as f32, best.distance as f32)
    }

    #[inline(always)]
    fn highest<S: Simd>(&self, eyes: Eyes<S>, part: Part<'_, S>) -> Points<S> {
        let Eyes { simd, column, height: eye, .. } = eyes;
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
        eyes: Eyes<S>,
        part: Part<'_, S>,
        best: &Best<S, DISTANCE>,
    ) -> bool {
        let Eyes { simd, column, height: eye, .. } = eyes;
        // A ray may cross a row on the way to the first column.
        let near = (part.places.0 * BLOCK - column) as f32 - 1.0;
        let far = (part.places.1 * BLOCK + BLOCK - column) as f32;
        let sunk = (self.bend * near * near).min(self.bend * far * far);
        let needed = (best.slope * near).min(best.slope * far) + f32x16::splat(simd, sunk);
        (part.highest - (eye - self.datum)).simd_gt(needed).any_true()
    }

    /// What the rays from `column` meet between the last whole block within the radius and the radius itself.
    #[inline(always)]
    pub(crate) fn consider_end<S: Simd, const DISTANCE: bool>(
        &self,
        eyes: Eyes<S>,
        end: &RayEnd,
        best: &mut Best<S, DISTANCE>,
    ) {
        let Eyes { simd, lane, height: eye, .. } = eyes;
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
