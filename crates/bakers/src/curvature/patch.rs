//! The fit to the neighbours of a few points at a time.

use barchan_asset::VertexFlags;
use fearless_simd::Simd;
use glam::DVec3;

use super::VertexCurvature;
use super::estimate::Shape;
use super::frame::Frame;
use super::jet::{JetFits, LANES, Samples, Solver};
use super::neighbourhood::Gatherer;
use super::sheets::Sheets;

/// A point, what surrounds it, and what was fitted.
#[derive(Debug, Clone, Copy)]
pub(super) struct Patch {
    pub(super) frame: Frame,
    pub(super) extent: [f64; 2],
    /// Curvature that was taken out before the fit.
    pub(super) flattened: f64,
    pub(super) fits: JetFits,
}

/// A point and how many neighbours to look at.
pub(super) type Reach = (usize, usize);

/// What a thread keeps from one fit to the next.
#[derive(Debug)]
pub(super) struct Fitter<'a> {
    gatherer: Gatherer<'a>,
    samples: Samples,
    pub(super) sheets: &'a Sheets,
}

impl<'a> Fitter<'a> {
    pub(super) fn new(sheets: &'a Sheets) -> Self {
        Self { gatherer: Gatherer::new(sheets), samples: Samples::default(), sheets }
    }

    /// Fits up to eight points in lockstep.
    #[inline(always)]
    pub(super) fn fit<S: Simd, const DEGREE: usize>(
        &mut self,
        simd: S,
        solver: &mut Solver<S>,
        reaches: &[Reach],
    ) -> [Patch; LANES] {
        let most = reaches.iter().map(|&(_, count)| count).max().unwrap_or(0);
        self.samples.reset(most);
        let mut placed = [(Frame::with_normal(DVec3::ZERO, DVec3::Z), [1.0; 2], 0.0); LANES];
        for (lane, &(point, count)) in reaches.iter().enumerate() {
            let frame = self.gatherer.gather(point, count);
            placed[lane] = (frame, self.gatherer.extent, self.gatherer.flattened);
            self.samples.fill_lane(lane, &self.gatherer);
        }
        let fits = solver.fit::<DEGREE>(simd, &self.samples);
        std::array::from_fn(|lane| {
            let (frame, extent, flattened) = placed[lane];
            Patch { frame, extent, flattened, fits: fits[lane] }
        })
    }

    /// Where no jet is determined: the sphere that follows the neighbours best.
    pub(super) fn sphere(&mut self, (point, count): Reach) -> VertexCurvature {
        let frame = self.gatherer.gather(point, count);
        if self.sheets.normals[point] == DVec3::ZERO {
            let flags = self.sheets.flags[point] | VertexFlags::DEGENERATE;
            return VertexCurvature { flags, ..VertexCurvature::UNKNOWN };
        }
        self.vertex(point, &frame, &Shape::umbilic(self.gatherer.flattened))
    }

    /// What goes into the table.
    pub(super) fn vertex(&self, point: usize, frame: &Frame, shape: &Shape) -> VertexCurvature {
        let (principal, directions, normal) = shape.principal(frame);
        let limit = self.resolvable(point);
        let clamped = principal.map(|curvature| curvature.clamp(-limit, limit));
        let remark = if clamped == principal { VertexFlags::NONE } else { VertexFlags::CLAMPED };
        VertexCurvature { principal: clamped, directions, normal, flags: self.sheets.flags[point] | remark }
    }

    /// The greatest curvature that the edges of a point can resolve: that of a circle of which their mean length is a diameter.
    fn resolvable(&self, point: usize) -> f64 {
        let Sheets { positions, .. } = self.sheets;
        let around = self.sheets.around(point);
        let lengths = around.iter().map(|&next| positions[next as usize].distance(positions[point]));
        let mean = lengths.sum::<f64>() / around.len().max(1) as f64;
        2.0 / mean.max(f64::MIN_POSITIVE)
    }
}
