//! Which points are kept, and what they are worth to a run time.

use barchan_bakers::swept::reference::CurvedReference;
use barchan_bakers::swept::{
    CandidateLayer, CurvatureRange, HorizonCandidate, MAX_POINTS, Nodes, PointLayerMut, SelectionErrors,
    losses_by_count, measure_band, select, select_band,
};
use barchan_shade::curved_horizon;
use proptest::prelude::*;

use crate::support::{assert_near, bends, candidates, params, stored, terrain, texels};

const BOTH: CurvatureRange = CurvatureRange { min: -0.015, max: 0.015 };
const CONVEX: CurvatureRange = CurvatureRange { min: 0.0, max: 0.015 };

fn candidate(slope: f32, distance: f32) -> HorizonCandidate {
    HorizonCandidate { slope, distance }
}

/// The angle, in degrees, between the horizon of some points and of all candidates.
fn loss_degrees(points: &[HorizonCandidate], all: &[HorizonCandidate], curvature: f64, height: f32) -> f64 {
    let horizon = |points| curved_horizon(&stored(points), curvature, f64::from(height)).atan().to_degrees();
    horizon(all) - horizon(points)
}

#[test]
fn one_point_is_the_papers_table() {
    let nodes = Nodes::recommended(&BOTH, 100.0);
    let found = [candidate(0.1, 90.0), candidate(0.05, 3.0), candidate(0.0, 100.0)];
    let mut kept = [candidate(9.0, 9.0)];
    assert!(select(&found, 1.0, &nodes, &mut kept) > 0.1);
    assert_eq!(kept, [found[0]]);
}

#[test]
fn a_missing_point_is_made_up_by_repeating_the_last() {
    let nodes = Nodes::recommended(&CONVEX, 100.0);
    let mut kept = [HorizonCandidate::default(); 4];
    let (far, near, useless) = (candidate(0.1, 90.0), candidate(0.05, 3.0), candidate(-3.0, 50.0));
    assert_eq!(select(&[far, far, useless, near, near], 0.0, &nodes, &mut kept), 0.0);
    assert_eq!(kept, [far, near, near, near]);
    assert_eq!(select(&[far], 0.0, &nodes, &mut kept), 0.0);
    assert_eq!(kept, [far; 4]);
}

#[test]
fn what_the_smooth_surface_hides_is_not_stored() {
    let nodes = Nodes::recommended(&CurvatureRange { min: 0.01, max: 0.015 }, 100.0);
    // Lower than the geometric horizon at any curvature of the range, but not than each other.
    let found = [candidate(-0.2, 90.0), candidate(-0.5, 10.0)];
    let mut kept = [HorizonCandidate::default(); 2];
    assert_eq!(select(&found, 4.0, &nodes, &mut kept), 0.0);
    assert_eq!(kept, [found[0]; 2]);
}

#[test]
fn every_bend_finds_the_highest_candidate_of_its_own_bend() {
    let (terrain, params) = (terrain(), params(16, 40.0));
    let nodes = Nodes::recommended(&BOTH, params.radius);
    let bent = bends(&terrain, &params, 3, &nodes);
    for texel in texels() {
        let points: Vec<_> = bent.iter().map(|bent| bent.point(texel.0, texel.1)).collect();
        assert!(points.iter().all(|point| (0.0..=params.radius).contains(&point.distance)));
        for (own, &bend) in points.iter().zip(nodes.bends()) {
            let highest = points.iter().map(|point| point.slope - bend * point.distance).fold(f64::MIN, f64::max);
            assert_near(own.slope - bend * own.distance, highest, 1e-12);
        }
    }
}

#[test]
fn the_error_never_grows_with_the_points_and_ends_at_none() {
    let (terrain, params) = (terrain(), params(16, 40.0));
    for range in [BOTH, CONVEX] {
        let nodes = Nodes::recommended(&range, params.radius);
        let bent = bends(&terrain, &params, 3, &nodes);
        for texel in texels() {
            let found = candidates(&bent, texel);
            let height = terrain.texel(i64::from(texel.0), i64::from(texel.1));
            let losses = losses_by_count(&found, height, &nodes);
            assert!(losses.is_sorted_by(|a, b| a >= b) && losses[MAX_POINTS - 1] == 0.0, "{losses:?}");
            for points in 1..=MAX_POINTS {
                let mut kept = vec![HorizonCandidate::default(); points];
                assert_eq!(select(&found, height, &nodes, &mut kept), losses[points - 1]);
                assert_eq!(kept[0], found[0]);
                // At the ends of the range, which are judged at, the run time loses no more than was said.
                for curvature in [range.min, range.max] {
                    let lost = loss_degrees(&kept, &found, curvature, height);
                    assert!(lost <= f64::from(losses[points - 1]).atan().to_degrees() + 1e-3, "{lost} {losses:?}");
                }
            }
        }
    }
}

#[test]
fn any_number_of_leading_layers_is_a_table() {
    let (terrain, params) = (terrain(), params(16, 40.0));
    let nodes = Nodes::recommended(&BOTH, params.radius);
    let bent = bends(&terrain, &params, 5, &nodes);
    for texel in texels() {
        let found = candidates(&bent, texel);
        let height = terrain.texel(i64::from(texel.0), i64::from(texel.1));
        let mut kept = [HorizonCandidate::default(); 4];
        select(&found, height, &nodes, &mut kept);
        for curvature in [-0.015, -0.006, -0.001, 0.0, 0.001, 0.006, 0.015] {
            let lost = [1, 2, 3, 4].map(|points| loss_degrees(&kept[..points], &found, curvature, height));
            assert!(lost.is_sorted_by(|a, b| a >= b) && lost[3] >= -1e-9, "{lost:?}");
        }
    }
}

#[test]
fn three_points_come_near_the_truth_and_never_above_it() {
    let (terrain, params) = (terrain(), params(16, 40.0));
    let nodes = Nodes::recommended(&BOTH, params.radius);
    let bent = bends(&terrain, &params, 3, &nodes);
    for curvature in [-0.015, -0.004, 0.0, 0.004, 0.015] {
        let truth = CurvedReference::new(&terrain, &params, 3, curvature);
        let (mut flat, mut swept, mut count) = (0.0, 0.0, 0.0);
        for texel in texels() {
            let height = terrain.texel(i64::from(texel.0), i64::from(texel.1));
            let mut kept = [HorizonCandidate::default(); 3];
            select(&candidates(&bent, texel), height, &nodes, &mut kept);
            let expected = truth.horizon(texel.0, texel.1).slope.atan().to_degrees();
            let error = |points: &[HorizonCandidate]| {
                curved_horizon(&stored(points), curvature, f64::from(height)).atan().to_degrees() - expected
            };
            assert!(error(&kept) <= 1e-4, "{} above the truth", error(&kept));
            flat += error(&kept[..1]).powi(2);
            swept += error(&kept).powi(2);
            count += 1.0;
        }
        let (flat, swept) = ((flat / count).sqrt(), (swept / count).sqrt());
        assert!(swept < 0.5 && (curvature == 0.0 || flat > 8.0 * swept), "κ {curvature}: {flat}° {swept}°");
    }
}

#[test]
fn bands_may_be_cut_anywhere() {
    let (terrain, params) = (terrain(), params(16, 40.0));
    let nodes = Nodes::recommended(&BOTH, params.radius);
    let bent = bends(&terrain, &params, 3, &nodes);
    let found: Vec<_> = texels().map(|texel| candidates(&bent, texel)).collect();
    let heights: Vec<_> = texels().map(|(c, r)| terrain.texel(i64::from(c), i64::from(r))).collect();
    let layers: Vec<(Vec<f32>, Vec<f32>)> = (0..bent.len())
        .map(|bend| found.iter().map(|found| (found[bend].slope, found[bend].distance)).unzip())
        .collect();
    let cut = |pieces: usize| {
        let (mut tables, mut errors) = (vec![(vec![0.0; heights.len()], vec![0.0; heights.len()]); 3], vec![]);
        for start in (0..heights.len()).step_by(pieces) {
            let band = start..(start + pieces).min(heights.len());
            let views: Vec<_> = layers
                .iter()
                .map(|(slope, distance)| CandidateLayer {
                    slope: &slope[band.clone()],
                    distance: &distance[band.clone()],
                })
                .collect();
            let mut places: Vec<_> = tables
                .iter_mut()
                .map(|(slope, distance)| PointLayerMut {
                    slope: &mut slope[band.clone()],
                    distance: &mut distance[band.clone()],
                })
                .collect();
            select_band(&nodes, &heights[band.clone()], &views, &mut places);
            let mut counted = SelectionErrors::default();
            measure_band(&nodes, &heights[band], &views, &mut counted);
            errors.push(counted);
        }
        let mut merged = SelectionErrors::default();
        errors.iter().rev().for_each(|counted| merged.merge(counted));
        (tables, merged)
    };
    let whole = cut(heights.len());
    assert_eq!(cut(1), whole);
    assert_eq!(cut(7), whole);
    assert_eq!(whole.0[0], layers[0]);
    let errors = whole.1;
    let (loose, tight) = (errors.points_for(10.0), errors.points_for(0.1));
    assert!(loose < tight && errors.percentile_degrees(tight) <= 0.1 && errors.percentile_degrees(tight - 1) > 0.1);
}

proptest! {
    #[test]
    fn nothing_in_is_too_extreme(
        found in prop::collection::vec(
            (prop_oneof![-1e8_f32..1e8, -1.0_f32..1.0, Just(f32::MAX), Just(f32::MIN)],
             prop_oneof![Just(0.0_f32), 0.0_f32..200.0, Just(1e30_f32)]),
            1..=MAX_POINTS,
        ),
        height in prop_oneof![Just(0.0_f32), -1e5_f32..1e5, -100.0_f32..100.0],
        range in prop_oneof![
            Just((0.0, 0.0)), Just((-0.0, 0.0)), Just((-1e-30, 1e-30)), Just((1.0, 1.0)), Just((-0.5, -0.01)),
            Just((-0.015, 1.0)),
        ],
        points in 1..=MAX_POINTS,
    ) {
        let found: Vec<_> = found.into_iter().map(|(slope, distance)| candidate(slope, distance)).collect();
        let nodes = Nodes::recommended(&CurvatureRange { min: range.0, max: range.1 }, 200.0);
        let mut kept = vec![candidate(f32::NAN, f32::NAN); points];
        let loss = select(&found, height, &nodes, &mut kept);
        prop_assert!(loss >= 0.0 && loss.is_finite());
        prop_assert_eq!(kept[0], found[0]);
        prop_assert!(kept.iter().all(|kept| found.contains(kept)));
        let same = select(&found, height, &nodes, &mut kept);
        prop_assert_eq!(same, loss);
    }
}
