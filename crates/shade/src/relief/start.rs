//! What to do with a start: how near it is likely to be, and the way back out of one that is not proven.
//!
//! Takeshi Suzuki, *An Accelerated Relief Mapping Using Depth Maps*, section 3.2: where the start is outside the relief, march
//! on; where it is inside, march back out.

use super::{Fetches, Relief, ReliefRay, Start};

/// The step of a march back for searches that have no step of their own, as a part of the thickness.
pub(crate) const STEP_BACK: f64 = 1.0 / 64.0;

/// What part of a ray's way to the floor is before it: from the top, and from a start that was looked up. Measured on
/// fractal relief, spikes, walls and noise; a part that shrinks with the depth of the start cost more on all but spikes. It
/// decides what is fetched first and never what is found.
const WAY_FROM_TOP: f64 = 0.25;
const WAY_FROM_START: f64 = 1.0 / 32.0;

/// About how many texels a ray goes along u or v from a start to its hit.
pub(crate) fn way_ahead(ray: &ReliefRay, start: f64) -> f64 {
    let part = if start > 0.0 { WAY_FROM_START } else { WAY_FROM_TOP };
    part * ray.step.0.abs().max(ray.step.1.abs())
}

/// What a start turned out to be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Left {
    /// Outside the relief at this depth: march on.
    Behind(f64),
    /// Inside: a march back is outside at the first depth and was still inside at the second.
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
    // What is not a number begins at the top.
    let depth = if start.depth > 0.0 { start.depth.min(1.0) } else { 0.0 };
    if start.proven || depth == 0.0 {
        return Left::Behind(depth);
    }
    let mut inside = depth;
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

/// A depth outside the relief to go on from, for searches that solve what is behind it themselves.
pub(crate) fn leave_relief_to(relief: &Relief<'_>, ray: &ReliefRay, start: Start, fetches: &mut Fetches) -> f64 {
    match leave_relief(relief, ray, start, STEP_BACK, fetches) {
        Left::Behind(outside) | Left::Within(outside, _) => outside,
    }
}
