//! The 256 bytes that say what a table of texels is.

use core::f64::consts::{FRAC_PI_2, TAU};

use crate::bytes::{CHUNK_ALIGN, align_up, f64_at, first_nonzero, put, u32_at};
use crate::{DescriptorError, Filter, Format, LengthUnit, MipReducer, Semantic, Unit, Wrap};

/// The section version of every kind that this crate reads and writes.
pub const SECTION_VERSION: u16 = 1;
/// Bytes of a texture descriptor.
pub(crate) const DESCRIPTOR_BYTES: usize = 256;
/// The most texels along one axis.
pub const MAX_EXTENT: u32 = 65_536;
/// The most layers.
pub const MAX_LAYERS: u32 = 2048;

const RESERVED_AT: usize = 128;

/// What a table of texels is: extent, meaning, and how stored numbers become values.
///
/// `value = scale · stored + bias`; see [`crate::TableView`] for the arithmetic.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TextureDescriptor {
    /// How a texel is stored.
    pub format: Format,
    /// Texels along u, 1 to [`MAX_EXTENT`].
    pub width: u32,
    /// Texels along v, 1 to [`MAX_EXTENT`].
    pub height: u32,
    /// 1 for heights; for directional tables the number of azimuths, 1 to [`MAX_LAYERS`].
    pub layers: u32,
    /// Mip levels stored; always 1 in this version.
    pub mips: u32,
    /// What the texels mean.
    pub semantic: Semantic,
    /// The unit of decoded values: radian for elevations, else `length_unit`.
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
    /// Factor of stored numbers, ≥ 0 and exact as f32; 1 for `R32Float`, 0 for a constant table.
    pub scale: f64,
    /// Offset of decoded values, exact as f32; 0 for `R32Float`.
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
    /// Azimuth of layer 0 in radians; always 0 in this version.
    pub first_azimuth: f64,
    /// Azimuth from one layer to the next in radians, 2π / layers; 0 for heights.
    pub azimuth_step: f64,
    /// How far the horizon was searched, in `length_unit`, above 0; 0 for heights.
    pub search_radius: f64,
}

impl TextureDescriptor {
    /// Reads and checks the descriptor of section version 1.
    ///
    /// # Errors
    /// Another length than 256 bytes, reserved bytes that are not zero, or whatever [`Self::check`] refuses.
    pub fn parse(bytes: &[u8]) -> Result<Self, DescriptorError> {
        if bytes.len() != DESCRIPTOR_BYTES {
            return Err(DescriptorError::Length { found: bytes.len() as u64 });
        }
        if let Some(at) = first_nonzero(&bytes[RESERVED_AT..]) {
            return Err(DescriptorError::Reserved { offset: RESERVED_AT + at });
        }
        let descriptor = Self::read(bytes)?;
        descriptor.check()?;
        Ok(descriptor)
    }

    fn read(bytes: &[u8]) -> Result<Self, DescriptorError> {
        macro_rules! term {
            ($kind:ident, $field:literal, $at:literal) => {{
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
        bytes
    }

    /// Whether every field is within the format and all agree with each other.
    ///
    /// # Errors
    /// The first field that does not, with its value and what would be accepted.
    pub fn check(&self) -> Result<(), DescriptorError> {
        self.check_extent()?;
        self.check_unit()?;
        self.check_encoding()?;
        self.check_range()?;
        self.check_geometry()
    }

    fn check_extent(&self) -> Result<(), DescriptorError> {
        let max_layers = if self.semantic.is_directional() { MAX_LAYERS } else { 1 };
        for (field, found, max) in [
            ("width", self.width, MAX_EXTENT),
            ("height", self.height, MAX_EXTENT),
            ("layers", self.layers, max_layers),
            ("mips", self.mips, 1),
        ] {
            if found == 0 || found > max {
                return Err(DescriptorError::Extent { field, found, min: 1, max });
            }
        }
        Ok(())
    }

    fn check_unit(&self) -> Result<(), DescriptorError> {
        let (expected, accepted) = match self.semantic {
            Semantic::HorizonElevation => (Unit::Radian, "1 (radian) for elevations"),
            _ => (Unit::Length(self.length_unit), "the same number as length_unit"),
        };
        if self.unit != expected {
            return Err(DescriptorError::Enumeration { field: "unit", found: self.unit.number(), accepted });
        }
        Ok(())
    }

    fn check_encoding(&self) -> Result<(), DescriptorError> {
        let (scale, bias) = (self.scale, self.bias);
        if self.format == Format::R32Float {
            real("scale", scale, scale == 1.0, "1 for R32_SFLOAT")?;
            real("bias", bias, bias == 0.0, "0 for R32_SFLOAT")?;
        }
        real("scale", scale, is_f32(scale) && scale >= 0.0, "0 or more, finite and exact as f32")?;
        real("bias", bias, is_f32(bias), "finite and exact as f32")?;
        let error = self.worst_case_error;
        real("worst_case_error", error, error.is_finite() && error >= 0.0, "0 or more and finite")
    }

    fn check_range(&self) -> Result<(), DescriptorError> {
        let (min, max) = (self.range_min, self.range_max);
        real("range_min", min, is_f32(min), "finite and exact as f32")?;
        real("range_max", max, is_f32(max) && min <= max, "range_min or more, finite and exact as f32")?;
        match self.semantic {
            Semantic::Height => Ok(()),
            Semantic::HorizonElevation => {
                real("range_min", min, min > -FRAC_PI_2, "above −π/2")?;
                real("range_max", max, max < FRAC_PI_2, "below π/2")
            }
            Semantic::HorizonDistance => {
                real("range_min", min, min >= 0.0, "0 or more")?;
                real("range_max", max, max <= self.search_radius, "search_radius or less")
            }
        }
    }

    fn check_geometry(&self) -> Result<(), DescriptorError> {
        for (field, spacing) in [("spacing_u", self.spacing_u), ("spacing_v", self.spacing_v)] {
            real(field, spacing, (1e-30..=1e30).contains(&spacing), "1e-30 to 1e30")?;
        }
        let (step, radius) = (self.azimuth_step, self.search_radius);
        real("first_azimuth", self.first_azimuth, self.first_azimuth == 0.0, "0")?;
        if self.semantic.is_directional() {
            real("azimuth_step", step, step == TAU / f64::from(self.layers), "2π / layers")?;
            real("search_radius", radius, radius > 0.0 && radius <= f64::from(f32::MAX), "above 0 and within f32")
        } else {
            real("azimuth_step", step, step == 0.0, "0 for heights")?;
            real("search_radius", radius, radius == 0.0, "0 for heights")
        }
    }

    /// Refuses a table of another meaning.
    pub(crate) fn expect(&self, expected: Semantic) -> Result<(), DescriptorError> {
        if self.semantic != expected {
            return Err(DescriptorError::Semantic { found: self.semantic, expected });
        }
        Ok(())
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
        // At most 2³⁴ for a checked descriptor, so aligning cannot overflow; one that was not checked saturates.
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

fn is_f32(value: f64) -> bool {
    value.is_finite() && f64::from(value as f32) == value
}

fn real(field: &'static str, found: f64, holds: bool, accepted: &'static str) -> Result<(), DescriptorError> {
    if holds { Ok(()) } else { Err(DescriptorError::Number { field, found, accepted }) }
}
