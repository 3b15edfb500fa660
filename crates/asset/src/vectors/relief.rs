//! Vectors of the tables for relief search, beside the heights that they are of. Depths and ratios of hemisphere and
//! cone maps are numbers that are easy to state, not a bake.

use core::f64::consts::{FRAC_PI_3, FRAC_PI_4};
use std::vec;
use std::vec::Vec;

use super::grid;
use crate::{
    AssetWriter, Azimuths, Codec, ConeMapTable, DepthMode, Encoding, HeightTable, HemisphereDirections,
    HemisphereTable, MaximumMipTable, RelaxedConeMapTable, ReliefRange, RingSpacing, TableGrid, Wrap, WriteError,
};

/// The heights of the `relief-…` vectors in metres, five columns and three rows.
pub const RELIEF: [f32; 15] = [
    0.0, 1.0, 2.5, -1.0, 0.25, //
    4.0, 0.5, 0.0, 1.5, 3.0, //
    -0.5, 2.0, 0.75, 1.25, 0.125,
];

/// What their depths measure.
pub const RELIEF_RANGE: ReliefRange = ReliefRange { top: 4.0, thickness: 5.0 };

/// The hemisphere depth of a layer and a column: of six layers and two columns in `relief-…`, of four in `hemisphere-arc`.
#[must_use]
pub fn hemisphere_depth(layer: u32, column: u32) -> f32 {
    layer as f32 / 8.0 + column as f32 / 16.0
}

/// The ratio of a texel of the cone map; the relaxed one has twice that.
#[must_use]
pub fn cone_ratio(column: u32, row: u32) -> f32 {
    ((column + 1) * (row + 1)) as f32 / 8.0
}

/// The greatest heights of [`RELIEF`], which repeats along u and clamps along v: levels of 5 × 3, 2 × 1 and 1 × 1.
#[must_use]
pub fn maxima() -> [Vec<f32>; 3] {
    let at = |column: usize, row: usize| RELIEF[row.min(2) * 5 + column % 5];
    let corners = |column, row| [at(column, row), at(column + 1, row), at(column, row + 1), at(column + 1, row + 1)];
    let greatest = |heights: &[f32]| heights.iter().copied().fold(f32::NEG_INFINITY, f32::max);
    let cells: Vec<f32> = (0..15).map(|i| greatest(&corners(i % 5, i / 5))).collect();
    let columns = |range: core::ops::Range<usize>| -> Vec<f32> {
        (0..15).filter(|i| range.contains(&(i % 5))).map(|i| cells[i]).collect()
    };
    // The second of two columns stands for three, the one row for all.
    let halves = vec![greatest(&columns(0..2)), greatest(&columns(2..5))];
    let all = vec![greatest(&cells)];
    [cells, halves, all]
}

/// 5 × 3 texels of 0.5 m × 0.25 m.
fn fine() -> TableGrid {
    TableGrid { width: 5, height: 3, ..grid(Wrap::Repeat, Wrap::Clamp) }
}

/// The same area in 2 × 1 texels.
fn coarse() -> TableGrid {
    TableGrid { width: 2, height: 1, spacing_u: 1.25, spacing_v: 0.75, ..fine() }
}

/// Every table; the hemisphere depths are conservative, of two rings up to 60° and three azimuths.
pub(super) fn everything(encoding: Encoding) -> Result<Vec<u8>, WriteError> {
    let (grid, relief) = (fine(), RELIEF_RANGE);
    let directions = HemisphereDirections {
        rings: 2,
        azimuths: Azimuths::full_circle(3),
        spacing: RingSpacing::SquaredTangents,
        max_polar_radians: FRAC_PI_3,
    };
    let depths = depths(directions.layers());
    let mode = DepthMode::Conservative;
    let cones = |factor: f32| -> Vec<f32> {
        let texels = (0..3).flat_map(|row| (0..5).map(move |column| (column, row)));
        let depth = |(column, row): (u32, u32)| (4.0 - RELIEF[(row * 5 + column) as usize]) / 5.0;
        texels.flat_map(|(column, row)| [depth((column, row)), factor * cone_ratio(column, row)]).collect()
    };
    let maxima = maxima();
    let levels: Vec<&[f32]> = maxima.iter().map(Vec::as_slice).collect();
    let mut writer = AssetWriter::new();
    for table in [
        HeightTable { grid, values: &RELIEF }.encode(encoding),
        HemisphereTable { grid: coarse(), directions, mode, relief, values: &depths }.encode(encoding),
        ConeMapTable { grid, relief, values: &cones(1.0) }.encode(encoding),
        RelaxedConeMapTable { grid, relief, values: &cones(2.0) }.encode(encoding),
        MaximumMipTable { grid, levels: &levels }.encode(encoding),
    ] {
        writer.add_table(table?, Codec::Raw)?;
    }
    writer.finish()
}

/// The depths of single rays, of two rings of equal angles up to 60° and an arc of two azimuths.
pub(super) fn arc() -> Result<Vec<u8>, WriteError> {
    let directions = HemisphereDirections {
        rings: 2,
        azimuths: Azimuths::arc(-FRAC_PI_4, FRAC_PI_4, 2),
        spacing: RingSpacing::EqualAngles,
        max_polar_radians: FRAC_PI_3,
    };
    let (depths, mode, relief) = (depths(directions.layers()), DepthMode::Nearest, RELIEF_RANGE);
    let mut writer = AssetWriter::new();
    writer.add_table(HeightTable { grid: fine(), values: &RELIEF }.encode(Encoding::F32)?, Codec::Raw)?;
    let table = HemisphereTable { grid: coarse(), directions, mode, relief, values: &depths };
    writer.add_table(table.encode(Encoding::U8)?, Codec::Raw)?;
    writer.finish()
}

fn depths(layers: u32) -> Vec<f32> {
    (0..layers).flat_map(|layer| [0, 1].map(|column| hemisphere_depth(layer, column))).collect()
}
