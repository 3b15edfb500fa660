//! The numbers of a quantiser: scale and bias that f32 holds exactly, and the error they allow.
//!
//! A value v is stored through t, where v = transfer(t): t = v, sin v or √v. `formats/height-v1.md` derives the bounds.

use core::ops::RangeInclusive;

use super::codes;
use super::encode::{EncodeError, Encoding};
use crate::angle::arcsine;
use crate::{Component, Semantic, Transfer, f32_at_least, f32_at_most};

/// `value = transfer(scale · stored + bias)`, for one way to store numbers.
#[derive(Debug, Clone, Copy)]
pub(super) struct Quantiser {
    pub(super) component: Component,
    pub(super) transfer: Transfer,
    pub(super) scale: f32,
    pub(super) bias: f32,
    /// The greatest |t| there can be.
    largest: f32,
}

impl Quantiser {
    /// The quantiser of values within `bounds`, whose decoded values stay within `legal`.
    pub(super) fn new(
        encoding: Encoding,
        semantic: Semantic,
        bounds: &RangeInclusive<f32>,
        legal: &RangeInclusive<f32>,
    ) -> Result<Self, EncodeError> {
        let (component, transfer) = (encoding.format(semantic).component(), encoding.transfer(semantic));
        let legal = legal_before(transfer, legal);
        // A zero is stored as +0, whichever of the two zeros came first.
        let [min, max] = [*bounds.start(), *bounds.end()]
            .map(|value| codes::before_transfer(transfer, value).clamp(*legal.start(), *legal.end()) + 0.0);
        let largest = min.abs().max(max.abs());
        let stored_as = |scale, bias| Self { component, transfer, scale, bias, largest };
        if component == Component::Float32 {
            return Ok(stored_as(1.0, 0.0));
        }
        if min == max {
            return Ok(stored_as(0.0, min));
        }
        let (low, high) = (f64::from(min), f64::from(max));
        let bias = if component == Component::Unorm8 { min } else { (0.5 * (low + high)) as f32 };
        let centre = f64::from(bias);
        // Wide enough for both ends …
        let mut scale = f32_at_least((high - centre).max(centre - low));
        if scale.is_infinite() {
            return Err(EncodeError::TooWide { min, max, encoding: encoding.name() });
        }
        // … but no wider than the legal range, where rounding upwards would leave it.
        scale = scale.min(f32_at_most(f64::from(*legal.end()) - centre));
        if component == Component::Float16 {
            scale = scale.min(f32_at_most(centre - f64::from(*legal.start())));
        }
        Ok(stored_as(scale, bias))
    }

    /// No decoded value is farther than this from the value encoded: half a code step, and f32 arithmetic, fused or
    /// not, with subnormals kept or flushed, through the transfer.
    pub(super) fn worst_case_error(&self) -> f64 {
        let (error, largest) = (self.error_before_transfer(), f64::from(self.largest));
        match self.transfer {
            Transfer::Identity => error,
            // The arcsine is steepest at the end that is nearest to ±1.
            Transfer::Sine => {
                let error = error + power_of_two(-21);
                let top = (largest + power_of_two(-20)).min(1.0);
                arcsine(top) - arcsine((top - error).max(-1.0)) + power_of_two(-22)
            }
            Transfer::Square => {
                error * (2.0 * largest + error) + power_of_two(-20) * largest * largest + power_of_two(-124)
            }
        }
    }

    fn error_before_transfer(&self) -> f64 {
        let half_step = match self.component {
            Component::Float32 => return 0.0,
            _ if self.scale == 0.0 && self.transfer == Transfer::Identity => return 0.0,
            Component::Unorm8 => 1.0 / 510.0,
            Component::Float16 => power_of_two(-12),
        };
        let (scale, bias) = (f64::from(self.scale), f64::from(self.bias).abs());
        half_step * scale + power_of_two(-21) * (scale + bias) + power_of_two(-124)
    }

    /// The value of every byte, by exactly the arithmetic of [`crate::TableView`].
    pub(super) fn values_of_bytes(&self) -> [f32; 256] {
        core::array::from_fn(|k| self.transfer.value(self.scale * (k as f32 / 255.0) + self.bias))
    }
}

/// What t may be, so that values are within `legal`.
fn legal_before(transfer: Transfer, legal: &RangeInclusive<f32>) -> RangeInclusive<f32> {
    match transfer {
        Transfer::Identity => legal.clone(),
        Transfer::Sine => -1.0..=1.0,
        Transfer::Square => {
            let mut greatest = legal.end().sqrt();
            while greatest * greatest > *legal.end() {
                greatest = greatest.next_down();
            }
            0.0..=greatest
        }
    }
}

/// 2 to the power of `exponent`, exactly, for −1022 to 1023.
fn power_of_two(exponent: i64) -> f64 {
    f64::from_bits(((exponent + 1023) as u64) << 52)
}
