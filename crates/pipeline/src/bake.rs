//! A plan carried out, stage by stage.

use std::io::{Read, Seek, Write};
use std::path::Path;

use barchan_asset::{Codec, HeightTable};
use barchan_bakers::Exec;
use barchan_bakers::horizon::HorizonParams;
use barchan_field::HeightField;

use crate::clock::Clock;
use crate::directions::{self, DirectionsDone, Task};
use crate::error::refused;
use crate::layout::table_grid;
use crate::provenance::{EncodingProvenance, HorizonProvenance, Provenance, SkyProvenance, SweptProvenance};
use crate::report::Facts;
use crate::sink::{Sink, WrittenTable};
use crate::source;
use crate::{BakeReport, Compression, InputProvenance, PipelineError, Plan, Recipe, Table};

/// A finished file and what there is to say about it.
#[derive(Debug)]
pub struct Baked<W> {
    /// What was written to, flushed.
    pub out: W,
    /// What was done.
    pub report: BakeReport,
}

/// Called with a stage's name, how many of its pieces are done, and how many there are.
pub type Progress<'a> = dyn Fn(&'static str, usize, usize) + Sync + 'a;

/// Where a bake reads, and how it runs: nothing that changes a bit of the file.
#[derive(Clone, Copy)]
pub struct Run<'a> {
    /// Where the recipe's paths start.
    pub folder: &'a Path,
    /// Worker threads; 0 for one per core.
    pub threads: usize,
    /// Told how far the work is.
    pub progress: &'a Progress<'a>,
}

/// Carries out a plan and writes the file to `out`, which must be empty.
///
/// Directions are baked, encoded and written one after the other. In memory are the field, 4 bytes a texel; what one
/// direction needs, 8 bytes a texel and the stored form; where tables of the sky are baked, the sums of a
/// [`barchan_bakers::sky::SkyAccumulator`]; where curvature is swept, 8 bytes a texel for every bend and point; and, if
/// tables are packed, all of their stored form.
///
/// # Errors
/// Whatever is wrong with the recipe, the height map or the file. What was written to is then no file that a reader opens.
pub fn bake<W: Read + Write + Seek>(plan: &Plan, run: &Run<'_>, out: W) -> Result<Baked<W>, PipelineError> {
    let mut clock = Clock::new(run.progress);
    let loaded = clock.stage("source", || source::load(&plan.recipe, run.folder))?;
    let (field, exec) = (&loaded.field, Exec::new(run.threads).map_err(|error| refused("-j", error))?);
    let mut sink = Sink::new(out, codec(plan.recipe.compression), clock);
    if plan.bakes(Table::Height) {
        let table = HeightTable { grid: table_grid(field.grid()), values: field.samples() };
        sink.whole(Table::Height, || table.encode(plan.recipe.height.encoding.into()))?;
    }
    let params = plan.needs_horizon().then(|| horizon_params(plan, field));
    let task = params.as_ref().map(|params| Task { plan, field, params, exec: &exec });
    let done = task.map(|task| directions::bake(task, &mut sink)).transpose()?;
    let horizon = params
        .as_ref()
        .zip(done)
        .map(|(params, done)| HorizonProvenance::new(&plan.recipe.horizon, params, done.accuracy));
    let provenance = provenance(plan, loaded.input.clone(), horizon, done, &sink.written);
    let json = serde_json::to_string_pretty(&provenance).expect("finite numbers and string keys become JSON");
    let Sink { mut stream, mut clock, written, .. } = sink;
    let finished = clock.stage("checksum", || {
        stream.provenance(&json)?;
        stream.finish()
    })?;
    let facts = Facts { plan, loaded: &loaded, written: &written, provenance, threads: exec.threads() };
    let report = facts.report(&finished, clock.into_stages());
    Ok(Baked { out: finished.out, report })
}

fn codec(compression: Compression) -> Codec {
    match compression {
        Compression::None => Codec::Raw,
        Compression::Zstd => Codec::Zstd,
    }
}

fn horizon_params(plan: &Plan, field: &HeightField) -> HorizonParams {
    let Recipe { horizon, .. } = &plan.recipe;
    HorizonParams {
        azimuths: horizon.azimuths(),
        radius: horizon.radius.unwrap_or_else(|| HorizonParams::default_radius(field.grid())),
        distance: plan.bakes(Table::Distance),
        method: horizon.method.into(),
    }
}

fn provenance(
    plan: &Plan,
    input: InputProvenance,
    horizon: Option<HorizonProvenance>,
    done: Option<DirectionsDone>,
    written: &[WrittenTable],
) -> Provenance {
    let tables: Vec<_> = written.iter().map(|written| written.table).collect();
    let points = done.and_then(|done| done.points);
    Provenance {
        horizon,
        swept: points.map(SweptProvenance::new),
        sky: tables.iter().any(|table| table.is_of_the_sky()).then(SkyProvenance::new),
        encodings: written.iter().map(EncodingProvenance::new).collect(),
        ..Provenance::of_recipe(&plan.recipe, input, &tables)
    }
}
