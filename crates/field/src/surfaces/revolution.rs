//! Surfaces of revolution about the z axis: torus, cylinder, cone. u is the angle about the axis, v runs along the profile.
//!
//! Curvatures, first along the profile, then around. Torus: 1 / minor and cos t / (major + minor cos t), t the angle of the
//! profile from the equator. Cylinder: 0 and 1 / radius. Cone: 0 and sin a / ρ at distance ρ from the axis, where a is the angle
//! between the axis and the normal, so that sin a = 1 / √(1 + slope²) for a radius that changes with `slope` along the axis.

use std::f64::consts::TAU;

use glam::{DVec2, DVec3};

use super::SurfaceJet;

/// A profile (distance from the axis, z) with its first and second derivative along v.
type Profile = [DVec2; 3];

pub(super) fn torus(major: f64, minor: f64, u: f64, v: f64) -> SurfaceJet {
    let (sin, cos) = (libm::sin(TAU * v), libm::cos(TAU * v));
    let outwards = DVec2::new(cos, sin) * minor;
    let profile = [DVec2::new(major, 0.0) + outwards, DVec2::new(-sin, cos) * (minor * TAU), outwards * -(TAU * TAU)];
    revolved(profile, u)
}

/// Straight from one radius at z = 0 to another at z = `height`: a cylinder where they agree.
pub(super) fn frustum(base: f64, top: f64, height: f64, u: f64, v: f64) -> SurfaceJet {
    let along = DVec2::new(top - base, height);
    revolved([DVec2::new(base, 0.0) + along * v, along, DVec2::ZERO], u)
}

fn revolved(profile: Profile, u: f64) -> SurfaceJet {
    let (sin, cos) = (libm::sin(TAU * u), libm::cos(TAU * u));
    let turned = |p: DVec2| DVec3::new(p.x * cos, p.x * sin, p.y);
    let across = |p: DVec2| DVec3::new(-p.x * sin, p.x * cos, 0.0) * TAU;
    let [point, first, second] = profile;
    SurfaceJet {
        position: turned(point),
        du: across(point),
        dv: turned(first),
        duu: DVec3::new(-point.x * cos, -point.x * sin, 0.0) * (TAU * TAU),
        duv: across(first),
        dvv: turned(second),
    }
}
