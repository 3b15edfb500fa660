//! Fields and parameters at the ends of their ranges: finite, in range, and the reference's.

use barchan_asset::{MAX_ELEVATION, f32_at_most};
use barchan_bakers::horizon::{HorizonMap, HorizonParams, Method};
use barchan_field::shapes::Spike;
use barchan_field::{Edge, HeightField, Shape};

use crate::support::{at, bake, both, fill, grid, noise, params};

const EDGES: [Edge; 2] = [Edge::Wrap, Edge::Clamp];

/// How far the methods that compute in f32 may be above the reference, in degrees.
const ROUNDING_DEGREES: f64 = 0.01;

/// The maps of the sweep, the accurate and the exact method and of the reference, finite and in range.
#[track_caller]
fn maps_in_range(field: &HeightField, params: &HorizonParams) -> [HorizonMap; 4] {
    let [exact, expected] = both(field, params);
    let by = |method| bake(field, &HorizonParams { method, ..*params });
    let maps = [by(Method::Sweep), by(Method::Accurate), exact, expected];
    for map in &maps {
        assert!(map.elevation_radians.iter().all(|e| e.abs() <= MAX_ELEVATION), "an elevation out of range");
        let farthest = f32_at_most(params.radius);
        let distances = map.distance.as_ref().unwrap();
        assert!(distances.iter().all(|d| (0.0..=farthest).contains(d)), "a distance out of range");
    }
    maps
}

/// Besides, the exact method is the reference, and the accurate one at most `tolerance_degrees` below it at any texel. What
/// the sweep may miss in noise is not stated here.
#[track_caller]
fn check(field: &HeightField, params: &HorizonParams, tolerance_degrees: f64) {
    let [swept, accurate, exact, expected] = maps_in_range(field, params);
    let errors = |map: &HorizonMap| -> (f64, f64) {
        let pairs = map.elevation_radians.iter().zip(&expected.elevation_radians);
        let errors = pairs.map(|(&found, &expected)| (f64::from(found) - f64::from(expected)).to_degrees());
        errors.fold((0.0, 0.0), |(below, above), error| (error.min(below), error.max(above)))
    };
    let (below, above) = errors(&exact);
    assert!(below >= -2e-5 && above <= 2e-5, "exact is {below}° below and {above}° above the reference");
    for (map, tolerance_degrees) in [(accurate, tolerance_degrees), (swept, f64::INFINITY)] {
        let (below, above) = errors(&map);
        let method = map.params.method.name();
        assert!(above <= ROUNDING_DEGREES, "{method} is {above}° above the reference");
        assert!(-below <= tolerance_degrees, "{method} is {below}° below the reference");
    }
}

#[test]
fn one_row_one_column_and_two_texels() {
    for edge in EDGES {
        for size in [(37, 1), (1, 37), (2, 1), (1, 2), (2, 2)] {
            for spacing in [(1.0, 1.0), (0.3, 2.0)] {
                let field = fill(grid(size, spacing, edge), |column, row| 3.0 * noise(1, column, row));
                for radius in [0.5, 8.0, 90.0] {
                    check(&field, &params(11, radius), 3.0);
                }
            }
        }
    }
}

#[test]
fn a_radius_far_below_a_texel_sees_the_slope_at_the_texel() {
    for edge in EDGES {
        let field = fill(grid((13, 9), (1.0, 2.0), edge), |column, row| 3.0 * noise(2, column, row));
        for radius in [1e-2, 1e-6, 1e-12, 1e-20] {
            check(&field, &params(9, radius), 1e-4);
        }
    }
}

#[test]
fn the_slope_at_the_texel_is_that_of_the_cell_the_ray_enters() {
    // A roof: falling to both sides of column 4.
    let roof = fill(grid((9, 3), (1.0, 1.0), Edge::Clamp), |column, _| -(column as f32 - 4.0).abs());
    for radius in [1e-3, 1e-9, 1e-15, 1e-18, 1e-25] {
        for map in both(&roof, &params(2, radius)) {
            for direction in 0..2 {
                let elevation = at(&map, direction, 4, 1).0;
                assert!((elevation + std::f64::consts::FRAC_PI_4).abs() < 1e-6, "radius {radius}: {elevation}");
            }
        }
    }
}

#[test]
fn a_radius_of_many_tiles() {
    let field = fill(grid((7, 5), (1.0, 1.0), Edge::Wrap), |column, row| 3.0 * noise(4, column, row));
    check(&field, &params(10, 500.0), 4.0);
    let field = fill(grid((7, 5), (1.0, 1.0), Edge::Clamp), |column, row| 3.0 * noise(4, column, row));
    check(&field, &params(10, 500.0), 4.0);
    let sky =
        bake(&fill(grid((3, 2), (1.0, 1.0), Edge::Wrap), |column, row| (column + row) as f32), &params(3, 131_072.0));
    assert!(sky.elevation_radians.iter().all(|elevation| elevation.is_finite()));
}

#[test]
fn heights_at_the_ends_of_f32_over_tiny_texels() {
    for edge in EDGES {
        for (height, spacing) in [(1e30_f32, 1e-3), (f32::MAX, 1e-30)] {
            let field = fill(grid((12, 9), (spacing, spacing), edge), |column, row| {
                if noise(6, column, row) < 0.5 { height } else { -height }
            });
            // Where slopes of 1e33 should cancel, what f64 leaves of them may be anything.
            maps_in_range(&field, &params(7, 6.3 * spacing));
            let wall =
                fill(grid((12, 9), (spacing, spacing), edge), |column, _| if column == 11 { height } else { -height });
            for map in both(&wall, &params(7, 20.0 * spacing)) {
                assert!((0..11).all(|column| at(&map, 0, column, 4).0 == f64::from(MAX_ELEVATION)));
            }
        }
        let field = fill(grid((12, 9), (1e30, 1e30), edge), |column, row| f32::MAX * noise(6, column, row));
        check(&field, &params(7, 6.3e30), 2.0);
    }
}

#[test]
fn subnormal_heights() {
    for edge in EDGES {
        for spacing in [1.0, 1e-30] {
            let field = fill(grid((12, 9), (spacing, spacing), edge), |column, row| {
                f32::from_bits((noise(7, column, row) * 1000.0) as u32)
            });
            check(&field, &params(7, 6.3 * spacing), 1e-4);
        }
    }
}

#[test]
fn small_relief_at_a_great_height() {
    for edge in EDGES {
        let field = fill(grid((24, 24), (1.0, 1.0), edge), |column, row| 1e7 + (4.0 * noise(8, column, row)).floor());
        check(&field, &params(12, 24.0), 9.0);
    }
}

#[test]
fn one_direction_and_a_prime_number_of_them() {
    for edge in EDGES {
        let field = fill(grid((24, 24), (1.0, 1.0), edge), |column, row| noise(9, column, row));
        for directions in [1, 2, 3, 5, 97, 2039] {
            check(&field, &params(directions, 5.0), 4.0);
        }
    }
}

#[test]
fn texels_a_hundred_times_as_long_as_wide() {
    for edge in EDGES {
        for spacing in [(100.0, 1.0), (1.0, 100.0), (1e30, 1.0), (1.0, 1e30)] {
            let field = fill(grid((16, 12), spacing, edge), |column, row| 3.0 * noise(10, column, row));
            let fine = spacing.0.min(spacing.1);
            check(&field, &params(10, 300.0 * fine), 3.0);
        }
    }
}

#[test]
fn a_spike_and_a_pit_a_thousand_texels_high() {
    for edge in EDGES {
        let tall = |height| Shape::Spike(Spike { height }).rasterize(grid((21, 21), (1.0, 1.0), edge)).unwrap();
        for height in [-1000.0, 1000.0] {
            check(&tall(height), &params(16, 21.0), 0.1);
        }
    }
}

/// Level ground with a wall along its 32nd column, looked at along +u by every method: `wall` high over texels of length 1.
#[track_caller]
fn check_wall(ground: f32, wall: f32, height: u32, tolerance: f64) {
    let field =
        fill(grid((64, height), (1.0, 1.0), Edge::Clamp), |column, _| if column < 32 { ground } else { ground + wall });
    for method in Method::ALL {
        let map = bake(&field, &HorizonParams { method, ..params(4, 40.0) });
        for column in 0..32 {
            let away = f64::from(32 - column);
            let (elevation, distance) = at(&map, 0, column, 0);
            let expected = (f64::from(wall) / away).atan();
            let name = method.name();
            assert!(
                (elevation - expected).abs() <= tolerance,
                "{name}, column {column}: {elevation:e} for {expected:e}"
            );
            assert!((distance - away).abs() <= 1e-5, "{name}, column {column}: seen at {distance} instead of {away}");
        }
    }
}

#[test]
fn a_wall_of_slope_a_million_is_seen_at_its_top() {
    check_wall(0.0, 1e6, 3, 2e-7);
}

#[test]
fn a_wall_on_ground_ten_million_high_is_seen_as_on_any_other() {
    check_wall(1e7, 4.0, 3, 2e-7);
}

#[test]
fn a_subnormal_wall_has_its_subnormal_elevation() {
    check_wall(0.0, 1e-40, 3, 3e-45);
}

#[test]
fn a_map_one_texel_high_sees_along_itself() {
    check_wall(0.0, 5.0, 1, 2e-7);
}
