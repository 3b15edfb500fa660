//! The equations by themselves: one stored point on a curved base, the smooth surface's own horizon, curvature along a direction.

use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::sync::OnceLock;

use barchan_asset::{Azimuths, DistanceTable, Encoding, HeightTable, HorizonTable, MAX_ELEVATION, Wrap};
use barchan_field::surfaces::ParametricSurface;
use barchan_shade::{Correction, FundamentalForms, StoredPoint, geometric_horizon};
use glam::DVec2;

use super::draw::evaluate;
use crate::compare::agree;
use crate::support::{Loaded, grid, numbers};

/// The least asset that shadows on curved surfaces are compiled for.
pub(super) fn least() -> &'static Loaded {
    static LEAST: OnceLock<Loaded> = OnceLock::new();
    LEAST.get_or_init(|| {
        let (grid, azimuths) = (grid((1, 1), (1.0, 1.0), (Wrap::Clamp, Wrap::Clamp)), Azimuths::full_circle(1));
        let radius = 1.0;
        Loaded::of_tables([
            HeightTable { grid, values: &[0.0] }.encode(Encoding::F32).unwrap(),
            HorizonTable { grid, azimuths, radius, values: &[0.0] }.encode(Encoding::F32).unwrap(),
            DistanceTable { grid, azimuths, radius, values: &[0.0] }.encode(Encoding::F32).unwrap(),
        ])
    })
}

/// One of the four numbers against what was expected of each input, in one line of pixels.
pub(super) fn agree_in_a_line(name: &str, found: &[[f32; 4]], which: usize, expected: &[f64], tolerance: f64) -> f64 {
    agree(name, (expected.len() as u32, 1), &numbers(found, which), expected, tolerance, 0.0)
}

/// A point as a texel sees it, on a base surface: what `barchan_carried_slope` takes.
#[derive(Debug, Clone, Copy)]
struct Carried {
    curvature: f32,
    stretch: f32,
    height: f32,
    elevation: f32,
    distance: f32,
}

impl Carried {
    /// By the CPU twin, in radians.
    fn expected(&self) -> f64 {
        let [curvature, stretch, height] = [self.curvature, self.stretch, self.height].map(f64::from);
        let slope = libm::tan(f64::from(self.elevation)) / stretch;
        let point = StoredPoint { slope, distance: f64::from(self.distance) * stretch };
        libm::atan(Correction::Exact.slope(point, curvature, height))
    }

    /// γ, by which the point stands round the surface's centre.
    fn angle(&self) -> f64 {
        f64::from(self.curvature) * f64::from(self.distance) * f64::from(self.stretch)
    }

    /// 1 + κh: by how much arcs at the texel's height are longer than at the base.
    fn raised(&self) -> f64 {
        1.0 + f64::from(self.curvature) * f64::from(self.height)
    }
}

/// The elevations that a shader finds.
fn carry(cases: &[Carried]) -> Vec<[f32; 4]> {
    let body = "let ground = barchan_ground(a.x, a.y, 0.0);
    let elevation = barchan_sine_cosine(b.x);
    let point = BarchanPoint(elevation.x, max(elevation.y, BARCHAN_LEAST_COSINE), b.y);
    let slope = barchan_carried_slope(ground, point, a.z);
    return vec4<f32>(barchan_arctangent(slope), slope, 0.0, 0.0);";
    let input = |case: &Carried| {
        let Carried { curvature, stretch, height, elevation, distance } = *case;
        [[curvature, stretch, height, 0.0], [elevation, distance, 0.0, 0.0], [0.0; 4]]
    };
    evaluate(least(), body, &cases.iter().map(input).collect::<Vec<_>>())
}

/// Curvatures of both signs, none, and hardly any.
const CURVATURES: [f32; 13] = [0.0, 1e-30, -1e-30, 1e-12, -1e-12, 1e-6, -1e-6, 0.005, -0.005, 0.015, -0.015, 0.2, -0.2];

/// From wall to wall.
const ELEVATIONS: [f32; 9] = [-MAX_ELEVATION, -1.5, -0.6, -1e-4, 0.0, 1e-4, 0.6, 1.5, MAX_ELEVATION];

#[test]
fn a_point_is_carried_over_to_any_curvature() {
    let mut cases = Vec::new();
    for curvature in CURVATURES {
        for stretch in [0.25, 1.0, 3.5] {
            for height in [-3.0, 0.0, 4.0_f32] {
                for elevation in ELEVATIONS {
                    // At the texel, near it, and as far as it may be seen from.
                    for distance in [0.0, 1e-3, 1.0, 16.0, 100.0, 1e4_f32] {
                        cases.push(Carried { curvature, stretch, height, elevation, distance });
                    }
                }
            }
        }
    }
    // Where a point is at the limit of being seen, either answer is right.
    cases.retain(|case| (case.angle() - FRAC_PI_2).abs() > 1e-5 && (case.angle() + PI).abs() > 1e-5);
    let (found, expected): (_, Vec<f64>) = (carry(&cases), cases.iter().map(Carried::expected).collect());
    let unseen = expected.iter().filter(|elevation| **elevation < -1.57).count();
    assert!(unseen * 2 < cases.len(), "{unseen} of {} are not seen", cases.len());
    // Near the centre of a hollow of 5, heights of 4 stand at a fifth of the radius.
    let worst = agree_in_a_line("carried", &found, 0, &expected, 1e-6);
    eprintln!("carried {} points: {worst:e}", cases.len());
    assert!(found.iter().all(|slope| slope[1].abs() <= 3.4e38), "no slope is infinite");
}

/// Just inside and just outside of a quarter round a ball, and of half round a hollow.
#[test]
fn points_leave_sight_where_they_do_for_the_cpu() {
    let mut cases = Vec::new();
    for (limit, curvature) in [(FRAC_PI_2, 0.01_f32), (PI, -0.01)] {
        for off in [-1e-2, -1e-4, -1e-5, 1e-5, 1e-4, 1e-2] {
            let distance = ((limit + off) / f64::from(curvature.abs())) as f32;
            for elevation in ELEVATIONS {
                cases.push(Carried { curvature, stretch: 1.0, height: 2.0, elevation, distance });
            }
        }
    }
    let (found, expected): (_, Vec<f64>) = (carry(&cases), cases.iter().map(Carried::expected).collect());
    let worst = agree_in_a_line("limits", &found, 0, &expected, 1e-6);
    eprintln!("limits: {worst:e}");
}

/// 1 + κh near 0: what f32 rounds off κh is the more the less is left.
#[test]
fn near_the_centre_of_a_hollow_elevations_lose_what_is_left_of_the_radius() {
    let mut cases = Vec::new();
    for left in [1e-1_f32, 1e-2, 1e-3, -1e-3] {
        for elevation in [-1.2, -0.3, 0.0, 0.4, 1.3] {
            for distance in [0.0, 0.1, 3.0, 50.0] {
                let curvature = -0.0123;
                cases.push(Carried { curvature, stretch: 1.0, height: (1.0 - left) / -curvature, elevation, distance });
            }
        }
    }
    let found = carry(&cases);
    let mut worst = 0.0_f64;
    for (case, found) in cases.iter().zip(&found) {
        let off = (f64::from(found[0]) - case.expected()).abs() * case.raised().abs();
        assert!(off < 3e-7, "{case:?} is seen at {} instead of {}", found[0], case.expected());
        worst = worst.max(off);
    }
    eprintln!("centre: {worst:e} / (1 + κh)");
}

#[test]
fn the_smooth_surface_hides_what_lies_beyond_its_own_horizon() {
    let mut cases = Vec::new();
    for curvature in CURVATURES {
        for lowest in [-20.0, -1.0, 0.0, 3.0_f32] {
            for above in [0.0, 1e-6, 0.3, 5.0, 80.0_f32] {
                cases.push((curvature, lowest, lowest + above));
            }
        }
    }
    let body = "let slope = barchan_smooth_slope(barchan_ground(a.x, 1.0, a.y), a.z);
    return vec4<f32>(barchan_arctangent(slope), 0.0, 0.0, 0.0);";
    let inputs =
        cases.iter().map(|&(curvature, lowest, height)| [[curvature, lowest, height, 0.0], [0.0; 4], [0.0; 4]]);
    let found = evaluate(least(), body, &inputs.collect::<Vec<_>>());
    let expected = |&(curvature, lowest, height): &(f32, f32, f32)| {
        let [curvature, lowest, height] = [curvature, lowest, height].map(f64::from);
        libm::atan(geometric_horizon(curvature / (1.0 + curvature * lowest), height - lowest))
    };
    let expected: Vec<f64> = cases.iter().map(expected).collect();
    let worst = agree_in_a_line("smooth", &found, 0, &expected, 3e-7);
    eprintln!("smooth: {worst:e}");
}

/// What the closed forms of surfaces say: κ1 cos² + κ2 sin² of the angle to the principal direction.
#[test]
fn curvature_along_a_direction_is_that_of_closed_forms() {
    let (mut inputs, mut expected, mut conditions) = (Vec::new(), Vec::new(), Vec::new());
    for surface in ParametricSurface::examples() {
        for (u, v) in [(0.1, 0.3), (0.35, 0.62), (0.8, 0.45)] {
            let jet = surface.jet(u, v);
            let (forms, truth) = (jet.forms(), jet.curvature());
            let greatest = truth.principal[0].abs().max(truth.principal[1].abs());
            for k in 0..24 {
                let direction = DVec2::from_angle(TAU * f64::from(k) / 24.0) * [1.0, 1e-25, 1e25][k as usize % 3];
                let along = (jet.du * direction.x + jet.dv * direction.y).normalize();
                let [first, second] = truth.directions.map(|principal| principal.dot(along).powi(2));
                expected.push((truth.principal[0] * first + truth.principal[1] * second) / greatest);
                let [e, f, g] = forms.first;
                conditions.push(e * g / (e * g - f * f));
                inputs.push(forms_along(forms.first, forms.second, [direction.x, direction.y], greatest));
            }
        }
    }
    assert!(conditions.iter().all(|&condition| condition < 10.0), "no chart here is nearly folded");
    let found = evaluate(least(), CURVATURE, &inputs);
    let worst = agree_in_a_line("closed_forms", &found, 0, &expected, 2e-6);
    eprintln!("closed forms: {worst:e}");
}

const CURVATURE: &str =
    "return vec4<f32>(barchan_curvature_along(a.xyz, b.xyz, vec2<f32>(a.w, b.w)) / c.x, 0.0, 0.0, 0.0);";

fn forms_along(first: [f64; 3], second: [f64; 3], [du, dv]: [f64; 2], unit: f64) -> [[f32; 4]; 3] {
    let with = |[x, y, z]: [f64; 3], w: f64| [x, y, z, w].map(|number| number as f32);
    [with(first, du), with(second, dv), with([unit, 0.0, 0.0], 0.0)]
}

#[test]
fn without_a_direction_it_is_the_mean_and_without_an_area_flat() {
    let cylinder = FundamentalForms { first: [4.0, 1.0, 2.0], second: [2.0, 0.5, 0.125] };
    let flat = FundamentalForms { first: [0.0; 3], second: [1.0, 0.0, 1.0] };
    let line = FundamentalForms { first: [1.0, 1.0, 1.0], second: [1.0, 0.0, 1.0] };
    // Along (1, −1) a chart folded into a line has no length.
    let cases =
        [(cylinder, [0.0, 0.0]), (flat, [0.0, 0.0]), (flat, [1.0, 0.0]), (line, [1.0, -1.0]), (line, [0.0, 2.0])];
    let inputs = cases.map(|(forms, direction)| forms_along(forms.first, forms.second, direction, 1.0));
    let expected = cases.map(|(forms, [du, dv])| forms.along(du, dv));
    assert_eq!(expected[1..], [0.0, 0.0, 0.0, 1.0]);
    agree_in_a_line("no_direction", &evaluate(least(), CURVATURE, &inputs), 0, &expected, 1e-7);
}
