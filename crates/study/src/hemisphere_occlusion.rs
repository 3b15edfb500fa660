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
