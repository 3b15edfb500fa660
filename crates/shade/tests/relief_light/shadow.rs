//! Shadows by relief rays against shadows traced over the surface.

use barchan_asset::DepthMode;
use barchan_field::{Edge, HeightField};
use barchan_metrics::MaskDisagreement;
use barchan_shade::{
    DepthMapStart, DirectionalLight, LinearSearch, Relief, ReliefRoad, ReliefSearch, ReliefShadow, SHADOW_TOLERANCE,
    Surface, TracedRelief, TracedShadow,
};
use glam::DVec3;
use proptest::prelude::*;

use crate::support::{cone_steps, field, fractal, hemisphere, hemisphere_view, noise, places, surface};

/// How often a search disagrees with the traced shadow, over lights all around at some elevations, in degrees.
pub(crate) fn disagreement(
    surface: &Surface,
    road: &ReliefRoad<'_>,
    tolerance: f64,
    elevations: &[f64],
) -> MaskDisagreement {
    let relief = Relief::new(surface);
    let shadow = ReliefShadow { relief, road: *road, tolerance };
    let mut sum = MaskDisagreement::default();
    for (index, &elevation) in elevations.iter().enumerate() {
        for azimuth in 0..7_u32 {
            let azimuth = f64::from(azimuth) * 360.0 / 7.0 + 11.0 * index as f64;
            let light = DirectionalLight::from_degrees(azimuth, elevation);
            let traced = TracedShadow::new(surface, &light, f64::INFINITY);
            let places: Vec<_> = places(300, surface.heights().width()).collect();
            let truth: Vec<_> = places.iter().map(|&(x, y)| traced.in_shadow(x, y)).collect();
            let found: Vec<_> = places
                .iter()
                .map(|&(x, y)| shadow.at((x, y), relief.depth_at(x, y), light.towards).in_shadow)
                .collect();
            sum.merge(&MaskDisagreement::between(&truth, &found));
        }
    }
    sum
}

fn assert_agrees(field: &HeightField, elevations: &[f64]) {
    let surface = surface(field);
    let relief = Relief::new(&surface);
    let road = ReliefRoad { depth_map: None, search: &TracedRelief::new(&relief) };
    // Of light that grazes, rounding decides.
    let wrong = disagreement(&surface, &road, 1e-9, elevations);
    assert!(wrong.rate() < 1e-3, "{wrong:?}");
}

#[test]
fn from_above_and_from_below_the_same_points_are_dark() {
    let rough = |edge| field((24, 24), (1.0, 1.5), edge, |column, row| 4.0 * noise(3, column, row));
    assert_agrees(&rough(Edge::Wrap), &[5.0, 20.0, 45.0, 70.0]);
    assert_agrees(&rough(Edge::Clamp), &[5.0, 20.0, 45.0, 70.0]);
    assert_agrees(&fractal(64), &[5.0, 20.0, 45.0]);
}

#[test]
fn a_linear_search_and_its_tolerance_miss_little() {
    let surface = surface(&fractal(64));
    let relief = Relief::new(&surface);
    let road = ReliefRoad { depth_map: None, search: &LinearSearch::new(&relief, 256, 10) };
    let wrong = disagreement(&surface, &road, SHADOW_TOLERANCE, &[15.0, 30.0, 60.0]);
    assert!(wrong.rate() < 0.01, "{wrong:?}");
}

#[test]
fn beyond_the_tile_its_edge_policy_decides() {
    // Ground in the middle of a tile, a wall at its left edge: a light from the right sees the wall repeated, or nothing.
    let walled = |edge| field((16, 4), (1.0, 1.0), edge, |column, _| if column == 0 { 8.0 } else { 0.0 });
    let in_shadow = |edge| {
        let surface = surface(&walled(edge));
        let relief = Relief::new(&surface);
        let search = TracedRelief::new(&relief);
        let shadow = ReliefShadow { relief, road: ReliefRoad { depth_map: None, search: &search }, tolerance: 1e-9 };
        shadow.at((12.0, 1.0), 1.0, DirectionalLight::from_degrees(0.0, 30.0).towards).in_shadow
    };
    assert!(in_shadow(Edge::Wrap) && !in_shadow(Edge::Clamp));
}

/// A search that nobody may ask.
struct Unasked;

impl ReliefSearch for Unasked {
    fn name(&self) -> &'static str {
        "unasked"
    }

    fn find(&self, _: &barchan_shade::ReliefRay, _: barchan_shade::Start) -> barchan_shade::Found {
        panic!("a search was asked")
    }
}

#[test]
fn what_lies_in_the_top_plane_is_lit_without_a_search() {
    let surface = surface(&fractal(16));
    let relief = Relief::new(&surface);
    let shadow = ReliefShadow { relief, road: ReliefRoad { depth_map: None, search: &Unasked }, tolerance: 0.0 };
    let answer = shadow.at((3.0, 4.0), 0.0, DirectionalLight::from_degrees(40.0, 10.0).towards);
    assert!(!answer.in_shadow && answer.fetches.total() == 0);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn light_that_does_not_come_from_above_reaches_nothing(
        (x, y) in (-20.0..40.0, -20.0..40.0), azimuth in 0.0..360.0, elevation in -90.0..=0.0_f64
    ) {
        let surface = surface(&field((5, 5), (1.0, 1.0), Edge::Wrap, |column, row| noise(1, column, row)));
        let relief = Relief::new(&surface);
        let shadow = ReliefShadow { relief, road: ReliefRoad { depth_map: None, search: &Unasked }, tolerance: 0.0 };
        // Of the horizon itself rounding makes this or that; it is dark either way.
        let towards = DirectionalLight::from_degrees(azimuth, elevation).towards;
        let answer = shadow.at((x, y), 0.5, towards.min(DVec3::new(1.0, 1.0, 0.0)));
        prop_assert!(answer.in_shadow);
    }
}

/// The default: starts that are proven, then cone steps. No search of it goes wrong, so what is left is the tolerance.
#[test]
fn cone_steps_from_a_conservative_map_shade_what_is_traced_dark() {
    for field in [fractal(64), field((48, 48), (1.0, 1.0), Edge::Wrap, |column, row| 9.0 * noise(8, column, row))] {
        let surface = surface(&field);
        let relief = Relief::new(&surface);
        let depths = hemisphere(&field, 16, DepthMode::Conservative);
        let start = DepthMapStart::new(&relief, &hemisphere_view(&depths)).unwrap();
        let search = cone_steps(&field, &relief);
        let road = ReliefRoad { depth_map: Some(&start), search: &search };
        let wrong = disagreement(&surface, &road, SHADOW_TOLERANCE, &[15.0, 30.0, 45.0, 70.0]);
        assert!(wrong.rate() < 0.002 && wrong.false_shadow == 0, "{wrong:?}");
    }
}

#[test]
fn starts_that_are_not_proven_cost_some_shadows() {
    let field = fractal(64);
    let surface = surface(&field);
    let relief = Relief::new(&surface);
    let depths = hemisphere(&field, 16, DepthMode::Nearest);
    let start = DepthMapStart::new(&relief, &hemisphere_view(&depths)).unwrap();
    let road = ReliefRoad { depth_map: Some(&start), search: &LinearSearch::new(&relief, 64, 10) };
    let wrong = disagreement(&surface, &road, SHADOW_TOLERANCE, &[15.0, 30.0, 45.0, 70.0]);
    assert!(wrong.rate() < 0.02, "{wrong:?}");
}

#[test]
fn what_a_conservative_start_proves_lit_costs_one_fetch() {
    // A post here and there on level ground.
    let post = |column: u32, row: u32| if (column % 32, row % 32) == (16, 16) { 5.0 } else { 0.0 };
    let field = field((64, 64), (1.0, 1.0), Edge::Wrap, post);
    let surface = surface(&field);
    let relief = Relief::new(&surface);
    let depths = hemisphere(&field, 64, DepthMode::Conservative);
    let start = DepthMapStart::new(&relief, &hemisphere_view(&depths)).unwrap();
    let search = cone_steps(&field, &relief);
    let road = ReliefRoad { depth_map: Some(&start), search: &search };
    // Bytes are rounded down by less than that.
    let shadow = ReliefShadow { relief, road, tolerance: 1.0 / 255.0 };
    let towards = DirectionalLight::from_degrees(70.0, 60.0).towards;
    let answers: Vec<_> = places(500, 64).map(|(x, y)| shadow.at((x, y), relief.depth_at(x, y), towards)).collect();
    let proven = answers.iter().filter(|answer| !answer.in_shadow && answer.fetches.total() == 1).count();
    assert!(proven > 450, "{proven} of {}", answers.len());
}
