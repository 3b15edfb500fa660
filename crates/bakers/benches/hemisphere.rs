//! The cost of a ray, by ring, relief and map size. What the docs quote is the last group: a 512² map in 512 directions, taken down to 64².

#![allow(missing_docs, reason = "criterion's macros write public functions")]

use std::time::Duration;

use barchan_asset::{Azimuths, DepthMode, HemisphereDirections, RingSpacing};
use barchan_bakers::Exec;
use barchan_bakers::hemisphere::{self, HemisphereBaker, HemisphereParams};
use barchan_field::{Edge, Grid, HeightField, LengthUnit, Shape, Spacing};
use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};

/// How deep a relief is, in tiles.
const DEPTH: f64 = 0.15;

/// An example of a size, or white noise, made so deep that it is [`DEPTH`] of its tile.
fn field(name: &str, size: u32) -> HeightField {
    let spacing = Spacing::square(256.0 / f64::from(size)).expect("a length");
    let grid = Grid { width: size, height: size, spacing, unit: LengthUnit::SceneUnit, edge: Edge::Wrap };
    let field = match Shape::examples().into_iter().find(|shape| shape.name() == name) {
        Some(shape) => shape.rasterize(grid).expect("examples fit"),
        None => HeightField::new(grid, (0..size * size).map(white_noise).collect()).expect("finite heights"),
    };
    let (lowest, highest) = field.range();
    let scale = (DEPTH * 256.0 / (f64::from(highest) - f64::from(lowest))) as f32;
    HeightField::new(grid, field.samples().iter().map(|height| height * scale).collect()).expect("finite heights")
}

/// Heights of 0 to 1, each texel by itself.
fn white_noise(texel: u32) -> f32 {
    let mixed = (texel ^ (texel >> 15)).wrapping_mul(0x2C1B_3C6D);
    let mixed = (mixed ^ (mixed >> 12)).wrapping_mul(0x297A_2D39);
    (mixed >> 8) as f32 / (1 << 24) as f32
}

/// The paper's directions, up to 80° from the normal, and a table of an eighth of the map's sides.
fn params(size: u32) -> HemisphereParams {
    let directions = HemisphereDirections {
        rings: 32,
        azimuths: Azimuths::full_circle(16),
        spacing: RingSpacing::EqualAngles,
        max_polar_radians: 80_f64.to_radians(),
    };
    HemisphereParams { directions, width: size / 8, height: size / 8, mode: DepthMode::Nearest }
}

fn group<'a>(criterion: &'a mut Criterion, varied: &str) -> BenchmarkGroup<'a, WallTime> {
    let mut group = criterion.benchmark_group(varied);
    group.sample_size(10).warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(1));
    group
}

/// All azimuths of one ring.
fn ring(group: &mut BenchmarkGroup<'_, WallTime>, name: &str, size: u32, ring: u32) {
    let (field, params, exec) = (field(name, size), params(size), Exec::new(1).expect("a thread"));
    let baker = HemisphereBaker::new(&field, params, &exec).expect("a table");
    let mut depths = vec![0.0; params.width as usize * params.height as usize];
    group.throughput(Throughput::Elements(u64::from(size * size) * 16));
    group.bench_function(BenchmarkId::new(format!("{name}_{size}"), format!("ring_{ring}")), |bencher| {
        bencher.iter(|| {
            for azimuth in 0..16 {
                baker.bake_layer(params.directions.layer(ring, azimuth), &exec, &mut depths);
            }
        });
    });
}

fn rings(criterion: &mut Criterion) {
    let mut group = group(criterion, "hemisphere_ring");
    for index in [0, 8, 16, 24, 31] {
        ring(&mut group, "fractal_terrain", 256, index);
    }
}

fn reliefs(criterion: &mut Criterion) {
    let mut group = group(criterion, "hemisphere_relief");
    for name in ["dunes", "reptile_skin", "spike", "step_wall", "white_noise"] {
        ring(&mut group, name, 256, 24);
    }
}

fn whole(criterion: &mut Criterion) {
    let mut group = group(criterion, "hemisphere_table");
    let (field, params) = (field("fractal_terrain", 512), params(512));
    group.throughput(Throughput::Elements(512 * 512 * 512));
    for threads in [1, 2] {
        let exec = Exec::new(threads).expect("threads");
        group.bench_function(BenchmarkId::new("fractal_terrain_512", threads), |bencher| {
            bencher.iter(|| hemisphere::bake(&field, &params, &exec));
        });
    }
}

/// The conservative mode by the size of the table: a 512² map in 512 directions.
fn conservative(criterion: &mut Criterion) {
    let mut group = group(criterion, "hemisphere_conservative");
    let (field, nearest) = (field("fractal_terrain", 512), params(512));
    group.throughput(Throughput::Elements(512 * 512 * 512));
    for size in [32, 64, 512] {
        let params = HemisphereParams { width: size, height: size, mode: DepthMode::Conservative, ..nearest };
        for threads in [1, 2] {
            let exec = Exec::new(threads).expect("threads");
            group.bench_function(BenchmarkId::new(format!("fractal_terrain_512_to_{size}"), threads), |bencher| {
                bencher.iter(|| hemisphere::bake(&field, &params, &exec));
            });
        }
    }
}

criterion_group!(benches, rings, reliefs, whole, conservative);
criterion_main!(benches);
