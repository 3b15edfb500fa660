//! `barchan dump`: a table's values in formats that other programs read.

mod exr;
mod npy;
mod picture;
mod text;

use std::ops::Range;

use barchan_asset::Semantic;
use barchan_pipeline::Table;
use serde::Serialize;

use crate::args::{DumpArguments, DumpFormat};
use crate::asset_file::{AssetFile, DecodedTable, list};
use crate::console;
use crate::failure::{ExitStatus, Failure};
use crate::output;

/// A table and the layers of it that were asked for.
struct Selection<'a> {
    table: &'a DecodedTable<'a>,
    layers: Range<u32>,
    /// One layer was named, so the layer axis is dropped where a format has one.
    single: bool,
}

impl Selection<'_> {
    fn width(&self) -> usize {
        self.table.descriptor.width as usize
    }

    fn height(&self) -> usize {
        self.table.descriptor.height as usize
    }

    fn is_horizon(&self) -> bool {
        self.table.descriptor.semantic == Semantic::HorizonElevation
    }

    /// The decoded values of one layer, row by row.
    fn layer_values(&self, layer: u32) -> impl Iterator<Item = f32> {
        let view = self.table.view();
        (0..self.table.descriptor.height).flat_map(move |row| view.row(layer, row))
    }
}

#[derive(Serialize)]
struct Report {
    schema: &'static str,
    file: String,
    table: &'static str,
    output: String,
    layers: u32,
    width: u32,
    height: u32,
    values: &'static str,
}

pub(crate) fn run(arguments: &DumpArguments, json: bool) -> Result<ExitStatus, Failure> {
    if let Some(output) = &arguments.output {
        output::check_writable(output, &arguments.file)?;
    }
    let file = AssetFile::read(&arguments.file)?;
    let table = file.decode(chosen_table(&file, arguments.table)?)?;
    let selection = select(&file, arguments, &table)?;
    let bytes = encode(arguments.format, &selection)?;
    let Some(output) = &arguments.output else {
        return to_stdout(arguments.format, json, &bytes);
    };
    output::write_whole(output, &bytes)?;
    let report = Report {
        schema: "barchan.dump/1",
        file: file.path.display().to_string(),
        table: table.table.name(),
        output: output.display().to_string(),
        layers: selection.layers.len() as u32,
        width: table.descriptor.width,
        height: table.descriptor.height,
        values: value_words(arguments.format, &selection),
    };
    console::present(&report, json, describe)?;
    Ok(ExitStatus::Success)
}

fn chosen_table(file: &AssetFile, named: Option<Table>) -> Result<Table, Failure> {
    let present = file.tables()?;
    match (named, present.as_slice()) {
        (Some(table), _) => Ok(table),
        (None, [table]) => Ok(*table),
        (None, []) => Err(file.content("there is no table in the file")),
        (None, tables) => {
            let path = file.path.display();
            Err(Failure::Usage(format!("{path}: the file has {}; name one of them", list(tables))))
        }
    }
}

fn select<'a>(
    file: &AssetFile,
    arguments: &DumpArguments,
    table: &'a DecodedTable<'a>,
) -> Result<Selection<'a>, Failure> {
    let (name, layers, mips) = (table.table.name(), table.descriptor.layers, table.descriptor.mips);
    let out_of_range = |what: &str, value: u32, count: u32| {
        let path = file.path.display();
        let last = count - 1;
        Failure::Usage(format!("{path}: --{what} is {value}; {name} has {what}s 0 to {last}"))
    };
    if arguments.mip >= mips {
        return Err(out_of_range("mip", arguments.mip, mips));
    }
    match arguments.layer {
        Some(layer) if layer >= layers => Err(out_of_range("layer", layer, layers)),
        Some(layer) => Ok(Selection { table, layers: layer..layer + 1, single: true }),
        None => Ok(Selection { table, layers: 0..layers, single: layers == 1 }),
    }
}

fn encode(format: DumpFormat, selection: &Selection<'_>) -> Result<Vec<u8>, Failure> {
    match format {
        DumpFormat::Text => Ok(text::text(selection).into_bytes()),
        DumpFormat::Csv => Ok(text::csv(selection).into_bytes()),
        DumpFormat::Npy => npy::encode(selection),
        DumpFormat::Png => picture::encode(selection),
        DumpFormat::Exr => exr::encode(selection),
    }
}

/// What the numbers in the output are.
fn value_words(format: DumpFormat, selection: &Selection<'_>) -> &'static str {
    match format {
        DumpFormat::Png => "16-bit grey over the table's range",
        _ if !selection.is_horizon() => "the length unit",
        DumpFormat::Text => "degrees of elevation",
        DumpFormat::Csv => "degrees of elevation and slope",
        DumpFormat::Npy => "slopes",
        DumpFormat::Exr => "radians of elevation",
    }
}

fn to_stdout(format: DumpFormat, json: bool, bytes: &[u8]) -> Result<ExitStatus, Failure> {
    if json || !matches!(format, DumpFormat::Text | DumpFormat::Csv) {
        return Err(Failure::Usage("-o is missing: only text and csv go to stdout, and not with --json".to_owned()));
    }
    console::print_bytes(bytes)?;
    Ok(ExitStatus::Success)
}

fn describe(report: &Report) -> String {
    let Report { table, output, layers, width, height, values, .. } = report;
    let layers = if *layers == 1 { String::new() } else { format!("{layers} layers of ") };
    format!("dumped    {table} to {output}: {layers}{width} × {height}, {values}\n")
}
