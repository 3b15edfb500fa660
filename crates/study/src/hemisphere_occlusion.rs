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

use barchan_bakers::Exec;
use barchan_shade::{
    DepthMapStart, HemisphereOcclusion, HemisphereQuadrature, MAP_TOLERANCE, Occlusion, Relief, ReliefRoad,
    ReliefSearch, ReliefShadow, SHADOW_TOLERANCE, TracedRelief,
};

use crate::hemisphere_spec::{HemisphereSpec, Layers, MODES, StoredHemisphere};
use crate::relief_method::Search;
use crate::relief_point::{ReliefPoint, traced_occlusion};
use crate::relief_search::MAX_POLAR;
use crate::relief_tables::StoredSearch;
use crate::runner::{Observer, Step};
use crate::timer::{Contestant, Pace, race};
use crate::{
    Item, Norms, Quantity, Record, Scale, Scene, Setting, StudyError, occlusion_forms, relief_shadow, reliefs, tables,
};

/// The reliefs whose occlusion is looked at; shadow is on all five.
const RELIEFS: [&str; 3] = ["smooth", "fractal", "bricks"];

/// The study.
pub struct Occlusions<'a> {
    /// Texels along the sides of tables; the last one is that of shadows.
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

/// The study and its reliefs.
///
/// # Errors
/// A relief that cannot be made.
pub fn parts<'a>(scale: Scale, exec: &'a Exec<'a>) -> Result<(Occlusions<'a>, Vec<Scene>), StudyError> {
    let (texels, sizes, points, shadows, seconds): (_, &[u32], _, _, _) = match scale {
        Scale::Full => (256, &[32, 64], 500, 10_000, 0.3),
        Scale::Quick => (32, &[4, 8], 20, 100, 0.0),
    };
    let scenes = reliefs::FIVE.map(|name| reliefs::by_name(name, texels)).into_iter().collect::<Result<_, _>>()?;
    Ok((Occlusions { sizes, points, shadows, exec, pace: Pace { seconds, max_rounds: 5 } }, scenes))
}

/// The records of all reliefs, and of the closed forms.
///
/// # Errors
/// A bake that is refused.
pub fn measure(
    study: &Occlusions<'_>,
    scenes: &[Scene],
    observe: &mut Observer<'_>,
) -> Result<Vec<Record>, StudyError> {
    let mut records = Vec::new();
    for (done, scene) in scenes.iter().enumerate() {
        observe(&Step { done, total: scenes.len() + 2, what: &scene.name });
        let surface = tables::surface(&scene.field)?;
        let relief = Relief::new(&surface);
        let cones = StoredSearch::bake(Search::Cones, &scene.field, study.exec)?.of(&relief)?;
        if RELIEFS.contains(&scene.name.as_str()) {
            records.extend(study.occlusions(scene, &relief, &*cones)?);
        }
        records.extend(relief_shadow::records(study, (scene, &relief), &*cones)?);
    }
    let size = scenes.first().map_or(32, |scene| scene.field.grid().width);
    for (done, scene) in occlusion_forms::scenes(size)?.iter().enumerate() {
        observe(&Step { done: scenes.len() + done, total: scenes.len() + 2, what: &scene.name });
        records.extend(occlusion_forms::records(study, scene)?);
    }
    Ok(records)
}

impl Occlusions<'_> {
    /// By the map alone, in every mode and size, and by rays over its cells.
    fn occlusions(
        &self,
        scene: &Scene,
        relief: &Relief<'_>,
        cones: &dyn ReliefSearch,
    ) -> Result<Vec<Record>, StudyError> {
        let points: Vec<ReliefPoint> = (0..self.points).map(|index| ReliefPoint::anywhere(relief, index)).collect();
        let traced = TracedRelief::new(relief);
        let truth = traced_occlusion(relief, &traced);
        let expected: Vec<f64> = points.iter().map(|point| point.occlusion(&truth)).collect();
        let stored = self.tables(scene)?;
        let starts = starts(&stored, relief)?;
        let methods = methods(relief, &starts, cones);
        let timings = race(&mut contestants(&methods, &points), &self.pace, &mut |_| ())?;
        let judged = methods.iter().zip(&timings).map(|((setting, method), timing)| {
            let found: Vec<_> = points.iter().map(|point| method.at(point.place, point.depth, point.normal)).collect();
            let errors: Vec<f64> =
                found.iter().zip(&expected).map(|(found, expected)| found.share - expected).collect();
            let mean = |of: fn(&Occlusion) -> u32| {
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
        let truth =
            Record { quantity: Some(Quantity::Occlusion), samples: Some(self.points), mean: Some(mean), ..truth };
        Ok([truth].into_iter().chain(judged).collect())
    }

    /// Both modes in all sizes.
    pub(crate) fn tables(&self, scene: &Scene) -> Result<Vec<(HemisphereSpec, StoredHemisphere)>, StudyError> {
        let specs = MODES.into_iter().flat_map(|mode| {
            self.sizes.iter().map(move |&size| HemisphereSpec { mode, size, ..HemisphereSpec::conservative(MAX_POLAR) })
        });
        specs.map(|spec| Ok((spec, spec.bake(&scene.field, Layers::All, self.exec)?))).collect()
    }
}

/// Where rays start by each table.
pub(crate) fn starts<'a>(
    stored: &'a [(HemisphereSpec, StoredHemisphere)],
    relief: &Relief<'_>,
) -> Result<Vec<(HemisphereSpec, DepthMapStart<'a>)>, StudyError> {
    stored.iter().map(|(spec, stored)| Ok((*spec, stored.start(relief)?))).collect()
}

/// By each map alone, and by rays over its cells that it starts.
pub(crate) fn methods<'a>(
    relief: &Relief<'a>,
    starts: &'a [(HemisphereSpec, DepthMapStart<'a>)],
    search: &'a dyn ReliefSearch,
) -> Vec<(Setting, HemisphereOcclusion<'a>)> {
    let both = |(spec, start): &'a (HemisphereSpec, DepthMapStart<'a>)| {
        let setting = Setting::default().with("mode", spec.mode_name()).with("size", spec.size);
        let road = ReliefRoad { depth_map: Some(start), search };
        let shadow = ReliefShadow { relief: *relief, road, tolerance: SHADOW_TOLERANCE };
        let quadrature = HemisphereQuadrature::of_cells(&spec.directions());
        [
            (setting.clone().with("by", "map"), HemisphereOcclusion::of_map(relief, start, MAP_TOLERANCE)),
            (setting.with("by", "rays"), HemisphereOcclusion::of_rays(quadrature, shadow)),
        ]
    };
    starts.iter().flat_map(both).collect()
}

fn contestants<'a>(
    methods: &'a [(Setting, HemisphereOcclusion<'a>)],
    points: &'a [ReliefPoint],
) -> Vec<Contestant<'a, f64>> {
    let contestant = |(_, method): &'a (Setting, HemisphereOcclusion<'a>)| Contestant {
        name: String::new(),
        work: Box::new(move || Ok(points.iter().map(|point| point.occlusion(method)).sum())),
    };
    methods.iter().map(contestant).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn records() -> Vec<Record> {
        let exec = Exec::new(1).unwrap();
        let (study, mut scenes) = parts(Scale::Quick, &exec).unwrap();
        scenes.retain(|scene| scene.name == "fractal");
        measure(&study, &scenes, &mut |_| ()).unwrap()
    }

    fn sum(records: &[Record], technique: &str, (name, value): (&str, &str), of: fn(&Record) -> Option<f64>) -> f64 {
        let some =
            records.iter().filter(|record| record.technique == technique && record.setting.get(name) == Some(value));
        some.filter_map(of).sum()
    }

    #[test]
    fn rays_are_nearer_to_the_truth_than_the_map_alone_and_the_safe_road_is_the_truth() {
        let records = records();
        let error = |by: &str| sum(&records, "hemisphere_occlusion", ("by", by), |record| record.rms);
        assert!(error("rays") < 0.5 * error("map"), "{} {}", error("rays"), error("map"));
        let wrong = |road: &str| sum(&records, "relief_shadow", ("road", road), |record| record.wrong_share);
        assert!(wrong("conservative_cone_steps") == 0.0 && wrong("linear") > 0.0, "{}", wrong("linear"));
    }

    #[test]
    fn traced_occlusion_is_that_of_the_closed_forms() {
        let exec = Exec::new(1).unwrap();
        let (study, _) = parts(Scale::Quick, &exec).unwrap();
        let study = Occlusions { sizes: &[4], ..study };
        let scenes = occlusion_forms::scenes(32).unwrap();
        let records: Vec<Record> =
            scenes.iter().flat_map(|scene| occlusion_forms::records(&study, scene).unwrap()).collect();
        let of = |by: &str| -> Vec<f64> {
            let of = records.iter().filter(|record| record.setting.get("by") == Some(by));
            of.filter_map(|record| record.mean).collect()
        };
        let (traced, closed) = (of("traced"), of("closed_form"));
        assert_eq!((closed.len(), traced[4], closed[4]), (5, 0.0, 0.0));
        assert!(
            traced.iter().zip(&closed).all(|(traced, closed)| (traced - closed).abs() < 0.02),
            "{traced:?} {closed:?}"
        );
    }
}
