//! The exact trace: closed forms, and dense marching on small rough fields.

use barchan_field::{Edge, HeightField};
use barchan_shade::{Relief, Surface, TracedRelief};
use proptest::prelude::*;

use crate::support::{assert_near, field, gap, noise, rays, surface, towards};

#[test]
fn a_slope_is_hit_where_two_lines_meet() {
    // One up per texel along u: from 0 to 4.
    let surface = surface(&field((5, 2), (1.0, 1.0), Edge::Clamp, |column, _| column as f32));
    let relief = Relief::new(&surface);
    for (x, polar) in [(3.5, 20.0_f64), (2.0, 45.0), (0.25, 70.0), (4.0, 80.0)] {
        // Coming from −u, the ray at height 4 (1 − d) meets the height x + 4 d tan θ.
        let ray = relief.ray(x, 0.5, towards(polar, 180.0)).unwrap();
        let depth = (4.0 - x) / (4.0 * (1.0 + polar.to_radians().tan()));
        assert_near(TracedRelief::new(&relief).first_hit(&ray, 0.0), depth, 1e-14);
    }
}

#[test]
fn inside_a_twisted_cell_the_hit_is_the_root_of_a_square() {
    // Depth x + y − 2 x y: a ray along the diagonal x = y = t d meets 2 t d − 2 t² d² = d.
    let surface = surface(&field((2, 2), (1.0, 1.0), Edge::Clamp, |column, row| -((column ^ row) as f32)));
    let relief = Relief::new(&surface);
    for step in [0.6, 0.75, 0.9] {
        let tangent = step * 2.0_f64.sqrt();
        let ray = relief.ray(0.0, 0.0, towards(tangent.atan().to_degrees(), 135.0)).unwrap();
        let depth = (2.0 * step - 1.0) / (2.0 * step * step);
        assert_near(TracedRelief::new(&relief).first_hit(&ray, 1e-6), depth, 1e-12);
        assert_eq!(TracedRelief::new(&relief).first_hit(&ray, 0.0), 0.0);
    }
}

#[test]
fn a_ray_along_the_normal_hits_the_surface_below_it() {
    let surface = surface(&field((7, 5), (0.7, 1.3), Edge::Wrap, |column, row| noise(3, column, row)));
    let relief = Relief::new(&surface);
    for ray in rays(&relief, 0.0, 200) {
        let (x, y) = ray.at(0.0);
        assert_near(TracedRelief::new(&relief).first_hit(&ray, 0.0), relief.depth_at(x, y), 1e-14);
    }
    for (x, y) in [(0.0, 0.0), (-3.0, 2.0), (6.0, 4.5), (13.5, -0.0)] {
        let ray = relief.ray(x, y, towards(0.0, 0.0)).unwrap();
        assert_near(TracedRelief::new(&relief).first_hit(&ray, 0.0), relief.depth_at(x, y), 1e-14);
    }
}

#[test]
fn a_tile_that_repeats_is_hit_alike_in_every_tile() {
    let surface = surface(&field((8, 4), (1.0, 1.0), Edge::Wrap, |column, row| 4.0 * noise(4, column, row)));
    let relief = Relief::new(&surface);
    let traced = TracedRelief::new(&relief);
    for k in 0..200 {
        let (x, y) = (f64::from(noise(5, k, 0)) * 8.0, f64::from(noise(5, k, 1)) * 4.0);
        let towards = towards(75.0, f64::from(k) * 1.8);
        let hit = |tiles: f64| traced.first_hit(&relief.ray(x + 8.0 * tiles, y - 4.0 * tiles, towards).unwrap(), 0.0);
        assert_near(hit(-3.0), hit(0.0), 1e-11);
    }
}

#[test]
fn beyond_an_edge_that_clamps_the_edge_goes_on() {
    let surface = surface(&field((3, 3), (1.0, 1.0), Edge::Clamp, |column, row| f32::from(column == 1 && row == 1)));
    let relief = Relief::new(&surface);
    let traced = TracedRelief::new(&relief);
    let floor = relief.ray(-50.0, 1.0, towards(60.0, 0.0)).unwrap();
    assert_eq!(traced.first_hit(&floor, 0.0), 1.0);
    // From far beyond the edge at the peak: the slope towards it rises from 0 at column 0 to 1 at column 1.
    let ray = relief.ray(1.0 - 100.0, 1.0, towards(100_f64.atan().to_degrees(), 180.0)).unwrap();
    assert_near(traced.first_hit(&ray, 0.0), 100.0 / 101.0, 1e-12);
}

#[test]
fn a_start_inside_the_relief_is_its_own_hit() {
    let surface = surface(&field((4, 4), (1.0, 1.0), Edge::Wrap, |column, _| f32::from(column == 2)));
    let relief = Relief::new(&surface);
    let ray = relief.ray(2.0, 0.0, towards(10.0, 0.0)).unwrap();
    assert_eq!(TracedRelief::new(&relief).first_hit(&ray, 0.125), 0.125);
}

/// A field, a direction in degrees, a place in texels.
fn scenes() -> impl Strategy<Value = (HeightField, (f64, f64), (f64, f64))> {
    let edges = prop_oneof![Just(Edge::Wrap), Just(Edge::Clamp)];
    let azimuths = prop_oneof![0.0..360.0_f64, (0_u8..8).prop_map(|k| 45.0 * f64::from(k))];
    let polars = prop_oneof![0.0..80.0_f64, 80.0..89.9_f64, Just(0.0), Just(45.0)];
    let places = || prop_oneof![-2.0..8.0_f64, (-2_i8..8).prop_map(f64::from)];
    let heights = prop::collection::vec(-2.0_f32..2.0, 30);
    let sizes = prop_oneof![Just((6, 5)), Just((5, 6)), Just((30, 1)), Just((1, 30))];
    let spacings = prop_oneof![Just((1.0, 1.0)), (0.4..2.0_f64, 0.4..2.0_f64)];
    (sizes, spacings, edges, heights, (polars, azimuths), (places(), places())).prop_map(
        |((width, height), spacing, edge, heights, direction, place)| {
            let at = |column: u32, row: u32| heights[(row * width + column) as usize];
            (field((width, height), spacing, edge, at), direction, place)
        },
    )
}

/// The least gap of a ray at evenly spread depths before `end`.
fn least_gap(surface: &Surface, ray: &barchan_shade::ReliefRay, end: f64) -> f64 {
    const STEPS: u32 = 20_000;
    let relief = Relief::new(surface);
    let depths = (0..STEPS).map(|k| end * f64::from(k) / f64::from(STEPS));
    depths.map(|depth| gap(&relief, ray, depth)).fold(f64::INFINITY, f64::min)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn a_hit_is_on_the_surface_and_everything_before_it_outside((field, direction, place) in scenes()) {
        let surface = surface(&field);
        let relief = Relief::new(&surface);
        let ray = relief.ray(place.0, place.1, towards(direction.0, direction.1)).unwrap();
        let hit = TracedRelief::new(&relief).first_hit(&ray, 0.0);
        prop_assert!((0.0..=1.0).contains(&hit));
        // The surface is as steep along a grazing ray as the ray is long.
        let tolerance = 1e-13 * (1.0 + ray.tangent());
        prop_assert!(gap(&relief, &ray, hit).abs() < tolerance, "a gap of {} at {hit}", gap(&relief, &ray, hit));
        let before = least_gap(&surface, &ray, hit);
        prop_assert!(before > -tolerance, "{before} inside before {hit}");
    }
}

#[test]
fn rays_along_texel_borders_are_walked_to_their_hit() {
    let field = field((9, 9), (1.0, 1.0), Edge::Wrap, |column, row| ((column * 5 + row * 3) % 7) as f32);
    let surface = surface(&field);
    let relief = Relief::new(&surface);
    for azimuth in 0..24 {
        for place in [(0.0, 0.0), (0.5, 3.0), (1e6, -1e6), (4.0, 1e-13), (3.0 - 1e-15, 8.0 + 1e-15)] {
            let ray = relief.ray(place.0, place.1, towards(85.0, 15.0 * f64::from(azimuth))).unwrap();
            let hit = TracedRelief::new(&relief).first_hit(&ray, 0.0);
            assert_near(gap(&relief, &ray, hit), 0.0, 1e-9);
            assert!(least_gap(&surface, &ray, hit) > -1e-9, "{azimuth} {place:?}");
        }
    }
}
