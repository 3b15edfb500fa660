//! How long work shows that it goes on.

use std::io::{IsTerminal, Write};
use std::sync::Mutex;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::args::ProgressStyleName;

/// Shows the stages of a bake on stderr.
pub(crate) enum ProgressDisplay {
    /// Nothing.
    Silent,
    /// A bar that is redrawn, for people.
    Bar { bar: ProgressBar, stage: Mutex<&'static str> },
    /// A line per step, for logs.
    Plain,
    /// An object per line, for machines.
    Json,
}

impl ProgressDisplay {
    pub(crate) fn new(style: ProgressStyleName) -> Self {
        match style {
            ProgressStyleName::None => Self::Silent,
            ProgressStyleName::Plain => Self::Plain,
            ProgressStyleName::Json => Self::Json,
            ProgressStyleName::Auto if std::io::stderr().is_terminal() => Self::bar(),
            ProgressStyleName::Auto => Self::Silent,
        }
    }

    fn bar() -> Self {
        let bar = ProgressBar::with_draw_target(Some(1), ProgressDrawTarget::stderr());
        let style = ProgressStyle::with_template("{msg:10} {bar:40} {pos}/{len}  {elapsed} (about {eta} left)");
        bar.set_style(style.expect("the template is well formed"));
        Self::Bar { bar, stage: Mutex::new("") }
    }

    /// One step of a stage is done.
    pub(crate) fn step(&self, stage: &'static str, done: usize, total: usize) {
        match self {
            Self::Silent => {}
            Self::Bar { bar, stage: shown } => {
                let mut shown = shown.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
                if *shown != stage {
                    *shown = stage;
                    bar.reset();
                    bar.set_message(stage);
                }
                bar.set_length(total as u64);
                bar.set_position(done as u64);
            }
            // A log that cannot be written must not stop the work it is about.
            Self::Plain => {
                let _ = writeln!(std::io::stderr(), "{stage} {done}/{total}");
            }
            Self::Json => {
                let line = serde_json::json!({
                    "schema": "barchan.progress/1", "stage": stage, "done": done, "total": total
                });
                let _ = writeln!(std::io::stderr(), "{line}");
            }
        }
    }

    /// Clears what was drawn.
    pub(crate) fn finish(&self) {
        if let Self::Bar { bar, .. } = self {
            bar.finish_and_clear();
        }
    }
}
