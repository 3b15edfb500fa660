//! Jets, forms and curvature against closed forms that are written down independently.

use std::f64::consts::{PI, TAU};

use super::*;

#[test]
fn names_and_examples_go_together() {
    let names: Vec<_> = ParametricSurface::examples().iter().map(ParametricSurface::name).collect();
    assert_eq!(names, ParametricSurface::ALL_NAMES);
}

#[test]
fn derivatives_are_those_of_the_point() {
    let step = 1e-5;
    for surface in ParametricSurface::examples() {
        for (u, v) in parameters() {
            let jet = surface.jet(u, v);
            let [left, right] = [surface.jet(u - step, v), surface.jet(u + step, v)];
            let [below, above] = [surface.jet(u, v - step), surface.jet(u, v + step)];
            let pairs = [
                ("du", jet.du, right.position - left.position),
                ("dv", jet.dv, above.position - below.position),
                ("duu", jet.duu, right.du - left.du),
                ("duv", jet.duv, above.du - below.du),
                ("duv", jet.duv, right.dv - left.dv),
                ("dvv", jet.dvv, above.dv - below.dv),
            ];
            for (name, exact, difference) in pairs {
                let error = (exact - difference / (2.0 * step)).length();
                assert!(error < 1e-5, "{name} of {} at {u}, {v} is off by {error}", surface.name());
            }
        }
    }
}

#[test]
fn spheres_and_cylinders_bend_by_one_over_their_radius() {
    for (u, v) in parameters() {
        for curvature in (ParametricSurface::Sphere { radius: 2.5 }).jet(u, v).curvature().principal {
            assert_close(curvature, 0.4, 1e-13);
        }
        let cylinder = ParametricSurface::Cylinder { radius: 2.5, height: 3.0 }.jet(u, v).curvature();
        assert_close(cylinder.principal[0], 0.4, 1e-14);
        assert_close(cylinder.principal[1], 0.0, 1e-14);
        assert_close(cylinder.directions[1].z.abs(), 1.0, 1e-14);
    }
}

#[test]
fn a_sphere_bends_alike_up_to_its_poles() {
    for v in [1e-6, 1.0 - 1e-6] {
        for curvature in (ParametricSurface::Sphere { radius: 1.0 }).jet(0.3, v).curvature().principal {
            assert_close(curvature, 1.0, 1e-9);
        }
    }
}

#[test]
fn a_torus_bends_along_its_tube_and_around_its_axis() {
    let (major, minor) = (2.0, 0.7);
    for (u, v) in parameters() {
        let found = ParametricSurface::Torus { major, minor }.jet(u, v).curvature();
        let cos = (TAU * v).cos();
        assert_close(found.principal[0], 1.0 / minor, 1e-12);
        assert_close(found.principal[1], cos / (major + minor * cos), 1e-12);
        let around = DVec3::new(-(TAU * u).sin(), (TAU * u).cos(), 0.0);
        assert_close(found.directions[1].dot(around).abs(), 1.0, 1e-12);
    }
}

#[test]
fn a_cone_bends_by_the_distance_from_its_axis() {
    for (base_radius, top_radius) in [(2.0, 0.5), (0.5, 2.0)] {
        for (u, v) in parameters() {
            let jet = ParametricSurface::Cone { base_radius, top_radius, height: 3.0 }.jet(u, v);
            let radius = jet.position.truncate().length();
            let [first, second] = jet.curvature().principal;
            assert_close(first, 1.0 / (radius * (1.0 + 0.25_f64).sqrt()), 1e-13);
            assert_close(second, 0.0, 1e-13);
        }
    }
}

#[test]
fn an_ellipsoid_has_its_textbook_gaussian_and_mean_curvature() {
    let (a, b, c) = (1.0_f64, 0.8_f64, 0.6_f64);
    for (u, v) in parameters() {
        let jet = ParametricSurface::Ellipsoid { a, b, c }.jet(u, v);
        let p = jet.position;
        let implicit = (p.x / a).powi(2) + (p.y / b).powi(2) + (p.z / c).powi(2);
        assert_close(implicit, 1.0, 1e-14);
        let gradient = p.x.powi(2) / a.powi(4) + p.y.powi(2) / b.powi(4) + p.z.powi(2) / c.powi(4);
        let [first, second] = jet.curvature().principal;
        let gaussian = 1.0 / (a * b * c * gradient).powi(2);
        let mean = (a * a + b * b + c * c - p.length_squared()) / (2.0 * (a * b * c).powi(2) * gradient.powf(1.5));
        assert_close(first * second / gaussian, 1.0, 1e-11);
        assert_close(0.5 * (first + second) / mean, 1.0, 1e-11);
    }
}

#[test]
fn a_helicoid_is_minimal() {
    let pitch = 3.0;
    for (u, v) in parameters() {
        let helicoid = ParametricSurface::Helicoid { inner_radius: 0.2, outer_radius: 1.5, pitch, turns: 1.5 };
        let jet = helicoid.jet(u, v);
        let (c, radius) = (pitch / TAU, jet.position.truncate().length());
        let [first, second] = jet.curvature().principal;
        assert_close(first, c / (radius * radius + c * c), 1e-12);
        assert_close(first + second, 0.0, 1e-12);
    }
}

/// K = (z_xx z_yy − z_xy²) / (1 + z_x² + z_y²)² and 2H from z = z(x, y); the front is above.
fn graph_curvature([x, y, xx, xy, yy]: [f64; 5]) -> [f64; 2] {
    let slope = 1.0 + x * x + y * y;
    let gaussian = (xx * yy - xy * xy) / (slope * slope);
    let mean = -((1.0 + y * y) * xx - 2.0 * x * y * xy + (1.0 + x * x) * yy) / (2.0 * slope.powf(1.5));
    [gaussian, mean]
}

#[test]
fn graphs_have_their_textbook_gaussian_and_mean_curvature() {
    for (u, v) in parameters() {
        let at = |name| example(name).jet(u, v);
        let [saddle, monkey, wavy] = ["saddle", "monkey_saddle", "wavy_sheet"].map(at);
        let (x, y) = (saddle.position.x, saddle.position.y);
        let k = TAU;
        let (sx, cx, sy, cy) = ((k * x).sin(), (k * x).cos(), (k * y).sin(), (k * y).cos());
        let expected = [
            (saddle, [x, -y / 1.5, 1.0, 0.0, -1.0 / 1.5]),
            (monkey, [0.75 * (x * x - y * y), -1.5 * x * y, 1.5 * x, -1.5 * y, -1.5 * x]),
            (
                wavy,
                [
                    0.1 * k * cx * sy,
                    0.1 * k * sx * cy,
                    -0.1 * k * k * sx * sy,
                    0.1 * k * k * cx * cy,
                    -0.1 * k * k * sx * sy,
                ],
            ),
        ];
        for (jet, derivatives) in expected {
            let [gaussian, mean] = graph_curvature(derivatives);
            let [first, second] = jet.curvature().principal;
            assert_close(first * second, gaussian, 1e-10);
            assert_close(0.5 * (first + second), mean, 1e-11);
        }
    }
}

#[test]
fn a_saddle_is_a_ridge_and_a_valley_at_its_middle() {
    let saddle = ParametricSurface::Saddle { valley_radius: 2.0, ridge_radius: 4.0, size: 1.0 };
    let found = saddle.jet(0.5, 0.5).curvature();
    assert_close(found.principal[0], 0.25, 1e-15);
    assert_close(found.principal[1], -0.5, 1e-15);
    assert_close(found.directions[0].y.abs(), 1.0, 1e-15);
    assert_close(found.directions[1].x.abs(), 1.0, 1e-15);
}

#[test]
fn a_patch_of_raised_degree_is_the_paraboloid_it_came_from() {
    // z = x² + y² over the unit square: raised to degree three its Bézier heights are 0, 0, 1/3, 1 along each axis.
    let height = [0.0, 0.0, 1.0 / 3.0, 1.0];
    let third = |i: usize| i as f64 / 3.0;
    let control =
        std::array::from_fn(|i| std::array::from_fn(|j| DVec3::new(third(i), third(j), height[i] + height[j])));
    let patch = ParametricSurface::BezierPatch { control };
    for (u, v) in parameters() {
        let jet = patch.jet(u, v);
        assert!((jet.position - DVec3::new(u, v, u * u + v * v)).length() < 1e-15);
        let [gaussian, mean] = graph_curvature([2.0 * u, 2.0 * v, 2.0, 0.0, 2.0]);
        let [first, second] = jet.curvature().principal;
        assert_close(first * second, gaussian, 1e-12);
        assert_close(0.5 * (first + second), mean, 1e-12);
    }
}

#[test]
fn curvature_agrees_with_the_forms_along_every_direction() {
    for surface in ParametricSurface::examples() {
        for (u, v) in parameters() {
            let jet = surface.jet(u, v);
            let curvature = jet.curvature();
            let FundamentalForms { first: [big_e, big_f, big_g], second: [e, f, g] } = jet.forms();
            let [first, second] = curvature.directions;
            let normal = jet.normal();
            assert_close(first.cross(second).dot(normal), 1.0, 1e-12);
            for step in 0..8 {
                let (du, dv) = ((PI / 8.0 * f64::from(step)).cos(), (PI / 8.0 * f64::from(step)).sin());
                let along = (jet.du * du + jet.dv * dv).normalize();
                let [most, least] = curvature.principal;
                let euler = most * along.dot(first).powi(2) + least * along.dot(second).powi(2);
                let from_forms = (e * du * du + 2.0 * f * du * dv + g * dv * dv)
                    / (big_e * du * du + 2.0 * big_f * du * dv + big_g * dv * dv);
                assert_close(euler, from_forms, 1e-11 * (1.0 + most.abs().max(least.abs())));
            }
        }
    }
}

#[test]
fn fronts_point_outwards_or_up() {
    for (u, v) in parameters() {
        for name in ["sphere", "ellipsoid", "cylinder", "cone"] {
            let jet = example(name).jet(u, v);
            assert!(jet.normal().truncate().dot(jet.position.truncate()) > 0.0, "{name} at {u}, {v}");
        }
        let tube = example("torus").jet(u, v);
        let middle = tube.position.with_z(0.0).normalize();
        assert!(tube.normal().dot(tube.position - middle) > 0.0);
        for name in ["saddle", "monkey_saddle", "helicoid", "wavy_sheet", "bezier_patch"] {
            assert!(example(name).jet(u, v).normal().z >= 0.0, "{name} at {u}, {v}");
        }
    }
}

#[test]
fn what_is_closed_continues_itself() {
    for surface in ParametricSurface::examples() {
        for (t, _) in parameters() {
            let same = |a: SurfaceJet, b: SurfaceJet| {
                (a.position - b.position).length() < 1e-12
                    && (a.du - b.du).length() < 1e-12
                    && (a.dv - b.dv).length() < 1e-12
            };
            assert_eq!(same(surface.jet(0.0, t), surface.jet(1.0, t)), surface.is_closed_u(), "{}", surface.name());
            assert_eq!(same(surface.jet(t, 0.0), surface.jet(t, 1.0)), surface.is_closed_v(), "{}", surface.name());
        }
    }
}
