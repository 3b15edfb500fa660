//! `barchan compare`: the first difference between two files, and how large differences are.

mod curvature;

use std::fmt::Write;

use barchan_asset::{TextureDescriptor, Unit};
use barchan_metrics::{ErrorStats, first_difference};
use barchan_pipeline::Table;
use serde::Serialize;

use crate::args::CompareArguments;
use crate::asset_file::{AssetFile, DecodedTable};
use crate::console::{self, number};
use crate::failure::{ExitStatus, Failure};

#[derive(Serialize)]
struct Report {
    schema: &'static str,
    a: String,
    b: String,
    tolerance: f64,
    same: bool,
    tables: Vec<TableReport>,
}

#[derive(Serialize)]
struct TableReport {
    table: &'static str,
    same: bool,
    /// What keeps the values from being compared: the table is only in one file, or has another shape.
    mismatch: Option<String>,
    values: Option<ValueReport>,
}

/// Differences `b − a`, in degrees for elevations, in the length unit for lengths, plain for depths and ratios.
#[derive(Serialize)]
struct ValueReport {
    unit: &'static str,
    rms: f64,
    max: f64,
    first: Option<Place>,
    worst: Option<Place>,
}

#[derive(Serialize)]
struct Place {
    #[serde(flatten)]
    at: Position,
    a: f32,
    b: f32,
}

#[derive(Serialize)]
#[serde(untagged)]
enum Position {
    Texel {
        layer: u32,
        column: u32,
        row: u32,
        /// Of the numbers of a texel.
        channel: u32,
    },
    Level {
        mip: u32,
        column: u32,
        row: u32,
    },
    Vertex {
        vertex: u32,
        number: &'static str,
    },
}

pub(crate) fn run(arguments: &CompareArguments, json: bool) -> Result<ExitStatus, Failure> {
    let (a, b) = (AssetFile::read(&arguments.a)?, AssetFile::read(&arguments.b)?);
    let tables = compare(&a, &b, arguments.tolerance)?;
    let report = Report {
        schema: "barchan.compare/1",
        a: a.path.display().to_string(),
        b: b.path.display().to_string(),
        tolerance: arguments.tolerance,
        same: tables.iter().all(|table| table.same),
        tables,
    };
    console::present(&report, json, describe)?;
    Ok(if report.same { ExitStatus::Success } else { ExitStatus::Difference })
}

fn compare(a: &AssetFile, b: &AssetFile, tolerance: f64) -> Result<Vec<TableReport>, Failure> {
    let (in_a, in_b) = (a.tables()?, b.tables()?);
    let mut reports = Vec::new();
    for table in Table::ALL {
        let report = match (in_a.contains(&table), in_b.contains(&table)) {
            (false, false) => continue,
            (true, true) if table.is_of_a_mesh() => {
                reports.extend(curvature::compare(&a.curvature()?.view(), &b.curvature()?.view(), tolerance));
                continue;
            }
            (true, true) => compare_table(&a.decode(table)?, &b.decode(table)?, tolerance),
            (only_a, _) => {
                let holder = if only_a { a } else { b };
                mismatched(table.name(), format!("only {} has it", holder.path.display()))
            }
        };
        reports.push(report);
    }
    Ok(reports)
}

fn mismatched(table: &'static str, mismatch: String) -> TableReport {
    TableReport { table, same: false, mismatch: Some(mismatch), values: None }
}

fn compare_table(a: &DecodedTable<'_>, b: &DecodedTable<'_>, tolerance: f64) -> TableReport {
    if let Some(mismatch) = shape_mismatch(&a.descriptor, &b.descriptor) {
        return mismatched(a.table.name(), mismatch);
    }
    let (values_a, values_b) = (comparable(a), comparable(b));
    let descriptor = &a.descriptor;
    let unit = match descriptor.unit {
        Unit::Radian => "degrees",
        Unit::Length(_) | Unit::None => descriptor.unit.symbol(),
    };
    let values = compare_values([&values_a, &values_b], tolerance, unit, |index| position(descriptor, index));
    TableReport { table: a.table.name(), same: values.first.is_none(), mismatch: None, values: Some(values) }
}

/// Where the `index`th value of a texture is.
fn position(descriptor: &TextureDescriptor, index: usize) -> Position {
    let channels = descriptor.semantic.channels() as usize;
    let (mut texel, channel) = (index / channels, (index % channels) as u32);
    let texels_of = |layer| {
        let (width, height) = descriptor.picture_extent(layer);
        width as usize * height as usize
    };
    let mut layer = 0;
    while layer + 1 < descriptor.pictures() && texel >= texels_of(layer) {
        texel -= texels_of(layer);
        layer += 1;
    }
    let width = descriptor.picture_extent(layer).0 as usize;
    let (column, row) = ((texel % width) as u32, (texel / width) as u32);
    match descriptor.mips {
        1 => Position::Texel { layer, column, row, channel },
        _ => Position::Level { mip: layer, column, row },
    }
}

/// Differences between two lists of the same length, whose numbers are at some `position` of a table.
fn compare_values(
    [a, b]: [&[f32]; 2],
    tolerance: f64,
    unit: &'static str,
    position: impl Fn(usize) -> Position,
) -> ValueReport {
    let stats = ErrorStats::between(a, b);
    let place = |index: usize| Place { at: position(index), a: a[index], b: b[index] };
    ValueReport {
        unit,
        rms: stats.rms(),
        max: stats.max(),
        first: first_difference(a, b, tolerance).map(|difference| place(difference.index)),
        worst: stats.worst().filter(|_| stats.max() > 0.0).map(|index| place(index as usize)),
    }
}

/// Facts that must agree before values can be compared. Encodings may differ: decoded values are what counts.
fn shape_mismatch(a: &TextureDescriptor, b: &TextureDescriptor) -> Option<String> {
    let facts = |d: &TextureDescriptor| {
        [
            ("extent", format!("{} × {} × {} layers", d.width, d.height, d.layers)),
            ("spacing", format!("{} × {}", d.spacing_u, d.spacing_v)),
            ("length unit", d.length_unit.name().to_owned()),
            ("edge", format!("{} / {}", d.wrap_u.name(), d.wrap_v.name())),
            ("search radius", d.search_radius.to_string()),
            ("azimuths", azimuth_words(d)),
            ("candidates", d.candidates.to_string()),
            ("range of curvatures", format!("{} to {}", d.curvature_min, d.curvature_max)),
            ("grid of directions", ring_words(d)),
            ("relief", format!("{} deep below {}", d.relief_thickness, d.relief_top)),
        ]
    };
    let different = facts(a).into_iter().zip(facts(b)).find(|(a, b)| a != b);
    different.map(|((fact, a), (_, b))| format!("{fact} is {a} in one and {b} in the other"))
}

fn ring_words(descriptor: &TextureDescriptor) -> String {
    match (descriptor.directions(), descriptor.depth_mode) {
        (Some(directions), Some(mode)) => {
            let (spacing, polar) = (directions.spacing.name(), number(directions.max_polar_radians.to_degrees()));
            format!("{} rings of {spacing} to {polar}°, {}", directions.rings, mode.name())
        }
        _ => "none".to_owned(),
    }
}

fn azimuth_words(descriptor: &TextureDescriptor) -> String {
    match console::covered_arc(descriptor) {
        Some(arc) => console::arc(arc),
        None => "all around".to_owned(),
    }
}

/// All decoded values, angles in degrees.
fn comparable(table: &DecodedTable<'_>) -> Vec<f32> {
    let (view, descriptor) = (table.view(), &table.descriptor);
    let rows_of = |layer| (0..descriptor.picture_extent(layer).1).map(move |row| (layer, row));
    let rows = (0..descriptor.pictures()).flat_map(rows_of);
    let values = rows.flat_map(|(layer, row)| view.row(layer, row));
    match descriptor.unit {
        Unit::Radian => values.map(|radians| f64::from(radians).to_degrees() as f32).collect(),
        Unit::Length(_) | Unit::None => values.collect(),
    }
}

fn describe(report: &Report) -> String {
    let mut text = String::new();
    for table in &report.tables {
        let words = match (&table.mismatch, &table.values) {
            (Some(mismatch), _) => mismatch.clone(),
            (None, Some(values)) => values_words(values),
            (None, None) => String::new(),
        };
        // Writing into a String cannot fail.
        let _ = writeln!(text, "{:14} {words}", table.table);
    }
    let verdict = if report.same { "the same" } else { "different" };
    let _ = writeln!(text, "{} and {}: {verdict} at tolerance {}", report.a, report.b, report.tolerance);
    text
}

fn values_words(values: &ValueReport) -> String {
    let ValueReport { unit, rms, max, first, worst } = values;
    let place = |name: &str, place: &Option<Place>| {
        place.as_ref().map_or_else(String::new, |at| {
            let Place { at, a, b } = at;
            let at = match at {
                Position::Texel { layer, column, row, channel: 0 } => {
                    format!("layer {layer}, column {column}, row {row}")
                }
                Position::Texel { layer, column, row, channel } => {
                    format!("layer {layer}, column {column}, row {row}, channel {channel}")
                }
                Position::Level { mip, column, row } => format!("level {mip}, column {column}, row {row}"),
                Position::Vertex { vertex, number } => format!("vertex {vertex}, {number}"),
            };
            format!("; {name} at {at}: {a} and {b}")
        })
    };
    let (rms, max) = (number(*rms), number(*max));
    let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
    format!("RMS {rms}{unit}, at most {max}{unit}{}{}", place("first", first), place("worst", worst))
}
