//! Views of what a texel sees of the sky. `formats/sky-v1.md` is the law.

use crate::angle::square_root;
use crate::views::common_view;
use crate::{DescriptorError, LengthUnit, Semantic, TableView, TextureDescriptor, Wrap};

/// How much of the sky a texel sees.
#[derive(Debug, Clone, Copy)]
pub struct SkyVisibilityView<'a> {
    table: TableView<'a>,
}

common_view!(SkyVisibilityView, Semantic::SkyVisibility);

impl SkyVisibilityView<'_> {
    /// The visible share of the sky, weighted by the cosine to the surface normal, in [0, 1]: 1 is open.
    ///
    /// # Panics
    /// If there is no such texel.
    #[must_use]
    pub fn visibility(&self, column: u32, row: u32) -> f32 {
        self.table.value(0, column, row)
    }
}

/// The mean direction of the visible sky.
#[derive(Debug, Clone, Copy)]
pub struct BentNormalView<'a> {
    table: TableView<'a>,
}

common_view!(BentNormalView, Semantic::BentNormal);

impl BentNormalView<'_> {
    /// The unit vector's components along u, v and height; the last is √(1 − u² − v²), never below 0.
    ///
    /// # Panics
    /// If there is no such texel.
    #[must_use]
    pub fn normal(&self, column: u32, row: u32) -> [f32; 3] {
        let [u, v] = [0, 1].map(|channel| self.table.channel(0, column, row, channel));
        let rest = 1.0 - f64::from(u) * f64::from(u) - f64::from(v) * f64::from(v);
        [u, v, square_root(rest) as f32]
    }
}

/// The cone of directions towards the visible sky.
#[derive(Debug, Clone, Copy)]
pub struct ApertureConeView<'a> {
    table: TableView<'a>,
}

common_view!(ApertureConeView, Semantic::ApertureCone);

impl ApertureConeView<'_> {
    /// The axis: components along u, v and height of a unit vector, as near to unit length as the encoding keeps it.
    ///
    /// # Panics
    /// If there is no such texel.
    #[must_use]
    pub fn axis(&self, column: u32, row: u32) -> [f32; 3] {
        [0, 1, 2].map(|channel| self.table.channel(0, column, row, channel))
    }

    /// The cosine of the half-angle, in [−1, 1]: 0 is a hemisphere, 1 a ray.
    ///
    /// # Panics
    /// If there is no such texel.
    #[must_use]
    pub fn cosine_of_half_angle(&self, column: u32, row: u32) -> f32 {
        self.table.channel(0, column, row, 3)
    }
}
