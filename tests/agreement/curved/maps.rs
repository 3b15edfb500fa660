//! Whole maps: every encoding and edge, any number of points, lights from everywhere.

use std::f64::consts::{FRAC_PI_2, TAU};

use barchan_asset::{
    Azimuths, DistanceTable, DistanceView, Encoding, HeightTable, HeightView, HorizonTable, HorizonView, MAX_ELEVATION,
    Semantic, SweptDistanceView, SweptHorizonView, Wrap,
};
use barchan_field::{Edge, Shape};
use barchan_pipeline::{Recipe, Scene, Table, TableEncoding};
use barchan_shade::{CurvedMethod, CurvedShadow, FundamentalForms, TangentFrame, TangentLight};
use barchan_view::Probe;
use barchan_wgpu::{Selection, TablePart, Technique};
use glam::{DVec2, DVec3};

use super::draw::evaluate;
use crate::compare::agree;
use crate::support::{self, ENCODINGS, Loaded, SAMPLINGS, bake, grid, noise, numbers, places};

const SIZE: (u32, u32) = (24, 20);

const DIRECTIONS: u32 = 8;

const TABLES: [Table; 5] = [Table::Height, Table::Horizon, Table::Distance, Table::SweptHorizon, Table::SweptDistance];

/// A map of three points for curvatures of both signs.
fn recipe(shape: &str, edge: Edge, encoding: TableEncoding) -> Recipe {
    let shape = Shape::examples().into_iter().find(|known| known.name() == shape).unwrap();
    let mut recipe = support::recipe(shape, SIZE, edge, encoding);
    recipe.scene = Some(Scene { curvature: Some((-0.02, 0.02)), ..Scene::default() });
    recipe.horizon.directions = DIRECTIONS;
    recipe.horizon.radius = Some(40.0);
    recipe.curved.points = Some(3);
    recipe
}

fn twin(loaded: &Loaded) -> CurvedShadow {
    let horizon = loaded.view(Semantic::HorizonElevation, HorizonView::new);
    let distance = loaded.view(Semantic::HorizonDistance, DistanceView::new);
    let heights = loaded.view(Semantic::Height, HeightView::new);
    let swept = loaded.plan.texture(Semantic::SweptElevation).map(|_| {
        let horizon = loaded.view(Semantic::SweptElevation, SweptHorizonView::new);
        (horizon, loaded.view(Semantic::SweptDistance, SweptDistanceView::new))
    });
    CurvedShadow::new(&horizon, &distance, swept.as_ref().map(|(h, d)| (h, d)), &heights).unwrap()
}

/// A place, the light it sees, and the curvature of the base along it.
#[derive(Debug, Clone, Copy)]
struct Seen {
    place: [f32; 2],
    azimuth: f32,
    elevation: f32,
    stretch: f32,
    curvature: f32,
}

impl Seen {
    /// Anywhere, beyond the edges too, under any light; azimuths between baked ones, exactly on one, half-way, and at either side of
    /// the seam.
    fn anywhere(index: u32) -> Self {
        let random = |seed| noise(seed, index);
        // A place that f32 keeps exactly.
        let along = |seed, texels: u32| (random(seed) * 64.0 * (texels as f32 + 20.0)).floor() / 64.0 - 10.0;
        let baked = (random(3) * DIRECTIONS as f32).floor() * (TAU as f32 / DIRECTIONS as f32);
        let azimuth = match index % 6 {
            0 => baked,
            1 => baked + 0.5 * TAU as f32 / DIRECTIONS as f32,
            2 => [-1e-4, 1e-4, -1e-9, TAU as f32 - 1e-3, TAU as f32][index as usize / 6 % 5],
            _ => (random(4) - 0.5) * TAU as f32,
        };
        let curvatures = [0.0, 1e-12, -1e-12, 0.004, -0.004, 0.015, -0.015, 0.02, -0.02];
        Self {
            place: [along(1, SIZE.0), along(2, SIZE.1)],
            azimuth,
            elevation: if index % 7 == 0 { 0.0 } else { random(5) * 1.6 - 0.5 },
            stretch: [0.5, 1.0, 1.0, 2.25][index as usize / 6 % 4],
            curvature: curvatures[index as usize % curvatures.len()],
        }
    }

    fn light(&self) -> TangentLight {
        let (sin, cos) = libm::sincosf(self.elevation);
        TangentLight {
            height: sin.into(),
            level: cos.into(),
            direction: DVec2::ZERO,
            azimuth_radians: self.azimuth.into(),
            stretch: self.stretch.into(),
        }
    }

    fn elevation_by(&self, twin: &CurvedShadow, method: CurvedMethod) -> f64 {
        twin.elevation_radians(method, self.texel(), &self.light(), self.curvature.into())
    }

    fn texel(&self) -> (f64, f64) {
        (self.place[0].into(), self.place[1].into())
    }
}

/// Elevation and shadow, by the GPU.
fn found(loaded: &Loaded, cases: &[Seen]) -> Vec<[f32; 4]> {
    let body = "let light = BarchanTangentLight(b.x, b.y, vec2<f32>(0.0), a.z, a.w);
    let elevation = barchan_curved_elevation(a.xy, light, b.z);
    return vec4<f32>(elevation, select(0.0, 1.0, barchan_is_below(light, elevation)), 0.0, 0.0);";
    let input = |case: &Seen| {
        let light = case.light();
        let [x, y] = case.place;
        [[x, y, case.azimuth, case.stretch], [light.height as f32, light.level as f32, case.curvature, 0.0], [0.0; 4]]
    };
    evaluate(loaded, body, &cases.iter().map(input).collect::<Vec<_>>())
}

/// Elevations agree to a tolerance, and shadows wherever the light is not within it of the horizon. Returns the worst.
#[track_caller]
fn check(name: &str, loaded: &Loaded, twin: &CurvedShadow, method: CurvedMethod, cases: &[Seen]) -> f64 {
    let found = found(loaded, cases);
    let expected: Vec<f64> = cases.iter().map(|case| case.elevation_by(twin, method)).collect();
    let worst = agree(name, (cases.len() as u32, 1), &numbers(&found, 0), &expected, TOLERANCE, 0.0);
    let mut dark = 0;
    for ((case, found), expected) in cases.iter().zip(&found).zip(&expected) {
        let shadow = twin.in_shadow(method, case.texel(), &case.light(), case.curvature.into());
        let is_near = (f64::from(case.elevation) - expected).abs() <= TOLERANCE;
        assert!(is_near || shadow == (found[1] == 1.0), "{name}: {case:?} under a horizon of {expected}");
        dark += usize::from(shadow);
    }
    assert!((cases.len() / 20..cases.len() * 19 / 20).contains(&dark), "{dark} of {} are dark", cases.len());
    eprintln!("{name}: {worst:e}, {dark} of {} dark", cases.len());
    worst
}

/// In radians. f32 has azimuths to 4e-7, and horizons of neighbouring ones are up to π apart within π/4.
const TOLERANCE: f64 = 3e-6;

fn anywhere() -> Vec<Seen> {
    (0..6000).map(Seen::anywhere).collect()
}

#[test]
fn every_encoding_and_edge_gives_the_horizon_of_the_cpu() {
    for encoding in ENCODINGS {
        for edge in [Edge::Wrap, Edge::Clamp] {
            let loaded = Loaded::baked(recipe("reptile_skin", edge, encoding), &TABLES);
            let name = format!("curved_{encoding:?}_{edge:?}");
            check(&name, &loaded, &twin(&loaded), CurvedMethod::Exact(3), &anywhere());
        }
    }
}

#[test]
fn as_many_points_as_are_loaded_are_looked_at() {
    for shape in ["reptile_skin", "cylinder_bumps", "fractal_terrain"] {
        let bytes = bake(recipe(shape, Edge::Wrap, TableEncoding::F16), &TABLES);
        let candidates = |count| TablePart { candidates: Some(count), ..TablePart::default() };
        let with = |count| {
            let part = Selection::everything().with_part(Semantic::SweptElevation, candidates(count));
            part.with_part(Semantic::SweptDistance, candidates(count))
        };
        let flat = Selection::tables(&[Semantic::Height, Semantic::HorizonElevation, Semantic::HorizonDistance]);
        let whole = twin(&Loaded::new(bytes.clone()));
        let cases = anywhere();
        for (points, selection) in [(1, flat), (2, with(1)), (3, with(2))] {
            let loaded = Loaded::selected(bytes.clone(), &selection);
            check(&format!("points_{shape}_{points}"), &loaded, &whole, CurvedMethod::Exact(points), &cases);
        }
        let raised = |points| {
            let by = |case: &Seen, points| case.elevation_by(&whole, CurvedMethod::Exact(points));
            cases.iter().filter(|case| by(case, points) > by(case, points - 1) + 0.01).count()
        };
        // Half-cylinders side by side have nothing for a third.
        let third = if shape == "cylinder_bumps" { 0 } else { 10 };
        assert!(raised(2) > 100 && raised(3) >= third, "{shape}: {} and {} horizons are raised", raised(2), raised(3));
    }
}

/// Loaded alone, azimuths from −90° to 45° serve lights between them; beyond, the nearer end stands for all.
#[test]
fn an_arc_across_the_seam_serves_lights_within() {
    let bytes = bake(recipe("fractal_terrain", Edge::Wrap, TableEncoding::F32), &TABLES);
    let arc = TablePart { azimuths: Some((6, 4)), ..TablePart::default() };
    let directional =
        [Semantic::HorizonElevation, Semantic::HorizonDistance, Semantic::SweptElevation, Semantic::SweptDistance];
    let selection = directional.iter().fold(Selection::everything(), |all, table| all.with_part(*table, arc));
    let loaded = Loaded::selected(bytes, &selection);
    let mut cases = anywhere();
    for case in &mut cases {
        let degrees = f64::from(case.azimuth).to_degrees();
        // Round to the arc: (−90, 45), and both ends.
        case.azimuth = (-90.0 + degrees.rem_euclid(135.0)).to_radians() as f32;
    }
    check("arc", &loaded, &twin(&loaded), CurvedMethod::Exact(3), &cases);
    let beyond = |degrees: f64, end: f64| {
        let at = |degrees: f64| cases.iter().map(move |case| Seen { azimuth: degrees.to_radians() as f32, ..*case });
        let found = found(&loaded, &at(degrees).collect::<Vec<_>>());
        let whole = twin(&loaded);
        let expected: Vec<f64> = at(end).map(|case| case.elevation_by(&whole, CurvedMethod::Exact(3))).collect();
        agree("beyond_the_arc", (cases.len() as u32, 1), &numbers(&found, 0), &expected, TOLERANCE, 0.0);
    };
    beyond(60.0, 45.0);
    beyond(-120.0, 270.0);
    beyond(150.0, 45.0);
}

/// Heights far below the base, and horizons so low that the smooth surface through the lowest relief stands above them.
#[test]
fn no_horizon_is_lower_than_the_surface_through_the_lowest_relief() {
    let (grid, azimuths) = (grid((3, 1), (1.0, 1.0), (Wrap::Repeat, Wrap::Clamp)), Azimuths::full_circle(1));
    let radius = 10.0;
    let loaded = Loaded::of_tables([
        HeightTable { grid, values: &[-12.0, 5.0, 0.0] }.encode(Encoding::F32).unwrap(),
        HorizonTable { grid, azimuths, radius, values: &[-1.4, -1.3, -0.02] }.encode(Encoding::F32).unwrap(),
        DistanceTable { grid, azimuths, radius, values: &[0.5, 3.0, 8.0] }.encode(Encoding::F32).unwrap(),
    ]);
    let cases: Vec<_> = anywhere().into_iter().map(|case| Seen { elevation: case.elevation - 0.5, ..case }).collect();
    check("floor", &loaded, &twin(&loaded), CurvedMethod::Exact(1), &cases);
}

/// A texel whose relief reaches the centre of the hollow in front of it.
#[test]
fn under_a_closed_sky_the_zenith_is_lit_and_nothing_comes_from_below() {
    let (grid, azimuths) = (grid((1, 1), (1.0, 1.0), (Wrap::Repeat, Wrap::Repeat)), Azimuths::full_circle(4));
    let radius = 10.0;
    let loaded = Loaded::of_tables([
        HeightTable { grid, values: &[0.0] }.encode(Encoding::F32).unwrap(),
        HorizonTable { grid, azimuths, radius, values: &[MAX_ELEVATION; 4] }.encode(Encoding::F32).unwrap(),
        DistanceTable { grid, azimuths, radius, values: &[2.0; 4] }.encode(Encoding::F32).unwrap(),
    ]);
    let body = "let light = BarchanTangentLight(a.x, a.y, vec2<f32>(0.0), 0.3, 1.0);
    let is_dark = barchan_curved_in_shadow(vec2<f32>(0.25), light, a.z);
    return vec4<f32>(select(0.0, 1.0, is_dark), barchan_curved_elevation(vec2<f32>(0.25), light, a.z), 0.0, 0.0);";
    for curvature in [-0.25, 0.0, 0.25] {
        let lights = [[1.0, 0.0], [-1.0, 0.0], [0.999, 0.045]];
        let inputs = lights.map(|[height, level]| [[height, level, curvature, 0.0], [0.0; 4], [0.0; 4]]);
        let found = evaluate(&loaded, body, &inputs);
        // On a ball a wall leans back by γ.
        let elevation = if curvature > 0.0 { FRAC_PI_2 - 0.5 } else { FRAC_PI_2 };
        let expected = [0.0, 1.0, if curvature > 0.0 { 0.0 } else { 1.0 }];
        for (found, expected) in found.iter().zip(expected) {
            assert!(f64::from(found[0]) == expected && (f64::from(found[1]) - elevation).abs() < 3e-7, "{found:?}");
        }
    }
}

/// Pu and Pv in the tangent plane, by columns.
const CHARTS: [[[f32; 2]; 2]; 4] =
    [[[18.0, 0.0], [0.0, 25.0]], [[40.0, 5.0], [-12.0, 20.0]], [[-30.0, 2.0], [4.0, 31.0]], [[9.0, 0.0], [3.0, -60.0]]];

/// e, f, g of a ball, a hollow and a saddle in a chart, whose first form is given.
fn second_forms([e, f, g]: [f32; 3]) -> [[f32; 3]; 3] {
    [[e, f, g].map(|number| 0.015 * number), [e, f, g].map(|number| -0.01 * number), [0.01 * e, 0.2, -0.01 * g]]
}

/// All of it at once, from a light in space to pictures of what every place sees.
#[test]
fn probes_draw_what_the_cpu_finds_in_any_chart() {
    let loaded = Loaded::baked(recipe("reptile_skin", Edge::Wrap, TableEncoding::Compact), &TABLES);
    let twin = twin(&loaded);
    let passes = SAMPLINGS.map(|sampling| loaded.pass(&[Technique::CurvedShadow], sampling));
    for (index, [[ux, uy], [vx, vy]]) in CHARTS.into_iter().enumerate() {
        let (along_u, along_v) = ([ux, uy, 0.0], [vx, vy, 0.0]);
        let first_form = [ux * ux + uy * uy, ux * vx + uy * vy, vx * vx + vy * vy];
        for (second_form, (azimuth, elevation)) in second_forms(first_form)
            .into_iter()
            .zip([(20.0, 12.0), (200.0, 40.0), (100.0, 0.0), (300.0, -15.0)].into_iter().cycle().skip(index))
        {
            let light = support::light(azimuth, elevation).towards;
            let probe = Probe {
                size: (32, 24),
                place: [-4.0, -2.5],
                step: [1.0625, 1.125],
                light: light.as_vec3().to_array(),
                first_form,
                second_form,
                along: [along_u, along_v],
                ..Probe::default()
            };
            let found = passes.each_ref().map(|pass| pass.draw(&probe).unwrap());
            assert_eq!(found[0], found[1], "texels are loaded either way");
            let vector = |v: [f32; 3]| DVec3::from_array(v.map(f64::from));
            let frame = TangentFrame::new(vector(along_u), vector(along_v), ux * vy < uy * vx).unwrap();
            assert_eq!(frame.normal, DVec3::Z);
            let seen = TangentLight::new(&frame, light, twin.extent());
            let forms = FundamentalForms { first: first_form.map(f64::from), second: second_form.map(f64::from) };
            let curvature = forms.along(seen.direction.x, seen.direction.y);
            let places = places(&probe);
            let horizon = |place| twin.elevation_radians(CurvedMethod::Exact(3), place, &seen, curvature);
            let elevations: Vec<f64> = places.iter().map(|&place| horizon(place)).collect();
            let name = format!("curved_chart_{index}_{azimuth}");
            let worst = agree(&name, probe.size, &numbers(&found[0], 0), &elevations, 1e-5, 0.0);
            let shadow = |place| f64::from(u8::from(twin.in_shadow(CurvedMethod::Exact(3), place, &seen, curvature)));
            let shadows: Vec<f64> = places.iter().map(|&place| shadow(place)).collect();
            agree(&format!("{name}_shadow"), probe.size, &numbers(&found[0], 1), &shadows, 0.0, 0.0);
            let all = vec![curvature; places.len()];
            agree(&format!("{name}_curvature"), probe.size, &numbers(&found[0], 2), &all, 1e-8, 0.0);
            let all = vec![seen.azimuth_radians; places.len()];
            agree(&format!("{name}_azimuth"), probe.size, &numbers(&found[0], 3), &all, 1e-6, 0.0);
            eprintln!("{name}: {worst:e}, {} dark", shadows.iter().sum::<f64>());
        }
    }
}
