//! No ray starts behind the surface: a million rays against the exact first hit, in every map size and encoding.

use std::f64::consts::TAU;

use barchan_asset::{
    Azimuths, DepthMode, Encoding, HemisphereDirections, HemisphereTable, HemisphereView, LengthUnit, RingSpacing,
    TableGrid, Wrap,
};
use barchan_bakers::hemisphere::reference::first_hit;
use barchan_bakers::hemisphere::{HemisphereMap, HemisphereParams};
use barchan_field::{Edge, Grid, HeightField};
use glam::DVec3;

use crate::support::{bake, field, fill, grid, noise};

const SIZE: u32 = 80;
const MAP_SIZES: [u32; 5] = [8, 13, 32, 64, SIZE];
const ENCODINGS: [Encoding; 3] = [Encoding::F32, Encoding::F16, Encoding::U8];

/// Of each relief: four of them make a million.
const RAYS: u32 = 260_000;

/// By how much a look-up is off in a texel, a ring and an azimuth: half of what is promised.
const OFF: f64 = 1.0 / (1 << 11) as f64;

/// The depths of a table as they are read back from its bytes.
struct Table {
    size: u32,
    depths: Vec<f32>,
}

/// A ray by the place where it enters, the tangent of its polar angle and its azimuth.
struct Ray {
    place: (f64, f64),
    tangent: f64,
    azimuth: f64,
}

/// Numbers that look random, the same in every run.
struct Dice(u64);

impl Dice {
    /// In [0, 1).
    fn part(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn below(&mut self, count: u32) -> u32 {
        (self.part() * f64::from(count)) as u32
    }

    /// −[`OFF`], 0 or [`OFF`].
    fn off(&mut self) -> f64 {
        OFF * (f64::from(self.below(3)) - 1.0)
    }
}

fn squared_tangents(rings: u32, azimuths: Azimuths) -> HemisphereDirections {
    HemisphereDirections {
        rings,
        azimuths,
        spacing: RingSpacing::SquaredTangents,
        max_polar_radians: 80_f64.to_radians(),
    }
}

fn tables(field: &HeightField, directions: HemisphereDirections) -> Vec<Table> {
    let sizes = MAP_SIZES.into_iter().map(|size| {
        let params = HemisphereParams { directions, width: size, height: size, mode: DepthMode::Conservative };
        bake(field, &params)
    });
    sizes.flat_map(|map| ENCODINGS.map(|encoding| read_back(&map, encoding))).collect()
}

fn read_back(map: &HemisphereMap, encoding: Encoding) -> Table {
    let HemisphereParams { directions, width, height, mode } = map.params;
    // Where texels lie does not change what they hold.
    let (length_unit, wrap) = (LengthUnit::SceneUnit, Wrap::Repeat);
    let grid = TableGrid { width, height, spacing_u: 1.0, spacing_v: 1.0, length_unit, wrap_u: wrap, wrap_v: wrap };
    let table = HemisphereTable { grid, directions, mode, relief: map.relief, values: &map.depths };
    let table = table.encode(encoding).unwrap();
    let view = HemisphereView::new(*table.descriptor(), table.payload()).unwrap();
    let places = (0..directions.layers()).flat_map(|layer| (0..height).map(move |row| (layer, row)));
    let places = places.flat_map(|(layer, row)| (0..width).map(move |column| (layer, column, row)));
    Table { size: width, depths: places.map(|(layer, column, row)| view.depth(layer, column, row)).collect() }
}

/// Every fourth number is on a border, exactly.
fn on_borders(dice: &mut Dice, cells: u32) -> f64 {
    let place = dice.part() * f64::from(cells);
    if dice.below(4) == 0 { place.round() } else { place }
}

fn ray(dice: &mut Dice, grid: &Grid, directions: &HemisphereDirections) -> Ray {
    let texels = MAP_SIZES[dice.below(5) as usize];
    let mut along = |size: u32| on_borders(dice, texels) / f64::from(texels) * f64::from(size) - 0.5;
    let place = (along(grid.width), along(grid.height));
    let ring = on_borders(dice, directions.rings).min(f64::from(directions.rings) - 1e-9);
    let (inner, outer) = (directions.tangent_of_edge(ring as u32), directions.tangent_of_edge(ring as u32 + 1));
    let step = directions.azimuths.step_radians();
    let azimuth = directions.azimuths.first_radians() + (on_borders(dice, directions.azimuths.count()) - 0.5) * step;
    Ray { place, tangent: inner + ring.fract() * (outer - inner), azimuth }
}

/// The layer of a ray, looked up a little off; none where there is no such direction.
fn layer(dice: &mut Dice, directions: &HemisphereDirections, ray: &Ray) -> Option<u32> {
    let ring = directions.ring_of_tangent(ray.tangent)?;
    let width = directions.tangent_of_edge(ring + 1) - directions.tangent_of_edge(ring);
    let ring = directions.ring_of_tangent((ray.tangent + dice.off() * width).max(0.0))?;
    let azimuth = directions.azimuth_cell(ray.azimuth + dice.off() * directions.azimuths.step_radians())?;
    Some(directions.layer(ring, azimuth))
}

/// Where a table says to start, looked up a little off.
fn start(dice: &mut Dice, table: &Table, grid: &Grid, layer: u32, place: (f64, f64)) -> f32 {
    let mut texel = |place: f64, size: u32| {
        let texel = ((place + 0.5) / f64::from(size) * f64::from(table.size) + dice.off()).floor() as i64;
        grid.edge.resolve(texel, table.size)
    };
    let (column, row) = (texel(place.0, grid.width), texel(place.1, grid.height));
    let size = table.size as usize;
    table.depths[(layer as usize * size + row) * size + column]
}

#[track_caller]
fn assert_no_overshoots(field: &HeightField, directions: HemisphereDirections) {
    let (tables, grid, mut dice) = (tables(field, directions), field.grid(), Dice(0x9E37_79B9_7F4A_7C15));
    let (mut deepest, mut rays) = (0.0_f32, 0);
    while rays < RAYS {
        let ray = ray(&mut dice, grid, &directions);
        let Some(layer) = layer(&mut dice, &directions, &ray) else { continue };
        rays += 1;
        let (sin, cos) = ray.azimuth.sin_cos();
        let towards = DVec3::new(ray.tangent * cos, ray.tangent * sin, 1.0);
        let hit = first_hit(field, ray.place.0, ray.place.1, towards);
        for table in &tables {
            let start = start(&mut dice, table, grid, layer, ray.place);
            deepest = deepest.max(start);
            assert!(f64::from(start) <= hit, "size {}: start {start} behind the hit at {hit}", table.size);
        }
    }
    assert!(deepest > 0.7, "no start is deeper than {deepest}: the relief is no test");
}

#[test]
fn of_spikes() {
    let spikes = field((SIZE, SIZE), Edge::Wrap, |column, row| {
        let is_spike = noise(1, column, row) < 0.01;
        if is_spike { 12.0 * noise(2, column, row) } else { 0.5 * noise(3, column, row) }
    });
    assert_no_overshoots(&spikes, squared_tangents(8, Azimuths::full_circle(12)));
}

#[test]
fn of_walls() {
    let walls = field((SIZE, SIZE), Edge::Clamp, |column, row| {
        let is_wall = column % 27 == 4 || row % 31 == 20 || (column + 2 * row) % 60 == 7;
        if is_wall { 10.0 } else { 0.0 }
    });
    assert_no_overshoots(&walls, squared_tangents(6, Azimuths::full_circle(7)));
}

#[test]
fn of_white_noise_with_oblong_texels() {
    let texels = grid((SIZE, SIZE), (0.6, 1.7), Edge::Wrap);
    let white = fill(texels, |column, row| 8.0 * noise(4, column, row).powi(3));
    let equal_angles =
        HemisphereDirections { spacing: RingSpacing::EqualAngles, ..squared_tangents(10, Azimuths::arc(-0.5, 3.0, 9)) };
    assert_no_overshoots(&white, equal_angles);
}

#[test]
fn of_smooth_relief() {
    let texels = grid((SIZE, SIZE), (1.0, 1.0), Edge::Clamp);
    let smooth = fill(texels, |column, row| {
        let angle = |texel: u32, waves: f64| (TAU * waves * f64::from(texel) / f64::from(SIZE)).sin();
        (6.0 * angle(column, 2.0) * angle(row, 3.0) + 3.0 * angle(column + 2 * row, 1.0)) as f32
    });
    assert_no_overshoots(&smooth, squared_tangents(12, Azimuths::full_circle(5)));
}
