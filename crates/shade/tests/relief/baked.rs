//! Baked and encoded tables, and a million random rays: a conservative start and free space never pass a first hit.

use barchan_asset::{
    Azimuths, ConeMapTable, ConeMapView, DepthMode, Encoding, HemisphereDirections, HemisphereTable, HemisphereView,
    MaximumMipTable, MaximumMipView, RingSpacing, TableGrid, TextureTable,
};
use barchan_bakers::cone::{self, ConeKind};
use barchan_bakers::hemisphere::{self, HemisphereParams};
use barchan_bakers::{Exec, maximum_mip};
use barchan_field::{Edge, HeightField};
use barchan_shade::{
    ConeSteps, DepthMapStart, MaximumMipTraversal, Relief, ReliefRay, ReliefSearch, Start, Surface, TracedRelief,
};

use crate::common::table_grid;
use crate::support::{noise, reliefs, surface, towards};

/// Texels along each side: odd, so that nothing is halved evenly.
const SIZE: u32 = 33;
const THICKNESS: f32 = 7.0;
const MAX_POLAR: f64 = 80.0;
/// Of 5 reliefs × 2 edges × 4 encodings × 5 sizes of map: a million.
const RAYS: u32 = 5000;
const MAPS: [(u32, u32); 5] = [(33, 33), (32, 16), (16, 16), (7, 5), (1, 1)];

fn depths(field: &HeightField, mode: DepthMode, (width, height): (u32, u32), encoding: Encoding) -> TextureTable {
    let directions = HemisphereDirections {
        rings: 5,
        azimuths: Azimuths::full_circle(6),
        spacing: if width % 2 == 0 { RingSpacing::EqualAngles } else { RingSpacing::SquaredTangents },
        max_polar_radians: MAX_POLAR.to_radians(),
    };
    let params = HemisphereParams { directions, width, height, mode };
    let map = hemisphere::bake(field, &params, &Exec::new(1).unwrap()).unwrap();
    let size = f64::from(SIZE);
    let (spacing_u, spacing_v) = (size / f64::from(width), size / f64::from(height));
    let grid = TableGrid { width, height, spacing_u, spacing_v, ..table_grid(field.grid()) };
    HemisphereTable { grid, directions, mode, relief: map.relief, values: &map.depths }.encode(encoding).unwrap()
}

fn cones(field: &HeightField, encoding: Encoding) -> TextureTable {
    let map = cone::bake(field, ConeKind::Strict, &Exec::new(1).unwrap()).unwrap();
    ConeMapTable { grid: table_grid(field.grid()), relief: map.relief, values: &map.values }.encode(encoding).unwrap()
}

fn mips(field: &HeightField, encoding: Encoding) -> TextureTable {
    let mip = maximum_mip::bake(field, &Exec::new(1).unwrap()).unwrap();
    let levels: Vec<&[f32]> = mip.levels.iter().map(|level| level.values.as_slice()).collect();
    MaximumMipTable { grid: table_grid(field.grid()), levels: &levels }.encode(encoding).unwrap()
}

/// A ray from anywhere in and around the tile, up to a little beyond the rings that are baked.
fn random_ray(relief: &Relief<'_>, seed: u32, index: u32) -> ReliefRay {
    let random = |what| f64::from(noise(seed, index, what));
    let place = |what| (1.5 * random(what) - 0.25) * f64::from(SIZE);
    // Every eighth ray on a texel border, every eighth along an axis.
    let (x, y) = if index % 8 == 0 { (place(0).round(), place(1)) } else { (place(0), place(1)) };
    let azimuth = if index % 8 == 1 { 90.0 * (4.0 * random(2)).floor() } else { 360.0 * random(2) };
    relief.ray(x, y, towards((MAX_POLAR + 1.0) * random(3).sqrt(), azimuth)).unwrap()
}

/// Rays that started behind their first hit, and searches that ended elsewhere.
fn faults(surface: &Surface, start: &DepthMapStart<'_>, searches: &[&dyn ReliefSearch], seed: u32) -> (u32, u32) {
    let relief = Relief::new(surface);
    let traced = TracedRelief::new(&relief);
    let (mut overshoots, mut elsewhere) = (0, 0);
    for index in 0..RAYS {
        let ray = random_ray(&relief, seed, index);
        let (start, truth) = (start.start(&ray), traced.first_hit(&ray, 0.0));
        assert!(start.proven);
        overshoots += u32::from(start.depth > truth);
        let search = searches[index as usize % searches.len()];
        // A ray that grazes the surface within rounding may go either way: none of these does.
        elsewhere += u32::from((search.find(&ray, start).depth - truth).abs() > 1e-9);
    }
    (overshoots, elsewhere)
}

fn never_tunnels(kind: usize) {
    for edge in [Edge::Wrap, Edge::Clamp] {
        let (name, field) = reliefs(SIZE, THICKNESS, edge).into_iter().nth(kind).unwrap();
        let surface = surface(&field);
        let relief = Relief::new(&surface);
        for (seed, map) in MAPS.into_iter().enumerate() {
            for encoding in Encoding::ALL {
                let (depths, cones, mips) = (
                    depths(&field, DepthMode::Conservative, map, encoding),
                    cones(&field, encoding),
                    mips(&field, encoding),
                );
                let depths = HemisphereView::new(*depths.descriptor(), depths.payload()).unwrap();
                let cones = ConeMapView::new(*cones.descriptor(), cones.payload()).unwrap();
                let mips = MaximumMipView::new(*mips.descriptor(), mips.payload()).unwrap();
                let searches: [&dyn ReliefSearch; 2] =
                    [&ConeSteps::new(&relief, &cones).unwrap(), &MaximumMipTraversal::new(&relief, &mips).unwrap()];
                let start = DepthMapStart::new(&relief, &depths).unwrap();
                let found = faults(&surface, &start, &searches, seed as u32);
                assert_eq!(
                    found,
                    (0, 0),
                    "overshoots and wrong hits on {name}, {edge:?}, {map:?}, {}",
                    encoding.name()
                );
            }
        }
    }
}

#[test]
fn no_ray_tunnels_through_noise() {
    never_tunnels(0);
}

#[test]
fn no_ray_tunnels_through_spikes() {
    never_tunnels(1);
}

#[test]
fn no_ray_tunnels_through_walls() {
    never_tunnels(2);
}

#[test]
fn no_ray_tunnels_through_smooth_relief() {
    never_tunnels(3);
}

#[test]
fn no_ray_tunnels_through_terraces() {
    never_tunnels(4);
}

#[test]
fn a_conservative_start_saves_fetches_and_a_nearest_one_can_tunnel() {
    let (_, field) = reliefs(SIZE, THICKNESS, Edge::Wrap).into_iter().next().unwrap();
    let (surface, mips) = (surface(&field), mips(&field, Encoding::Compact));
    let relief = Relief::new(&surface);
    let mips =
        MaximumMipTraversal::new(&relief, &MaximumMipView::new(*mips.descriptor(), mips.payload()).unwrap()).unwrap();
    let table = |mode| depths(&field, mode, (16, 16), Encoding::Compact);
    let (conservative, nearest) = (table(DepthMode::Conservative), table(DepthMode::Nearest));
    let start = |table: &TextureTable, ray: &ReliefRay| {
        let view = HemisphereView::new(*table.descriptor(), table.payload()).unwrap();
        DepthMapStart::new(&relief, &view).unwrap().start(ray)
    };
    let (mut from_top, mut from_start, mut missed) = (0, 0, 0);
    for index in 0..RAYS {
        let ray = random_ray(&relief, 9, index);
        let top = mips.find(&ray, Start::TOP);
        from_top += top.fetches.total();
        from_start += mips.find(&ray, start(&conservative, &ray)).fetches.total();
        missed += u32::from(mips.find(&ray, start(&nearest, &ray)).depth > top.depth + 1e-3);
    }
    assert!(from_start < from_top, "{from_start} fetches instead of {from_top}");
    assert!(missed > 0, "the paper's start is not proven for a reason");
}
