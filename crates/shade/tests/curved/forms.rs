//! Curvature along a direction.

use std::f64::consts::TAU;

use barchan_shade::{BaseSurface, Cylinder, FundamentalForms, PrincipalUv, Sphere, SphereChart};
use glam::{DMat2, DVec2};

use crate::support::assert_near;

const SHEAR: DMat2 = DMat2::from_cols(DVec2::new(1.0, 0.0), DVec2::new(0.6, 0.8));

fn directions() -> impl Iterator<Item = DVec2> {
    (0..48).map(|k| DVec2::from_angle(TAU * f64::from(k) / 48.0))
}

/// What is known of a cylinder of radius 2 under a chart: the forms, and principal directions as textures have them.
fn cylinder(chart: DMat2) -> (FundamentalForms, PrincipalUv) {
    let surface = Cylinder { radius: 2.0, hollow: false, chart };
    let inverse = chart.inverse();
    let principal = PrincipalUv { curvatures: [0.5, 0.0], directions: [inverse * DVec2::X, inverse * DVec2::Y] };
    (surface.forms(DVec2::new(0.3, -0.2)), principal)
}

/// The curvature of a cylinder along a direction of the texture: ½ cos² of the angle to its circle.
fn truth(chart: DMat2, direction: DVec2) -> f64 {
    0.5 * (chart * direction).normalize().x.powi(2)
}

#[test]
fn both_forms_know_the_curvature_of_a_cylinder_under_any_chart() {
    for chart in [DMat2::IDENTITY, SHEAR, DMat2::from_diagonal(DVec2::new(3.0, -0.2)), SHEAR * 1e-9] {
        let (forms, principal) = cylinder(chart);
        for direction in directions() {
            let expected = truth(chart, direction);
            assert_near(forms.along(direction.x, direction.y), expected, 1e-13);
            assert_near(forms.along(-7.0 * direction.x, -7.0 * direction.y), expected, 1e-13);
            assert_near(principal.euler_solved(direction), expected, 1e-13);
        }
    }
}

#[test]
fn eq_1_as_printed_is_right_on_conformal_charts_only() {
    let error = |chart: DMat2| {
        let (_, principal) = cylinder(chart);
        let squares = directions().map(|along| (principal.euler_as_printed(along) - truth(chart, along)).powi(2));
        (squares.sum::<f64>() / 48.0).sqrt() / 0.5
    };
    assert!(error(DMat2::IDENTITY) < 1e-15 && error(DMat2::from_angle(0.3) * 5.0) < 1e-14);
    // The errata's 19 % of the greatest curvature, on a cylinder: shear and stretch are alike.
    let (sheared, stretched) = (error(SHEAR), error(DMat2::from_diagonal(DVec2::new(2.0, 1.0))));
    assert!(sheared > 0.15 && stretched > 0.15, "{sheared} {stretched}");
}

#[test]
fn mirrored_texture_coordinates_leave_a_ball_convex() {
    for tile in [DVec2::new(1.0, 1.0), DVec2::new(-1.0, 1.0), DVec2::new(1.0, -2.0)] {
        for (hollow, expected) in [(false, 0.25), (true, -0.25)] {
            let ball = Sphere { radius: 4.0, hollow, chart: SphereChart::Geographic, tile };
            let forms = ball.forms(DVec2::new(0.4, 0.7));
            for direction in directions() {
                assert_near(forms.along(direction.x, direction.y), expected, 1e-14);
            }
            assert_near(forms.mean(), expected, 1e-14);
        }
    }
}

#[test]
fn where_nothing_can_be_known_the_answer_is_the_mean_or_flat() {
    let (forms, principal) = cylinder(SHEAR);
    assert_near(forms.along(0.0, 0.0), 0.25, 1e-14);
    assert_eq!(principal.euler_solved(DVec2::ZERO), 0.25);
    assert_eq!(principal.euler_as_printed(DVec2::ZERO), 0.25);
    let parallel = PrincipalUv { directions: [DVec2::X, DVec2::X], ..principal };
    assert_eq!(parallel.euler_solved(DVec2::Y), 0.25);
    let null = PrincipalUv { directions: [DVec2::ZERO, DVec2::X], ..principal };
    assert_eq!((null.euler_solved(DVec2::Y), null.euler_as_printed(DVec2::Y)), (0.25, 0.25));
    let no_area = FundamentalForms { first: [0.0; 3], second: [1.0, 0.0, 1.0] };
    assert_eq!((no_area.along(1.0, 0.0), no_area.mean()), (0.0, 0.0));
}

#[test]
fn forms_are_interpolated_exactly_over_an_umbilic_and_directions_are_not() {
    // Three corners of a triangle on a ball, whose principal directions, as any on a ball, are what a baker happened to choose.
    let ball = Sphere { radius: 4.0, hollow: false, chart: SphereChart::Stereographic, tile: DVec2::ONE };
    let corners = [DVec2::new(0.0, 0.0), DVec2::new(0.1, 0.0), DVec2::new(0.0, 0.1)].map(|uv| ball.forms(uv));
    let [a, b, c] = &corners;
    for direction in directions() {
        let along = FundamentalForms::interpolated([a, b, c], [0.2, 0.3, 0.5]).along(direction.x, direction.y);
        assert_near(along, 0.25, 1e-14);
    }
}

#[test]
fn directions_of_opposite_signs_cancel_unless_they_are_aligned() {
    let (_, principal) = cylinder(DMat2::IDENTITY);
    let turned = PrincipalUv { directions: principal.directions.map(|direction| -direction), ..principal };
    let (corners, weights) = ([&principal, &turned, &principal], [0.25, 0.5, 0.25]);
    let plain = PrincipalUv::interpolated(corners, weights);
    assert_eq!(plain.directions, [DVec2::ZERO; 2]);
    assert_eq!(plain.euler_solved(DVec2::X), 0.25);
    assert_eq!(PrincipalUv::interpolated_aligned(corners, weights), principal);
}
