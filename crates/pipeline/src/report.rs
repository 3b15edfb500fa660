//! What a bake did, for machines; the CLI prints it for people.

use barchan_asset::{Encoding, Finished, SectionKind, Semantic};
use barchan_field::HeightField;
use serde::Serialize;

use crate::provenance::{HorizonProvenance, Provenance, SweptProvenance};
use crate::sink::WrittenTable;
use crate::source::Loaded;
use crate::{Decision, Plan, PlannedTable, Table};

/// Names the layout of [`BakeReport`] as JSON.
pub const BAKE_SCHEMA: &str = "barchan.bake/1";

/// What was baked, what was left out, sizes, times and errors.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BakeReport {
    /// [`BAKE_SCHEMA`].
    pub schema: &'static str,
    /// The height map or shape, in words.
    pub source: String,
    /// Texels whose height a fill rule made up.
    pub filled_texels: u64,
    /// The field.
    pub grid: GridReport,
    /// The tables in the file.
    pub tables: Vec<TableReport>,
    /// The tables that are not.
    pub left_out: Vec<LeftOut>,
    /// What the horizon's baker did and how exactly; `null` without a horizon or distance table.
    pub horizon: Option<HorizonProvenance>,
    /// How many points were kept for curved surfaces; `null` where none were looked for.
    pub swept: Option<SweptProvenance>,
    /// Wall-clock time of each stage, in the order they ran.
    pub stages: Vec<StageTime>,
    /// Texels times directions baked per second of the horizon stage, in millions.
    pub mtexel_directions_per_second: Option<f64>,
    /// Worker threads.
    pub threads: usize,
    /// Size of the file in bytes.
    pub file_bytes: u64,
    /// BLAKE3 of the uncompressed content, in hexadecimal.
    pub identity: String,
}

/// The field that was baked.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GridReport {
    /// Texels along u.
    pub width: u32,
    /// Texels along v.
    pub height: u32,
    /// Length per texel along u.
    pub spacing_u: f64,
    /// Length per texel along v.
    pub spacing_v: f64,
    /// The length unit's symbol.
    pub unit: &'static str,
    /// `wrap` or `clamp`.
    pub edge: &'static str,
    /// The lowest height.
    pub lowest: f32,
    /// The highest height.
    pub highest: f32,
}

/// A table in the file.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TableReport {
    /// Its name.
    pub table: &'static str,
    /// How a texel is stored.
    pub format: &'static str,
    /// Directions times candidates, or 1.
    pub layers: u32,
    /// Points per direction besides the horizon's, in a swept table; else 0.
    pub candidates: u32,
    /// Bytes in the file.
    pub stored_bytes: u64,
    /// Bytes after unpacking.
    pub raw_bytes: u64,
    /// The most that encoding can change a value, in `unit`.
    pub worst_case_error: f64,
    /// What encoding changed, measured over every value: RMS, in `unit`.
    pub encoding_rms: f64,
    /// The largest such change.
    pub encoding_max: f64,
    /// The unit of values.
    pub unit: &'static str,
    /// Why it was baked.
    pub reason: &'static str,
}

/// A table that is not in the file.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LeftOut {
    /// Its name.
    pub table: &'static str,
    /// Why.
    pub reason: &'static str,
    /// What it would have taken, uncompressed; of a swept table as much as is certain.
    pub bytes_saved: u64,
}

/// How long a stage took.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StageTime {
    /// `source`, `points`, `bounds`, `horizon`, `encode`, `write`, `sky`, `measure` or `checksum`, if there was anything to do;
    /// the CLI adds `save`.
    pub stage: &'static str,
    /// Wall-clock seconds.
    pub seconds: f64,
}

/// All that a report is made of.
pub(crate) struct Facts<'a> {
    pub(crate) plan: &'a Plan,
    pub(crate) loaded: &'a Loaded,
    pub(crate) written: &'a [WrittenTable],
    pub(crate) provenance: Provenance,
    pub(crate) threads: usize,
}

impl Facts<'_> {
    pub(crate) fn report<W>(self, finished: &Finished<W>, stages: Vec<StageTime>) -> BakeReport {
        let field = &self.loaded.field;
        let seconds = stages.iter().find(|stage| stage.stage == "horizon").map(|stage| stage.seconds);
        let horizon = self.provenance.horizon.as_ref();
        let work = horizon.map(|horizon| field.grid().texels() as f64 * f64::from(horizon.directions) / 1e6);
        BakeReport {
            schema: BAKE_SCHEMA,
            source: self.loaded.words.clone(),
            filled_texels: self.loaded.filled_texels,
            grid: grid_report(field),
            tables: self.tables(&finished.stored_lengths),
            left_out: self.plan.tables.iter().filter_map(|planned| self.left_out(planned)).collect(),
            mtexel_directions_per_second: work.zip(seconds).map(|(work, seconds)| work / seconds),
            horizon: self.provenance.horizon,
            swept: self.provenance.swept,
            stages,
            threads: self.threads,
            file_bytes: finished.bytes,
            identity: finished.identity.iter().map(|byte| format!("{byte:02x}")).collect(),
        }
    }

    fn written(&self, table: Table) -> Option<&WrittenTable> {
        self.written.iter().find(|written| written.table == table)
    }

    fn tables(&self, stored_lengths: &[(SectionKind, u64)]) -> Vec<TableReport> {
        let report = |planned: &PlannedTable| {
            let written = self.written(planned.table)?;
            let stored = stored_lengths.iter().find(|(kind, _)| *kind == planned.table.kind());
            Some(table_report(written, stored.map_or(0, |(_, bytes)| *bytes), planned.reason))
        };
        self.plan.tables.iter().filter_map(report).collect()
    }

    fn left_out(&self, planned: &PlannedTable) -> Option<LeftOut> {
        if self.written(planned.table).is_some() {
            return None;
        }
        let reason = match planned.decision {
            Decision::LeaveOut => planned.reason,
            Decision::Bake => "the flat horizon alone keeps the error asked for",
        };
        let directions = u64::from(self.plan.recipe.horizon.directions);
        let layers = match planned.table {
            Table::Horizon | Table::Distance => directions,
            table if table.is_swept() => {
                directions * u64::from(self.plan.recipe.curved.points.unwrap_or(2).saturating_sub(1))
            }
            _ => 1,
        };
        let semantic = Semantic::of_kind(planned.table.kind()).expect("every table is a table of texels");
        let texel_bytes = Encoding::from(self.plan.encoding(planned.table)).format(semantic).texel_bytes();
        let bytes_saved = self.loaded.field.grid().texels() as u64 * layers * u64::from(texel_bytes);
        Some(LeftOut { table: planned.table.name(), reason, bytes_saved })
    }
}

fn table_report(written: &WrittenTable, stored_bytes: u64, reason: &'static str) -> TableReport {
    let WrittenTable { table, descriptor, loss } = written;
    TableReport {
        table: table.name(),
        format: descriptor.format.name(),
        layers: descriptor.layers,
        candidates: descriptor.candidates,
        stored_bytes,
        raw_bytes: descriptor.payload_length(),
        worst_case_error: descriptor.worst_case_error,
        encoding_rms: loss.rms,
        encoding_max: loss.max,
        unit: descriptor.unit.symbol(),
        reason,
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
