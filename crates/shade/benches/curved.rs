//! Curved surfaces: nanoseconds per curvature along the light, per shadow test by each method, and per traced ray.
//!
//! `cargo bench -p barchan-shade`

#![allow(missing_docs, reason = "criterion's macros write public functions")]

use std::hint::black_box;

use barchan_asset::{
    Azimuths, CurvatureSweep, DistanceTable, DistanceView, Encoding, HeightTable, HeightView, HorizonTable,
    HorizonView, LengthUnit, SweptDistanceTable, SweptDistanceView, SweptHorizonTable, SweptHorizonView, TableGrid,
    Wrap,
};
use barchan_shade::{
    BaseSurface, CurvedMethod, CurvedShadow, DisplacedShadow, Place, PrincipalUv, Sphere, SphereChart, Surface,
};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use glam::{DVec2, DVec3};

const SIZE: u32 = 128;
const DIRECTIONS: u32 = 16;
const PLACES: u32 = 4096;
const SWEEP: CurvatureSweep = CurvatureSweep { candidates: 2, curvature_min: 0.0, curvature_max: 0.015 };
const GRID: TableGrid = TableGrid {
    width: SIZE,
    height: SIZE,
    spacing_u: 1.0,
    spacing_v: 1.0,
    length_unit: LengthUnit::SceneUnit,
    wrap_u: Wrap::Repeat,
    wrap_v: Wrap::Repeat,
};
const RADIUS: f64 = 64.0;

/// Reproducible numbers in [0, 1).
fn random(index: u32) -> f32 {
    let hash = (index ^ 0x9E37_79B9).wrapping_mul(0x85EB_CA6B);
    let hash = (hash ^ (hash >> 13)).wrapping_mul(0xC2B2_AE35);
    ((hash ^ (hash >> 16)) >> 8) as f32 / (1 << 24) as f32
}

/// Gentle bumps.
fn heights() -> Vec<f32> {
    let wave = |index: u32| (index as f32 * 0.39).sin();
    (0..SIZE * SIZE).map(|texel| 2.0 + 2.0 * wave(texel % SIZE) * wave(texel / SIZE)).collect()
}

/// Tables of made-up points: what they cost does not depend on what they say.
fn shadow() -> CurvedShadow {
    let azimuths = Azimuths::full_circle(DIRECTIONS);
    let values = |layers: u32, of: &dyn Fn(f32) -> f32| -> Vec<f32> {
        (0..layers * DIRECTIONS * SIZE * SIZE).map(|index| of(random(index))).collect()
    };
    let elevations = values(3, &|random| random);
    let distances = values(3, &|random| 40.0 * random);
    let one = (DIRECTIONS * SIZE * SIZE) as usize;
    let ((flat, swept), (flat_distance, swept_distance)) = (elevations.split_at(one), distances.split_at(one));
    let horizon = HorizonTable { grid: GRID, azimuths, radius: RADIUS, values: flat };
    let distance = DistanceTable { grid: GRID, azimuths, radius: RADIUS, values: flat_distance };
    let swept = SweptHorizonTable { grid: GRID, azimuths, radius: RADIUS, sweep: SWEEP, values: swept };
    let swept_distance =
        SweptDistanceTable { grid: GRID, azimuths, radius: RADIUS, sweep: SWEEP, values: swept_distance };
    let encoded = "values within bounds";
    let horizon = horizon.encode(Encoding::F32).expect(encoded);
    let distance = distance.encode(Encoding::F32).expect(encoded);
    let swept = swept.encode(Encoding::F32).expect(encoded);
    let swept_distance = swept_distance.encode(Encoding::F32).expect(encoded);
    let heights = HeightTable { grid: GRID, values: &heights() }.encode(Encoding::F32).expect(encoded);
    let swept = SweptHorizonView::new(*swept.descriptor(), swept.payload()).expect(encoded);
    let swept_distance = SweptDistanceView::new(*swept_distance.descriptor(), swept_distance.payload()).expect(encoded);
    CurvedShadow::new(
        &HorizonView::new(*horizon.descriptor(), horizon.payload()).expect(encoded),
        &DistanceView::new(*distance.descriptor(), distance.payload()).expect(encoded),
        Some((&swept, &swept_distance)),
        &HeightView::new(*heights.descriptor(), heights.payload()).expect(encoded),
    )
    .expect("tables of one map")
}

fn relief() -> Surface {
    let table = HeightTable { grid: GRID, values: &heights() }.encode(Encoding::F32).expect("finite heights");
    Surface::new(&HeightView::new(*table.descriptor(), table.payload()).expect("a height table"))
}

fn curved(criterion: &mut Criterion) {
    let base = Sphere { radius: 66.7, hollow: false, chart: SphereChart::Stereographic, tile: DVec2::splat(128.0) };
    let (shadow, relief) = (shadow(), relief());
    let towards = DVec3::new(0.3, 0.9, 0.2).normalize();
    let uvs: Vec<DVec2> =
        (0..PLACES).map(|k| DVec2::new(random(2 * k).into(), random(2 * k + 1).into()) - 0.5).collect();
    let places: Vec<Place> = uvs.iter().map(|&uv| Place::new(&base, &relief, uv, towards)).collect();
    let mut group = criterion.benchmark_group("curved");
    group.throughput(Throughput::Elements(u64::from(PLACES)));

    let forms: Vec<_> = places.iter().map(|place| (place.forms, place.light.direction)).collect();
    group.bench_function("curvature/forms", |bencher| {
        bencher.iter(|| black_box(&forms).iter().map(|(at, along)| at.along(along.x, along.y)).sum::<f64>());
    });
    let principal = PrincipalUv { curvatures: [0.02, 0.01], directions: [DVec2::new(0.8, 0.1), DVec2::new(-0.3, 1.1)] };
    let principals: Vec<_> = places.iter().map(|place| (principal, place.light.direction)).collect();
    group.bench_function("curvature/euler-solved", |bencher| {
        bencher.iter(|| black_box(&principals).iter().map(|(at, along)| at.euler_solved(*along)).sum::<f64>());
    });
    group.bench_function("curvature/euler-as-printed", |bencher| {
        bencher.iter(|| black_box(&principals).iter().map(|(at, along)| at.euler_as_printed(*along)).sum::<f64>());
    });
    for method in CurvedMethod::ALL {
        group.bench_function(format!("shadow/{method}"), |bencher| {
            let in_shadow = |place: &&Place| shadow.in_shadow(method, place.texel, &place.light, place.curvature());
            bencher.iter(|| black_box(&places).iter().filter(in_shadow).count());
        });
    }
    let oracle = DisplacedShadow::new(&base as &dyn BaseSurface, &relief, f64::INFINITY);
    group.bench_function("traced", |bencher| {
        bencher.iter(|| black_box(&uvs).iter().filter(|&&uv| oracle.in_shadow(uv, towards)).count());
    });
    group.finish();
}

criterion_group!(benches, curved);
criterion_main!(benches);
