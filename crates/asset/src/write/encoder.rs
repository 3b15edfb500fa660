//! Values to stored bytes, a layer at a time, with the error that costs.

use core::ops::RangeInclusive;
use std::vec;
use std::vec::Vec;

use super::codes;
use super::encode::{EncodeError, Encoding};
use super::facts::TableFacts;
use super::loss::{self, EncodingLoss, LayerMeasure};
use super::quantiser::Quantiser;
use crate::{Component, TextureDescriptor};

/// Values that are worked on together, so that what lies between two loops stays in the first cache.
const BLOCK: usize = 1024;

/// Encodes the layers of one table as they come, in any order, and measures what that costs.
///
/// What must be known beforehand are bounds of the values; the tighter, the smaller the error. Nothing of the size of a
/// table is held. The same layers give the same descriptor and loss, whatever the order and on whichever thread they
/// were encoded.
#[derive(Debug, Clone)]
pub struct TableEncoder {
    /// Complete but for the range.
    descriptor: TextureDescriptor,
    quantiser: Quantiser,
    values_of_bytes: [f32; 256],
    bounds: RangeInclusive<f32>,
    measures: Vec<Option<LayerMeasure>>,
}

impl TableEncoder {
    /// An encoder of a table whose values are all within `bounds`, in their own unit.
    ///
    /// # Errors
    /// Facts outside the format, or bounds that are no range or leave [`TableFacts::legal`].
    pub fn new(facts: &TableFacts, encoding: Encoding, bounds: RangeInclusive<f32>) -> Result<Self, EncodeError> {
        let mut descriptor = facts.descriptor(encoding);
        // Facts first: a wrong extent must be refused before anything is allocated for it.
        descriptor.check()?;
        let (legal, min, max) = (facts.legal(), *bounds.start(), *bounds.end());
        if !(legal.contains(&min) && legal.contains(&max) && min <= max) {
            return Err(EncodeError::Bounds { min, max, legal_min: *legal.start(), legal_max: *legal.end() });
        }
        let quantiser = Quantiser::new(encoding, facts.semantic(), &bounds, &legal)?;
        descriptor.scale = f64::from(quantiser.scale);
        descriptor.bias = f64::from(quantiser.bias);
        descriptor.worst_case_error = quantiser.worst_case_error();
        let values_of_bytes = quantiser.values_of_bytes();
        let measures = vec![None; descriptor.layers as usize];
        Ok(Self { descriptor, quantiser, values_of_bytes, bounds, measures })
    }

    /// What is known already: all but the range of the values, which is stated as 0.
    #[must_use]
    pub fn descriptor(&self) -> &TextureDescriptor {
        &self.descriptor
    }

    /// Appends the stored form of a layer, row by row, channels interleaved, to `bytes`. May run on several threads at
    /// once; the measure has to be handed to [`Self::record`].
    ///
    /// # Errors
    /// A wrong number of values, or one that is NaN or outside the bounds.
    pub fn encode(&self, values: &[f32], bytes: &mut Vec<u8>) -> Result<LayerMeasure, EncodeError> {
        let (found, expected) = (values.len() as u64, self.descriptor.layer_values());
        if found != expected {
            return Err(EncodeError::Count { found, expected });
        }
        check_values(values, &self.bounds)?;
        let mut measure = LayerMeasure::EMPTY;
        bytes.reserve(values.len() * self.quantiser.component.bytes() as usize);
        for block in values.chunks(BLOCK) {
            match self.quantiser.component {
                Component::Unorm8 => self.bytes_of(block, bytes, &mut measure),
                Component::Float16 => self.halves_of(block, bytes, &mut measure),
                Component::Float32 => floats_of(block, bytes, &mut measure),
            }
        }
        Ok(measure)
    }

    fn bytes_of(&self, values: &[f32], bytes: &mut Vec<u8>, measure: &mut LayerMeasure) {
        let (mut numbers, mut codes) = ([0.0; BLOCK], [0; BLOCK]);
        let (numbers, codes) = (&mut numbers[..values.len()], &mut codes[..values.len()]);
        codes::all_before_transfer(self.quantiser.transfer, values, numbers);
        codes::to_bytes(&self.quantiser, numbers, codes);
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
        codes::to_halves(&self.quantiser, numbers, codes);
        bytes.extend(codes.iter().flat_map(|code| code.to_le_bytes()));
        codes::from_halves(&self.quantiser, codes, numbers);
        for decoded in numbers.iter_mut() {
            *decoded = self.quantiser.transfer.value(*decoded);
        }
        measure.add(values, numbers);
    }

    /// Takes note of an encoded layer.
    ///
    /// # Errors
    /// A layer that the table does not have.
    pub fn record(&mut self, layer: u32, measure: LayerMeasure) -> Result<(), EncodeError> {
        let layers = self.descriptor.layers;
        let slot = self.measures.get_mut(layer as usize).ok_or(EncodeError::Layer { layer, layers })?;
        *slot = Some(measure);
        Ok(())
    }

    /// The stored form of a layer, taken note of: [`Self::encode`] and [`Self::record`] in one.
    ///
    /// # Errors
    /// Those of both.
    pub fn layer(&mut self, layer: u32, values: &[f32]) -> Result<Vec<u8>, EncodeError> {
        let mut bytes = Vec::new();
        let measure = self.encode(values, &mut bytes)?;
        self.record(layer, measure)?;
        Ok(bytes)
    }

    /// The finished descriptor, with the range that the decoded values reach, and what the encoding cost.
    ///
    /// # Errors
    /// A layer that was not encoded.
    pub fn finish(self) -> Result<(TextureDescriptor, EncodingLoss), EncodeError> {
        let layers = self.descriptor.layers;
        let missing = |layer: usize| EncodeError::Missing { layer: layer as u32, layers };
        let measures: Vec<LayerMeasure> =
            self.measures.iter().enumerate().map(|(k, m)| m.ok_or_else(|| missing(k))).collect::<Result<_, _>>()?;
        let ranges = measures.iter().filter(|measure| measure.values() > 0).map(LayerMeasure::range);
        let (min, max) = ranges.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1))).unwrap_or_default();
        let descriptor = TextureDescriptor { range_min: min.into(), range_max: max.into(), ..self.descriptor };
        Ok((descriptor, loss::total(&measures)))
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
