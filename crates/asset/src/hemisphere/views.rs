//! Views of the tables for relief search, in the words of each.

use crate::views::common_view;
use crate::{
    DepthMode, DescriptorError, HemisphereDirections, LengthUnit, ReliefRange, RingSpacing, Semantic, TableView,
    TextureDescriptor, Wrap,
};

/// What every view of depths offers besides.
macro_rules! depth_view {
    ($name:ident) => {
        impl $name<'_> {
            /// What depths measure.
            #[must_use]
            pub fn relief(&self) -> ReliefRange {
                ReliefRange { top: self.descriptor().relief_top, thickness: self.descriptor().relief_thickness }
            }
        }
    };
}

/// Depths at which rays of cells of directions first meet the relief.
#[derive(Debug, Clone, Copy)]
pub struct HemisphereView<'a> {
    table: TableView<'a>,
}

common_view!(HemisphereView, Semantic::HemisphereDepth);
depth_view!(HemisphereView);

impl HemisphereView<'_> {
    /// The cells of the layers.
    #[must_use]
    pub fn directions(&self) -> HemisphereDirections {
        let descriptor = self.descriptor();
        // A checked descriptor of this semantic has both.
        let azimuths = descriptor.azimuths().unwrap_or(crate::Azimuths::full_circle(1));
        let spacing = descriptor.ring_spacing.unwrap_or(RingSpacing::SquaredTangents);
        HemisphereDirections { rings: descriptor.rings, azimuths, spacing, max_polar_radians: descriptor.max_polar }
    }

    /// What a depth says about the rays of its cell.
    #[must_use]
    pub fn mode(&self) -> DepthMode {
        self.descriptor().depth_mode.unwrap_or(DepthMode::Nearest)
    }

    /// The depth, in [0, 1], of a layer of [`HemisphereDirections::layer`] and a texel.
    ///
    /// # Panics
    /// If there is no such layer or texel.
    #[must_use]
    pub fn depth(&self, layer: u32, column: u32, row: u32) -> f32 {
        self.table.value(layer, column, row)
    }
}

/// What both cone maps offer besides.
macro_rules! cone_view {
    ($name:ident) => {
        impl $name<'_> {
            /// The depth of the surface at a texel's centre, in [0, 1], or less.
            ///
            /// # Panics
            /// If there is no such texel.
            #[must_use]
            pub fn depth(&self, column: u32, row: u32) -> f32 {
                self.table.channel(0, column, row, 0)
            }

            /// The ratio of the cone: horizontal length over height, the tangent of its half-angle; 0 or more.
            ///
            /// # Panics
            /// If there is no such texel.
            #[must_use]
            pub fn ratio(&self, column: u32, row: u32) -> f32 {
                self.table.channel(0, column, row, 1)
            }
        }
    };
}

/// Depths and cones that the relief stays out of.
#[derive(Debug, Clone, Copy)]
pub struct ConeMapView<'a> {
    table: TableView<'a>,
}

common_view!(ConeMapView, Semantic::ConeMap);
depth_view!(ConeMapView);
cone_view!(ConeMapView);

/// Depths and cones in which a ray pierces the relief once at most.
#[derive(Debug, Clone, Copy)]
pub struct RelaxedConeMapView<'a> {
    table: TableView<'a>,
}

common_view!(RelaxedConeMapView, Semantic::RelaxedConeMap);
depth_view!(RelaxedConeMapView);
cone_view!(RelaxedConeMapView);

/// The greatest heights of cells between texels, level by level.
#[derive(Debug, Clone, Copy)]
pub struct MaximumMipView<'a> {
    table: TableView<'a>,
}

common_view!(MaximumMipView, Semantic::MaximumHeight);

impl MaximumMipView<'_> {
    /// How many levels there are, the last of one texel.
    #[must_use]
    pub fn levels(&self) -> u32 {
        self.descriptor().mips
    }

    /// Texels of a level along u and v: half those of the level before, rounded down, at least 1.
    #[must_use]
    pub fn extent(&self, level: u32) -> (u32, u32) {
        self.descriptor().picture_extent(level)
    }

    /// The greatest height in the length unit, or more, of all cells whose column >> level and row >> level are this
    /// column and row; the last column and row stand for what is left over as well.
    ///
    /// # Panics
    /// If there is no such level or texel.
    #[must_use]
    pub fn value(&self, level: u32, column: u32, row: u32) -> f32 {
        self.table.value(level, column, row)
    }
}
