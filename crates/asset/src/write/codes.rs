//! The loops that every value of a table goes through: transfer, code, decode. Free of branches, so that the compiler
//! makes vectors of them; correctly rounded or bit for bit the same on every machine.
//!
//! Adding 1½ · 2⁵² to a small f64 rounds it to an integer, ties to even, and leaves that integer in the lowest bits.

use super::quantiser::Quantiser;
use crate::Transfer;

/// 1½ · 2⁵².
const INTEGER: f64 = 6_755_399_441_055_744.0;
/// The exponent bits of 2⁻¹⁴, below which halves are subnormal.
const LEAST_EXPONENT: u64 = 1023 - 14;

/// The sine's Taylor coefficients of the third to the thirteenth power.
const SINE: [f32; 6] =
    [-1.0 / 6.0, 1.0 / 120.0, -1.0 / 5040.0, 1.0 / 362_880.0, -1.0 / 39_916_800.0, 1.0 / 6_227_020_800.0];

/// t, of which `value` is the transfer: the value, its sine to 2⁻²², or its root.
#[inline]
pub(super) fn before_transfer(transfer: Transfer, value: f32) -> f32 {
    match transfer {
        Transfer::Identity => value,
        Transfer::Sine => sine(value),
        Transfer::Square => value.sqrt(),
    }
}

/// [`before_transfer`] of many values.
pub(super) fn all_before_transfer(transfer: Transfer, values: &[f32], out: &mut [f32]) {
    let pairs = out.iter_mut().zip(values);
    match transfer {
        Transfer::Identity => pairs.for_each(|(t, &value)| *t = value),
        Transfer::Sine => pairs.for_each(|(t, &value)| *t = sine(value)),
        Transfer::Square => pairs.for_each(|(t, &value)| *t = value.sqrt()),
    }
}

/// The sine of an angle in [−π/2, π/2], in radians, to 2⁻²²; f32 all the way, for speed.
#[inline]
fn sine(angle: f32) -> f32 {
    let square = angle * angle;
    let [c3, c5, c7, c9, c11, c13] = SINE;
    let series = c3 + square * (c5 + square * (c7 + square * (c9 + square * (c11 + square * c13))));
    angle + angle * (square * series)
}

/// The bytes nearest to `numbers`, ties to even.
pub(super) fn to_bytes(quantiser: &Quantiser, numbers: &[f32], codes: &mut [u8]) {
    if quantiser.scale == 0.0 {
        return codes.fill(0);
    }
    let (scale, bias) = (f64::from(quantiser.scale), f64::from(quantiser.bias));
    for (code, &t) in codes.iter_mut().zip(numbers) {
        let normalised = between((f64::from(t) - bias) / scale, 0.0, 1.0);
        *code = (255.0 * normalised + INTEGER).to_bits() as u8;
    }
}

/// The halves nearest to `numbers`, ties to even.
pub(super) fn to_halves(quantiser: &Quantiser, numbers: &[f32], codes: &mut [u16]) {
    if quantiser.scale == 0.0 {
        return codes.fill(0);
    }
    let (scale, bias) = (f64::from(quantiser.scale), f64::from(quantiser.bias));
    for (code, &t) in codes.iter_mut().zip(numbers) {
        *code = nearest_half(between((f64::from(t) - bias) / scale, -1.0, 1.0));
    }
}

/// What a shader makes of those halves, before the transfer.
pub(super) fn from_halves(quantiser: &Quantiser, codes: &[u16], numbers: &mut [f32]) {
    let (scale, bias) = (quantiser.scale, quantiser.bias);
    for (t, &code) in numbers.iter_mut().zip(codes) {
        *t = scale * value_of_half(code) + bias;
    }
}

/// `clamp` as one minimum and one maximum; `x` is not NaN.
#[inline]
fn between(x: f64, low: f64, high: f64) -> f64 {
    let x = if x > low { x } else { low };
    if x < high { x } else { high }
}

/// The binary16 nearest to `x`, ties to even. `x` is no larger than the greatest finite half, 65504.
#[inline]
pub(super) fn nearest_half(x: f64) -> u16 {
    let least = f64::from_bits(LEAST_EXPONENT << 52);
    let (sign, size) = ((x.to_bits() >> 48) as u16 & 0x8000, x.abs());
    let exponent = (if size > least { size } else { least }).to_bits() >> 52;
    // Scaling by a power of two is exact; the mantissa counts units in the last place and may carry upwards.
    let units = size * f64::from_bits((2 * 1023 + 10 - exponent) << 52);
    let mantissa = (units + INTEGER).to_bits() as u16;
    sign | (((exponent - LEAST_EXPONENT) as u16) << 10).wrapping_add(mantissa)
}

/// The value of a finite binary16.
#[inline]
pub(super) fn value_of_half(code: u16) -> f32 {
    let size = u32::from(code & 0x7FFF);
    let subnormal = (size as i32 as f32) * f32::from_bits((127 - 24) << 23);
    let normal = f32::from_bits((size << 13) + (112 << 23));
    let size = if size < 0x400 { subnormal } else { normal };
    f32::from_bits(size.to_bits() | u32::from(code & 0x8000) << 16)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::MAX_ELEVATION;
    use crate::half::f16_to_f32;

    #[test]
    fn every_half_in_the_unit_interval_is_its_own_nearest_half() {
        for bits in 0..=0x3C00_u16 {
            let value = f64::from(f16_to_f32(bits));
            assert_eq!(nearest_half(value), bits);
            assert_eq!(nearest_half(-value), bits | 0x8000);
        }
    }

    #[test]
    fn between_halves_the_nearer_one_wins_and_ties_go_to_even() {
        for bits in 0..0x3C00_u16 {
            let (low, high) = (f64::from(f16_to_f32(bits)), f64::from(f16_to_f32(bits + 1)));
            let middle = 0.5 * (low + high);
            assert_eq!(nearest_half(middle), bits + (bits & 1));
            assert_eq!(nearest_half(middle.next_down()), bits);
            assert_eq!(nearest_half(middle.next_up()), bits + 1);
        }
    }

    #[test]
    fn finite_halves_have_the_value_that_a_reader_reads() {
        for bits in (0..=u16::MAX).filter(|bits| bits & 0x7C00 != 0x7C00) {
            assert_eq!(value_of_half(bits).to_bits(), f16_to_f32(bits).to_bits(), "{bits:#06x}");
        }
    }

    #[test]
    fn the_fast_sine_is_right_to_a_quarter_of_a_millionth() {
        for bits in (0..=MAX_ELEVATION.to_bits()).step_by(97).chain([MAX_ELEVATION.to_bits()]) {
            let angle = f32::from_bits(bits);
            let error = f64::from(sine(angle)) - f64::from(angle).sin();
            assert!(error.abs() < 0.5_f64.powi(22), "sin {angle}: {error}");
            assert_eq!(sine(-angle), -sine(angle));
        }
    }
}
