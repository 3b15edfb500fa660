//! What a bake did, for machines; the CLI prints it for people.

use serde::Serialize;

use crate::provenance::HorizonProvenance;

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
    /// Directions, or 1.
    pub layers: u32,
    /// Bytes in the file.
    pub stored_bytes: u64,
    /// Bytes after unpacking.
    pub raw_bytes: u64,
    /// The most that encoding can change a value, in `unit`.
    pub worst_case_error: f64,
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
    /// What it would have taken, uncompressed.
    pub bytes_saved: u64,
}

/// How long a stage took.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StageTime {
    /// `source`, `horizon`, `encode`, `measure` or `pack`; the CLI adds `write`.
    pub stage: &'static str,
    /// Wall-clock seconds.
    pub seconds: f64,
}
