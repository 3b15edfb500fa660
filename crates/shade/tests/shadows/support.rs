//! Height fields, and their tables as a file holds them.

use barchan_asset::{Encoding, HeightTable, HeightView, HorizonTable, HorizonView, TextureTable};
use barchan_bakers::Exec;
use barchan_bakers::horizon::{self, Azimuths, HorizonParams, Method};
use barchan_field::{Grid, HeightField};
use barchan_shade::{DirectionalLight, HorizonShadow, Surface};

use crate::common::table_grid;
pub(crate) use crate::common::{assert_near, field, noise};

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
