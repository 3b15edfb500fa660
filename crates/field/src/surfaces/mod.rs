//! Closed-form curved surfaces: their exact differential geometry, and triangle meshes of them.
//!
//! They are the truth that curvature of meshes is measured against, and the base surfaces of curved bump shading.
//!
//! # Conventions
//!
//! A surface is a map from the parameters (u, v), each from 0 to 1, into space; [`ParametricSurface::jet`] gives the point and its
//! derivatives at any of them. The front is the side that ∂u × ∂v points to: outwards on closed surfaces, cylinder and cone,
//! upwards on the others. Curvature is positive where the surface is convex seen from its front, in 1 / length unit.
//!
//! # Ends of the parameters
//!
//! At both ends of u, and of v, a surface has a border, or meets itself ([`ParametricSurface::is_closed_u`],
//! [`is_closed_v`](ParametricSurface::is_closed_v)), or shrinks to a point: the poles of sphere and ellipsoid lie at v = 0 and 1, where
//! ∂u vanishes and a jet has no curvature.
//!
//! # In recipes
//!
//! A surface reads `Torus(major: 2.0, minor: 0.5)`. Unknown fields are refused.

mod bezier;
mod ellipsoid;
mod graph;
mod helicoid;
mod jet;
mod random;
mod revolution;
mod tessellate;
#[cfg(test)]
mod tests;
mod validate;
mod vertex_noise;

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::FieldError;

pub use jet::{FundamentalForms, PrincipalCurvature, SurfaceJet};
pub use tessellate::{Pattern, TessellatedSurface, Tessellation};
pub use vertex_noise::with_vertex_noise;

/// A closed-form curved surface. Lengths, 1e-9 to 1e9, are in one unit of the reader's choice.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[expect(clippy::large_enum_variant, reason = "there are never many surfaces, and being copied easily is worth more")]
pub enum ParametricSurface {
    /// A sphere about the origin. u is the longitude, v the latitude from the south pole (−z) to the north pole.
    Sphere {
        /// Its radius.
        radius: f64,
    },
    /// An ellipsoid about the origin, with parameters as on the sphere.
    Ellipsoid {
        /// Semi-axis along x.
        a: f64,
        /// Semi-axis along y.
        b: f64,
        /// Semi-axis along z.
        c: f64,
    },
    /// A torus about the z axis. u is the angle about the axis, v that of the profile, from the outer equator upwards.
    Torus {
        /// Radius of the circle in the middle of the tube.
        major: f64,
        /// Radius of the tube; smaller than `major`.
        minor: f64,
    },
    /// The side of a cylinder about the z axis from z = 0. u is the angle, v runs upwards.
    Cylinder {
        /// Its radius.
        radius: f64,
        /// Its length along z.
        height: f64,
    },
    /// The side of a truncated cone about the z axis from z = 0. u is the angle, v runs upwards.
    Cone {
        /// Radius at z = 0.
        base_radius: f64,
        /// Radius at z = `height`; either may be the larger.
        top_radius: f64,
        /// Its length along z.
        height: f64,
    },
    /// A hyperbolic paraboloid over a square, z = (x² / `valley_radius` − y² / `ridge_radius`) / 2.
    Saddle {
        /// Radius of the valley along x, at the origin: κ2 = −1 / `valley_radius` there.
        valley_radius: f64,
        /// Radius of the ridge along y, at the origin: κ1 = 1 / `ridge_radius` there.
        ridge_radius: f64,
        /// Side of the square in x and y about the origin.
        size: f64,
    },
    /// A monkey saddle over a square, z = (x³ − 3 x y²) / `scale`²: flat to second order at the origin.
    MonkeySaddle {
        /// The larger, the flatter.
        scale: f64,
        /// Side of the square in x and y about the origin.
        size: f64,
    },
    /// A right-handed helicoid about the z axis, front upwards: u runs down the turns, v outwards. A minimal surface.
    Helicoid {
        /// Distance of its inner border from the axis; 0 to have the axis for a border.
        inner_radius: f64,
        /// Distance of its outer border; larger than `inner_radius`.
        outer_radius: f64,
        /// Rise per turn.
        pitch: f64,
        /// Turns in all, 0.01 to 100; need not be whole.
        turns: f64,
    },
    /// Egg-box waves over a square, z = `amplitude` sin(2π x / `wavelength`) sin(2π y / `wavelength`).
    WavySheet {
        /// Highest height above the middle.
        amplitude: f64,
        /// Period along x and along y; at most 64 of them across the square.
        wavelength: f64,
        /// Side of the square in x and y about the origin.
        size: f64,
    },
    /// A bicubic Bézier patch, with a tangent plane everywhere.
    BezierPatch {
        /// `control[i][j]` belongs to Bernstein polynomial i of u and j of v; coordinates within ±1e9.
        control: [[DVec3; 4]; 4],
    },
}

impl ParametricSurface {
    /// The name of every surface, in the order of [`ParametricSurface::examples`].
    pub const ALL_NAMES: [&'static str; 10] = [
        "sphere",
        "ellipsoid",
        "torus",
        "cylinder",
        "cone",
        "saddle",
        "monkey_saddle",
        "helicoid",
        "wavy_sheet",
        "bezier_patch",
    ];

    /// One sensible instance of each surface, a few length units across.
    #[must_use]
    pub fn examples() -> Vec<Self> {
        // A sheared, unevenly bent patch, so that nothing about its parameters is special.
        let rise = [[0.0, 0.3, 0.5, 0.1], [0.4, 1.2, 0.9, 0.2], [0.2, 0.8, 1.0, 0.6], [-0.1, 0.3, 0.5, 0.2]];
        let control = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let (x, y) = (i as f64 * 0.8, j as f64 * 0.7);
                DVec3::new(x + 0.3 * y, y + 0.02 * x * x, rise[i][j])
            })
        });
        vec![
            Self::Sphere { radius: 1.0 },
            Self::Ellipsoid { a: 1.0, b: 0.8, c: 0.6 },
            Self::Torus { major: 1.0, minor: 0.4 },
            Self::Cylinder { radius: 0.5, height: 2.0 },
            Self::Cone { base_radius: 1.0, top_radius: 0.4, height: 1.2 },
            Self::Saddle { valley_radius: 1.0, ridge_radius: 1.5, size: 2.0 },
            Self::MonkeySaddle { scale: 2.0, size: 2.0 },
            Self::Helicoid { inner_radius: 0.0, outer_radius: 1.0, pitch: 3.0, turns: 1.0 },
            Self::WavySheet { amplitude: 0.1, wavelength: 1.0, size: 2.0 },
            Self::BezierPatch { control },
        ]
    }

    /// The surface's name: lower case, words joined by `_`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Sphere { .. } => "sphere",
            Self::Ellipsoid { .. } => "ellipsoid",
            Self::Torus { .. } => "torus",
            Self::Cylinder { .. } => "cylinder",
            Self::Cone { .. } => "cone",
            Self::Saddle { .. } => "saddle",
            Self::MonkeySaddle { .. } => "monkey_saddle",
            Self::Helicoid { .. } => "helicoid",
            Self::WavySheet { .. } => "wavy_sheet",
            Self::BezierPatch { .. } => "bezier_patch",
        }
    }

    /// Refuses parameters that are not finite or out of range.
    ///
    /// # Errors
    /// The first such parameter, its value, and what would be accepted.
    pub fn validate(&self) -> Result<(), FieldError> {
        validate::check(self)
    }

    /// The point at parameters `u` and `v`, 0 to 1 each, and its derivatives. Parameters of the surface that
    /// [`ParametricSurface::validate`] refuses give meaningless numbers.
    #[must_use]
    pub fn jet(&self, u: f64, v: f64) -> SurfaceJet {
        match *self {
            Self::Sphere { radius } => ellipsoid::jet(DVec3::splat(radius), u, v),
            Self::Ellipsoid { a, b, c } => ellipsoid::jet(DVec3::new(a, b, c), u, v),
            Self::Torus { major, minor } => revolution::torus(major, minor, u, v),
            Self::Cylinder { radius, height } => revolution::frustum(radius, radius, height, u, v),
            Self::Cone { base_radius, top_radius, height } => {
                revolution::frustum(base_radius, top_radius, height, u, v)
            }
            Self::Saddle { valley_radius, ridge_radius, size } => {
                graph::saddle(valley_radius, ridge_radius, size, u, v)
            }
            Self::MonkeySaddle { scale, size } => graph::monkey_saddle(scale, size, u, v),
            Self::Helicoid { inner_radius, outer_radius, pitch, turns } => {
                helicoid::jet([inner_radius, outer_radius], pitch, turns, u, v)
            }
            Self::WavySheet { amplitude, wavelength, size } => graph::wavy_sheet(amplitude, wavelength, size, u, v),
            Self::BezierPatch { ref control } => bezier::jet(control, u, v),
        }
    }

    /// Does u = 1 continue at u = 0?
    #[must_use]
    pub fn is_closed_u(&self) -> bool {
        self.has_poles() || matches!(self, Self::Torus { .. } | Self::Cylinder { .. } | Self::Cone { .. })
    }

    /// Does v = 1 continue at v = 0?
    #[must_use]
    pub fn is_closed_v(&self) -> bool {
        matches!(self, Self::Torus { .. })
    }

    /// Is each end of v a single point?
    #[must_use]
    pub fn has_poles(&self) -> bool {
        matches!(self, Self::Sphere { .. } | Self::Ellipsoid { .. })
    }
}
