//! Against rays: the twin itself against closed forms, then the baker against the twin.

use barchan_bakers::sky::reference::{RayCount, sky};
use barchan_field::shapes::{Axis, Plane, StepWall};
use barchan_field::{Edge, HeightField, Shape};

use crate::support::{angle, assert_near, assert_towards, at, bake, fill, grid, horizons, noise};

const RAYS: RayCount = RayCount { rings: 64, rays: 256 };

#[test]
fn rays_find_the_closed_forms() {
    let level = fill(grid((4, 4), (1.0, 1.0), Edge::Wrap), |_, _| 2.0);
    let open = sky(&level, 10.0, (1, 2), RAYS);
    assert_near(open.visibility, 1.0, 1e-12);
    assert_near(open.cos_half_angle, 0.0, 1e-12);
    assert_towards(open.bent_normal, [0.0, 0.0, 1.0], 1e-9);

    let plane = Shape::Plane(Plane { slope_u: 0.5, slope_v: 0.0 });
    let plane = sky(&plane.rasterize(grid((17, 17), (1.0, 0.5), Edge::Clamp)).unwrap(), 3.5, (8, 8), RAYS);
    let tilt = 0.5_f64.atan();
    assert_near(plane.visibility, 0.5 * (1.0 + tilt.cos()), 1e-3);
    assert_towards(plane.cone_axis, [-(0.5 * tilt).sin(), 0.0, (0.5 * tilt).cos()], 2e-3);

    let wall = Shape::StepWall(StepWall { height: 6.0, position: 0.5, across: Axis::U });
    let wall = sky(&wall.rasterize(grid((64, 3), (0.5, 0.5), Edge::Clamp)).unwrap(), 500.0, (20, 1), RAYS);
    assert_near(wall.visibility, 1.0 - 0.5 * (1.0 - 1.0 / 2.0_f64.sqrt()), 1e-3);
}

fn example(name: &str, edge: Edge) -> HeightField {
    let shape = Shape::examples().into_iter().find(|shape| shape.name() == name).unwrap();
    shape.rasterize(grid((32, 32), (8.0, 8.0), edge)).unwrap()
}

fn white_noise() -> HeightField {
    fill(grid((24, 24), (1.0, 1.0), Edge::Wrap), |column, row| 4.0 * noise(3, column, row))
}

/// RMS over a dozen texels, of visibility, of the bent normal in degrees, of the cone's axis and half-angle in degrees.
fn errors(field: &HeightField, directions: u32) -> [f64; 4] {
    let radius = 2.0 * field.grid().extent_u();
    let map = bake(field, &horizons(directions, radius));
    let texels: Vec<(u32, u32)> = (0..12).map(|i| (7 * i % field.grid().width, 5 * i % field.grid().height)).collect();
    let mut squares = [0.0; 4];
    for &texel in &texels {
        let (found, traced) = (at(&map, texel), sky(field, radius, texel, RAYS));
        let off = [
            found.visibility - traced.visibility,
            angle(found.bent_normal, traced.bent_normal).to_degrees(),
            angle(found.cone_axis, traced.cone_axis).to_degrees(),
            (found.half_angle - traced.cos_half_angle.acos()).to_degrees(),
        ];
        for (square, off) in squares.iter_mut().zip(off) {
            *square += off * off / texels.len() as f64;
        }
    }
    squares.map(f64::sqrt)
}

#[track_caller]
fn check(field: &HeightField, directions: u32, tolerance: [f64; 4]) {
    let found = errors(field, directions);
    assert!(found.iter().zip(tolerance).all(|(found, tolerance)| *found <= tolerance), "{directions}: {found:?}");
}

#[test]
fn smooth_relief_needs_few_directions() {
    for name in ["dunes", "ripples"] {
        check(&example(name, Edge::Wrap), 16, [1e-3, 0.1, 0.3, 0.2]);
        check(&example(name, Edge::Wrap), 64, [5e-4, 0.05, 0.1, 0.1]);
    }
    check(&example("gaussian", Edge::Clamp), 32, [5e-4, 0.05, 0.1, 0.1]);
}

#[test]
fn rough_relief_gains_with_every_direction() {
    for field in [example("fractal_terrain", Edge::Wrap), example("reptile_skin", Edge::Wrap)] {
        check(&field, 8, [1e-2, 0.8, 1.2, 0.8]);
        check(&field, 32, [2e-3, 0.15, 0.2, 0.2]);
    }
    check(&white_noise(), 8, [5e-2, 5.0, 5.0, 5.0]);
    check(&white_noise(), 32, [8e-3, 0.8, 0.8, 0.8]);
    check(&white_noise(), 128, [2e-3, 0.3, 0.3, 0.3]);
}
