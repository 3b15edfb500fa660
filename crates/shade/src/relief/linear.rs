//! The baseline: steps of equal depth until one ends inside the relief, then bisection.
//!
//! Fabio Policarpo, Manuel Oliveira, João Comba, *Real-Time Relief Mapping on Arbitrary Polygonal Surfaces*, 2005: whatever is
//! thinner than a step may be stepped over.

use super::start::{Left, leave_relief};
use super::{Fetches, Found, MOST_STEPS, Relief, ReliefRay, ReliefSearch, Start};

/// More halvings leave nothing of a step to halve.
const MOST_BISECTIONS: u32 = 64;

/// Linear search and bisection.
#[derive(Debug, Clone, Copy)]
pub struct LinearSearch<'a> {
    relief: Relief<'a>,
    steps: u32,
    bisections: u32,
}

impl<'a> LinearSearch<'a> {
    /// Steps of 1 / `steps` of the thickness, 1 to 2²⁰ of them, and then as many halvings of the last step, 64 at most. The hit
    /// is the middle of what is left.
    #[must_use]
    pub fn new(relief: &Relief<'a>, steps: u32, bisections: u32) -> Self {
        Self { relief: *relief, steps: steps.clamp(1, MOST_STEPS), bisections }
    }
}

impl ReliefSearch for LinearSearch<'_> {
    fn name(&self) -> &'static str {
        "linear search"
    }

    fn find(&self, ray: &ReliefRay, start: Start) -> Found {
        let (step, mut fetches) = (1.0 / f64::from(self.steps), start.fetches);
        let around = match leave_relief(&self.relief, ray, start, step, &mut fetches) {
            Left::Within(outside, inside) => (outside, inside),
            Left::Behind(outside) => first_inside(&self.relief, ray, outside, step, &mut fetches),
        };
        Found { depth: bisect(&self.relief, ray, around, self.bisections, &mut fetches), fetches }
    }
}

/// The middle of what is left after halving a part of a ray that goes from outside to inside, 64 times at most.
pub(crate) fn bisect(
    relief: &Relief<'_>,
    ray: &ReliefRay,
    (mut outside, mut inside): (f64, f64),
    bisections: u32,
    fetches: &mut Fetches,
) -> f64 {
    for _ in 0..bisections.min(MOST_BISECTIONS) {
        let middle = 0.5 * (outside + inside);
        *fetches += Fetches::HEIGHT;
        if relief.gap(ray, middle) > 0.0 {
            outside = middle;
        } else {
            inside = middle;
        }
    }
    0.5 * (outside + inside)
}

/// Marches on until a step ends inside. The floor is inside without a look.
fn first_inside(relief: &Relief<'_>, ray: &ReliefRay, start: f64, step: f64, fetches: &mut Fetches) -> (f64, f64) {
    let mut outside = start;
    for k in 1_u32.. {
        let depth = start + f64::from(k) * step;
        if depth >= 1.0 {
            break;
        }
        *fetches += Fetches::HEIGHT;
        if relief.gap(ray, depth) <= 0.0 {
            return (outside, depth);
        }
        outside = depth;
    }
    (outside, 1.0)
}
