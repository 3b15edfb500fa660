//! Skies that can be written down.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, FRAC_PI_4, PI};

use barchan_asset::MAX_ELEVATION;
use barchan_field::shapes::{Axis, Plane, StepWall};
use barchan_field::{Edge, HeightField, Shape};

use crate::support::{EDGES, assert_near, assert_towards, at, bake, fill, grid, horizons, under_skyline};

const UP: [f64; 3] = [0.0, 0.0, 1.0];

/// What f32 sums of a few dozen terms keep.
const ROUNDING: f64 = 2e-6;

fn level() -> HeightField {
    fill(grid((2, 1), (1.0, 1.0), Edge::Clamp), |_, _| 3.0)
}

#[test]
fn level_ground_sees_all_of_the_sky_exactly() {
    for edge in EDGES {
        for directions in [3, 4, 8, 17, 32, 2048] {
            let field = fill(grid((3, 2), (1.0, 1.0), edge), |_, _| 1.25);
            let sky = bake(&field, &horizons(directions, 4.0));
            assert!(sky.visibility.unwrap().iter().all(|&visibility| visibility == 1.0), "{directions}");
            assert!(sky.bent_normal.unwrap().iter().all(|&component| component == 0.0), "{directions}");
            assert!(sky.aperture_cone.unwrap().chunks(4).all(|cone| cone == [0.0, 0.0, 1.0, 0.0]), "{directions}");
        }
    }
}

/// A ring of horizon at elevation E leaves sin²(90° − E) of a level texel's visibility, and a cap of half-angle 90° −
/// E.
#[test]
fn an_even_skyline_leaves_a_cap() {
    for degrees in [0.0_f64, 5.0, 30.0, 45.0, 80.0, 89.0] {
        let elevation = degrees.to_radians();
        let sky = at(&under_skyline(&level(), 8, |_| elevation), (0, 0));
        assert_near(sky.visibility, elevation.cos().powi(2), ROUNDING);
        assert_towards(sky.bent_normal, UP, ROUNDING);
        assert_towards(sky.cone_axis, UP, ROUNDING);
        // An f32 cosine near 1 keeps an angle of a degree to no more.
        assert_near(sky.half_angle, FRAC_PI_2 - elevation, 2e-5);
    }
}

/// An infinitely long wall of height H at distance d hides ½(1 − 1/√(1 + k²)), k = H/d, of a level texel's sky.
#[test]
fn an_infinitely_long_wall() {
    for k in [0.1_f64, 0.5, 1.0, 2.0, 5.0] {
        let skyline = |azimuth: f64| (k * azimuth.cos()).max(0.0).atan();
        let expected = 1.0 - 0.5 * (1.0 - 1.0 / (1.0 + k * k).sqrt());
        assert_near(at(&under_skyline(&level(), 64, skyline), (0, 0)).visibility, expected, ROUNDING);
    }
}

/// Half the sky: a quarter of a sphere, whose mean direction stands at 45° and whose solid angle is that of a cap of
/// 60°.
#[test]
fn an_infinitely_high_wall() {
    let directions = 256;
    let wall = |azimuth: f64| if azimuth.cos() > 1e-9 { f64::from(MAX_ELEVATION) } else { 0.0 };
    let sky = at(&under_skyline(&level(), directions, wall), (0, 0));
    // The skyline jumps: one slice more or less than half of them.
    let slice = 1.0 / f64::from(directions);
    assert_near(sky.visibility, 0.5, 1.01 * slice);
    assert_near(sky.half_angle, FRAC_PI_3, 2.0 * slice);
    assert_towards(sky.cone_axis, [-FRAC_PI_4.sin(), 0.0, FRAC_PI_4.cos()], 2.0 * slice);
    // ∫ ω (n·ω) over the quarter sphere: 2/3 sideways, π/3 up.
    let length = (4.0 / 9.0 + PI * PI / 9.0_f64).sqrt();
    assert_towards(sky.bent_normal, [-2.0 / 3.0 / length, 0.0, PI / 3.0 / length], 2.0 * slice);
}

#[test]
fn a_wall_of_texels_is_an_infinitely_long_one_where_it_is_long_enough() {
    let wall = Shape::StepWall(StepWall { height: 6.0, position: 0.5, across: Axis::U });
    let field = wall.rasterize(grid((64, 3), (0.5, 0.5), Edge::Clamp)).unwrap();
    // Clamped, the wall goes on for ever; the bilinear surface reaches its top at column 32.
    let sky = bake(&field, &horizons(64, 2000.0));
    for column in [4, 12, 20, 26] {
        let k = 6.0 / (0.5 * f64::from(32 - column));
        let expected = 1.0 - 0.5 * (1.0 - 1.0 / (1.0 + k * k).sqrt());
        assert_near(at(&sky, (column, 1)).visibility, expected, 1e-4);
    }
}

/// A slope of angle S in the open: what it sees lies between its own plane and the horizontal, a lune of angle π − S.
///
/// Visibility is (1 + cos S)/2; the cone's axis is the lune's middle, S/2 from the zenith, and Ω = 2(π − S). With ψ
/// from the normal towards the zenith, ∫ ω (n·ω) = 4/3 ∫ (cos ψ, sin ψ) cos ψ dψ over −π/2 ≤ ψ ≤ π/2 − S, but for the
/// sign of ψ.
#[test]
fn an_inclined_plane_sees_a_lune() {
    for (slope_u, slope_v) in [(0.5, 0.0), (0.25, -0.75), (-1.0, 1.0), (0.0, 4.0)] {
        let steepness = f64::hypot(slope_u, slope_v);
        let angle = steepness.atan();
        let tilted = |by: f64| [-slope_u / steepness * by.sin(), -slope_v / steepness * by.sin(), by.cos()];
        let along = 0.5 * (PI - angle) + 0.25 * (2.0 * angle).sin();
        let towards_zenith = (0.5 * angle.sin().powi(2)).atan2(along);
        let plane = Shape::Plane(Plane { slope_u, slope_v });
        let field = plane.rasterize(grid((17, 17), (1.0, 0.5), Edge::Clamp)).unwrap();
        let sky = at(&bake(&field, &horizons(64, 3.5)), (8, 8));
        // Where the slope's own plane begins to rise the slices have a corner, and 64 of them leave this.
        assert_near(sky.visibility, 0.5 * (1.0 + angle.cos()), 3e-5);
        assert_towards(sky.bent_normal, tilted(angle - towards_zenith), 1e-4);
        assert_towards(sky.cone_axis, tilted(0.5 * angle), 2e-3);
        assert_near(sky.half_angle.cos(), angle / PI, 1.1e-3);
    }
}

/// In a pit that is part of a sphere every point sees the same share of the sky, whatever its own slope: seen from
/// one point of a sphere, equal areas of it have equal form factors. So visibility is 1 − depth/(2 radius)
/// everywhere, and half in a hemisphere.
#[test]
fn everywhere_in_a_spherical_pit_the_sky_is_the_same() {
    let (radius, size) = (100.0_f64, 201);
    for depth in [20.0, 50.0] {
        let pit = grid((size, size), (1.0, 1.0), Edge::Clamp);
        let field = fill(pit, |column, row| {
            let (u, v) = (f64::from(column) - 100.0, f64::from(row) - 100.0);
            (radius - (radius * radius - u * u - v * v).max(0.0).sqrt()).min(depth) as f32
        });
        let sky = bake_row(&field, 32);
        let rim = (radius * radius - (radius - depth).powi(2)).sqrt();
        for column in (100..200).step_by(7).take_while(|&column| f64::from(column) - 100.0 < rim - 2.0) {
            assert_near(sky(column).visibility, 1.0 - 0.5 * depth / radius, 4e-3);
        }
        let bottom = sky(100);
        assert_near(bottom.half_angle, rim.atan2(depth), 1e-2);
        assert_towards(bottom.bent_normal, UP, 1e-5);
        assert_towards(bottom.cone_axis, UP, 1e-5);
    }
}

#[test]
fn the_bottom_of_a_hemispherical_pit_sees_half() {
    let size = 129;
    let field = fill(grid((size, size), (1.0, 1.0), Edge::Clamp), |column, row| {
        let (u, v) = (f64::from(column) - 64.0, f64::from(row) - 64.0);
        (48.0 - (48.0_f64 * 48.0 - u * u - v * v).max(0.0).sqrt()) as f32
    });
    // From the bottom the rim of a hemisphere stands at 45°, but for where its texels, a 48th of the radius, let it
    // fall short.
    let bottom = at(&under_horizons_of_row(&field, 64, 64), (64, 64));
    assert_near(bottom.visibility, 0.5, 7e-3);
    assert_near(bottom.half_angle, FRAC_PI_4, 7e-3);
    assert_towards(bottom.bent_normal, UP, 1e-5);
}

/// The sky of the middle row alone: exact horizons of whole large fields take too long.
fn bake_row(field: &HeightField, directions: u32) -> impl Fn(u32) -> crate::support::Sky {
    let row = field.grid().height / 2;
    let sky = under_horizons_of_row(field, directions, row);
    move |column| at(&sky, (column, row))
}

fn under_horizons_of_row(field: &HeightField, directions: u32, row: u32) -> barchan_bakers::sky::SkyMap {
    use barchan_bakers::horizon::reference;
    use barchan_bakers::{Exec, sky::SkyAccumulator, sky::SkyParams};
    let (exec, params) = (Exec::new(1).unwrap(), horizons(directions, field.grid().diagonal()));
    let mut sky = SkyAccumulator::new(field, &params.azimuths, SkyParams::ALL).unwrap();
    for direction in 0..directions {
        let mut elevations = vec![0.0; field.grid().texels()];
        for column in 0..field.grid().width {
            let texel = (row * field.grid().width + column) as usize;
            elevations[texel] = reference::horizon(field, &params, direction, column, row).slope.atan() as f32;
        }
        sky.add(direction, &elevations, &exec);
    }
    sky.finish(&exec).unwrap()
}

/// Nothing is seen from the bottom of a shaft: the answers are the normal and no cone at all.
#[test]
fn where_nothing_is_seen_both_directions_are_the_normal() {
    let slopes = fill(grid((3, 3), (1.0, 1.0), Edge::Clamp), |column, row| 0.5 * column as f32 + 2.0 * row as f32);
    for skyline in [f64::from(MAX_ELEVATION), FRAC_PI_2] {
        let sky = at(&under_skyline(&slopes, 16, |_| skyline), (1, 1));
        let length = (1.0_f64 + 0.25 + 4.0).sqrt();
        let normal = [-0.5 / length, 2.0 / length, 1.0 / length];
        assert_eq!((sky.visibility, sky.half_angle), (0.0, 0.0));
        assert_towards(sky.bent_normal, normal, ROUNDING);
        assert_towards(sky.cone_axis, normal, ROUNDING);
    }
}
