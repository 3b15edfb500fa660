//! What the tests of flat and of curved relief share.

use barchan_asset::{LengthUnit, TableGrid, Wrap};
use barchan_field::{Edge, Grid, HeightField, Spacing};

/// A field of (width, height) texels of a length along u and along v.
pub(crate) fn field(
    (width, height): (u32, u32),
    (spacing_u, spacing_v): (f64, f64),
    edge: Edge,
    at: impl Fn(u32, u32) -> f32,
) -> HeightField {
    let (spacing, unit) = (Spacing::new(spacing_u, spacing_v).unwrap(), barchan_field::LengthUnit::Metre);
    let at = &at;
    let samples = (0..height).flat_map(|row| (0..width).map(move |column| at(column, row))).collect();
    HeightField::new(Grid { width, height, spacing, unit, edge }, samples).unwrap()
}

/// Where the texels of a field lie, for a file.
pub(crate) fn table_grid(grid: &Grid) -> TableGrid {
    let wrap = match grid.edge {
        Edge::Wrap => Wrap::Repeat,
        Edge::Clamp => Wrap::Clamp,
    };
    TableGrid {
        width: grid.width,
        height: grid.height,
        spacing_u: grid.spacing.u(),
        spacing_v: grid.spacing.v(),
        length_unit: LengthUnit::Metre,
        wrap_u: wrap,
        wrap_v: wrap,
    }
}

#[track_caller]
pub(crate) fn assert_near(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance, "{found} instead of {expected}, off by {:e}", found - expected);
}

/// Reproducible noise in [0, 1) for a texel.
pub(crate) fn noise(seed: u32, column: u32, row: u32) -> f32 {
    let mut hash = seed.wrapping_mul(0x9E37_79B9) ^ column.wrapping_mul(0x85EB_CA6B) ^ row.wrapping_mul(0xC2B2_AE35);
    for _ in 0..2 {
        hash = (hash ^ (hash >> 15)).wrapping_mul(0x2C1B_3C6D);
        hash = (hash ^ (hash >> 12)).wrapping_mul(0x297A_2D39);
    }
    (hash >> 8) as f32 / (1 << 24) as f32
}
