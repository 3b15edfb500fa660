//! Height fields written down.

use barchan_field::{Edge, Grid, HeightField, LengthUnit, Spacing};

pub(crate) fn grid((width, height): (u32, u32), (spacing_u, spacing_v): (f64, f64), edge: Edge) -> Grid {
    let spacing = Spacing::new(spacing_u, spacing_v).unwrap();
    Grid { width, height, spacing, unit: LengthUnit::SceneUnit, edge }
}

/// `height` is asked for each column and row.
pub(crate) fn fill(grid: Grid, height: impl Fn(u32, u32) -> f32) -> HeightField {
    let height = &height;
    let samples = (0..grid.height).flat_map(|row| (0..grid.width).map(move |column| height(column, row))).collect();
    HeightField::new(grid, samples).unwrap()
}
