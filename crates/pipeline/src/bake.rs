//! A plan carried out, stage by stage.

use std::path::Path;
use std::time::Instant;

use barchan_asset::{Asset, AssetWriter, Codec, DistanceTable, HeightTable, HorizonTable, HorizonView};
use barchan_asset::{
    Azimuths as TableAzimuths, EncodeError, Encoding, LengthUnit as AssetUnit, Semantic, TableGrid, TextureTable, Wrap,
};
use barchan_bakers::horizon::{self, Azimuths, HorizonMap, HorizonParams, Method};
use barchan_bakers::{BakeError, Exec};
use barchan_field::{Edge, Grid, HeightField, LengthUnit};

use crate::accuracy::HorizonAccuracy;
use crate::provenance::{CanonicalRecipe, HorizonProvenance};
use crate::source::{self, Loaded};
use crate::{
    BAKE_SCHEMA, BakeReport, Compression, Decision, GridReport, LeftOut, PROVENANCE_SCHEMA, PipelineError, Plan,
    Provenance, Recipe, StageTime, Table, TableEncoding, TableReport,
};

/// The bytes of an asset and what there is to say about them.
#[derive(Debug, Clone, PartialEq)]
pub struct Baked {
    /// The file.
    pub bytes: Vec<u8>,
    /// What was done.
    pub report: BakeReport,
}

/// Called with a stage's name, how many of its pieces are done, and how many there are.
pub type Progress<'a> = dyn Fn(&'static str, usize, usize) + Sync + 'a;

/// Carries out a plan on `threads` threads, 0 for one per core. Paths in the recipe start at `folder`.
pub fn bake(plan: &Plan, folder: &Path, threads: usize, progress: &Progress<'_>) -> Result<Baked, PipelineError> {
    let mut clock = Clock::new(progress);
    let loaded = clock.time("source", || source::load(&plan.recipe, folder))?;
    let report_horizon = |done, total| progress("horizon", done, total);
    let exec = Exec::new(threads).map_err(|error| refused("-j", error))?.with_progress(&report_horizon);
    let map = if plan.bakes(Table::Horizon) || plan.bakes(Table::Distance) {
        Some(clock.time("horizon", || bake_horizon(plan, &loaded, &exec))?)
    } else {
        None
    };
    let tables = clock.time("encode", || encode_tables(plan, &loaded.field, map.as_ref()))?;
    let horizon = clock.time("measure", || measure(&loaded.field, map.as_ref(), &tables));
    let provenance = provenance(plan, &loaded, horizon.clone());
    let bytes = clock.time("pack", || pack(plan, tables, &provenance))?;
    let report = report(plan, &loaded, horizon, &bytes, clock.stages, exec.threads());
    Ok(Baked { bytes, report })
}

/// Times stages and announces them.
struct Clock<'a> {
    progress: &'a Progress<'a>,
    stages: Vec<StageTime>,
}

impl<'a> Clock<'a> {
    fn new(progress: &'a Progress<'a>) -> Self {
        Self { progress, stages: Vec::new() }
    }

    fn time<T>(&mut self, stage: &'static str, work: impl FnOnce() -> T) -> T {
        (self.progress)(stage, 0, 1);
        let start = Instant::now();
        let result = work();
        self.stages.push(StageTime { stage, seconds: start.elapsed().as_secs_f64() });
        (self.progress)(stage, 1, 1);
        result
    }
}

fn refused(subject: &str, error: BakeError) -> PipelineError {
    PipelineError::Bake { subject: subject.to_owned(), error }
}

fn bake_horizon(plan: &Plan, loaded: &Loaded, exec: &Exec<'_>) -> Result<HorizonMap, PipelineError> {
    let params = horizon_params(&plan.recipe, loaded.field.grid(), plan.bakes(Table::Distance));
    // A field that is too small is the source's fault, anything else the recipe's.
    horizon::bake(&loaded.field, &params, exec).map_err(|error| match error {
        BakeError::Field { .. } => refused("source", error),
        _ => refused("horizon", error),
    })
}

fn horizon_params(recipe: &Recipe, grid: &Grid, distance: bool) -> HorizonParams {
    let radius = recipe.horizon.radius.unwrap_or_else(|| HorizonParams::default_radius(grid));
    let azimuths = Azimuths::full_circle(recipe.horizon.directions);
    HorizonParams { azimuths, radius, distance, method: Method::default() }
}

fn encode_tables(
    plan: &Plan,
    field: &HeightField,
    map: Option<&HorizonMap>,
) -> Result<Vec<TextureTable>, PipelineError> {
    let Recipe { height, horizon, distance, .. } = &plan.recipe;
    let grid = table_grid(field.grid());
    let fail = |table: Table| move |error: EncodeError| PipelineError::Encode { table: table.name(), error };
    let mut tables = Vec::new();
    if plan.bakes(Table::Height) {
        let table = HeightTable { grid, values: field.samples() };
        tables.push(table.encode(height.encoding.into()).map_err(fail(Table::Height))?);
    }
    let Some(map) = map else { return Ok(tables) };
    let (azimuths, radius) = (TableAzimuths::full_circle(map.params.directions()), map.params.radius);
    if plan.bakes(Table::Horizon) {
        let table = HorizonTable { grid, azimuths, radius, values: &map.elevation_radians };
        tables.push(table.encode(horizon.encoding.into()).map_err(fail(Table::Horizon))?);
    }
    if let Some(values) = &map.distance {
        let table = DistanceTable { grid, azimuths, radius, values };
        tables.push(table.encode(distance.encoding.into()).map_err(fail(Table::Distance))?);
    }
    Ok(tables)
}

/// The grid in the asset's words: the reader's crate knows nothing of fields.
fn table_grid(grid: &Grid) -> TableGrid {
    let wrap = match grid.edge {
        Edge::Wrap => Wrap::Repeat,
        Edge::Clamp => Wrap::Clamp,
    };
    TableGrid {
        width: grid.width,
        height: grid.height,
        spacing_u: grid.spacing.u(),
        spacing_v: grid.spacing.v(),
        length_unit: match grid.unit {
            LengthUnit::SceneUnit => AssetUnit::SceneUnit,
            LengthUnit::Metre => AssetUnit::Metre,
            LengthUnit::Centimetre => AssetUnit::Centimetre,
            LengthUnit::Millimetre => AssetUnit::Millimetre,
            LengthUnit::Kilometre => AssetUnit::Kilometre,
        },
        wrap_u: wrap,
        wrap_v: wrap,
    }
}

fn measure(field: &HeightField, map: Option<&HorizonMap>, tables: &[TextureTable]) -> Option<HorizonProvenance> {
    let map = map?;
    let stored = tables.iter().find(|table| table.kind() == Table::Horizon.kind());
    let view = stored.and_then(|table| HorizonView::new(*table.descriptor(), table.payload()).ok());
    let accuracy = view.map(|view| HorizonAccuracy::measure(field, map, &view));
    Some(HorizonProvenance::new(map.params.directions(), map.params.radius, accuracy))
}

fn provenance(plan: &Plan, loaded: &Loaded, horizon: Option<HorizonProvenance>) -> Provenance {
    let baked = plan.tables.iter().filter(|planned| planned.decision == Decision::Bake);
    Provenance {
        schema: PROVENANCE_SCHEMA.to_owned(),
        generator: concat!("barchan ", env!("CARGO_PKG_VERSION")).to_owned(),
        input: loaded.input.clone(),
        recipe: CanonicalRecipe::new(&plan.recipe, baked.map(|planned| planned.table.name().to_owned()).collect()),
        horizon,
    }
}

fn pack(plan: &Plan, tables: Vec<TextureTable>, provenance: &Provenance) -> Result<Vec<u8>, PipelineError> {
    let codec = match plan.recipe.compression {
        Compression::None => Codec::Raw,
        Compression::Zstd => Codec::Zstd,
    };
    let mut writer = AssetWriter::new();
    for table in tables {
        writer.add_table(table, codec)?;
    }
    let json = serde_json::to_string_pretty(provenance).expect("finite numbers and string keys become JSON");
    writer.provenance(&json)?;
    Ok(writer.finish()?)
}

fn report(
    plan: &Plan,
    loaded: &Loaded,
    horizon: Option<HorizonProvenance>,
    bytes: &[u8],
    stages: Vec<StageTime>,
    threads: usize,
) -> BakeReport {
    let asset = Asset::open(bytes).expect("what the writer finished can be opened");
    let grid = loaded.field.grid();
    let seconds = stages.iter().find(|stage| stage.stage == "horizon").map(|stage| stage.seconds);
    let work = horizon.as_ref().map(|horizon| grid.texels() as f64 * f64::from(horizon.directions) / 1e6);
    BakeReport {
        schema: BAKE_SCHEMA,
        source: loaded.words.clone(),
        filled_texels: loaded.filled_texels,
        grid: grid_report(&loaded.field),
        tables: plan.tables.iter().filter_map(|planned| table_report(&asset, planned)).collect(),
        left_out: left_out(plan, &loaded.field),
        mtexel_directions_per_second: work.zip(seconds).map(|(work, seconds)| work / seconds),
        horizon,
        stages,
        threads,
        file_bytes: bytes.len() as u64,
        identity: asset.identity().iter().map(|byte| format!("{byte:02x}")).collect(),
    }
}

fn grid_report(field: &HeightField) -> GridReport {
    let grid = field.grid();
    let (lowest, highest) = field.range();
    GridReport {
        width: grid.width,
        height: grid.height,
        spacing_u: grid.spacing.u(),
        spacing_v: grid.spacing.v(),
        unit: grid.unit.symbol(),
        edge: grid.edge.name(),
        lowest,
        highest,
    }
}

fn table_report(asset: &Asset<'_>, planned: &crate::PlannedTable) -> Option<TableReport> {
    let section = asset.section(planned.table.kind())?;
    let texture = section.texture().ok()?;
    Some(TableReport {
        table: planned.table.name(),
        format: texture.format.name(),
        layers: texture.layers,
        stored_bytes: section.stored_length(),
        raw_bytes: section.raw_length(),
        worst_case_error: texture.worst_case_error,
        unit: texture.unit.symbol(),
        reason: planned.reason,
    })
}

fn left_out(plan: &Plan, field: &HeightField) -> Vec<LeftOut> {
    let Recipe { height, horizon, distance, .. } = &plan.recipe;
    let planned = plan.tables.iter().filter(|planned| planned.decision == Decision::LeaveOut);
    planned
        .map(|planned| {
            let (encoding, layers) = match planned.table {
                Table::Height => (height.encoding, 1),
                Table::Horizon => (horizon.encoding, horizon.directions),
                Table::Distance => (distance.encoding, horizon.directions),
            };
            let texel_bytes = stored_texel_bytes(planned.table, encoding);
            let texels = field.grid().texels() as u64 * u64::from(layers);
            let bytes_saved = texels * u64::from(texel_bytes);
            LeftOut { table: planned.table.name(), reason: planned.reason, bytes_saved }
        })
        .collect()
}

fn stored_texel_bytes(table: Table, encoding: TableEncoding) -> u32 {
    let semantic = Semantic::of_kind(table.kind()).expect("every table is a table of texels");
    Encoding::from(encoding).format(semantic).texel_bytes()
}
