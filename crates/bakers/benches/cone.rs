//! Cone maps and maximum mips: one thread, per texel.

#![allow(missing_docs, reason = "criterion's macros write public functions")]

use barchan_bakers::cone::{self, ConeKind};
use barchan_bakers::{Exec, maximum_mip};
use barchan_field::{Edge, Grid, HeightField, LengthUnit, Shape, Spacing};
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main, measurement::WallTime};

/// Fractal relief that is 0.15 of a tile high.
fn fractal(size: u32) -> HeightField {
    let grid =
        Grid { width: size, height: size, spacing: Spacing::UNIT, unit: LengthUnit::SceneUnit, edge: Edge::Wrap };
    let shapes = Shape::examples();
    let shape = shapes.into_iter().find(|shape| shape.name() == "fractal_terrain").expect("an example of every shape");
    let field = shape.rasterize(grid).expect("examples fit");
    let (lowest, highest) = field.range();
    let scale = 0.15 * size as f32 / (highest - lowest);
    HeightField::new(grid, field.samples().iter().map(|height| scale * height).collect()).expect("finite heights")
}

fn group<'a>(criterion: &'a mut Criterion, name: &str, size: u32) -> BenchmarkGroup<'a, WallTime> {
    let mut group = criterion.benchmark_group(name);
    group.sample_size(10);
    group.throughput(Throughput::Elements(u64::from(size * size)));
    group
}

fn cones(criterion: &mut Criterion) {
    let exec = Exec::new(1).expect("one thread");
    for size in [128, 256] {
        let field = fractal(size);
        let mut group = group(criterion, "cone", size);
        for (name, kind) in [("strict", ConeKind::Strict), ("relaxed", ConeKind::Relaxed)] {
            group.bench_function(format!("{name}/{size}"), |bencher| {
                bencher.iter(|| cone::bake(&field, kind, &exec).expect("memory"));
            });
        }
        group.finish();
    }
}

fn mips(criterion: &mut Criterion) {
    let exec = Exec::new(1).expect("one thread");
    let field = fractal(1024);
    let mut group = group(criterion, "maximum_mip", 1024);
    group.bench_function("1024", |bencher| bencher.iter(|| maximum_mip::bake(&field, &exec).expect("memory")));
    group.finish();
}

criterion_group!(benches, cones, mips);
criterion_main!(benches);
