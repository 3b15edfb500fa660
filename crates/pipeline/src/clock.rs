//! Where the time of a bake goes.

use std::time::Instant;

use crate::{Progress, StageTime};

/// Times stages and announces them.
pub(crate) struct Clock<'a> {
    progress: &'a Progress<'a>,
    stages: Vec<StageTime>,
}

impl<'a> Clock<'a> {
    pub(crate) fn new(progress: &'a Progress<'a>) -> Self {
        Self { progress, stages: Vec::new() }
    }

    /// A stage of its own: announced when it starts and when it ends.
    pub(crate) fn stage<T>(&mut self, stage: &'static str, work: impl FnOnce() -> T) -> T {
        self.announce(stage, 0, 1);
        let result = self.time(stage, work);
        self.announce(stage, 1, 1);
        result
    }

    /// Adds to a stage's time without a word: what is done anew for every direction.
    pub(crate) fn time<T>(&mut self, stage: &'static str, work: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let result = work();
        let seconds = start.elapsed().as_secs_f64();
        match self.stages.iter_mut().find(|known| known.stage == stage) {
            Some(known) => known.seconds += seconds,
            None => self.stages.push(StageTime { stage, seconds }),
        }
        result
    }

    /// Says how much of a stage is done.
    pub(crate) fn announce(&self, stage: &'static str, done: usize, total: usize) {
        (self.progress)(stage, done, total);
    }

    /// Stages in the order they began.
    pub(crate) fn into_stages(self) -> Vec<StageTime> {
        self.stages
    }
}
