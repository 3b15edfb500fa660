//! The sky against rays: every example shape, white noise and a map if one is given. A markdown table on stdout.
//!
//! ```text
//! cargo run --release -p barchan-bakers --example sky -- [HEIGHT_MAP [HEIGHT_SCALE [SPACING_U [SPACING_V]]]]
//! ```
//!
//! The scale turns samples into heights and the spacing is that of texels; unless given they are those of
//! `samples/jacksboro.png`: 65535, 74 and 93. Horizons are exact, so that errors are those of the sky: of the
//! azimuths there are, and of the rays, whose own error is about that of the smooth fields at 64 directions. Texels
//! are a sample, the same for every row of a field. Time is that of all three tables on one thread, per texel,
//! without the horizons.

#![allow(clippy::print_stdout, reason = "an example's output is its purpose")]

use std::error::Error;
use std::path::Path;
use std::time::Instant;

use barchan_bakers::horizon::{Azimuths, HorizonParams, Method, reference as horizon};
use barchan_bakers::sky::reference::{RayCount, SkyPoint, sky};
use barchan_bakers::sky::{SkyAccumulator, SkyMap, SkyParams};
use barchan_bakers::{BakeError, Exec};
use barchan_field::{Edge, Grid, HeightField, LengthUnit, Shape, Spacing};
use barchan_import::{HeightMapOptions, read_height_map};
use barchan_metrics::ErrorStats;

/// Texels of a shape's side; the shapes are meant for tiles of 256 length units.
const SIZE: u32 = 128;
const DIRECTIONS: [u32; 4] = [8, 16, 32, 64];
const SAMPLES: usize = 64;
const RAYS: RayCount = RayCount { rings: 96, rays: 384 };

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let mut fields = shapes()?;
    fields.push(("white noise".to_owned(), white_noise()?));
    fields.extend(height_map(&arguments)?);
    println!("RMS / maximum over {SAMPLES} texels, against {} × {} rays of each.\n", RAYS.rings, RAYS.rays);
    println!("| field | directions | visibility | bent normal | cone's axis | half-angle | ns per texel |");
    println!("|---|---:|---:|---:|---:|---:|---:|");
    for (name, field) in &fields {
        let sample = Sample::trace(field);
        for directions in DIRECTIONS {
            println!("| {name} | {directions} | {} |", sample.row(directions)?);
        }
    }
    Ok(())
}

fn grid(size: u32, length: f64, edge: Edge) -> Result<Grid, Box<dyn Error>> {
    let spacing = Spacing::square(length / f64::from(size))?;
    Ok(Grid { width: size, height: size, spacing, unit: LengthUnit::SceneUnit, edge })
}

fn shapes() -> Result<Vec<(String, HeightField)>, Box<dyn Error>> {
    let rasterize = |shape: Shape| {
        let edge = if shape.tiles() { Edge::Wrap } else { Edge::Clamp };
        Ok((shape.name().to_owned(), shape.rasterize(grid(SIZE, 256.0, edge)?)?))
    };
    Shape::examples().into_iter().map(rasterize).collect()
}

/// Heights of 0 to 4 texels, each texel by itself.
fn white_noise() -> Result<HeightField, Box<dyn Error>> {
    let mut next = generator();
    let grid = grid(SIZE, f64::from(SIZE), Edge::Wrap)?;
    Ok(HeightField::new(grid, (0..grid.texels()).map(|_| 4.0 * next()).collect())?)
}

/// Numbers in [0, 1): Knuth's MMIX generator, whose upper bits are the random ones.
fn generator() -> impl FnMut() -> f32 {
    let mut state = 0_u64;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f32 / (1 << 24) as f32
    }
}

fn height_map(arguments: &[String]) -> Result<Option<(String, HeightField)>, Box<dyn Error>> {
    let Some((path, numbers)) = arguments.split_first() else { return Ok(None) };
    let number = |index: usize, default: f64| match numbers.get(index) {
        Some(text) => text.parse().map_err(|_| format!("{text} is not a number")),
        None => Ok(default),
    };
    let options = HeightMapOptions {
        height_scale: number(0, 65535.0)?,
        spacing: Spacing::new(number(1, 74.0)?, number(2, 93.0)?)?,
        ..HeightMapOptions::default()
    };
    let path = Path::new(path);
    let name = path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    Ok(Some((name, read_height_map(path, &options)?.field)))
}

/// Some texels of a field, and what rays see from them.
struct Sample<'a> {
    field: &'a HeightField,
    radius: f64,
    texels: Vec<(u32, u32)>,
    traced: Vec<SkyPoint>,
}

impl<'a> Sample<'a> {
    fn trace(field: &'a HeightField) -> Self {
        let radius = HorizonParams::default_radius(field.grid());
        let mut next = generator();
        let mut below = |limit: u32| (next() * limit as f32) as u32;
        let texels: Vec<_> = (0..SAMPLES).map(|_| (below(field.grid().width), below(field.grid().height))).collect();
        let traced = texels.iter().map(|&texel| sky(field, radius, texel, RAYS)).collect();
        Self { field, radius, texels, traced }
    }

    fn row(&self, directions: u32) -> Result<String, BakeError> {
        let (map, seconds) = self.bake(directions)?;
        let mut errors = [(); 4].map(|()| ErrorStats::default());
        for (&texel, traced) in self.texels.iter().zip(&self.traced) {
            for (stats, error) in errors.iter_mut().zip(errors_at(&map, texel, traced)) {
                stats.merge(&ErrorStats::between(&[0.0], &[error as f32]));
            }
        }
        let [visibility, bent, axis, half_angle] = errors;
        let degrees = |stats: ErrorStats| format!("{:.3}° / {:.2}°", stats.rms(), stats.max());
        Ok(format!(
            "{:.5} / {:.4} | {} | {} | {} | {:.0}",
            visibility.rms(),
            visibility.max(),
            degrees(bent),
            degrees(axis),
            degrees(half_angle),
            1e9 * seconds / self.field.grid().texels() as f64,
        ))
    }

    /// Horizons are found for the sampled texels alone, and left level elsewhere.
    fn bake(&self, directions: u32) -> Result<(SkyMap, f64), BakeError> {
        let (exec, azimuths) = (Exec::new(1)?, Azimuths::full_circle(directions));
        let params = HorizonParams { azimuths, radius: self.radius, distance: false, method: Method::Exact };
        let mut accumulator = SkyAccumulator::new(self.field, &azimuths, SkyParams::ALL)?;
        let mut elevations = vec![0.0; self.field.grid().texels()];
        let mut fastest = f64::INFINITY;
        for direction in 0..directions {
            for &(column, row) in &self.texels {
                let point = horizon::horizon(self.field, &params, direction, column, row);
                elevations[index(self.field.grid(), (column, row))] = point.slope.atan() as f32;
            }
            let start = Instant::now();
            accumulator.add(direction, &elevations, &exec);
            fastest = fastest.min(start.elapsed().as_secs_f64());
        }
        let start = Instant::now();
        let map = accumulator.finish(&exec)?;
        // Of the fastest direction, which nothing else on the machine held up.
        Ok((map, f64::from(directions) * fastest + start.elapsed().as_secs_f64()))
    }
}

fn index(grid: &Grid, (column, row): (u32, u32)) -> usize {
    row as usize * grid.width as usize + column as usize
}

/// Of visibility; of the bent normal, the cone's axis and its half-angle in degrees.
fn errors_at(map: &SkyMap, texel: (u32, u32), traced: &SkyPoint) -> [f64; 4] {
    let texel = index(&map.grid, texel);
    let value = |table: &Option<Vec<f32>>, index: usize| f64::from(table.as_ref().expect("it was asked for")[index]);
    let (u, v) = (value(&map.bent_normal, 2 * texel), value(&map.bent_normal, 2 * texel + 1));
    let bent = [u, v, (1.0 - u * u - v * v).max(0.0).sqrt()];
    let [axis_u, axis_v, axis_up, cos] = [0, 1, 2, 3].map(|part| value(&map.aperture_cone, 4 * texel + part));
    [
        value(&map.visibility, texel) - traced.visibility,
        degrees_between(bent, traced.bent_normal),
        degrees_between([axis_u, axis_v, axis_up], traced.cone_axis),
        (cos.acos() - traced.cos_half_angle.acos()).to_degrees(),
    ]
}

/// By the chord, which small angles do not cancel in.
fn degrees_between(a: [f64; 3], b: [f64; 3]) -> f64 {
    let chord = (0..3).map(|axis| (a[axis] - b[axis]).powi(2)).sum::<f64>().sqrt();
    (2.0 * (0.5 * chord).min(1.0).asin()).to_degrees()
}
