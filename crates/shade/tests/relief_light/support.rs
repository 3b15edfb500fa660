//! Height fields as surfaces.

use barchan_asset::{
    Azimuths, ConeMapTable, ConeMapView, DepthMode, Encoding, HeightTable, HeightView, HemisphereDirections,
    HemisphereTable, HemisphereView, RingSpacing, TableGrid, TextureTable,
};
use barchan_bakers::Exec;
use barchan_bakers::cone::{self, ConeKind};
use barchan_bakers::hemisphere::{self, HemisphereParams};
use barchan_field::shapes::{FractalTerrain, Shape};
use barchan_field::{Edge, Grid, HeightField, LengthUnit, Spacing};
use barchan_shade::{ConeSteps, Relief, Surface};

use crate::common::table_grid;
pub(crate) use crate::common::{assert_near, field, noise};

pub(crate) fn surface(field: &HeightField) -> Surface {
    let table = HeightTable { grid: table_grid(field.grid()), values: field.samples() }.encode(Encoding::F32).unwrap();
    Surface::new(&HeightView::new(*table.descriptor(), table.payload()).unwrap())
}

/// Relief at every scale on a tile of `size` texels of length 1, about a sixth of the tile deep.
pub(crate) fn fractal(size: u32) -> HeightField {
    let grid = Grid {
        width: size,
        height: size,
        spacing: Spacing::new(1.0, 1.0).unwrap(),
        unit: LengthUnit::Metre,
        edge: Edge::Wrap,
    };
    let shape = FractalTerrain { height: f64::from(size) / 6.0, hurst: 0.8, features_across: 3, octaves: 5, seed: 5 };
    Shape::FractalTerrain(shape).rasterize(grid).unwrap()
}

/// Points spread evenly over a tile, no two in a row or a column.
pub(crate) fn places(count: u32, size: u32) -> impl Iterator<Item = (f64, f64)> {
    let part = move |k: u32, by: f64| (f64::from(k) * by).fract() * f64::from(size) - 0.5;
    (0..count).map(move |k| (part(k + 1, 0.754_877_666), part(k + 1, 0.569_840_291)))
}

/// The directions of a small depth map.
pub(crate) fn directions() -> HemisphereDirections {
    HemisphereDirections {
        rings: 16,
        azimuths: Azimuths::full_circle(16),
        spacing: RingSpacing::SquaredTangents,
        max_polar_radians: 80_f64.to_radians(),
    }
}

/// Depths of a square field in bytes, on `size` texels along either side.
pub(crate) fn hemisphere(field: &HeightField, size: u32, mode: DepthMode) -> TextureTable {
    let params = HemisphereParams { directions: directions(), width: size, height: size, mode };
    let map = hemisphere::bake(field, &params, &Exec::new(1).unwrap()).unwrap();
    let heights = table_grid(field.grid());
    let texels = |count: u32, spacing: f64| f64::from(count) * spacing / f64::from(size);
    let grid = TableGrid {
        width: size,
        height: size,
        spacing_u: texels(heights.width, heights.spacing_u),
        spacing_v: texels(heights.height, heights.spacing_v),
        ..heights
    };
    let table = HemisphereTable { grid, directions: directions(), mode, relief: map.relief, values: &map.depths };
    table.encode(Encoding::U8).unwrap()
}

pub(crate) fn hemisphere_view(table: &TextureTable) -> HemisphereView<'_> {
    HemisphereView::new(*table.descriptor(), table.payload()).unwrap()
}

/// Cone steps through a field's relief, by a map in bytes.
pub(crate) fn cone_steps<'a>(field: &HeightField, relief: &Relief<'a>) -> ConeSteps<'a> {
    let map = cone::bake(field, ConeKind::Strict, &Exec::new(1).unwrap()).unwrap();
    let table = ConeMapTable { grid: table_grid(field.grid()), relief: map.relief, values: &map.values };
    let table = table.encode(Encoding::U8).unwrap();
    ConeSteps::new(relief, &ConeMapView::new(*table.descriptor(), table.payload()).unwrap()).unwrap()
}
