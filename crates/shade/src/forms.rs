//! Normal curvature along a direction of the texture, from the fundamental forms of the surface.
//!
//! # Theory
//!
//! Along (du, dv) a surface P(u, v) with unit normal N has the normal curvature
//!
//! > κ = (e du² + 2f du dv + g dv²) / (E du² + 2F du dv + G dv²),
//!
//! E, F, G = Pu·Pu, Pu·Pv, Pv·Pv the first fundamental form and e, f, g = Pu·Nu, Pu·Nv, Pv·Nv the second, with the
//! sign that makes a ball convex and κ positive. No square root, no angle, and no principal direction, which at an
//! umbilic does not exist.
//!
//! # Departures
//!
//! Koiichi Onoue, Nelson Max, Tomoyuki Nishita, *Bumpmap Shadows on Curved Surfaces*, take κ1, κ2 and their
//! directions through Euler's formula, eq 1: [`crate::PrincipalUv`]. It is the same number where directions are known
//! and solved for as they must be, and something else as printed. Between vertices, the six numbers here are
//! interpolated by themselves; directions are not, as their signs are arbitrary.
//!
//! # Conventions
//!
//! u, v in any unit, E, F, G in length² and e, f, g in length over the squares of it. N is the normal of the
//! geometry: mirrored texture coordinates leave all six numbers as they are.

/// The first and second fundamental form of a surface at a point, in the chart of its texture coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FundamentalForms {
    /// E, F, G: length² per unit of texture coordinate squared.
    pub first: [f64; 3],
    /// e, f, g: length per unit of texture coordinate squared, positive where convex.
    pub second: [f64; 3],
}

impl FundamentalForms {
    /// The normal curvature along a direction of the texture, in 1 / length; the direction's own length does not matter.
    ///
    /// Where the direction has no length on the surface it is the mean curvature.
    #[inline]
    #[must_use]
    pub fn along(&self, du: f64, dv: f64) -> f64 {
        let length_squared = quadratic(self.first, du, dv);
        if length_squared > 0.0 { quadratic(self.second, du, dv) / length_squared } else { self.mean() }
    }

    /// The mean curvature, half the sum of the principal ones, in 1 / length; 0 where the chart has no area.
    #[inline]
    #[must_use]
    pub fn mean(&self) -> f64 {
        let ([e1, f1, g1], [e2, f2, g2]) = (self.first, self.second);
        let area_squared = e1 * g1 - f1 * f1;
        if area_squared > 0.0 { (e2 * g1 - 2.0 * f2 * f1 + g2 * e1) / (2.0 * area_squared) } else { 0.0 }
    }

    /// The length on the surface of a step in the texture.
    #[must_use]
    pub fn length(&self, du: f64, dv: f64) -> f64 {
        quadratic(self.first, du, dv).max(0.0).sqrt()
    }

    /// Inside a triangle: each of the six numbers by itself, weighted by the barycentric coordinates.
    #[inline]
    #[must_use]
    pub fn interpolated(corners: [&Self; 3], weights: [f64; 3]) -> Self {
        let [a, b, c] = corners;
        let mix = |a: [f64; 3], b: [f64; 3], c: [f64; 3]| {
            std::array::from_fn(|k| a[k] * weights[0] + b[k] * weights[1] + c[k] * weights[2])
        };
        Self { first: mix(a.first, b.first, c.first), second: mix(a.second, b.second, c.second) }
    }
}

#[inline]
fn quadratic([uu, uv, vv]: [f64; 3], du: f64, dv: f64) -> f64 {
    uu * du * du + 2.0 * uv * du * dv + vv * dv * dv
}
