//! Settings × scenes → records.

use crate::{Record, Scene, StudyError};

/// Where a run stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Step<'a> {
    /// Measurements finished.
    pub done: usize,
    /// Measurements in all.
    pub total: usize,
    /// What is measured next.
    pub what: &'a str,
}

/// Told of every step before it is taken.
pub type Observer<'a> = dyn FnMut(&Step<'_>) + 'a;

/// What is measured of a scene, at each of several settings, against a truth that is found once.
pub trait Study {
    /// What is varied.
    type Setting;
    /// What results are held against.
    type Truth;

    /// The settings, in the order of the records.
    fn settings(&self) -> Vec<Self::Setting>;

    /// The truth about a scene.
    fn truth(&self, scene: &Scene) -> Result<Self::Truth, StudyError>;

    /// The records of one scene at one setting.
    fn measure(&self, scene: &Scene, truth: &Self::Truth, setting: &Self::Setting) -> Result<Vec<Record>, StudyError>;
}

/// Runs a study scene by scene, so that one truth is kept in memory at a time.
///
/// # Errors
/// The first error ends the run.
pub fn run<S: Study>(study: &S, scenes: &[Scene], observe: &mut Observer<'_>) -> Result<Vec<Record>, StudyError> {
    let settings = study.settings();
    let total = scenes.len() * settings.len();
    let mut records = Vec::new();
    for (index, scene) in scenes.iter().enumerate() {
        let before = index * settings.len();
        observe(&Step { done: before, total, what: &format!("{}: the truth", scene.name) });
        let truth = study.truth(scene)?;
        for (done, setting) in settings.iter().enumerate() {
            observe(&Step { done: before + done, total, what: &scene.name });
            records.extend(study.measure(scene, &truth, setting)?);
        }
    }
    Ok(records)
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::*;
    use crate::{Setting, scenes};

    struct Counting {
        truths: Cell<u32>,
    }

    impl Study for Counting {
        type Setting = u32;
        type Truth = u32;

        fn settings(&self) -> Vec<u32> {
            vec![10, 20]
        }

        fn truth(&self, _: &Scene) -> Result<u32, StudyError> {
            self.truths.set(self.truths.get() + 1);
            Ok(self.truths.get())
        }

        fn measure(&self, scene: &Scene, truth: &u32, setting: &u32) -> Result<Vec<Record>, StudyError> {
            let setting = Setting::default().with("truth", truth).with("of", setting);
            Ok(vec![Record::new("counting", setting, scene)])
        }
    }

    #[test]
    fn scenes_come_one_after_the_other_each_with_one_truth() {
        let scenes = ["constant", "spike"].map(|name| scenes::by_name(name, 4).unwrap());
        let study = Counting { truths: Cell::new(0) };
        let mut seen = Vec::new();
        let mut observe = |step: &Step<'_>| seen.push(format!("{} {}/{}", step.what, step.done, step.total));
        let records = run(&study, &scenes, &mut observe).unwrap();
        let order: Vec<_> = records.iter().map(|record| format!("{} {}", record.scene, record.setting)).collect();
        assert_eq!(
            order,
            ["constant truth=1 of=10", "constant truth=1 of=20", "spike truth=2 of=10", "spike truth=2 of=20"]
        );
        assert_eq!(study.truths.get(), 2);
        let words = "constant: the truth 0/4, constant 0/4, constant 1/4, spike: the truth 2/4, spike 2/4, spike 3/4";
        assert_eq!(seen.join(", "), words);
    }
}
