//! Ranges of the surfaces' parameters.

use glam::DVec3;

use super::{ParametricSurface, bezier};
use crate::FieldError;
use crate::shapes::check::Check;

pub(super) fn check(surface: &ParametricSurface) -> Result<(), FieldError> {
    use ParametricSurface as S;
    let check = Check(surface.name());
    let lengths = |named: &[(&'static str, f64)]| {
        named
            .iter()
            .try_for_each(|&(name, value)| check.within(name, value, 1e-9..=1e9, "a positive length from 1e-9 to 1e9"))
    };
    match *surface {
        S::Sphere { radius } => lengths(&[("radius", radius)]),
        S::Ellipsoid { a, b, c } => lengths(&[("a", a), ("b", b), ("c", c)]),
        S::Torus { major, minor } => {
            lengths(&[("major", major), ("minor", minor)])?;
            ensure(minor < major, || check.refusal("minor", minor, "a radius smaller than the major one"))
        }
        S::Cylinder { radius, height } => lengths(&[("radius", radius), ("height", height)]),
        S::Cone { base_radius, top_radius, height } => {
            lengths(&[("base_radius", base_radius), ("top_radius", top_radius), ("height", height)])
        }
        S::Saddle { valley_radius, ridge_radius, size } => {
            lengths(&[("valley_radius", valley_radius), ("ridge_radius", ridge_radius), ("size", size)])
        }
        S::MonkeySaddle { scale, size } => lengths(&[("scale", scale), ("size", size)]),
        S::Helicoid { inner_radius, outer_radius, pitch, turns } => {
            lengths(&[("outer_radius", outer_radius), ("pitch", pitch)])?;
            check.within("turns", turns, 0.01..=100.0, "a number of turns from 0.01 to 100")?;
            ensure((0.0..outer_radius).contains(&inner_radius), || {
                check.refusal("inner_radius", inner_radius, "a radius of 0 or more, smaller than the outer one")
            })
        }
        S::WavySheet { amplitude, wavelength, size } => {
            lengths(&[("amplitude", amplitude), ("wavelength", wavelength), ("size", size)])?;
            ensure(size / wavelength <= 64.0, || {
                check.refusal("wavelength", wavelength, "a wavelength of at least a 64th of the size")
            })
        }
        S::BezierPatch { ref control } => patch(control, &check),
    }
}

/// Coordinates in range, and a tangent plane at each of a grid of parameters.
fn patch(control: &[[DVec3; 4]; 4], check: &Check) -> Result<(), FieldError> {
    let mut coordinates = control.iter().flatten().flat_map(|point| point.to_array());
    if let Some(value) = coordinates.find(|value| !(-1e9..=1e9).contains(value)) {
        return Err(check.refusal("control", value, "a coordinate from -1e9 to 1e9"));
    }
    for i in 0..=16 {
        for j in 0..=16 {
            let jet = bezier::jet(control, f64::from(i) / 16.0, f64::from(j) / 16.0);
            let sine = jet.area_density() / (jet.du.length() * jet.dv.length());
            // A NaN, where a derivative vanishes, is refused as well.
            ensure(sine >= 1e-6, || {
                check.refusal("the sine between ∂u and ∂v", sine, "a patch with a tangent plane everywhere")
            })?;
        }
    }
    Ok(())
}

fn ensure(holds: bool, refusal: impl FnOnce() -> FieldError) -> Result<(), FieldError> {
    if holds { Ok(()) } else { Err(refusal()) }
}
