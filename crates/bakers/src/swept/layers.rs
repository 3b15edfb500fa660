//! Candidates of whole rows to stored points of whole rows, one direction at a time.

use super::accuracy::SelectionErrors;
use super::nodes::Nodes;
use super::params::MAX_POINTS;
use super::select::{HorizonCandidate, losses_by_count, select};

/// Slopes and distances of one bend or one stored point, for a band of texels in one direction.
#[derive(Debug, Clone, Copy)]
pub struct CandidateLayer<'a> {
    /// δ over the flat base surface, as a tangent.
    pub slope: &'a [f32],
    /// d, in the field's length unit.
    pub distance: &'a [f32],
}

/// Where one stored point goes, for a band of texels in one direction.
#[derive(Debug)]
pub struct PointLayerMut<'a> {
    /// δ over the flat base surface, as a tangent.
    pub slope: &'a mut [f32],
    /// d, in the field's length unit.
    pub distance: &'a mut [f32],
}

impl CandidateLayer<'_> {
    #[inline]
    fn candidate(&self, texel: usize) -> HorizonCandidate {
        HorizonCandidate { slope: self.slope[texel], distance: self.distance[texel] }
    }
}

/// Chooses the points of a band. Every texel by itself: bands may be cut and ordered in any way.
///
/// `heights` above the base surface, `candidates` one layer per bend of `nodes`, the flat first, and `points`, one
/// layer per point to store, whose first will be the flat layer, are all of the same texels in the same order.
///
/// # Panics
///
/// When they are not of the same length, or there are none or more than [`MAX_POINTS`] of them.
pub fn select_band(nodes: &Nodes, heights: &[f32], candidates: &[CandidateLayer], points: &mut [PointLayerMut]) {
    let lengths = points.iter().map(|layer| (layer.slope.len(), layer.distance.len()));
    check_lengths(heights.len(), lengths);
    let mut chosen = [HorizonCandidate::default(); MAX_POINTS];
    let count = points.len();
    for_each_texel(heights, candidates, |texel, height, candidates| {
        select(candidates, height, nodes, &mut chosen[..count]);
        for (layer, point) in points.iter_mut().zip(&chosen) {
            (layer.slope[texel], layer.distance[texel]) = (point.slope, point.distance);
        }
    });
}

/// Counts what each number of points would lose on a band, or on a sample of texels: arguments as of [`select_band`].
///
/// # Panics
///
/// As [`select_band`].
pub fn measure_band(nodes: &Nodes, heights: &[f32], candidates: &[CandidateLayer], errors: &mut SelectionErrors) {
    for_each_texel(heights, candidates, |_, height, candidates| {
        errors.add(&losses_by_count(candidates, height, nodes));
    });
}

fn for_each_texel(heights: &[f32], layers: &[CandidateLayer], mut visit: impl FnMut(usize, f32, &[HorizonCandidate])) {
    check_lengths(heights.len(), layers.iter().map(|layer| (layer.slope.len(), layer.distance.len())));
    let mut candidates = [HorizonCandidate::default(); MAX_POINTS];
    let candidates = &mut candidates[..layers.len()];
    for (texel, &height) in heights.iter().enumerate() {
        for (candidate, layer) in candidates.iter_mut().zip(layers) {
            *candidate = layer.candidate(texel);
        }
        visit(texel, height, candidates);
    }
}

fn check_lengths(texels: usize, lengths: impl ExactSizeIterator<Item = (usize, usize)>) {
    assert!((1..=MAX_POINTS).contains(&lengths.len()), "{} layers", lengths.len());
    for (slopes, distances) in lengths {
        assert!(slopes == texels && distances == texels, "layers of {slopes} and {distances} texels, not {texels}");
    }
}
