//! The traced shadow against marching in small steps, on small rough fields.

use barchan_field::{Edge, HeightField};
use barchan_shade::{DirectionalLight, TracedShadow};
use proptest::prelude::*;

use crate::support::{field, surface};

/// A field, a light's azimuth and elevation in degrees, a place in texels, a radius.
fn scenes() -> impl Strategy<Value = (HeightField, (f64, f64), (f64, f64), f64)> {
    let edges = prop_oneof![Just(Edge::Wrap), Just(Edge::Clamp)];
    let azimuths = prop_oneof![0.0..360.0_f64, (0_u8..8).prop_map(|k| 45.0 * f64::from(k))];
    let heights = prop::collection::vec(-2.0_f32..2.0, 30);
    let sizes = prop_oneof![Just((6, 5)), Just((5, 6)), Just((30, 1)), Just((1, 30))];
    (sizes, (0.4..2.0, 0.4..2.0), edges, heights, (azimuths, -30.0..80.0_f64), (-2.0..8.0, -2.0..8.0), 0.2..25.0)
        .prop_map(|((width, height), spacing, edge, heights, light, place, radius)| {
            let at = |column: u32, row: u32| heights[(row * width + column) as usize];
            (field((width, height), spacing, edge, at), light, place, radius)
        })
}

/// How far the surface rises above the ray at most, at points of the ray beyond the place itself.
fn clearance(field: &HeightField, (azimuth, elevation): (f64, f64), (x, y): (f64, f64), radius: f64) -> f64 {
    const STEPS: u32 = 20_000;
    let (sin, cos) = azimuth.to_radians().sin_cos();
    let (spacing, climb) = (field.grid().spacing, elevation.to_radians().tan());
    let eye = field.surface(x, y);
    let above = |s: f64| field.surface(x + s * cos / spacing.u(), y - s * sin / spacing.v()) - eye - s * climb;
    (1..=STEPS).map(|k| above(radius * f64::from(k) / f64::from(STEPS))).fold(f64::NEG_INFINITY, f64::max)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    #[test]
    fn a_ray_is_blocked_where_marching_finds_it_blocked((field, light, place, radius) in scenes()) {
        let surface = surface(&field);
        let towards = DirectionalLight::from_degrees(light.0, light.1);
        let found = TracedShadow::new(&surface, &towards, radius).in_shadow(place.0, place.1);
        let above = clearance(&field, light, place, radius);
        // Between steps the surface can rise by what its steepest cell rises in one.
        let unseen = 1e-9 + radius / 20_000.0 * 20.0;
        prop_assert!(!found || above > -unseen, "shadow, though every step is {above} clear");
        prop_assert!(found || above <= 1e-9, "light, though a step is {above} inside the ground");
    }
}

#[test]
fn the_walk_ends_for_rays_along_texel_borders() {
    let field = field((9, 9), (1.0, 1.0), Edge::Wrap, |column, row| ((column * 5 + row * 3) % 7) as f32 * 0.1);
    let surface = surface(&field);
    for azimuth in 0..24 {
        let light = DirectionalLight::from_degrees(15.0 * f64::from(azimuth), 1.0);
        let traced = TracedShadow::new(&surface, &light, 500.0);
        for place in [(0.0, 0.0), (0.5, 3.0), (1e6, -1e6), (4.0, 1e-13)] {
            let found = traced.in_shadow(place.0, place.1);
            let above = clearance(&field, (light.azimuth_radians.to_degrees(), 1.0), place, 500.0);
            assert!(found == (above > 0.0) || above.abs() < 0.2, "{azimuth} {place:?} {above}");
        }
    }
}
