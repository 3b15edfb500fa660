//! The height field a picture is of.

use barchan_asset::HeightView;
use glam::{DVec2, DVec3};

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

    /// Length of the whole table along u and v: of one unit of texture coordinates.
    #[must_use]
    pub fn extent(&self) -> (f64, f64) {
        (f64::from(self.heights.width()) * self.spacing.0, f64::from(self.heights.height()) * self.spacing.1)
    }

    /// The place of texture coordinates, in texels from the centre of texel (0, 0): the table is 1 by 1, (0, 0) its lower left
    /// corner, v up the picture.
    #[must_use]
    pub fn texel_of(&self, uv: DVec2) -> (f64, f64) {
        let (width, height) = (f64::from(self.heights.width()), f64::from(self.heights.height()));
        (uv.x * width - 0.5, (1.0 - uv.y) * height - 0.5)
    }

    /// How steeply heights rise along u and v, smoothed for shading: over one texel to each side.
    #[must_use]
    pub fn slopes(&self, x: f64, y: f64) -> (f64, f64) {
        let along_u = (self.heights.sample(x + 1.0, y) - self.heights.sample(x - 1.0, y)) / (2.0 * self.spacing.0);
        // v points up the picture, rows are counted downwards.
        let along_v = (self.heights.sample(x, y - 1.0) - self.heights.sample(x, y + 1.0)) / (2.0 * self.spacing.1);
        (along_u, along_v)
    }

    /// The unit normal at a place, smoothed for shading: [`Surface::slopes`].
    #[must_use]
    pub fn normal(&self, x: f64, y: f64) -> DVec3 {
        let (along_u, along_v) = self.slopes(x, y);
        DVec3::new(-along_u, -along_v, 1.0).normalize()
    }
}
