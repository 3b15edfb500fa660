//! Which bends are swept for candidates, and at which curvatures candidates are judged.
//!
//! # Where the nodes lie
//!
//! Let f(λ) = max over s of δ(s) − λs. It is convex, and a sweep at λ returns a line that touches it there, of slope
//! −d. Between nodes a < b the two lines stay within ¼(b − a)(d_a − d_b) of f: the height of a triangle. How large d
//! may be is known: f is at least the slope at the texel itself, so λd ≤ Δ, where Δ is the height of the flat horizon
//! over that slope, and d ≤ Δ/λ; and d is at most the search radius R. So the first gap, from the flat horizon to λ₁,
//! is within ¼λ₁R, and one of ratio r = b/a within ¼(r − 1)Δ: the bound is evenly spread by nodes in geometric
//! progression that starts at λ₁ = (r − 1)Δ/R. Given the last node and their number, r follows. On concave surfaces
//! the same holds with R − d in the place of d.
//!
//! # Where the last node lies
//!
//! Eq 2 would have λ = κ/2. The exact form is steeper: the points of the flat chart that a curved surface shows at
//! the slope t lie, to first order in κ, on a line of slope κ(1 + κh)(½ + t²). So what maximises the exact slope at
//! κ is what maximises δ − λs at λ = κ(½ + t²), and the last node is put where t = ½ has it: 1.5 times as far out as
//! eq 2 says.
//!
//! # Measured
//!
//! What all candidates together miss, by the f64 twin on the shapes and curvatures of `barchan-study`'s
//! `horizon_curvature`, measured once: the worst RMS error. The fast sweeps add what they miss on flat bases too.
//!
//! | last node over ½κ, bends for convex and both | convex | concave |
//! |---|---:|---:|
//! | 1, 5 and 8: as eq 2 says | .37° | 7.7° |
//! | **1.5, 5 and 8** | **.077°** | **.077°** |
//! | 2, 5 and 8 | .059° | .19° |
//! | 1.5, 3 and 5 | .38° | .27° |
//! | 1.5, 4 and 7 | .16° | .077° |
//! | 1.5, 6 and 8 | .057° | .077° |

use super::CurvatureRange;
use super::params::MAX_POINTS;

/// How many curvatures a candidate is judged at.
pub(super) const LANES: usize = 8;

/// One number for each curvature that candidates are judged at.
pub(super) type Lanes = [f32; LANES];

/// Where the last node lies, over ½κ: 1 + 2t² for a horizon of slope t = ½.
const STRETCH: f64 = 1.5;

/// The height of the flat horizon over the texel's own slope, Δ, that the nodes are spread for: 27°.
const RELIEF: f64 = 0.5;

/// The bends to sweep and the curvatures to judge at, for one range and search radius.
#[derive(Debug, Clone, PartialEq)]
pub struct Nodes {
    bends: Vec<f64>,
    curvatures: Lanes,
}

impl Nodes {
    /// `count` bends, 1 to [`MAX_POINTS`], the flat one included. A range that is both convex and concave needs at
    /// least 3: with fewer, only its convex side is looked at.
    ///
    /// # Panics
    ///
    /// When `count` is out of range.
    #[must_use]
    pub fn new(range: &CurvatureRange, radius: f64, count: usize) -> Self {
        assert!((1..=MAX_POINTS).contains(&count), "{count} bends");
        let (convex, concave) = sides(range);
        let bend = |(near, far): (f64, f64)| (0.5 * near, 0.5 * STRETCH * far);
        let (convex_count, concave_count) = split(count - 1, convex.1 > 0.0, concave.1 > 0.0);
        let mut bends = vec![0.0];
        bends.extend(graded(bend(convex), radius, convex_count));
        bends.extend(graded(bend(concave), radius, concave_count).map(|bend| -bend));
        Self { bends, curvatures: judged(convex, concave, radius) }
    }

    /// As many bends as are worth their time: 5 for a range of one sign, 8 for one of both.
    #[must_use]
    pub fn recommended(range: &CurvatureRange, radius: f64) -> Self {
        let both = range.min < 0.0 && range.max > 0.0;
        Self::new(range, radius, if both { 8 } else { 5 })
    }

    /// The bends λ to sweep, in the inverse of the length unit: 0 first, then convex ones rising, then concave ones
    /// falling.
    #[must_use]
    pub fn bends(&self) -> &[f64] {
        &self.bends
    }

    /// The curvatures κ at which candidates are judged, in the inverse of the length unit; the ends of the range
    /// among them.
    pub(super) fn curvatures(&self) -> &Lanes {
        &self.curvatures
    }
}

/// The convex and the concave part of a range, as sizes: nearest to flat and farthest.
fn sides(range: &CurvatureRange) -> ((f64, f64), (f64, f64)) {
    let side = |near: f64, far: f64| (near.max(0.0), far.max(0.0));
    (side(range.min, range.max), side(-range.max, -range.min))
}

/// How many of `count` go to either side; one that is there gets the odd one, the convex if both are.
fn split(count: usize, convex: bool, concave: bool) -> (usize, usize) {
    match (convex, concave) {
        (true, true) => (count.div_ceil(2), count / 2),
        (true, false) => (count, 0),
        (false, true) => (0, count),
        (false, false) => (0, 0),
    }
}

/// `count` nodes in geometric progression up to `far`, none below `near`, smallest first.
fn graded((near, far): (f64, f64), radius: f64, count: usize) -> impl Iterator<Item = f64> {
    let ratio = ratio(far * radius / RELIEF, count);
    let start = near.max(far / powi(ratio, count.saturating_sub(1)));
    // From `near` on the progression is a slower one.
    let ratio = if count > 1 { libm::pow(far / start, 1.0 / (count - 1) as f64) } else { 1.0 };
    (0..count).map(move |index| if index + 1 == count { far } else { start * powi(ratio, index) })
}

/// The r > 1 at which (r − 1) r^(count − 1) is `span`.
fn ratio(span: f64, count: usize) -> f64 {
    let (mut low, mut high) = (1.0, 2.0 + span);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if (middle - 1.0) * powi(middle, count.saturating_sub(1)) < span { low = middle } else { high = middle }
    }
    high
}

/// By multiplication alone: the same on every machine.
fn powi(base: f64, exponent: usize) -> f64 {
    (0..exponent).fold(1.0, |power, _| power * base)
}

fn judged(convex: (f64, f64), concave: (f64, f64), radius: f64) -> Lanes {
    let (convex_count, concave_count) = split(LANES, convex.1 > 0.0, concave.1 > 0.0);
    // Bends are half a curvature, so the search reaches half as far for the spread.
    let one_side = |side, count| graded(side, 0.5 * radius, count);
    let mut curvatures = [0.0; LANES];
    let values = one_side(convex, convex_count).chain(one_side(concave, concave_count).map(|curvature| -curvature));
    for (lane, curvature) in curvatures.iter_mut().zip(values) {
        *lane = curvature as f32;
    }
    curvatures
}

#[cfg(test)]
mod tests {
    use super::*;

    fn range(min: f64, max: f64) -> CurvatureRange {
        CurvatureRange { min, max }
    }

    #[test]
    fn the_flat_bend_comes_first_and_both_ends_are_swept() {
        for count in 3..=MAX_POINTS {
            let nodes = Nodes::new(&range(-0.01, 0.02), 100.0, count);
            assert_eq!((nodes.bends()[0], nodes.bends().len()), (0.0, count));
            let extreme = |pick: fn(f64, f64) -> f64| nodes.bends().iter().copied().fold(0.0, pick);
            assert_eq!((extreme(f64::max), extreme(f64::min)), (0.5 * STRETCH * 0.02, -0.5 * STRETCH * 0.01));
        }
    }

    #[test]
    fn a_range_without_the_flat_surface_is_swept_between_its_ends() {
        let nodes = Nodes::new(&range(0.01, 0.02), 1000.0, 4);
        assert_eq!(nodes.bends()[0], 0.0);
        assert!(nodes.bends()[1] >= 0.005 && nodes.bends().is_sorted(), "{nodes:?}");
        assert!(nodes.curvatures().iter().all(|curvature| (0.00999..=0.02).contains(curvature)), "{nodes:?}");
        assert!(nodes.curvatures().is_sorted());
    }

    #[test]
    fn the_bound_is_evenly_spread() {
        let (radius, far) = (128.0, 0.02);
        let nodes: Vec<f64> = graded((0.0, far), radius, 5).collect();
        let bounds: Vec<f64> = [0.25 * nodes[0] * radius]
            .into_iter()
            .chain(nodes.windows(2).map(|pair| 0.25 * (pair[1] / pair[0] - 1.0) * RELIEF))
            .collect();
        assert!(bounds.iter().all(|bound| (bound / bounds[0] - 1.0).abs() < 1e-9), "{bounds:?}");
    }

    #[test]
    fn a_flat_scene_needs_no_bend() {
        let nodes = Nodes::recommended(&range(0.0, 0.0), 100.0);
        assert_eq!((nodes.bends(), nodes.curvatures()), (&[0.0][..], &[0.0; LANES]));
    }
}
