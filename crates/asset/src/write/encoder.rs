//! Values to stored bytes, a layer at a time, with the error that costs.

use core::ops::RangeInclusive;
use std::vec;
use std::vec::Vec;

use super::encode::{EncodeError, Encoding};
use super::facts::TableFacts;
use super::loss::{self, EncodingLoss, LayerMeasure};
use super::numbers::NumberEncoder;
use super::quantiser::Quantiser;
use crate::TextureDescriptor;

/// Encodes the layers of one table as they come, in any order, and measures what that costs.
///
/// What must be known beforehand are bounds of the values; the tighter, the smaller the error. Nothing of the size of a
/// table is held. The same layers give the same descriptor and loss, whatever the order and on whichever thread they
/// were encoded.
#[derive(Debug, Clone)]
pub struct TableEncoder {
    /// Complete but for the range.
    descriptor: TextureDescriptor,
    numbers: NumberEncoder,
    /// Of the first channel of a cone map, which is no ratio.
    depths: Option<NumberEncoder>,
    measures: Vec<Option<LayerMeasure>>,
}

impl TableEncoder {
    /// An encoder of a table whose values are all within `bounds`, in their own unit; of a cone map, whose ratios are.
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
        let quantiser = Quantiser::new(encoding, facts, &bounds)?;
        descriptor.scale = f64::from(quantiser.scale);
        descriptor.bias = f64::from(quantiser.bias);
        descriptor.worst_case_error = quantiser.worst_case_error();
        let depths = facts.semantic().is_cone_map().then(|| {
            let quantiser = Quantiser::plain(encoding, facts);
            descriptor.worst_case_error = descriptor.worst_case_error.max(quantiser.worst_case_error());
            NumberEncoder::new(quantiser, 0.0..=1.0)
        });
        let measures = vec![None; descriptor.pictures() as usize];
        Ok(Self { descriptor, numbers: NumberEncoder::new(quantiser, bounds), depths, measures })
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
        self.picture(values, bytes)
    }

    /// [`Self::encode`] of a mip level too, whatever its extent.
    pub(super) fn picture(&self, values: &[f32], bytes: &mut Vec<u8>) -> Result<LayerMeasure, EncodeError> {
        let mut measure = LayerMeasure::EMPTY;
        match &self.depths {
            None => {
                self.numbers.check(values)?;
                self.numbers.encode(values, bytes, &mut measure);
            }
            Some(depths) => self.depths_and_ratios(depths, values, bytes, &mut measure)?,
        }
        Ok(measure)
    }

    fn depths_and_ratios(
        &self,
        depths: &NumberEncoder,
        values: &[f32],
        bytes: &mut Vec<u8>,
        measure: &mut LayerMeasure,
    ) -> Result<(), EncodeError> {
        let encoders = [depths, &self.numbers];
        let mut stored = [Vec::new(), Vec::new()];
        for (channel, (encoder, stored)) in encoders.into_iter().zip(&mut stored).enumerate() {
            let numbers: Vec<f32> = values.iter().skip(channel).step_by(2).copied().collect();
            encoder.check(&numbers).map_err(|error| error.at_index(|texel| 2 * texel + channel))?;
            encoder.encode(&numbers, stored, measure);
        }
        let number_bytes = self.numbers.quantiser().component.bytes() as usize;
        let texels = stored[0].chunks_exact(number_bytes).zip(stored[1].chunks_exact(number_bytes));
        bytes.extend(texels.flat_map(|(depth, ratio)| depth.iter().chain(ratio)));
        Ok(())
    }

    /// Takes note of an encoded layer.
    ///
    /// # Errors
    /// A layer that the table does not have.
    pub fn record(&mut self, layer: u32, measure: LayerMeasure) -> Result<(), EncodeError> {
        let layers = self.descriptor.pictures();
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
        let layers = self.descriptor.pictures();
        let missing = |layer: usize| EncodeError::Missing { layer: layer as u32, layers };
        let measures: Vec<LayerMeasure> =
            self.measures.iter().enumerate().map(|(k, m)| m.ok_or_else(|| missing(k))).collect::<Result<_, _>>()?;
        let ranges = measures.iter().filter(|measure| measure.values() > 0).map(LayerMeasure::range);
        let (min, max) = ranges.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1))).unwrap_or_default();
        let descriptor = TextureDescriptor { range_min: min.into(), range_max: max.into(), ..self.descriptor };
        Ok((descriptor, loss::total(&measures)))
    }
}
