//! How far the map is from traced rays, on relief of many scales.

use barchan_field::HeightField;
use barchan_shade::{DirectionalLight, DiscLight, HorizonShadow, TracedPenumbra};
use glam::DVec3;

use crate::support::{Horizons, noise, shape, sun, surface};

const RADIUS: f64 = 256.0;
const RAYS: u32 = 256;

/// A texel of the tile, and two numbers in [0, 1).
fn draw(index: u32) -> ((f64, f64), f64, f64) {
    let number = |which| f64::from(noise(which, index, 0));
    (((64.0 * number(1)).floor(), (64.0 * number(2)).floor()), number(3), number(4))
}

fn root_mean_square(errors: impl Iterator<Item = f64>) -> f64 {
    let (squares, count) = errors.fold((0.0, 0), |(sum, count), error| (sum + error * error, count + 1));
    (squares / f64::from(count)).sqrt()
}

/// Of suns of an angular radius in degrees, as far as twice that above and below the horizon of texels.
fn error_of_suns(field: &HeightField, directions: u32, radius: f64) -> f64 {
    let (horizons, surface) = (Horizons::baked(field, directions, RADIUS), surface(field));
    let (map, traced) = (horizons.penumbra(), TracedPenumbra::new(&surface, RADIUS, RAYS));
    root_mean_square((0..250).map(draw).map(|(place, around, above)| {
        let azimuth = 360.0 * around;
        let shadow = HorizonShadow::new(&horizons.elevation(), &DirectionalLight::from_degrees(azimuth, 0.0));
        let horizon = shadow.elevation_radians(place.0, place.1).to_degrees();
        let light = sun(azimuth, horizon + (4.0 * above - 2.0) * radius, radius);
        map.visibility(place, &light) - traced.visibility(place, &light)
    }))
}

/// Of lamps over ground that faces them, and of the same lamps when what is behind them hides them too.
fn errors_of_lamps(field: &HeightField, directions: u32, radius: f64) -> (f64, f64) {
    let (map, surface) = (Horizons::baked(field, directions, RADIUS).penumbra(), surface(field));
    let traced = TracedPenumbra::new(&surface, RADIUS, RAYS);
    let ground = |(x, y): (f64, f64)| surface.heights().sample(x, y);
    let errors: Vec<(f64, f64)> = (0..400)
        .map(draw)
        .filter_map(|(place, around, far)| {
            let (sin, cos) = libm::sincos(around * std::f64::consts::TAU);
            let level = 30.0 + 100.0 * far;
            let below = (place.0 + level * cos / 4.0, place.1 - level * sin / 4.0);
            let height = ground(below) + 0.2 * level + radius - ground(place);
            let lamp = DiscLight::near(DVec3::new(level * cos, level * sin, height), radius);
            // What is turned away from a lamp is dark anyway.
            if surface.normal(place.0, place.1).dot(lamp.towards) <= 0.0 {
                return None;
            }
            let truth = traced.visibility(place, &lamp);
            let endless = DiscLight { level_distance: f64::INFINITY, ..lamp };
            Some((map.visibility(place, &lamp) - truth, map.visibility(place, &endless) - truth))
        })
        .collect();
    (root_mean_square(errors.iter().map(|e| e.0)), root_mean_square(errors.iter().map(|e| e.1)))
}

#[test]
fn terrain_is_near_the_traced_truth_and_nearer_with_more_azimuths() {
    let terrain = shape("fractal_terrain");
    for (directions, radius, most) in [(16, 2.0, 0.11), (32, 2.0, 0.057), (64, 2.0, 0.031), (32, 5.0, 0.022)] {
        let error = error_of_suns(&terrain, directions, radius);
        assert!(error <= most, "{directions} azimuths, {radius}°: {error}");
    }
}

#[test]
fn dunes_are_near_the_traced_truth() {
    for (radius, most) in [(0.27, 0.19), (2.0, 0.026), (5.0, 0.011)] {
        let error = error_of_suns(&shape("dunes"), 32, radius);
        assert!(error <= most, "{radius}°: {error}");
    }
}

#[test]
fn the_distance_tells_what_stands_behind_a_lamp() {
    for (name, most) in [("fractal_terrain", 0.041), ("dunes", 0.009), ("step_wall", 0.056)] {
        let (error, without_distance) = errors_of_lamps(&shape(name), 32, 4.0);
        assert!(error <= most, "{name}: {error}");
        assert!(error < 0.5 * without_distance, "{name}: {error}, and {without_distance} without the distance");
    }
}
