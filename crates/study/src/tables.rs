//! Fields and maps as a file stores them: the road from a bake to what a shader reads.

use barchan_asset::{
    Azimuths, Encoding, HeightTable, HeightView, HorizonTable, LengthUnit as AssetUnit, TableGrid, TextureTable, Wrap,
};
use barchan_bakers::horizon::HorizonMap;
use barchan_field::{Edge, Grid, HeightField};
use barchan_shade::Surface;

use crate::StudyError;

/// The surface that shadow rays are traced over, exact to f32.
pub(crate) fn surface(field: &HeightField) -> Result<Surface, StudyError> {
    let table = HeightTable { grid: table_grid(field.grid()), values: field.samples() }.encode(Encoding::F32)?;
    Ok(Surface::new(&HeightView::new(*table.descriptor(), table.payload())?))
}

/// A horizon map in its stored form.
pub(crate) fn horizon(map: &HorizonMap, encoding: Encoding) -> Result<TextureTable, StudyError> {
    let grid = table_grid(&map.grid);
    let (azimuths, radius) = (Azimuths::full_circle(map.params.directions()), map.params.radius);
    Ok(HorizonTable { grid, azimuths, radius, values: &map.elevation_radians }.encode(encoding)?)
}

/// Lengths are only compared with each other here, so all units are the scene's.
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
        length_unit: AssetUnit::SceneUnit,
        wrap_u: wrap,
        wrap_v: wrap,
    }
}
