//! How exact horizon maps are: each method against the f64 [`reference`](mod@reference).
//!
//! # Two errors
//!
//! **Elevation**: found minus true, in degrees. That is what a shadow is decided by.
//!
//! **Distance**: a wrong distance at an equal slope is no error. On a level field every point is the horizon, and two
//! summits may be as high as each other to the last bit; whichever is named, the light goes dark behind it at the same
//! elevation. So the surface is looked up at the distance found: the *point is right* if the texel sees it no more than
//! [`POINT_TOLERANCE_DEGREES`] below the true horizon, and its distance error is 0. Else the point is wrong, and its error is
//! (found − true) / true, the true distance taken as one texel at least. The share of wrong points stands beside the norms,
//! which are over all points.
//!
//! # What is looked at
//!
//! Every texel of a small map in a few azimuths; of a large one a fixed pseudo-random sample, whose truth is found ray by ray.

use barchan_bakers::Exec;
use barchan_bakers::horizon::{self, Azimuths, HorizonMap, HorizonParams, Method, reference};
use barchan_field::{Grid, HeightField};

use crate::horizon_point::View;
use crate::horizon_speed::quarter;
use crate::runner::Study;
use crate::sample::scramble;
use crate::{Norms, Quantity, Record, Scale, Scene, Setting, Stopwatch, StudyError, scenes};

/// How far below the horizon a point may be seen and still count as the horizon: about what f16 rounds away.
pub const POINT_TOLERANCE_DEGREES: f64 = 0.02;

/// The study: every method on each scene.
pub struct Accuracy<'a> {
    /// The azimuths of one bake each; errors are summarised over all.
    pub azimuths: Vec<Azimuths>,
    /// Places looked at per bake; `None` for every texel and azimuth.
    pub samples: Option<u64>,
    /// How bakes run.
    pub exec: &'a Exec<'a>,
}

/// What the reference says.
pub struct Truth {
    bakes: Vec<(HorizonParams, Vec<TruePoint>)>,
}

/// A place that is looked at, and its horizon.
struct TruePoint {
    direction: u32,
    texel: u32,
    elevation_degrees: f64,
    distance: f64,
}

/// The parts of the study, each with its scenes: small maps whole, large ones by sample. `more` are further small ones.
///
/// # Errors
/// A scene that cannot be made.
pub fn parts<'a>(
    scale: Scale,
    exec: &'a Exec<'a>,
    more: Vec<Scene>,
) -> Result<Vec<(Accuracy<'a>, Vec<Scene>)>, StudyError> {
    let (small, large, samples) = match scale {
        Scale::Full => (256, 1024, 20_000),
        Scale::Quick => (32, 64, 500),
    };
    let every: Result<Vec<_>, _> = scenes::names().into_iter().map(|name| scenes::by_name(name, small)).collect();
    let sampled: Result<Vec<_>, _> =
        ["dunes", "fractal_terrain", "white_noise"].into_iter().map(|name| scenes::by_name(name, large)).collect();
    // Axes and diagonals; and 11, which has no multiple of 45° but 0. The reference is two hundred times slower than a bake.
    let azimuths = [8, 11].map(Azimuths::full_circle).to_vec();
    let whole = Accuracy { azimuths, samples: None, exec };
    let sample = Accuracy { azimuths: vec![quarter(32)], samples: Some(samples), exec };
    Ok(vec![(whole, every?.into_iter().chain(more).collect()), (sample, sampled?)])
}

impl Study for Accuracy<'_> {
    type Setting = Method;
    type Truth = Truth;

    fn settings(&self) -> Vec<Method> {
        Method::ALL.to_vec()
    }

    fn truth(&self, scene: &Scene) -> Result<Truth, StudyError> {
        let bake = |azimuths: &Azimuths| {
            let params = params(scene.field.grid(), *azimuths, Method::Exact);
            params.check(&scene.field)?;
            let points = match self.samples {
                None => every_point(&reference::bake(&scene.field, &params, self.exec)?),
                Some(samples) => sampled_points(&scene.field, &params, samples),
            };
            Ok((params, points))
        };
        Ok(Truth { bakes: self.azimuths.iter().map(bake).collect::<Result<_, StudyError>>()? })
    }

    fn measure(&self, scene: &Scene, truth: &Truth, method: &Method) -> Result<Vec<Record>, StudyError> {
        let mut errors = Errors::default();
        let mut seconds = 0.0;
        for (params, points) in &truth.bakes {
            let watch = Stopwatch::start();
            let map = horizon::bake(&scene.field, &HorizonParams { method: *method, ..*params }, self.exec)?;
            seconds += watch.elapsed().core_seconds();
            errors.add(&scene.field, &map, points);
        }
        Ok(errors.records(scene, &self.setting(*method), seconds))
    }
}

impl Accuracy<'_> {
    fn setting(&self, method: Method) -> Setting {
        let counts: Vec<String> = self.azimuths.iter().map(|azimuths| azimuths.count().to_string()).collect();
        let looked_at = if self.samples.is_some() { "sample" } else { "all" };
        Setting::default().with("method", method.name()).with("directions", counts.join("+")).with("texels", looked_at)
    }
}

fn params(grid: &Grid, azimuths: Azimuths, method: Method) -> HorizonParams {
    HorizonParams { azimuths, radius: HorizonParams::default_radius(grid), distance: true, method }
}

fn every_point(map: &HorizonMap) -> Vec<TruePoint> {
    let texels = map.grid.texels();
    let distances = map.distance.as_deref().unwrap_or_default();
    let point = |(index, (&elevation, &distance)): (usize, (&f32, &f32))| TruePoint {
        direction: (index / texels) as u32,
        texel: (index % texels) as u32,
        elevation_degrees: f64::from(elevation).to_degrees(),
        distance: f64::from(distance),
    };
    map.elevation_radians.iter().zip(distances).enumerate().map(point).collect()
}

fn sampled_points(field: &HeightField, params: &HorizonParams, samples: u64) -> Vec<TruePoint> {
    let (width, texels) = (field.grid().width, field.grid().texels() as u64);
    let point = |sample: u64| {
        let direction = (scramble(2 * sample) % u64::from(params.directions())) as u32;
        let texel = (scramble(2 * sample + 1) % texels) as u32;
        let found = reference::horizon(field, params, direction, texel % width, texel / width);
        let elevation_degrees = libm::atan(found.slope).to_degrees();
        TruePoint { direction, texel, elevation_degrees, distance: found.distance }
    };
    (0..samples).map(point).collect()
}

/// Errors of all bakes of one scene, in a fixed order.
#[derive(Default)]
struct Errors {
    elevation_degrees: Vec<f64>,
    distance_share: Vec<f64>,
    wrong_points: u64,
}

impl Errors {
    fn add(&mut self, field: &HeightField, map: &HorizonMap, points: &[TruePoint]) {
        let (grid, texels) = (map.grid, map.grid.texels());
        let texel_length = grid.spacing.u().min(grid.spacing.v());
        for point in points {
            let index = point.direction as usize * texels + point.texel as usize;
            let elevation_degrees = f64::from(map.elevation_radians[index]).to_degrees();
            self.elevation_degrees.push(elevation_degrees - point.elevation_degrees);
            let Some(distances) = &map.distance else { continue };
            let distance = f64::from(distances[index]);
            let towards = map.params.azimuths.vector(point.direction);
            let view = View { field, towards, column: point.texel % grid.width, row: point.texel / grid.width };
            let right = distance == point.distance || is_right(&view, distance, point.elevation_degrees);
            let share = (distance - point.distance) / point.distance.max(texel_length);
            self.distance_share.push(if right { 0.0 } else { share });
            self.wrong_points += u64::from(!right);
        }
    }

    fn records(&self, scene: &Scene, setting: &Setting, bake_seconds: f64) -> Vec<Record> {
        let record = |quantity, errors: &[f64]| {
            let record = Record::new("horizon", setting.clone(), scene).with_norms(quantity, &Norms::of(errors));
            Record { bake_seconds: Some(bake_seconds), ..record }
        };
        let elevation = record(Quantity::ElevationDegrees, &self.elevation_degrees);
        let mut distance = record(Quantity::DistanceShare, &self.distance_share);
        distance.wrong_share = Some(self.wrong_points as f64 / (self.distance_share.len() as f64).max(1.0));
        vec![elevation, distance]
    }
}

/// Whether the texel sees the point at a distance as high as its horizon.
fn is_right(view: &View<'_>, distance: f64, horizon_degrees: f64) -> bool {
    view.elevation_degrees(distance) >= horizon_degrees - POINT_TOLERANCE_DEGREES
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run;

    fn study(exec: &Exec<'_>, name: &str, samples: Option<u64>) -> Vec<Record> {
        let study = Accuracy { azimuths: vec![Azimuths::full_circle(8)], samples, exec };
        run(&study, &[scenes::by_name(name, 24).unwrap()], &mut |_| ()).unwrap()
    }

    #[test]
    fn exact_has_neither_error_whether_all_is_looked_at_or_a_sample() {
        let exec = Exec::new(1).unwrap();
        for samples in [None, Some(100)] {
            for name in ["white_noise", "constant", "step_wall"] {
                let records = study(&exec, name, samples);
                let exact: Vec<_> =
                    records.iter().filter(|record| record.setting.get("method") == Some("exact")).collect();
                assert_eq!(exact.len(), 2);
                assert!(exact[0].max < Some(1e-4) && exact[1].wrong_share == Some(0.0), "{name}: {exact:?}");
                assert_eq!(exact[0].samples, Some(samples.unwrap_or(24 * 24 * 8)));
            }
        }
    }

    #[test]
    fn on_a_level_field_every_distance_is_right() {
        let field = scenes::by_name("constant", 16).unwrap().field;
        let params = params(field.grid(), Azimuths::full_circle(4), Method::Exact);
        let exec = Exec::new(1).unwrap();
        let mut map = reference::bake(&field, &params, &exec).unwrap();
        let points = every_point(&map);
        map.distance.as_mut().unwrap().fill(3.5);
        let mut errors = Errors::default();
        errors.add(&field, &map, &points);
        assert_eq!((errors.wrong_points, errors.distance_share.iter().all(|&share| share == 0.0)), (0, true));
    }

    #[test]
    fn a_lower_point_is_wrong_by_its_distance() {
        let field = scenes::by_name("spike", 16).unwrap().field;
        let params = params(field.grid(), Azimuths::full_circle(4), Method::Exact);
        let exec = Exec::new(1).unwrap();
        let mut map = reference::bake(&field, &params, &exec).unwrap();
        let points = every_point(&map);
        // The spike stands in the middle; the texel two to its left sees it at 90°, two texels away.
        let (spike, _) = field.samples().iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1)).unwrap();
        assert_eq!(points[spike - 2].distance, 2.0 * field.grid().spacing.u());
        map.distance.as_mut().unwrap()[spike - 2] = 3.0 * field.grid().spacing.u() as f32;
        let mut errors = Errors::default();
        errors.add(&field, &map, &points);
        assert_eq!((errors.wrong_points, errors.distance_share[spike - 2]), (1, 0.5));
    }
}
