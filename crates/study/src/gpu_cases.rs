//! What is timed on a GPU: techniques, the tables that each is given, and what it looks at.

use barchan_asset::{Encoding, Semantic};
use barchan_shade::DirectionalLight;
use barchan_view::Probe;
use barchan_wgpu::{ReliefSearch, Technique};

use crate::Setting;
use crate::gpu_files::CURVATURES;
use crate::relief_method::{Feed, Method, Search};
use crate::relief_tables::{BISECTIONS, STEPS};
use crate::scenes::SIDE;

/// Angles of rays from the normal, in degrees.
pub(crate) const ANGLES: [f64; 2] = [35.0, 75.0];

/// The angle of the light of relief, likewise.
const LIGHT: f64 = 55.0;

/// The azimuth of lights and eyes: between two baked ones.
const AZIMUTH: f64 = 100.0;

/// The sun's angular radius, in degrees.
const SUN: f64 = 0.27;

/// A technique as it is timed.
pub(crate) struct Case {
    /// Its name in records.
    pub(crate) name: &'static str,
    /// The first is drawn, the others are those it stands on.
    pub(crate) techniques: Vec<Technique>,
    /// What is uploaded for it.
    pub(crate) tables: Vec<Semantic>,
    /// What it looks at, and how records say it.
    pub(crate) looks: Vec<(Setting, Probe)>,
}

/// What there is to do with a file of horizons: with one in the compact encoding all, with others horizon shadows.
pub(crate) fn of_horizons(encoding: Encoding) -> Vec<Case> {
    let light = direction(70.0);
    let lit = Probe { place: [0.25, 0.25], light, angular_radius: (SUN as f32).to_radians(), ..Probe::default() };
    let setting = || Setting::default().with("encoding", encoding.name());
    let case = |name, technique: Technique, more: &[Semantic]| Case {
        name,
        techniques: vec![technique],
        tables: [technique.required(), more].concat(),
        looks: vec![(setting(), lit)],
    };
    let horizon = case("horizon_shadow", Technique::HorizonShadow, &[]);
    if encoding != Encoding::Compact {
        return vec![horizon];
    }
    let curved = |points: u32, more: &[Semantic]| {
        let looks = vec![(setting().with("points", points), on_a_ball(&lit))];
        Case { looks, ..case("curved_shadow", Technique::CurvedShadow, more) }
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

/// What there is to do with relief: these searches from both starts at both angles, and shadow at the first.
pub(crate) fn of_relief(searches: &[Search]) -> Vec<Case> {
    let starts = [(Feed::Top, &[][..]), (Feed::Conservative, &[Semantic::HemisphereDepth])];
    let methods = searches.iter().flat_map(|&search| starts.map(|(feed, table)| (Method { search, feed }, table)));
    methods.flat_map(|(method, table)| of_method(method, table)).collect()
}

/// A search from one start, which reads this table.
fn of_method(method: Method, table: &[Semantic]) -> [Case; 2] {
    let technique = Technique::Relief(on_gpu(method.search));
    let look = |angle| {
        let setting = Setting::default().with("search", method.search.name()).with("start", method.feed.name());
        let probe = Probe { place: [0.25, 0.25], eye: direction(angle), light: direction(LIGHT), ..Probe::default() };
        (setting.with("angle", angle), probe)
    };
    let case = |name, techniques, angles: &[f64]| Case {
        name,
        techniques,
        tables: [technique.required(), table].concat(),
        looks: angles.iter().map(|angle| look(*angle)).collect(),
    };
    [
        case("relief", vec![technique], &ANGLES),
        case("relief_shadow", vec![Technique::ReliefShadow, technique], &ANGLES[..1]),
    ]
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
