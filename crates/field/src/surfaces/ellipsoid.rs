//! Ellipsoids, and the sphere among them: u is the longitude, v the latitude from the south pole to the north pole.
//!
//! Curvatures of a sphere of radius r: 1/r both. Gaussian curvature of an ellipsoid: 1 / (a b c (x²/a⁴ + y²/b⁴ + z²/c⁴))².

use std::f64::consts::{PI, TAU};

use glam::DVec3;

use super::SurfaceJet;

pub(super) fn jet(semi_axes: DVec3, u: f64, v: f64) -> SurfaceJet {
    let (sin_u, cos_u) = (libm::sin(TAU * u), libm::cos(TAU * u));
    let (sin_v, cos_v) = (libm::sin(PI * v), libm::cos(PI * v));
    let at = |x: f64, y: f64, z: f64| semi_axes * DVec3::new(x, y, z);
    SurfaceJet {
        position: at(sin_v * cos_u, sin_v * sin_u, -cos_v),
        du: at(-sin_v * sin_u, sin_v * cos_u, 0.0) * TAU,
        dv: at(cos_v * cos_u, cos_v * sin_u, sin_v) * PI,
        duu: at(-sin_v * cos_u, -sin_v * sin_u, 0.0) * (TAU * TAU),
        duv: at(-cos_v * sin_u, cos_v * cos_u, 0.0) * (TAU * PI),
        dvv: at(-sin_v * cos_u, -sin_v * sin_u, cos_v) * (PI * PI),
    }
}
