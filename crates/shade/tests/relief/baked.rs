//! Baked and encoded tables, and a million random rays: a conservative start and free space never pass a first hit.

use barchan_asset::{
    Azimuths, ConeMapTable, ConeMapView, DepthMode, Encoding, HemisphereDirections, HemisphereTable, HemisphereView,
    MaximumMipTable, MaximumMipView, RingSpacing, TableGrid, TextureTable,
};
use barchan_bakers::Exec;
use barchan_bakers::cone::{self, ConeKind, ConeMap};
use barchan_bakers::hemisphere::{self, HemisphereMap, HemisphereParams};
use barchan_bakers::maximum_mip::{self, MaximumMip};
use barchan_field::{Edge, HeightField};
use barchan_shade::{
    ConeSteps, DepthMapStart, MaximumMipTraversal, Relief, ReliefRay, ReliefSearch, Start, Surface, TracedRelief,
};

use crate::common::table_grid;
use crate::support::{noise, rays, reliefs, surface, towards};

/// Texels along each side: odd, so that nothing is halved evenly.
const SIZE: u32 = 33;
const THICKNESS: f32 = 7.0;
const MAX_POLAR: f64 = 80.0;
/// Of 5 reliefs × 2 edges × 4 encodings × 5 sizes of map: a million.
const RAYS: u32 = 5000;
const MAPS: [(u32, u32); 5] = [(33, 33), (32, 16), (16, 16), (7, 5), (1, 1)];

fn hemisphere_map(
    field: &HeightField,
    mode: DepthMode,
    (rings, azimuths): (u32, u32),
    (width, height): (u32, u32),
) -> HemisphereMap {
    let directions = HemisphereDirections {
        rings,
        azimuths: Azimuths::full_circle(azimuths),
        spacing: if width % 2 == 0 { RingSpacing::EqualAngles } else { RingSpacing::SquaredTangents },
        max_polar_radians: MAX_POLAR.to_radians(),
    };
    hemisphere::bake(field, &HemisphereParams { directions, width, height, mode }, &Exec::new(1).unwrap()).unwrap()
}

fn depths(field: &HeightField, map: &HemisphereMap, encoding: Encoding) -> TextureTable {
    let HemisphereParams { directions, width, height, mode } = map.params;
    let size = f64::from(SIZE);
    let (spacing_u, spacing_v) = (size / f64::from(width), size / f64::from(height));
    let grid = TableGrid { width, height, spacing_u, spacing_v, ..table_grid(field.grid()) };
    HemisphereTable { grid, directions, mode, relief: map.relief, values: &map.depths }.encode(encoding).unwrap()
}

fn cones(map: &ConeMap, encoding: Encoding) -> TextureTable {
    ConeMapTable { grid: table_grid(&map.grid), relief: map.relief, values: &map.values }.encode(encoding).unwrap()
}

fn mips(mip: &MaximumMip, encoding: Encoding) -> TextureTable {
    let levels: Vec<&[f32]> = mip.levels.iter().map(|level| level.values.as_slice()).collect();
    MaximumMipTable { grid: table_grid(&mip.grid), levels: &levels }.encode(encoding).unwrap()
}

/// A ray from anywhere in and around the tile, up to a little beyond the rings that are baked.
fn random_ray(relief: &Relief<'_>, seed: u32, index: u32) -> ReliefRay {
    let random = |what| f64::from(noise(seed, index, what));
    let place = |what| (1.5 * random(what) - 0.25) * f64::from(SIZE);
    // Every eighth ray on a texel border, every eighth along an axis.
    let (x, y) = if index.is_multiple_of(8) { (place(0).round(), place(1)) } else { (place(0), place(1)) };
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
        let exec = Exec::new(1).unwrap();
        let (cone_map, mip) =
            (cone::bake(&field, ConeKind::Strict, &exec).unwrap(), maximum_mip::bake(&field, &exec).unwrap());
        for (seed, size) in (0..).zip(MAPS) {
            let map = hemisphere_map(&field, DepthMode::Conservative, (5, 6), size);
            for encoding in Encoding::ALL {
                let (depths, cones, mips) =
                    (depths(&field, &map, encoding), cones(&cone_map, encoding), mips(&mip, encoding));
                let depths = HemisphereView::new(*depths.descriptor(), depths.payload()).unwrap();
                let cones = ConeMapView::new(*cones.descriptor(), cones.payload()).unwrap();
                let mips = MaximumMipView::new(*mips.descriptor(), mips.payload()).unwrap();
                let searches: [&dyn ReliefSearch; 2] =
                    [&ConeSteps::new(&relief, &cones).unwrap(), &MaximumMipTraversal::new(&relief, &mips).unwrap()];
                let start = DepthMapStart::new(&relief, &depths).unwrap();
                let found = faults(&surface, &start, &searches, seed);
                let name = format!("{name}, {edge:?}, {size:?}, {}", encoding.name());
                assert_eq!(found, (0, 0), "overshoots and wrong hits on {name}");
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

/// Fetches and too deep hits of maximum mips, from the top and from a depth map, of rays at a polar angle.
fn with_and_without(kind: usize, mode: DepthMode, polar: f64) -> ([u32; 2], u32) {
    let (_, field) = reliefs(SIZE, THICKNESS, Edge::Wrap).into_iter().nth(kind).unwrap();
    let surface = surface(&field);
    let relief = Relief::new(&surface);
    let mips = mips(&maximum_mip::bake(&field, &Exec::new(1).unwrap()).unwrap(), Encoding::Compact);
    let mips = MaximumMipView::new(*mips.descriptor(), mips.payload()).unwrap();
    let search = MaximumMipTraversal::new(&relief, &mips).unwrap();
    let table = depths(&field, &hemisphere_map(&field, mode, (16, 16), (16, 16)), Encoding::Compact);
    let table = HemisphereView::new(*table.descriptor(), table.payload()).unwrap();
    let start = DepthMapStart::new(&relief, &table).unwrap();
    let (mut fetches, mut too_deep) = ([0, 0], 0);
    for ray in rays(&relief, polar, RAYS) {
        let (top, started) = (search.find(&ray, Start::TOP), search.find(&ray, start.start(&ray)));
        fetches = [fetches[0] + top.fetches.total(), fetches[1] + started.fetches.total()];
        too_deep += u32::from(started.depth > top.depth + 1e-3);
    }
    (fetches, too_deep)
}

#[test]
fn a_conservative_start_saves_fetches_on_smooth_relief() {
    let ([from_top, from_start], too_deep) = with_and_without(3, DepthMode::Conservative, 35.0);
    assert!(from_start < from_top, "{from_start} fetches instead of {from_top}");
    assert_eq!(too_deep, 0);
}

#[test]
fn a_start_at_the_nearest_direction_saves_fetches_and_loses_hits() {
    let ([from_top, from_start], too_deep) = with_and_without(1, DepthMode::Nearest, 60.0);
    assert!(from_start < from_top, "{from_start} fetches instead of {from_top}");
    assert!(too_deep > 0);
}
