//! The oracle against what is known otherwise.

use barchan_field::{Edge, HeightField};
use barchan_shade::{
    BaseSurface, Correction, Cylinder, DirectionalLight, DisplacedShadow, Patch, Plane, Sphere, SphereChart,
    StoredPoint, Surface, SurfacePoint, TangentFrame, TracedShadow, geometric_horizon,
};
use glam::{DMat2, DVec2, DVec3};
use proptest::prelude::*;

use crate::support::{ball, example, field, noise, relief, towards};

fn extent(field: &HeightField) -> DVec2 {
    DVec2::new(field.grid().extent_u(), field.grid().extent_v())
}

/// Texture coordinates of a place in texels from the centre of texel (0, 0).
fn uv_of(field: &HeightField, x: f64, y: f64) -> DVec2 {
    DVec2::new((x + 0.5) / f64::from(field.grid().width), 1.0 - (y + 0.5) / f64::from(field.grid().height))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn on_a_flat_base_it_is_the_traced_shadow(
        heights in prop::collection::vec(-2.0_f32..2.0, 42),
        edge in prop_oneof![Just(Edge::Wrap), Just(Edge::Clamp)],
        azimuth in prop_oneof![0.0..360.0_f64, (0_u8..8).prop_map(|k| 45.0 * f64::from(k))],
        elevation in 3.0..80.0_f64,
        place in prop_oneof![(0.0..6.0, 0.0..7.0_f64), (0_u8..6, 0_u8..7).prop_map(|(x, y)| (x.into(), y.into()))],
    ) {
        let field = field((6, 7), edge, |column, row| heights[(row * 6 + column) as usize]);
        let (relief, light) = (relief(&field), DirectionalLight::from_degrees(azimuth, elevation));
        let plane = Plane { chart: DMat2::from_diagonal(extent(&field)) };
        let expected = TracedShadow::new(&relief, &light, 300.0).in_shadow(place.0, place.1);
        let uv = uv_of(&field, place.0, place.1);
        let at = |towards: DVec3| DisplacedShadow::new(&plane, &relief, f64::INFINITY).in_shadow(uv, towards);
        // A ray that touches relief by less than the tolerance may go either way.
        let (lower, higher) = [-1e-6, 1e-6].map(|more| at(DirectionalLight::from_degrees(azimuth, elevation + more).towards)).into();
        prop_assert!(at(light.towards) == expected || lower != higher, "{expected} and not");
    }
}

#[test]
fn a_smooth_ball_is_its_own_shadow_behind_the_terminator() {
    let level = field((8, 8), Edge::Wrap, |_, _| 0.0);
    let relief = relief(&level);
    for chart in [SphereChart::Geographic, SphereChart::Stereographic] {
        let ball = ball(&level, 20.0, chart);
        let shadow = DisplacedShadow::new(&ball, &relief, f64::INFINITY);
        for elevation in [-40.0, -1.0, -0.01, 0.01, 1.0, 50.0, 89.0] {
            for azimuth in [0.0, 77.0, 200.0] {
                assert_eq!(shadow.in_shadow(DVec2::ZERO, towards(azimuth, elevation)), elevation < 0.0, "{elevation}");
            }
        }
    }
}

/// A circle in the plane of z = 0, and a ridge along the axis of the cylinder at a distance along the arc: it is seen at the angle
/// of its top, which the exact form gives and plane geometry gives again here.
#[test]
fn a_ridge_on_a_cylinder_shades_up_to_the_angle_of_its_top() {
    for (radius, hollow) in [(40.0, false), (25.0, true), (12.0, false)] {
        for (height, distance) in [(6.0, 9.0), (2.0, 5.0), (1.0, 3.0)] {
            let ridge = field((64, 4), Edge::Wrap, |column, _| if column == 32 { height as f32 } else { 0.0 });
            let relief = relief(&ridge);
            let base = Cylinder { radius, hollow, chart: DMat2::from_diagonal(extent(&ridge)) };
            let uv = uv_of(&ridge, 32.0 - distance, 1.3);
            let (point, top) = (base.point(uv), base.point(uv_of(&ridge, 32.0, 1.3)));
            let line = top.position + top.frame.normal * height - point.position;
            let round = point.frame.along_u.normalize();
            let angle = line.dot(point.frame.normal).atan2(line.dot(round));
            let side = if hollow { -1.0 } else { 1.0 };
            // In a hollow, the far wall shuts out all light in the end.
            let reach = if hollow { 1.1 * line.length() } else { f64::INFINITY };
            let shadow = DisplacedShadow::new(&base, &relief, reach);
            let stored = StoredPoint { slope: height / distance, distance };
            let exact = Correction::Exact.slope(stored, side / radius, 0.0);
            assert!((angle - exact.atan()).abs() < 1e-12, "the exact form is {exact}");
            let at = |angle: f64| shadow.in_shadow(uv, round * angle.cos() + point.frame.normal * angle.sin());
            assert!(at(angle - 1e-7) && !at(angle + 1e-7), "{radius} {hollow} {height} {distance}");
        }
    }
}

/// Eq 3, with its sign mended. Texels are coarse beside the ball, so that the ray comes and goes within one step.
#[test]
fn from_the_top_of_a_spike_a_ball_goes_on_to_its_own_horizon() {
    let spike = field((17, 17), Edge::Clamp, |column, row| if (column, row) == (8, 8) { 3.0 } else { 0.0 });
    let relief = relief(&spike);
    let ball = Sphere { tile: DVec2::splat(4.0 * 17.0), ..ball(&spike, 15.0, SphereChart::Stereographic) };
    let shadow = DisplacedShadow::new(&ball, &relief, f64::INFINITY);
    let (uv, limb) = (uv_of(&spike, 8.0, 8.0), geometric_horizon(1.0 / 15.0, 3.0).atan());
    let frame = ball.point(uv).frame;
    let across = frame.along_u.normalize();
    for k in 0..24 {
        let (sin, cos) = (0.3 + f64::from(k)).sin_cos();
        let level = across * cos + frame.normal.cross(across) * sin;
        let at = |angle: f64| shadow.in_shadow(uv, level * angle.cos() + frame.normal * angle.sin());
        assert!(at(limb - 1e-6) && !at(limb + 1e-6), "{k}");
    }
}

/// From the bottom of a round gutter whose sides rise by `half` radians, its rim is seen at half that angle.
#[test]
fn the_bottom_of_a_gutter_sees_over_its_rim_at_half_its_angle() {
    let level = relief(&field((8, 8), Edge::Clamp, |_, _| 0.0));
    for half in [0.4_f64, 1.0, 1.4] {
        let gutter = |uv: DVec2| {
            let (sin, cos) = uv.x.sin_cos();
            let out = DVec3::new(cos, sin, 0.0);
            let frame = TangentFrame { along_u: DVec3::new(-sin, cos, 0.0) * 10.0, along_v: DVec3::Z, normal: -out };
            SurfacePoint { position: out * 10.0 + DVec3::Z * uv.y, frame }
        };
        let domain = (DVec2::new(-half, -50.0), DVec2::new(half, 50.0));
        let base = Patch::new(gutter, domain, (false, false), 24);
        let shadow = DisplacedShadow::new(&base, &level, f64::INFINITY);
        let at = |angle: f64| shadow.in_shadow(DVec2::ZERO, DVec3::new(-angle.sin(), angle.cos(), 0.0));
        assert!(at(0.5 * half - 1e-4) && at(0.1) && !at(0.5 * half + 1e-4) && !at(1.5), "{half}");
    }
}

/// The least clearance of a ray at many points beyond its start, wherever the surface is below it.
fn least_clearance(base: &dyn BaseSurface, relief: &Surface, uv: DVec2, light: DVec3, reach: f64) -> f64 {
    const POINTS: u32 = 20_000;
    let point = base.point(uv);
    let at = |uv: DVec2| {
        let (x, y) = relief.texel_of(uv);
        relief.heights().sample(x, y)
    };
    let origin = point.position + point.frame.normal * at(uv);
    let clearance = |k: u32| {
        let foot = base.foot(origin + light * (reach * f64::from(k) / f64::from(POINTS)), Some(uv));
        foot.height - at(foot.uv)
    };
    (1..=POINTS).map(clearance).fold(f64::INFINITY, f64::min)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn a_ray_is_blocked_where_marching_finds_it_blocked(
        heights in prop::collection::vec(0.0_f32..2.0, 64),
        kind in 0_usize..5,
        (azimuth, elevation) in (0.0..360.0_f64, -15.0..70.0_f64),
        (u, v) in (-0.5..0.5_f64, -0.5..0.5_f64),
    ) {
        let field = field((8, 8), Edge::Wrap, |column, row| heights[(row * 8 + column) as usize]);
        let (relief, sheared) = (relief(&field), DMat2::from_cols(DVec2::new(8.0, 1.0), DVec2::new(-2.0, 6.0)));
        let sphere = |chart, hollow| Sphere { radius: 15.0, hollow, chart, tile: DVec2::new(8.0, -7.0) };
        let surfaces: [&dyn BaseSurface; 5] = [
            &sphere(SphereChart::Geographic, false),
            &sphere(SphereChart::Stereographic, false),
            &sphere(SphereChart::Stereographic, true),
            &Cylinder { radius: 12.0, hollow: false, chart: sheared },
            &Cylinder { radius: 30.0, hollow: true, chart: sheared },
        ];
        let (base, uv) = (surfaces[kind], DVec2::new(u, v));
        let light = towards(azimuth, elevation);
        // In the frame of the place, out of the surface.
        let frame = base.point(uv).frame;
        let across = frame.along_u.normalize();
        let light = frame.normal * light.x + across * light.y + frame.normal.cross(across) * light.z;
        let found = DisplacedShadow::new(base, &relief, 20.0).in_shadow(uv, light);
        let least = least_clearance(base, &relief, uv, light, 20.0);
        // Between points, a thousandth apart, relief rises by no more than its steepest cell.
        prop_assert!(!found || least < 0.01, "shadow, though every point is {least} clear");
        prop_assert!(found || least > -1e-7, "light, though a point is {least} deep");
    }
}

/// A light that runs level over an endless plane neither meets anything nor leaves, and the answer must come all the same.
#[test]
fn a_level_ray_over_a_level_plane_ends_and_is_lit() {
    let level = relief(&field((4, 4), Edge::Wrap, |_, _| 1.0));
    let plane = Plane { chart: DMat2::from_diagonal(DVec2::splat(4.0)) };
    assert!(!DisplacedShadow::new(&plane, &level, 1000.0).in_shadow(DVec2::splat(0.3), DVec3::X));
    assert!(!DisplacedShadow::new(&plane, &level, f64::INFINITY).in_shadow(DVec2::splat(0.3), DVec3::X));
}

/// A ball's relief in fine triangles: what is really there, apart from facets.
struct Facets(Vec<[DVec3; 3]>);

impl Facets {
    const PER_TEXEL: u32 = 6;

    fn new(base: &Sphere, relief: &Surface) -> Self {
        let (width, height) = (relief.heights().width() * Self::PER_TEXEL, relief.heights().height() * Self::PER_TEXEL);
        let vertex = |i: u32, j: u32| {
            let uv = DVec2::new(f64::from(i) / f64::from(width), f64::from(j) / f64::from(height)) - 0.5;
            let (x, y) = relief.texel_of(uv);
            let point = base.point(uv);
            point.position + point.frame.normal * relief.heights().sample(x, y)
        };
        let mut triangles = Vec::new();
        for j in 0..height {
            for i in 0..width {
                let [a, b, c, d] = [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(k, l)| vertex(i + k, j + l));
                triangles.extend([[a, b, c], [a, c, d]]);
            }
        }
        Self(triangles)
    }

    fn blocks(&self, origin: DVec3, direction: DVec3) -> bool {
        self.0.iter().any(|&[a, b, c]| {
            let (along_b, along_c, from_a) = (b - a, c - a, origin - a);
            let across = direction.cross(along_c);
            let volume = along_b.dot(across);
            let up = from_a.cross(along_b);
            let (weight_b, weight_c) = (from_a.dot(across) / volume, direction.dot(up) / volume);
            // Beyond the facets that meet in the point itself.
            let distance = along_c.dot(up) / volume;
            distance > 1e-4 && weight_b >= 0.0 && weight_c >= 0.0 && weight_b + weight_c <= 1.0
        })
    }
}

#[test]
fn it_agrees_with_fine_triangles_of_the_displaced_ball() {
    let rough = field((16, 16), Edge::Clamp, |column, row| 4.0 * noise(3, column, row));
    let relief = relief(&rough);
    for chart in [SphereChart::Geographic, SphereChart::Stereographic] {
        let ball = ball(&rough, 14.0, chart);
        let shadow = DisplacedShadow::new(&ball, &relief, f64::INFINITY);
        let facets = Facets::new(&ball, &relief);
        let (mut shadows, mut different) = (0, 0);
        for k in 0..240_u32 {
            // Corners of facets in the middle of the patch, so that no ray meets its edge.
            let random = |salt| noise(salt, k, 0);
            let part = DVec2::new(random(5).into(), random(6).into()) * 0.4 - 0.2;
            let cells = f64::from(16 * Facets::PER_TEXEL);
            let uv = (part * cells).round() / cells;
            let light = towards(360.0 * f64::from(random(7)), 70.0 * f64::from(random(8)) - 10.0);
            let point = ball.point(uv);
            let (x, y) = relief.texel_of(uv);
            let origin = point.position + point.frame.normal * relief.heights().sample(x, y);
            let found = shadow.in_shadow(uv, light);
            shadows += u32::from(found);
            different += u32::from(found != facets.blocks(origin, light));
        }
        assert!(shadows > 40 && shadows < 200, "{shadows} shadows");
        assert!(different <= 3, "{different} of 240 differ: more than facets explain");
    }
}

#[test]
fn a_patch_that_is_a_ball_has_the_shadows_of_a_ball() {
    let bumps = example("reptile_skin", 48);
    let relief = relief(&bumps);
    let ball = ball(&bumps, 60.0, SphereChart::Stereographic);
    let patch = Patch::new(|uv| ball.point(uv), (DVec2::splat(-1.5), DVec2::splat(1.5)), (false, false), 24);
    let (closed, general) =
        (DisplacedShadow::new(&ball, &relief, f64::INFINITY), DisplacedShadow::new(&patch, &relief, f64::INFINITY));
    let mut shadows = 0;
    for k in 0..150 {
        let uv = DVec2::new(noise(1, k, 0).into(), noise(2, k, 0).into()) - 0.5;
        let light = towards(360.0 * f64::from(noise(3, k, 0)), 40.0 * f64::from(noise(4, k, 0)));
        assert_eq!(closed.in_shadow(uv, light), general.in_shadow(uv, light), "{uv} {light}");
        shadows += u32::from(closed.in_shadow(uv, light));
    }
    assert!(shadows > 20 && shadows < 130, "{shadows}");
}
