//! The first pass: a fit to the nearest neighbours of every point.

use barchan_asset::VertexFlags;
use fearless_simd::{Level, Simd, dispatch};

use super::estimate::{Estimate, MOST_AMPLIFIED, MOST_AMPLIFIED_AT_BORDER, Residue, Shape};
use super::jet::{LANES, Solver};
use super::patch::{Fitter, Patch, Reach};
use super::sheets::Sheets;
use super::{CurvatureMethod, VertexCurvature};
use crate::Exec;

/// Points that a thread takes at a time.
pub(super) const BLOCK: usize = 2048;
/// Neighbours of a cubic jet: ten coefficients.
const FAST_NEIGHBOURS: usize = 18;
/// Neighbours of a jet of degree six: 28 coefficients.
const NEIGHBOURS: usize = 44;
/// Neighbours of a jet of degree eight, 45 coefficients, which looks out over the edge of the surface.
const BORDER_NEIGHBOURS: usize = 60;
/// How many times as many neighbours are looked at where fewer do not determine a quadric.
const GROWTH: [usize; 3] = [1, 2, 4];

/// Neighbours and degrees that are tried where a surface is so coarse that the usual ones do not resolve it.
const SMALLER: [(usize, usize); 6] = [(30, 4), (22, 4), (22, 2), (16, 2), (10, 2), (8, 2)];

/// The squared error expected, as a part of the squared curvature, beyond which no expectation means anything and the last of these is taken.
const HOPELESS: f64 = 0.1;

/// What the first pass finds at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Found {
    pub(super) curvature: VertexCurvature,
    /// What the fit left over, where it can be told.
    pub(super) residue: Option<Residue>,
    /// The variance of the shape under unit noise; infinite where no jet was determined.
    pub(super) variance: f64,
    /// The squared error expected of an estimate that does not resolve the surface; `None` if it does.
    unresolved: Option<f64>,
}

/// Fits every point.
pub(super) fn fit_all(sheets: &Sheets, method: CurvatureMethod, exec: &Exec) -> Vec<Found> {
    let unknown =
        Found { curvature: VertexCurvature::UNKNOWN, residue: None, variance: f64::INFINITY, unresolved: None };
    let mut found = vec![unknown; sheets.positions.len()];
    let level = Level::new();
    let blocks = found.chunks_mut(BLOCK).enumerate().collect();
    exec.for_each_with(
        blocks,
        || Fitter::new(sheets),
        |fitter, (block, found): (usize, &mut [Found])| match method {
            CurvatureMethod::Fast => dispatch!(level, simd => fit_fast(simd, fitter, block * BLOCK, found)),
            CurvatureMethod::Accurate => dispatch!(level, simd => fit_accurately(simd, fitter, block * BLOCK, found)),
        },
    );
    found
}

/// Fits a block of points that begins with `first`.
#[inline(always)]
fn fit_fast<S: Simd>(simd: S, fitter: &mut Fitter<'_>, first: usize, found: &mut [Found]) {
    let reaches: Vec<Reach> = (first..first + found.len()).map(|point| (point, FAST_NEIGHBOURS)).collect();
    fit_points::<_, 3>(simd, fitter, &reaches, first, found);
}

/// The same, at the edge of the surface farther.
#[inline(always)]
fn fit_accurately<S: Simd>(simd: S, fitter: &mut Fitter<'_>, first: usize, found: &mut [Found]) {
    let points = first..first + found.len();
    let (border, inside): (Vec<usize>, Vec<usize>) = points.partition(|&point| is_at_border(fitter.sheets, point));
    let inside: Vec<Reach> = inside.into_iter().map(|point| (point, NEIGHBOURS)).collect();
    let border: Vec<Reach> = border.into_iter().map(|point| (point, BORDER_NEIGHBOURS)).collect();
    fit_points::<_, 6>(simd, fitter, &inside, first, found);
    fit_points::<_, 8>(simd, fitter, &border, first, found);
}

/// Whether a point is on the edge of the surface or next to it.
fn is_at_border(sheets: &Sheets, point: usize) -> bool {
    let on_edge = |point: usize| sheets.flags[point].contains(VertexFlags::BOUNDARY);
    on_edge(point) || sheets.around(point).iter().any(|&next| on_edge(next as usize))
}

#[inline(always)]
fn fit_points<S: Simd, const DEGREE: usize>(
    simd: S,
    fitter: &mut Fitter<'_>,
    reaches: &[Reach],
    first: usize,
    found: &mut [Found],
) {
    let mut solver = Solver::new(simd);
    let most_amplified = if DEGREE > 6 { MOST_AMPLIFIED_AT_BORDER } else { MOST_AMPLIFIED };
    let mut wanting = reaches.to_vec();
    for growth in GROWTH {
        let asked = std::mem::take(&mut wanting);
        for asked in asked.chunks(LANES) {
            let grown: Vec<Reach> = asked.iter().map(|&(point, count)| (point, growth * count)).collect();
            let patches = fitter.fit::<_, DEGREE>(simd, &mut solver, &grown);
            for (&(point, count), patch) in asked.iter().zip(&patches) {
                let Some(estimate) = Estimate::of(patch, most_amplified) else {
                    wanting.push((point, count));
                    continue;
                };
                let Estimate { shape, residue, error } = estimate;
                let curvature = fitter.vertex(point, &patch.frame, &shape);
                let unresolved = (!estimate.is_resolved()).then_some(error);
                found[point - first] = Found { curvature, residue, variance: shape.variance, unresolved };
            }
        }
    }
    for (point, count) in wanting {
        let curvature = fitter.sphere((point, count));
        found[point - first] = Found { curvature, residue: None, variance: f64::INFINITY, unresolved: None };
    }
}

/// Tries smaller neighbourhoods where the usual ones do not resolve the surface, and takes whichever is expected to be nearest.
pub(super) fn resolve(sheets: &Sheets, found: &mut [Found], exec: &Exec) {
    if found.iter().all(|found| found.unresolved.is_none()) {
        return;
    }
    let level = Level::new();
    let blocks = found.chunks_mut(BLOCK).enumerate().collect();
    exec.for_each_with(
        blocks,
        || Fitter::new(sheets),
        |fitter, (block, found): (usize, &mut [Found])| {
            dispatch!(level, simd => resolve_block(simd, fitter, block * BLOCK, found));
        },
    );
}

#[inline(always)]
fn resolve_block<S: Simd>(simd: S, fitter: &mut Fitter<'_>, first: usize, found: &mut [Found]) {
    let mut solver = Solver::new(simd);
    for (point, found) in (first..).zip(found) {
        let Some(error) = found.unresolved else { continue };
        let patches = fitter.fit::<_, 4>(simd, &mut solver, &SMALLER.map(|(count, _)| (point, count)));
        let [k1, k2] = found.curvature.principal;
        let hopeless = error > HOPELESS * (k1 * k1 + k2 * k2);
        let [.., nearest] = &patches[..SMALLER.len()] else { continue };
        let chosen = match Shape::of_quadric(nearest).filter(|_| hopeless) {
            Some(shape) => Some((nearest, shape)),
            None => likeliest(&patches, error),
        };
        if let Some((patch, shape)) = chosen {
            found.curvature = fitter.vertex(point, &patch.frame, &shape);
        }
    }
}

/// The one of the smaller neighbourhoods of which the least error is expected, if less than that.
fn likeliest(patches: &[Patch], mut least: f64) -> Option<(&Patch, Shape)> {
    let mut likeliest = None;
    for (patch, (_, degree)) in patches.iter().zip(SMALLER) {
        if let Some(estimate) = Estimate::of_degree(patch, degree).filter(|estimate| estimate.error < least) {
            least = estimate.error;
            likeliest = Some((patch, estimate.shape));
        }
    }
    likeliest
}
