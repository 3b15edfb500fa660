//! Rays against relief: nanoseconds per ray of every search, from the top and from a conservative depth map, by angle.
//!
//! `cargo bench -p barchan-shade --bench relief`

#![allow(missing_docs, reason = "criterion's macros write public functions")]

use std::hint::black_box;

use barchan_asset::{
    Azimuths, ConeMapTable, ConeMapView, DepthMode, Encoding, HeightTable, HeightView, HemisphereDirections,
    HemisphereTable, HemisphereView, LengthUnit, MaximumMipTable, MaximumMipView, RelaxedConeMapTable,
    RelaxedConeMapView, RingSpacing, TableGrid, TextureTable, Wrap,
};
use barchan_bakers::cone::{self, ConeKind};
use barchan_bakers::hemisphere::{self, HemisphereParams};
use barchan_bakers::{Exec, maximum_mip};
use barchan_field::{Edge, Grid, HeightField, Spacing};
use barchan_shade::{
    ConeSteps, DepthMapStart, LinearSearch, MaximumMipTraversal, ParallaxOcclusion, RelaxedConeSteps, Relief,
    ReliefRay, ReliefSearch, Start, Surface, TracedRelief,
};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use glam::DVec3;

const SIZE: u32 = 128;
const MAP: u32 = 32;
const RAYS: u32 = 4096;
const GRID: TableGrid = TableGrid {
    width: SIZE,
    height: SIZE,
    spacing_u: 1.0,
    spacing_v: 1.0,
    length_unit: LengthUnit::Metre,
    wrap_u: Wrap::Repeat,
    wrap_v: Wrap::Repeat,
};

/// Reproducible numbers in [0, 1).
fn random(index: u32) -> f32 {
    let hash = (index ^ 0x9E37_79B9).wrapping_mul(0x85EB_CA6B);
    let hash = (hash ^ (hash >> 13)).wrapping_mul(0xC2B2_AE35);
    ((hash ^ (hash >> 16)) >> 8) as f32 / (1 << 24) as f32
}

/// Bumps and grit, about 0.15 of a tile deep.
fn field() -> HeightField {
    let wave = |index: u32, turns: u32| (index as f32 * turns as f32 * std::f32::consts::TAU / SIZE as f32).sin();
    let height = |texel: u32| {
        let (u, v) = (texel % SIZE, texel / SIZE);
        4.5 * wave(u, 3) * wave(v + u, 2) + 3.0 * wave(2 * u + v, 7) + 2.0 * random(texel)
    };
    let unit = barchan_field::LengthUnit::Metre;
    let spacing = Spacing::new(1.0, 1.0).expect("texels of one metre");
    let grid = Grid { width: SIZE, height: SIZE, spacing, unit, edge: Edge::Wrap };
    HeightField::new(grid, (0..SIZE * SIZE).map(height).collect()).expect("finite heights")
}

/// Encoded as an asset would hold them.
struct Tables {
    heights: TextureTable,
    cones: TextureTable,
    relaxed_cones: TextureTable,
    mips: TextureTable,
    depths: TextureTable,
}

fn tables() -> Tables {
    const FITS: &str = "values within bounds";
    let (field, exec) = (field(), Exec::new(2).expect("two threads"));
    let cones = cone::bake(&field, ConeKind::Strict, &exec).expect(FITS);
    let relaxed = cone::bake(&field, ConeKind::Relaxed, &exec).expect(FITS);
    let mip = maximum_mip::bake(&field, &exec).expect(FITS);
    let levels: Vec<&[f32]> = mip.levels.iter().map(|level| level.values.as_slice()).collect();
    let directions = HemisphereDirections {
        rings: 32,
        azimuths: Azimuths::full_circle(16),
        spacing: RingSpacing::SquaredTangents,
        max_polar_radians: 80_f64.to_radians(),
    };
    let mode = DepthMode::Conservative;
    let params = HemisphereParams { directions, width: MAP, height: MAP, mode };
    let depths = hemisphere::bake(&field, &params, &exec).expect(FITS);
    let spacing = f64::from(SIZE / MAP);
    let map_grid = TableGrid { width: MAP, height: MAP, spacing_u: spacing, spacing_v: spacing, ..GRID };
    let depths = HemisphereTable { grid: map_grid, directions, mode, relief: depths.relief, values: &depths.depths };
    let heights = HeightTable { grid: GRID, values: field.samples() };
    let relaxed = RelaxedConeMapTable { grid: GRID, relief: relaxed.relief, values: &relaxed.values };
    let cones = ConeMapTable { grid: GRID, relief: cones.relief, values: &cones.values };
    Tables {
        heights: heights.encode(Encoding::F32).expect(FITS),
        cones: cones.encode(Encoding::Compact).expect(FITS),
        relaxed_cones: relaxed.encode(Encoding::Compact).expect(FITS),
        mips: MaximumMipTable { grid: GRID, levels: &levels }.encode(Encoding::Compact).expect(FITS),
        depths: depths.encode(Encoding::Compact).expect(FITS),
    }
}

fn rays(relief: &Relief<'_>, polar: f64) -> Vec<ReliefRay> {
    let (sin, cos) = polar.to_radians().sin_cos();
    let ray = |index| {
        let [x, y, turn] = [0, 1, 2].map(|what| f64::from(random(3 * index + what)));
        let (up, right) = (std::f64::consts::TAU * turn).sin_cos();
        let size = f64::from(SIZE);
        relief.ray(size * x, size * y, DVec3::new(sin * right, sin * up, cos)).expect("a ray that goes down")
    };
    (0..RAYS).map(ray).collect()
}

fn relief(criterion: &mut Criterion) {
    const KIND: &str = "a table of its kind, of these heights";
    let tables = tables();
    let surface = Surface::new(&HeightView::new(*tables.heights.descriptor(), tables.heights.payload()).expect(KIND));
    let relief = Relief::new(&surface);
    let cones = ConeMapView::new(*tables.cones.descriptor(), tables.cones.payload()).expect(KIND);
    let relaxed =
        RelaxedConeMapView::new(*tables.relaxed_cones.descriptor(), tables.relaxed_cones.payload()).expect(KIND);
    let mips = MaximumMipView::new(*tables.mips.descriptor(), tables.mips.payload()).expect(KIND);
    let depths = HemisphereView::new(*tables.depths.descriptor(), tables.depths.payload()).expect(KIND);
    let start = DepthMapStart::new(&relief, &depths).expect(KIND);
    let searches: [&dyn ReliefSearch; 6] = [
        &LinearSearch::new(&relief, 64, 12),
        &ParallaxOcclusion::new(&relief, 64),
        &ConeSteps::new(&relief, &cones).expect(KIND),
        &RelaxedConeSteps::new(&relief, &relaxed, 10).expect(KIND),
        &MaximumMipTraversal::new(&relief, &mips).expect(KIND),
        &TracedRelief::new(&relief),
    ];
    for polar in [10.0, 35.0, 60.0, 75.0] {
        let rays = rays(&relief, polar);
        let mut group = criterion.benchmark_group(format!("relief/{polar}"));
        group.throughput(Throughput::Elements(u64::from(RAYS)));
        for search in searches {
            let all = |from: &dyn Fn(&ReliefRay) -> Start| {
                black_box(&rays).iter().map(|ray| search.find(ray, from(ray)).depth).sum::<f64>()
            };
            group.bench_function(format!("{}/top", search.name()), |bencher| {
                bencher.iter(|| all(&|_| Start::TOP));
            });
            group.bench_function(format!("{}/depth map", search.name()), |bencher| {
                bencher.iter(|| all(&|ray| start.start(ray)));
            });
        }
        group.finish();
    }
}

criterion_group!(benches, relief);
criterion_main!(benches);
