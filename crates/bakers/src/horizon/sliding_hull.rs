//! Upper hulls of a window that slides along sixteen lines towards the observer.
//!
//! A hull can take in points at one end but not lose them at the other, so the line is cut: what the window covers of
//! the nearer part is a hull that grows, and what it covers of the farther part is a hull built whole that shrinks by
//! undoing. When the farther part is used up, all that is in sight becomes the new farther part. Each point enters two
//! hulls at most.

use fearless_simd::{Simd, f32x16, prelude::*};

use super::lane_hull::{LANES, LaneHull, Points, Undo};

/// The hulls of one window and the highest point under each.
pub(crate) struct SlidingHull {
    /// The first place in the window.
    start: usize,
    /// One past the last place of the nearer part.
    nearer_end: usize,
    nearer: LaneHull,
    nearer_highest: [f32; LANES],
    farther: LaneHull,
    /// For each place of the farther part how to take it back, and the highest point up to it.
    farther_places: Vec<(Undo, [f32; LANES])>,
}

/// What an observer needs to know to decide whether a hull is worth asking.
#[derive(Clone, Copy)]
pub(crate) struct Part<'a, S: Simd> {
    pub(crate) hull: &'a LaneHull,
    pub(crate) highest: f32x16<S>,
    /// First and last place.
    pub(crate) places: (usize, usize),
    /// Whether points arrived from the far side, the nearest last.
    pub(crate) from_top: bool,
}

impl SlidingHull {
    pub(crate) fn new() -> Self {
        Self {
            start: usize::MAX,
            nearer_end: usize::MAX,
            nearer: LaneHull::new(),
            nearer_highest: [f32::NEG_INFINITY; LANES],
            farther: LaneHull::new(),
            farther_places: Vec::new(),
        }
    }

    /// Forgets everything.
    pub(crate) fn restart(&mut self) {
        self.start = usize::MAX;
        self.nearer_end = usize::MAX;
    }

    /// Makes `first..=last` the window, neither end farther than it was; `point` tells what is at a place.
    #[inline(always)]
    pub(crate) fn slide_to<S: Simd>(
        &mut self,
        simd: S,
        first: usize,
        last: usize,
        bend: f32,
        point: impl Fn(usize) -> Points<S>,
    ) {
        if last + 1 < self.nearer_end {
            let from = if self.start == usize::MAX { first } else { self.start };
            self.rebuild(simd, from.min(last + 1), last, bend, &point);
        }
        while self.start > first {
            self.start -= 1;
            let new = point(self.start);
            self.nearer.push_nearer(simd, new, bend);
            let highest: f32x16<S> = self.nearer_highest.simd_into(simd);
            self.nearer_highest = highest.max(new.heights).into();
        }
        while self.nearer_end + self.farther_places.len() > last + 1
            && let Some((undo, _)) = self.farther_places.pop()
        {
            self.farther.undo(&undo);
        }
    }

    /// Makes `from..=last` the farther part.
    #[inline(always)]
    fn rebuild<S: Simd>(&mut self, simd: S, from: usize, last: usize, bend: f32, point: &impl Fn(usize) -> Points<S>) {
        (self.start, self.nearer_end) = (from, from);
        self.nearer.clear();
        self.nearer_highest = [f32::NEG_INFINITY; LANES];
        self.farther.clear();
        self.farther_places.clear();
        let mut highest = f32x16::splat(simd, f32::NEG_INFINITY);
        for place in from..=last {
            let new = point(place);
            highest = highest.max(new.heights);
            let undo = self.farther.push_farther(simd, new, bend);
            self.farther_places.push((undo, highest.into()));
        }
    }

    /// The nearer part, unless it is empty.
    #[inline(always)]
    pub(crate) fn nearer<S: Simd>(&self, simd: S) -> Option<Part<'_, S>> {
        (self.start < self.nearer_end).then(|| Part {
            hull: &self.nearer,
            highest: self.nearer_highest.simd_into(simd),
            places: (self.start, self.nearer_end - 1),
            from_top: true,
        })
    }

    /// The farther part, unless it is empty.
    #[inline(always)]
    pub(crate) fn farther<S: Simd>(&self, simd: S) -> Option<Part<'_, S>> {
        self.farther_places.last().map(|(_, highest)| Part {
            hull: &self.farther,
            highest: (*highest).simd_into(simd),
            places: (self.nearer_end, self.nearer_end + self.farther_places.len() - 1),
            from_top: false,
        })
    }
}
