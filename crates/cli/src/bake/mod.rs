//! `barchan bake`: a recipe, a height map or a mesh to a file.

pub(crate) mod recipe;
mod words;

use std::path::{Path, PathBuf};
use std::time::Instant;

use barchan_asset::WriteError;
use barchan_pipeline::{BakeReport, PipelineError, Run, StageTime, bake};
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
    let BakeArguments { wanted, jobs, .. } = arguments;
    let plan = recipe::plan(wanted)?;
    let output = output_path(arguments)?;
    output::check_writable(&output, &wanted.input)?;
    let display = ProgressDisplay::new(progress);
    let mut pending = PendingFile::create(&output)?;
    let progress = |stage, done, total| display.step(stage, done, total);
    let run = Run { folder: recipe::folder(&wanted.input), threads: *jobs, progress: &progress };
    let baked = bake(&plan, &run, pending.file());
    display.finish();
    let mut report = baked.map_err(|error| failure(&wanted.input, &output, error))?.report;
    let save_start = Instant::now();
    pending.keep()?;
    report.stages.push(StageTime { stage: "save", seconds: save_start.elapsed().as_secs_f64() });
    let total_seconds = start.elapsed().as_secs_f64();
    let report = Report { bake: &report, output: output.display().to_string(), total_seconds };
    console::present(&report, json, words::describe)?;
    Ok(ExitStatus::Success)
}

/// A failing disk is about the output.
fn failure(input: &Path, output: &Path, error: PipelineError) -> Failure {
    match error {
        PipelineError::Write(WriteError::Io { error, .. }) => output::cannot_write(output, &error),
        error => recipe::refused(input, error),
    }
}

fn output_path(arguments: &BakeArguments) -> Result<PathBuf, Failure> {
    if let Some(output) = &arguments.output {
        return Ok(output.clone());
    }
    let input = &arguments.wanted.input;
    let stem = input.file_stem().ok_or_else(|| Failure::Usage(format!("{}: not a file name", input.display())))?;
    let mut name = stem.to_owned();
    name.push(".barchan");
    Ok(PathBuf::from(name))
}
