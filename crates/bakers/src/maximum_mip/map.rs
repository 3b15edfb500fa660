//! The typed table a bake of a maximum mip returns, before any encoding.

use barchan_field::Grid;

/// The highest point of every square of a relief.
#[derive(Debug, Clone, PartialEq)]
pub struct MaximumMip {
    /// The grid of the field it was baked from.
    pub grid: Grid,
    /// Level 0, of as many values as there are texels, down to one of a single value.
    pub levels: Vec<MipLevel>,
}

/// One level of a [`MaximumMip`].
#[derive(Debug, Clone, PartialEq)]
pub struct MipLevel {
    /// Values along u, at least 1.
    pub width: u32,
    /// Values along v, at least 1.
    pub height: u32,
    /// The greatest heights, row by row from the top of the picture, in the unit of length of the field.
    pub values: Vec<f32>,
}

impl MipLevel {
    /// The greatest height of a square.
    ///
    /// # Panics
    /// If the level has no such column or row.
    #[must_use]
    pub fn value(&self, column: u32, row: u32) -> f32 {
        assert!(column < self.width, "column {column} of {}", self.width);
        self.values[row as usize * self.width as usize + column as usize]
    }
}
