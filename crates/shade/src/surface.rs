//! The height field a picture is of.

use barchan_asset::HeightView;
use glam::DVec3;

use crate::Texture;

/// Heights and the spacing of their texels.
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    heights: Texture,
    spacing: (f64, f64),
}

impl Surface {
    /// The surface of a height table.
    #[must_use]
    pub fn new(heights: &HeightView<'_>) -> Self {
        Self { heights: Texture::new(&heights.table(), 0), spacing: heights.spacing() }
    }

    /// The heights, in the table's length unit.
    #[must_use]
    pub fn heights(&self) -> &Texture {
        &self.heights
    }

    /// Length per texel along u and v.
    #[must_use]
    pub fn spacing(&self) -> (f64, f64) {
        self.spacing
    }

    /// The unit normal at a place, smoothed for shading: the slope over one texel to each side.
    #[must_use]
    pub fn normal(&self, x: f64, y: f64) -> DVec3 {
        let along_u = (self.heights.sample(x + 1.0, y) - self.heights.sample(x - 1.0, y)) / (2.0 * self.spacing.0);
        // v points up the picture, rows are counted downwards.
        let along_v = (self.heights.sample(x, y - 1.0) - self.heights.sample(x, y + 1.0)) / (2.0 * self.spacing.1);
        DVec3::new(-along_u, -along_v, 1.0).normalize()
    }
}
