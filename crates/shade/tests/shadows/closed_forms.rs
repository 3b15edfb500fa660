//! Shadows whose outline can be written down, by the horizon map and by the traced ray.

use barchan_field::{Edge, HeightField};
use barchan_shade::{DirectionalLight, TracedShadow};

use crate::support::{Horizons, field, noise, surface};

const RADIUS: f64 = 200.0;

/// What both techniques say at each of a list of places.
fn shadows(field: &HeightField, light: &DirectionalLight, places: &[(f64, f64)]) -> [Vec<bool>; 2] {
    let surface = surface(field);
    let horizon = Horizons::baked(field, 16, RADIUS).shadow(light);
    let traced = TracedShadow::new(&surface, light, RADIUS);
    [
        places.iter().map(|&(x, y)| horizon.in_shadow(x, y)).collect(),
        places.iter().map(|&(x, y)| traced.in_shadow(x, y)).collect(),
    ]
}

/// 8 m of wall from column 60 on; its top begins at that texel's centre. Texels are half a metre wide.
fn wall() -> HeightField {
    field((80, 5), (0.5, 1.0), Edge::Clamp, |column, _| if column < 60 { 0.0 } else { 8.0 })
}

#[test]
fn the_shadow_of_a_wall_is_its_height_over_the_tangent_of_the_sun() {
    for elevation in [18.0_f64, 26.0, 44.0, 71.0] {
        let columns = 8.0 / elevation.to_radians().tan() / 0.5;
        let edge = 60.0 - columns;
        let texels: Vec<(f64, f64)> = (0..59).map(|column| (f64::from(column), 2.0)).collect();
        let expected: Vec<bool> = texels.iter().map(|&(x, _)| x > edge).collect();
        for found in shadows(&wall(), &DirectionalLight::from_degrees(0.0, elevation), &texels) {
            assert_eq!(found, expected, "elevation {elevation}°, shadow from column {edge}");
        }
    }
}

#[test]
fn a_traced_shadow_ends_where_the_wall_says_between_texels_too() {
    let (field, elevation) = (wall(), 30.0_f64);
    let surface = surface(&field);
    let edge = 60.0 - 8.0 / elevation.to_radians().tan() / 0.5;
    let traced = TracedShadow::new(&surface, &DirectionalLight::from_degrees(0.0, elevation), RADIUS);
    assert!(traced.in_shadow(edge + 1e-6, 1.3) && !traced.in_shadow(edge - 1e-6, 1.3));
}

#[test]
fn a_sun_that_stands_behind_leaves_the_wall_lit() {
    let texels: Vec<(f64, f64)> = (0..80).map(|column| (f64::from(column), 2.0)).collect();
    for found in shadows(&wall(), &DirectionalLight::from_degrees(180.0, 20.0), &texels) {
        assert!(found.iter().all(|&shadow| !shadow));
    }
}

#[test]
fn azimuth_90_degrees_is_a_sun_beyond_the_top_of_the_picture() {
    let wall_at_the_top = field((5, 40), (1.0, 1.0), Edge::Clamp, |_, row| if row < 10 { 6.0 } else { 0.0 });
    let places = [(2.0, 12.0), (2.0, 14.0), (2.0, 16.0), (2.0, 30.0)];
    for found in shadows(&wall_at_the_top, &DirectionalLight::from_degrees(90.0, 45.0), &places) {
        assert_eq!(found, [true, true, false, false]);
    }
    for found in shadows(&wall_at_the_top, &DirectionalLight::from_degrees(270.0, 45.0), &places) {
        assert_eq!(found, [false; 4]);
    }
}

fn everywhere() -> Vec<(f64, f64)> {
    (0..24).flat_map(|row| (0..24).map(move |column| (f64::from(column), f64::from(row)))).collect()
}

fn rough() -> HeightField {
    field((24, 24), (1.0, 1.0), Edge::Wrap, |column, row| 30.0 * noise(1, column, row))
}

#[test]
fn a_sun_at_the_zenith_lights_everything() {
    for azimuth in [0.0, 77.0, 359.9] {
        for found in shadows(&rough(), &DirectionalLight::from_degrees(azimuth, 90.0), &everywhere()) {
            assert!(found.iter().all(|&shadow| !shadow), "azimuth {azimuth}");
        }
    }
}

#[test]
fn a_sun_exactly_at_the_zenith_has_no_azimuth_and_needs_none() {
    let zenith = DirectionalLight { towards: glam::DVec3::Z, azimuth_radians: 0.0 };
    for found in shadows(&rough(), &zenith, &everywhere()) {
        assert!(found.iter().all(|&shadow| !shadow));
    }
}

#[test]
fn a_sun_below_every_horizon_lights_nothing() {
    // Level ground, and a summit whose horizon is 1° to 2° below the horizontal.
    let level = field((8, 8), (1.0, 1.0), Edge::Clamp, |_, _| 2.0);
    for found in shadows(&level, &DirectionalLight::from_degrees(33.0, -0.5), &[(3.0, 4.0), (7.0, 0.0)]) {
        assert_eq!(found, [true, true]);
    }
    for found in shadows(&rough(), &DirectionalLight::from_degrees(45.0, -85.0), &everywhere()) {
        assert!(found.iter().all(|&shadow| shadow));
    }
}

#[test]
fn a_summit_sees_the_sun_below_the_horizontal_until_its_horizon() {
    let summit = field((401, 3), (1.0, 1.0), Edge::Clamp, |column, _| if column == 200 { 10.0 } else { 0.0 });
    // 10 m over a radius of 200 m: 2.86° below the horizontal.
    for (elevation, dark) in [(1.0, false), (-2.8, false), (-2.9, true)] {
        for found in shadows(&summit, &DirectionalLight::from_degrees(180.0, elevation), &[(200.0, 1.0)]) {
            assert_eq!(found, [dark], "{elevation}°");
        }
    }
}

#[test]
fn level_ground_is_lit_by_a_level_sun() {
    let level = field((8, 8), (1.0, 1.0), Edge::Wrap, |_, _| 2.0);
    for found in shadows(&level, &DirectionalLight::from_degrees(10.0, 0.0), &[(3.0, 4.0), (2.5, 1.25)]) {
        assert_eq!(found, [false, false]);
    }
}
