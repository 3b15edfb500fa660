//! Fields, directions and tables.

use barchan_asset::{Azimuths, DepthMode, HemisphereDirections, RingSpacing};
use barchan_bakers::Exec;
use barchan_bakers::hemisphere::{self, HemisphereMap, HemisphereParams};
use barchan_field::{Edge, Grid, HeightField};
use glam::DVec3;

pub(crate) use crate::fields::{fill, grid};
pub(crate) use crate::random::noise;

/// A field of square texels of length 1.
pub(crate) fn field(size: (u32, u32), edge: Edge, height: impl Fn(u32, u32) -> f32) -> HeightField {
    fill(grid(size, (1.0, 1.0), edge), height)
}

/// Rings of equal angles up to some degrees from the normal, around the whole circle.
pub(crate) fn directions(rings: u32, azimuths: u32, max_polar_degrees: f64) -> HemisphereDirections {
    HemisphereDirections {
        rings,
        azimuths: Azimuths::full_circle(azimuths),
        spacing: RingSpacing::EqualAngles,
        max_polar_radians: max_polar_degrees.to_radians(),
    }
}

/// A table as large as the field, each of its texels the ray of one of the field's.
pub(crate) fn whole(field: &HeightField, directions: HemisphereDirections) -> HemisphereParams {
    let Grid { width, height, .. } = *field.grid();
    HemisphereParams { directions, width, height, mode: DepthMode::Nearest }
}

pub(crate) fn bake(field: &HeightField, params: &HemisphereParams) -> HemisphereMap {
    hemisphere::bake(field, params, &Exec::new(1).unwrap()).unwrap()
}

/// Where the rays of a layer come from: the inner edge of its ring, the middle of its azimuth.
pub(crate) fn towards(directions: &HemisphereDirections, layer: u32) -> DVec3 {
    let (ring, azimuth) = directions.ring_and_azimuth(layer);
    let (sin, cos) = directions.azimuths.radians(azimuth).sin_cos();
    let tangent = directions.tangent_of_edge(ring);
    DVec3::new(tangent * cos, tangent * sin, 1.0).normalize()
}

#[track_caller]
pub(crate) fn assert_near(found: f32, expected: f64, tolerance: f64) {
    let off = f64::from(found) - expected;
    assert!(off.abs() <= tolerance, "{found} instead of {expected}, off by {off:e}");
}
