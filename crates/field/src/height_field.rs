//! The height field itself.

use crate::{FieldError, Grid};

/// Finite f32 heights at the texel centres of a [`Grid`], row by row from the top of the picture.
#[derive(Debug, Clone, PartialEq)]
pub struct HeightField {
    grid: Grid,
    samples: Vec<f32>,
}

impl HeightField {
    /// Refuses an empty grid, a wrong number of samples, and samples that are not finite.
    pub fn new(grid: Grid, samples: Vec<f32>) -> Result<Self, FieldError> {
        let Grid { width, height, .. } = grid;
        if width == 0 || height == 0 {
            return Err(FieldError::Empty { width, height });
        }
        let expected = u64::from(width) * u64::from(height);
        let found = samples.len() as u64;
        if found != expected {
            return Err(FieldError::SampleCount { width, height, expected, found });
        }
        if let Some(first) = samples.iter().position(|h| !h.is_finite()) {
            return Err(FieldError::NotFinite {
                column: (first % width as usize) as u32,
                row: (first / width as usize) as u32,
                value: samples[first],
                count: samples.iter().filter(|h| !h.is_finite()).count() as u64,
                total: expected,
            });
        }
        Ok(Self { grid, samples })
    }

    /// Extent, spacing, unit and edge policy.
    #[must_use]
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// The heights, row by row from the top, in the grid's length unit.
    #[must_use]
    pub fn samples(&self) -> &[f32] {
        &self.samples
    }

    /// The lowest and the highest sample.
    #[must_use]
    pub fn range(&self) -> (f32, f32) {
        self.samples.iter().fold((f32::INFINITY, f32::NEG_INFINITY), |(lo, hi), &h| (lo.min(h), hi.max(h)))
    }

    /// The height at texel `(column, row)`, continued beyond the edge by the grid's policy.
    #[inline]
    #[must_use]
    pub fn texel(&self, column: i64, row: i64) -> f32 {
        let Grid { width, height, edge, .. } = self.grid;
        self.samples[edge.resolve(row, height) * width as usize + edge.resolve(column, width)]
    }

    /// The bilinear surface, in f64. `x` counts columns and `y` rows *from the centre of the first texel*: `(0, 0)` is
    /// the sample of texel (0, 0), and y grows downwards.
    #[must_use]
    pub fn surface(&self, x: f64, y: f64) -> f64 {
        let (column, row) = (x.floor(), y.floor());
        let (fx, fy) = (x - column, y - row);
        let texel = |i: i64, j: i64| f64::from(self.texel(column as i64 + i, row as i64 + j));
        let upper = texel(0, 0) * (1.0 - fx) + texel(1, 0) * fx;
        let lower = texel(0, 1) * (1.0 - fx) + texel(1, 1) * fx;
        upper * (1.0 - fy) + lower * fy
    }
}
