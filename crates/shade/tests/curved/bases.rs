//! The base surfaces: charts, frames, forms, feet, hits.

use barchan_shade::{BaseSurface, Cylinder, Patch, Plane, Ray, Sphere, SphereChart, SurfacePoint, TangentFrame};
use glam::{DMat2, DVec2, DVec3};

use crate::support::assert_near;

/// One tile of a ring, as a patch that closes both ways.
pub(crate) fn torus(uv: DVec2) -> SurfacePoint {
    let ((sin_u, cos_u), (sin_v, cos_v)) = (uv.x.sin_cos(), uv.y.sin_cos());
    let ring = 3.0 + cos_v;
    let frame = TangentFrame {
        along_u: DVec3::new(-ring * sin_u, ring * cos_u, 0.0),
        along_v: DVec3::new(-sin_v * cos_u, -sin_v * sin_u, cos_v),
        normal: DVec3::new(cos_v * cos_u, cos_v * sin_u, sin_v),
    };
    SurfacePoint { position: DVec3::new(ring * cos_u, ring * sin_u, sin_v), frame }
}

/// A wavy sheet over the unit square.
fn sheet(uv: DVec2) -> SurfacePoint {
    let (x, y) = (uv.x, uv.y);
    let (along_u, along_v) = (DVec3::new(1.0, 0.0, 0.6 * (2.0 * x).cos()), DVec3::new(0.2, 1.0, -0.4 * y));
    let position = DVec3::new(x + 0.2 * y, y, 0.3 * (2.0 * x).sin() - 0.2 * y * y);
    SurfacePoint { position, frame: TangentFrame::new(along_u, along_v, false).unwrap() }
}

fn surfaces() -> Vec<(&'static str, Box<dyn BaseSurface>)> {
    let sheared = DMat2::from_cols(DVec2::new(1.5, 0.2), DVec2::new(-0.7, 0.9));
    let sphere = |chart, hollow, tile| Box::new(Sphere { radius: 2.0, hollow, chart, tile });
    let domain = (DVec2::ZERO, DVec2::splat(std::f64::consts::TAU));
    vec![
        ("plane", Box::new(Plane { chart: sheared })),
        ("cylinder", Box::new(Cylinder { radius: 2.0, hollow: false, chart: sheared })),
        ("hollow cylinder", Box::new(Cylinder { radius: 2.0, hollow: true, chart: sheared })),
        ("geographic", sphere(SphereChart::Geographic, false, DVec2::new(1.0, 1.5))),
        ("mirrored", sphere(SphereChart::Geographic, false, DVec2::new(-1.0, 1.5))),
        ("stereographic", sphere(SphereChart::Stereographic, false, DVec2::new(1.2, -0.8))),
        ("hollow sphere", sphere(SphereChart::Stereographic, true, DVec2::new(1.0, 1.0))),
        ("torus", Box::new(Patch::new(torus, domain, (true, true), 32))),
        ("sheet", Box::new(Patch::new(sheet, (DVec2::ZERO, DVec2::ONE), (false, false), 16))),
    ]
}

const PLACES: [DVec2; 4] = [DVec2::new(0.3, 0.4), DVec2::new(0.9, 0.2), DVec2::new(0.55, 0.85), DVec2::new(0.05, 0.5)];

#[test]
fn frames_are_the_derivatives_of_the_surface() {
    const STEP: f64 = 1e-6;
    for (name, surface) in surfaces() {
        for uv in PLACES {
            let frame = surface.point(uv).frame;
            let change =
                |step: DVec2| (surface.point(uv + step).position - surface.point(uv - step).position) / (2.0 * STEP);
            let (u, v) = (change(DVec2::X * STEP), change(DVec2::Y * STEP));
            assert!((u - frame.along_u).length() < 1e-8 && (v - frame.along_v).length() < 1e-8, "{name} {uv}");
            let normal = frame.normal;
            assert!(normal.dot(u).abs() < 1e-8 && normal.dot(v).abs() < 1e-8 && (normal.length() - 1.0).abs() < 1e-14);
        }
    }
}

#[test]
fn second_forms_are_how_normals_turn() {
    const STEP: f64 = 1e-6;
    for (name, surface) in surfaces() {
        for uv in PLACES {
            let (frame, forms) = (surface.point(uv).frame, surface.forms(uv));
            let change = |step: DVec2| {
                (surface.point(uv + step).frame.normal - surface.point(uv - step).frame.normal) / (2.0 * STEP)
            };
            let (u, v) = (change(DVec2::X * STEP), change(DVec2::Y * STEP));
            let expected = [u.dot(frame.along_u), u.dot(frame.along_v), v.dot(frame.along_v)];
            for (found, expected) in forms.second.into_iter().zip(expected) {
                assert_near(found, expected, 1e-7);
            }
            assert_eq!(forms.first, frame.first_form(), "{name}");
        }
    }
}

#[test]
fn a_point_above_the_surface_has_its_foot_there() {
    for (name, surface) in surfaces() {
        for uv in PLACES {
            let point = surface.point(uv);
            for height in [-0.2, 0.0, 1e-6, 0.3] {
                let above = point.position + point.frame.normal * height;
                for near in [None, Some(uv + DVec2::new(0.02, -0.03))] {
                    let foot = surface.foot(above, near);
                    assert!((foot.uv - uv).length() < 1e-12 && !foot.beyond_edge, "{name} {uv}: {:?}", foot.uv);
                    assert_near(foot.height, height, 1e-14);
                }
            }
        }
    }
}

#[test]
fn a_ray_from_above_hits_where_it_was_aimed() {
    for (name, surface) in surfaces() {
        for uv in PLACES {
            let point = surface.point(uv);
            // Aslant, from not far away: nothing of the surface is between.
            let from = point.position + point.frame.normal * 0.7 + point.frame.along_u * 0.1;
            let ray = Ray { origin: from, direction: (point.position - from).normalize() };
            let hit = surface.hit(&ray).unwrap_or_else(|| panic!("{name} {uv}: missed"));
            assert!((hit - uv).length() < 1e-10, "{name}: {hit} instead of {uv}");
            let away = Ray { origin: from, direction: point.frame.normal };
            assert!(matches!(name, "hollow cylinder" | "hollow sphere" | "torus") || surface.hit(&away).is_none());
        }
    }
}

#[test]
fn texture_coordinates_go_on_along_a_path_round_the_back() {
    let cylinder = Cylinder { radius: 1.0, hollow: false, chart: DMat2::IDENTITY };
    let sphere = Sphere { radius: 1.0, hollow: false, chart: SphereChart::Geographic, tile: DVec2::ONE };
    let surfaces: [&dyn BaseSurface; 2] = [&cylinder, &sphere];
    for surface in surfaces {
        let mut uv = DVec2::ZERO;
        for step in 1..=700 {
            let angle = 0.01 * f64::from(step);
            uv = surface.foot(DVec3::new(angle.cos(), angle.sin(), 0.0) * 1.1, Some(uv)).uv;
            assert_near(uv.x, angle, 1e-12);
        }
    }
}

#[test]
fn beside_a_patch_there_is_no_surface_below() {
    let patch = Patch::new(sheet, (DVec2::ZERO, DVec2::ONE), (false, false), 16);
    let edge = sheet(DVec2::new(1.0, 0.5));
    let beside = edge.position + edge.frame.along_u.normalize() * 0.25;
    let foot = patch.foot(beside, None);
    assert!(foot.beyond_edge && foot.uv.x == 1.0);
    assert_near(foot.height, 0.25, 0.02);
    // A ray that passes by the box of the patch never comes back.
    let past = Ray { origin: DVec3::new(3.0, 0.0, 2.0), direction: DVec3::Y };
    assert!(patch.escapes(&past, 0.1) && !patch.escapes(&past, 3.0));
}
