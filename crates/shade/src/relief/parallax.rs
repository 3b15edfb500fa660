//! Parallax occlusion mapping: linear search, then one secant.
//!
//! Natalya Tatarchuk, *Dynamic Parallax Occlusion Mapping with Approximate Soft Shadows*, 2006: the surface between the last
//! two steps is taken for a line. It misses what linear search misses, and its hit is off where the surface is not a line.

use super::start::{Left, leave_relief};
use super::{Fetches, Found, MOST_STEPS, Relief, ReliefRay, ReliefSearch, Start};

/// Linear search with a secant end.
#[derive(Debug, Clone, Copy)]
pub struct ParallaxOcclusion<'a> {
    relief: Relief<'a>,
    steps: u32,
}

impl<'a> ParallaxOcclusion<'a> {
    /// Steps of 1 / `steps` of the thickness, 1 to 2²⁰ of them.
    #[must_use]
    pub fn new(relief: &Relief<'a>, steps: u32) -> Self {
        Self { relief: *relief, steps: steps.clamp(1, MOST_STEPS) }
    }
}

impl ReliefSearch for ParallaxOcclusion<'_> {
    fn name(&self) -> &'static str {
        "parallax occlusion"
    }

    fn find(&self, ray: &ReliefRay, start: Start) -> Found {
        let (step, mut fetches) = (1.0 / f64::from(self.steps), start.fetches);
        let start = match leave_relief(&self.relief, ray, start, step, &mut fetches) {
            Left::Behind(outside) | Left::Within(outside, _) => outside,
        };
        let mut gap = |depth: f64| {
            fetches += Fetches::HEIGHT;
            self.relief.gap(ray, depth)
        };
        let mut before = (start, gap(start));
        let mut depth = start;
        for k in 1_u32.. {
            if before.1 <= 0.0 || before.0 >= 1.0 {
                break;
            }
            let here = (start + f64::from(k) * step).min(1.0);
            let after = gap(here);
            depth = here;
            if after <= 0.0 {
                depth = before.0 + (here - before.0) * before.1 / (before.1 - after);
                break;
            }
            before = (here, after);
        }
        Found { depth, fetches }
    }
}
