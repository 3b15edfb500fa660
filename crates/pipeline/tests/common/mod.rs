//! Recipes baked into memory.

use std::io::Cursor;
use std::path::Path;

use barchan_pipeline::{BakeReport, PipelineError, Plan, Progress, Recipe, Run, Table, bake};

/// A file in memory, and what was said of it.
#[derive(Debug)]
pub(crate) struct Baked {
    pub(crate) bytes: Vec<u8>,
    pub(crate) report: BakeReport,
}

pub(crate) fn bake_on(
    threads: usize,
    recipe: Recipe,
    only: Option<&[Table]>,
    progress: &Progress<'_>,
) -> Result<Baked, PipelineError> {
    let run = Run { folder: Path::new("maps"), threads, progress };
    let baked = bake(&Plan::new(recipe, only), &run, Cursor::new(Vec::new()))?;
    Ok(Baked { bytes: baked.out.into_inner(), report: baked.report })
}
