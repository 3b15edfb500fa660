//! Height fields, and their horizons as a file holds them.

use barchan_asset::{
    Azimuths, DistanceTable, DistanceView, Encoding, HeightTable, HeightView, HorizonTable, HorizonView, TableGrid,
    TextureTable,
};
use barchan_bakers::Exec;
use barchan_bakers::horizon::{self, HorizonParams, Method};
use barchan_field::{Edge, Grid, HeightField, Shape, Spacing};
use barchan_shade::{DirectionalLight, DiscLight, Penumbra, Surface};

use crate::common::table_grid;
pub(crate) use crate::common::{assert_near, field, noise};

/// A sun of an azimuth, an elevation and an angular radius in degrees.
pub(crate) fn sun(azimuth: f64, elevation: f64, radius: f64) -> DiscLight {
    DiscLight::sun(DirectionalLight::from_degrees(azimuth, elevation).towards, radius.to_radians())
}

pub(crate) fn surface(field: &HeightField) -> Surface {
    let table = HeightTable { grid: table_grid(field.grid()), values: field.samples() }.encode(Encoding::F32).unwrap();
    Surface::new(&HeightView::new(*table.descriptor(), table.payload()).unwrap())
}

/// One of the example shapes, over a tile of 64 by 64 texels of length 4.
pub(crate) fn shape(name: &str) -> HeightField {
    let shape = Shape::examples().into_iter().find(|shape| shape.name() == name).unwrap();
    let unit = barchan_field::LengthUnit::Metre;
    let grid = Grid { width: 64, height: 64, spacing: Spacing::square(4.0).unwrap(), unit, edge: Edge::Wrap };
    shape.rasterize(grid).unwrap()
}

/// A horizon table and its distances.
pub(crate) struct Horizons {
    pub(crate) elevation: TextureTable,
    pub(crate) distance: TextureTable,
}

impl Horizons {
    /// The exact ones of a field, in f32.
    pub(crate) fn baked(field: &HeightField, directions: u32, radius: f64) -> Self {
        let params = HorizonParams {
            azimuths: horizon::Azimuths::full_circle(directions),
            radius,
            distance: true,
            method: Method::Exact,
        };
        let map = horizon::bake(field, &params, &Exec::new(1).unwrap()).unwrap();
        let azimuths = Azimuths::full_circle(directions);
        Self::of(table_grid(field.grid()), azimuths, radius, &map.elevation_radians, &map.distance.unwrap())
    }

    /// One texel: elevations in radians, and distances, of each azimuth.
    pub(crate) fn single(azimuths: Azimuths, elevation: &[f32], distance: &[f32]) -> Self {
        let grid = table_grid(field((1, 1), (1.0, 1.0), Edge::Clamp, |_, _| 0.0).grid());
        Self::of(grid, azimuths, 100.0, elevation, distance)
    }

    /// Made up by the test.
    pub(crate) fn of(grid: TableGrid, azimuths: Azimuths, radius: f64, elevation: &[f32], distance: &[f32]) -> Self {
        Self {
            elevation: HorizonTable { grid, azimuths, radius, values: elevation }.encode(Encoding::F32).unwrap(),
            distance: DistanceTable { grid, azimuths, radius, values: distance }.encode(Encoding::F32).unwrap(),
        }
    }

    pub(crate) fn elevation(&self) -> HorizonView<'_> {
        HorizonView::new(*self.elevation.descriptor(), self.elevation.payload()).unwrap()
    }

    pub(crate) fn penumbra(&self) -> Penumbra {
        let distance = DistanceView::new(*self.distance.descriptor(), self.distance.payload()).unwrap();
        Penumbra::new(&self.elevation(), &distance).unwrap()
    }
}
