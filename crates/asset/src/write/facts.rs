//! What is known of a table before any of its values.

use core::ops::RangeInclusive;

use super::encode::Encoding;
use super::quantiser::Rounding;
use crate::{
    Azimuths, DepthMode, Filter, HemisphereDirections, LengthUnit, MAX_ELEVATION, MipReducer, ReliefRange, Semantic,
    TextureDescriptor, Wrap, f32_at_most,
};

/// Where the texels of a table lie.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TableGrid {
    /// Texels along u.
    pub width: u32,
    /// Texels along v.
    pub height: u32,
    /// Length per texel along u.
    pub spacing_u: f64,
    /// Length per texel along v.
    pub spacing_v: f64,
    /// The unit of lengths.
    pub length_unit: LengthUnit,
    /// What lies beyond the first and the last column.
    pub wrap_u: Wrap,
    /// What lies beyond the first and the last row.
    pub wrap_v: Wrap,
}

impl TableGrid {
    /// Other texels over the same lengths.
    #[must_use]
    pub fn with_texels(self, width: u32, height: u32) -> Self {
        let spacing = |spacing: f64, texels: u32, others: u32| spacing * f64::from(texels) / f64::from(others);
        Self {
            width,
            height,
            spacing_u: spacing(self.spacing_u, self.width, width),
            spacing_v: spacing(self.spacing_v, self.height, height),
            ..self
        }
    }
}

/// Which curved bases a swept table serves, and with how many points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvatureSweep {
    /// Points per texel and azimuth, at least 1, besides the one in the horizon table.
    pub candidates: u32,
    /// The least curvature, in 1 / length unit.
    pub curvature_min: f64,
    /// The greatest curvature, in 1 / length unit.
    pub curvature_max: f64,
}

/// All that a descriptor says and the values do not change.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TableFacts {
    grid: TableGrid,
    semantic: Semantic,
    azimuths: Option<Azimuths>,
    sweep: Option<CurvatureSweep>,
    radius: f64,
    cells: Option<(HemisphereDirections, DepthMode)>,
    relief: Option<ReliefRange>,
}

impl TableFacts {
    /// Heights in the length unit.
    #[must_use]
    pub fn height(grid: TableGrid) -> Self {
        let semantic = Semantic::Height;
        Self { grid, semantic, azimuths: None, sweep: None, radius: 0.0, cells: None, relief: None }
    }

    /// Horizon elevations in radians; the horizon was searched up to `radius`, in the length unit.
    #[must_use]
    pub fn horizon(grid: TableGrid, azimuths: Azimuths, radius: f64) -> Self {
        Self { semantic: Semantic::HorizonElevation, azimuths: Some(azimuths), radius, ..Self::height(grid) }
    }

    /// Horizon distances in the length unit.
    #[must_use]
    pub fn distance(grid: TableGrid, azimuths: Azimuths, radius: f64) -> Self {
        Self { semantic: Semantic::HorizonDistance, ..Self::horizon(grid, azimuths, radius) }
    }

    /// Elevations in radians of points that become the horizon on a curved base.
    #[must_use]
    pub fn swept_horizon(grid: TableGrid, azimuths: Azimuths, radius: f64, sweep: CurvatureSweep) -> Self {
        let semantic = Semantic::SweptElevation;
        Self { semantic, sweep: Some(sweep), ..Self::horizon(grid, azimuths, radius) }
    }

    /// Distances of those points in the length unit.
    #[must_use]
    pub fn swept_distance(grid: TableGrid, azimuths: Azimuths, radius: f64, sweep: CurvatureSweep) -> Self {
        Self { semantic: Semantic::SweptDistance, ..Self::swept_horizon(grid, azimuths, radius, sweep) }
    }

    /// Visible shares of the sky, of horizons searched up to `radius`.
    #[must_use]
    pub fn sky_visibility(grid: TableGrid, radius: f64) -> Self {
        Self { semantic: Semantic::SkyVisibility, radius, ..Self::height(grid) }
    }

    /// Mean directions of the visible sky: u and v of each texel, interleaved.
    #[must_use]
    pub fn bent_normal(grid: TableGrid, radius: f64) -> Self {
        Self { semantic: Semantic::BentNormal, radius, ..Self::height(grid) }
    }

    /// Cones of directions towards the sky: u, v and height of the axis and the cosine of the half-angle, interleaved.
    #[must_use]
    pub fn aperture_cone(grid: TableGrid, radius: f64) -> Self {
        Self { semantic: Semantic::ApertureCone, radius, ..Self::height(grid) }
    }

    /// Depths in [0, 1] at which rays of each cell of `directions` first meet the relief.
    #[must_use]
    pub fn hemisphere(grid: TableGrid, directions: HemisphereDirections, mode: DepthMode, relief: ReliefRange) -> Self {
        let (azimuths, cells) = (Some(directions.azimuths), Some((directions, mode)));
        Self { semantic: Semantic::HemisphereDepth, azimuths, cells, ..Self::cone_map(grid, relief) }
    }

    /// Depths in [0, 1] and ratios of cones that the relief stays out of, interleaved.
    #[must_use]
    pub fn cone_map(grid: TableGrid, relief: ReliefRange) -> Self {
        Self { semantic: Semantic::ConeMap, relief: Some(relief), ..Self::height(grid) }
    }

    /// Depths in [0, 1] and ratios of cones in which a ray pierces the relief once at most, interleaved.
    #[must_use]
    pub fn relaxed_cone_map(grid: TableGrid, relief: ReliefRange) -> Self {
        Self { semantic: Semantic::RelaxedConeMap, ..Self::cone_map(grid, relief) }
    }

    /// Greatest heights in the length unit, level by level.
    #[must_use]
    pub fn maximum_mip(grid: TableGrid) -> Self {
        Self { semantic: Semantic::MaximumHeight, ..Self::height(grid) }
    }

    /// What the texels mean.
    #[must_use]
    pub fn semantic(&self) -> Semantic {
        self.semantic
    }

    /// Layers: azimuths times candidates or rings; 1 where there is no direction.
    #[must_use]
    pub fn layers(&self) -> u32 {
        let azimuths = self.azimuths.map_or(1, |azimuths| azimuths.count());
        let rings = self.cells.map_or(1, |(directions, _)| directions.rings);
        azimuths.saturating_mul(self.sweep.map_or(1, |sweep| sweep.candidates)).saturating_mul(rings)
    }

    /// Numbers in one layer, or in the first mip level: texels times channels.
    #[must_use]
    pub fn layer_values(&self) -> u64 {
        u64::from(self.grid.width) * u64::from(self.grid.height) * u64::from(self.semantic.channels())
    }

    /// The values that a table of this meaning may hold: bounds for a bake that knows no better. Of a cone map, the ratios;
    /// its depths are within [0, 1].
    #[must_use]
    pub fn legal(&self) -> RangeInclusive<f32> {
        match self.semantic {
            Semantic::Height | Semantic::MaximumHeight => f32::MIN..=f32::MAX,
            Semantic::ConeMap | Semantic::RelaxedConeMap => 0.0..=f32::MAX,
            Semantic::HorizonElevation | Semantic::SweptElevation => -MAX_ELEVATION..=MAX_ELEVATION,
            Semantic::HorizonDistance | Semantic::SweptDistance => 0.0..=f32_at_most(self.radius),
            Semantic::SkyVisibility | Semantic::HemisphereDepth => 0.0..=1.0,
            Semantic::BentNormal | Semantic::ApertureCone => -1.0..=1.0,
        }
    }

    /// To which side values are rounded: what bounds depths from above the surface stays above it.
    pub(super) fn rounding(&self) -> Rounding {
        match (self.semantic, self.cells) {
            (Semantic::HemisphereDepth, Some((_, DepthMode::Conservative))) => Rounding::Down,
            (Semantic::ConeMap | Semantic::RelaxedConeMap, _) => Rounding::Down,
            (Semantic::MaximumHeight, _) => Rounding::Up,
            _ => Rounding::Nearest,
        }
    }

    /// The descriptor of a table of zeros.
    pub(super) fn descriptor(&self, encoding: Encoding) -> TextureDescriptor {
        let Self { grid, semantic, azimuths, sweep, radius, cells, relief } = *self;
        let (mips, filter, mip_reducer) = match semantic {
            Semantic::MaximumHeight => {
                (grid.width.max(grid.height).max(1).ilog2() + 1, Filter::Nearest, MipReducer::Max)
            }
            Semantic::HemisphereDepth => (1, Filter::Nearest, MipReducer::Min),
            Semantic::ConeMap | Semantic::RelaxedConeMap => (1, Filter::Linear, MipReducer::Min),
            _ => (1, Filter::Linear, MipReducer::Mean),
        };
        TextureDescriptor {
            format: encoding.format(semantic),
            width: grid.width,
            height: grid.height,
            layers: self.layers(),
            mips,
            semantic,
            unit: semantic.unit(grid.length_unit),
            length_unit: grid.length_unit,
            wrap_u: grid.wrap_u,
            wrap_v: grid.wrap_v,
            filter,
            mip_reducer,
            scale: 1.0,
            bias: 0.0,
            range_min: 0.0,
            range_max: 0.0,
            worst_case_error: 0.0,
            spacing_u: grid.spacing_u,
            spacing_v: grid.spacing_v,
            first_azimuth: azimuths.map_or(0.0, |azimuths| azimuths.first_radians()),
            azimuth_step: azimuths.map_or(0.0, |azimuths| azimuths.step_radians()),
            search_radius: radius,
            transfer: encoding.transfer(semantic),
            candidates: sweep.map_or(0, |sweep| sweep.candidates),
            curvature_min: sweep.map_or(0.0, |sweep| sweep.curvature_min),
            curvature_max: sweep.map_or(0.0, |sweep| sweep.curvature_max),
            rings: cells.map_or(0, |(directions, _)| directions.rings),
            ring_spacing: cells.map(|(directions, _)| directions.spacing),
            depth_mode: cells.map(|(_, mode)| mode),
            max_polar: cells.map_or(0.0, |(directions, _)| directions.max_polar_radians),
            relief_top: relief.map_or(0.0, |relief| relief.top),
            relief_thickness: relief.map_or(0.0, |relief| relief.thickness),
        }
    }
}
