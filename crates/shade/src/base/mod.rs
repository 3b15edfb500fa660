//! Smooth surfaces that relief stands on.
//!
//! Every one is P(u, v), u and v in the unit of texture coordinates: one tile of the relief is 1 by 1. The plain ones have
//! closed forms; [`Patch`] takes any smooth P(u, v).

mod cylinder;
mod patch;
mod plane;
mod sphere;

pub use cylinder::Cylinder;
pub use patch::Patch;
pub use plane::Plane;
pub use sphere::{Sphere, SphereChart};

use glam::{DVec2, DVec3};

use crate::{FundamentalForms, TangentFrame};

/// A point of a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfacePoint {
    /// P.
    pub position: DVec3,
    /// Pu, Pv and the outward unit normal there.
    pub frame: TangentFrame,
}

/// The point of a surface that is nearest to a point in space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Foot {
    /// u and v.
    pub uv: DVec2,
    /// How far above it the point in space is, along the normal; negative inside the body. Beyond an edge, the distance.
    pub height: f64,
    /// Whether the nearest point is on the edge of the surface, and the point in space not above the surface at all.
    pub beyond_edge: bool,
}

/// A half-line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ray {
    /// Where it starts.
    pub origin: DVec3,
    /// Where it goes: a unit vector.
    pub direction: DVec3,
}

impl Ray {
    /// The point at a distance.
    #[must_use]
    pub fn at(&self, distance: f64) -> DVec3 {
        self.origin + self.direction * distance
    }
}

/// A smooth surface with a chart.
pub trait BaseSurface {
    /// The surface at (u, v).
    fn point(&self, uv: DVec2) -> SurfacePoint;

    /// First and second fundamental form at (u, v).
    fn forms(&self, uv: DVec2) -> FundamentalForms;

    /// The nearest point of the surface. With `near`, of the part of the surface around it, and of several names of one point
    /// the one next to it, so that (u, v) is continuous along a path.
    fn foot(&self, position: DVec3, near: Option<DVec2>) -> Foot;

    /// Whether a ray that starts higher above the surface than `height`, or beyond its edge, never comes as near again. `false` is
    /// always right, and costs the ray's full length.
    fn escapes(&self, ray: &Ray, height: f64) -> bool;

    /// Where a ray first meets the front of the surface.
    fn hit(&self, ray: &Ray) -> Option<DVec2>;
}

/// The distances at which a ray enters and leaves a ball round the origin; both may be behind it. Ray and ball may be in two
/// dimensions: only lengths and dot products count.
fn ball_crossings(origin_squared: f64, along: f64, direction_squared: f64, radius: f64) -> Option<(f64, f64)> {
    let inside = along * along - direction_squared * (origin_squared - radius * radius);
    (inside >= 0.0 && direction_squared > 0.0).then(|| {
        let root = inside.sqrt();
        ((-along - root) / direction_squared, (-along + root) / direction_squared)
    })
}
