//! How fast hemisphere depths are baked: by mode, by texels of the height map, by texels of the table, by threads, and the
//! promise, 512² heights in 512 directions.
//!
//! # What is timed
//!
//! A baker made and its layers baked, without encoding, on the fractal relief in the default directions. But for the promise
//! only one layer of 23 is baked: 23 has no factor in common with 16 azimuths, so every azimuth and every part of the
//! rings has its share. A ray is one texel of the height map in one direction, whatever the mode and the size of the table:
//! the same map is as many rays, and what differs is the time.

use std::hint::black_box;

use barchan_asset::DepthMode;
use barchan_bakers::Exec;
use barchan_bakers::hemisphere::HemisphereBaker;

use crate::hemisphere_spec::{HemisphereSpec, MODES};
use crate::relief_search::MAX_POLAR;
use crate::runner::{Observer, Step};
use crate::timer::{Contestant, Pace, Spread, Timing, race};
use crate::{Item, Record, Scale, Scene, Setting, Stopwatch, StudyError, reliefs};

/// Of this many layers one is baked.
const EVERY: usize = 23;

/// The relief that is baked.
const RELIEF: &str = "fractal";

/// One bake: its mode, texels along the sides of the height map and of the table, threads.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Case {
    varied: &'static str,
    mode: DepthMode,
    texels: u32,
    size: u32,
    threads: usize,
}

/// The study.
pub struct Speed {
    /// Texels along the sides of height maps, the one of the other cases last but one.
    pub texels: [u32; 3],
    /// Texels along the sides of tables.
    pub sizes: &'static [u32],
    /// All cores of the machine.
    pub cores: usize,
    /// How long cases that differ in one thing are timed.
    pub pace: Pace,
}

/// The study on so many cores.
#[must_use]
pub fn study(scale: Scale, cores: usize) -> Speed {
    match scale {
        Scale::Full => Speed {
            texels: [128, 256, 512],
            sizes: &[16, 32, 64, 128],
            cores,
            pace: Pace { seconds: 4.0, max_rounds: 5 },
        },
        Scale::Quick => {
            Speed { texels: [8, 16, 24], sizes: &[2, 4, 8], cores, pace: Pace { seconds: 0.0, max_rounds: 1 } }
        }
    }
}

/// The records of all cases.
///
/// # Errors
/// A bake that is refused.
pub fn measure(study: &Speed, observe: &mut Observer<'_>) -> Result<Vec<Record>, StudyError> {
    let mut records = Vec::new();
    for (varied, cases) in [("texels", study.by_texels()), ("size", study.by_size()), ("threads", study.by_threads())] {
        let cases: Vec<Case> =
            MODES.into_iter().flat_map(|mode| cases.iter().map(move |case| Case { mode, varied, ..*case })).collect();
        records.extend(study.race(&cases, observe)?);
    }
    for (done, mode) in MODES.into_iter().enumerate() {
        observe(&Step { done, total: MODES.len(), what: "the promise" });
        records.push(study.promise(mode)?);
    }
    Ok(records)
}

impl Speed {
    fn middle(&self) -> Case {
        let [_, texels, _] = self.texels;
        let size = self.sizes[self.sizes.len() / 2];
        Case { varied: "", mode: DepthMode::Nearest, texels, size, threads: 1 }
    }

    /// But for the middle, which is among the sizes.
    fn by_texels(&self) -> Vec<Case> {
        let [small, _, large] = self.texels;
        [small, large].map(|texels| Case { texels, ..self.middle() }).into()
    }

    fn by_size(&self) -> Vec<Case> {
        self.sizes.iter().map(|&size| Case { size, ..self.middle() }).collect()
    }

    /// But for one, likewise.
    fn by_threads(&self) -> Vec<Case> {
        [self.cores]
            .into_iter()
            .filter(|&threads| threads > 1)
            .map(|threads| Case { threads, ..self.middle() })
            .collect()
    }

    fn race(&self, cases: &[Case], observe: &mut Observer<'_>) -> Result<Vec<Record>, StudyError> {
        let scenes = cases.iter().map(|case| reliefs::by_name(RELIEF, case.texels)).collect::<Result<Vec<_>, _>>()?;
        let execs = cases.iter().map(|case| Exec::new(case.threads)).collect::<Result<Vec<_>, _>>()?;
        let contestant = |((case, scene), exec): ((&Case, _), _)| {
            let spec = case.spec();
            let name = format!("{:?}, {}² to {}², {} threads", case.mode, case.texels, case.size, case.threads);
            Contestant { name, work: Box::new(move || bake(&spec, scene, EVERY, exec)) }
        };
        let mut contestants: Vec<_> = cases.iter().zip(&scenes).zip(&execs).map(contestant).collect();
        let timings = race(&mut contestants, &self.pace, observe)?;
        let record = |((case, scene), timing): ((&Case, &Scene), &Timing)| case.record(scene, timing, EVERY);
        Ok(cases.iter().zip(&scenes).zip(&timings).map(record).collect())
    }

    /// The largest height map in all directions on all cores, once.
    fn promise(&self, mode: DepthMode) -> Result<Record, StudyError> {
        let case = Case { varied: "promise", mode, texels: self.texels[2], threads: self.cores, ..self.middle() };
        let scene = reliefs::by_name(RELIEF, case.texels)?;
        let exec = Exec::new(case.threads)?;
        let watch = Stopwatch::start();
        black_box(bake(&case.spec(), &scene, 1, &exec)?);
        let elapsed = watch.elapsed();
        let once = |seconds: f64| Spread::of(&[seconds]);
        let timing = Timing { rounds: 1, wall: once(elapsed.wall_seconds), cpu: elapsed.cpu_seconds.map(once) };
        Ok(case.record(&scene, &timing, 1))
    }
}

impl Case {
    fn spec(&self) -> HemisphereSpec {
        HemisphereSpec { mode: self.mode, size: self.size, ..HemisphereSpec::conservative(MAX_POLAR) }
    }

    fn record(&self, scene: &Scene, timing: &Timing, every: usize) -> Record {
        let spec = self.spec();
        let layers = (spec.directions().layers() as usize).div_ceil(every);
        let setting = Setting::default().with("varied", self.varied).with("mode", spec.mode_name());
        let setting = setting.with("size", self.size).with("layers", layers).with("threads", self.threads);
        let rays = scene.field.samples().len() * layers;
        let record = Record::new("hemisphere", setting, scene).with_timing(timing, Item::Ray, rays as f64);
        Record { bake_seconds: Some(timing.cpu.unwrap_or(timing.wall).median), ..record }
    }
}

/// The layers, one of so many.
fn bake(spec: &HemisphereSpec, scene: &Scene, every: usize, exec: &Exec<'_>) -> Result<Vec<f32>, StudyError> {
    let baker = HemisphereBaker::new(&scene.field, spec.params(), exec)?;
    let mut values = vec![0.0; spec.size as usize * spec.size as usize];
    for layer in (0..spec.directions().layers()).step_by(every) {
        baker.bake_layer(layer, exec, &mut values);
    }
    Ok(values)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_case_is_timed_in_both_modes() {
        let records = measure(&study(Scale::Quick, 2), &mut |_| ()).unwrap();
        let count = |varied: &str| records.iter().filter(|record| record.setting.get("varied") == Some(varied)).count();
        assert_eq!(["texels", "size", "threads", "promise"].map(count), [4, 6, 2, 2]);
        assert!(records.iter().all(|record| record.wall_ns > Some(0.0)));
    }

    #[test]
    fn the_promise_is_of_all_directions() {
        let record = study(Scale::Quick, 1).promise(DepthMode::Nearest).unwrap();
        assert_eq!((record.setting.get("layers"), record.width), (Some("512"), 24));
        let rays = 24.0 * 24.0 * 512.0;
        assert!((record.core_ns().unwrap() * rays * 1e-9 / record.bake_seconds.unwrap() - 1.0).abs() < 1e-9);
    }
}
