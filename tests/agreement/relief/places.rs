//! Far tiles, places beside a tile, rays that graze, and mips that begin at a coarser level.

use barchan_asset::Semantic;
use barchan_field::Edge;
use barchan_view::Probe;
use barchan_wgpu::{ReliefSearch, Sampling, Selection, TablePart, Technique};

use super::scene::Scene;
use super::{Case, Limits, SEARCHES, around, is_exact, towards};
use crate::support::Loaded;

#[test]
fn far_tiles_are_found_to_the_bit() {
    let scene = Scene::noise();
    let loaded = scene.load();
    let near = around(scene.size, towards(65.0, 33.0));
    for search in SEARCHES {
        let pass = loaded.pass(&[Technique::Relief(search)], Sampling::Loaded);
        let expected = pass.draw(&near).unwrap();
        for (tiles_u, tiles_v) in [(1000.0, 0.0), (-300.0, 2000.0)] {
            let place = [near.place[0] + 24.0 * tiles_u, near.place[1] + 19.0 * tiles_v];
            assert_eq!(pass.draw(&Probe { place, ..near }).unwrap(), expected, "{search:?}");
        }
    }
}

#[test]
fn rays_enter_far_beside_a_clamped_tile() {
    let scene = Scene { edge: Edge::Clamp, ..Scene::noise() };
    let loaded = scene.load();
    for search in SEARCHES.into_iter().filter(|&search| is_exact(search)) {
        let case = Case::new("beside", &loaded, search, Sampling::Loaded);
        for azimuth in [0.0, 90.0, 180.0, 225.0, 300.0] {
            let probe = around(scene.size, towards(85.0, azimuth));
            case.assert_is_exact(&Probe { place: [-120.0, -90.0], step: [7.25, 6.5], ..probe });
        }
    }
}

#[test]
fn grazing_rays_are_followed_for_thousands_of_texels() {
    let scene = Scene::noise();
    let loaded = scene.load();
    // Ways of 460 and 4600 texels: where a ray stands is rounded to 1/4000 of a texel, and noise rises by its thickness on one.
    for (polar, depth) in [(89.0, 1e-5), (89.9, 1e-4)] {
        for search in SEARCHES.into_iter().filter(|&search| is_exact(search)) {
            let limits = Limits { depth, depth_share: 0.01, fetch_share: 0.05 };
            Case::new("grazing", &loaded, search, Sampling::Loaded)
                .within(limits)
                .assert_agrees(&around(scene.size, towards(polar, 200.0)));
        }
    }
}

#[test]
fn rays_that_do_not_come_down_are_given_up() {
    let loaded = Scene::noise().load();
    for search in SEARCHES {
        let pass = loaded.pass(&[Technique::Relief(search)], Sampling::Loaded);
        // Level, from below, and so level that the way to the floor is longer than 65536 texels.
        for eye in [[1.0, 0.0, 0.0], [0.6, 0.0, -0.8], [1.0, 0.0, 5e-5]] {
            let probe = Probe { eye, ..around((24, 19), towards(0.0, 0.0)) };
            let found = pass.draw(&probe).unwrap();
            assert!(found.iter().all(|&pixel| pixel == [-1.0, 0.0, 0.0, 0.0]), "{search:?} {eye:?}");
        }
    }
}

#[test]
fn mips_from_a_coarser_level_find_the_same() {
    let scene = Scene::noise();
    let bytes = scene.load().bytes;
    for first_level in [1, 3] {
        let part = TablePart { first_level, ..TablePart::default() };
        let selection = Selection::everything().with_part(Semantic::MaximumHeight, part);
        let loaded = Loaded::selected(bytes.clone(), &selection);
        let case = Case::new(&format!("from.{first_level}"), &loaded, ReliefSearch::MaximumMip, Sampling::Loaded);
        // Level 0 is never read; where others are missing, too, cells are looked at.
        let fetch_share = if first_level == 1 { case.limits.fetch_share } else { 1.0 };
        let limits = Limits { fetch_share, ..case.limits };
        let case = case.within(limits);
        for polar in [20.0, 60.0, 80.0] {
            case.assert_is_exact(&around(scene.size, towards(polar, 140.0)));
        }
    }
}
