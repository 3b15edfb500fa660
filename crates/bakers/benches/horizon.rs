//! The cost of a texel in one direction, which should grow neither with the map nor with what is on it.
//!
//! Small enough to be run while a kernel is being written. What the docs quote is measured by `cargo xtask bench`, at full size
//! and in processor time.

#![allow(missing_docs, reason = "criterion's macros write public functions")]

use std::fmt::Display;
use std::time::Duration;

use barchan_bakers::Exec;
use barchan_bakers::horizon::{self, Azimuths, HorizonParams, Method};
use barchan_field::{Edge, Grid, HeightField, LengthUnit, Shape, Spacing};
use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};

/// One bake; each group below varies one part of it.
#[derive(Clone, Copy)]
struct Case {
    field: &'static str,
    size: u32,
    directions: u32,
    threads: usize,
}

const USUAL: Case = Case { field: "fractal_terrain", size: 256, directions: 8, threads: 1 };

/// The examples are meant for tiles of 256 length units, at any resolution.
fn field(name: &str, size: u32) -> HeightField {
    let spacing = Spacing::square(256.0 / f64::from(size)).expect("a length");
    let grid = Grid { width: size, height: size, spacing, unit: LengthUnit::SceneUnit, edge: Edge::Wrap };
    if let Some(shape) = Shape::examples().into_iter().find(|shape| shape.name() == name) {
        return shape.rasterize(grid).expect("examples fit");
    }
    let height: fn(u32) -> f32 = match name {
        "white_noise" => white_noise,
        _ => |_| 1.0,
    };
    let scale = grid.spacing.u() as f32;
    let samples = (0..size * size).map(|texel| scale * height(texel)).collect();
    HeightField::new(grid, samples).expect("finite heights")
}

/// Heights of 0 to 4 texels, each texel by itself.
fn white_noise(texel: u32) -> f32 {
    let mixed = (texel ^ (texel >> 15)).wrapping_mul(0x2C1B_3C6D);
    let mixed = (mixed ^ (mixed >> 12)).wrapping_mul(0x297A_2D39);
    4.0 * (mixed >> 8) as f32 / (1 << 24) as f32
}

fn bake(group: &mut BenchmarkGroup<'_, WallTime>, varied: &dyn Display, case: Case) {
    let Case { field: name, size, directions, threads } = case;
    let field = field(name, size);
    let exec = Exec::new(threads).expect("threads");
    group.throughput(Throughput::Elements(u64::from(size * size * directions)));
    for method in Method::ALL {
        let params = HorizonParams {
            azimuths: Azimuths::full_circle(directions),
            radius: HorizonParams::default_radius(field.grid()),
            distance: false,
            method,
        };
        group.bench_with_input(BenchmarkId::new(method.name(), varied.to_string()), &params, |bencher, params| {
            bencher.iter(|| horizon::bake(&field, params, &exec));
        });
    }
}

fn group<'a>(criterion: &'a mut Criterion, varied: &str) -> BenchmarkGroup<'a, WallTime> {
    let mut group = criterion.benchmark_group(varied);
    group.sample_size(10).warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(1));
    group
}

fn fields(criterion: &mut Criterion) {
    let mut group = group(criterion, "field");
    for field in ["fractal_terrain", "dunes", "white_noise", "spike", "constant"] {
        bake(&mut group, &field, Case { field, ..USUAL });
    }
}

fn sizes(criterion: &mut Criterion) {
    let mut group = group(criterion, "size");
    for size in [64, 128, 512] {
        bake(&mut group, &size, Case { size, ..USUAL });
    }
}

fn directions(criterion: &mut Criterion) {
    let mut group = group(criterion, "directions");
    // 17 has no multiple of 45° but 0.
    for directions in [4, 17, 32] {
        bake(&mut group, &directions, Case { directions, size: 128, ..USUAL });
    }
}

fn threads(criterion: &mut Criterion) {
    let mut group = group(criterion, "threads");
    for threads in [1, 2] {
        bake(&mut group, &threads, Case { threads, ..USUAL });
    }
}

criterion_group!(benches, fields, sizes, directions, threads);
criterion_main!(benches);
