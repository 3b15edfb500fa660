//! `barchan plan`: what a bake would bake, what it would leave out, and why.

use barchan_pipeline::{CurvedRecipe, Plan, PlanReport, PlannedGrid, Table, TableOutline};

use crate::args::PlanArguments;
use crate::asset_file::list;
use crate::bake::{LayerCounts, layer_words, recipe};
use crate::console::{self, bytes, number, shell_word};
use crate::failure::{ExitStatus, Failure};

pub(crate) fn run(arguments: &PlanArguments, json: bool) -> Result<ExitStatus, Failure> {
    let input = &arguments.wanted.input;
    let plan = recipe::plan(&arguments.wanted)?;
    let report = plan.report(recipe::folder(input)).map_err(|error| recipe::refused(input, error))?;
    console::present(&report, json, |report| describe(&plan, report))?;
    Ok(ExitStatus::Success)
}

fn describe(plan: &Plan, report: &PlanReport) -> String {
    let mut text = String::new();
    let mut line = |what: &str, words: String| text += &format!("{what:14} {words}\n");
    line("planned", counts_words(report));
    if let Some(source) = &report.source {
        let grid = report.grid.as_ref().map(grid_words).unwrap_or_default();
        line("source", format!("{source}{grid}"));
    }
    if let Some(mesh) = &report.mesh {
        line("mesh", mesh.clone());
    }
    line("checked", checked_words(report));
    line("next", next_words());
    let head = ["table", "decision", "stored as", "size", "why"].map(str::to_owned);
    let rows: Vec<_> = std::iter::once(head).chain(report.tables.iter().map(|table| row(plan, table))).collect();
    format!("{text}\n{}", columns(&rows))
}

fn counts_words(report: &PlanReport) -> String {
    let count = |decision: &str| report.tables.iter().filter(|table| table.decision == decision).count();
    let baked = report.tables.iter().filter(|table| table.decision == "bake");
    let size = baked.map(|table| table.raw_bytes).try_fold(0_u64, |sum, bytes| Some(sum.saturating_add(bytes?)));
    let size = size.map(|size| format!(", {} before packing", bytes(size))).unwrap_or_default();
    let (bake, left_out, no_input) = (count("bake"), count("leave_out"), count("no_input"));
    let tables = if bake == 1 { "table" } else { "tables" };
    format!("{bake} {tables} to bake{size}; {left_out} left out, {no_input} without input")
}

fn grid_words(grid: &PlannedGrid) -> String {
    let PlannedGrid { width, height, spacing_u, spacing_v, unit, edge } = grid;
    format!(", {width} × {height} texels of {} × {} {unit}, {edge}", number(*spacing_u), number(*spacing_v))
}

fn checked_words(report: &PlanReport) -> String {
    if report.unread.is_empty() {
        return "the recipe, all that can be checked before a bake".to_owned();
    }
    let files: Vec<_> = report.unread.iter().map(String::as_str).collect();
    format!("all that can be checked without {}", list(&files))
}

/// A row of the table, a cell to a column.
fn row(plan: &Plan, outline: &TableOutline) -> [String; 5] {
    let decision = match outline.decision {
        "bake" => "baked",
        "leave_out" => "left out",
        _ => "no input",
    };
    let (stored, size) = match outline.decision {
        "no_input" => ("-".to_owned(), "-".to_owned()),
        _ => (stored_words(plan, outline), size_words(outline)),
    };
    [outline.table.to_owned(), decision.to_owned(), stored, size, outline.reason.to_owned()]
}

/// `R8_UNORM × 32 directions`, of a size of its own where that is not the heights'; what only a bake finds out, in words.
fn stored_words(plan: &Plan, outline: &TableOutline) -> String {
    let TableOutline { format, layers, rings, candidates, mips, .. } = outline;
    if outline.table == Table::Curvature.name() {
        return format!("{format} and further columns a vertex");
    }
    let (Some(layers), Some(candidates)) = (*layers, *candidates) else {
        let directions = plan.recipe.horizon.directions;
        let error = plan.recipe.curved.max_error_degrees.unwrap_or(CurvedRecipe::DEFAULT_MAX_ERROR_DEGREES);
        return format!("{format} × as few points as keep {}° × {directions} directions", number(error));
    };
    match mips {
        Some(mips) => {
            let counts = LayerCounts { layers, candidates, rings: *rings, mips: *mips };
            format!("{format}{}{}", own_extent_words(outline), layer_words(counts))
        }
        None => format!("{format} × levels down to one texel"),
    }
}

/// The texels of a table that has not those of the heights, where they are known.
fn own_extent_words(outline: &TableOutline) -> String {
    match outline.width.zip(outline.height).filter(|_| outline.table == Table::Hemisphere.name()) {
        Some((width, height)) => format!(", {width} × {height} texels"),
        None => String::new(),
    }
}

fn size_words(outline: &TableOutline) -> String {
    match (outline.raw_bytes, outline.bytes_per_texel) {
        // As much as is certain.
        (Some(size), _) if outline.layers.is_none() => format!("{} at least", bytes(size)),
        (Some(size), _) => bytes(size),
        (None, Some(size)) => format!("{} a texel", bytes(size)),
        (None, None) if outline.table == Table::Curvature.name() => "needs the mesh".to_owned(),
        (None, None) if outline.layers.is_none() => "needs a bake".to_owned(),
        (None, None) => "needs the map".to_owned(),
    }
}

/// Cells under each other, as wide as the widest of their column.
fn columns(rows: &[[String; 5]]) -> String {
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or_default();
    let widths: [usize; 5] = std::array::from_fn(width);
    let line = |row: &[String; 5]| {
        let cells = row.iter().zip(widths).map(|(cell, width)| format!("{cell:width$}"));
        cells.collect::<Vec<_>>().join("  ").trim_end().to_owned() + "\n"
    };
    rows.iter().map(line).collect()
}

/// The bake of this plan: the same words with another command.
fn next_words() -> String {
    // A name need not be UTF-8.
    let words = std::env::args_os().map(|word| word.to_string_lossy().into_owned());
    let mut words: Vec<_> = words.filter(|word| word != "--json").collect();
    if let Some(command) = words.iter_mut().skip(1).find(|word| *word == "plan") {
        "bake".clone_into(command);
    }
    words.iter().map(|word| shell_word(word)).collect::<Vec<_>>().join(" ")
}
