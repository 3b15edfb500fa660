//! The occlusion of points against closed forms.

use barchan_asset::{Azimuths, DepthMode, HemisphereDirections, RingSpacing};
use barchan_field::Edge;
use barchan_shade::{
    DepthMapStart, HemisphereOcclusion, HemisphereQuadrature, MAP_TOLERANCE, Relief, ReliefRoad, ReliefShadow, Surface,
    TracedRelief,
};
use glam::DVec3;

use crate::support::{
    assert_near, cone_steps, directions, field, fractal, hemisphere, hemisphere_view, places, surface,
};

/// The traced occlusion of points on a surface, with its normals.
fn traced(surface: &Surface, quadrature: HemisphereQuadrature, places: &[(f64, f64)]) -> Vec<f64> {
    let relief = Relief::new(surface);
    let search = TracedRelief::new(&relief);
    let shadow = ReliefShadow { relief, road: ReliefRoad { depth_map: None, search: &search }, tolerance: 1e-9 };
    let occlusion = HemisphereOcclusion::of_rays(quadrature, shadow);
    let at = |&(x, y): &(f64, f64)| occlusion.at((x, y), relief.depth_at(x, y), surface.normal(x, y)).share;
    places.iter().map(at).collect()
}

fn paper() -> HemisphereDirections {
    HemisphereDirections {
        rings: 32,
        azimuths: Azimuths::full_circle(16),
        spacing: RingSpacing::EqualAngles,
        max_polar_radians: 80_f64.to_radians(),
    }
}

#[test]
fn level_ground_is_not_occluded() {
    let flat = surface(&field((4, 4), (1.0, 1.0), Edge::Wrap, |_, _| 3.0));
    assert_eq!(traced(&flat, HemisphereQuadrature::of_cells(&paper()), &[(1.0, 2.0), (0.3, 7.7)]), [0.0, 0.0]);
}

#[test]
fn before_an_endless_wall_it_is_half_of_one_minus_the_sine_of_what_is_free() {
    const HEIGHT: f32 = 6.0;
    // Under the clamp policy the wall goes on for ever along v, and its top for ever along u.
    let wall = surface(&field((64, 3), (1.0, 1.0), Edge::Clamp, |column, _| if column < 40 { 0.0 } else { HEIGHT }));
    for distance in [2.5, 6.0, 12.0, 30.0] {
        let closed = 0.5 * (1.0 - 1.0 / (1.0 + (f64::from(HEIGHT) / distance).powi(2)).sqrt());
        let found = |quadrature| traced(&wall, quadrature, &[(40.0 - distance, 1.0)])[0];
        assert_near(found(HemisphereQuadrature::even(96, 192)), closed, 0.003);
        assert_near(found(HemisphereQuadrature::of_cells(&paper())), closed, 0.02);
        assert_near(found(HemisphereQuadrature::of_rays(&paper())), closed, 0.02);
    }
}

#[test]
fn at_the_bottom_of_a_deep_well_all_is_occluded_but_straight_up() {
    let hole = |column, row| if (column, row) == (8, 8) { -1000.0 } else { 0.0 };
    let well = surface(&field((17, 17), (1.0, 1.0), Edge::Clamp, hole));
    let share = traced(&well, HemisphereQuadrature::even(64, 32), &[(8.0, 8.0)])[0];
    assert!(share > 0.999, "{share}");
}

#[test]
fn a_tilted_plane_is_not_occluded() {
    let slope = |column: u32, _| 0.7 * column as f32;
    let incline = surface(&field((64, 3), (1.0, 1.0), Edge::Clamp, slope));
    let share = traced(&incline, HemisphereQuadrature::even(32, 32), &[(31.2, 1.0)])[0];
    // Only what the incline itself hides of the sky, which its normal weighs least: it is behind that normal.
    assert_near(share, 0.0, 1e-9);
}

/// The mean and the root of the mean square of what `found` has more than `truth`.
fn excess(truth: &[f64], found: &[f64]) -> (f64, f64) {
    let of = |measure: fn(f64) -> f64| {
        truth.iter().zip(found).map(|(a, b)| measure(b - a)).sum::<f64>() / truth.len() as f64
    };
    (of(|excess| excess), of(|excess| excess * excess).sqrt())
}

#[test]
fn cells_of_a_map_are_fine_enough() {
    let surface = surface(&fractal(64));
    let places: Vec<_> = places(60, 64).collect();
    let fine = HemisphereDirections { rings: 128, azimuths: Azimuths::full_circle(64), ..paper() };
    let fine = traced(&surface, HemisphereQuadrature::of_cells(&fine), &places);
    for quadrature in [HemisphereQuadrature::of_cells(&paper()), HemisphereQuadrature::of_rays(&paper())] {
        let (_, rms) = excess(&fine, &traced(&surface, quadrature, &places));
        assert!(rms < 0.01, "{rms}");
    }
}

#[test]
fn what_stands_below_the_last_ring_alone_is_missed_and_nothing_is_made_up() {
    let surface = surface(&fractal(64));
    let places: Vec<_> = places(60, 64).collect();
    let whole = traced(&surface, HemisphereQuadrature::even(48, 96), &places);
    let (mean, rms) = excess(&whole, &traced(&surface, HemisphereQuadrature::of_cells(&paper()), &places));
    assert!(mean < 0.0 && mean > -0.03 && rms < 0.03, "{mean} {rms}");
}

#[test]
fn what_stands_on_one_side_darkens_what_faces_it() {
    let wall = surface(&field((64, 3), (1.0, 1.0), Edge::Clamp, |column, _| if column < 40 { 0.0 } else { 6.0 }));
    let relief = Relief::new(&wall);
    let search = TracedRelief::new(&relief);
    let shadow = ReliefShadow { relief, road: ReliefRoad { depth_map: None, search: &search }, tolerance: 1e-9 };
    let occlusion = HemisphereOcclusion::of_rays(HemisphereQuadrature::even(48, 48), shadow);
    let leaning = |x: f64| occlusion.at((36.0, 1.0), 1.0, DVec3::new(x, 0.0, 1.0).normalize()).share;
    assert!(leaning(0.5) > leaning(0.0) && leaning(0.0) > leaning(-0.5));
}

/// What a map alone has more than the traced occlusion of the same rays: mean and RMS.
fn excess_of_map(size: u32) -> (f64, f64) {
    let field = fractal(64);
    let surface = surface(&field);
    let relief = Relief::new(&surface);
    let places: Vec<_> = places(120, 64).collect();
    let depths = hemisphere(&field, size, DepthMode::Nearest);
    let start = DepthMapStart::new(&relief, &hemisphere_view(&depths)).unwrap();
    let occlusion = HemisphereOcclusion::of_map(&relief, &start, MAP_TOLERANCE);
    let at = |&(x, y): &(f64, f64)| occlusion.at((x, y), relief.depth_at(x, y), surface.normal(x, y)).share;
    let truth = traced(&surface, HemisphereQuadrature::of_rays(&directions()), &places);
    excess(&truth, &places.iter().map(at).collect::<Vec<_>>())
}

#[test]
fn a_map_as_fine_as_the_heights_knows_the_occlusion() {
    let (mean, rms) = excess_of_map(64);
    assert!(mean.abs() < 0.01 && rms < 0.03, "{mean} {rms}");
}

/// The least depth of a footprint is that of its highest corner, and on a slope the rest of it lies deeper.
#[test]
fn a_map_that_was_reduced_takes_slopes_for_shadows() {
    let (mean, _) = excess_of_map(16);
    assert!(mean > 0.3, "{mean}");
}

#[test]
fn rays_from_a_conservative_map_give_the_traced_occlusion_for_fewer_fetches() {
    let field = fractal(64);
    let surface = surface(&field);
    let relief = Relief::new(&surface);
    let places: Vec<_> = places(60, 64).collect();
    let depths = hemisphere(&field, 32, DepthMode::Conservative);
    let start = DepthMapStart::new(&relief, &hemisphere_view(&depths)).unwrap();
    let search = cone_steps(&field, &relief);
    let quadrature = HemisphereQuadrature::of_cells(&directions());
    let occlusion = |depth_map| {
        let road = ReliefRoad { depth_map, search: &search };
        HemisphereOcclusion::of_rays(quadrature.clone(), ReliefShadow { relief, road, tolerance: 1e-6 })
    };
    let (from_map, from_top) = (occlusion(Some(&start)), occlusion(None));
    let at = |way: &HemisphereOcclusion<'_>, &(x, y): &(f64, f64)| {
        way.at((x, y), relief.depth_at(x, y), surface.normal(x, y))
    };
    let truth = traced(&surface, quadrature.clone(), &places);
    let found: Vec<_> = places.iter().map(|place| at(&from_map, place)).collect();
    let (_, rms) = excess(&truth, &found.iter().map(|occlusion| occlusion.share).collect::<Vec<_>>());
    assert!(rms < 1e-3, "{rms}");
    let fetches = |all: u32, place| all + at(&from_top, place).fetches.total();
    let (from_map, from_top) =
        (found.iter().map(|occlusion| occlusion.fetches.total()).sum::<u32>(), places.iter().fold(0, fetches));
    assert!(from_map < from_top, "{from_map} instead of {from_top}");
}
