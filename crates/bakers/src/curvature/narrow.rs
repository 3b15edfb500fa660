//! The first pass: a fit to the nearest neighbours of every point.

use std::ops::Range;

use barchan_asset::VertexFlags;
use fearless_simd::{Level, Simd, dispatch};
use glam::DVec3;

use super::estimate::{Estimate, Shape};
use super::frame::Frame;
use super::jet::{JetFits, LANES, Samples, Solver};
use super::neighbourhood::Gatherer;
use super::sheets::Sheets;
use super::table::VertexCurvature;
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

/// Degree and neighbours of a pass.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reach {
    pub(super) degree: usize,
    pub(super) neighbours: usize,
}

/// Fits every point.
pub(super) fn fit_all(sheets: &Sheets, reach: Reach, exec: &Exec) -> Vec<Found> {
    let unknown = Found { curvature: VertexCurvature::UNKNOWN, noise: None, variance: 0.0 };
    let mut found = vec![unknown; sheets.positions.len()];
    let level = Level::new();
    let blocks = found.chunks_mut(BLOCK).enumerate().collect();
    exec.for_each_with(
        blocks,
        || Worker { gatherer: Gatherer::new(sheets), samples: Samples::default(), sheets },
        |worker, (block, found): (usize, &mut [Found])| {
            let first = block * BLOCK;
            let points = first..first + found.len();
            match reach.degree {
                3 => dispatch!(level, simd => worker.fit_block::<_, 3>(simd, reach.neighbours, points, found)),
                _ => {
                    dispatch!(level, simd => worker.fit_block::<_, 6>(simd, reach.neighbours, points.clone(), found));
                    let bn = super::knob::bn();
                    if bn > 0 { dispatch!(level, simd => worker.fit_border::<_, 8>(simd, bn, points, found)); }
                }
            }
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
    fn fit_block<S: Simd, const DEGREE: usize>(
        &mut self,
        simd: S,
        neighbours: usize,
        points: Range<usize>,
        found: &mut [Found],
    ) {
        let mut solver = Solver::new(simd);
        for (start, found) in points.step_by(LANES).zip(found.chunks_mut(LANES)) {
            let patches = self.fit_lanes::<_, DEGREE>(simd, &mut solver, neighbours, start..start + found.len());
            for (lane, found) in found.iter_mut().enumerate() {
                let patch = &patches[lane];
                *found = match Estimate::of(&patch.fits, patch.extent, patch.flattened) {
                    Some(estimate) => self.finish(&patch.frame, &estimate, start + lane),
                    None => self.fit_wider::<_, DEGREE>(simd, &mut solver, neighbours, start + lane),
                };
            }
        }
    }

    #[inline(always)]
    fn fit_border<S: Simd, const DEGREE: usize>(&mut self, simd: S, neighbours: usize, points: Range<usize>, found: &mut [Found]) {
        let mut solver = Solver::new(simd);
        let first = points.start;
        for point in points {
            let near = self.sheets.flags[point].contains(VertexFlags::BOUNDARY) || self.sheets.around(point).iter().any(|&n| self.sheets.flags[n as usize].contains(VertexFlags::BOUNDARY));
            if near {
                let patches = self.fit_lanes::<_, DEGREE>(simd, &mut solver, neighbours, point..point + 1);
                let [Patch { frame, extent, flattened, fits }, ..] = patches;
                if let Some(estimate) = Estimate::of(&fits, extent, flattened) {
                    found[point - first] = self.finish(&frame, &estimate, point);
                }
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
        points: Range<usize>,
    ) -> [Patch; LANES] {
        self.samples.reset(neighbours);
        let mut placed = [(Frame::with_normal(DVec3::ZERO, DVec3::Z), [1.0; 2], 0.0); LANES];
        for (lane, point) in points.enumerate() {
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
            let patches = self.fit_lanes::<_, DEGREE>(simd, solver, growth * neighbours, point..point + 1);
            let [Patch { frame, extent, flattened, fits }, ..] = patches;
            if let Some(estimate) = Estimate::of(&fits, extent, flattened) {
                return self.finish(&frame, &estimate, point);
            }
        }
        let frame = self.gatherer.gather(point, neighbours);
        if self.sheets.normals[point] == DVec3::ZERO {
            let flags = self.sheets.flags[point] | VertexFlags::DEGENERATE;
            return Found { curvature: VertexCurvature { flags, ..VertexCurvature::UNKNOWN }, noise: None, variance: 0.0 };
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
