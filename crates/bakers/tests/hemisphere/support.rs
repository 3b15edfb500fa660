//! Fields, directions and tables.

use barchan_asset::{Azimuths, DepthMode, HemisphereDirections, RingSpacing};
use barchan_bakers::Exec;
use barchan_bakers::hemisphere::{self, HemisphereMap, HemisphereParams};
use barchan_field::{Edge, Grid, HeightField, LengthUnit, Spacing};
use glam::DVec3;

pub(crate) fn grid((width, height): (u32, u32), (spacing_u, spacing_v): (f64, f64), edge: Edge) -> Grid {
    let spacing = Spacing::new(spacing_u, spacing_v).unwrap();
    Grid { width, height, spacing, unit: LengthUnit::SceneUnit, edge }
}

/// `height` is asked for each column and row.
pub(crate) fn fill(grid: Grid, height: impl Fn(u32, u32) -> f32) -> HeightField {
    let height = &height;
    let samples = (0..grid.height).flat_map(|row| (0..grid.width).map(move |column| height(column, row))).collect();
    HeightField::new(grid, samples).unwrap()
}

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

/// Reproducible noise in [0, 1) for a texel.
pub(crate) fn noise(seed: u32, column: u32, row: u32) -> f32 {
    let mut hash = seed.wrapping_mul(0x9E37_79B9) ^ column.wrapping_mul(0x85EB_CA6B) ^ row.wrapping_mul(0xC2B2_AE35);
    for _ in 0..2 {
        hash = (hash ^ (hash >> 15)).wrapping_mul(0x2C1B_3C6D);
        hash = (hash ^ (hash >> 12)).wrapping_mul(0x297A_2D39);
    }
    (hash >> 8) as f32 / (1 << 24) as f32
}
