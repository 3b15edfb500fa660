//! The baseline: steps of equal depth until one ends inside the relief, then bisection.
//!
//! Fabio Policarpo, Manuel Oliveira, João Comba, *Real-Time Relief Mapping on Arbitrary Polygonal Surfaces*, 2005: whatever is
//! thinner than a step may be stepped over.

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
        Self { relief: *relief, steps: steps.clamp(1, MOST_STEPS), bisections: bisections.min(MOST_BISECTIONS) }
    }
}

impl ReliefSearch for LinearSearch<'_> {
    fn name(&self) -> &'static str {
        "linear search"
    }

    fn find(&self, ray: &ReliefRay, start: Start) -> Found {
        let (step, mut fetches) = (1.0 / f64::from(self.steps), start.fetches);
        let (mut outside, mut inside) = match leave_relief(&self.relief, ray, start, step, &mut fetches) {
            Left::Within(outside, inside) => (outside, inside),
            Left::Behind(outside) => first_inside(&self.relief, ray, outside, step, &mut fetches),
        };
        for _ in 0..self.bisections {
            let middle = 0.5 * (outside + inside);
            fetches += Fetches::HEIGHT;
            if self.relief.gap(ray, middle) > 0.0 { outside = middle } else { inside = middle }
        }
        Found { depth: 0.5 * (outside + inside), fetches }
    }
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

/// What a start turned out to be.
pub(crate) enum Left {
    /// Outside the relief at this depth: march on.
    Behind(f64),
    /// Inside: a step back is outside at the first depth and inside at the second.
    Within(f64, f64),
}

/// Looks whether a start that is not proven is inside the relief, and if it is, marches back out in steps.
///
/// The crossing that a march back finds is the last before the start, not always the first of the ray: what is thinner than
/// the way back may still be missed, and that is the price of such a start.
pub(crate) fn leave_relief(
    relief: &Relief<'_>,
    ray: &ReliefRay,
    start: Start,
    step: f64,
    fetches: &mut Fetches,
) -> Left {
    if start.proven || start.depth <= 0.0 {
        return Left::Behind(start.depth.clamp(0.0, 1.0));
    }
    let mut inside = start.depth.min(1.0);
    *fetches += Fetches::HEIGHT;
    if relief.gap(ray, inside) > 0.0 {
        return Left::Behind(inside);
    }
    loop {
        let depth = inside - step;
        // Nothing is above the top.
        if depth <= 0.0 {
            return Left::Within(0.0, inside);
        }
        *fetches += Fetches::HEIGHT;
        if relief.gap(ray, depth) > 0.0 {
            return Left::Within(depth, inside);
        }
        inside = depth;
    }
}
