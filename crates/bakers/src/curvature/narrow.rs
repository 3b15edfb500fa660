//! The first pass: a fit to the nearest neighbours of every point.

use barchan_asset::VertexFlags;
use fearless_simd::{Level, Simd, dispatch};
use glam::DVec3;

use super::estimate::{Estimate, Shape};
use super::frame::Frame;
use super::jet::{JetFits, LANES, Samples, Solver};
use super::neighbourhood::Gatherer;
use super::sheets::Sheets;
use super::{CurvatureMethod, VertexCurvature};
use crate::Exec;

/// Points that a thread takes at a time.
const BLOCK: usize = 2048;
/// Neighbours, growing, where fewer do not determine a quadric.
const GROWTH: [usize; 2] = [2, 4];

/// What the first pass finds at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Found {
    pub(super) curvature: VertexCurvature,
    /// Noise of positions, squared, where it can be told.
    pub(super) noise: Option<f64>,
    /// The variance of the shape under unit noise.
    pub(super) variance: f64,
}

/// Neighbours of a cubic jet: ten coefficients.
const FAST_NEIGHBOURS: usize = 18;
/// Neighbours of a jet of degree six: 28 coefficients.
const NEIGHBOURS: usize = 44;
/// Neighbours of a jet of degree eight, 45 coefficients, which looks out over the edge of the surface.
const BORDER_NEIGHBOURS: usize = 60;

/// Fits every point.
pub(super) fn fit_all(sheets: &Sheets, method: CurvatureMethod, exec: &Exec) -> Vec<Found> {
    let unknown = Found { curvature: VertexCurvature::UNKNOWN, noise: None, variance: 0.0 };
    let mut found = vec![unknown; sheets.positions.len()];
    let level = Level::new();
    let blocks = found.chunks_mut(BLOCK).enumerate().collect();
    exec.for_each_with(
        blocks,
        || Worker { gatherer: Gatherer::new(sheets), samples: Samples::default(), sheets },
        |worker, (block, found): (usize, &mut [Found])| match method {
            CurvatureMethod::Fast => dispatch!(level, simd => worker.fit_fast(simd, block * BLOCK, found)),
            CurvatureMethod::Accurate => dispatch!(level, simd => worker.fit_accurately(simd, block * BLOCK, found)),
        },
    );
    found
}

/// A thread's memory.
struct Worker<'a> {
    gatherer: Gatherer<'a>,
    samples: Samples,
    sheets: &'a Sheets,
}

/// A point, what surrounds it, and what was fitted.
#[derive(Clone, Copy)]
struct Patch {
    frame: Frame,
    extent: [f64; 2],
    /// Curvature that was taken out before the fit.
    flattened: f64,
    fits: JetFits,
}

impl Worker<'_> {
    #[inline(always)]
    fn fit_fast<S: Simd>(&mut self, simd: S, first: usize, found: &mut [Found]) {
        let points: Vec<usize> = (first..first + found.len()).collect();
        self.fit_points::<_, 3>(simd, FAST_NEIGHBOURS, &points, first, found);
    }

    #[inline(always)]
    fn fit_accurately<S: Simd>(&mut self, simd: S, first: usize, found: &mut [Found]) {
        let (border, inside): (Vec<usize>, Vec<usize>) =
            (first..first + found.len()).partition(|&point| self.is_at_border(point));
        self.fit_points::<_, 6>(simd, NEIGHBOURS, &inside, first, found);
        self.fit_points::<_, 8>(simd, BORDER_NEIGHBOURS, &border, first, found);
    }

    /// Whether a point is on the edge of the surface or next to it.
    fn is_at_border(&self, point: usize) -> bool {
        let on_edge = |point: usize| self.sheets.flags[point].contains(VertexFlags::BOUNDARY);
        on_edge(point) || self.sheets.around(point).iter().any(|&next| on_edge(next as usize))
    }

    /// Fits points of a block that begins with the point `first`.
    #[inline(always)]
    fn fit_points<S: Simd, const DEGREE: usize>(
        &mut self,
        simd: S,
        neighbours: usize,
        points: &[usize],
        first: usize,
        found: &mut [Found],
    ) {
        let mut solver = Solver::new(simd);
        for points in points.chunks(LANES) {
            let patches = self.fit_lanes::<_, DEGREE>(simd, &mut solver, neighbours, points);
            for (&point, patch) in points.iter().zip(&patches) {
                found[point - first] = match Estimate::of(&patch.fits, patch.extent, patch.flattened) {
                    Some(estimate) => self.finish(&patch.frame, &estimate, point),
                    None => self.fit_wider::<_, DEGREE>(simd, &mut solver, neighbours, point),
                };
            }
        }
    }

    /// Fits up to eight points in lockstep.
    #[inline(always)]
    fn fit_lanes<S: Simd, const DEGREE: usize>(
        &mut self,
        simd: S,
        solver: &mut Solver<S>,
        neighbours: usize,
        points: &[usize],
    ) -> [Patch; LANES] {
        self.samples.reset(neighbours);
        let mut placed = [(Frame::with_normal(DVec3::ZERO, DVec3::Z), [1.0; 2], 0.0); LANES];
        for (lane, &point) in points.iter().enumerate() {
            let frame = self.gatherer.gather(point, neighbours);
            placed[lane] = (frame, self.gatherer.extent, self.gatherer.flattened);
            self.samples.fill_lane(lane, &self.gatherer);
        }
        let fits = solver.fit::<DEGREE>(simd, &self.samples);
        std::array::from_fn(|lane| {
            let (frame, extent, flattened) = placed[lane];
            Patch { frame, extent, flattened, fits: fits[lane] }
        })
    }

    /// Where the nearest neighbours do not determine a quadric: more of them; at last the mean of their curvatures.
    #[inline(always)]
    fn fit_wider<S: Simd, const DEGREE: usize>(
        &mut self,
        simd: S,
        solver: &mut Solver<S>,
        neighbours: usize,
        point: usize,
    ) -> Found {
        for growth in GROWTH {
            let patches = self.fit_lanes::<_, DEGREE>(simd, solver, growth * neighbours, &[point]);
            let [Patch { frame, extent, flattened, fits }, ..] = patches;
            if let Some(estimate) = Estimate::of(&fits, extent, flattened) {
                return self.finish(&frame, &estimate, point);
            }
        }
        let frame = self.gatherer.gather(point, neighbours);
        if self.sheets.normals[point] == DVec3::ZERO {
            let flags = self.sheets.flags[point] | VertexFlags::DEGENERATE;
            return Found {
                curvature: VertexCurvature { flags, ..VertexCurvature::UNKNOWN },
                noise: None,
                variance: 0.0,
            };
        }
        let umbilic = Shape::umbilic(self.gatherer.flattened);
        self.finish(&frame, &Estimate { shape: umbilic, noise: None }, point)
    }

    fn finish(&self, frame: &Frame, estimate: &Estimate, point: usize) -> Found {
        let (principal, directions, normal) = estimate.shape.principal(frame);
        let limit = self.resolvable(point);
        let clamped = principal.map(|curvature| curvature.clamp(-limit, limit));
        let remark = if clamped == principal { VertexFlags::NONE } else { VertexFlags::CLAMPED };
        let flags = self.sheets.flags[point] | remark;
        let curvature = VertexCurvature { principal: clamped, directions, normal, flags };
        Found { curvature, noise: estimate.noise, variance: estimate.shape.variance }
    }

    /// The greatest curvature that the edges of a point can resolve: a circle on which they would be diameters.
    fn resolvable(&self, point: usize) -> f64 {
        let Sheets { positions, .. } = self.sheets;
        let around = self.sheets.around(point);
        let shortest = around
            .iter()
            .map(|&next| positions[next as usize].distance_squared(positions[point]))
            .filter(|&squared| squared > 0.0)
            .fold(f64::INFINITY, f64::min);
        2.0 / shortest.sqrt().max(f64::MIN_POSITIVE)
    }
}
