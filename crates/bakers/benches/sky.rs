//! What one direction adds to the sky, per texel, for each table alone and for all: one thread.

#![allow(missing_docs, reason = "criterion's macros write public functions")]

use barchan_bakers::Exec;
use barchan_bakers::horizon::Azimuths;
use barchan_bakers::sky::{SkyAccumulator, SkyParams};
use barchan_field::{Edge, Grid, LengthUnit, Shape, Spacing};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

const SIZE: u32 = 1024;
const DIRECTIONS: u32 = 8;

fn skies(criterion: &mut Criterion) {
    let exec = Exec::new(1).expect("one thread");
    let spacing = Spacing::square(0.25).expect("a length");
    let grid = Grid { width: SIZE, height: SIZE, spacing, unit: LengthUnit::SceneUnit, edge: Edge::Wrap };
    let dunes = Shape::examples().into_iter().find(|shape| shape.name() == "dunes").expect("an example of every shape");
    let field = dunes.rasterize(grid).expect("examples fit");
    // The cost does not depend on what the elevations are, only that they are of every kind.
    let elevations: Vec<f32> = field.samples().iter().map(|height| (height * 0.1).sin()).collect();
    let azimuths = Azimuths::full_circle(DIRECTIONS);
    let mut group = criterion.benchmark_group("sky");
    group.sample_size(20);
    group.throughput(Throughput::Elements(u64::from(SIZE * SIZE * DIRECTIONS)));
    let none = SkyParams::default();
    for (name, params) in [
        ("visibility", SkyParams { visibility: true, ..none }),
        ("bent_normal", SkyParams { bent_normal: true, ..none }),
        ("aperture_cone", SkyParams { aperture_cone: true, ..none }),
        ("all", SkyParams::ALL),
    ] {
        group.bench_function(name, |bencher| {
            bencher.iter_batched(
                || SkyAccumulator::new(&field, &azimuths, params).expect("memory"),
                |mut sky| {
                    for direction in 0..DIRECTIONS {
                        sky.add(direction, &elevations, &exec);
                    }
                    sky
                },
                criterion::BatchSize::LargeInput,
            );
        });
    }
    group.finish();
}

criterion_group!(benches, skies);
criterion_main!(benches);
