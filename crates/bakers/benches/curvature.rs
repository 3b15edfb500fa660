//! The cost of a vertex, which should not grow with the mesh.
//!
//! Small enough to be run while a kernel is being written. What the docs quote is measured by `cargo xtask bench`, at full size
//! and in processor time.

#![allow(missing_docs, reason = "criterion's macros write public functions")]

use std::time::Duration;

use barchan_bakers::Exec;
use barchan_bakers::curvature::{self, CurvatureMethod, CurvatureParams};
use barchan_field::Mesh;
use barchan_field::surfaces::{ParametricSurface, Pattern, Tessellation};
use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};

const USUAL: u32 = 100_000;

fn torus(vertices: u32, pattern: Pattern) -> Mesh {
    let surface = ParametricSurface::Torus { major: 1.0, minor: 0.4 };
    surface.tessellate(&Tessellation { vertices, pattern, seed: 1, uv_seam: false }).expect("in range").mesh
}

fn bake(group: &mut BenchmarkGroup<'_, WallTime>, varied: &str, mesh: &Mesh, threads: usize) {
    let exec = Exec::new(threads).expect("threads");
    group.throughput(Throughput::Elements(mesh.positions().len() as u64));
    for method in CurvatureMethod::ALL {
        let params = CurvatureParams { method, ..CurvatureParams::default() };
        group.bench_with_input(BenchmarkId::new(method.name(), varied), &params, |bencher, params| {
            bencher.iter(|| curvature::bake(mesh, params, &exec));
        });
    }
}

fn group<'a>(criterion: &'a mut Criterion, varied: &str) -> BenchmarkGroup<'a, WallTime> {
    let mut group = criterion.benchmark_group(varied);
    group.sample_size(10).warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(2));
    group
}

fn patterns(criterion: &mut Criterion) {
    let mut group = group(criterion, "pattern");
    let patterns = [
        ("regular", Pattern::Regular { aspect: 1.0 }),
        ("jittered", Pattern::Jittered),
        ("random", Pattern::Random),
        ("long_thin", Pattern::LongThin { aspect: 20.0 }),
    ];
    for (name, pattern) in patterns {
        bake(&mut group, name, &torus(USUAL, pattern), 1);
    }
}

fn sizes(criterion: &mut Criterion) {
    let mut group = group(criterion, "size");
    for vertices in [10_000, 30_000] {
        bake(&mut group, &vertices.to_string(), &torus(vertices, Pattern::Jittered), 1);
    }
}

fn threads(criterion: &mut Criterion) {
    let mut group = group(criterion, "threads");
    let mesh = torus(USUAL, Pattern::Jittered);
    for threads in [1, 2] {
        bake(&mut group, &threads.to_string(), &mesh, threads);
    }
}

criterion_group!(benches, patterns, sizes, threads);
criterion_main!(benches);
