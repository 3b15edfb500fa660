//! The sweep against the reference: every example shape, and a height map if one is given. A markdown table on stdout.
//!
//! ```text
//! cargo run --release -p barchan-bakers --example agreement -- \
//!     [HEIGHT_MAP [HEIGHT_SCALE [HEIGHT_OFFSET [SPACING_U [SPACING_V]]]]]
//! ```
//!
//! Scale and offset turn samples into heights and are 1 and 0 unless given; the spacing is that of `samples/jacksboro.png`,
//! 74 and 93, in the same unit. Errors are differences of elevation. Rates count one texel in one direction, on one thread.

#![allow(clippy::print_stdout, reason = "an example's output is its purpose")]

use std::error::Error;
use std::path::Path;
use std::time::Instant;

use barchan_bakers::Exec;
use barchan_bakers::horizon::{self, HorizonMap, HorizonParams, reference};
use barchan_field::{Edge, Grid, HeightField, LengthUnit, Shape, Spacing};
use barchan_import::{HeightMapOptions, read_height_map};
use barchan_metrics::ErrorStats;
use rayon::prelude::*;

/// Texels of a shape's side.
const SIZE: u32 = 256;
/// 17 has no multiple of 45° but 0.
const DIRECTIONS: [u32; 2] = [32, 17];
/// The reference looks at every texel of every so many rows; of all, it would take some five minutes on two cores.
const ROW_STRIDE: u32 = 8;
/// Directions and rows the reference's rate is measured on: it is the same everywhere.
const RATE_DIRECTIONS: u32 = 4;
const RATE_ROWS: u32 = 4;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let mut fields = shapes()?;
    fields.extend(height_map(&arguments)?);
    println!(
        "Every texel of every {ROW_STRIDE}th row, every direction of {DIRECTIONS:?}; default radius; one thread.\n"
    );
    println!("| field | grid | RMS | maximum | sweep | reference | faster |");
    println!("|---|---|---:|---:|---:|---:|---:|");
    for (name, field) in &fields {
        println!("{}", row(name, field)?);
    }
    Ok(())
}

fn shapes() -> Result<Vec<(String, HeightField)>, Box<dyn Error>> {
    let examples = Shape::examples().into_iter();
    let rasterize = |shape: Shape| {
        let edge = if shape.tiles() { Edge::Wrap } else { Edge::Clamp };
        let grid = Grid { width: SIZE, height: SIZE, spacing: Spacing::UNIT, unit: LengthUnit::SceneUnit, edge };
        Ok((shape.name().to_owned(), shape.rasterize(grid)?))
    };
    examples.map(rasterize).collect()
}

fn height_map(arguments: &[String]) -> Result<Option<(String, HeightField)>, Box<dyn Error>> {
    let Some((path, numbers)) = arguments.split_first() else { return Ok(None) };
    let number = |index: usize, default: f64| match numbers.get(index) {
        Some(text) => text.parse().map_err(|_| format!("{text} is not a number")),
        None => Ok(default),
    };
    let options = HeightMapOptions {
        height_scale: number(0, 1.0)?,
        height_offset: number(1, 0.0)?,
        spacing: Spacing::new(number(2, 74.0)?, number(3, 93.0)?)?,
        ..HeightMapOptions::default()
    };
    let path = Path::new(path);
    let name = path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    Ok(Some((name, read_height_map(path, &options)?.field)))
}

fn row(name: &str, field: &HeightField) -> Result<String, Box<dyn Error>> {
    let (mut below, mut rate, mut reference_rate) = (ErrorStats::default(), f64::INFINITY, f64::INFINITY);
    for directions in DIRECTIONS {
        let params = HorizonParams { directions, radius: HorizonParams::default_radius(field.grid()), distance: true };
        let (swept, seconds) = sweep(field, &params)?;
        below.merge(&compare(field, &params, &swept));
        rate = rate.min((field.grid().texels() * directions as usize) as f64 / seconds);
        reference_rate = reference_rate.min(measure_reference(field, &params));
    }
    let Grid { width, height, edge, .. } = *field.grid();
    Ok(format!(
        "| {name} | {width} × {height} {} | {:.3}° | {:.2}° | {:.1} M/s | {:.2} M/s | {:.0} × |",
        edge.name(),
        below.rms().to_degrees(),
        below.max().to_degrees(),
        rate / 1e6,
        reference_rate / 1e6,
        rate / reference_rate,
    ))
}

/// A bake on one thread, and the shorter of two times it took.
fn sweep(field: &HeightField, params: &HorizonParams) -> Result<(HorizonMap, f64), Box<dyn Error>> {
    let exec = Exec::new(1)?;
    let start = Instant::now();
    let swept = horizon::bake(field, params, &exec)?;
    let first = start.elapsed();
    let start = Instant::now();
    horizon::bake(field, params, &exec)?;
    Ok((swept, first.min(start.elapsed()).as_secs_f64()))
}

/// How far elevations are from the reference's, in radians.
fn compare(field: &HeightField, params: &HorizonParams, swept: &HorizonMap) -> ErrorStats {
    let width = field.grid().width;
    let rows: Vec<(u32, u32)> = (0..params.directions)
        .flat_map(|direction| (0..field.grid().height).step_by(ROW_STRIDE as usize).map(move |row| (direction, row)))
        .collect();
    let of_row = |&(direction, row): &(u32, u32)| {
        let layer = swept.elevation_layer(direction);
        ErrorStats::of((0..width).map(|column| {
            let expected = reference::horizon(field, params, direction, column, row).slope.atan();
            f64::from(layer[(row * width + column) as usize]) - expected
        }))
    };
    // Rows are merged in their order, whatever threads they came from.
    let parts: Vec<ErrorStats> = rows.par_iter().map(of_row).collect();
    parts.iter().fold(ErrorStats::default(), |mut stats, part| {
        stats.merge(part);
        stats
    })
}

/// Texels and directions per second of the reference, on one thread.
fn measure_reference(field: &HeightField, params: &HorizonParams) -> f64 {
    let Grid { width, height, .. } = *field.grid();
    let start = Instant::now();
    let mut lowest = f64::INFINITY;
    for direction in (0..params.directions).step_by((params.directions / RATE_DIRECTIONS) as usize) {
        for row in (0..height).step_by((height / RATE_ROWS) as usize) {
            for column in 0..width {
                lowest = lowest.min(reference::horizon(field, params, direction, column, row).slope);
            }
        }
    }
    std::hint::black_box(lowest);
    let directions = (0..params.directions).step_by((params.directions / RATE_DIRECTIONS) as usize).len();
    let rows = (0..height).step_by((height / RATE_ROWS) as usize).len();
    (directions * rows * width as usize) as f64 / start.elapsed().as_secs_f64()
}
