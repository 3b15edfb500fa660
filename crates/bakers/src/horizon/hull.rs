//! Upper convex hulls of one line's heights: what can be seen of it from anywhere before it.
//!
//! Heights are addressed by their position on the line, a whole number, and a hull is a stack of positions. A position
//! is stacked once and dropped at most once, so a line costs amortised constant time per position.

/// Which way positions arrive at a hull.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Arrival {
    /// Each new position is nearer than all before: the stack ends with its nearest point.
    Nearer,
    /// Each new position is farther: the stack ends with its farthest point.
    Farther,
}

/// The upper hull of the positions pushed so far.
struct UpperHull {
    arrival: Arrival,
    stack: Vec<u32>,
    /// Entries in use. Those behind it stay as they are, for [`UpperHull::undo`].
    length: usize,
}

/// What a push changed.
struct Undo {
    length: usize,
    overwritten: u32,
}

impl UpperHull {
    fn new(arrival: Arrival) -> Self {
        Self { arrival, stack: Vec::new(), length: 0 }
    }

    fn push(&mut self, heights: &[f64], position: u32) -> Undo {
        let mut kept = self.length;
        while kept >= 2 && self.hides(heights, position, self.stack[kept - 1], self.stack[kept - 2]) {
            kept -= 1;
        }
        if kept == self.stack.len() {
            self.stack.push(position);
        }
        let undo = Undo { length: self.length, overwritten: self.stack[kept] };
        self.stack[kept] = position;
        self.length = kept + 1;
        undo
    }

    /// Takes back the latest push that was not taken back yet.
    fn undo(&mut self, undo: &Undo) {
        self.stack[self.length - 1] = undo.overwritten;
        self.length = undo.length;
    }

    /// Whether `middle` lies on or below the chord from `arriving` to `other`.
    fn hides(&self, heights: &[f64], arriving: u32, middle: u32, other: u32) -> bool {
        let from_arriving =
            |to: u32| (f64::from(to) - f64::from(arriving), heights[to as usize] - heights[arriving as usize]);
        let ((middle_x, middle_z), (other_x, other_z)) = (from_arriving(middle), from_arriving(other));
        let turn = middle_z * other_x - other_z * middle_x;
        match self.arrival {
            Arrival::Nearer => turn <= 0.0,
            Arrival::Farther => turn >= 0.0,
        }
    }

    /// The position seen at the steepest slope from height `eye` at `observer`, a position before all of them.
    ///
    /// Slopes rise and then fall along a hull, so it is found by bisection; of two equal slopes the farther wins.
    fn tangent(&self, heights: &[f64], observer: u32, eye: f64) -> Option<u32> {
        let near_to_far = |i: usize| match self.arrival {
            Arrival::Nearer => self.stack[self.length - 1 - i],
            Arrival::Farther => self.stack[i],
        };
        let next_is_as_steep = |i: usize| {
            let (here, next) = (near_to_far(i), near_to_far(i + 1));
            let rise = |to: u32| heights[to as usize] - eye;
            rise(next) * f64::from(here - observer) >= rise(here) * f64::from(next - observer)
        };
        if self.length == 0 {
            return None;
        }
        // Most tangents touch near the observer: stride out in doubling steps, then bisect the last stride.
        let (mut low, mut stride) = (0, 1);
        while low + stride < self.length && next_is_as_steep(low + stride - 1) {
            low += stride;
            stride *= 2;
        }
        let mut high = (low + stride).min(self.length) - 1;
        while low < high {
            let middle = (low + high) / 2;
            if next_is_as_steep(middle) { low = middle + 1 } else { high = middle }
        }
        Some(near_to_far(low))
    }
}

/// The upper hull of a window of fixed length that slides along a line towards smaller positions.
///
/// A hull can take in positions at one end but not lose them at the other, so the line is cut into blocks as long as
/// the window: what the window covers of the nearer block is a hull that grows, and what it covers of the farther
/// block is a hull built whole that shrinks by undoing. Each position enters two hulls.
pub(crate) struct SlidingHull {
    /// Positions the window holds.
    window: usize,
    /// One past the last position of the nearer block.
    block_end: usize,
    nearer: UpperHull,
    farther: UpperHull,
    farther_undo: Vec<Undo>,
}

impl SlidingHull {
    pub(crate) fn new(window: usize) -> Self {
        Self {
            window,
            block_end: 0,
            nearer: UpperHull::new(Arrival::Nearer),
            farther: UpperHull::new(Arrival::Farther),
            farther_undo: Vec::new(),
        }
    }

    /// Forgets everything; the next window starts before `end`.
    pub(crate) fn restart(&mut self, end: usize) {
        self.block_end = end;
        self.nearer.length = 0;
        self.farther.length = 0;
        self.farther_undo.clear();
    }

    /// Moves the window's start to `start`, one before where it was (or one before the end after a restart).
    pub(crate) fn slide_to(&mut self, heights: &[f64], start: usize) {
        if self.block_end - start > self.window {
            self.start_block(heights, start + 1);
        }
        self.nearer.push(heights, start as u32);
        while self.block_end + self.farther_undo.len() > start + self.window
            && let Some(undo) = self.farther_undo.pop()
        {
            self.farther.undo(&undo);
        }
    }

    /// Makes the block from `end` on the farther one.
    fn start_block(&mut self, heights: &[f64], end: usize) {
        self.restart(end);
        for position in end..(end + self.window).min(heights.len()) {
            let undo = self.farther.push(heights, position as u32);
            self.farther_undo.push(undo);
        }
    }

    /// The position in the window seen at the steepest slope from height `eye` at `observer`, before the window.
    pub(crate) fn tangent(&self, heights: &[f64], observer: usize, eye: f64) -> Option<usize> {
        let observer = observer as u32;
        let nearer = self.nearer.tangent(heights, observer, eye);
        let farther = self.farther.tangent(heights, observer, eye);
        let steepest = match (nearer, farther) {
            (Some(near), Some(far)) => {
                let rise = |to: u32| heights[to as usize] - eye;
                let far_is_as_steep = rise(far) * f64::from(near - observer) >= rise(near) * f64::from(far - observer);
                Some(if far_is_as_steep { far } else { near })
            }
            (one, other) => one.or(other),
        };
        steepest.map(|position| position as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every position in the window, tried in turn.
    fn steepest(heights: &[f64], window: std::ops::Range<usize>, observer: usize, eye: f64) -> f64 {
        window.map(|i| (heights[i] - eye) / (i - observer) as f64).fold(f64::NEG_INFINITY, f64::max)
    }

    fn noise(length: usize, seed: u64) -> Vec<f64> {
        let mut state = seed;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 40) as f64 / 65_536.0
        };
        (0..length).map(|_| next()).collect()
    }

    #[test]
    fn finds_the_steepest_position_of_every_window() {
        for window in [1, 2, 3, 7, 16, 100, 1000] {
            for lag in [1, 3] {
                let heights = noise(257, window as u64);
                let mut hull = SlidingHull::new(window);
                hull.restart(heights.len());
                for start in (lag..heights.len()).rev() {
                    hull.slide_to(&heights, start);
                    let observer = start - lag;
                    for eye in [heights[observer], 0.0, 400.0] {
                        let found = hull.tangent(&heights, observer, eye).expect("the window is not empty");
                        let end = (start + window).min(heights.len());
                        assert!((start..end).contains(&found), "{found} outside {start}..{end}");
                        let slope = (heights[found] - eye) / (found - observer) as f64;
                        let expected = steepest(&heights, start..end, observer, eye);
                        assert!((slope - expected).abs() <= 1e-12 * expected.abs(), "window {window} at {start}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_level_line_is_seen_at_its_far_end() {
        let heights = vec![2.0; 64];
        let mut hull = SlidingHull::new(10);
        hull.restart(heights.len());
        for start in (1..heights.len()).rev() {
            hull.slide_to(&heights, start);
            assert_eq!(hull.tangent(&heights, start - 1, 2.0), Some((start + 9).min(63)));
        }
    }
}
