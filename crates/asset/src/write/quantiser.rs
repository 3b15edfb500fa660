//! The numbers of a quantiser: scale and bias that f32 holds exactly, and the nearest code of a value.

use core::ops::RangeInclusive;

use super::encode::{EncodeError, Encoding};
use crate::{Format, f32_at_least, f32_at_most};

/// `value = scale · stored + bias`, for one format.
#[derive(Debug, Clone, Copy)]
pub(super) struct Quantiser {
    pub(super) format: Format,
    pub(super) scale: f32,
    pub(super) bias: f32,
}

impl Quantiser {
    /// The quantiser of values from `min` to `max`, whose decoded values stay within `legal`.
    pub(super) fn new(
        encoding: Encoding,
        (min, max): (f32, f32),
        legal: &RangeInclusive<f32>,
    ) -> Result<Self, EncodeError> {
        let format = encoding.format();
        if format == Format::R32Float {
            return Ok(Self { format, scale: 1.0, bias: 0.0 });
        }
        if min == max {
            return Ok(Self { format, scale: 0.0, bias: min });
        }
        let (low, high) = (f64::from(min), f64::from(max));
        let bias = if format == Format::R8Unorm { min } else { (0.5 * (low + high)) as f32 };
        let centre = f64::from(bias);
        // Wide enough for both ends …
        let mut scale = f32_at_least((high - centre).max(centre - low));
        if scale.is_infinite() {
            return Err(EncodeError::TooWide { min, max, encoding: encoding.name() });
        }
        // … but no wider than the legal range, where rounding upwards would leave it.
        scale = scale.min(f32_at_most(f64::from(*legal.end()) - centre));
        if format == Format::R16Float {
            scale = scale.min(f32_at_most(centre - f64::from(*legal.start())));
        }
        Ok(Self { format, scale, bias })
    }

    /// Appends the stored form of `value`.
    pub(super) fn put(&self, value: f32, out: &mut std::vec::Vec<u8>) {
        match self.format {
            Format::R8Unorm => out.push((255.0 * self.normalised(value).max(0.0)).round_ties_even() as u8),
            Format::R16Float => out.extend_from_slice(&f16_of_unit(self.normalised(value)).to_le_bytes()),
            Format::R32Float => out.extend_from_slice(&value.to_le_bytes()),
        }
    }

    /// The stored number that would be exact, in [−1, 1].
    fn normalised(&self, value: f32) -> f64 {
        if self.scale == 0.0 {
            return 0.0;
        }
        ((f64::from(value) - f64::from(self.bias)) / f64::from(self.scale)).clamp(-1.0, 1.0)
    }

    /// No decoded value is farther than this from the value encoded: half a code step, and f32 arithmetic, fused or
    /// not, with subnormals kept or flushed. `formats/height-v1.md` derives it.
    pub(super) fn worst_case_error(&self) -> f64 {
        let half_step = match self.format {
            Format::R32Float => return 0.0,
            _ if self.scale == 0.0 => return 0.0,
            Format::R8Unorm => 1.0 / 510.0,
            Format::R16Float => power_of_two(-12),
        };
        let (scale, bias) = (f64::from(self.scale), f64::from(self.bias).abs());
        half_step * scale + power_of_two(-21) * (scale + bias) + power_of_two(-124)
    }
}

/// 2 to the power of `exponent`, exactly, for −1022 to 1023.
fn power_of_two(exponent: i64) -> f64 {
    f64::from_bits(((exponent + 1023) as u64) << 52)
}

/// The binary16 nearest to `value`, ties to even; `value` is in [−1, 1]. Bit arithmetic, so the same on every machine.
fn f16_of_unit(value: f64) -> u16 {
    let sign = ((value.to_bits() >> 48) & 0x8000) as u16;
    let magnitude = value.abs();
    let exponent = ((magnitude.to_bits() >> 52) as i64 - 1023).max(-14);
    // Multiplying by a power of two is exact; `mantissa` counts units in the last place and may carry upwards.
    let mantissa = (magnitude * power_of_two(10 - exponent)).round_ties_even() as u16;
    sign | ((exponent + 14) as u16 * 1024 + mantissa)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::half::f16_to_f32;

    #[test]
    fn every_half_in_the_unit_interval_is_its_own_nearest_half() {
        for bits in 0..=0x3C00_u16 {
            let value = f64::from(f16_to_f32(bits));
            assert_eq!(f16_of_unit(value), bits);
            assert_eq!(f16_of_unit(-value), bits | 0x8000);
        }
    }

    #[test]
    fn between_halves_the_nearer_one_wins_and_ties_go_to_even() {
        for bits in 0..0x3C00_u16 {
            let (low, high) = (f64::from(f16_to_f32(bits)), f64::from(f16_to_f32(bits + 1)));
            let middle = 0.5 * (low + high);
            assert_eq!(f16_of_unit(middle), bits + (bits & 1));
            assert_eq!(f16_of_unit(middle.next_down()), bits);
            assert_eq!(f16_of_unit(middle.next_up()), bits + 1);
        }
    }
}
