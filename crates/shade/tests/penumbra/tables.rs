//! How tables are read: between azimuths, over the seam, between texels; and what a file may not do.

use barchan_asset::{Azimuths, DistanceView, HorizonView, TextureTable};
use barchan_field::Edge;
use barchan_shade::{DirectionalLight, DiscLight, HorizonShadow, Penumbra, TracedPenumbra, TracedShadow};
use glam::DVec3;

use crate::common::table_grid;
use crate::support::{Horizons, assert_near, field, noise, shape, sun, surface};

const FAR: [f32; 4] = [50.0; 4];

fn single(elevation: [f32; 4], distance: [f32; 4]) -> Penumbra {
    Horizons::single(Azimuths::full_circle(4), &elevation, &distance).penumbra()
}

#[test]
fn a_light_that_is_a_point_casts_the_hard_shadow() {
    let field = shape("fractal_terrain");
    let (horizons, surface) = (Horizons::baked(&field, 16, 256.0), surface(&field));
    let (map, traced) = (horizons.penumbra(), TracedPenumbra::new(&surface, 256.0, 3));
    let mut shadows = 0;
    for (azimuth, elevation) in [(0.0, 12.0), (100.0, 25.0), (348.0, 20.0), (211.25, 8.0)] {
        let light = DirectionalLight::from_degrees(azimuth, elevation);
        let hard = HorizonShadow::new(&horizons.elevation(), &light);
        let ray = TracedShadow::new(&surface, &light, 256.0);
        for (x, y) in (0..500).map(|i| (64.0 * f64::from(noise(1, i, 0)), 64.0 * f64::from(noise(2, i, 0)))) {
            let point = DiscLight::sun(light.towards, 0.0);
            let lit = f64::from(u8::from(!hard.in_shadow(x, y)));
            assert_eq!(map.visibility((x, y), &point), lit, "{azimuth}°, {elevation}°, ({x}, {y})");
            assert_eq!(traced.visibility((x, y), &point), f64::from(u8::from(!ray.in_shadow(x, y))));
            shadows += u32::from(lit == 0.0);
        }
    }
    assert!((100..1900).contains(&shadows), "{shadows}");
}

#[test]
fn the_higher_the_light_the_more_of_it_is_seen() {
    let field = field((8, 8), (1.0, 1.5), Edge::Wrap, |column, row| 6.0 * noise(4, column, row));
    let map = Horizons::baked(&field, 8, 12.0).penumbra();
    for (x, y) in [(0.0, 0.0), (2.4, 3.9), (7.5, 7.5)] {
        for azimuth in [0.0, 33.0, 200.0] {
            let seen: Vec<f64> =
                (-900..900).map(|tenth| map.visibility((x, y), &sun(azimuth, f64::from(tenth) * 0.1, 3.0))).collect();
            assert!(seen.is_sorted(), "({x}, {y}), {azimuth}°");
            assert_eq!((seen[0], seen[1799]), (0.0, 1.0));
        }
    }
}

#[test]
fn what_is_seen_is_continuous_round_the_circle() {
    let map = single([0.1, 0.25, 0.3, 0.2], FAR);
    let seen = |azimuth: f64| map.visibility((0.0, 0.0), &sun(azimuth, 11.0, 5.0));
    let step = 0.01;
    for azimuth in (-18_000..36_000).map(|i| f64::from(i) * step) {
        // 0.15 rad of horizon a quarter turn, and 2/π of visibility a radius.
        assert_near(seen(azimuth + step), seen(azimuth), 1.3e-4);
    }
    assert_near(seen(360.0 - 1e-9), seen(0.0), 1e-9);
    assert!((seen(0.0) - seen(90.0)).abs() > 0.5);
}

#[test]
fn between_texels_and_azimuths_the_elevation_is_interpolated_and_then_the_disc_is_cut() {
    let grid = table_grid(field((2, 1), (1.0, 1.0), Edge::Clamp, |_, _| 0.0).grid());
    let elevation = [0.1_f32, 0.2, 0.3, 0.4];
    let map = Horizons::of(grid, Azimuths::full_circle(2), 100.0, &elevation, &FAR).penumbra();
    // A quarter from texel 0 to 1, half-way between the azimuths.
    let horizon = 0.225_f64;
    for (above, seen) in [(0.0, 0.5), (0.5, 0.804_498_9), (-0.5, 0.195_501_1), (1.0, 1.0)] {
        let light = sun(90.0, (horizon + (0.05_f64 * above).atan()).to_degrees(), 0.05_f64.atan().to_degrees());
        assert_near(map.visibility((0.25, 0.0), &light), seen, 1e-6);
    }
}

#[test]
fn an_arc_ends_at_both_ends() {
    let arc = Azimuths::arc(-0.5, 0.5, 3);
    let map = Horizons::single(arc, &[0.1, 0.2, 0.3], &FAR[..3]).penumbra();
    let seen = |azimuth: f64| map.visibility((0.0, 0.0), &sun(azimuth.to_degrees(), 0.2_f64.to_degrees(), 6.0));
    assert_near(seen(0.0), 0.5, 1e-6);
    assert!(seen(-0.25) > 0.5 && seen(0.25) < 0.5);
    assert_eq!([seen(-0.5), seen(0.5)], [seen(-1.5), seen(1.5)]);
}

#[test]
fn horizons_behind_a_lamp_do_not_count() {
    let lamp = |ahead: f64| DiscLight::near(DVec3::new(ahead, 0.0, 0.0), 0.1);
    let map = single([0.5; 4], [10.0, 20.0, 30.0, 40.0]);
    let seen = [5.0, 10.0, 10.5, 1000.0].map(|ahead| map.visibility((0.0, 0.0), &lamp(ahead)));
    // An edge at the lamp's own distance is behind it.
    assert_eq!(seen, [1.0, 1.0, 0.0, 0.0]);
    // Half-way between an azimuth that blocks and one that does not.
    let diagonal = DiscLight::near(DVec3::new(10.0, 10.0, 0.0), 0.1);
    assert_near(map.visibility((0.0, 0.0), &diagonal), 0.5, 1e-7);
    // The elevation of what does not block does not count: the mean of both would hide nothing.
    let steep = single([0.5, -1.0, 0.5, 0.5], [10.0, 20.0, 30.0, 40.0]);
    assert_near(steep.visibility((0.0, 0.0), &diagonal), 0.5, 1e-7);
}

#[test]
fn tables_of_different_maps_do_not_fit() {
    let four = Horizons::single(Azimuths::full_circle(4), &[0.0; 4], &FAR);
    let arc = Horizons::single(Azimuths::arc(0.0, 1.0, 4), &[0.0; 4], &FAR);
    let distance = DistanceView::new(*arc.distance.descriptor(), arc.distance.payload()).unwrap();
    let message = Penumbra::new(&four.elevation(), &distance).unwrap_err().to_string();
    assert!(message.starts_with("the distance table has another size"), "{message}");
}

#[test]
fn whatever_a_table_or_a_light_holds_the_share_is_within_0_and_1() {
    let whole = Horizons::single(Azimuths::full_circle(2), &[0.0; 2], &FAR[..2]);
    let hostile = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -1e30, 0.3];
    let with = |table: &TextureTable, first: f32, last: f32| {
        let mut payload = table.payload().to_vec();
        payload[..4].copy_from_slice(&first.to_le_bytes());
        payload.last_chunk_mut().map(|bytes: &mut [u8; 4]| *bytes = last.to_le_bytes()).unwrap();
        payload
    };
    let numbers = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, 1e300, 0.4];
    let towards = [DVec3::NAN, DVec3::ZERO, DVec3::Z, DVec3::NEG_Z, DVec3::ONE, DVec3::splat(f64::INFINITY)];
    for (first, last) in hostile.iter().flat_map(|&a| hostile.map(|b| (a, b))) {
        let (elevation, distance) = (with(&whole.elevation, first, last), with(&whole.distance, last, first));
        let elevation = HorizonView::new(*whole.elevation.descriptor(), &elevation).unwrap();
        let distance = DistanceView::new(*whole.distance.descriptor(), &distance).unwrap();
        let map = Penumbra::new(&elevation, &distance).unwrap();
        for (angular_radius_radians, level_distance) in numbers.iter().flat_map(|&a| numbers.map(|b| (a, b))) {
            for towards in towards {
                let light = DiscLight { towards, angular_radius_radians, level_distance };
                for place in [(0.0, 0.0), (0.3, -7.8), (f64::NAN, 1e15)] {
                    let seen = map.visibility(place, &light);
                    assert!((0.0..=1.0).contains(&seen), "{first} {last} {light:?} {place:?}: {seen}");
                }
            }
        }
    }
}

#[test]
fn a_lamp_at_the_place_shines_from_the_zenith() {
    let lamp = DiscLight::near(DVec3::ZERO, 1.0);
    assert_eq!((lamp.towards, lamp.level_distance), (DVec3::Z, 0.0));
    assert_eq!(single([1.0; 4], FAR).visibility((0.0, 0.0), &lamp), 1.0);
}
