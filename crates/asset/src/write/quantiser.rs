//! The numbers of a quantiser: scale and bias that f32 holds exactly, and the error they allow.
//!
//! A value v is stored through t, where v = transfer(t): t = v, sin v or √v. `formats/height-v1.md` derives the bounds.

use core::ops::RangeInclusive;

use super::codes;
use super::encode::{EncodeError, Encoding};
use super::facts::TableFacts;
use crate::angle::arcsine;
use crate::{Component, Transfer, f32_at_least, f32_at_most};

/// To which side of a value its stored form may lie.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Rounding {
    /// To the nearer one.
    Nearest,
    /// No decoded value is greater than what was given: lower bounds stay lower bounds.
    Down,
    /// No decoded value is less: upper bounds stay upper bounds.
    Up,
}

/// `value = transfer(scale · stored + bias)`, for one way to store numbers.
#[derive(Debug, Clone, Copy)]
pub(super) struct Quantiser {
    pub(super) component: Component,
    pub(super) transfer: Transfer,
    pub(super) rounding: Rounding,
    pub(super) scale: f32,
    pub(super) bias: f32,
    /// The greatest |t| there can be.
    largest: f32,
    /// Whether t is stored without any error.
    exact: bool,
}

impl Quantiser {
    /// The quantiser of the values of a table, all within `bounds`, whose decoded values are legal.
    pub(super) fn new(
        encoding: Encoding,
        facts: &TableFacts,
        bounds: &RangeInclusive<f32>,
    ) -> Result<Self, EncodeError> {
        let (semantic, rounding) = (facts.semantic(), facts.rounding());
        let (component, transfer) = (encoding.format(semantic).component(), encoding.transfer(semantic));
        let legal = legal_before(transfer, &facts.legal());
        // A zero is stored as +0, whichever of the two zeros came first.
        let [min, max] = [*bounds.start(), *bounds.end()].map(|value| {
            let mut t = codes::before_transfer(transfer, value).clamp(*legal.start(), *legal.end()) + 0.0;
            while rounding == Rounding::Down && transfer.value(t) > value {
                t = t.next_down();
            }
            t
        });
        let largest = min.abs().max(max.abs());
        let stored_as = |scale, bias| Self { component, transfer, rounding, scale, bias, largest, exact: false };
        if component == Component::Float32 {
            return Ok(Self { exact: true, ..stored_as(1.0, 0.0) });
        }
        if min == max {
            return Ok(Self { exact: transfer == Transfer::Identity, ..stored_as(0.0, min) });
        }
        let (low, high) = (f64::from(min), f64::from(max));
        let bias = if component == Component::Unorm8 { min } else { (0.5 * (low + high)) as f32 };
        let centre = f64::from(bias);
        // Wide enough for both ends …
        let mut scale = f32_at_least((high - centre).max(centre - low));
        if scale.is_infinite() {
            return Err(EncodeError::TooWide { min, max, encoding: encoding.name() });
        }
        if rounding == Rounding::Nearest {
            // … but no wider than the legal range, where rounding upwards would leave it.
            scale = scale.min(f32_at_most(f64::from(*legal.end()) - centre));
            if component == Component::Float16 {
                scale = scale.min(f32_at_most(centre - f64::from(*legal.start())));
            }
        }
        let quantiser = stored_as(scale, bias).with_room(bounds);
        if rounding == Rounding::Up && quantiser.value(1.0).is_infinite() {
            return Err(EncodeError::TooWide { min, max, encoding: encoding.name() });
        }
        Ok(quantiser)
    }

    /// Mends what rounding the scale upwards did to the ends of `bounds`: on the side to which values are rounded there
    /// must be a number for the end, and bytes that are rounded down should not lose their last one to it.
    fn with_room(self, bounds: &RangeInclusive<f32>) -> Self {
        let (wider, narrower) = (self.scale.next_up(), self.scale.next_down());
        let scale = match (self.rounding, self.component) {
            (Rounding::Up, _) if self.value(1.0) < *bounds.end() => wider,
            (Rounding::Down, Component::Float16) if self.value(-1.0) > *bounds.start() => wider,
            (Rounding::Down, Component::Unorm8) if self.value(1.0) > *bounds.end() => narrower,
            _ => self.scale,
        };
        Self { scale, ..self }
    }

    /// The quantiser of depths in [0, 1] that are stored as they are, whatever scale and bias of the table.
    pub(super) fn plain(encoding: Encoding, facts: &TableFacts) -> Self {
        let (component, rounding) = (encoding.format(facts.semantic()).component(), facts.rounding());
        let exact = component == Component::Float32;
        Self { component, transfer: Transfer::Identity, rounding, scale: 1.0, bias: 0.0, largest: 1.0, exact }
    }

    /// What a reader makes of a stored number, by exactly the arithmetic of [`crate::TableView`].
    pub(super) fn value(&self, stored: f32) -> f32 {
        self.transfer.value(self.scale * stored + self.bias)
    }

    /// No decoded value is farther than this from the value encoded: a code step or half of it, and f32 arithmetic, fused or
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
        if self.exact {
            return 0.0;
        }
        let step = match self.component {
            Component::Float32 => 0.0,
            Component::Unorm8 => 1.0 / 255.0,
            Component::Float16 => power_of_two(-11),
        };
        // To one side a step is lost where to the nearer one half of it is; and f32 arithmetic pushes to both sides.
        let part = if self.rounding == Rounding::Nearest { 0.5 } else { 1.0 };
        let (scale, bias) = (f64::from(self.scale), f64::from(self.bias).abs());
        part * (step * scale + power_of_two(-20) * (scale + bias)) + power_of_two(-124)
    }

    /// The value of every byte.
    pub(super) fn values_of_bytes(&self) -> [f32; 256] {
        core::array::from_fn(|k| self.value(k as f32 / 255.0))
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
