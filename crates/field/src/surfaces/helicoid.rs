//! A helicoid about the z axis: the ramp of a spiral stair, right-handed, front upwards. u runs down the turns, v along the straight
//! lines outwards.
//!
//! Minimal: κ1 = −κ2 = c / (ρ² + c²) at distance ρ from the axis, where c = `pitch` / 2π.

use std::f64::consts::TAU;

use glam::DVec3;

use super::SurfaceJet;

pub(super) fn jet([inner, outer]: [f64; 2], pitch: f64, turns: f64, u: f64, v: f64) -> SurfaceJet {
    let rate = -TAU * turns;
    let angle = rate * (u - 1.0);
    let outwards = DVec3::new(libm::cos(angle), libm::sin(angle), 0.0);
    let across = DVec3::new(-outwards.y, outwards.x, 0.0);
    let width = outer - inner;
    let radius = inner + width * v;
    SurfaceJet {
        position: outwards * radius + DVec3::Z * (pitch * turns * (1.0 - u)),
        du: across * (radius * rate) - DVec3::Z * (pitch * turns),
        dv: outwards * width,
        duu: outwards * (-radius * rate * rate),
        duv: across * (width * rate),
        dvv: DVec3::ZERO,
    }
}
