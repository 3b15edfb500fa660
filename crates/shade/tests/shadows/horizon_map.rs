//! How a horizon map is read: between azimuths, over the seam, between texels; and that it agrees with tracing.

use barchan_field::{Edge, Grid, HeightField, Shape, Spacing};
use barchan_metrics::MaskDisagreement;
use barchan_shade::{DirectionalLight, TracedShadow};

use crate::support::{Horizons, assert_near, field, noise, surface};

/// One texel, a horizon per direction.
fn single(elevations: &[f32]) -> Horizons {
    let grid = *field((1, 1), (1.0, 1.0), Edge::Clamp, |_, _| 0.0).grid();
    Horizons::of(&grid, elevations.len() as u32, 1.0, elevations)
}

fn elevation(horizons: &Horizons, azimuth: f64) -> f64 {
    horizons.shadow(&DirectionalLight::from_degrees(azimuth, 10.0)).elevation_radians(0.0, 0.0)
}

#[test]
fn at_a_baked_azimuth_the_horizon_is_the_layer() {
    let horizons = single(&[0.1, 0.2, 0.4, -0.3]);
    for (azimuth, expected) in [(0.0, 0.1_f32), (90.0, 0.2), (180.0, 0.4), (270.0, -0.3), (360.0, 0.1), (-90.0, -0.3)] {
        assert_eq!(elevation(&horizons, azimuth), f64::from(expected), "{azimuth}°");
    }
}

#[test]
fn half_way_between_azimuths_it_is_half_way_between_layers() {
    let horizons = single(&[0.1, 0.2, 0.4, -0.3]);
    for (azimuth, expected) in [(45.0, 0.15), (135.0, 0.3), (112.5, 0.25), (225.0, 0.05)] {
        assert_near(elevation(&horizons, azimuth), expected, 1e-7);
    }
}

#[test]
fn beyond_the_last_azimuth_comes_the_first() {
    let horizons = single(&[0.1, 0.2, 0.4, -0.3]);
    assert_near(elevation(&horizons, 315.0), -0.1, 1e-7);
    assert_near(elevation(&horizons, 360.0 - 1e-9), 0.1, 1e-7);
    assert_near(elevation(&horizons, -1e-300), 0.1, 1e-7);
    // One azimuth is its own neighbour; three do not divide the turn evenly in binary.
    assert_near(elevation(&single(&[0.25]), 200.0), 0.25, 0.0);
    assert_near(elevation(&single(&[0.0, 0.3, 0.6]), 300.0), 0.3, 1e-7);
}

#[test]
fn between_texels_the_horizon_is_bilinear_and_wraps_with_the_table() {
    let of = |edge| {
        let grid = *field((2, 2), (1.0, 1.0), edge, |_, _| 0.0).grid();
        Horizons::of(&grid, 1, 1.0, &[0.0, 0.1, 0.2, 0.5]).shadow(&DirectionalLight::from_degrees(0.0, 10.0))
    };
    assert_near(of(Edge::Clamp).elevation_radians(0.5, 0.5), 0.2, 1e-7);
    assert_near(of(Edge::Clamp).elevation_radians(0.0, 0.25), 0.05, 1e-7);
    assert_near(of(Edge::Clamp).elevation_radians(-0.5, 0.0), 0.0, 1e-7);
    assert_near(of(Edge::Wrap).elevation_radians(-0.5, 0.0), 0.05, 1e-7);
    assert_near(of(Edge::Wrap).elevation_radians(3.0, 2.5), 0.3, 1e-7);
}

#[test]
fn a_wall_to_the_zenith_shades_any_sun_below_it() {
    let shadow = |degrees| {
        let horizons = single(&[barchan_asset::MAX_ELEVATION]);
        horizons.shadow(&DirectionalLight::from_degrees(0.0, degrees)).in_shadow(0.0, 0.0)
    };
    assert!(shadow(89.999) && shadow(-90.0) && !shadow(90.0));
}

#[test]
fn a_light_is_in_shadow_below_the_horizon_and_not_above() {
    for horizon in [-1.57_f32, -0.3, 0.0, 0.3, 1.2, 1.57] {
        let degrees = f64::from(horizon).to_degrees();
        let shadow = |above: f64| {
            single(&[horizon]).shadow(&DirectionalLight::from_degrees(0.0, degrees + above)).in_shadow(0.0, 0.0)
        };
        assert!(shadow(-1e-4) && !shadow(1e-4), "{degrees}°");
    }
}

/// Where the map's and the traced shadow differ, at texel centres.
fn disagreement(field: &HeightField, directions: u32, light: &DirectionalLight) -> MaskDisagreement {
    let Grid { width, height, .. } = *field.grid();
    let radius = field.grid().diagonal();
    let surface = surface(field);
    let horizon = Horizons::baked(field, directions, radius).shadow(light);
    let traced = TracedShadow::new(&surface, light, radius);
    let centres = || (0..height).flat_map(|row| (0..width).map(move |column| (f64::from(column), f64::from(row))));
    let truth: Vec<bool> = centres().map(|(x, y)| traced.in_shadow(x, y)).collect();
    let mask: Vec<bool> = centres().map(|(x, y)| horizon.in_shadow(x, y)).collect();
    assert!(truth.contains(&true) && truth.contains(&false), "a picture without an edge of shadow");
    MaskDisagreement::between(&truth, &mask)
}

#[test]
fn at_a_baked_azimuth_map_and_tracing_agree_at_texel_centres() {
    for name in ["fractal_terrain", "dunes", "reptile_skin", "pyramid"] {
        let shape = Shape::examples().into_iter().find(|shape| shape.name() == name).unwrap();
        let edge = if shape.tiles() { Edge::Wrap } else { Edge::Clamp };
        let spacing = Spacing::new(256.0 / 96.0, 256.0 / 64.0).unwrap();
        let grid = Grid { width: 96, height: 64, spacing, unit: barchan_field::LengthUnit::Metre, edge };
        let field = shape.rasterize(grid).unwrap();
        for azimuth in [0.0, 22.5, 112.5, 315.0] {
            let found = disagreement(&field, 16, &DirectionalLight::from_degrees(azimuth, 12.0));
            assert!(found.rate() <= 0.0005, "{name}, {azimuth}°: {found:?}");
        }
    }
}

#[test]
fn map_and_tracing_agree_on_white_noise_too() {
    let field = field((64, 64), (1.0, 0.6), Edge::Wrap, |column, row| noise(5, column, row));
    for azimuth in [0.0, 30.0, 210.0, 300.0] {
        let found = disagreement(&field, 12, &DirectionalLight::from_degrees(azimuth, 25.0));
        assert!(found.rate() <= 0.0005, "{azimuth}°: {found:?}");
    }
}
