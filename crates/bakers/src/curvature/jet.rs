//! Least-squares jets of eight points in lockstep, of all degrees at once.
//!
//! The surface around a point is a height over its tangent plane, and its *jet* of degree d the polynomial
//! Σ c_ab x^a y^b, a + b ≤ d, that fits the neighbours best: Frédéric Cazals, Marc Pouget, *Estimating differential
//! quantities using polynomial fitting of osculating jets*, 2005. Curvature is in its first six coefficients.
//!
//! # How all degrees come at once
//!
//! The normal matrix G holds nothing but the moments Σ w x^a y^b, a + b ≤ 2d, and with monomials in order of their degree that of a lower
//! degree is its leading block. So is its Cholesky factor L. With y = L⁻¹ b and x_k = L⁻¹ e_k, the coefficient k of *every*
//! degree is a prefix of the dot product x_k · y, its variance under unit noise a prefix of x_k · x_k, and the residual
//! Σ w z² − y · y likewise. One factorisation answers for all degrees.
//!
//! # Departures
//!
//! Cazals and Pouget solve by singular values. Coordinates here are scaled to the unit disc, where the normal equations of degree
//! six lose no more than half of f64's digits; a pivot that loses more ends the usable degrees instead
//! ([`JetFits::degrees`]). The [`reference`](mod@super::reference) solves by Householder reflections.

#[cfg(test)]
mod tests;

use fearless_simd::{Simd, f64x8, prelude::*};

use super::neighbourhood::Gatherer;

/// Points fitted in lockstep.
pub(super) const LANES: usize = 8;
/// The highest degree there is.
pub(super) const MAX_DEGREE: usize = 8;

/// Coefficients of a polynomial of a degree in two variables.
pub(super) const fn coefficients(degree: usize) -> usize {
    (degree + 1) * (degree + 2) / 2
}

const MAX_COEFFICIENTS: usize = coefficients(MAX_DEGREE);
/// Powers of one variable in the moments of the highest degree.
const POWERS: usize = 2 * MAX_DEGREE + 1;
/// A pivot below this part of its diagonal has lost its digits.
const LEAST_PIVOT: f64 = 1e-11;
/// The weight of a neighbour falls as (1 − this · squared distance)²: near a Gaussian, without its exponential.
const FALLOFF: f64 = 0.6;

/// The exponents of the monomial at a place.
const EXPONENTS: [(usize, usize); MAX_COEFFICIENTS] = {
    let mut exponents = [(0, 0); MAX_COEFFICIENTS];
    let (mut degree, mut index) = (0, 0);
    while degree <= MAX_DEGREE {
        let mut b = 0;
        while b <= degree {
            exponents[index] = (degree - b, b);
            index += 1;
            b += 1;
        }
        degree += 1;
    }
    exponents
};

/// Neighbours of eight points: `[neighbour][lane]`, coordinates scaled to the unit disc; the weight of a missing one is 0.
#[derive(Debug, Clone, Default)]
pub(super) struct Samples {
    pub(super) x: Vec<[f64; LANES]>,
    pub(super) y: Vec<[f64; LANES]>,
    pub(super) z: Vec<[f64; LANES]>,
    pub(super) weight: Vec<[f64; LANES]>,
}

impl Samples {
    /// Room for `count` neighbours in every lane, all missing.
    pub(super) fn reset(&mut self, count: usize) {
        for values in [&mut self.x, &mut self.y, &mut self.z, &mut self.weight] {
            values.clear();
            values.resize(count, [0.0; LANES]);
        }
    }

    /// Puts the neighbours that were gathered into a lane.
    pub(super) fn fill_lane(&mut self, lane: usize, gatherer: &Gatherer<'_>) {
        let [along, across] = gatherer.extent;
        let height = along.max(across);
        for (index, near) in gatherer.neighbours.iter().enumerate() {
            let falloff = 1.0 - FALLOFF * near.squared_distance;
            self.x[index][lane] = near.x / along;
            self.y[index][lane] = near.y / across;
            self.z[index][lane] = near.z / height;
            self.weight[index][lane] = falloff * falloff;
        }
    }
}

/// A jet of one degree in scaled coordinates, and how far it can be trusted.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Jet {
    /// c10, c01, c20, c11, c02.
    pub(super) coefficients: [f64; 5],
    /// Variances of c20, c11, c02 under unit noise of z.
    pub(super) variances: [f64; 3],
    /// Σ w (z − fit)².
    pub(super) residual: f64,
}

/// The jets of one point, of every degree from 2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct JetFits {
    /// The degrees that the neighbours determine: 2 … `degrees`; none if it is less than 2.
    pub(super) degrees: usize,
    /// `jets[d − 2]` is that of degree d.
    pub(super) jets: [Jet; MAX_DEGREE - 1],
    /// Σ w and Σ w² over the neighbours and the point itself.
    pub(super) weights: [f64; 2],
}

impl JetFits {
    const NONE: Self = Self {
        degrees: 0,
        jets: [Jet { coefficients: [0.0; 5], variances: [0.0; 3], residual: 0.0 }; MAX_DEGREE - 1],
        weights: [0.0; 2],
    };

    /// The jet of a degree that is there.
    pub(super) fn jet(&self, degree: usize) -> &Jet {
        &self.jets[degree - 2]
    }
}

/// Moments of eight neighbourhoods and what becomes of them.
pub(super) struct Solver<S: Simd> {
    /// Σ w x^a y^b at `[a][b]`.
    moments: [[f64x8<S>; POWERS]; POWERS],
    /// Σ w z x^a y^b at `[a][b]`.
    heights: [[f64x8<S>; MAX_DEGREE + 1]; MAX_DEGREE + 1],
    squared_heights: f64x8<S>,
    squared_weights: f64x8<S>,
    /// Row by row, the lower triangle; the diagonal holds its inverse.
    factor: [f64x8<S>; MAX_COEFFICIENTS * (MAX_COEFFICIENTS + 1) / 2],
}

impl<S: Simd> Solver<S> {
    #[inline(always)]
    pub(super) fn new(simd: S) -> Self {
        let zero = f64x8::splat(simd, 0.0);
        Self {
            moments: [[zero; POWERS]; POWERS],
            heights: [[zero; MAX_DEGREE + 1]; MAX_DEGREE + 1],
            squared_heights: zero,
            squared_weights: zero,
            factor: [zero; MAX_COEFFICIENTS * (MAX_COEFFICIENTS + 1) / 2],
        }
    }

    /// The jets of eight points, up to a degree.
    #[inline(always)]
    pub(super) fn fit<const DEGREE: usize>(&mut self, simd: S, samples: &Samples) -> [JetFits; LANES] {
        self.sum::<DEGREE>(simd, samples);
        let usable = self.factorise::<DEGREE>(simd);
        self.solve::<DEGREE>(simd, usable)
    }

    #[inline(always)]
    fn sum<const DEGREE: usize>(&mut self, simd: S, samples: &Samples) {
        let (zero, one) = (f64x8::splat(simd, 0.0), f64x8::splat(simd, 1.0));
        self.moments = [[zero; POWERS]; POWERS];
        self.heights = [[zero; MAX_DEGREE + 1]; MAX_DEGREE + 1];
        self.squared_heights = zero;
        // The point itself, at the origin, has weight 1.
        self.moments[0][0] = one;
        self.squared_weights = one;
        for index in 0..samples.x.len() {
            let load = |values: &[[f64; LANES]]| f64x8::from_slice(simd, &values[index]);
            let [x, y, z, weight] = [load(&samples.x), load(&samples.y), load(&samples.z), load(&samples.weight)];
            let weighted = weight * z;
            self.squared_heights += weighted * z;
            self.squared_weights += weight * weight;
            let (mut row, mut lifted_row) = (weight, weighted);
            for a in 0..=2 * DEGREE {
                let mut term = row;
                for b in 0..=2 * DEGREE - a {
                    self.moments[a][b] += term;
                    term *= y;
                }
                row *= x;
            }
            for a in 0..=DEGREE {
                let mut term = lifted_row;
                for b in 0..=DEGREE - a {
                    self.heights[a][b] += term;
                    term *= y;
                }
                lifted_row *= x;
            }
        }
    }

    /// The Cholesky factor, and per lane how many of its rows have kept their digits.
    #[inline(always)]
    fn factorise<const DEGREE: usize>(&mut self, simd: S) -> [usize; LANES] {
        let (one, floor) = (f64x8::splat(simd, 1.0), f64x8::splat(simd, LEAST_PIVOT));
        let mut usable = [coefficients(DEGREE); LANES];
        for row in 0..coefficients(DEGREE) {
            let (a, b) = EXPONENTS[row];
            let start = row * (row + 1) / 2;
            for column in 0..row {
                let (c, d) = EXPONENTS[column];
                let above = column * (column + 1) / 2;
                let mut sum = self.moments[a + c][b + d];
                for k in 0..column {
                    sum -= self.factor[start + k] * self.factor[above + k];
                }
                self.factor[start + column] = sum * self.factor[above + column];
            }
            let diagonal = self.moments[2 * a][2 * b];
            let mut pivot = diagonal;
            for k in 0..row {
                pivot -= self.factor[start + k] * self.factor[start + k];
            }
            let sound = pivot.simd_gt(floor * diagonal);
            let sound_lanes = sound.select(one, f64x8::splat(simd, 0.0));
            let lanes: [f64; LANES] = sound_lanes.into();
            for (lane, usable) in usable.iter_mut().enumerate() {
                if lanes[lane] == 0.0 {
                    *usable = (*usable).min(row);
                }
            }
            self.factor[start + row] = one / sound.select(pivot, one).sqrt();
        }
        usable
    }

    /// L⁻¹ of a vector whose first `first` numbers are zero.
    #[inline(always)]
    fn forward<const DEGREE: usize>(&self, vector: &mut [f64x8<S>; MAX_COEFFICIENTS], first: usize) {
        for row in first..coefficients(DEGREE) {
            let start = row * (row + 1) / 2;
            let mut sum = vector[row];
            for k in first..row {
                sum -= self.factor[start + k] * vector[k];
            }
            vector[row] = sum * self.factor[start + row];
        }
    }

    #[inline(always)]
    fn solve<const DEGREE: usize>(&self, simd: S, usable: [usize; LANES]) -> [JetFits; LANES] {
        let (zero, one) = (f64x8::splat(simd, 0.0), f64x8::splat(simd, 1.0));
        let mut fits = [JetFits::NONE; LANES];
        let weights: [[f64; LANES]; 2] = [self.moments[0][0].into(), self.squared_weights.into()];
        for (lane, fit) in fits.iter_mut().enumerate() {
            fit.weights = [weights[0][lane], weights[1][lane]];
            fit.degrees = (2..=DEGREE).rev().find(|&degree| coefficients(degree) <= usable[lane]).unwrap_or(0);
        }
        let mut right = EXPONENTS.map(|(a, b)| self.heights[a][b]);
        self.forward::<DEGREE>(&mut right, 0);
        let mut explained = zero;
        for degree in 0..=DEGREE {
            let first = if degree == 0 { 0 } else { coefficients(degree - 1) };
            for value in &right[first..coefficients(degree)] {
                explained += *value * *value;
            }
            if degree >= 2 {
                let residual: [f64; LANES] = (self.squared_heights - explained).max(zero).into();
                for (fit, residual) in fits.iter_mut().zip(residual) {
                    fit.jets[degree - 2].residual = residual;
                }
            }
        }
        for coefficient in 1..6 {
            let mut unit = [zero; MAX_COEFFICIENTS];
            unit[coefficient] = one;
            self.forward::<DEGREE>(&mut unit, coefficient);
            let (mut value, mut variance) = (zero, zero);
            for degree in 1..=DEGREE {
                for k in coefficients(degree - 1).max(coefficient)..coefficients(degree) {
                    value += unit[k] * right[k];
                    variance += unit[k] * unit[k];
                }
                if degree >= 2 {
                    let (values, variances): ([f64; LANES], [f64; LANES]) = (value.into(), variance.into());
                    for (lane, fit) in fits.iter_mut().enumerate() {
                        let jet = &mut fit.jets[degree - 2];
                        jet.coefficients[coefficient - 1] = values[lane];
                        if coefficient >= 3 {
                            jet.variances[coefficient - 3] = variances[lane];
                        }
                    }
                }
            }
        }
        fits
    }
}
