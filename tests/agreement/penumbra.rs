//! Soft shadows of discs, far and near.

use barchan_asset::{DistanceView, HorizonView, Semantic};
use barchan_field::shapes::FractalTerrain;
use barchan_field::{Edge, Shape};
use barchan_pipeline::{Table, TableEncoding};
use barchan_shade::{DiscLight, Penumbra};
use barchan_view::Probe;
use barchan_wgpu::{Sampling, Technique};

use crate::compare::agree;
use crate::support::{ENCODINGS, Loaded, SAMPLINGS, light, numbers, places, recipe};

/// How far an elevation may be off on the device, in radians: what is seen of a disc is off by that over the disc.
const ELEVATION: f64 = 4e-7;
/// What the arcsine adds.
const ARC: f64 = 2e-6;

/// Azimuths and elevations in degrees: on baked azimuths and half-way between them, about the seam, at and below the horizon.
const SUNS: [(f64, f64); 7] =
    [(0.0, 12.0), (45.0, 5.0), (22.5, 9.0), (359.99, 15.0), (-0.01, 3.0), (200.0, 0.0), (130.0, -2.0)];

fn terrain(edge: Edge, encoding: TableEncoding) -> Loaded {
    Loaded::baked(recipe(shape(), (33, 20), edge, encoding), &[Table::Height, Table::Horizon, Table::Distance])
}

fn shape() -> Shape {
    Shape::FractalTerrain(FractalTerrain { height: 12.0, hurst: 0.8, features_across: 3, octaves: 5, seed: 7 })
}

fn twin(terrain: &Loaded) -> Penumbra {
    let horizon = terrain.view(Semantic::HorizonElevation, HorizonView::new);
    Penumbra::new(&horizon, &terrain.view(Semantic::HorizonDistance, DistanceView::new)).unwrap()
}

/// A light of exactly the numbers that the GPU is given.
fn disc((azimuth, elevation): (f64, f64), degrees: f64, level_distance: f32) -> (DiscLight, Probe) {
    let towards = light(azimuth, elevation).towards;
    let angular_radius = degrees.to_radians() as f32;
    let twin = DiscLight {
        towards,
        angular_radius_radians: f64::from(angular_radius),
        level_distance: f64::from(level_distance),
    };
    let probe = Probe {
        size: (48, 40),
        place: [-9.0, -12.25],
        step: [1.125, 1.0625],
        light: towards.as_vec3().to_array(),
        angular_radius,
        level_distance,
        ..Probe::default()
    };
    (twin, probe)
}

#[test]
fn every_encoding_and_edge_sees_as_much_of_a_sun_and_of_a_lamp_as_the_twin() {
    for encoding in ENCODINGS {
        for edge in [Edge::Wrap, Edge::Clamp] {
            let terrain = terrain(edge, encoding);
            let pass = terrain.pass(&[Technique::Penumbra], Sampling::Loaded);
            let twin = twin(&terrain);
            for (degrees, level_distance) in [(0.27_f64, f32::INFINITY), (5.0, f32::INFINITY), (2.0, 7.3), (20.0, 3.1)]
            {
                let tolerance = ELEVATION / degrees.to_radians().tan() + ARC;
                let name = format!("penumbra {encoding:?} {edge:?} {degrees} {level_distance}");
                for sun in SUNS {
                    let (light, probe) = disc(sun, degrees, level_distance);
                    let found = numbers(&pass.draw(&probe).unwrap(), 0);
                    let expected: Vec<f64> =
                        places(&probe).into_iter().map(|place| twin.visibility(place, &light)).collect();
                    agree(&format!("{name} {sun:?}"), probe.size, &found, &expected, tolerance, 0.0);
                    assert!(expected.iter().any(|&seen| seen < 1.0), "{name}: something stands in the light");
                }
            }
        }
    }
}

#[test]
fn a_sampler_sees_what_its_eight_bits_of_weight_let_it() {
    // Elevations of the terrain differ by up to 0.6 rad from texel to texel, and a sampler's weights are 1/256 apart.
    let terrain = terrain(Edge::Wrap, TableEncoding::F16);
    let pass = terrain.pass(&[Technique::Penumbra], Sampling::Filtered);
    let twin = twin(&terrain);
    for sun in SUNS {
        let (light, probe) = disc(sun, 5.0, f32::INFINITY);
        let found = numbers(&pass.draw(&probe).unwrap(), 0);
        let expected: Vec<f64> = places(&probe).into_iter().map(|place| twin.visibility(place, &light)).collect();
        agree(&format!("penumbra filtered {sun:?}"), probe.size, &found, &expected, 0.02, 0.0);
    }
}

#[test]
fn beyond_an_arc_its_nearer_end_is_seen() {
    let mut recipe = recipe(shape(), (16, 16), Edge::Wrap, TableEncoding::F32);
    recipe.horizon.arc = Some((300.0, 420.0));
    let terrain = Loaded::baked(recipe, &[Table::Height, Table::Horizon, Table::Distance]);
    let twin = twin(&terrain);
    for sampling in SAMPLINGS {
        let pass = terrain.pass(&[Technique::Penumbra], sampling);
        for azimuth in [300.0, 299.0, 60.0, 61.0, 179.0, 181.0, 359.99, 10.0] {
            let (light, probe) = disc((azimuth, 4.0), 4.0, 9.0);
            let found = numbers(&pass.draw(&probe).unwrap(), 0);
            let expected: Vec<f64> = places(&probe).into_iter().map(|place| twin.visibility(place, &light)).collect();
            agree(&format!("penumbra arc {azimuth}"), probe.size, &found, &expected, 2e-5, 0.0);
        }
    }
}

#[test]
fn a_light_without_a_disc_casts_the_hard_shadow() {
    let terrain = terrain(Edge::Wrap, TableEncoding::Compact);
    let soft = terrain.pass(&[Technique::Penumbra], Sampling::Loaded);
    let hard = terrain.pass(&[Technique::HorizonShadow], Sampling::Loaded);
    for sun in SUNS {
        let (_, probe) = disc(sun, 0.0, f32::INFINITY);
        let (soft, hard) = (soft.draw(&probe).unwrap(), hard.draw(&probe).unwrap());
        // Half of a point is seen where it stands on the horizon to 10⁻⁶.
        let differ = soft.iter().zip(&hard).filter(|(soft, hard)| (1.0 - soft[0] - hard[1]).abs() > 0.5).count();
        assert_eq!(differ, 0, "{sun:?}");
    }
}
