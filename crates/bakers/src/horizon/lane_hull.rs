//! Upper convex hulls of sixteen lines at a time.
//!
//! A hull is a stack of points per lane, `[depth][lane]`, so that lanes of about the same depth share cache lines; a lane
//! that is done waits for the others. A point is stacked once and dropped at most once: amortised constant time.
//!
//! With a *bend* λ the hull is that of the relief less λ x², a parabola under which what is highest on a curved surface is
//! highest on a level one. Written relative to the observer the parabola costs one product and loses no digits: of two
//! points at distances x₁ < x₂ and heights z₁, z₂, the farther is seen as high or higher iff
//! z₂ x₁ − λ x₁ x₂ (x₂ − x₁) ≥ z₁ x₂.

use fearless_simd::{Simd, f32x16, mask32x16, prelude::*, u32x16, u64x8};

/// Lines swept in lockstep.
pub(crate) const LANES: usize = 16;

/// A column and a height in one word: two floats that are always fetched together.
type Point = u64;

#[inline(always)]
fn point(column: f32, height: f32) -> Point {
    u64::from(height.to_bits()) | (u64::from(column.to_bits()) << 32)
}

/// Points as one vector of columns and one of heights.
#[derive(Clone, Copy)]
pub(crate) struct Points<S: Simd> {
    pub(crate) columns: f32x16<S>,
    pub(crate) heights: f32x16<S>,
}

/// An upper hull per lane, growing at one end.
pub(crate) struct LaneHull {
    stack: Vec<[Point; LANES]>,
    /// One past the last point of each lane. Place 0 holds a bottom that no point hides and none is seen beyond.
    depth: [u32; LANES],
    pushes: usize,
}

/// What a push changed.
pub(crate) struct Undo {
    depth: [u32; LANES],
    overwritten: [Point; LANES],
}

impl LaneHull {
    pub(crate) fn new() -> Self {
        let bottom = [point(1e9, f32::NEG_INFINITY); LANES];
        Self { stack: vec![bottom; 64], depth: [1; LANES], pushes: 0 }
    }

    pub(crate) fn clear(&mut self) {
        self.depth = [1; LANES];
        self.pushes = 0;
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.pushes == 0
    }

    /// Adds a point per lane on the side of the observer: nearer than all before.
    #[inline(always)]
    pub(crate) fn push_nearer<S: Simd>(&mut self, simd: S, new: Points<S>, bend: f32) {
        let depth = self.depth_after_hiding(
            simd,
            new,
            bend,
            #[inline(always)]
            |z1_x2, z2_x1| z1_x2.simd_le(z2_x1),
        );
        self.put(simd, new, depth);
    }

    /// Adds a point per lane on the far side; the push can be taken back.
    #[inline(always)]
    pub(crate) fn push_farther<S: Simd>(&mut self, simd: S, new: Points<S>, bend: f32) -> Undo {
        // Seen back from the new point distances are negative, which turns the comparison around.
        let depth = self.depth_after_hiding(
            simd,
            new,
            bend,
            #[inline(always)]
            |z1_x2, z2_x1| z1_x2.simd_ge(z2_x1),
        );
        self.make_room();
        let overwritten = std::array::from_fn(
            #[inline(always)]
            |lane| self.stack[self.place(depth[lane])][lane],
        );
        let undo = Undo { depth: self.depth, overwritten };
        self.put(simd, new, depth);
        undo
    }

    /// Takes back the latest push that was not taken back yet.
    pub(crate) fn undo(&mut self, undo: &Undo) {
        for lane in 0..LANES {
            let place = self.place(self.depth[lane] - 1);
            self.stack[place][lane] = undo.overwritten[lane];
        }
        self.depth = undo.depth;
        self.pushes -= 1;
    }

    /// The depth of each lane once the points on or below the chord from a new point are dropped.
    #[inline(always)]
    fn depth_after_hiding<S: Simd>(
        &self,
        simd: S,
        new: Points<S>,
        bend: f32,
        hidden: impl Fn(f32x16<S>, f32x16<S>) -> mask32x16<S>,
    ) -> [u32; LANES] {
        if self.is_empty() {
            return self.depth;
        }
        let bend = f32x16::splat(simd, bend);
        let mut depth: u32x16<S> = self.depth.simd_into(simd);
        let mut first = self.points(simd, depth - 1).relative_to(new);
        loop {
            let second = self.points(simd, depth - 2).relative_to(new);
            let (z1_x2, z2_x1) = first.compared(second, bend);
            let drop = hidden(z1_x2, z2_x1);
            if !drop.any_true() {
                return depth.into();
            }
            depth = drop.select(depth - 1, depth);
            first = Points {
                columns: drop.select(second.columns, first.columns),
                heights: drop.select(second.heights, first.heights),
            };
        }
    }

    #[inline(always)]
    fn put<S: Simd>(&mut self, simd: S, new: Points<S>, depth: [u32; LANES]) {
        self.make_room();
        let (columns, heights): ([f32; LANES], [f32; LANES]) = (new.columns.into(), new.heights.into());
        for lane in 0..LANES {
            let place = self.place(depth[lane]);
            self.stack[place][lane] = point(columns[lane], heights[lane]);
        }
        let depth: u32x16<S> = depth.simd_into(simd);
        self.depth = (depth + 1).into();
        self.pushes += 1;
    }

    /// Room for one more point. Lengths are powers of two, so that [`Self::place`] need not be checked.
    fn make_room(&mut self) {
        if self.pushes + 2 >= self.stack.len() {
            let bottom = self.stack[0];
            self.stack.resize(2 * self.stack.len(), bottom);
        }
    }

    #[inline(always)]
    fn place(&self, depth: u32) -> usize {
        depth as usize & (self.stack.len() - 1)
    }

    #[inline(always)]
    fn points<S: Simd>(&self, simd: S, places: u32x16<S>) -> Points<S> {
        let places: [u32; LANES] = places.into();
        let at = |lane: usize| self.stack[self.place(places[lane])][lane];
        let low: u64x8<S> = [at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7)].simd_into(simd);
        let high: u64x8<S> = [at(8), at(9), at(10), at(11), at(12), at(13), at(14), at(15)].simd_into(simd);
        let (low, high): (f32x16<S>, f32x16<S>) = (low.bitcast(), high.bitcast());
        let (heights, columns) = low.deinterleave(high);
        Points { columns, heights }
    }

    /// The point of each lane seen highest by an observer nearer than all of them, if points arrived [`Self::push_nearer`].
    #[inline(always)]
    pub(crate) fn highest_from_top<S: Simd>(&self, simd: S, eye: Points<S>, bend: f32) -> Points<S> {
        /// Most observers see what is near: this many points are tried in turn before the rest is bisected.
        const STRIDES: usize = 12;
        let splat_bend = f32x16::splat(simd, bend);
        let mut depth: u32x16<S> = self.depth.simd_into(simd);
        let mut first = self.points(simd, depth - 1).relative_to(eye);
        for _ in 0..STRIDES {
            let second = self.points(simd, depth - 2).relative_to(eye);
            let (z1_x2, z2_x1) = first.compared(second, splat_bend);
            let go_on = z2_x1.simd_ge(z1_x2);
            if !go_on.any_true() {
                return first;
            }
            depth = go_on.select(depth - 1, depth);
            first = Points {
                columns: go_on.select(second.columns, first.columns),
                heights: go_on.select(second.heights, first.heights),
            };
        }
        self.bisect(simd, eye, bend, depth - 1, u32::MAX, depth - 2)
    }

    /// The same if points arrived by [`Self::push_farther`]; lanes must not be empty.
    #[inline(always)]
    pub(crate) fn highest_from_bottom<S: Simd>(&self, simd: S, eye: Points<S>, bend: f32) -> Points<S> {
        let depth: u32x16<S> = self.depth.simd_into(simd);
        self.bisect(simd, eye, bend, u32x16::splat(simd, 1), 1, depth - 2)
    }

    /// Along a hull points are seen higher and higher and then lower and lower: the first of at most `last` steps from
    /// `start` after which the next point is lower.
    #[inline(always)]
    fn bisect<S: Simd>(
        &self,
        simd: S,
        eye: Points<S>,
        bend: f32,
        start: u32x16<S>,
        step: u32,
        last: u32x16<S>,
    ) -> Points<S> {
        let bend = f32x16::splat(simd, bend);
        let step = u32x16::splat(simd, step);
        let (mut low, mut high) = (u32x16::splat(simd, 0), last);
        loop {
            let searching = low.simd_lt(high);
            if !searching.any_true() {
                return self.points(simd, start + low * step).relative_to(eye);
            }
            let middle = (low + high) >> 1;
            let place = start + middle * step;
            let first = self.points(simd, place).relative_to(eye);
            let second = self.points(simd, place + step).relative_to(eye);
            let (z1_x2, z2_x1) = first.compared(second, bend);
            let go_on = z2_x1.simd_ge(z1_x2) & searching;
            low = go_on.select(middle + 1, low);
            high = (go_on | !searching).select(high, middle);
        }
    }
}

impl<S: Simd> Points<S> {
    #[inline(always)]
    pub(crate) fn relative_to(self, origin: Self) -> Self {
        Self { columns: self.columns - origin.columns, heights: self.heights - origin.heights }
    }

    /// The two products whose order says which of two points is seen higher from the origin, the bend on the second.
    #[inline(always)]
    fn compared(self, second: Self, bend: f32x16<S>) -> (f32x16<S>, f32x16<S>) {
        let (x1, x2) = (self.columns, second.columns);
        let parabola = bend * (x1 * x2) * (x1 - x2);
        (self.heights * x2, second.heights * x1 + parabola)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fearless_simd::{Level, dispatch};

    /// Heights of sixteen lines, from one number per place.
    fn noise(length: usize, seed: u64) -> Vec<[f32; LANES]> {
        let mut state = seed;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 40) as f32 / 65_536.0
        };
        (0..length).map(|_| std::array::from_fn(|_| next())).collect()
    }

    fn seen(rise: f32, run: f32, bend: f32) -> f64 {
        f64::from(rise) / f64::from(run) - f64::from(bend) * f64::from(run)
    }

    #[inline(always)]
    fn points<S: Simd>(simd: S, column: usize, heights: [f32; LANES]) -> Points<S> {
        Points { columns: f32x16::splat(simd, column as f32), heights: heights.simd_into(simd) }
    }

    /// Every observer before the points of `heights[lag..]`, near side growing.
    #[inline(always)]
    fn check_nearer<S: Simd>(simd: S, heights: &[[f32; LANES]], bend: f32) {
        let mut hull = LaneHull::new();
        for column in (1..heights.len()).rev() {
            hull.push_nearer(simd, points(simd, column, heights[column]), bend);
            let eye = heights[column - 1];
            let found = hull.highest_from_top(simd, points(simd, column - 1, eye), bend);
            check(simd, found, heights, column..heights.len(), column - 1, eye, bend);
        }
    }

    #[inline(always)]
    fn check_farther<S: Simd>(simd: S, heights: &[[f32; LANES]], bend: f32) {
        let mut hull = LaneHull::new();
        let undo: Vec<Undo> = (1..heights.len())
            .map(|column| hull.push_farther(simd, points(simd, column, heights[column]), bend))
            .collect();
        for (end, undo) in (1..heights.len()).zip(&undo).rev() {
            let found = hull.highest_from_bottom(simd, points(simd, 0, heights[0]), bend);
            check(simd, found, heights, 1..end + 1, 0, heights[0], bend);
            hull.undo(undo);
        }
        assert!(hull.is_empty());
    }

    fn check<S: Simd>(
        _: S,
        found: Points<S>,
        heights: &[[f32; LANES]],
        range: std::ops::Range<usize>,
        observer: usize,
        eye: [f32; LANES],
        bend: f32,
    ) {
        let (columns, rises): ([f32; LANES], [f32; LANES]) = (found.columns.into(), found.heights.into());
        for lane in 0..LANES {
            let best = range
                .clone()
                .map(|column| seen(heights[column][lane] - eye[lane], (column - observer) as f32, bend))
                .fold(f64::NEG_INFINITY, f64::max);
            let slope = seen(rises[lane], columns[lane], bend);
            assert!((slope - best).abs() <= 1e-4 * (1.0 + best.abs()), "lane {lane} of {range:?}: {slope} for {best}");
        }
    }

    #[test]
    fn the_highest_point_of_every_window_is_found() {
        for bend in [0.0, 0.25, -0.03] {
            for length in [2, 3, 17, 300] {
                let heights = noise(length, length as u64);
                dispatch!(Level::new(), simd => check_nearer(simd, &heights, bend));
                dispatch!(Level::new(), simd => check_farther(simd, &heights, bend));
            }
        }
    }

    #[test]
    fn a_dome_with_pits_is_bisected() {
        let dome = |column: usize| [1e4 - 0.05 * (column as f32).powi(2); LANES];
        let mut heights: Vec<_> = (0..300).map(dome).collect();
        heights[0] = [9e3; LANES];
        let mut hull = LaneHull::new();
        dispatch!(Level::new(), simd => {
            for column in (1..heights.len()).rev() {
                hull.push_nearer(simd, points(simd, column, heights[column]), 0.0);
            }
            let found = hull.highest_from_top(simd, points(simd, 0, heights[0]), 0.0);
            check(simd, found, &heights, 1..heights.len(), 0, heights[0], 0.0);
        });
    }

    #[test]
    fn a_level_line_is_seen_at_its_far_end() {
        dispatch!(Level::new(), simd => {
            let mut hull = LaneHull::new();
            for column in (1..64).rev() {
                hull.push_nearer(simd, points(simd, column, [2.0; LANES]), 0.0);
            }
            let found = hull.highest_from_top(simd, points(simd, 0, [2.0; LANES]), 0.0);
            let columns: [f32; LANES] = found.columns.into();
            assert_eq!(columns, [63.0; LANES]);
        });
    }
}
