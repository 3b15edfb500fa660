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
use std::time::{Duration, Instant};

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
    println!("Every texel of every {ROW_STRIDE}th row, every direction; default radius.\n");
    println!("| field | size | edge | directions | RMS ° | max ° | above ° | compared | sweep M/s | reference M/s |");
    println!("|---|---|---|---:|---:|---:|---:|---:|---:|---:|");
    for (name, field) in &fields {
        for directions in DIRECTIONS {
            println!("{}", row(name, field, directions)?);
        }
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

fn row(name: &str, field: &HeightField, directions: u32) -> Result<String, Box<dyn Error>> {
    let grid = field.grid();
    let params = HorizonParams { directions, radius: HorizonParams::default_radius(grid), distance: true };
    let exec = Exec::new(1)?;
    let mut time = Duration::MAX;
    let mut swept = None;
    for _ in 0..2 {
        let start = Instant::now();
        swept = Some(horizon::bake(field, &params, &exec)?);
        time = time.min(start.elapsed());
    }
    let swept = swept.ok_or("nothing was baked")?;
    let (below, above) = compare(field, &params, &swept);
    let rate = (grid.texels() * directions as usize) as f64 / time.as_secs_f64();
    Ok(format!(
        "| {name} | {} × {} | {} | {directions} | {:.4} | {:.3} | {:.1e} | {} | {:.1} | {:.2} |",
        grid.width,
        grid.height,
        grid.edge.name(),
        below.rms().to_degrees(),
        below.max().to_degrees(),
        above.to_degrees(),
        below.count(),
        rate / 1e6,
        reference_rate(field, &params) / 1e6,
    ))
}

/// Statistics of all differences, and the most that the sweep is above the reference, in radians.
fn compare(field: &HeightField, params: &HorizonParams, swept: &HorizonMap) -> (ErrorStats, f64) {
    let width = field.grid().width;
    let rows: Vec<(u32, u32)> = (0..params.directions)
        .flat_map(|direction| (0..field.grid().height).step_by(ROW_STRIDE as usize).map(move |row| (direction, row)))
        .collect();
    let of_row = |&(direction, row): &(u32, u32)| {
        let layer = swept.elevation_layer(direction);
        let errors = (0..width).map(|column| {
            let expected = reference::horizon(field, params, direction, column, row).slope.atan();
            f64::from(layer[(row * width + column) as usize]) - expected
        });
        let mut above = 0.0_f64;
        let stats = ErrorStats::of(errors.inspect(|&error| above = above.max(error)));
        (stats, above)
    };
    // Rows are merged in their order, whatever threads they came from.
    let parts: Vec<(ErrorStats, f64)> = rows.par_iter().map(of_row).collect();
    parts.iter().fold((ErrorStats::default(), 0.0), |(mut stats, above), part| {
        stats.merge(&part.0);
        (stats, part.1.max(above))
    })
}

/// Texels and directions per second of the reference, on one thread.
fn reference_rate(field: &HeightField, params: &HorizonParams) -> f64 {
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
