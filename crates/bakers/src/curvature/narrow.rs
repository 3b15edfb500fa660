//! The first pass: a fit to the nearest neighbours of every point.

use std::ops::Range;

use barchan_asset::VertexFlags;
use fearless_simd::{Level, Simd, dispatch};

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
const GROWTH: [usize; 3] = [1, 2, 4];

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
                _ => dispatch!(level, simd => worker.fit_block::<_, 6>(simd, reach.neighbours, points, found)),
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
        let mut undetermined = Vec::new();
        for (start, found) in points.step_by(LANES).zip(found.chunks_mut(LANES)) {
            let patches = self.fit_lanes::<_, DEGREE>(simd, &mut solver, neighbours, start..start + found.len());
            for (lane, (patch, found)) in patches.iter().zip(found.iter_mut()).enumerate() {
                match patch.estimate() {
                    Some(estimate) => *found = self.finish(patch, &estimate, start + lane),
                    None => undetermined.push((start + lane, found)),
                }
            }
        }
        for (point, found) in undetermined {
            *found = self.fit_alone::<_, DEGREE>(simd, &mut solver, neighbours, point);
        }
    }
}
