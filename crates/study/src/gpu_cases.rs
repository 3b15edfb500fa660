//! What is timed on a GPU: techniques, the tables that each is given, and what it looks at.

use barchan_asset::{Encoding, Semantic};
use barchan_shade::DirectionalLight;
use barchan_view::Probe;
use barchan_wgpu::{ReliefSearch, Technique};

use crate::Setting;
use crate::gpu_files::CURVATURES;
use crate::relief_method::{Feed, Search};
use crate::relief_tables::{BISECTIONS, STEPS};
use crate::scenes::SIDE;

/// Angles of rays from the normal, in degrees.
pub(crate) const ANGLES: [f64; 2] = [35.0, 75.0];

/// The azimuth of lights and eyes: between two baked ones.
const AZIMUTH: f64 = 100.0;

/// The sun's angular radius, in degrees.
const SUN: f64 = 0.27;

/// A technique as it is timed.
pub(crate) struct Case {
    /// Its name in records.
    pub(crate) name: &'static str,
    pub(crate) setting: Setting,
    /// The first is drawn, the others are those it stands on.
    pub(crate) techniques: Vec<Technique>,
    /// What is uploaded for it.
    pub(crate) tables: Vec<Semantic>,
    pub(crate) probe: Probe,
}

/// What there is to do with a file of horizons: with one in the compact encoding all, with others horizon shadows.
pub(crate) fn of_horizons(encoding: Encoding) -> Vec<Case> {
    let light = direction(70.0);
    let lit = Probe { place: [0.25, 0.25], light, angular_radius: (SUN as f32).to_radians(), ..Probe::default() };
    let case = |name, technique: Technique, more: &[Semantic]| Case {
        name,
        setting: Setting::default().with("encoding", encoding.name()),
        techniques: vec![technique],
        tables: [technique.required(), more].concat(),
        probe: lit,
    };
    let horizon = case("horizon_shadow", Technique::HorizonShadow, &[]);
    if encoding != Encoding::Compact {
        return vec![horizon];
    }
    let curved = |points: u32, more: &[Semantic]| {
        let case = case("curved_shadow", Technique::CurvedShadow, more);
        Case { setting: case.setting.with("points", points), probe: on_a_ball(&lit), ..case }
    };
    vec![
        case("surface", Technique::Surface, &[]),
        horizon,
        curved(1, &[]),
        curved(3, &[Semantic::SweptElevation, Semantic::SweptDistance]),
        case("penumbra", Technique::Penumbra, &[]),
        case("sky", Technique::Sky, &[Semantic::BentNormal]),
        case("aperture_cone", Technique::ApertureCone, &[]),
    ]
}

/// What there is to do with relief: every search from both starts at both angles, and its shadow.
pub(crate) fn of_relief() -> Vec<Case> {
    let mut cases = Vec::new();
    for (search, feed) in
        Search::ALL.into_iter().flat_map(|search| [Feed::Top, Feed::Conservative].map(|f| (search, f)))
    {
        let technique = Technique::Relief(on_gpu(search));
        let starts = if feed == Feed::Top { &[][..] } else { &[Semantic::HemisphereDepth] };
        let tables = [technique.required(), starts].concat();
        let case = |name, angle: f64, techniques| Case {
            name,
            setting: Setting::default().with("search", search.name()).with("start", feed.name()).with("angle", angle),
            techniques,
            tables: tables.clone(),
            probe: Probe { place: [0.25, 0.25], eye: direction(angle), light: direction(55.0), ..Probe::default() },
        };
        cases.extend(ANGLES.map(|angle| case("relief", angle, vec![technique])));
        cases.push(case("relief_shadow", ANGLES[0], vec![Technique::ReliefShadow, technique]));
    }
    cases
}

/// A search with the numbers of the CPU's studies.
fn on_gpu(search: Search) -> ReliefSearch {
    let (steps, bisections) = (STEPS, BISECTIONS);
    match search {
        Search::Linear => ReliefSearch::Linear { steps, bisections },
        Search::Parallax => ReliefSearch::ParallaxOcclusion { steps },
        Search::Cones => ReliefSearch::ConeSteps,
        Search::RelaxedCones => ReliefSearch::RelaxedConeSteps { bisections },
        Search::MaximumMip => ReliefSearch::MaximumMip,
    }
}

/// So many degrees from the normal.
fn direction(angle: f64) -> [f32; 3] {
    DirectionalLight::from_degrees(AZIMUTH, 90.0 - angle).towards.as_vec3().to_array()
}

/// The texture as long as the scene, on a ball of the tightest curvature that points were chosen for.
fn on_a_ball(probe: &Probe) -> Probe {
    let side = SIDE as f32;
    let (first, second) = (side * side, CURVATURES.max as f32 * side * side);
    Probe {
        first_form: [first, 0.0, first],
        second_form: [second, 0.0, second],
        along: [[side, 0.0, 0.0], [0.0, side, 0.0]],
        ..*probe
    }
}
