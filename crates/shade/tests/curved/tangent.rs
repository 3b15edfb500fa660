//! Frames and lights of the tangent plane.

use barchan_shade::{BaseSurface, Plane, Sphere, SphereChart, TangentFrame, TangentLight};
use glam::{DMat2, DVec2, DVec3};

use crate::support::assert_near;

#[test]
fn a_frame_without_a_plane_is_refused_and_mirroring_turns_its_normal() {
    let frame = |u, v, mirrored| TangentFrame::new(u, v, mirrored);
    assert_eq!(frame(DVec3::X, DVec3::X * 2.0, false), None);
    assert_eq!(frame(DVec3::X, DVec3::ZERO, false), None);
    assert_eq!(frame(DVec3::X, DVec3::splat(f64::NAN), false), None);
    let straight = frame(DVec3::X * 2.0, DVec3::Y * 3.0, false).unwrap();
    assert!(straight.normal == DVec3::Z && !straight.mirrored());
    let mirrored = frame(DVec3::NEG_X * 2.0, DVec3::Y * 3.0, true).unwrap();
    assert!(mirrored.normal == DVec3::Z && mirrored.mirrored());
}

#[test]
fn on_a_square_texture_a_light_keeps_its_azimuth_and_elevation() {
    let frame = TangentFrame::new(DVec3::X * 64.0, DVec3::Y * 64.0, false).unwrap();
    for (azimuth, elevation) in [(0.0, 30.0), (123.0, 5.0), (300.0, -20.0)] {
        let light = barchan_shade::DirectionalLight::from_degrees(azimuth, elevation);
        let found = TangentLight::new(&frame, light.towards, (64.0, 64.0));
        assert_near(found.azimuth_radians.rem_euclid(std::f64::consts::TAU), light.azimuth_radians, 1e-14);
        assert_near(found.height, light.towards.z, 1e-15);
        assert_near(found.level, light.level_length(), 1e-15);
        assert_near(found.stretch, 1.0, 1e-14);
    }
}

/// One unit of u is 2 along x, one of v is 3 along a direction 60° from it.
#[test]
fn on_a_sheared_texture_the_light_comes_along_its_image() {
    let along_v = DVec3::new(1.5, 3.0_f64.sqrt() * 1.5, 0.0);
    let frame = TangentFrame::new(DVec3::X * 2.0, along_v, false).unwrap();
    // The map's own grid is 8 long along u and 4 along v.
    for step in [DVec2::X, DVec2::Y, DVec2::new(0.6, -1.1)] {
        let image = frame.along_u * step.x + frame.along_v * step.y;
        let light = TangentLight::new(&frame, (image + DVec3::Z).normalize(), (8.0, 4.0));
        let on_grid = step * DVec2::new(8.0, 4.0);
        assert_near(light.azimuth_radians, on_grid.to_angle(), 1e-14);
        assert_near(light.stretch, image.length() / on_grid.length(), 1e-14);
        assert_near(light.height / light.level, 1.0 / image.length(), 1e-14);
        assert!(light.direction.perp_dot(step).abs() < 1e-14 && light.direction.dot(step) > 0.0);
    }
}

#[test]
fn a_light_at_the_zenith_has_no_azimuth() {
    let frame = TangentFrame::new(DVec3::X, DVec3::Y, false).unwrap();
    let light = TangentLight::new(&frame, DVec3::Z, (1.0, 1.0));
    assert_eq!((light.height, light.level, light.azimuth_radians, light.stretch), (1.0, 0.0, 0.0, 1.0));
}

#[test]
fn a_bump_normal_is_that_of_the_raised_plane() {
    let chart = DMat2::from_cols(DVec2::new(2.0, 0.3), DVec2::new(-0.5, 1.5));
    for chart in [chart, DMat2::from_cols(-chart.x_axis, chart.y_axis)] {
        let frame = Plane { chart }.point(DVec2::ZERO).frame;
        let (u, v) = (frame.along_u + DVec3::Z * 0.7, frame.along_v - DVec3::Z * 0.4);
        let expected = u.cross(v).normalize() * chart.determinant().signum();
        assert!((frame.bump_normal(0.7, -0.4) - expected).length() < 1e-14);
    }
    let none = TangentFrame { along_u: DVec3::X, along_v: DVec3::X, normal: DVec3::Z };
    assert_eq!(none.bump_normal(1.0, 2.0), DVec3::Z);
}

/// What bump mapping leaves out is the height over the radius.
#[test]
fn on_a_ball_it_is_the_raised_normal_to_the_height_over_the_radius() {
    let ball = Sphere { radius: 50.0, hollow: false, chart: SphereChart::Geographic, tile: DVec2::splat(10.0) };
    let height = |uv: DVec2| 0.2 * (6.0 * uv.x).sin() * (5.0 * uv.y).cos();
    let raised = |uv: DVec2| {
        let point = ball.point(uv);
        point.position + point.frame.normal * height(uv)
    };
    let (uv, step) = (DVec2::new(0.3, 0.8), 1e-5);
    let change = |axis: DVec2| (raised(uv + axis * step) - raised(uv - axis * step)) / (2.0 * step);
    let slope = |axis: DVec2| (height(uv + axis * step) - height(uv - axis * step)) / (2.0 * step);
    let expected = change(DVec2::X).cross(change(DVec2::Y)).normalize();
    let found = ball.point(uv).frame.bump_normal(slope(DVec2::X), slope(DVec2::Y));
    assert!((found - expected).length() < 0.2 / 50.0 * 0.2, "{}", (found - expected).length());
    assert!((found - ball.point(uv).frame.normal).length() > 0.02);
}
