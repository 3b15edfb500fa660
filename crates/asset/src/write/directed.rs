//! Codes of values that may only err to one side, so that what is decoded is still a bound.
//!
//! A code is judged by what a reader makes of it: all of f32's roundings on the way are allowed for by looking.

use super::codes;
use super::quantiser::{Quantiser, Rounding};

impl Rounding {
    /// Whether a value may be stored as what decodes to `decoded`.
    fn accepts(self, decoded: f32, value: f32) -> bool {
        match self {
            Self::Nearest => true,
            Self::Down => decoded <= value,
            Self::Up => decoded >= value,
        }
    }
}

/// Moves bytes that are the nearest to `values` to the side that the quantiser rounds to.
pub(super) fn correct_bytes(quantiser: &Quantiser, values_of_bytes: &[f32; 256], values: &[f32], codes: &mut [u8]) {
    let (rounding, end) = (quantiser.rounding, if quantiser.rounding == Rounding::Up { u8::MAX } else { 0 });
    for (code, &value) in codes.iter_mut().zip(values) {
        while *code != end && !rounding.accepts(values_of_bytes[usize::from(*code)], value) {
            *code = if rounding == Rounding::Up { *code + 1 } else { *code - 1 };
        }
    }
}

/// The halves nearest to `values` on the side that the quantiser rounds to; `numbers` are the values before the transfer.
pub(super) fn to_halves(quantiser: &Quantiser, values: &[f32], numbers: &[f32], codes: &mut [u16]) {
    for (code, (&value, &t)) in codes.iter_mut().zip(values.iter().zip(numbers)) {
        *code = half(quantiser, value, t);
    }
}

fn half(quantiser: &Quantiser, value: f32, t: f32) -> u16 {
    let (scale, bias) = (f64::from(quantiser.scale), f64::from(quantiser.bias));
    if scale == 0.0 {
        return 0;
    }
    let end = if quantiser.rounding == Rounding::Up { 1.0 } else { -1.0 };
    // What a reader's product and sum may be off by, in units of the scale.
    let step = end * f64::from(f32::EPSILON) * (1.0 + bias.abs() / scale);
    let mut normalised = ((f64::from(t) - bias) / scale).clamp(-1.0, 1.0);
    loop {
        let code = half_beside(normalised, quantiser.rounding);
        let decoded = quantiser.value(codes::value_of_half(code));
        // The quantiser's own end always does; elsewhere a turn or two are enough.
        if quantiser.rounding.accepts(decoded, value) || normalised == end {
            return code;
        }
        normalised = (normalised + step).clamp(-1.0, 1.0);
    }
}

/// The binary16 nearest to `x`, in [−1, 1], on that side.
fn half_beside(x: f64, rounding: Rounding) -> u16 {
    match rounding {
        Rounding::Nearest => codes::nearest_half(x),
        Rounding::Down => half_at_most(x),
        Rounding::Up => half_at_most(-x) ^ 0x8000,
    }
}

/// The greatest binary16 that is not above `x`.
fn half_at_most(x: f64) -> u16 {
    let nearest = codes::nearest_half(x);
    if f64::from(codes::value_of_half(nearest)) <= x {
        return nearest;
    }
    match nearest {
        // Below either zero is the least negative half.
        0 | 0x8000 => 0x8001,
        // The bits of negative halves grow as their values fall.
        negative if negative & 0x8000 != 0 => negative + 1,
        positive => positive - 1,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::half::f16_to_f32;

    #[test]
    fn a_half_beside_a_number_is_the_last_on_its_side() {
        // Ordered: every half from −1 to 1 but −0, and what lies beside it.
        let ordered: std::vec::Vec<f64> = (1..=0x3C00_u16)
            .rev()
            .map(|bits| -f64::from(f16_to_f32(bits)))
            .chain((0..=0x3C00).map(|bits| f64::from(f16_to_f32(bits))))
            .collect();
        let value = |code| f64::from(codes::value_of_half(code));
        for pair in ordered.windows(2) {
            let (low, high) = (pair[0], pair[1]);
            for x in [low, low.next_up(), 0.5 * (low + high), high.next_down()] {
                assert_eq!(value(half_beside(x, Rounding::Down)), low, "{x}");
            }
            for x in [low.next_up(), 0.5 * (low + high), high.next_down(), high] {
                assert_eq!(value(half_beside(x, Rounding::Up)), high, "{x}");
            }
        }
    }
}
