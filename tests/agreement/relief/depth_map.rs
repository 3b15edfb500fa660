//! Starts out of depth maps: the cells of directions, and parts of a table.

use barchan_asset::{Azimuths, DepthMode, RingSpacing, Semantic};
use barchan_view::Probe;
use barchan_wgpu::{ReliefSearch, Sampling, Selection, TablePart, Technique};

use super::scene::{ReliefTwin, Scene};
use super::{Case, around, eye, towards};
use crate::compare::agree;
use crate::support::{Loaded, numbers, places};

const SPACINGS: [RingSpacing; 2] = [RingSpacing::EqualAngles, RingSpacing::SquaredTangents];

/// A few rays: all of them are in one cell of directions.
fn few(scene: &Scene, (polar, azimuth): (f64, f64)) -> Probe {
    Probe { size: (11, 9), step: [3.953_125, 3.765_625], ..around(scene.size, towards(polar, azimuth)) }
}

#[test]
fn every_ring_and_azimuth_starts_where_the_twin_does() {
    for mode in [DepthMode::Conservative, DepthMode::Nearest] {
        for spacing in SPACINGS {
            let scene = Scene { mode, spacing, ..Scene::noise() };
            let loaded = scene.load();
            let case =
                Case::new(&format!("cells.{mode:?}.{spacing:?}"), &loaded, ReliefSearch::MaximumMip, Sampling::Loaded);
            let polars = [1.0, 5.0, 15.9, 16.1, 31.0, 49.0, 63.0, 69.0, 76.0, 79.9, 80.1];
            // In the middles of the six cells of azimuths, and near their borders.
            let azimuths = [0.0, 29.9, 30.1, 60.0, 121.0, 180.0, 240.0, 299.0, 329.9, 330.1, 359.99];
            for turn in 0..2 * polars.len() {
                case.assert_agrees(&few(&scene, (polars[turn % 11], azimuths[(3 * turn + turn / 11) % 11])));
            }
        }
    }
}

#[test]
fn between_two_cells_either_start_leads_to_the_same_hit() {
    for spacing in SPACINGS {
        let scene = Scene { spacing, ..Scene::noise() };
        let loaded = scene.load();
        let twin = ReliefTwin::new(&loaded);
        for search in [ReliefSearch::MaximumMip, ReliefSearch::ConeSteps] {
            let pass = loaded.pass(&[Technique::Relief(search)], Sampling::Loaded);
            // On the borders of azimuths, and of rings of equal angles.
            for direction in [(25.0, 30.0), (48.0, 90.0), (64.0, 150.0), (16.0, 270.0), (80.0, 330.0)] {
                let probe = few(&scene, direction);
                let found = numbers(&pass.draw(&probe).unwrap(), 0);
                let expected = twin.find(search, &places(&probe), eye(&probe));
                let expected: Vec<f64> = expected.iter().map(|ray| ray.unwrap().1.depth).collect();
                agree("relief.between", probe.size, &found, &expected, 1e-5, 0.0);
            }
        }
    }
}

#[test]
fn beyond_an_arc_rays_start_at_the_top() {
    // Four azimuths 30° apart, from 320° through 0 to 50°.
    let azimuths = Azimuths::arc((-40_f64).to_radians(), 50_f64.to_radians(), 4);
    for mode in [DepthMode::Conservative, DepthMode::Nearest] {
        let scene = Scene { azimuths, mode, ..Scene::noise() };
        let loaded = scene.load();
        let case = Case::new(&format!("arc.{mode:?}"), &loaded, ReliefSearch::MaximumMip, Sampling::Loaded);
        for azimuth in [-55.5, -54.5, -40.0, -26.0, 0.0, 4.0, 34.0, 36.0, 50.0, 64.5, 65.5, 180.0] {
            case.assert_agrees(&few(&scene, (50.0, azimuth)));
        }
    }
}

#[test]
fn rings_that_are_not_loaded_start_at_the_top() {
    for spacing in SPACINGS {
        let scene = Scene { spacing, ..Scene::noise() };
        let part = TablePart { rings: Some(3), ..TablePart::default() };
        let loaded =
            Loaded::selected(scene.load().bytes, &Selection::everything().with_part(Semantic::HemisphereDepth, part));
        let pass = loaded.pass(&[Technique::Relief(ReliefSearch::MaximumMip)], Sampling::Loaded);
        let whole = ReliefTwin::new(&loaded);
        for polar in [3.0, 20.0, 40.0, 47.0, 78.0] {
            let probe = few(&scene, (polar, 61.0));
            let starts = numbers(&pass.draw(&probe).unwrap(), 3);
            let expected = whole.find(ReliefSearch::MaximumMip, &places(&probe), eye(&probe));
            // The third ring ends at 48° or, of squared tangents, at 63.9°.
            let is_loaded = polar < 48.0;
            let expected: Vec<f64> = expected.iter().map(|ray| if is_loaded { ray.unwrap().0 } else { 0.0 }).collect();
            agree("relief.rings", probe.size, &starts, &expected, 1e-6, 0.0);
        }
    }
}
