//! What the equations for curved surfaces promise, against points placed on a circle by hand.

use std::f64::consts::{FRAC_PI_2, PI};

use barchan_shade::{
    CLOSED, Correction, NO_HORIZON, StoredPoint, curved_horizon, geometric_horizon, geometric_horizon_as_printed,
    paper_horizon,
};
use proptest::prelude::*;

fn point(slope: f64, distance: f64) -> StoredPoint {
    StoredPoint { slope, distance }
}

/// The slope by construction: both ends are placed on their normals of a circle of radius 1/κ. A concave circle has a
/// negative radius and turns the other way, which needs no other formula.
fn constructed(point: StoredPoint, curvature: f64, height: f64) -> f64 {
    let radius = 1.0 / curvature;
    let (sin, cos) = (point.distance / radius).sin_cos();
    let reach = radius + height + point.slope * point.distance;
    (reach * cos - (radius + height)) / (reach * sin)
}

#[track_caller]
fn assert_near(found: f64, expected: f64, relative: f64) {
    assert!((found - expected).abs() <= relative * (1.0 + expected.abs()), "{found} instead of {expected}");
}

proptest! {
    #[test]
    fn the_exact_form_is_the_construction(
        radius in 1.0_f64..1e4, concave: bool, turn in 0.001_f64..1.5, height in -0.9_f64..0.9, rise in -0.9_f64..3.0,
    ) {
        let curvature = if concave { -1.0 / radius } else { 1.0 / radius };
        let height = radius * if concave { height.min(0.5) } else { height };
        // Room is left up to the centre: below it for convex, above it for concave.
        let room = radius + height * curvature.signum();
        let rise = if concave { room * rise.min(0.9) } else { room * rise };
        let distance = radius * turn;
        let point = point(rise / distance, distance);
        let found = Correction::Exact.slope(point, curvature, height);
        assert_near(found, constructed(point, curvature, height), 1e-10);
    }

    #[test]
    fn every_answer_is_a_number(
        slope in prop_oneof![-1e8_f64..1e8, -2.0_f64..2.0], distance in prop_oneof![Just(0.0), 0.0_f64..1e6],
        curvature in prop_oneof![Just(0.0), Just(-0.0), Just(1e-300), Just(-1e-300), -1.0_f64..1.0, -1e-9_f64..1e-9],
        height in prop_oneof![Just(0.0), -1e5_f64..1e5],
    ) {
        for correction in Correction::ALL {
            prop_assert!(correction.slope(point(slope, distance), curvature, height).is_finite());
        }
        let horizon = curved_horizon(&[point(slope, distance)], curvature, height);
        prop_assert!((NO_HORIZON..=CLOSED).contains(&horizon));
    }

    #[test]
    fn more_points_only_raise_the_horizon(
        points in prop::collection::vec((-3.0_f64..3.0, 0.0_f64..200.0), 1..6), curvature in -0.015_f64..0.015,
    ) {
        let points: Vec<_> = points.into_iter().map(|(slope, distance)| point(slope, distance)).collect();
        let leading = (1..=points.len()).map(|count| &points[..count]);
        let horizons: Vec<_> = leading.map(|points| curved_horizon(points, curvature, 4.0)).collect();
        prop_assert!(horizons.is_sorted(), "{horizons:?}");
    }
}

#[test]
fn a_steep_point_at_the_end_of_a_quarter_radian_is_the_one_of_the_checklist() {
    let slope = |correction: Correction| correction.slope(point(1.0, 16.0), 0.015, 4.0);
    assert_near(slope(Correction::Exact), 0.656, 5e-4);
    assert_near(slope(Correction::FullAsPrinted), 0.805, 5e-4);
    assert_near(slope(Correction::Paper), 0.82, 1e-15);
    assert_near(slope(Correction::Flat), 1.0, 0.0);
}

#[test]
fn a_vanishing_curvature_changes_nothing_and_has_no_seam() {
    for curvature in [0.0, -0.0, 1e-300, -1e-300, 1e-20, -1e-20] {
        for point in [point(0.7, 0.0), point(0.7, 100.0), point(-0.2, 1e5)] {
            assert_near(Correction::Exact.slope(point, curvature, 5.0), point.slope, 1e-13);
        }
    }
    // Across the switch to the series, γ = 1e-4, neighbours stay neighbours.
    let slope = |curvature: f64| Correction::Exact.slope(point(0.5, 1.0), curvature, 0.0);
    for curvature in [1e-4_f64, -1e-4, 2e-4, -2e-4] {
        assert_near(slope(curvature), slope(curvature * (1.0 - 1e-12)), 1e-14);
    }
}

#[test]
fn only_a_convex_surface_goes_on_to_its_own_horizon() {
    // From a peak that sees nothing but what is lower, within its search radius.
    let horizon = |curvature| curved_horizon(&[point(-0.2, 100.0)], curvature, 5.0);
    assert_eq!(horizon(0.0), -0.2);
    assert_near(horizon(-1e-20), -0.2, 1e-13);
    assert_near(horizon(1e-20), -(1e-19_f64.sqrt()), 1e-13);
}

#[test]
fn the_limit_at_the_texel_itself_is_its_slope_over_a_longer_arc() {
    assert_eq!(Correction::Exact.slope(point(0.6, 0.0), 0.05, 4.0), 0.5);
}

#[test]
fn coarse_inputs_are_as_good_as_their_own_rounding() {
    let (slope, distance, height) = (f64::from(0.7_f32), f64::from(33.3_f32), f64::from(2.1_f32));
    for curvature in [0.015_f32, -0.015, 1e-6, -1e-6] {
        let curvature = f64::from(curvature);
        let expected = constructed(point(slope, distance), curvature, height);
        // The construction cancels for the large circles, the form under test does not.
        assert_near(Correction::Exact.slope(point(slope, distance), curvature, height), expected, 1e-9);
    }
}

#[test]
fn a_point_beyond_the_quarter_circle_is_no_horizon_of_a_convex_surface() {
    let curvature = 0.01;
    for distance in [100.0 * FRAC_PI_2, 100.0 * PI, 1e4] {
        assert_eq!(Correction::Exact.slope(point(3.0, distance), curvature, 4.0), NO_HORIZON);
        assert_eq!(curved_horizon(&[point(3.0, distance)], curvature, 4.0), geometric_horizon(curvature, 4.0));
    }
}

#[test]
fn what_the_guard_drops_is_below_the_smooth_surface() {
    // As high as the guard's argument allows: (√2 − 1)/κ.
    let highest = std::f64::consts::SQRT_2 - 1.0;
    for height in [0.0, 0.1, 0.2, highest] {
        for turn in [FRAC_PI_2, 1.8, 2.5, 3.1] {
            let dropped = constructed(point((highest - height) / turn, turn), 1.0, height);
            assert!(dropped <= geometric_horizon(1.0, height) + 1e-12, "{height} {turn}");
        }
    }
}

#[test]
fn a_pipe_closes_over_its_floor() {
    let slope = |turn: f64| Correction::Exact.slope(point(0.0, turn), -1.0, 0.0);
    // A quarter of the way round a pipe its wall is as high as it is far: one radius.
    assert_near(slope(FRAC_PI_2), 1.0, 1e-12);
    // Seen from the floor, a point of a circle stands at half its angle round the centre.
    for turn in [0.1, 1.0, 2.0, 3.0] {
        assert_near(slope(turn), (0.5 * turn).tan(), 1e-12);
    }
    assert!(slope(PI.next_down()) > 1e15);
    assert_eq!(slope(PI), NO_HORIZON);
}

#[test]
fn relief_that_reaches_the_centre_closes_a_hollow_and_is_lost_from_a_ball() {
    assert_eq!(Correction::Exact.slope(point(1.0, 1.0), -1.0, 0.0), CLOSED);
    assert_eq!(Correction::Exact.slope(point(3.0, 1.0), -1.0, 0.25), CLOSED);
    assert_eq!(Correction::Exact.slope(point(-1.0, 1.0), 1.0, 0.0), NO_HORIZON);
    assert_eq!(curved_horizon(&[point(-1.0, 1.0)], 1.0, 0.0), 0.0);
}

#[test]
fn a_texel_at_the_centre_sees_no_horizon() {
    for height in [1.0, 1.5] {
        assert_eq!(curved_horizon(&[point(0.5, 0.5)], -1.0, height), NO_HORIZON);
        // Beyond the centre of a convex surface: the tangent plane, which it is below.
        assert_eq!(curved_horizon(&[point(0.5, 0.5)], 1.0, -height), 0.0);
    }
    let nearly = Correction::Exact.slope(point(-0.5, 1.0), -1.0, 1.0 - 1e-12);
    assert!(nearly.is_finite() && nearly != NO_HORIZON);
}

#[test]
fn the_geometric_horizon_touches_the_circle() {
    for (curvature, height) in [(0.015, 4.0), (0.005, 40.0), (1.0, 3.0)] {
        let tangent = -(1.0_f64 / (1.0 + curvature * height)).acos().tan();
        assert_near(geometric_horizon(curvature, height), tangent, 1e-12);
        // Level relief at the point of touch is seen exactly there.
        let touch = point(-height / (-tangent).atan() * curvature, (-tangent).atan() / curvature);
        assert_near(Correction::Exact.slope(touch, curvature, height), tangent, 1e-12);
        assert_near(geometric_horizon_as_printed(curvature, height), -tangent, 1e-12);
    }
    for height in [0.0, -3.0] {
        assert_eq!(geometric_horizon(0.01, height), 0.0);
    }
    assert_eq!(geometric_horizon(0.0, 4.0), NO_HORIZON);
    assert_eq!(geometric_horizon(-0.01, 4.0), NO_HORIZON);
}

#[test]
fn the_geometric_horizon_does_not_cancel() {
    assert_near(geometric_horizon(1e-8, 1.0) / -1.414_213_566e-4, 1.0, 1e-9);
    assert_eq!(geometric_horizon(1e-20, 1.0), -(2e-20_f64.sqrt()));
    assert_eq!(geometric_horizon_as_printed(1e-20, 1.0), 0.0);
}

#[test]
fn the_papers_equation_is_the_small_angle_form() {
    assert_eq!(Correction::Paper.slope(point(0.5, 20.0), 0.01, 3.0), 0.5 * 0.97 - 0.1);
    assert_eq!(paper_horizon(point(-2.0, 20.0), 0.01, 3.0), geometric_horizon(0.01, 3.0));
    // First order in κ, for shallow points.
    let difference = |curvature: f64| {
        let point = point(0.01, 5.0);
        (Correction::Exact.slope(point, curvature, 0.5) - paper_horizon(point, curvature, 0.5)).abs()
    };
    assert!(difference(1e-3) < 1e-5 && difference(1e-4) < 1e-6);
}

#[test]
fn every_correction_has_a_name_of_its_own() {
    let names: std::collections::BTreeSet<_> = Correction::ALL.map(Correction::name).into_iter().collect();
    assert_eq!(names.len(), Correction::ALL.len());
}
