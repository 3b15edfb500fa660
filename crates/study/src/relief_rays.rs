//! Rays into a relief, and what is true of each: sights at one angle from anywhere, and the pictures of the paper.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use barchan_shade::{Relief, ReliefRay, TracedRelief};
use glam::DVec3;

use crate::sample::unit;

/// A hit is missed that is passed by more than this part of the relief's thickness.
pub const TOLERANCE: f64 = 0.01;

/// Tiles around the sphere of [`sphere`]; half as many from pole to pole.
const TILES_AROUND: f64 = 12.0;

/// A ray and where it ends.
pub(crate) struct Sight {
    pub(crate) ray: ReliefRay,
    /// The depth of its first hit.
    pub(crate) hit: f64,
}

/// A place in texels from the centre of texel (0, 0), and the unit direction to the eye.
type Look = (f64, f64, DVec3);

/// Rays at one angle from the normal, in degrees, from places anywhere in the tile and from all azimuths.
pub(crate) fn anywhere(relief: &Relief<'_>, size: u32, polar_degrees: f64, count: u64) -> Vec<Sight> {
    let (side, polar) = (f64::from(size), polar_degrees.to_radians());
    let look = |index: u64| {
        let [x, y, turns] = [0, 1, 2].map(|part| unit(3 * index + part));
        (x * side - 0.5, y * side - 0.5, towards(polar, turns * TAU))
    };
    sights(relief, (0..count).map(look))
}

/// Rays at any angle from the normal up to one in degrees, all as likely, otherwise as [`anywhere`].
pub(crate) fn anywhere_within(relief: &Relief<'_>, size: u32, polar_degrees: f64, count: u64) -> Vec<Sight> {
    let (side, most) = (f64::from(size), polar_degrees.to_radians());
    let look = |index: u64| {
        let [x, y, polar, turns] = [0, 1, 2, 3].map(|part| unit(4 * index + part));
        (x * side - 0.5, y * side - 0.5, towards(polar * most, turns * TAU))
    };
    sights(relief, (0..count).map(look))
}

/// A picture of one tile of a plane, seen along one direction: so many pixels across and down.
pub(crate) fn plane(relief: &Relief<'_>, size: u32, direction: DVec3, pixels: u32) -> Vec<Sight> {
    let step = f64::from(size) / f64::from(pixels);
    let places = (0..pixels).flat_map(|row| (0..pixels).map(move |column| (column, row)));
    let look = |(column, row)| ((f64::from(column) + 0.5) * step - 0.5, (f64::from(row) + 0.5) * step - 0.5, direction);
    sights(relief, places.map(look))
}

/// A picture of a sphere with the tile all over it, seen from far before its equator: what is inside the outline. The
/// relief lies on the sphere's tangent planes, as relief mapping has it.
pub(crate) fn sphere(relief: &Relief<'_>, size: u32, pixels: u32) -> Vec<Sight> {
    let across = f64::from(pixels);
    let places = (0..pixels).flat_map(|row| (0..pixels).map(move |column| (column, row)));
    let look = |(column, row): (u32, u32)| {
        let (right, up) = ((2.0 * f64::from(column) + 1.0) / across - 1.0, 1.0 - (2.0 * f64::from(row) + 1.0) / across);
        let forward = libm::sqrt(1.0 - right * right - up * up);
        // Outside the outline the root is not a number.
        (forward > 0.0).then(|| on_sphere(DVec3::new(right, up, forward), f64::from(size)))
    };
    sights(relief, places.filter_map(look))
}

/// What is seen at a point of the unit sphere, whose poles are up and down, by an eye far along +z.
fn on_sphere(normal: DVec3, side: f64) -> Look {
    let (longitude, latitude) = (libm::atan2(normal.x, normal.z), libm::asin(normal.y));
    let (u, v) = (TILES_AROUND * longitude / TAU, 0.5 * TILES_AROUND * (latitude + FRAC_PI_2) / PI);
    let east = DVec3::new(libm::cos(longitude), 0.0, -libm::sin(longitude));
    let towards = DVec3::new(east.z, normal.cross(east).z, normal.z);
    (u.rem_euclid(1.0) * side - 0.5, (1.0 - v.rem_euclid(1.0)) * side - 0.5, towards)
}

/// The unit direction at an angle from the normal and an azimuth, in radians.
pub(crate) fn towards(polar: f64, azimuth: f64) -> DVec3 {
    let ((sin, cos), (sin_azimuth, cos_azimuth)) = (libm::sincos(polar), libm::sincos(azimuth));
    DVec3::new(sin * cos_azimuth, sin * sin_azimuth, cos)
}

fn sights(relief: &Relief<'_>, looks: impl Iterator<Item = Look>) -> Vec<Sight> {
    let oracle = TracedRelief::new(relief);
    let sight = |(x, y, towards)| {
        let ray = relief.ray(x, y, towards)?;
        let hit = oracle.first_hit(&ray, 0.0);
        Some(Sight { ray, hit })
    };
    looks.filter_map(sight).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spheres_middle_is_seen_straight_and_its_rim_from_the_side() {
        let (_, _, middle) = on_sphere(DVec3::Z, 64.0);
        assert!((middle - DVec3::Z).length() < 1e-12);
        // On the right rim the eye is to the west, on the upper rim to the south.
        let (_, _, right) = on_sphere(DVec3::new(0.8, 0.0, 0.6), 64.0);
        assert!((right - DVec3::new(-0.8, 0.0, 0.6)).length() < 1e-12, "{right}");
        let (_, _, up) = on_sphere(DVec3::new(0.0, 0.8, 0.6), 64.0);
        assert!((up - DVec3::new(0.0, -0.8, 0.6)).length() < 1e-12, "{up}");
    }

    #[test]
    fn a_direction_is_a_unit_vector_at_its_angle() {
        let direction = towards(1.0, 2.0);
        assert!((direction.length() - 1.0).abs() < 1e-12 && (direction.z - libm::cos(1.0)).abs() < 1e-12);
    }
}
