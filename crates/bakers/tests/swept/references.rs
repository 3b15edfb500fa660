//! The brute-force twins, on fields whose horizon can be written down and against each other.

use barchan_bakers::horizon::reference;
use barchan_bakers::swept::Tie;
use barchan_bakers::swept::reference::{BentReference, CurvedReference};
use barchan_field::Edge;
use barchan_shade::{Correction, StoredPoint, geometric_horizon};

use crate::support::{assert_near, field, params, terrain, texels};

#[test]
fn level_ground_on_a_ball_has_its_horizon_at_its_feet_and_level() {
    for height in [0.0, 3.0] {
        let level = field((8, 8), Edge::Wrap, |_, _| height);
        let point = CurvedReference::new(&level, &params(7, 60.0), 3, 0.01).horizon(2, 5);
        assert_eq!((point.slope, point.distance), (0.0, 0.0));
    }
}

#[test]
fn level_ground_in_a_pipe_is_seen_at_half_the_angle_searched() {
    let level = field((8, 8), Edge::Wrap, |_, _| 0.0);
    for radius in [10.0, 100.0, 150.0, 300.0] {
        let point = CurvedReference::new(&level, &params(7, radius), 2, -0.01).horizon(2, 5);
        assert_near(point.slope, (0.005 * radius).tan(), 1e-9 * point.slope);
        assert_eq!(point.distance, radius);
    }
    // Half round, straight overhead; and no farther than that.
    let overhead = CurvedReference::new(&level, &params(7, 1e3), 2, -0.01).horizon(2, 5);
    assert!(overhead.slope > 1e12 && overhead.distance <= 100.0 * std::f64::consts::PI);
}

#[test]
fn a_pole_on_a_ball_looks_down_to_the_geometric_horizon() {
    let pole = field((64, 3), Edge::Clamp, |column, row| if (column, row) == (1, 1) { 4.0 } else { 0.0 });
    for curvature in [0.015, 0.05] {
        let point = CurvedReference::new(&pole, &params(4, 60.0), 0, curvature).horizon(1, 1);
        assert_near(point.slope, geometric_horizon(curvature, 4.0), 1e-9);
        assert_near(point.distance, (1.0 / (1.0 + curvature * 4.0)).acos() / curvature, 1e-2);
    }
}

#[test]
fn a_flat_surface_is_the_horizon_map_and_no_curvature_is_too_small() {
    let (terrain, params) = (terrain(), params(5, 40.0));
    for (column, row) in texels().step_by(3) {
        let expected = reference::horizon(&terrain, &params, 2, column, row);
        let bent = BentReference::new(&terrain, &params, 2, 0.0, Tie::Farthest).point(column, row);
        assert_near(bent.slope, expected.slope, 1e-12);
        assert_near(bent.distance, expected.distance, 1e-9);
        for curvature in [0.0, -0.0, 1e-300, -1e-300, 1e-16, -1e-16] {
            let curved = CurvedReference::new(&terrain, &params, 2, curvature).horizon(column, row);
            assert_near(curved.slope, expected.slope, 1e-7);
        }
    }
}

#[test]
fn a_bend_finds_what_a_dense_search_finds() {
    let (terrain, params) = (terrain(), params(16, 30.0));
    let (cos, sin) = params.azimuths.vector(3);
    for bend in [-0.02, -0.001, 0.001, 0.02] {
        let bent = BentReference::new(&terrain, &params, 3, bend, Tie::Nearest);
        for (column, row) in texels().step_by(9) {
            let (x, y) = (f64::from(column), f64::from(row));
            let height = |s: f64| terrain.surface(x + s * cos, y - s * sin);
            let bent_slope = |s: f64| (height(s) - height(0.0)) / s - bend * s;
            let dense = (1..=6000).map(|step| bent_slope(f64::from(step) * 0.005)).fold(f64::MIN, f64::max);
            let point = bent.point(column, row);
            assert!(point.distance <= 30.0);
            let found = point.slope - bend * point.distance;
            assert!(found >= dense - 1e-9 && found <= dense + 1e-2, "{found} {dense}");
        }
    }
}

#[test]
fn the_curved_horizon_is_a_point_of_the_surface_carried_over_exactly() {
    let (terrain, params) = (terrain(), params(16, 45.0));
    let (cos, sin) = params.azimuths.vector(3);
    for curvature in [-0.03, -0.005, 0.005, 0.03] {
        let curved = CurvedReference::new(&terrain, &params, 3, curvature);
        for (column, row) in texels().step_by(9) {
            let (x, y) = (f64::from(column), f64::from(row));
            let height = |s: f64| terrain.surface(x + s * cos, y - s * sin);
            let seen = |s: f64| {
                let point = StoredPoint { slope: (height(s) - height(0.0)) / s, distance: s };
                Correction::Exact.slope(point, curvature, height(0.0))
            };
            let found = curved.horizon(column, row);
            if found.distance > 0.0 {
                assert_near(found.slope, seen(found.distance), 1e-9);
            }
            let dense = (1..=9000).map(|step| seen(f64::from(step) * 0.005)).fold(f64::MIN, f64::max);
            assert!(found.slope >= dense - 1e-9, "{} below {dense}", found.slope);
        }
    }
}

#[test]
fn a_texel_at_the_centre_of_a_hollow_has_no_horizon() {
    let bump = field((9, 3), Edge::Clamp, |column, _| if column == 4 { 10.0 } else { 0.0 });
    assert_eq!(CurvedReference::new(&bump, &params(4, 5.0), 0, -0.1).horizon(4, 1).slope, f64::NEG_INFINITY);
    // From its foot the bump closes the hollow.
    assert_eq!(CurvedReference::new(&bump, &params(4, 5.0), 0, -0.1).horizon(2, 1).slope, f64::INFINITY);
}

#[test]
fn of_equal_crests_the_rule_decides() {
    let crests = field((40, 3), Edge::Clamp, |column, _| if column % 10 == 0 { 2.0 } else { 0.5 });
    let distance = |tie| BentReference::new(&crests, &params(4, 35.0), 0, 0.0, tie).point(0, 1).distance;
    assert_eq!((distance(Tie::Nearest), distance(Tie::Farthest)), (10.0, 30.0));
}
