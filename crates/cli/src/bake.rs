//! `barchan bake`: a recipe or a height map to a file.

use std::path::{Path, PathBuf};
use std::time::Instant;

use barchan_asset::WriteError;
use barchan_pipeline::{
    BakeReport, HeightMapSource, PipelineError, Plan, Recipe, RecipeError, Run, Source, StageTime, Table,
    TableEncoding, TableReport, bake,
};
use serde::Serialize;

use crate::args::{BakeArguments, HeightMapArguments, ProgressStyleName};
use crate::console::{self, bytes, error_in, number};
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
    let recipe = recipe(arguments)?;
    let output = output_path(arguments)?;
    output::check_writable(&output, &arguments.input)?;
    let plan = Plan::new(recipe, arguments.only.as_deref());
    let display = ProgressDisplay::new(progress);
    let folder = arguments.input.parent().unwrap_or(Path::new(""));
    // A bare height map's path is as typed, a recipe's paths start at the recipe.
    let folder = if is_recipe(&arguments.input) { folder } else { Path::new("") };
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
    console::present(&report, json, describe)?;
    Ok(ExitStatus::Success)
}

/// An import error names its file, a failing disk is about the output; any other complaint is about the recipe or the map
/// that was typed.
fn failure(arguments: &BakeArguments, output: &Path, error: PipelineError) -> Failure {
    let input = &arguments.input;
    match error {
        PipelineError::Write(WriteError::Io { error, .. }) => output::cannot_write(output, &error),
        PipelineError::NoCurvature { table } if !is_recipe(input) => {
            let input = input.display();
            Failure::Usage(format!("{input}: {table} needs a recipe that names `scene: (curvature: (min, max))`"))
        }
        error @ PipelineError::Import(_) => error.into(),
        error if error.is_io() => Failure::Io(format!("{}: {error}", input.display())),
        error => Failure::content(input, error),
    }
}

fn is_recipe(input: &Path) -> bool {
    input.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("ron"))
}

fn recipe(arguments: &BakeArguments) -> Result<Recipe, Failure> {
    let flags = &arguments.height_map;
    if !is_recipe(&arguments.input) {
        return Ok(bare_recipe(arguments.input.clone(), flags));
    }
    if let Some(flag) = first_flag(flags) {
        let input = arguments.input.display();
        return Err(Failure::Usage(format!("{flag} is for a height map without a recipe; set it in {input}")));
    }
    let path = &arguments.input;
    let text = std::fs::read(path).map_err(|error| Failure::io(path, "cannot be read", &error))?;
    let text = String::from_utf8(text).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        Failure::content(path, format!("byte {at} is not UTF-8; a recipe is a RON text"))
    })?;
    Recipe::parse(&text).map_err(|error| match error {
        RecipeError::Syntax { line, column, reason } => {
            Failure::BadInput(format!("{}:{line}:{column}: {reason}", path.display()))
        }
        error @ (RecipeError::Field(_) | RecipeError::PointsTwice) => Failure::content(path, error),
    })
}

/// The recipe that the flags spell.
fn bare_recipe(path: PathBuf, flags: &HeightMapArguments) -> Recipe {
    let mut source = HeightMapSource::new(path, flags.height_scale.unwrap_or(1.0));
    source.integers = flags.integers.unwrap_or_default();
    source.height_offset = flags.height_offset.unwrap_or(0.0);
    source.channel = flags.channel.clone();
    source.no_data = flags.no_data;
    source.fill = flags.fill;
    let mut recipe = Recipe::bare(Source::HeightMap(source));
    recipe.spacing = flags.spacing.unwrap_or(recipe.spacing);
    recipe.unit = flags.unit.unwrap_or(recipe.unit);
    recipe.edge = flags.edge.unwrap_or(recipe.edge);
    recipe.compression = flags.compression.unwrap_or(recipe.compression);
    recipe.horizon.directions = flags.directions.unwrap_or(recipe.horizon.directions);
    recipe.horizon.arc = flags.arc;
    recipe.horizon.radius = flags.radius;
    recipe.horizon.method = flags.method.unwrap_or_default();
    let encoding = flags.encoding.unwrap_or_default();
    (recipe.horizon.encoding, recipe.distance.encoding, recipe.sky.encoding) = (encoding, encoding, encoding);
    if encoding == TableEncoding::F32 {
        recipe.height.encoding = encoding;
    }
    recipe
}

/// A height-map flag that was typed, if any was.
fn first_flag(flags: &HeightMapArguments) -> Option<&'static str> {
    let typed = [
        ("--directions", flags.directions.is_some()),
        ("--edge", flags.edge.is_some()),
        ("--spacing", flags.spacing.is_some()),
        ("--unit", flags.unit.is_some()),
        ("--integers", flags.integers.is_some()),
        ("--height-scale", flags.height_scale.is_some()),
        ("--height-offset", flags.height_offset.is_some()),
        ("--arc", flags.arc.is_some()),
        ("--method", flags.method.is_some()),
        ("--radius", flags.radius.is_some()),
        ("--encoding", flags.encoding.is_some()),
        ("--compression", flags.compression.is_some()),
        ("--channel", flags.channel.is_some()),
        ("--no-data", flags.no_data.is_some()),
        ("--fill", flags.fill.is_some()),
    ];
    typed.into_iter().find(|(_, is_typed)| *is_typed).map(|(flag, _)| flag)
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

fn describe(report: &Report<'_>) -> String {
    let Report { bake, output, total_seconds } = report;
    let mut text = String::new();
    let mut line = |what: &str, words: String| text += &format!("{what:14} {words}\n");
    line("baked", format!("{output}, {}, in {total_seconds:.2} s", bytes(bake.file_bytes)));
    line("source", source_words(bake));
    for table in &bake.tables {
        line(table.table, format!("{}: {}", table_words(table), table.reason));
    }
    for table in &bake.left_out {
        line("left out", format!("{}, saving {}: {}", table.table, bytes(table.bytes_saved), table.reason));
    }
    if let Some(accuracy) = bake.horizon.as_ref().and_then(|horizon| horizon.accuracy.as_ref()) {
        line("error", console::accuracy(accuracy));
    }
    line("time", time_words(bake));
    line("next", next_words(bake, output));
    text
}

fn source_words(bake: &BakeReport) -> String {
    let grid = &bake.grid;
    let filled = match bake.filled_texels {
        0 => String::new(),
        count => format!(", {count} texels filled"),
    };
    format!(
        "{}, {} × {} texels of {} × {} {unit}, {}, heights {} to {} {unit}{filled}",
        bake.source,
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
    let layers = layer_words(table.layers, table.candidates);
    if *worst_case_error == 0.0 {
        return format!("{format}{layers}, {size}, exact");
    }
    let [bound, rms, max] = [*worst_case_error, *encoding_rms, *encoding_max].map(|error| error_in(unit, error));
    format!("{format}{layers}, {size}, ± {bound} (measured {rms} RMS, {max} at most)")
}

/// ` × 32 directions`, ` × 2 points × 32 directions`, or nothing.
pub(crate) fn layer_words(layers: u32, candidates: u32) -> String {
    match (layers, candidates) {
        (1, 0) => String::new(),
        (layers, 0) => format!(" × {layers} directions"),
        (layers, 1) => format!(" × 1 further point × {layers} directions"),
        (layers, candidates) => format!(" × {candidates} further points × {} directions", layers / candidates),
    }
}

fn time_words(bake: &BakeReport) -> String {
    let threads = if bake.threads == 1 { "1 thread".to_owned() } else { format!("{} threads", bake.threads) };
    let stages = bake.stages.iter().map(|stage| {
        let speed = bake.mtexel_directions_per_second.filter(|_| stage.stage == "horizon");
        let speed = speed.map(|speed| format!(" ({speed:.1} Mtexel·direction/s on {threads})")).unwrap_or_default();
        format!("{} {:.2} s{speed}", stage.stage, stage.seconds)
    });
    stages.collect::<Vec<_>>().join(", ")
}

/// Commands that can be pasted: the program is named as it was called. A picture needs the heights and the horizon.
fn next_words(bake: &BakeReport, output: &str) -> String {
    let program = std::env::args().next().unwrap_or_else(|| "barchan".to_owned());
    let program = shell_word(&program);
    let inspect = format!("{program} inspect {}", shell_word(output));
    let has = |table: Table| bake.tables.iter().any(|baked| baked.table == table.name());
    if !has(Table::Height) || !has(Table::Horizon) {
        return inspect;
    }
    // Never the name of a height map that may lie beside the file.
    let picture = Path::new(output).with_extension("lit.png");
    let (output, picture) = (shell_word(output), shell_word(&picture.display().to_string()));
    format!("{inspect}\n               {program} render {output} --azimuth 135 --elevation 10 -o {picture}")
}

/// A word as a shell takes it.
fn shell_word(word: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "/\\._-+:,=@%".contains(c);
    if word.chars().all(is_plain) { word.to_owned() } else { format!("'{}'", word.replace('\'', r"'\''")) }
}
