//! What a surface is to second order at a point, and the curvature in it.
//!
//! Theory: do Carmo, *Differential Geometry of Curves and Surfaces*, §2.5 and §3.3. Departure: the second fundamental form has the
//! other sign, so that curvature is positive where the surface is convex seen from its front.

use glam::DVec3;

/// Position and derivatives of a surface at a parameter (u, v). Lengths are in the surface's length unit, per whole range of
/// u and v.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceJet {
    /// The point.
    pub position: DVec3,
    /// ∂/∂u.
    pub du: DVec3,
    /// ∂/∂v.
    pub dv: DVec3,
    /// ∂²/∂u².
    pub duu: DVec3,
    /// ∂²/∂u∂v.
    pub duv: DVec3,
    /// ∂²/∂v².
    pub dvv: DVec3,
}

/// The fundamental forms of a surface at a point, in its parameters (u, v).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FundamentalForms {
    /// E, F, G: products of the first derivatives.
    pub first: [f64; 3],
    /// e, f, g, positive where the surface is convex seen from its front: the normal curvature along (du, dv) is
    /// (e du² + 2f du dv + g dv²) / (E du² + 2F du dv + G dv²).
    pub second: [f64; 3],
}

/// The principal curvatures of a surface at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PrincipalCurvature {
    /// κ1 ≥ κ2 in 1 / length unit, positive where the surface is convex seen from its front.
    pub principal: [f64; 2],
    /// Unit tangents along which they are found. Their sign means nothing; where the two curvatures agree, neither do they.
    pub directions: [DVec3; 2],
}

impl SurfaceJet {
    /// The area that a unit of (u, v) covers: |∂u × ∂v|.
    #[must_use]
    pub fn area_density(&self) -> f64 {
        self.du.cross(self.dv).length()
    }

    /// The unit normal towards the front: along ∂u × ∂v. Not finite where the two are parallel.
    #[must_use]
    pub fn normal(&self) -> DVec3 {
        let normal = self.du.cross(self.dv);
        normal / normal.length()
    }

    /// The fundamental forms in (u, v).
    #[must_use]
    pub fn forms(&self) -> FundamentalForms {
        let Self { du, dv, duu, duv, dvv, .. } = *self;
        let inwards = -self.normal();
        FundamentalForms {
            first: [du.dot(du), du.dot(dv), dv.dot(dv)],
            second: [duu.dot(inwards), duv.dot(inwards), dvv.dot(inwards)],
        }
    }

    /// The principal curvatures and their directions. Not finite where ∂u and ∂v are parallel.
    #[must_use]
    pub fn curvature(&self) -> PrincipalCurvature {
        let (normal, [e, f, g]) = (self.normal(), self.forms().second);
        // An orthonormal tangent frame, in which ∂u = a x and ∂v = b x + c y.
        let a = self.du.length();
        let x = self.du / a;
        let y = normal.cross(x);
        let (b, c) = (self.dv.dot(x), self.dv.dot(y));
        let shear = b / a;
        let along_x = e / (a * a);
        let mixed = (f - shear * e) / (a * c);
        let along_y = (g - 2.0 * shear * f + shear * shear * e) / (c * c);

        let (mean, half_difference) = (0.5 * (along_x + along_y), 0.5 * (along_x - along_y));
        let radius = libm::hypot(half_difference, mixed);
        let angle = 0.5 * libm::atan2(mixed, half_difference);
        let first = x * libm::cos(angle) + y * libm::sin(angle);
        PrincipalCurvature { principal: [mean + radius, mean - radius], directions: [first, normal.cross(first)] }
    }
}
