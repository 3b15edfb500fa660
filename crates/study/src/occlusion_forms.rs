//! Occlusion where its closed form is known: before a wall, and on the plane.

use barchan_field::shapes::{Axis, Plane, StepWall};
use barchan_field::{Edge, Grid, LengthUnit, Shape, Spacing};
use barchan_shade::{Relief, TracedRelief};
use glam::DVec3;

use crate::hemisphere_occlusion::{self, Occlusions};
use crate::relief_method::Search;
use crate::relief_point::{ReliefPoint, traced_occlusion};
use crate::relief_tables::StoredSearch;
use crate::scenes::SIDE;
use crate::{Quantity, Record, Scene, Setting, StudyError, reliefs, tables};

/// Height of the wall over its distance.
const WALLS: [f64; 4] = [0.5, 1.0, 2.0, 4.0];

/// The wall and the plane.
pub(crate) fn scenes(size: u32) -> Result<[Scene; 2], StudyError> {
    Ok([wall(size)?, plane(size)?])
}

/// At the foot of the wall in several distances; on the plane in its middle.
pub(crate) fn records(study: &Occlusions<'_>, scene: &Scene) -> Result<Vec<Record>, StudyError> {
    let surface = tables::surface(&scene.field)?;
    let relief = Relief::new(&surface);
    let stored = study.tables(scene)?;
    let starts = hemisphere_occlusion::starts(&stored, &relief)?;
    let cones = StoredSearch::bake(Search::Cones, &scene.field, study.exec)?.of(&relief)?;
    let traced = TracedRelief::new(&relief);
    let by = |name: &str| Setting::default().with("by", name);
    let mut methods = vec![(by("traced"), traced_occlusion(&relief, &traced))];
    methods.extend(hemisphere_occlusion::methods(&relief, &starts, &*cones));
    let record = |by: &Setting, wall: &Wall, found: f64| {
        let setting = by.clone().with("height_over_distance", wall.ratio);
        Record { quantity: Some(Quantity::Occlusion), mean: Some(found), ..Record::new("closed_form", setting, scene) }
    };
    let mut records = Vec::new();
    for wall in walls(scene) {
        records.push(record(&by("closed_form"), &wall, wall.occlusion()));
        records.extend(methods.iter().map(|(by, method)| record(by, &wall, wall.point.occlusion(method))));
    }
    Ok(records)
}

/// A point on the ground before a wall.
struct Wall {
    point: ReliefPoint,
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
        Wall { point: ReliefPoint { place, depth: if ratio > 0.0 { 1.0 } else { 0.0 }, normal: DVec3::Z }, ratio }
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
