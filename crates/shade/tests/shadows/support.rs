//! Height fields, and their tables as a file holds them.

use barchan_asset::{
    Encoding, HeightTable, HeightView, HorizonTable, HorizonView, LengthUnit, TableGrid, TextureTable, Wrap,
};
use barchan_bakers::Exec;
use barchan_bakers::horizon::{self, Azimuths, HorizonParams, Method};
use barchan_field::{Edge, Grid, HeightField, Spacing};
use barchan_shade::{DirectionalLight, HorizonShadow, Surface};

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

fn table_grid(grid: &Grid) -> TableGrid {
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

pub(crate) fn surface(field: &HeightField) -> Surface {
    let table = HeightTable { grid: table_grid(field.grid()), values: field.samples() }.encode(Encoding::F32).unwrap();
    Surface::new(&HeightView::new(*table.descriptor(), table.payload()).unwrap())
}

/// A horizon table, ready for lights.
pub(crate) struct Horizons(TextureTable);

impl Horizons {
    /// The exact horizon of a field, in f32: what is tested here is what is made of it.
    pub(crate) fn baked(field: &HeightField, directions: u32, radius: f64) -> Self {
        let params = HorizonParams {
            azimuths: Azimuths::full_circle(directions),
            radius,
            distance: false,
            method: Method::Exact,
        };
        let map = horizon::bake(field, &params, &Exec::new(1).unwrap()).unwrap();
        Self::of(field.grid(), directions, radius, &map.elevation_radians)
    }

    /// Elevations made up by the test.
    pub(crate) fn of(grid: &Grid, directions: u32, radius: f64, values: &[f32]) -> Self {
        let azimuths = barchan_asset::Azimuths::full_circle(directions);
        Self(HorizonTable { grid: table_grid(grid), azimuths, radius, values }.encode(Encoding::F32).unwrap())
    }

    pub(crate) fn shadow(&self, light: &DirectionalLight) -> HorizonShadow {
        HorizonShadow::new(&HorizonView::new(*self.0.descriptor(), self.0.payload()).unwrap(), light)
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
