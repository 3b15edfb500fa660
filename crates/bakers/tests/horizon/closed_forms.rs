//! Fields whose horizon can be written down. Both bakers must find it, unless a test says otherwise.

use std::f64::consts::{SQRT_2, TAU};

use barchan_asset::f32_at_most;
use barchan_bakers::horizon::reference;
use barchan_field::shapes::{Axis, Gaussian, Plane, Pyramid, Spike, StepWall};
use barchan_field::{Edge, Shape};

use crate::support::{assert_near, at, both, field, fill, grid, params};

/// f32 tables keep an elevation to this, in radians.
const ROUNDING: f64 = 2e-7;

#[test]
fn a_level_field_has_its_horizon_at_the_radius_and_level() {
    for edge in [Edge::Wrap, Edge::Clamp] {
        for radius in [0.4, 7.3, 40.0] {
            let params = params(7, radius);
            for map in both(&field((9, 6), edge, |_, _| 1.25), &params) {
                assert!(map.elevation_radians.iter().all(|&elevation| elevation == 0.0));
                assert!(map.distance.unwrap().iter().all(|&distance| distance == f32_at_most(radius)), "{radius}");
            }
        }
    }
}

#[test]
fn a_plane_is_seen_at_its_slope_along_every_azimuth() {
    let grid = grid((33, 33), (1.0, 0.5), Edge::Clamp);
    let field = Shape::Plane(Plane { slope_u: 0.25, slope_v: -0.75 }).rasterize(grid).unwrap();
    for map in both(&field, &params(24, 6.0)) {
        for direction in 0..24 {
            let (sin, cos) = (TAU * f64::from(direction) / 24.0).sin_cos();
            let (elevation, _) = at(&map, direction, 16, 16);
            assert_near(elevation, (0.25 * cos - 0.75 * sin).atan(), ROUNDING);
        }
    }
}

#[test]
fn azimuth_90_degrees_looks_up_the_picture() {
    let rising_to_the_top = field((9, 9), Edge::Clamp, |_, row| 8.0 - row as f32);
    for map in both(&rising_to_the_top, &params(4, 3.0)) {
        let elevations = [0, 1, 2, 3].map(|direction| at(&map, direction, 4, 4).0);
        assert_near(elevations[1], 45_f64.to_radians(), ROUNDING);
        assert_near(elevations[3], -45_f64.to_radians(), ROUNDING);
        assert_eq!((elevations[0], elevations[2]), (0.0, 0.0));
    }
}

#[test]
fn a_wall_is_seen_at_its_top_and_at_its_distance() {
    let wall = Shape::StepWall(StepWall { height: 6.0, position: 0.5, across: Axis::U });
    let field = wall.rasterize(grid((64, 64), (0.5, 1.0), Edge::Clamp)).unwrap();
    for map in both(&field, &params(32, 100.0)) {
        for direction in 0..=4 {
            // The bilinear surface reaches the top at the first texel centre beyond the wall, column 32.
            let (sin, cos) = (TAU * f64::from(direction) / 32.0).sin_cos();
            for column in [0, 7, 24, 30] {
                let expected = 0.5 * f64::from(32 - column) / cos;
                assert!(expected * sin < 31.0, "the ray leaves through the top");
                let (elevation, distance) = at(&map, direction, column, 32);
                assert_near(elevation, (6.0 / expected).atan(), ROUNDING);
                assert_near(distance, expected, 1e-5);
            }
        }
    }
}

#[test]
fn a_wall_beyond_the_radius_is_not_seen_and_half_a_ramp_within_is() {
    let field = field((32, 3), Edge::Clamp, |column, _| if column < 20 { 0.0 } else { 8.0 });
    for (radius, elevation, distance) in [
        (8.0, 0.0, 8.0),
        (9.0, 0.0, 9.0),
        (9.5, (4.0_f64 / 9.5).atan(), 9.5),
        (10.0, (8.0_f64 / 10.0).atan(), 10.0),
        (18.0, (8.0_f64 / 10.0).atan(), 10.0),
    ] {
        for map in both(&field, &params(4, radius)) {
            let found = at(&map, 0, 10, 1);
            assert_near(found.0, elevation, ROUNDING);
            assert_near(found.1, distance, 1e-6);
        }
    }
}

#[test]
fn a_peak_sees_its_horizon_below_the_horizontal() {
    let peak = field((41, 41), Edge::Clamp, |column, row| if (column, row) == (20, 20) { 3.0 } else { 0.0 });
    for map in both(&peak, &params(17, 15.0)) {
        for direction in 0..17 {
            let (elevation, distance) = at(&map, direction, 20, 20);
            assert_near(elevation, -(3.0_f64 / 15.0).atan(), ROUNDING);
            assert_near(distance, 15.0, 1e-6);
        }
    }
}

#[test]
fn from_the_top_of_a_gaussian_the_horizon_is_the_summit_itself() {
    let hill = Gaussian { height: 4.0, sigma: 8.0, centre_u: 0.5, centre_v: 0.5 };
    let field = Shape::Gaussian(hill).rasterize(grid((65, 65), (1.0, 1.0), Edge::Clamp)).unwrap();
    // Along the axes the surface falls straight to the neighbouring texel.
    let first_step = 4.0 * ((-0.5_f64 / 64.0).exp() - 1.0);
    for map in both(&field, &params(4, 30.0)) {
        for direction in 0..4 {
            let (elevation, distance) = at(&map, direction, 32, 32);
            assert_near(elevation, first_step.atan(), 1e-6);
            assert!(distance <= 1.0);
        }
    }
}

#[test]
fn from_the_plain_a_gaussian_is_seen_where_the_sight_line_touches_it() {
    let hill = Gaussian { height: 12.0, sigma: 8.0, centre_u: 0.5, centre_v: 0.5 };
    let field = Shape::Gaussian(hill).rasterize(grid((129, 129), (1.0, 1.0), Edge::Clamp)).unwrap();
    for away in [30, 45, 60] {
        let eye = 12.0 * (-0.5 * f64::from(away * away) / 64.0).exp();
        let slope = |s: f64| (12.0 * (-0.5 * ((s - f64::from(away)) / 8.0).powi(2)).exp() - eye) / s;
        let touching = (1..20_000).map(|k| slope(f64::from(k) * 0.01)).fold(f64::NEG_INFINITY, f64::max);
        for map in both(&field, &params(4, 120.0)) {
            for (direction, column, row) in [(0, 64 - away, 64), (1, 64, 64 + away), (2, 64 + away, 64)] {
                // Chords between texels lie below a summit, by up to an eighth of its bend.
                assert_near(at(&map, direction, column, row).0, touching.atan(), 12.0 / (8.0 * 64.0) / 30.0);
            }
        }
    }
}

#[test]
fn a_pyramid_is_seen_at_its_apex_from_the_plain_and_from_its_faces() {
    let pyramid = Pyramid { height: 10.0, half_width: 16.0, centre_u: 0.5, centre_v: 0.5 };
    let field = Shape::Pyramid(pyramid).rasterize(grid((129, 65), (0.5, 1.0), Edge::Clamp)).unwrap();
    for map in both(&field, &params(8, 60.0)) {
        // From the plain: the apex, over the length to it.
        let (elevation, distance) = at(&map, 0, 4, 32);
        assert_near(elevation, (10.0_f64 / 30.0).atan(), 1e-6);
        assert_near(distance, 30.0, 1e-5);
        // On a face, straight up: the face itself. Both up and down the face is at its own slope.
        assert_near(at(&map, 0, 50, 32).0, (10.0_f64 / 16.0).atan(), 1e-6);
        assert_near(at(&map, 3, 64 + 12, 32 + 6).0, (10.0_f64 / (16.0 * SQRT_2)).atan(), 1e-6);
    }
}

#[test]
fn a_wrapped_field_sees_itself_over_the_seam_and_a_clamped_one_does_not() {
    let ridge = |edge| field((16, 16), edge, |column, _| if column == 2 { 3.0 } else { 0.0 });
    for map in both(&ridge(Edge::Wrap), &params(4, 12.0)) {
        let (elevation, distance) = at(&map, 0, 14, 5);
        assert_near(elevation, (3.0_f64 / 4.0).atan(), ROUNDING);
        assert_near(distance, 4.0, 1e-6);
    }
    for map in both(&ridge(Edge::Clamp), &params(4, 12.0)) {
        assert_eq!(at(&map, 0, 14, 5), (0.0, 12.0));
    }
}

#[test]
fn a_wrapped_ridge_sees_its_own_image() {
    let ridge = field((16, 4), Edge::Wrap, |column, _| if column == 2 { 3.0 } else { 0.0 });
    for map in both(&ridge, &params(4, 16.0)) {
        assert_eq!(at(&map, 0, 2, 1), (0.0, 16.0));
        assert_eq!(at(&map, 2, 2, 1), (0.0, 16.0));
    }
}

#[test]
fn forty_five_degrees_is_a_matter_of_length_not_of_texels() {
    // Texels twice as high as wide: 45° climbs one row for two columns.
    let peak_at = |peak: (u32, u32)| {
        fill(grid((17, 9), (1.0, 2.0), Edge::Clamp), |column, row| if (column, row) == peak { 5.0 } else { 0.0 })
    };
    for map in both(&peak_at((8, 4)), &params(8, 12.0)) {
        let (elevation, distance) = at(&map, 1, 4, 6);
        assert_near(elevation, (5.0 / (4.0 * SQRT_2)).atan(), ROUNDING);
        assert_near(distance, 4.0 * SQRT_2, 1e-6);
    }
    for map in both(&peak_at((8, 2)), &params(8, 12.0)) {
        assert_eq!(at(&map, 1, 4, 6).0, 0.0);
    }
}

#[test]
fn a_spike_is_a_tent_seen_exactly_on_the_axis() {
    let field = Shape::Spike(Spike { height: 32.0 }).rasterize(grid((17, 17), (1.0, 1.0), Edge::Clamp)).unwrap();
    for map in both(&field, &params(4, 16.0)) {
        for away in 2..=8 {
            let (elevation, distance) = at(&map, 0, 8 - away, 8);
            assert_near(elevation, (32.0 / f64::from(away)).atan(), ROUNDING);
            assert_near(distance, f64::from(away), 1e-6);
        }
    }
}

#[test]
fn a_ray_that_grazes_a_spike_touches_its_tent_where_calculus_says() {
    let field = Shape::Spike(Spike { height: 32.0 }).rasterize(grid((17, 17), (1.0, 1.0), Edge::Clamp)).unwrap();
    // The diagonal through (8 + a, 9 − a) has height 32 a (1 − a) at distance √2 (4 + a): steepest at a = √20 − 4.
    let a = 20_f64.sqrt() - 4.0;
    let (slope, distance) = (32.0 * a * (1.0 - a) / (SQRT_2 * (4.0 + a)), SQRT_2 * (4.0 + a));
    for map in both(&field, &params(8, 16.0)) {
        let found = at(&map, 1, 4, 13);
        assert_near(found.0, slope.atan(), ROUNDING);
        assert_near(found.1, distance, 1e-6);
    }
}

#[test]
fn where_the_surface_falls_away_below_its_tangent_the_distance_is_0() {
    // A saddle cell: down its diagonal from the corner, h = −s²/2 bends away at once.
    let field = field((2, 2), Edge::Clamp, |column, row| if (column, row) == (1, 1) { -1.0 } else { 0.0 });
    let found = reference::horizon(&field, &params(8, 1.0), 7, 0, 0);
    assert_eq!((found.slope, found.distance), (0.0, 0.0));
    for map in both(&field, &params(8, 1.0)) {
        assert_eq!(at(&map, 7, 0, 0), (0.0, 0.0));
    }
}
