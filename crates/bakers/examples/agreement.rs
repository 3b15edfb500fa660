//! The sweep against the reference: every example shape, white noise, and a height map if one is given. A markdown table on stdout.
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

use barchan_bakers::horizon::{self, Azimuths, HorizonMap, HorizonParams, Method, reference};
use barchan_bakers::{BakeError, Exec};
use barchan_field::{Edge, FieldError, Grid, HeightField, LengthUnit, Shape, Spacing};
use barchan_import::{HeightMapOptions, read_height_map};
use barchan_metrics::ErrorStats;

/// Texels of a shape's side.
const SIZE: u32 = 256;
/// 17 has no multiple of 45° but 0.
const DIRECTIONS: [u32; 2] = [32, 17];
fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let mut fields = shapes()?;
    fields.push(("white noise".to_owned(), white_noise()?));
    fields.extend(height_map(&arguments)?);
    println!("Every texel and every direction of {DIRECTIONS:?}; default radius; rates of one thread.\n");
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

/// The sweep's worst case: heights of 0 to 4 texels, each texel by itself.
fn white_noise() -> Result<HeightField, FieldError> {
    let mut state = 0_u64;
    let mut next = || {
        // Knuth's MMIX generator; its upper bits are the random ones.
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        4.0 * (state >> 40) as f32 / (1 << 24) as f32
    };
    let grid =
        Grid { width: SIZE, height: SIZE, spacing: Spacing::UNIT, unit: LengthUnit::SceneUnit, edge: Edge::Wrap };
    HeightField::new(grid, (0..grid.texels()).map(|_| next()).collect())
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
    let exec = Exec::new(1)?;
    let mut errors = ErrorStats::default();
    let (mut sweep_seconds, mut reference_seconds) = (0.0, 0.0);
    for directions in DIRECTIONS {
        let params = HorizonParams {
            azimuths: Azimuths::full_circle(directions),
            radius: HorizonParams::default_radius(field.grid()),
            distance: true,
            method: Method::default(),
        };
        let (swept, seconds) = timed(|| horizon::bake(field, &params, &exec))?;
        sweep_seconds += seconds;
        let (expected, seconds) = timed(|| reference::bake(field, &params, &exec))?;
        reference_seconds += seconds;
        errors.merge(&ErrorStats::between(&expected.elevation_radians, &swept.elevation_radians));
    }
    let Grid { width, height, edge, .. } = *field.grid();
    let mega = errors.count() as f64 / 1e6;
    Ok(format!(
        "| {name} | {width} × {height} {} | {:.3}° | {:.2}° | {:.1} M/s | {:.2} M/s | {:.0} × |",
        edge.name(),
        errors.rms().to_degrees(),
        errors.max().to_degrees(),
        mega / sweep_seconds,
        mega / reference_seconds,
        reference_seconds / sweep_seconds,
    ))
}

fn timed(bake: impl Fn() -> Result<HorizonMap, BakeError>) -> Result<(HorizonMap, f64), BakeError> {
    let start = Instant::now();
    let map = bake()?;
    Ok((map, start.elapsed().as_secs_f64()))
}
