//! The values of a table, or of one of its channels, to stored bytes.

use core::ops::RangeInclusive;
use std::vec::Vec;

use super::codes;
use super::directed;
use super::encode::EncodeError;
use super::loss::LayerMeasure;
use super::quantiser::{Quantiser, Rounding};
use crate::Component;

/// Values that are worked on together, so that what lies between two loops stays in the first cache.
const BLOCK: usize = 1024;

/// How numbers of one kind are stored.
#[derive(Debug, Clone)]
pub(super) struct NumberEncoder {
    quantiser: Quantiser,
    values_of_bytes: [f32; 256],
    bounds: RangeInclusive<f32>,
}

impl NumberEncoder {
    /// An encoder of values within `bounds`.
    pub(super) fn new(quantiser: Quantiser, bounds: RangeInclusive<f32>) -> Self {
        Self { values_of_bytes: quantiser.values_of_bytes(), quantiser, bounds }
    }

    pub(super) fn quantiser(&self) -> &Quantiser {
        &self.quantiser
    }

    /// Refuses the first value that is NaN or out of bounds.
    pub(super) fn check(&self, values: &[f32]) -> Result<(), EncodeError> {
        check_values(values, &self.bounds)
    }

    /// Appends the stored form of values that were checked.
    pub(super) fn encode(&self, values: &[f32], bytes: &mut Vec<u8>, measure: &mut LayerMeasure) {
        bytes.reserve(values.len() * self.quantiser.component.bytes() as usize);
        for block in values.chunks(BLOCK) {
            match self.quantiser.component {
                Component::Unorm8 => self.bytes_of(block, bytes, measure),
                Component::Float16 => self.halves_of(block, bytes, measure),
                Component::Float32 => floats_of(block, bytes, measure),
            }
        }
    }

    fn bytes_of(&self, values: &[f32], bytes: &mut Vec<u8>, measure: &mut LayerMeasure) {
        let (mut numbers, mut codes) = ([0.0; BLOCK], [0; BLOCK]);
        let (numbers, codes) = (&mut numbers[..values.len()], &mut codes[..values.len()]);
        codes::all_before_transfer(self.quantiser.transfer, values, numbers);
        codes::to_bytes(&self.quantiser, numbers, codes);
        if self.quantiser.rounding != Rounding::Nearest {
            directed::correct_bytes(&self.quantiser, &self.values_of_bytes, values, codes);
        }
        bytes.extend_from_slice(codes);
        for (decoded, &code) in numbers.iter_mut().zip(&*codes) {
            *decoded = self.values_of_bytes[usize::from(code)];
        }
        measure.add(values, numbers);
    }

    fn halves_of(&self, values: &[f32], bytes: &mut Vec<u8>, measure: &mut LayerMeasure) {
        let (mut numbers, mut codes) = ([0.0; BLOCK], [0; BLOCK]);
        let (numbers, codes) = (&mut numbers[..values.len()], &mut codes[..values.len()]);
        codes::all_before_transfer(self.quantiser.transfer, values, numbers);
        if self.quantiser.rounding == Rounding::Nearest {
            codes::to_halves(&self.quantiser, numbers, codes);
        } else {
            directed::to_halves(&self.quantiser, values, numbers, codes);
        }
        bytes.extend(codes.iter().flat_map(|code| code.to_le_bytes()));
        codes::from_halves(&self.quantiser, codes, numbers);
        for decoded in numbers.iter_mut() {
            *decoded = self.quantiser.transfer.value(*decoded);
        }
        measure.add(values, numbers);
    }
}

fn floats_of(values: &[f32], bytes: &mut Vec<u8>, measure: &mut LayerMeasure) {
    bytes.extend(values.iter().flat_map(|value| value.to_le_bytes()));
    measure.add(values, values);
}

/// Refuses the first value that is NaN or out of bounds.
pub(super) fn check_values(values: &[f32], bounds: &RangeInclusive<f32>) -> Result<(), EncodeError> {
    let (min, max) = (*bounds.start(), *bounds.end());
    // Looking at all of them without a branch is what vectors are for; the culprit is only looked for if there is one.
    let good = |value: f32| (value >= min) & (value <= max);
    if values.chunks(BLOCK).all(|block| block.iter().fold(true, |all, &value| all & good(value))) {
        return Ok(());
    }
    match values.iter().position(|&value| !good(value)) {
        Some(index) => Err(EncodeError::Value { index, value: values[index], min, max }),
        None => Ok(()),
    }
}
