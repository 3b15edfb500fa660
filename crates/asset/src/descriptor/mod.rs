//! The 256 bytes that say what a table of texels is.

mod bytes;
mod check;
mod error;
mod layout;

pub use error::DescriptorError;

use crate::{
    Azimuths, DepthMode, Filter, Format, HemisphereDirections, LengthUnit, MipReducer, ReliefRange, RingSpacing,
    Semantic, Transfer, Unit, Wrap,
};

/// The newest section version of tables that this crate reads and writes; the oldest is 1. The texture descriptor has
/// the version of its section.
pub const SECTION_VERSION: u16 = 3;
/// Bytes of a texture descriptor.
pub(crate) const DESCRIPTOR_BYTES: usize = 256;
/// The most texels along one axis.
pub const MAX_EXTENT: u32 = 65_536;
/// The most layers.
pub const MAX_LAYERS: u32 = 2048;

/// What a table of texels is: extent, meaning, and how stored numbers become values.
///
/// `value = transfer(scale · stored + bias)`; see [`crate::TableView`] for the arithmetic.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TextureDescriptor {
    /// How a texel is stored.
    pub format: Format,
    /// Texels along u, 1 to [`MAX_EXTENT`].
    pub width: u32,
    /// Texels along v, 1 to [`MAX_EXTENT`].
    pub height: u32,
    /// The number of azimuths for directional tables, times `candidates` for swept and `rings` for hemispherical ones,
    /// 1 to [`MAX_LAYERS`]; else 1.
    pub layers: u32,
    /// Mip levels stored: for maximum heights all down to one texel, else 1.
    pub mips: u32,
    /// What the texels mean.
    pub semantic: Semantic,
    /// The unit of decoded values: radian for elevations, `length_unit` for heights and distances, else none.
    pub unit: Unit,
    /// The unit of spacing, search radius and lengths.
    pub length_unit: LengthUnit,
    /// What lies beyond the first and the last column.
    pub wrap_u: Wrap,
    /// What lies beyond the first and the last row.
    pub wrap_v: Wrap,
    /// How to interpolate.
    pub filter: Filter,
    /// How to make coarser mip levels.
    pub mip_reducer: MipReducer,
    /// Factor of stored numbers, ≥ 0 and exact as f32; 1 for 32-bit floats, 0 for a constant table.
    pub scale: f64,
    /// Offset of stored numbers after that, exact as f32; 0 for 32-bit floats.
    pub bias: f64,
    /// The least decoded value, in `unit`.
    pub range_min: f64,
    /// The greatest decoded value, in `unit`.
    pub range_max: f64,
    /// No decoded value is farther than this from the value that was encoded, in `unit`.
    pub worst_case_error: f64,
    /// Length per texel along u, in `length_unit`, 1e-30 to 1e30.
    pub spacing_u: f64,
    /// Length per texel along v, in `length_unit`, 1e-30 to 1e30.
    pub spacing_v: f64,
    /// Azimuth of layer 0 in radians, within ±2π; 0 for a full circle.
    pub first_azimuth: f64,
    /// From one azimuth to the next in radians, 2π / azimuths for a full circle; 0 where there is no direction.
    pub azimuth_step: f64,
    /// How far the horizon was searched, in `length_unit`, above 0; 0 where no horizon was.
    pub search_radius: f64,
    /// What becomes of `scale · stored + bias`.
    pub transfer: Transfer,
    /// Points per texel and azimuth, for swept tables; else 0. Layer = candidate · azimuths + direction.
    pub candidates: u32,
    /// The least curvature of the base surface that a swept table serves, in 1 / `length_unit`; else 0.
    pub curvature_min: f64,
    /// The greatest such curvature.
    pub curvature_max: f64,
    /// Rings of polar angles of a hemisphere table; else 0. Layer = ring · azimuths + azimuth.
    pub rings: u32,
    /// How the polar angle is cut; none where there are no rings.
    pub ring_spacing: Option<RingSpacing>,
    /// What a depth says about the rays of its cell; none where there are no rings.
    pub depth_mode: Option<DepthMode>,
    /// The polar angle at which the last ring ends, in radians, above 0 and below π/2; 0 where there are no rings.
    pub max_polar: f64,
    /// The height of depth 0, in `length_unit`; 0 where no values are depths.
    pub relief_top: f64,
    /// From depth 0 down to depth 1, in `length_unit`, 0 or more; 0 where no values are depths.
    pub relief_thickness: f64,
}

impl TextureDescriptor {
    /// Refuses a table of another meaning.
    pub(crate) fn expect(&self, expected: Semantic) -> Result<(), DescriptorError> {
        if self.semantic != expected {
            return Err(DescriptorError::Semantic { found: self.semantic, expected });
        }
        Ok(())
    }

    /// The azimuths of the layers; `None` where there is no direction.
    #[must_use]
    pub fn azimuths(&self) -> Option<Azimuths> {
        let count = self.layers / self.candidates.max(1) / self.rings.max(1);
        self.semantic.is_directional().then(|| Azimuths::from_parts(self.first_azimuth, self.azimuth_step, count))
    }

    /// The cells of the layers of a hemisphere table; `None` of another.
    #[must_use]
    pub fn directions(&self) -> Option<HemisphereDirections> {
        let (azimuths, spacing) = (self.azimuths()?, self.ring_spacing?);
        Some(HemisphereDirections { rings: self.rings, azimuths, spacing, max_polar_radians: self.max_polar })
    }

    /// What depths measure; `None` where no values are depths.
    #[must_use]
    pub fn relief(&self) -> Option<ReliefRange> {
        let range = ReliefRange { top: self.relief_top, thickness: self.relief_thickness };
        self.semantic.has_depths().then_some(range)
    }
}
