//! The 256 bytes that say what a table of texels is.

mod check;
mod error;

pub use error::DescriptorError;

use crate::bytes::{CHUNK_ALIGN, align_up, f64_at, first_nonzero, put, u32_at};
use crate::{Azimuths, Filter, Format, LengthUnit, MipReducer, Semantic, Transfer, Unit, Wrap};

/// The newest section version of tables that this crate reads and writes; the oldest is 1. The texture descriptor has
/// the version of its section.
pub const SECTION_VERSION: u16 = 2;
/// Bytes of a texture descriptor.
pub(crate) const DESCRIPTOR_BYTES: usize = 256;
/// The most texels along one axis.
pub const MAX_EXTENT: u32 = 65_536;
/// The most layers.
pub const MAX_LAYERS: u32 = 2048;

const TRANSFER_AT: usize = 128;
const CANDIDATES_AT: usize = 132;
const CURVATURE_AT: usize = 136;

/// Where the bytes start that are zero in a descriptor of that version.
fn reserved_at(version: u16) -> usize {
    if version == 1 { TRANSFER_AT } else { CURVATURE_AT + 16 }
}

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
    /// The number of azimuths for directional tables, times `candidates` for swept ones, 1 to [`MAX_LAYERS`]; else 1.
    pub layers: u32,
    /// Mip levels stored; always 1 in this version.
    pub mips: u32,
    /// What the texels mean.
    pub semantic: Semantic,
    /// The unit of decoded values: radian for elevations, `length_unit` for lengths, else none.
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
    /// Azimuth from one layer to the next in radians, 2π / azimuths for a full circle; 0 where there is no direction.
    pub azimuth_step: f64,
    /// How far the horizon was searched, in `length_unit`, above 0; 0 for heights.
    pub search_radius: f64,
    /// What becomes of `scale · stored + bias`.
    pub transfer: Transfer,
    /// Points per texel and azimuth, for swept tables; else 0. Layer = candidate · azimuths + direction.
    pub candidates: u32,
    /// The least curvature of the base surface that a swept table serves, in 1 / `length_unit`; else 0.
    pub curvature_min: f64,
    /// The greatest such curvature.
    pub curvature_max: f64,
}

impl TextureDescriptor {
    /// Reads and checks the descriptor of a section of that version.
    ///
    /// # Errors
    /// An unknown version, another length than 256 bytes, reserved bytes that are not zero, what the version does not
    /// have, or whatever [`Self::check`] refuses.
    pub fn parse(bytes: &[u8], version: u16) -> Result<Self, DescriptorError> {
        if !(1..=SECTION_VERSION).contains(&version) {
            return Err(DescriptorError::Version { found: version });
        }
        if bytes.len() != DESCRIPTOR_BYTES {
            return Err(DescriptorError::Length { found: bytes.len() as u64 });
        }
        let reserved_at = reserved_at(version);
        if let Some(at) = first_nonzero(&bytes[reserved_at..]) {
            return Err(DescriptorError::Reserved { offset: reserved_at + at });
        }
        let descriptor = Self::read(bytes)?;
        if version == 1 {
            descriptor.fits_version_1()?;
        }
        descriptor.check()?;
        Ok(descriptor)
    }

    /// The version of the section that can hold it: the oldest, so that old readers read what they can.
    #[must_use]
    pub fn section_version(&self) -> u16 {
        if self.fits_version_1().is_ok() { 1 } else { 2 }
    }

    fn read(bytes: &[u8]) -> Result<Self, DescriptorError> {
        macro_rules! term {
            ($kind:ident, $field:literal, $at:expr) => {{
                let found = u32_at(bytes, $at);
                let refused = DescriptorError::Enumeration { field: $field, found, accepted: $kind::ACCEPTED };
                $kind::from_number(found).ok_or(refused)?
            }};
        }
        Ok(Self {
            format: term!(Format, "vk_format", 0),
            width: u32_at(bytes, 4),
            height: u32_at(bytes, 8),
            layers: u32_at(bytes, 12),
            mips: u32_at(bytes, 16),
            semantic: term!(Semantic, "semantic", 20),
            unit: term!(Unit, "unit", 24),
            length_unit: term!(LengthUnit, "length_unit", 28),
            wrap_u: term!(Wrap, "wrap_u", 32),
            wrap_v: term!(Wrap, "wrap_v", 36),
            filter: term!(Filter, "filter", 40),
            mip_reducer: term!(MipReducer, "mip_reducer", 44),
            scale: f64_at(bytes, 48),
            bias: f64_at(bytes, 56),
            range_min: f64_at(bytes, 64),
            range_max: f64_at(bytes, 72),
            worst_case_error: f64_at(bytes, 80),
            spacing_u: f64_at(bytes, 88),
            spacing_v: f64_at(bytes, 96),
            first_azimuth: f64_at(bytes, 104),
            azimuth_step: f64_at(bytes, 112),
            search_radius: f64_at(bytes, 120),
            transfer: term!(Transfer, "transfer", TRANSFER_AT),
            candidates: u32_at(bytes, CANDIDATES_AT),
            curvature_min: f64_at(bytes, CURVATURE_AT),
            curvature_max: f64_at(bytes, CURVATURE_AT + 8),
        })
    }

    /// The 256 bytes of the descriptor. Nothing is checked.
    #[must_use]
    pub fn to_bytes(&self) -> [u8; DESCRIPTOR_BYTES] {
        let words = [
            self.format.number(),
            self.width,
            self.height,
            self.layers,
            self.mips,
            self.semantic.number(),
            self.unit.number(),
            self.length_unit.number(),
            self.wrap_u.number(),
            self.wrap_v.number(),
            self.filter.number(),
            self.mip_reducer.number(),
        ];
        let reals = [
            self.scale,
            self.bias,
            self.range_min,
            self.range_max,
            self.worst_case_error,
            self.spacing_u,
            self.spacing_v,
            self.first_azimuth,
            self.azimuth_step,
            self.search_radius,
        ];
        let mut bytes = [0; DESCRIPTOR_BYTES];
        for (i, word) in words.into_iter().enumerate() {
            put(&mut bytes, 4 * i, &word.to_le_bytes());
        }
        for (i, real) in reals.into_iter().enumerate() {
            put(&mut bytes, 48 + 8 * i, &real.to_le_bytes());
        }
        put(&mut bytes, TRANSFER_AT, &self.transfer.number().to_le_bytes());
        put(&mut bytes, CANDIDATES_AT, &self.candidates.to_le_bytes());
        put(&mut bytes, CURVATURE_AT, &self.curvature_min.to_le_bytes());
        put(&mut bytes, CURVATURE_AT + 8, &self.curvature_max.to_le_bytes());
        bytes
    }

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
        let count = self.layers / self.candidates.max(1);
        self.semantic.is_directional().then(|| Azimuths::from_parts(self.first_azimuth, self.azimuth_step, count))
    }

    /// Numbers in one layer: texels times channels.
    #[must_use]
    pub fn layer_values(&self) -> u64 {
        u64::from(self.width) * u64::from(self.height) * u64::from(self.format.channels())
    }

    /// Bytes of one row of texels.
    #[must_use]
    pub fn row_bytes(&self) -> u64 {
        u64::from(self.width) * u64::from(self.format.texel_bytes())
    }

    /// Bytes of one layer: its rows, tight.
    #[must_use]
    pub fn layer_bytes(&self) -> u64 {
        self.row_bytes() * u64::from(self.height)
    }

    /// Bytes from the start of one layer to the start of the next: a multiple of 256.
    #[must_use]
    pub fn layer_stride(&self) -> u64 {
        // At most 2³⁶ for a checked descriptor, so aligning cannot overflow; one that was not checked saturates.
        align_up(self.layer_bytes(), CHUNK_ALIGN).unwrap_or(u64::MAX)
    }

    /// Offset of a layer in the decoded payload.
    #[must_use]
    pub fn layer_offset(&self, layer: u32) -> u64 {
        self.layer_stride().saturating_mul(u64::from(layer))
    }

    /// Bytes of the decoded payload: all layers, padded between but not behind the last.
    #[must_use]
    pub fn payload_length(&self) -> u64 {
        self.layer_offset(self.layers.saturating_sub(1)).saturating_add(self.layer_bytes())
    }
}
