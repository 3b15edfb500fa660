//! What a bake did, for people.

use std::path::Path;

use barchan_pipeline::{BakeReport, ColumnReport, GridReport, LeftOut, Table, TableReport};

use super::Report;
use crate::asset_file::list;
use crate::console::{self, bytes, error_in, number, shell_word};
use crate::mesh_words;

pub(super) fn describe(report: &Report<'_>) -> String {
    let Report { bake, output, total_seconds } = report;
    let mut text = String::new();
    let mut line = |what: &str, words: String| text += &format!("{what:14} {words}\n");
    line("baked", format!("{output}, {}, in {total_seconds:.2} s", bytes(bake.file_bytes)));
    if let (Some(source), Some(grid)) = (&bake.source, &bake.grid) {
        line("source", source_words(source, grid, bake.filled_texels));
    }
    if let Some(mesh) = &bake.mesh {
        line("mesh", mesh_words::source(mesh));
    }
    for table in &bake.tables {
        line(table.table, format!("{}: {}", table_words(table), table.reason));
        for column in &table.columns {
            line("", column_words(column));
        }
    }
    for tables in bake.left_out.chunk_by(|one, next| one.reason == next.reason) {
        line("left out", left_out_words(tables));
    }
    if let Some(accuracy) = bake.horizon.as_ref().and_then(|horizon| horizon.accuracy.as_ref()) {
        line("error", console::accuracy(accuracy));
    }
    if let Some(hemisphere) = bake.relief_search.as_ref().and_then(|search| search.hemisphere.as_ref()) {
        line("starts", console::starts(&hemisphere.accuracy));
    }
    if let (Some(curvature), Some(mesh)) = (&bake.curvature, &bake.mesh) {
        line("welded", mesh_words::welded(&curvature.mended, mesh.vertices, mesh.unit));
        line("found", mesh_words::found(curvature, mesh.unit));
        line("flagged", mesh_words::flagged(&curvature.flagged, mesh.vertices));
        if let Some(range) = bake.swept.as_ref().and_then(|swept| swept.on_mesh.as_ref()) {
            line("swept", mesh_words::swept(range, mesh.unit));
        }
    }
    line("time", time_words(bake));
    line("next", next_words(bake, output));
    text
}

fn source_words(source: &str, grid: &GridReport, filled_texels: u64) -> String {
    let filled = match filled_texels {
        0 => String::new(),
        count => format!(", {count} texels filled"),
    };
    format!(
        "{source}, {} × {} texels of {} × {} {unit}, {}, heights {} to {} {unit}{filled}",
        grid.width,
        grid.height,
        number(grid.spacing_u),
        number(grid.spacing_v),
        grid.edge,
        number(grid.lowest.into()),
        number(grid.highest.into()),
        unit = grid.unit,
    )
}

/// How a table is stored, what that takes, and what it costs: the bound, and what was measured.
fn table_words(table: &TableReport) -> String {
    let TableReport { format, worst_case_error, encoding_rms, encoding_max, unit, .. } = table;
    let size = bytes(table.stored_bytes);
    if !table.columns.is_empty() {
        return format!("{} columns, {size}", table.columns.len());
    }
    let layers = layer_words(LayerCounts {
        layers: table.layers,
        candidates: table.candidates,
        rings: table.rings,
        mips: table.mips,
    });
    let cost = cost_words([*worst_case_error, *encoding_rms, *encoding_max], unit);
    format!("{format}{layers}, {size}, {cost}")
}

/// How a column of a table of vertices is stored.
fn column_words(column: &ColumnReport) -> String {
    let ColumnReport { column, format, raw_bytes, worst_case_error, encoding_rms, encoding_max, unit } = column;
    let cost = cost_words([*worst_case_error, *encoding_rms, *encoding_max], unit);
    format!("{column} {format}, {}, {cost}", bytes(*raw_bytes))
}

/// The bound of what storing costs, and what it measured, RMS and at most.
fn cost_words(errors: [f64; 3], unit: &str) -> String {
    let [bound, rms, max] = errors.map(|error| error_in(unit, error));
    if errors[0] == 0.0 { "exact".to_owned() } else { format!("± {bound} (measured {rms} RMS, {max} at most)") }
}

/// Neighbours in the list that one reason leaves out.
fn left_out_words(tables: &[LeftOut]) -> String {
    let names: Vec<_> = tables.iter().map(|left| left.table).collect();
    let saved = tables.iter().map(|left| left.bytes_saved).fold(0, u64::saturating_add);
    format!("{}, saving {}: {}", list(&names), bytes(saved), tables[0].reason)
}

/// How many layers and levels a texture has, and what they stand for.
#[derive(Clone, Copy)]
pub(crate) struct LayerCounts {
    pub(crate) layers: u32,
    /// Of a swept table; else 0.
    pub(crate) candidates: u32,
    /// Of a hemisphere table; else 0.
    pub(crate) rings: u32,
    pub(crate) mips: u32,
}

/// ` × 32 directions`, ` × 2 points × 32 directions`, ` × 32 rings × 16 azimuths`, ` × 9 levels`, or nothing.
pub(crate) fn layer_words(counts: LayerCounts) -> String {
    match counts {
        LayerCounts { mips: mips @ 2.., .. } => format!(" × {mips} levels"),
        LayerCounts { rings: rings @ 1.., layers, .. } => format!(" × {rings} rings × {} azimuths", layers / rings),
        LayerCounts { layers: 1, candidates: 0, .. } => String::new(),
        LayerCounts { layers, candidates: 0, .. } => format!(" × {layers} directions"),
        LayerCounts { layers, candidates: 1, .. } => format!(" × 1 further point × {layers} directions"),
        LayerCounts { layers, candidates, .. } => {
            format!(" × {candidates} further points × {} directions", layers / candidates)
        }
    }
}

fn time_words(bake: &BakeReport) -> String {
    let threads = if bake.threads == 1 { "1 thread".to_owned() } else { format!("{} threads", bake.threads) };
    let speed = |stage: &str| match stage {
        "horizon" => bake.mtexel_directions_per_second.map(|speed| format!("{speed:.1} Mtexel·direction/s")),
        "hemisphere" => bake.mrays_per_second.map(|speed| format!("{speed:.1} Mray/s")),
        "curvature" => bake.mvertices_per_second.map(|speed| format!("{speed:.2} Mvertex/s")),
        _ => None,
    };
    let stages = bake.stages.iter().map(|stage| {
        let speed = speed(stage.stage).map(|speed| format!(" ({speed} on {threads})")).unwrap_or_default();
        format!("{} {:.2} s{speed}", stage.stage, stage.seconds)
    });
    stages.collect::<Vec<_>>().join(", ")
}

/// Commands that can be pasted: the program is named as it was called. A picture from above needs the heights and the horizon, one
/// from a side the heights.
fn next_words(bake: &BakeReport, output: &str) -> String {
    let program = std::env::args().next().unwrap_or_else(|| "barchan".to_owned());
    let program = shell_word(&program);
    let has = |table: Table| bake.tables.iter().any(|baked| baked.table == table.name());
    // Never the name of an input that may lie beside the file.
    let beside = |ending: &str| shell_word(&Path::new(output).with_extension(ending).display().to_string());
    let file = shell_word(output);
    let mut commands = vec![format!("{program} inspect {file}")];
    if has(Table::Height) && has(Table::Horizon) {
        let picture = beside("lit.png");
        commands.push(format!("{program} render {file} --azimuth 135 --elevation 10 -o {picture}"));
    }
    if has(Table::Height) && has(Table::Hemisphere) {
        let picture = beside("relief.png");
        commands.push(format!("{program} render {file} --eye-elevation 35 --elevation 30 -o {picture}"));
    }
    if let Some(mesh) = bake.mesh.as_ref().filter(|_| has(Table::Curvature)) {
        let mesh = mesh.path.as_ref().map(|path| format!(" --mesh {}", shell_word(&path.display().to_string())));
        let (mesh, coloured) = (mesh.unwrap_or_default(), beside("curvature.ply"));
        commands.push(format!("{program} dump {file} curvature --format ply{mesh} -o {coloured}"));
    }
    commands.join("\n               ")
}
