//! A descriptor to its 256 bytes and back.

use core::ops::Range;

use super::{DESCRIPTOR_BYTES, SECTION_VERSION, TextureDescriptor};
use crate::bytes::{f64_at, first_nonzero, put, u32_at};
use crate::{
    DepthMode, DescriptorError, Filter, Format, LengthUnit, MipReducer, RingSpacing, Semantic, Transfer, Unit, Wrap,
};

const TRANSFER_AT: usize = 128;
const CANDIDATES_AT: usize = 132;
const CURVATURE_AT: usize = 136;
const RINGS_AT: usize = 152;
const MAX_POLAR_AT: usize = 168;
const RELIEF_AT: usize = 176;

/// The bytes that are zero in a descriptor of that version.
fn reserved(version: u16) -> [Range<usize>; 2] {
    match version {
        1 => [TRANSFER_AT..DESCRIPTOR_BYTES, 0..0],
        2 => [RINGS_AT..DESCRIPTOR_BYTES, 0..0],
        _ => [RINGS_AT + 12..MAX_POLAR_AT, RELIEF_AT + 16..DESCRIPTOR_BYTES],
    }
}

impl TextureDescriptor {
    /// Reads and checks the descriptor of a section of that version.
    ///
    /// # Errors
    /// An unknown version, another length than 256 bytes, reserved bytes that are not zero, what the version does not
    /// have, or whatever [`Self::check`] refuses.
    pub fn parse(bytes: &[u8], version: u16) -> Result<Self, DescriptorError> {
        if !(1..=SECTION_VERSION).contains(&version) {
            return Err(DescriptorError::Version { found: version, newest: SECTION_VERSION });
        }
        if bytes.len() != DESCRIPTOR_BYTES {
            return Err(DescriptorError::Length { found: bytes.len() as u64 });
        }
        for reserved in reserved(version) {
            if let Some(at) = first_nonzero(&bytes[reserved.clone()]) {
                return Err(DescriptorError::Reserved { offset: reserved.start + at });
            }
        }
        let descriptor = Self::read(bytes)?;
        descriptor.fits(version)?;
        descriptor.check()?;
        Ok(descriptor)
    }

    /// The version of the section that can hold it: the oldest, so that old readers read what they can.
    #[must_use]
    pub fn section_version(&self) -> u16 {
        (1..SECTION_VERSION).find(|&version| self.fits(version).is_ok()).unwrap_or(SECTION_VERSION)
    }

    fn read(bytes: &[u8]) -> Result<Self, DescriptorError> {
        macro_rules! term {
            ($kind:ident, $field:literal, $at:expr) => {{
                let found = u32_at(bytes, $at);
                let refused = DescriptorError::Enumeration { field: $field, found, accepted: $kind::ACCEPTED };
                $kind::from_number(found).ok_or(refused)?
            }};
            // 0 is none.
            (optional $kind:ident, $field:literal, $at:expr) => {
                if u32_at(bytes, $at) == 0 { None } else { Some(term!($kind, $field, $at)) }
            };
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
            rings: u32_at(bytes, RINGS_AT),
            ring_spacing: term!(optional RingSpacing, "ring_spacing", RINGS_AT + 4),
            depth_mode: term!(optional DepthMode, "depth_mode", RINGS_AT + 8),
            max_polar: f64_at(bytes, MAX_POLAR_AT),
            relief_top: f64_at(bytes, RELIEF_AT),
            relief_thickness: f64_at(bytes, RELIEF_AT + 8),
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
        self.put_what_later_versions_say(&mut bytes);
        bytes
    }

    fn put_what_later_versions_say(&self, bytes: &mut [u8]) {
        for (at, word) in [
            (TRANSFER_AT, self.transfer.number()),
            (CANDIDATES_AT, self.candidates),
            (RINGS_AT, self.rings),
            (RINGS_AT + 4, self.ring_spacing.map_or(0, RingSpacing::number)),
            (RINGS_AT + 8, self.depth_mode.map_or(0, DepthMode::number)),
        ] {
            put(bytes, at, &word.to_le_bytes());
        }
        for (at, real) in [
            (CURVATURE_AT, self.curvature_min),
            (CURVATURE_AT + 8, self.curvature_max),
            (MAX_POLAR_AT, self.max_polar),
            (RELIEF_AT, self.relief_top),
            (RELIEF_AT + 8, self.relief_thickness),
        ] {
            put(bytes, at, &real.to_le_bytes());
        }
    }
}
