//! `barchan bake`: a recipe, a height map or a mesh to a file.

mod recipe;
mod words;

use std::path::{Path, PathBuf};
use std::time::Instant;

use barchan_asset::WriteError;
use barchan_pipeline::{BakeReport, PipelineError, Plan, Run, StageTime, bake};
use serde::Serialize;

pub(crate) use self::words::{LayerCounts, layer_words};
use crate::args::{BakeArguments, ProgressStyleName};
use crate::console;
use crate::failure::{ExitStatus, Failure};
use crate::output::{self, PendingFile};
use crate::progress::ProgressDisplay;

/// The report of the pipeline, and where the file went.
#[derive(Serialize)]
struct Report<'a> {
    #[serde(flatten)]
    bake: &'a BakeReport,
    output: String,
    total_seconds: f64,
}

pub(crate) fn run(arguments: &BakeArguments, progress: ProgressStyleName, json: bool) -> Result<ExitStatus, Failure> {
    let start = Instant::now();
    let recipe = recipe::recipe(arguments)?;
    let output = output_path(arguments)?;
    output::check_writable(&output, &arguments.input)?;
    let plan = Plan::new(recipe, arguments.only.as_deref());
    let display = ProgressDisplay::new(progress);
    let folder = arguments.input.parent().unwrap_or(Path::new(""));
    // A bare file's path is as typed, a recipe's paths start at the recipe.
    let folder = if recipe::is_recipe(&arguments.input) { folder } else { Path::new("") };
    let mut pending = PendingFile::create(&output)?;
    let progress = |stage, done, total| display.step(stage, done, total);
    let run = Run { folder, threads: arguments.jobs, progress: &progress };
    let baked = bake(&plan, &run, pending.file());
    display.finish();
    let mut report = baked.map_err(|error| failure(arguments, &output, error))?.report;
    let save_start = Instant::now();
    pending.keep()?;
    report.stages.push(StageTime { stage: "save", seconds: save_start.elapsed().as_secs_f64() });
    let total_seconds = start.elapsed().as_secs_f64();
    let report = Report { bake: &report, output: output.display().to_string(), total_seconds };
    console::present(&report, json, words::describe)?;
    Ok(ExitStatus::Success)
}

/// An import error names its file, a failing disk is about the output; any other complaint is about the file that was typed, or
/// about --only where that file is no recipe.
fn failure(arguments: &BakeArguments, output: &Path, error: PipelineError) -> Failure {
    let input = &arguments.input;
    match error {
        PipelineError::Write(WriteError::Io { error, .. }) => output::cannot_write(output, &error),
        PipelineError::NoCurvature { table } if !recipe::is_recipe(input) => {
            let input = input.display();
            Failure::Usage(format!("{input}: {table} needs a recipe that names `scene: (curvature: (min, max))`"))
        }
        error @ PipelineError::NoInput { .. } => Failure::Usage(format!("{}: {error}", input.display())),
        error @ PipelineError::Import(_) => error.into(),
        error if error.is_io() => Failure::Io(format!("{}: {error}", input.display())),
        error => Failure::content(input, error),
    }
}

fn output_path(arguments: &BakeArguments) -> Result<PathBuf, Failure> {
    if let Some(output) = &arguments.output {
        return Ok(output.clone());
    }
    let input = &arguments.input;
    let stem = input.file_stem().ok_or_else(|| Failure::Usage(format!("{}: not a file name", input.display())))?;
    let mut name = stem.to_owned();
    name.push(".barchan");
    Ok(PathBuf::from(name))
}
