//! Penumbrae that can be written down, by the horizon map and by traced rays.

use std::f64::consts::PI;

use barchan_field::{Edge, HeightField};
use barchan_shade::{DiscLight, Penumbra, TracedPenumbra};
use glam::DVec3;

use crate::support::{Horizons, assert_near, field, sun, surface};

const RADIUS: f64 = 100.0;
const TEXEL: f64 = 0.125;
const WALL: f64 = 8.0;

/// A wall along v on level ground; its near edge is at `EDGE`, in texels.
const EDGE: f64 = 320.0;

fn wall() -> HeightField {
    let height = |column| if f64::from(column) < EDGE { 0.0 } else { WALL as f32 };
    field((330, 2), (TEXEL, 1.0), Edge::Clamp, |column, _| height(column))
}

/// Where the disc begins to be seen and where all of it is, in lengths from the wall, by bisection.
fn penumbra(map: &Penumbra, light_at: impl Fn(f64) -> DiscLight) -> (f64, f64) {
    let visibility = |distance: f64| map.visibility((EDGE - distance / TEXEL, 0.5), &light_at(distance));
    let farthest = |is_darker: &dyn Fn(f64) -> bool| {
        let (mut near, mut far) = (0.5, 38.0);
        for _ in 0..50 {
            let middle = 0.5 * (near + far);
            if is_darker(visibility(middle)) { near = middle } else { far = middle }
        }
        near
    };
    (farthest(&|seen| seen == 0.0), farthest(&|seen| seen < 1.0))
}

#[test]
fn the_penumbra_of_a_wall_is_as_wide_as_geometry_says() {
    let map = Horizons::baked(&wall(), 4, RADIUS).penumbra();
    for (elevation, radius) in [(30.0, 0.27), (30.0, 2.0), (20.0, 5.0), (55.0, 4.0)] {
        let light = sun(0.0, elevation, radius);
        let (dark, lit) = penumbra(&map, |_| light);
        let cot = |degrees: f64| 1.0 / degrees.to_radians().tan();
        assert_near(dark, WALL * cot(elevation + radius), 0.002);
        assert_near(lit, WALL * cot(elevation - radius), 0.002);
        let width = light.penumbra_width(WALL * cot(elevation));
        assert_near(width, WALL * (cot(elevation - radius) - cot(elevation + radius)), 1e-12);
        assert_near(lit - dark, width, 0.003 + 0.002 * width);
    }
}

#[test]
fn a_lamp_close_behind_the_wall_has_a_penumbra_as_much_wider_as_similar_triangles_say() {
    let map = Horizons::baked(&wall(), 4, RADIUS).penumbra();
    for (behind, height, radius) in [(20.0, 20.0, 0.5), (5.0, 12.0, 0.5), (40.0, 20.0, 3.0)] {
        // The same lamp from every place at a distance from the wall.
        let lamp = |distance: f64| DiscLight::near(DVec3::new(distance + behind, 0.0, height), radius);
        let (dark, lit) = penumbra(&map, lamp);
        // From here the edge cuts it in half.
        let middle = WALL * behind / (height - WALL);
        let light = lamp(middle);
        let width = light.penumbra_width(middle);
        assert!(width > 1.2 * DiscLight { level_distance: f64::INFINITY, ..light }.penumbra_width(middle));
        // Where the lowest and the highest point of the disc, as it faces that place, cast the edge on the ground.
        let (rise, away) = (radius * light.towards.x, radius * light.towards.z);
        let cast = |away: f64, height: f64| WALL * away / (height - WALL);
        let limbs = cast(behind + away, height - rise) - cast(behind - away, height + rise);
        assert_near(width, limbs, 1e-9);
        assert_near(lit - dark, width, 0.03 * width);
        assert!(dark < middle && middle < lit);
    }
}

#[test]
fn penumbrae_end_where_there_is_none() {
    let lamp = DiscLight::near(DVec3::new(10.0, 0.0, 5.0), 1.0);
    assert_eq!([lamp.penumbra_width(0.0), lamp.penumbra_width(10.0), lamp.penumbra_width(50.0)], [0.0; 3]);
    assert_eq!(sun(0.0, 30.0, 0.0).penumbra_width(7.0), 0.0);
    // What touches the ground casts no end of a shadow.
    assert_eq!(sun(0.0, 1.0, 2.0).penumbra_width(7.0), f64::INFINITY);
    assert_eq!(sun(0.0, -20.0, 2.0).penumbra_width(7.0), f64::INFINITY);
}

#[test]
fn a_straight_horizon_through_the_centre_hides_half_of_the_disc() {
    let (field, elevation) = (wall(), 40.0_f64);
    let (map, surface) = (Horizons::baked(&field, 4, RADIUS).penumbra(), surface(&field));
    let middle = (EDGE - (WALL / elevation.to_radians().tan() / TEXEL).round(), 1.0);
    let elevation = (WALL / ((EDGE - middle.0) * TEXEL)).atan().to_degrees();
    let traced = TracedPenumbra::new(&surface, RADIUS, 1000);
    for radius in [0.27, 2.0, 5.0] {
        assert_near(map.visibility(middle, &sun(0.0, elevation, radius)), 0.5, 1e-5);
        assert_near(traced.visibility(middle, &sun(0.0, elevation, radius)), 0.5, 0.01);
    }
}

#[test]
fn a_chord_cuts_off_the_segment_of_the_disc() {
    let (field, radius) = (wall(), 4.0_f64);
    let (map, surface) = (Horizons::baked(&field, 4, RADIUS).penumbra(), surface(&field));
    let traced = TracedPenumbra::new(&surface, RADIUS, 1000);
    let place = (EDGE - 80.0, 0.0);
    let horizon = (WALL / 10.0).atan().to_degrees();
    for above in [-1.5_f64, -0.9, -0.5, 0.25, 0.75, 1.0] {
        let offset = (above * radius.to_radians().tan()).atan().to_degrees();
        let light = sun(0.0, horizon + offset, radius);
        let half_angle = above.clamp(-1.0, 1.0).acos();
        let seen = 1.0 - (half_angle - half_angle.sin() * half_angle.cos()) / PI;
        assert_near(map.visibility(place, &light), seen, 1e-6);
        assert_near(traced.visibility(place, &light), seen, 0.01);
    }
}

#[test]
fn a_lamp_in_front_of_the_wall_is_seen_and_behind_it_is_not() {
    let field = wall();
    let (map, surface) = (Horizons::baked(&field, 4, RADIUS).penumbra(), surface(&field));
    let traced = TracedPenumbra::new(&surface, RADIUS, 300);
    let place = (EDGE - 80.0, 0.3);
    for (ahead, expected) in [(2.0, 1.0), (9.0, 1.0), (11.0, 0.0), (30.0, 0.0)] {
        let lamp = DiscLight::near(DVec3::new(ahead, 0.0, 3.0), 0.5);
        assert_eq!(map.visibility(place, &lamp), expected, "{ahead}");
        assert_eq!(traced.visibility(place, &lamp), expected, "{ahead}");
    }
}

#[test]
fn level_ground_hides_no_part_of_a_light_above_it() {
    let level = field((5, 4), (1.0, 2.0), Edge::Wrap, |_, _| 3.0);
    let (map, surface) = (Horizons::baked(&level, 7, RADIUS).penumbra(), surface(&level));
    let traced = TracedPenumbra::new(&surface, RADIUS, 50);
    for azimuth in (0..360).step_by(11).map(f64::from) {
        for light in [sun(azimuth, 5.01, 5.0), sun(azimuth, 40.0, 5.0), sun(azimuth, 90.0, 0.5)] {
            assert_eq!(map.visibility((1.3, 2.7), &light), 1.0);
            assert_eq!(traced.visibility((1.3, 2.7), &light), 1.0);
        }
        assert_near(map.visibility((1.3, 2.7), &sun(azimuth, 0.0, 5.0)), 0.5, 1e-12);
        let lamp = DiscLight::near(DVec3::new(4.0 * azimuth.cos(), 4.0 * azimuth.sin(), 1.0), 0.5);
        assert_eq!(map.visibility((1.3, 2.7), &lamp), 1.0);
    }
}
