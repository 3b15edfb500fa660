//! Every search, from every start, on every kind of relief, in every encoding.

use barchan_asset::{Azimuths, DepthMode, Encoding, RingSpacing, Semantic};
use barchan_field::Edge;
use barchan_wgpu::{ReliefSearch, Sampling, Selection};

use super::scene::{Kind, Scene};
use super::{Case, Limits, SEARCHES, around, is_exact, towards};
use crate::support::Loaded;

/// Polar angles and azimuths: straight down, in the middles of cells of directions, between them, along axes, and beyond the last ring.
const EYES: [(f64, f64); 6] = [(0.0, 0.0), (10.0, 60.0), (35.0, 111.0), (60.0, 180.0), (75.0, 271.0), (85.0, 350.0)];

/// Odd sizes among them, and one texel.
const SIZES: [(u32, u32); 4] = [(33, 21), (24, 40), (1, 1), (32, 32)];

/// All searches under all eyes.
fn assert_searches(name: &str, loaded: &Loaded, size: (u32, u32), is_proven: bool) {
    for search in SEARCHES {
        let case = Case::new(name, loaded, search, Sampling::Loaded);
        for (polar, azimuth) in EYES {
            let probe = around(size, towards(polar, azimuth));
            if is_exact(search) && is_proven {
                case.assert_is_exact(&probe);
            } else {
                case.assert_agrees(&probe);
            }
        }
    }
}

/// Two edges, three starts; sizes, encodings and rings in turn.
fn assert_finds_what_the_twin_finds(kind: Kind) {
    for (index, edge) in [Edge::Wrap, Edge::Clamp].into_iter().enumerate() {
        let turn = kind as usize + index;
        let spacing = [RingSpacing::EqualAngles, RingSpacing::SquaredTangents][turn % 2];
        let (size, encoding) = (SIZES[turn % 4], Encoding::ALL[(turn + kind as usize / 4) % 4]);
        for mode in [DepthMode::Conservative, DepthMode::Nearest] {
            let is_proven = mode == DepthMode::Conservative;
            let scene = Scene { kind, size, edge, encoding, mode, spacing, azimuths: Azimuths::full_circle(6) };
            let loaded = scene.load();
            assert_searches(&format!("{kind:?}.{edge:?}.{mode:?}"), &loaded, size, is_proven);
            if is_proven {
                let tables = [Semantic::Height, Semantic::ConeMap, Semantic::RelaxedConeMap, Semantic::MaximumHeight];
                let top = Loaded::selected(loaded.bytes, &Selection::tables(&tables));
                assert_searches(&format!("{kind:?}.{edge:?}.top"), &top, size, true);
            }
        }
    }
}

#[test]
fn on_smooth_relief_every_search_finds_what_its_twin_finds() {
    assert_finds_what_the_twin_finds(Kind::Smooth);
}

#[test]
fn on_cobbles_every_search_finds_what_its_twin_finds() {
    assert_finds_what_the_twin_finds(Kind::Cobbles);
}

#[test]
fn on_spikes_every_search_finds_what_its_twin_finds() {
    assert_finds_what_the_twin_finds(Kind::Spikes);
}

#[test]
fn on_walls_every_search_finds_what_its_twin_finds() {
    assert_finds_what_the_twin_finds(Kind::Walls);
}

#[test]
fn on_noise_every_search_finds_what_its_twin_finds() {
    assert_finds_what_the_twin_finds(Kind::Noise);
}

#[test]
fn on_a_plane_every_search_finds_the_top() {
    assert_finds_what_the_twin_finds(Kind::Flat);
}

#[test]
fn every_encoding_is_decoded_as_the_twin_does() {
    for encoding in Encoding::ALL {
        let scene = Scene { encoding, ..Scene::noise() };
        let loaded = scene.load();
        for search in SEARCHES {
            Case::new(encoding.name(), &loaded, search, Sampling::Loaded)
                .assert_agrees(&around(scene.size, towards(55.0, 200.0)));
        }
    }
}

#[test]
fn exact_searches_are_as_exact_by_a_sampler() {
    for encoding in Encoding::ALL {
        let scene = Scene { encoding, ..Scene::noise() };
        let loaded = scene.load();
        for search in SEARCHES.into_iter().filter(|&search| is_exact(search)) {
            // A cone that is sampled a little elsewhere is a step more or less.
            let limits = Limits { fetch_share: 0.05, ..Limits::of(search) };
            Case::new(&format!("{}.filtered", encoding.name()), &loaded, search, Sampling::Filtered)
                .within(limits)
                .assert_is_exact(&around(scene.size, towards(55.0, 200.0)));
        }
    }
}

#[test]
fn other_searches_are_off_by_what_a_sampler_rounds() {
    let scene = Scene { kind: Kind::Smooth, size: (32, 24), encoding: Encoding::F16, ..Scene::noise() };
    let loaded = scene.load();
    // It rises by 0.6 of its thickness a texel along u and v together at most: 1/512 of that, seen along a ray.
    let limits = Limits { depth: 4e-3, depth_share: 0.005, fetch_share: 0.2 };
    for search in SEARCHES.into_iter().filter(|&search| !is_exact(search)) {
        Case::new("filtered", &loaded, search, Sampling::Filtered)
            .within(limits)
            .assert_agrees(&around(scene.size, towards(35.0, 200.0)));
    }
}

#[test]
fn the_numbers_of_steps_and_halvings_are_the_shaders() {
    let scene = Scene::noise();
    let loaded = scene.load();
    for search in [
        ReliefSearch::Linear { steps: 7, bisections: 12 },
        ReliefSearch::Linear { steps: 1, bisections: 0 },
        ReliefSearch::ParallaxOcclusion { steps: 3 },
        ReliefSearch::RelaxedConeSteps { bisections: 0 },
    ] {
        Case::new("steps", &loaded, search, Sampling::Loaded).assert_agrees(&around(scene.size, towards(40.0, 20.0)));
    }
}
