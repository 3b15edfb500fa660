//! Every search, from every start, on every kind of relief, in every encoding.

use barchan_asset::{DepthMode, Encoding, RingSpacing, Semantic};
use barchan_field::Edge;
use barchan_wgpu::{ReliefSearch, Sampling, Selection};

use super::scene::{Kind, ReliefTwin, Scene};
use super::{Limits, SEARCHES, around, assert_finds, assert_never_tunnels, is_exact, towards, word};
use crate::support::Loaded;

/// Polar angles and azimuths: straight down, in the middles of cells of directions, between them, along axes, and beyond the last ring.
const EYES: [(f64, f64); 6] = [(0.0, 0.0), (10.0, 60.0), (35.0, 111.0), (60.0, 180.0), (75.0, 271.0), (85.0, 350.0)];

/// Odd sizes among them, and one texel.
const SIZES: [(u32, u32); 4] = [(33, 21), (24, 40), (1, 1), (32, 32)];

/// Without the table that starts rays.
pub(super) fn from_the_top(bytes: &[u8]) -> Loaded {
    let tables = [Semantic::Height, Semantic::ConeMap, Semantic::RelaxedConeMap, Semantic::MaximumHeight];
    Loaded::selected(bytes.to_vec(), &Selection::tables(&tables))
}

/// All searches under all eyes.
fn assert_searches(name: &str, loaded: &Loaded, size: (u32, u32), sampling: Sampling, is_proven: bool) {
    for search in SEARCHES {
        for (polar, azimuth) in EYES {
            let probe = around(size, towards(polar, azimuth));
            let name = format!("{name}.{polar}");
            let depths = assert_finds(&name, loaded, (search, sampling), &probe, Limits::of(search));
            if is_exact(search) && is_proven {
                let name = format!("{name}.{}", word(search));
                assert_never_tunnels(&name, &ReliefTwin::new(loaded).relief(), &probe, &depths);
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
            let loaded = Scene { kind, size, edge, encoding, mode, spacing }.load();
            let name = format!("{kind:?}.{edge:?}.{mode:?}");
            assert_searches(&name, &loaded, size, Sampling::Loaded, mode == DepthMode::Conservative);
            if mode == DepthMode::Conservative {
                let top = from_the_top(&loaded.bytes);
                assert_searches(&format!("{kind:?}.{edge:?}.Top"), &top, size, Sampling::Loaded, true);
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
fn on_a_plane_every_search_stops_at_once() {
    assert_finds_what_the_twin_finds(Kind::Flat);
}

/// A scene of relief in which neighbours differ, in some encoding.
fn noise(encoding: Encoding) -> (Scene, Loaded) {
    let scene = Scene {
        kind: Kind::Noise,
        size: (24, 19),
        edge: Edge::Wrap,
        encoding,
        mode: DepthMode::Conservative,
        spacing: RingSpacing::SquaredTangents,
    };
    (scene, scene.load())
}

#[test]
fn every_encoding_is_decoded_as_the_twin_does() {
    for encoding in Encoding::ALL {
        let (scene, loaded) = noise(encoding);
        for search in SEARCHES {
            let probe = around(scene.size, towards(55.0, 200.0));
            assert_finds(encoding.name(), &loaded, (search, Sampling::Loaded), &probe, Limits::of(search));
        }
    }
}

#[test]
fn exact_searches_are_as_exact_by_a_sampler() {
    for encoding in Encoding::ALL {
        let (scene, loaded) = noise(encoding);
        for search in SEARCHES.into_iter().filter(|&search| is_exact(search)) {
            let probe = around(scene.size, towards(55.0, 200.0));
            // A cone that is sampled a little elsewhere is a step more or less.
            let limits = Limits { fetch_share: 0.05, ..Limits::of(search) };
            let name = format!("{}.filtered", encoding.name());
            let depths = assert_finds(&name, &loaded, (search, Sampling::Filtered), &probe, limits);
            assert_never_tunnels(&name, &ReliefTwin::new(&loaded).relief(), &probe, &depths);
        }
    }
}

#[test]
fn sampled_searches_are_off_by_what_a_sampler_rounds() {
    let scene = Scene { kind: Kind::Smooth, size: (32, 24), ..noise(Encoding::F16).0 };
    let loaded = scene.load();
    // At most 0.6 of the thickness a texel along u and v together: 1/512 of that, seen along a ray.
    let limits = Limits { depth: 4e-3, depth_share: 0.005, fetch_share: 0.2 };
    for search in SEARCHES.into_iter().filter(|&search| !is_exact(search)) {
        let probe = around(scene.size, towards(35.0, 200.0));
        assert_finds("filtered", &loaded, (search, Sampling::Filtered), &probe, limits);
    }
}

#[test]
fn the_numbers_of_steps_are_the_shaders() {
    let (scene, loaded) = noise(Encoding::F32);
    let probe = around(scene.size, towards(40.0, 20.0));
    for search in [
        ReliefSearch::Linear { steps: 7, bisections: 12 },
        ReliefSearch::Linear { steps: 1, bisections: 0 },
        ReliefSearch::ParallaxOcclusion { steps: 3 },
        ReliefSearch::RelaxedConeSteps { bisections: 0 },
    ] {
        assert_finds("steps", &loaded, (search, Sampling::Loaded), &probe, Limits::of(search));
    }
}
