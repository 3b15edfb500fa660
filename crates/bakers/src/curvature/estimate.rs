//! From jets to the shape of the surface.

use glam::DVec3;

use super::frame::Frame;
use super::jet::{JetFits, MAX_DEGREE, coefficients};
use super::patch::Patch;
use super::tensor::principal;

/// Neighbours beyond its coefficients, in effective number, that a jet needs.
const LEAST_FREEDOM: f64 = 1.0;
/// The part of the curvature that an error may be before other neighbourhoods are tried.
const UNRESOLVED: f64 = 0.02;
/// The weight that a coefficient takes from the residual, tr(G⁻¹ Σ w² φ φᵀ) over the number of coefficients: weights are not inverse
/// variances, and high degrees live where weights are low. Measured on jittered points of a disc, for all degrees and counts alike; .58
/// on half a disc.
const LEVERAGE: f64 = 0.46;
/// The variance of a shape over what the inverse normal matrix says of it, for the same reason, by degree from 2; measured likewise.
const VARIANCE_SHARE: [f64; MAX_DEGREE - 1] = [0.44, 0.44, 0.60, 0.60, 0.73, 0.73, 0.78];
/// The greatest variance of a shape, under unit noise, in a neighbourhood of unit size: 1000 is usual for degree 6. Neighbours in rows and
/// columns too few for a degree give 10⁶ and more.
pub(super) const MOST_AMPLIFIED: f64 = 3e4;
/// The same at the edge of the surface, where a jet of degree 8 looks out of its neighbourhood.
pub(super) const MOST_AMPLIFIED_AT_BORDER: f64 = 1e8;
/// The same for quadrics that compete with other neighbourhoods: 6 is usual.
const WELL_AMPLIFIED: f64 = 60.0;

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
    /// The shape that the jet of a degree describes.
    pub(super) fn of(patch: &Patch, degree: usize) -> Self {
        let (jet, [along, across]) = (patch.fits.jet(degree), patch.extent);
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
        let round = patch.flattened / (1.0 + p * p + q * q).sqrt();
        let variance = variance * VARIANCE_SHARE[degree - 2];
        Self { tensor: [xx + round, xy, yy + round], slope: [p, q], variance }
    }

    /// That of degree 2, where the neighbours determine it, be it only just.
    pub(super) fn of_quadric(patch: &Patch) -> Option<Self> {
        let shape = (patch.fits.degrees >= 2).then(|| Self::of(patch, 2))?;
        (shape.variance * unit(patch) <= MOST_AMPLIFIED).then_some(shape)
    }

    /// The shape of a surface that bends alike in all directions.
    pub(super) fn umbilic(curvature: f64) -> Self {
        Self { tensor: [curvature, 0.0, curvature], slope: [0.0; 2], variance: 0.0 }
    }

    /// κ1 ≥ κ2, their directions and the normal.
    pub(super) fn principal(&self, frame: &Frame) -> ([f64; 2], [DVec3; 2], DVec3) {
        let [xx, xy, yy] = self.tensor;
        let (principal, [a, b]) = principal(xx, xy, yy);
        let [p, q] = self.slope;
        let basis = tangent_basis(self.slope);
        let lift = |[u, v]: [f64; 2]| frame.x * u + frame.y * v + frame.normal * (p * u + q * v);
        let [first, second] = basis.map(lift);
        let normal = (frame.normal - frame.x * p - frame.y * q).normalize();
        (principal, [first * a + second * b, second * a - first * b], normal)
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
    /// What is left over; `None` where too few neighbours say.
    pub(super) residue: Option<Residue>,
    /// The squared error expected of the shape if what is left over were noise: a measure of how well a surface is resolved.
    pub(super) error: f64,
}

/// The variance of positions that a jet leaves over.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Residue {
    /// By the degree that was taken.
    pub(super) fine: f64,
    /// By two degrees less. Noise is the same to both; the shape of the surface is not.
    pub(super) coarse: f64,
}

impl Estimate {
    /// The highest degree that the neighbours support within an amplification; else the lowest that they support at all, if any.
    pub(super) fn of(patch: &Patch, most_amplified: f64) -> Option<Self> {
        let scale = unit(patch);
        let within = |degree: usize, most: f64| Shape::of(patch, degree).variance * scale <= most;
        let free = |degree: usize| degree == 2 || freedom(&patch.fits, degree) >= LEAST_FREEDOM;
        let mut degrees = 2..=patch.fits.degrees;
        let highest = degrees.clone().rev().find(|&degree| free(degree) && within(degree, most_amplified));
        let degree = highest.or_else(|| degrees.find(|&degree| within(degree, MOST_AMPLIFIED_AT_BORDER)))?;
        let told = degree >= 4 && freedom(&patch.fits, degree) >= LEAST_FREEDOM;
        let residue =
            told.then(|| Residue { fine: variance_left(patch, degree), coarse: variance_left(patch, degree - 2) });
        Some(Self { shape: Shape::of(patch, degree), residue, error: error(patch, degree) })
    }

    /// The estimate of a lower degree, where its neighbours determine it with some to spare.
    pub(super) fn of_degree(patch: &Patch, degree: usize) -> Option<Self> {
        if degree > patch.fits.degrees || freedom(&patch.fits, degree) < LEAST_FREEDOM {
            return None;
        }
        let most_amplified = if degree == 2 { WELL_AMPLIFIED } else { MOST_AMPLIFIED };
        let shape = Shape::of(patch, degree);
        (shape.variance * unit(patch) <= most_amplified).then(|| Self {
            shape,
            residue: None,
            error: error(patch, degree),
        })
    }

    /// Whether the error expected is no more than a small part of the curvature.
    pub(super) fn is_resolved(&self) -> bool {
        let [xx, xy, yy] = self.shape.tensor;
        self.error <= UNRESOLVED * UNRESOLVED * (xx * xx + 2.0 * xy * xy + yy * yy)
    }
}

/// The squared error of a shape if what is left over were noise; what few spare neighbours leave over is believed less.
fn error(patch: &Patch, degree: usize) -> f64 {
    let spare = freedom(&patch.fits, degree).max(LEAST_FREEDOM);
    Shape::of(patch, degree).variance * variance_left(patch, degree) * (1.0 + 2.0 / spare)
}

/// What makes a variance that of a neighbourhood of unit size.
fn unit(patch: &Patch) -> f64 {
    let [along, across] = patch.extent;
    along * along * across * across
}

/// The effective number of neighbours beyond the coefficients of a degree.
fn freedom(fits: &JetFits, degree: usize) -> f64 {
    let [sum, squares] = fits.weights;
    sum * sum / squares - coefficients(degree) as f64
}

/// The variance of positions that a degree leaves over.
fn variance_left(patch: &Patch, degree: usize) -> f64 {
    let [sum, _] = patch.fits.weights;
    let height = patch.extent[0].max(patch.extent[1]);
    patch.fits.jet(degree).residual / (sum - LEVERAGE * coefficients(degree) as f64) * height * height
}
