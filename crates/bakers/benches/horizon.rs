//! The sweep's cost per texel and direction, which should not grow with the field, beside the reference's, which does.

#![allow(missing_docs, reason = "criterion's macros write public functions")]

use barchan_bakers::Exec;
use barchan_bakers::horizon::{self, Azimuths, HorizonParams, Method, reference};
use barchan_field::{Edge, Grid, HeightField, LengthUnit, Shape, Spacing};
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};

const DIRECTIONS: u32 = 16;

fn shape(name: &str) -> Shape {
    Shape::examples().into_iter().find(|shape| shape.name() == name).expect("an example of every shape")
}

/// The examples are meant for tiles of 256 length units, at any resolution.
fn field(shape: Shape, size: u32) -> HeightField {
    let spacing = Spacing::square(256.0 / f64::from(size)).expect("a length");
    let grid = Grid { width: size, height: size, spacing, unit: LengthUnit::SceneUnit, edge: Edge::Wrap };
    shape.rasterize(grid).expect("examples fit")
}

fn horizons(criterion: &mut Criterion) {
    let exec = Exec::new(1).expect("one thread");
    for name in ["fractal_terrain", "dunes"] {
        let mut group = criterion.benchmark_group(name);
        group.sample_size(10);
        for (baker, sizes) in [("sweep", &[128, 256, 512][..]), ("reference", &[64, 128][..])] {
            for &size in sizes {
                let field = field(shape(name), size);
                let radius = HorizonParams::default_radius(field.grid());
                let params = HorizonParams {
                    azimuths: Azimuths::full_circle(DIRECTIONS),
                    radius,
                    distance: true,
                    method: Method::default(),
                };
                group.throughput(Throughput::Elements(u64::from(size * size * DIRECTIONS)));
                group.bench_with_input(BenchmarkId::new(baker, size), &field, |bencher, field| {
                    bencher.iter(|| match baker {
                        "sweep" => horizon::bake(field, &params, &exec),
                        _ => reference::bake(field, &params, &exec),
                    });
                });
            }
        }
        group.finish();
    }
}

criterion_group!(benches, horizons);
criterion_main!(benches);
