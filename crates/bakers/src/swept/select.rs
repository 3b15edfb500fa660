//! Which of a texel's candidates are stored.
//!
//! Each candidate is seen by the exact formula, at the texel's own height and at each curvature judged at. Its loss
//! there is the tangent of the angle by which it stays below the highest candidate, of a convex surface also below
//! the smooth surface, which needs no point. The flat horizon is always stored; of the sets that contain it and have
//! at most K points the one of the least maximum loss is found by looking at every one: at most 64 of up to 4 points,
//! and few texels have more than 4 different candidates. The first of equal sets is taken, smaller ones first.
//!
//! The points of a set are then stored best first: each is the one that lowers the maximum loss most, given those
//! before it. So a run time that reads fewer layers than are stored has the better part of them. If a set is smaller
//! than K its last point is repeated, which no maximum minds.
//!
//! All in f32 without transcendental functions: the same bits everywhere. About 100 ns per texel and direction with 5
//! candidates and 150 ns with 8, of one core with vectors of four.

use super::nodes::{LANES, Lanes, Nodes};
use super::params::MAX_POINTS;

/// A point of the relief as a texel of the flat base surface sees it.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct HorizonCandidate {
    /// Rise over run from the texel: δ, the tangent of the elevation over the flat base surface.
    pub slope: f32,
    /// Distance along the base surface, in the field's length unit, 0 to the search radius.
    pub distance: f32,
}

/// The tangent of an angle of loss that is a right angle or more.
const LOST: f32 = 1e9;

/// Below and above every slope, with room for products in f32.
const UNSEEN: f32 = -1e15;
const CLOSED: f32 = 1e15;

/// A wall: the tangent of a hair less than 90°, above what any table can hold.
const STEEPEST: f32 = 3e7;

/// Fills `out`, the flat horizon first, with the candidates that serve best over the whole range; returns the angle,
/// as a tangent, by which they fail the highest of all candidates at the worst of the curvatures judged at.
///
/// `candidates` are those of the bends of `nodes` in their order, 1 to [`MAX_POINTS`], the flat one first; `height`
/// is the texel's above the base surface; `out` has at least one place.
///
/// # Panics
///
/// When there is no candidate, no place, or more than [`MAX_POINTS`] of either.
pub fn select(candidates: &[HorizonCandidate], height: f32, nodes: &Nodes, out: &mut [HorizonCandidate]) -> f32 {
    let losses = Losses::new(candidates, height, nodes);
    let best = losses.best_sets(out.len());
    // The smallest set that no larger one beats.
    let chosen = best[..out.len()].iter().fold(best[0], |kept, set| if set.loss < kept.loss { *set } else { kept });
    losses.write_best_first(chosen.members, out);
    chosen.loss
}

/// The loss, as in [`select`], with 1, 2, … [`MAX_POINTS`] points: never rising.
#[must_use]
pub fn losses_by_count(candidates: &[HorizonCandidate], height: f32, nodes: &Nodes) -> [f32; MAX_POINTS] {
    let best = Losses::new(candidates, height, nodes).best_sets(MAX_POINTS);
    let mut least = f32::INFINITY;
    best.map(|set| {
        least = least.min(set.loss);
        least
    })
}

/// The different candidates of a texel, the flat one first, and what each loses at each curvature.
struct Losses {
    candidates: [HorizonCandidate; MAX_POINTS],
    lanes: [Lanes; MAX_POINTS],
    count: usize,
}

/// A set of candidates, a bit for each, and its greatest loss.
#[derive(Clone, Copy)]
struct PointSet {
    members: u8,
    loss: f32,
}

impl Losses {
    fn new(candidates: &[HorizonCandidate], height: f32, nodes: &Nodes) -> Self {
        assert!((1..=MAX_POINTS).contains(&candidates.len()), "{} candidates", candidates.len());
        let mut losses = Self { candidates: [candidates[0]; MAX_POINTS], lanes: [[0.0; LANES]; MAX_POINTS], count: 0 };
        for candidate in candidates {
            if !losses.candidates[..losses.count].contains(candidate) {
                losses.candidates[losses.count] = *candidate;
                losses.count += 1;
            }
        }
        if losses.count > 1 {
            losses.judge(height, nodes.curvatures());
        }
        losses
    }

    fn judge(&mut self, height: f32, curvatures: &Lanes) {
        let ground = ground(height, curvatures);
        let mut highest = ground;
        for (candidate, seen) in self.candidates.iter().zip(&mut self.lanes).take(self.count) {
            *seen = slopes(*candidate, height, curvatures, &ground);
            highest = zip(&highest, seen, larger);
        }
        for seen in &mut self.lanes[..self.count] {
            *seen = zip(&highest, seen, loss);
        }
    }

    /// The best set of each size up to `limit` points, by size − 1.
    fn best_sets(&self, limit: usize) -> [PointSet; MAX_POINTS] {
        assert!((1..=MAX_POINTS).contains(&limit), "{limit} points");
        let mut best = [PointSet { members: 1, loss: f32::INFINITY }; MAX_POINTS];
        self.extend_set(PointSet { members: 1, loss: 0.0 }, &self.lanes[0], 1, &mut best[..limit]);
        best
    }

    /// Enters a set into `best[0]`, and with each later candidate added into the rest.
    fn extend_set(&self, set: PointSet, lanes: &Lanes, next: usize, best: &mut [PointSet]) {
        let Some((same_size, larger)) = best.split_first_mut() else { return };
        let loss = greatest(lanes);
        if loss < same_size.loss {
            *same_size = PointSet { loss, ..set };
        }
        if loss == 0.0 {
            return;
        }
        for index in next..self.count {
            let lanes = zip(lanes, &self.lanes[index], smaller);
            self.extend_set(PointSet { members: set.members | 1 << index, loss }, &lanes, index + 1, larger);
        }
    }

    /// Writes a set, the flat horizon first and then whichever helps most; the last is repeated to the end.
    fn write_best_first(&self, mut members: u8, out: &mut [HorizonCandidate]) {
        let (mut next, mut lanes) = (0, self.lanes[0]);
        for place in out {
            members &= !(1 << next);
            *place = self.candidates[next];
            let with = |index: usize| zip(&lanes, &self.lanes[index], smaller);
            let rest = (1..self.count).filter(|index| members >> index & 1 == 1);
            let best = rest.min_by(|&a, &b| greatest(&with(a)).total_cmp(&greatest(&with(b))));
            if let Some(index) = best {
                lanes = with(index);
                next = index;
            }
        }
    }
}

#[inline]
fn zip(a: &Lanes, b: &Lanes, combine: impl Fn(f32, f32) -> f32) -> Lanes {
    std::array::from_fn(|lane| combine(a[lane], b[lane]))
}

/// The greatest of all lanes, halved again and again: in a row each step would wait for the one before.
#[inline]
fn greatest(lanes: &Lanes) -> f32 {
    let four: [f32; LANES / 2] = std::array::from_fn(|lane| larger(lanes[lane], lanes[lane + LANES / 2]));
    let [a, b, c, d] = four;
    larger(larger(a, c), larger(b, d))
}

/// The tangent of the angle from a slope up to one that is not below it.
#[inline]
fn loss(highest: f32, seen: f32) -> f32 {
    let turned = 1.0 + highest * seen;
    if turned > 0.0 { (highest - seen) / turned } else { LOST }
}

/// The horizon of the smooth surface, eq 3 of Onoue, Max, Nishita with its sign mended; nothing where it is not convex.
#[inline]
fn ground(height: f32, curvatures: &Lanes) -> Lanes {
    curvatures.map(|curvature| {
        let raised = larger(curvature * height, 0.0);
        if curvature > 0.0 { -(raised * (2.0 + raised)).sqrt() } else { UNSEEN }
    })
}

#[inline]
fn slopes(candidate: HorizonCandidate, height: f32, curvatures: &Lanes, ground: &Lanes) -> Lanes {
    zip(curvatures, ground, |curvature, ground| smaller(larger(slope(candidate, height, curvature), ground), CLOSED))
}

/// The exact form of `reference::Turn`, with cos γ and sinc γ by half angles: sinc γ = SC and cos γ = 1 − ½γ²S², where
/// S = sinc(γ/2) and C = cos(γ/2) are polynomials, to 1e-6 up to γ = π.
#[inline]
fn slope(candidate: HorizonCandidate, height: f32, curvature: f32) -> f32 {
    use std::f32::consts::{FRAC_PI_2, PI};
    let flat = candidate.slope.clamp(-STEEPEST, STEEPEST);
    let angle = curvature * candidate.distance;
    let quarter = 0.25 * angle * angle;
    let (half_sinc, half_cos) = half_angle(quarter);
    let stretch = 1.0 + curvature * height;
    let widening = stretch + angle * flat;
    let square = half_sinc * half_sinc;
    let rise = flat * (1.0 - 2.0 * quarter * square) - stretch * (0.5 * angle * square);
    let seen = rise / (widening * half_sinc * half_cos);
    let beyond = if curvature > 0.0 { UNSEEN } else { CLOSED };
    let seen = if widening > 0.0 { seen } else { beyond };
    if angle < FRAC_PI_2 && angle > -PI && stretch > 0.0 { seen } else { UNSEEN }
}

/// sinc x and cos x of q = x² up to (π/2)²: their series. The cosine is kept above 0.
#[inline]
fn half_angle(q: f32) -> (f32, f32) {
    // Multiplied by reciprocals: a division takes longer than the rest of a term.
    const SINC: [f32; 5] = [1.0 / 110.0, 1.0 / 72.0, 1.0 / 42.0, 1.0 / 20.0, 1.0 / 6.0];
    const COS: [f32; 6] = [1.0 / 132.0, 1.0 / 90.0, 1.0 / 56.0, 1.0 / 30.0, 1.0 / 12.0, 1.0 / 2.0];
    let series = |ratios: &[f32]| ratios.iter().fold(1.0, |sum, ratio| 1.0 - q * ratio * sum);
    (series(&SINC), larger(series(&COS), 1e-6))
}

/// As a processor has it, without `f32::max`'s care for NaN, of which there are none.
#[inline]
fn larger(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// The same for the smaller.
#[inline]
fn smaller(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_series_are_the_functions_up_to_half_a_turn() {
        for step in 0..=100 {
            let x = std::f64::consts::FRAC_PI_2 * f64::from(step) / 100.0;
            let (sinc, cos) = half_angle((x * x) as f32);
            let expected = if x == 0.0 { 1.0 } else { x.sin() / x };
            assert!((f64::from(sinc) - expected).abs() < 5e-7 && (f64::from(cos) - x.cos()).abs() < 2e-6, "{x}");
        }
    }

    #[test]
    fn a_loss_is_the_tangent_of_the_angle_between() {
        assert_eq!(loss(1.0, 1.0), 0.0);
        assert!((loss(3.0_f32.sqrt(), 1.0) - 15.0_f32.to_radians().tan()).abs() < 1e-6);
        assert_eq!((loss(1.0, -1.0), loss(CLOSED, -2.0), loss(0.5, UNSEEN)), (LOST, LOST, LOST));
        assert_eq!((loss(UNSEEN, UNSEEN), loss(CLOSED, CLOSED)), (0.0, 0.0));
    }
}
