//! Ambient occlusion and shadow from hemisphere depths, against closed forms and traced rays.
//!
//! # Occlusion
//!
//! Eq 3 of Takeshi Suzuki, *An Accelerated Relief Mapping Using Depth Maps*, at points anywhere on the relief: by the map alone, one fetch a
//! direction, for tables of both modes and several sizes; and by a shadow ray for each of the map's directions. The truth is a traced
//! ray for each of 1024 directions of equal weight. An infinitely long wall of height H at a distance d has a closed form,
//! ½ (1 − 1 / √(1 + k²)), k = H / d, and the plane has none to speak of: 0.
//!
//! # Shadow
//!
//! Section 4.1: a ray comes down from where the light enters the top plane, and what it meets before the point shades it. Held
//! against the same question asked of the exact trace, at the same tolerance.

use std::f64::consts::TAU;

use barchan_bakers::Exec;
use barchan_field::shapes::{Axis, Plane, StepWall};
use barchan_field::{Edge, Grid, HeightField, LengthUnit, Shape, Spacing};
use barchan_shade::{
    ConeSteps, DepthMapStart, HemisphereOcclusion, HemisphereQuadrature, LinearSearch, MAP_TOLERANCE, Relief, ReliefRoad,
    ReliefSearch, ReliefShadow, SHADOW_TOLERANCE, Surface, TracedRelief,
};
use glam::DVec3;

use crate::hemisphere_spec::{HemisphereSpec, Layers, MODES};
use crate::relief_method::Search;
use crate::relief_rays::towards;
use crate::relief_search::MAX_POLAR;
use crate::relief_tables::SearchTables;
use crate::runner::{Observer, Step};
use crate::sample::unit;
use crate::scenes::SIDE;
use crate::timer::{Contestant, Pace, race};
use crate::{Item, Norms, Quantity, Record, Scale, Scene, Setting, StudyError, reliefs, tables};

/// Height of the wall over its distance.
pub(crate) const WALLS: [f64; 4] = [0.5, 1.0, 2.0, 4.0];

/// Angles of lights from the normal, degrees.
const LIGHTS: [f64; 3] = [30.0, 60.0, 75.0];

/// Rings and azimuths of the traced truth.
const TRUTH: (u32, u32) = (32, 32);

/// The study.
pub struct Occlusions<'a> {
    /// Texels along the sides of tables; the middle one also feeds rays.
    pub sizes: &'static [u32],
    /// Points per relief.
    pub points: u64,
    /// Shadow tests per relief and angle of the light.
    pub shadows: u64,
    /// How bakes run.
    pub exec: &'a Exec<'a>,
    /// How long all methods are timed on a relief.
    pub pace: Pace,
}

/// A point of a relief.
struct Point {
    place: (f64, f64),
    depth: f64,
    normal: DVec3,
}

/// The study and its reliefs.
///
/// # Errors
/// A relief that cannot be made.
pub fn parts<'a>(scale: Scale, exec: &'a Exec<'a>) -> Result<(Occlusions<'a>, Vec<Scene>), StudyError> {
    let (texels, sizes, points, shadows, seconds): (_, &[u32], _, _, _) = match scale {
        Scale::Full => (256, &[32, 64, 128], 500, 10_000, 0.3),
        Scale::Quick => (32, &[8, 16], 20, 100, 0.0),
    };
    let scenes = reliefs::FIVE.map(|name| reliefs::by_name(name, texels)).into_iter().collect::<Result<_, _>>()?;
    Ok((Occlusions { sizes, points, shadows, exec, pace: Pace { seconds, max_rounds: 5 } }, scenes))
}

/// The records of all reliefs, and of the closed forms.
///
/// # Errors
/// A bake that is refused.
pub fn measure(study: &Occlusions<'_>, scenes: &[Scene], observe: &mut Observer<'_>) -> Result<Vec<Record>, StudyError> {
    let mut records = Vec::new();
    for (done, scene) in scenes.iter().enumerate() {
        observe(&Step { done, total: scenes.len() + 2, what: &scene.name });
        let surface = tables::surface(&scene.field)?;
        let relief = Relief::new(&surface);
        let searches = SearchTables::bake(&scene.field, &[Search::Cones], study.exec)?;
        let cones = searches.search(&relief, Search::Cones)?;
        records.extend(study.occlusions(scene, &relief, &*cones)?);
        records.extend(study.shadows(scene, &relief, &*cones)?);
    }
    let size = scenes.first().map_or(32, |scene| scene.field.grid().width);
    for (done, scene) in [wall(size)?, plane(size)?].iter().enumerate() {
        observe(&Step { done: scenes.len() + done, total: scenes.len() + 2, what: &scene.name });
        records.extend(study.closed_forms(scene)?);
    }
    Ok(records)
}

impl Occlusions<'_> {
    /// By the map alone, in every mode and size, and by rays over its cells.
    fn occlusions(&self, scene: &Scene, relief: &Relief<'_>, cones: &dyn ReliefSearch) -> Result<Vec<Record>, StudyError> {
        let points: Vec<Point> = (0..self.points).map(|index| Point::anywhere(relief, index)).collect();
        let traced = TracedRelief::new(relief);
        let truth = traced_occlusion(relief, &traced);
        let expected: Vec<f64> = points.iter().map(|point| point.occlusion(&truth)).collect();
        let stored = self.tables(scene)?;
        let starts = stored.iter().map(|(spec, stored)| Ok((spec, stored.start(relief)?)));
        let starts = starts.collect::<Result<Vec<_>, StudyError>>()?;
        let mut methods: Vec<(Setting, HemisphereOcclusion<'_>)> = Vec::new();
        for (spec, start) in &starts {
            let setting = Setting::default().with("mode", spec.mode_name()).with("size", spec.size);
            methods.push((setting.clone().with("by", "map"), HemisphereOcclusion::of_map(relief, start, MAP_TOLERANCE)));
            let road = ReliefRoad { depth_map: Some(start), search: cones };
            let shadow = ReliefShadow { relief: *relief, road, tolerance: SHADOW_TOLERANCE };
            let quadrature = HemisphereQuadrature::of_cells(&spec.directions());
            methods.push((setting.with("by", "rays"), HemisphereOcclusion::of_rays(quadrature, shadow)));
        }
        let timings = race(&mut contestants(&methods, &points), &self.pace, &mut |_| ())?;
        let judged = methods.iter().zip(&timings).map(|((setting, method), timing)| {
            let found: Vec<_> = points.iter().map(|point| method.at(point.place, point.depth, point.normal)).collect();
            let errors: Vec<f64> = found.iter().zip(&expected).map(|(found, expected)| found.share - expected).collect();
            let mean = |of: fn(&barchan_shade::Occlusion) -> u32| {
                Some(found.iter().map(|found| f64::from(of(found))).sum::<f64>() / found.len() as f64)
            };
            let record = Record::new("hemisphere_occlusion", setting.clone(), scene);
            let record = record.with_norms(Quantity::Occlusion, &Norms::of(&errors));
            Record {
                height_fetches: mean(|found| found.fetches.heights),
                table_fetches: mean(|found| found.fetches.tables),
                ..record.with_timing(timing, Item::Pixel, points.len() as f64)
            }
        });
        let mean = expected.iter().sum::<f64>() / expected.len() as f64;
        let truth = Record::new("hemisphere_occlusion", Setting::default().with("by", "traced"), scene);
        let truth = Record { quantity: Some(Quantity::Occlusion), samples: Some(self.points), mean: Some(mean), ..truth };
        Ok([truth].into_iter().chain(judged).collect())
    }

    /// The paper's road, the safe one, and both against the trace.
    fn shadows(&self, scene: &Scene, relief: &Relief<'_>, cones: &dyn ReliefSearch) -> Result<Vec<Record>, StudyError> {
        let middle = self.sizes[self.sizes.len() / 2];
        let baked = |spec: HemisphereSpec| {
            HemisphereSpec { size: middle, ..spec }.bake(&scene.field, Layers::AtAngles(&LIGHTS), self.exec)
        };
        let (nearest, conservative) = (baked(HemisphereSpec::paper(MAX_POLAR))?, baked(HemisphereSpec::conservative(MAX_POLAR))?);
        let (nearest, conservative) = (nearest.start(relief)?, conservative.start(relief)?);
        let (traced, linear) = (TracedRelief::new(relief), LinearSearch::new(relief, STEPS, BISECTIONS));
        let roads: [(&str, ReliefRoad<'_>); 3] = [
            ("linear", ReliefRoad { depth_map: None, search: &linear }),
            ("nearest_linear", ReliefRoad { depth_map: Some(&nearest), search: &linear }),
            ("conservative_cone_steps", ReliefRoad { depth_map: Some(&conservative), search: cones }),
        ];
        let shadow = |road| ReliefShadow { relief: *relief, road, tolerance: SHADOW_TOLERANCE };
        let truth = shadow(ReliefRoad { depth_map: None, search: &traced });
        let mut records = Vec::new();
        for angle in LIGHTS {
            let tests: Vec<(Point, DVec3)> = (0..self.shadows).map(|index| test(relief, angle, index)).collect();
            let decide = |shadow: &ReliefShadow<'_>| -> Vec<_> {
                tests.iter().map(|(point, light)| shadow.at(point.place, point.depth, *light)).collect()
            };
            let expected = decide(&truth);
            for (name, road) in roads {
                let found = decide(&shadow(road));
                let wrong = found.iter().zip(&expected).filter(|(found, expected)| found.in_shadow != expected.in_shadow);
                let count = found.len() as f64;
                let mean = |of: fn(&ShadowAnswer) -> u32| Some(found.iter().map(|found| f64::from(of(found))).sum::<f64>() / count);
                let setting = Setting::default().with("road", name).with("angle", angle);
                records.push(Record {
                    quantity: Some(Quantity::ReliefShadow),
                    samples: Some(self.shadows),
                    wrong_share: Some(wrong.count() as f64 / count),
                    mean: Some(expected.iter().filter(|answer| answer.in_shadow).count() as f64 / count),
                    height_fetches: mean(|found| found.fetches.heights),
                    table_fetches: mean(|found| found.fetches.tables),
                    ..Record::new("relief_shadow", setting, scene)
                });
            }
        }
        Ok(records)
    }

    /// At the foot of the wall in several distances; on the plane in its middle.
    fn closed_forms(&self, scene: &Scene) -> Result<Vec<Record>, StudyError> {
        let surface = tables::surface(&scene.field)?;
        let relief = Relief::new(&surface);
        let stored = self.tables(scene)?;
        let traced = TracedRelief::new(&relief);
        let record = |by: Setting, wall: &Wall, found: f64| {
            let setting = by.with("height_over_distance", wall.ratio);
            Record { quantity: Some(Quantity::Occlusion), mean: Some(found), ..Record::new("closed_form", setting, scene) }
        };
        let mut records = Vec::new();
        for wall in walls(scene) {
            let by = |name: &str| Setting::default().with("by", name);
            records.push(record(by("closed_form"), &wall, wall.occlusion()));
            records.push(record(by("traced"), &wall, wall.point.occlusion(&traced_occlusion(&relief, &traced))));
            for (spec, stored) in &stored {
                let start = stored.start(&relief)?;
                let map = HemisphereOcclusion::of_map(&relief, &start, MAP_TOLERANCE);
                let by = by("map").with("mode", spec.mode_name()).with("size", spec.size);
                records.push(record(by, &wall, wall.point.occlusion(&map)));
            }
        }
        Ok(records)
    }

    /// Both modes in all sizes.
    fn tables(&self, scene: &Scene) -> Result<Vec<(HemisphereSpec, StoredHemisphere)>, StudyError> {
        let specs = MODES.into_iter().flat_map(|mode| {
            self.sizes.iter().map(move |&size| HemisphereSpec { mode, size, ..HemisphereSpec::conservative(MAX_POLAR) })
        });
        specs.map(|spec| Ok((spec, spec.bake(&scene.field, Layers::All, self.exec)?))).collect()
    }
}

/// The truth of a relief: rays of equal weight, each traced.
fn traced_occlusion<'a>(relief: &Relief<'a>, traced: &'a TracedRelief<'a>) -> HemisphereOcclusion<'a> {
    let road = ReliefRoad { depth_map: None, search: traced };
    let shadow = ReliefShadow { relief: *relief, road, tolerance: SHADOW_TOLERANCE };
    HemisphereOcclusion::of_rays(HemisphereQuadrature::even(TRUTH.0, TRUTH.1), shadow)
}

fn contestants<'a>(
    methods: &'a [(Setting, HemisphereOcclusion<'a>)],
    points: &'a [Point],
) -> Vec<Contestant<'a, f64>> {
    let contestant = |(_, method): &'a (Setting, HemisphereOcclusion<'a>)| Contestant {
        name: String::new(),
        work: Box::new(move || Ok(points.iter().map(|point| point.occlusion(method)).sum())),
    };
    methods.iter().map(contestant).collect()
}

impl Point {
    /// One of many, the same in every run.
    fn anywhere(relief: &Relief<'_>, index: u64) -> Self {
        let surface = relief.surface();
        let along = |part: u64, texels: u32| unit(2 * index + part) * f64::from(texels) - 0.5;
        let (x, y) = (along(0, surface.heights().width()), along(1, surface.heights().height()));
        Self { place: (x, y), depth: relief.depth_at(x, y), normal: surface.normal(x, y) }
    }

    fn occlusion(&self, method: &HemisphereOcclusion<'_>) -> f64 {
        method.at(self.place, self.depth, self.normal).share
    }
}

/// A point and the light that it is asked about.
fn test(relief: &Relief<'_>, angle_degrees: f64, index: u64) -> (Point, DVec3) {
    let azimuth = TAU * unit(1_000_000_007 + index);
    (Point::anywhere(relief, index), towards(angle_degrees.to_radians(), azimuth))
}

/// A point on the ground before a wall.
struct Wall {
    point: Point,
    /// The wall's height over its distance.
    ratio: f64,
}

impl Wall {
    /// Of a wall without ends, for a level normal.
    fn occlusion(&self) -> f64 {
        0.5 * (1.0 - 1.0 / libm::sqrt(1.0 + self.ratio * self.ratio))
    }
}

/// The wall's brink is the centre of the first high column: the bilinear surface climbs up to there.
fn walls(scene: &Scene) -> Vec<Wall> {
    let grid = scene.field.grid();
    let middle = f64::from(grid.height / 2);
    let high = f64::from(scene.field.range().1 - scene.field.range().0);
    let wall = |ratio: f64| {
        let distance = if ratio > 0.0 { high / (ratio * grid.spacing.u()) } else { 0.0 };
        let place = (f64::from(grid.width / 2) - distance, middle);
        Wall { point: Point { place, depth: if ratio > 0.0 { 1.0 } else { 0.0 }, normal: DVec3::Z }, ratio }
    };
    if high > 0.0 { WALLS.map(wall).into() } else { vec![wall(0.0)] }
}

/// A step as high as all reliefs are deep, without an end to either side.
fn wall(size: u32) -> Result<Scene, StudyError> {
    let step = StepWall { height: reliefs::DEPTH * SIDE, position: 0.5, across: Axis::U };
    closed_form("wall", &Shape::StepWall(step), size)
}

fn plane(size: u32) -> Result<Scene, StudyError> {
    closed_form("plane", &Shape::Plane(Plane { slope_u: 0.0, slope_v: 0.0 }), size)
}

fn closed_form(name: &str, shape: &Shape, size: u32) -> Result<Scene, StudyError> {
    let spacing = Spacing::square(SIDE / f64::from(size.max(1)))?;
    let grid = Grid { width: size, height: size, spacing, unit: LengthUnit::SceneUnit, edge: Edge::Clamp };
    Ok(Scene { name: name.to_owned(), field: shape.rasterize(grid)? })
}
