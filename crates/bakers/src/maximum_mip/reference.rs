//! The obvious twin: every square looks through all the texels that it stands for.

use barchan_field::{Grid, HeightField};

use super::{MaximumMip, MipLevel};

/// Bakes by the definition.
#[must_use]
pub fn bake(field: &HeightField) -> MaximumMip {
    let grid = *field.grid();
    let last_level = grid.width.max(grid.height).ilog2();
    MaximumMip { grid, levels: (0..=last_level).map(|level| bake_level(field, level)).collect() }
}

fn bake_level(field: &HeightField, level: u32) -> MipLevel {
    let Grid { width, height, .. } = *field.grid();
    let extent = |texels: u32| (texels >> level).max(1);
    let index = |cell: u32, texels: u32| (cell >> level).min(extent(texels) - 1);
    let (columns, rows) = (extent(width), extent(height));
    let mut values = vec![f32::MIN; columns as usize * rows as usize];
    for (row, column) in (0..height).flat_map(|row| (0..width).map(move |column| (row, column))) {
        let value = &mut values[(index(row, height) * columns + index(column, width)) as usize];
        for (i, j) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            *value = value.max(field.texel(i64::from(column) + i, i64::from(row) + j));
        }
    }
    MipLevel { width: columns, height: rows, values }
}
