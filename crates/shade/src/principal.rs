//! Normal curvature along a direction of the texture, from principal curvatures and directions: eq 1 of Koiichi Onoue,
//! Nelson Max, Tomoyuki Nishita, *Bumpmap Shadows on Curved Surfaces*, after Euler.
//!
//! # Theory
//!
//! At an angle φ to the first principal direction, κ = κ1 cos²φ + κ2 sin²φ. Principal directions are at right angles on
//! the surface, not in the texture; the paper says so itself, and yet prints cos φ = V·V1 / (|V| |V1|), which with the
//! dot product of texture coordinates is the angle in the texture. [`PrincipalUv::euler_as_printed`] is that; its error is
//! nothing on a conformal chart, and as large as κ1 − κ2 on others. [`PrincipalUv::euler_solved`] asks for the weights of the
//! two unit vectors instead, V = a V1 + b V2, and needs no root either.
//!
//! Directions have no sign, and where κ1 = κ2 no meaning: what is interpolated between the corners of a triangle depends
//! on how they were chosen. [`crate::FundamentalForms`] have neither flaw.

use glam::DVec2;

/// Principal curvatures and their directions at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PrincipalUv {
    /// κ1 ≥ κ2 in 1 / length, positive where convex.
    pub curvatures: [f64; 2],
    /// V1, V2: what unit vectors on the surface along the principal directions are in texture coordinates, per length.
    pub directions: [DVec2; 2],
}

impl PrincipalUv {
    /// Eq 1 with dot products of texture coordinates, as printed, for studies: right on conformal charts only.
    ///
    /// The mean of both curvatures where one of the three directions is null.
    #[inline]
    #[must_use]
    pub fn euler_as_printed(&self, direction: DVec2) -> f64 {
        let cos_squared = self.directions.map(|principal| {
            let cos = direction.dot(principal);
            (cos * cos, direction.length_squared() * principal.length_squared())
        });
        let [(cos, length), (sin, other)] = cos_squared;
        if length > 0.0 && other > 0.0 {
            self.curvatures[0] * (cos / length) + self.curvatures[1] * (sin / other)
        } else {
            self.mean()
        }
    }

    /// Euler's formula with the angle on the surface, by solving V = a V1 + b V2: right on any chart.
    ///
    /// The mean of both curvatures where the direction is null or V1 and V2 are parallel.
    #[inline]
    #[must_use]
    pub fn euler_solved(&self, direction: DVec2) -> f64 {
        let [first, second] = self.directions;
        // The common factor 1 / V1×V2 cancels.
        let (a, b) = (direction.perp_dot(second), first.perp_dot(direction));
        let weight = a * a + b * b;
        if weight > 0.0 && first.perp_dot(second) != 0.0 {
            (self.curvatures[0] * a * a + self.curvatures[1] * b * b) / weight
        } else {
            self.mean()
        }
    }

    /// Inside a triangle: curvatures and directions as they are, weighted by the barycentric coordinates.
    #[inline]
    #[must_use]
    pub fn interpolated(corners: [&Self; 3], weights: [f64; 3]) -> Self {
        let [a, b, c] = corners;
        let mix = |k: usize| a.directions[k] * weights[0] + b.directions[k] * weights[1] + c.directions[k] * weights[2];
        let curvature =
            |k: usize| a.curvatures[k] * weights[0] + b.curvatures[k] * weights[1] + c.curvatures[k] * weights[2];
        Self { curvatures: [curvature(0), curvature(1)], directions: [mix(0), mix(1)] }
    }

    /// The same with directions turned round that point away from those of the first corner.
    #[inline]
    #[must_use]
    pub fn interpolated_aligned(corners: [&Self; 3], weights: [f64; 3]) -> Self {
        let aligned = corners.map(|corner| {
            let align = |k: usize| {
                let direction = corner.directions[k];
                if direction.dot(corners[0].directions[k]) < 0.0 { -direction } else { direction }
            };
            Self { curvatures: corner.curvatures, directions: [align(0), align(1)] }
        });
        let [a, b, c] = &aligned;
        Self::interpolated([a, b, c], weights)
    }

    fn mean(&self) -> f64 {
        0.5 * (self.curvatures[0] + self.curvatures[1])
    }
}
