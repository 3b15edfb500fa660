//! Height fields as surfaces.

use barchan_asset::{Encoding, HeightTable, HeightView};
use barchan_field::shapes::{FractalTerrain, Shape};
use barchan_field::{Edge, Grid, HeightField, LengthUnit, Spacing};
use barchan_shade::Surface;

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
