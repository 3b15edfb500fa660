//! Values to stored bytes, with the error that costs.

use core::ops::RangeInclusive;
use std::vec::Vec;

use super::quantiser::Quantiser;
use crate::bytes::CHUNK_ALIGN;
use crate::half::f16_to_f32;
use crate::{Format, bytes};

/// How values are stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Encoding {
    /// As they are: 4 bytes, exact, not filterable on every GPU.
    F32,
    /// 2 bytes; error at most 2⁻¹² of half the table's range, and rounding.
    F16,
    /// 1 byte; error at most 1/510 of the table's range, and rounding.
    U8,
}

impl Encoding {
    /// Every encoding, the most exact first.
    pub const ALL: [Self; 3] = [Self::F32, Self::F16, Self::U8];

    /// `f32`, `f16` or `u8`, as in recipes and on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::F16 => "f16",
            Self::U8 => "u8",
        }
    }

    /// The texel format that stores it.
    #[must_use]
    pub fn format(self) -> Format {
        match self {
            Self::F32 => Format::R32Float,
            Self::F16 => Format::R16Float,
            Self::U8 => Format::R8Unorm,
        }
    }
}

/// Why values could not be encoded.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum EncodeError {
    /// The number of values does not follow from the extent.
    #[error("there are {found} values; the extent asks for {expected}")]
    Count {
        /// Values given.
        found: u64,
        /// Values the extent asks for.
        expected: u64,
    },
    /// A value is NaN, infinite or outside what the table may hold.
    #[error("value {index} is {value}; {min} to {max} is accepted")]
    Value {
        /// Its place among the values.
        index: usize,
        /// The value.
        value: f32,
        /// The least value accepted.
        min: f32,
        /// The greatest value accepted.
        max: f32,
    },
    /// The range has no scale in f32.
    #[error("{encoding} cannot hold values from {min} to {max}: their difference is beyond f32; f32 is accepted")]
    TooWide {
        /// The least value.
        min: f32,
        /// The greatest value.
        max: f32,
        /// The encoding asked for.
        encoding: &'static str,
    },
    /// The facts about the table are outside the format.
    #[error(transparent)]
    Descriptor(#[from] crate::DescriptorError),
}

/// Values in their stored form, and all a descriptor says about them.
#[derive(Debug, Clone, PartialEq)]
pub struct Encoded {
    /// All layers, each starting at a multiple of 256 bytes, zeros between.
    pub bytes: Vec<u8>,
    /// How a texel is stored.
    pub format: Format,
    /// Factor of stored numbers; exact as f32.
    pub scale: f32,
    /// Offset of decoded values; exact as f32.
    pub bias: f32,
    /// The least and the greatest decoded value, in the unit of the values.
    pub range: (f32, f32),
    /// No decoded value is farther than this from the value given, in the unit of the values.
    pub worst_case_error: f64,
}

/// Encodes `values`: `layers` layers of `layer_texels` each, tight. Decoded values are within `legal` too.
///
/// # Errors
/// A wrong number of values, none at all, a value that is not within `legal` (NaN never is), or a range whose scale is
/// beyond f32.
pub fn encode(
    values: &[f32],
    layers: u32,
    layer_texels: u64,
    encoding: Encoding,
    legal: RangeInclusive<f32>,
) -> Result<Encoded, EncodeError> {
    let expected = layer_texels.saturating_mul(u64::from(layers));
    let found = values.len() as u64;
    if found != expected || found == 0 {
        return Err(EncodeError::Count { found, expected });
    }
    let extent = extent(values, &legal)?;
    let quantiser = Quantiser::new(encoding, extent, &legal)?;
    Ok(Encoded {
        bytes: store(values, layer_texels as usize, &quantiser),
        format: quantiser.format,
        scale: quantiser.scale,
        bias: quantiser.bias,
        // Quantising and decoding both preserve order, so the ends decode to the ends.
        range: (decoded(&quantiser, extent.0), decoded(&quantiser, extent.1)),
        worst_case_error: quantiser.worst_case_error(),
    })
}

/// The least and the greatest value, all of them legal.
fn extent(values: &[f32], legal: &RangeInclusive<f32>) -> Result<(f32, f32), EncodeError> {
    let (mut min, mut max) = (f32::INFINITY, f32::NEG_INFINITY);
    for (index, &value) in values.iter().enumerate() {
        if !value.is_finite() || !legal.contains(&value) {
            return Err(EncodeError::Value { index, value, min: *legal.start(), max: *legal.end() });
        }
        min = min.min(value);
        max = max.max(value);
    }
    Ok((min, max))
}

fn store(values: &[f32], layer_texels: usize, quantiser: &Quantiser) -> Vec<u8> {
    let texel_bytes = quantiser.format.texel_bytes() as usize;
    let stride = bytes::align_up((layer_texels * texel_bytes) as u64, CHUNK_ALIGN).unwrap_or(u64::MAX) as usize;
    let mut out = Vec::with_capacity(stride * (values.len() / layer_texels));
    for (k, layer) in values.chunks_exact(layer_texels).enumerate() {
        out.resize(k * stride, 0);
        for &value in layer {
            quantiser.put(value, &mut out);
        }
    }
    out
}

/// What `value` is after storing and decoding, as [`crate::TableView`] decodes.
fn decoded(quantiser: &Quantiser, value: f32) -> f32 {
    let mut texel = Vec::with_capacity(4);
    quantiser.put(value, &mut texel);
    match quantiser.format {
        Format::R8Unorm => quantiser.scale * (f32::from(texel[0]) / 255.0) + quantiser.bias,
        Format::R16Float => quantiser.scale * f16_to_f32(bytes::u16_at(&texel, 0)) + quantiser.bias,
        Format::R32Float => value,
    }
}
