//! The highest point found so far, for sixteen texels at a time.

use fearless_simd::{ExtractToken, Simd, f32x16, mask32x16, prelude::*};

/// Slope and, if `DISTANCE`, distance of the highest point so far, in scaled heights per column and in columns. With a bend
/// λ the slope is that of the bent relief, λ · distance lower than the true one.
#[derive(Clone, Copy)]
pub(crate) struct Best<S: Simd, const DISTANCE: bool> {
    pub(crate) slope: f32x16<S>,
    pub(crate) distance: f32x16<S>,
}

impl<S: Simd, const DISTANCE: bool> Best<S, DISTANCE> {
    #[inline(always)]
    pub(crate) fn none(simd: S) -> Self {
        Self { slope: f32x16::splat(simd, f32::NEG_INFINITY), distance: f32x16::splat(simd, 0.0) }
    }

    /// Takes points that are higher, or as high and farther: a level field's horizon is at the search radius.
    #[inline(always)]
    pub(crate) fn raise(&mut self, slope: f32x16<S>, distance: f32x16<S>) {
        if DISTANCE {
            let farther = slope.simd_eq(self.slope) & distance.simd_gt(self.distance);
            self.take(slope.simd_gt(self.slope) | farther, slope, distance);
        } else {
            self.slope = slope.simd_gt(self.slope).select(slope, self.slope);
        }
    }

    /// The same where no point before can be farther.
    #[inline(always)]
    pub(crate) fn raise_farther(&mut self, slope: f32x16<S>, distance: f32x16<S>) {
        if DISTANCE {
            self.take(slope.simd_ge(self.slope), slope, distance);
        } else {
            self.raise(slope, distance);
        }
    }

    /// The same for some lanes only.
    #[inline(always)]
    pub(crate) fn raise_these(&mut self, these: mask32x16<S>, slope: f32x16<S>, distance: f32x16<S>) {
        let lowest = f32x16::splat(slope.token(), f32::NEG_INFINITY);
        self.raise(these.select(slope, lowest), distance);
    }

    #[inline(always)]
    fn take(&mut self, these: mask32x16<S>, slope: f32x16<S>, distance: f32x16<S>) {
        self.slope = these.select(slope, self.slope);
        self.distance = these.select(distance, self.distance);
    }
}
