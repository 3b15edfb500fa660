//! A plan carried out, stage by stage.

use std::io::{Read, Seek, Write};
use std::path::Path;

use barchan_asset::Codec;
use barchan_bakers::Exec;

use crate::clock::Clock;
use crate::curvature::{FoundCurvature, WrittenCurvature};
use crate::error::refused;
use crate::provenance::{EncodingProvenance, Provenance, SkyProvenance};
use crate::relief::{self, ReliefDone};
use crate::report::Facts;
use crate::sink::Sink;
use crate::source::Loaded;
use crate::{BakeReport, Compression, MeshInput, PipelineError, Plan, Table, curvature, mesh_input, source};

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
/// [`barchan_bakers::sky::SkyAccumulator`]; where curvature is swept, 8 bytes a texel for every bend and point; for relief search
/// the heights as stored, 4 bytes a texel, and then whole cone maps, 8 bytes a texel, or mips, 6; and, if tables are packed, all
/// of their stored form. A mesh, its curvature and the table made of it are in memory as a whole.
///
/// # Errors
/// Whatever is wrong with the recipe, the height map, the mesh or the file. What was written to is then no file that a reader
/// opens.
pub fn bake<W: Read + Write + Seek>(plan: &Plan, run: &Run<'_>, out: W) -> Result<Baked<W>, PipelineError> {
    plan.check()?;
    let mut clock = Clock::new(run.progress);
    let inputs = Inputs::load(plan, run, &mut clock)?;
    let exec = Exec::new(run.threads).map_err(|error| refused("-j", error))?;
    let mesh = inputs.mesh.as_ref().filter(|_| plan.looks_at_mesh());
    // Before the relief, which may be swept over the curvatures of the mesh.
    let found = mesh.map(|mesh| curvature::find(plan, mesh, run, &mut clock)).transpose()?;
    let on_mesh = found.as_ref().filter(|_| plan.sweeps_over_mesh()).and_then(FoundCurvature::range);

    let mut sink = Sink::new(out, codec(plan.recipe.compression), clock);
    let relief = match &inputs.relief {
        Some(loaded) => relief::bake(plan, &loaded.field, on_mesh, (run, &exec), &mut sink)?,
        None => ReliefDone::default(),
    };
    let stored = mesh.zip(found.as_ref()).filter(|_| plan.bakes(Table::Curvature));
    let curvature = stored.map(|(mesh, found)| found.write(plan, mesh, &mut sink)).transpose()?;

    let mut tables: Vec<_> = sink.written.iter().map(|written| written.table).collect();
    tables.extend(curvature.as_ref().map(|_| Table::Curvature));
    let mut encodings: Vec<_> = sink.written.iter().map(EncodingProvenance::new).collect();
    encodings.extend(curvature.iter().flat_map(WrittenCurvature::encodings));
    let provenance = Provenance {
        input: inputs.relief.as_ref().map(|loaded| loaded.input.clone()),
        mesh: inputs.mesh.as_ref().map(|mesh| mesh.provenance.clone()),
        horizon: relief.horizon,
        swept: relief.swept,
        sky: tables.iter().any(|table| table.is_of_the_sky()).then(SkyProvenance::new),
        relief_search: relief.search,
        curvature: found.map(|found| found.provenance),
        encodings,
        ..Provenance::of_recipe(&plan.recipe, &tables)
    };
    let json = serde_json::to_string_pretty(&provenance).expect("finite numbers and string keys become JSON");
    let Sink { mut stream, mut clock, written, .. } = sink;
    let finished = clock.stage("checksum", || {
        stream.provenance(&json)?;
        stream.finish()
    })?;
    let facts = Facts {
        plan,
        inputs: &inputs,
        written: &written,
        curvature: curvature.as_ref(),
        provenance,
        threads: exec.threads(),
    };
    let report = facts.report(&finished, clock.into_stages());
    Ok(Baked { out: finished.out, report })
}

/// What there is to bake from: heights, a mesh or both.
pub(crate) struct Inputs {
    pub(crate) relief: Option<Loaded>,
    pub(crate) mesh: Option<MeshInput>,
}

impl Inputs {
    fn load(plan: &Plan, run: &Run<'_>, clock: &mut Clock<'_>) -> Result<Self, PipelineError> {
        let recipe = &plan.recipe;
        let relief =
            recipe.source.as_ref().map(|source| clock.stage("source", || source::load(recipe, source, run.folder)));
        let mesh = recipe.mesh.as_ref().map(|mesh| clock.stage("mesh", || mesh_input::load(recipe, mesh, run.folder)));
        Ok(Self { relief: relief.transpose()?, mesh: mesh.transpose()? })
    }
}

fn codec(compression: Compression) -> Codec {
    match compression {
        Compression::None => Codec::Raw,
        Compression::Zstd => Codec::Zstd,
    }
}
