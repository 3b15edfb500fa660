//! Encoding a layer: values per second, to be held against a bake of 60 million per second and core.
//!
//! `cargo bench -p barchan-asset --features write`

#![allow(missing_docs, reason = "criterion's macros write public functions")]

use std::hint::black_box;

use barchan_asset::{Azimuths, Encoding, LengthUnit, TableEncoder, TableFacts, TableGrid, Wrap};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

const SIZE: u32 = 512;

fn encode(criterion: &mut Criterion) {
    let (length_unit, wrap) = (LengthUnit::Metre, Wrap::Clamp);
    let grid = TableGrid {
        width: SIZE,
        height: SIZE,
        spacing_u: 1.0,
        spacing_v: 1.0,
        length_unit,
        wrap_u: wrap,
        wrap_v: wrap,
    };
    let azimuths = Azimuths::full_circle(1);
    let values: Vec<f32> = (0..SIZE * SIZE).map(|i| (i * 7919 % 10_007) as f32 / 10_007.0).collect();
    let mut bytes = Vec::with_capacity(4 * values.len());
    let mut group = criterion.benchmark_group("encode");
    group.throughput(Throughput::Elements(values.len() as u64));
    for (name, facts) in [
        ("horizon", TableFacts::horizon(grid, azimuths, 10.0)),
        ("distance", TableFacts::distance(grid, azimuths, 10.0)),
    ] {
        for encoding in Encoding::ALL {
            let encoder = TableEncoder::new(&facts, encoding, 0.0..=1.5).expect("legal facts and bounds");
            group.bench_function(format!("{name}/{}", encoding.name()), |bencher| {
                bencher.iter(|| {
                    bytes.clear();
                    black_box(encoder.encode(black_box(&values), &mut bytes).expect("values within bounds"))
                });
            });
        }
    }
    group.finish();
}

criterion_group!(benches, encode);
criterion_main!(benches);
