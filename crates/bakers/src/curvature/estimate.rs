//! From jets to the shape of the surface, and which jet to believe.
//!
//! A jet of a low degree is steady but bent by what it leaves out, one of a high degree follows the surface but also its noise.
//! With the shape S_d of degree d, its variance V_d under unit noise, and the noise σ² that the highest degree leaves over, the
//! expected squared error is
//!
//! > |S_d − S_top|² − σ² (V_top − V_d), not below 0, which is the square of what d leaves out, + σ² V_d,
//!
//! and the degree that makes it least is taken.

use glam::DVec3;

use super::frame::Frame;
use super::jet::{Jet, JetFits, coefficients};

/// Neighbours beyond what a jet needs, in effective number, before its residual is believed.
const LEAST_FREEDOM: f64 = 5.0;

/// The shape operator of the surface at a point, in an orthonormal basis of its tangent plane.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Shape {
    /// xx, xy, yy; positive where convex.
    pub(super) tensor: [f64; 3],
    /// The slopes of the surface over the frame's plane.
    slope: [f64; 2],
    /// Σ of the variances of the tensor's four numbers under unit noise of positions: 1 / length⁴.
    pub(super) variance: f64,
}

impl Shape {
    /// The shape that a jet describes, its coordinates in units of `extent`.
    pub(super) fn of(jet: &Jet, extent: [f64; 2], flattened: f64) -> Self {
        let [along, across] = extent;
        let height = along.max(across);
        let [c10, c01, c20, c11, c02] = jet.coefficients;
        let (p, q) = (c10 * height / along, c01 * height / across);
        let (xx, xy, yy) = (
            2.0 * c20 * height / (along * along),
            c11 * height / (along * across),
            2.0 * c02 * height / (across * across),
        );
        let [v20, v11, v02] = jet.variances;
        let variance = 4.0 * v20 / (along * along * along * along)
            + 2.0 * v11 / (along * along * across * across)
            + 4.0 * v02 / (across * across * across * across);
        let [xx, xy, yy] = shape_operator([p, q], [xx, xy, yy]);
        // What flattening took out, along the surface's own normal.
        let round = flattened / (1.0 + p * p + q * q).sqrt();
        Self { tensor: [xx + round, xy, yy + round], slope: [p, q], variance }
    }

    /// The shape of a surface that bends alike in all directions.
    pub(super) fn umbilic(curvature: f64) -> Self {
        Self { tensor: [curvature, 0.0, curvature], slope: [0.0; 2], variance: 0.0 }
    }

    /// Σ of the squares of the tensor's differences.
    pub(super) fn squared_difference(&self, other: &Self) -> f64 {
        let [xx, xy, yy] = [0, 1, 2].map(|index| self.tensor[index] - other.tensor[index]);
        xx * xx + 2.0 * xy * xy + yy * yy
    }

    /// κ1 ≥ κ2, their directions and the normal.
    pub(super) fn principal(&self, frame: &Frame) -> ([f64; 2], [DVec3; 2], DVec3) {
        let [xx, xy, yy] = self.tensor;
        let (mean, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
        let spread = (half * half + xy * xy).sqrt();
        // Of the two forms of the eigenvector, the one that does not cancel.
        let [a, b] = if half >= 0.0 { [half + spread, xy] } else { [xy, spread - half] };
        let length = (a * a + b * b).sqrt();
        let [a, b] = if length > 0.0 { [a / length, b / length] } else { [1.0, 0.0] };
        let [p, q] = self.slope;
        let basis = tangent_basis(self.slope);
        let lift = |[u, v]: [f64; 2]| frame.x * u + frame.y * v + frame.normal * (p * u + q * v);
        let [first, second] = basis.map(lift);
        let normal = (frame.normal - frame.x * p - frame.y * q).normalize();
        ([mean + spread, mean - spread], [first * a + second * b, second * a - first * b], normal)
    }
}

/// Two vectors of the frame's plane whose lifts to the surface of these slopes are orthonormal.
fn tangent_basis([p, q]: [f64; 2]) -> [[f64; 2]; 2] {
    let along = (1.0 + p * p).sqrt();
    let area = (1.0 + p * p + q * q).sqrt();
    [[1.0 / along, 0.0], [-p * q / (along * area), along / area]]
}

/// −II in that basis, of a height with these slopes and second derivatives.
fn shape_operator(slope: [f64; 2], [xx, xy, yy]: [f64; 3]) -> [f64; 3] {
    let area = (1.0 + slope[0] * slope[0] + slope[1] * slope[1]).sqrt();
    let [[a, _], [c, d]] = tangent_basis(slope);
    let second = |[u, v]: [f64; 2], [s, t]: [f64; 2]| -(xx * u * s + xy * (u * t + v * s) + yy * v * t) / area;
    [second([a, 0.0], [a, 0.0]), second([a, 0.0], [c, d]), second([c, d], [c, d])]
}

/// A shape, and how far it is believed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Estimate {
    pub(super) shape: Shape,
    /// Noise of positions, squared: what the highest degree leaves over; `None` where too few neighbours say.
    pub(super) noise: Option<f64>,
}

impl Estimate {
    /// The best degree of a fit; `None` if no degree is determined.
    pub(super) fn of(fits: &JetFits, extent: [f64; 2], flattened: f64) -> Option<Self> {
        let determined = 2..=fits.degrees;
        let Some(top) = determined.clone().rev().find(|&degree| freedom(fits, degree) >= super::knob::lf()) else {
            // As many coefficients as neighbours: nothing is left over to judge by.
            let lowest = determined.min()?;
            return Some(Self { shape: Shape::of(fits.jet(lowest), extent, flattened), noise: None });
        };
        Some(Self { shape: Shape::of(fits.jet(top), extent, flattened), noise: Some(noise(fits, top, extent)) })
    }
}

/// The effective number of neighbours beyond the coefficients of a degree.
pub(super) fn freedom(fits: &JetFits, degree: usize) -> f64 {
    let [sum, squares] = fits.weights;
    sum * sum / squares - coefficients(degree) as f64
}

/// The noise of positions, squared, that a degree leaves over.
pub(super) fn noise(fits: &JetFits, degree: usize, extent: [f64; 2]) -> f64 {
    let height = extent[0].max(extent[1]);
    let [sum, squares] = fits.weights;
    fits.jet(degree).residual / (freedom(fits, degree) * squares / sum) * height * height
}
