//! Shadows of relief, of points that an eye sees.

use barchan_asset::Encoding;
use barchan_field::Edge;
use barchan_shade::{ReliefRoad, ReliefShadow, SHADOW_TOLERANCE};
use barchan_view::Probe;
use barchan_wgpu::{ReliefSearch, Sampling, Technique};

use super::scene::{Kind, ReliefTwin, Scene};
use super::{SEARCHES, around, eye, towards, word};
use crate::compare::agree;
use crate::support::{Loaded, numbers, places};

/// Draws which of the points that an eye sees are dark under a light; all but a share as by the twin.
#[track_caller]
fn assert_shadows(name: &str, loaded: &Loaded, search: ReliefSearch, probe: &Probe, share: f64) {
    let twin = ReliefTwin::new(loaded);
    let (starts, twin_search, relief) = (twin.starts(), twin.search(search), twin.relief());
    let road = ReliefRoad { depth_map: starts.as_ref(), search: twin_search.as_ref() };
    let shadow = ReliefShadow { relief, road, tolerance: f64::from(probe.tolerance) };
    let light = glam::DVec3::from_array(probe.light.map(f64::from));
    let is_dark = |(x, y): (f64, f64)| {
        let ray = relief.ray(x, y, eye(probe)).unwrap();
        let depth = road.find(&ray).depth;
        f64::from(u8::from(shadow.at(ray.at(depth), depth, light).in_shadow))
    };
    let expected: Vec<f64> = places(probe).into_iter().map(is_dark).collect();
    let pass = loaded.pass(&[Technique::ReliefShadow, Technique::Relief(search)], Sampling::Loaded);
    let found = numbers(&pass.draw(probe).unwrap(), 1);
    let name = format!("relief_shadow.{name}.{}.{:.4}", word(search), probe.light[2]);
    agree(&name, probe.size, &found, &expected, 0.0, share);
}

/// A light of an azimuth and an elevation in degrees.
fn light(azimuth: f64, elevation: f64) -> [f32; 3] {
    towards(90.0 - elevation, azimuth).as_vec3().to_array()
}

fn scene(kind: Kind, edge: Edge) -> Scene {
    Scene { kind, edge, encoding: Encoding::Compact, ..Scene::noise() }
}

#[test]
fn the_same_points_are_dark() {
    for kind in [Kind::Smooth, Kind::Cobbles, Kind::Walls, Kind::Noise] {
        for edge in [Edge::Wrap, Edge::Clamp] {
            let scene = scene(kind, edge);
            let loaded = scene.load();
            for (azimuth, elevation) in [(200.0, 3.0), (91.0, 20.0), (310.0, 50.0)] {
                let probe = Probe {
                    light: light(azimuth, elevation),
                    tolerance: SHADOW_TOLERANCE as f32,
                    ..around(scene.size, towards(30.0, 111.0))
                };
                // Points that graze an edge, as seen from the light.
                assert_shadows(&format!("{kind:?}.{edge:?}"), &loaded, ReliefSearch::MaximumMip, &probe, 0.005);
            }
        }
    }
}

#[test]
fn by_every_search() {
    let scene = scene(Kind::Cobbles, Edge::Wrap);
    let loaded = scene.load();
    for search in SEARCHES {
        for tolerance in [SHADOW_TOLERANCE as f32, 0.25] {
            let probe = Probe { light: light(33.0, 25.0), tolerance, ..around(scene.size, towards(30.0, 111.0)) };
            assert_shadows("searches", &loaded, search, &probe, 0.01);
        }
    }
}

#[test]
fn a_light_at_the_horizon_or_below_reaches_nothing() {
    let loaded = scene(Kind::Cobbles, Edge::Wrap).load();
    let techniques = [Technique::ReliefShadow, Technique::Relief(ReliefSearch::MaximumMip)];
    let pass = loaded.pass(&techniques, Sampling::Loaded);
    for elevation in [0.0, -10.0, -90.0] {
        let mut light = light(70.0, elevation);
        light[2] = light[2].min(0.0);
        let probe = Probe { light, ..around((24, 19), towards(30.0, 111.0)) };
        assert!(numbers(&pass.draw(&probe).unwrap(), 1).iter().all(|&dark| dark == 1.0), "{elevation}");
    }
}

#[test]
fn a_light_at_the_zenith_reaches_everything() {
    let scene = scene(Kind::Noise, Edge::Wrap);
    let loaded = scene.load();
    let techniques = [Technique::ReliefShadow, Technique::Relief(ReliefSearch::MaximumMip)];
    let pass = loaded.pass(&techniques, Sampling::Loaded);
    let probe = Probe { tolerance: SHADOW_TOLERANCE as f32, ..around(scene.size, towards(30.0, 111.0)) };
    assert!(numbers(&pass.draw(&probe).unwrap(), 1).iter().all(|&dark| dark == 0.0));
}
