//! Raw samples to heights: no data, scale, offset.

use crate::{
    DecodeError, HeightMapOptions, Integers,
    limits::reserved,
    samples::{RawMap, Sample, with_samples},
};

/// Heights, with NaN in the place of those that are missing.
pub(crate) struct Heights {
    pub(crate) heights: Vec<f32>,
    pub(crate) missing: u64,
    /// Index and raw sample of the first missing height.
    pub(crate) first_missing: Option<(usize, f64)>,
    /// Lowest and highest raw sample that became a height.
    pub(crate) raw_range: (f64, f64),
}

/// `sample / full scale × height_scale + height_offset`, or without the division, for every sample that is a number and not no-data.
pub(crate) fn heights(raw: &RawMap, options: &HeightMapOptions) -> Result<Heights, DecodeError> {
    with_samples!(&raw.samples, v => scale(v, raw, options))
}

fn scale<T: Sample>(samples: &[T], raw: &RawMap, options: &HeightMapOptions) -> Result<Heights, DecodeError> {
    let no_data = no_data_values::<T>([options.no_data, raw.no_data]);
    let full_scale = match options.integers {
        Integers::Normalised => raw.sample_type.full_scale(),
        Integers::Raw => 1.0,
    };
    let HeightMapOptions { height_scale, height_offset, .. } = *options;
    let mut result = Heights {
        heights: reserved(samples.len())?,
        missing: 0,
        first_missing: None,
        raw_range: (f64::INFINITY, f64::NEG_INFINITY),
    };
    for (i, sample) in samples.iter().enumerate() {
        let value = sample.to_f64();
        if !value.is_finite() || no_data.contains(&value) {
            result.missing += 1;
            result.first_missing.get_or_insert((i, value));
            result.heights.push(f32::NAN);
            continue;
        }
        let scaled = value / full_scale * height_scale + height_offset;
        let height = scaled as f32;
        if !height.is_finite() {
            let (column, row) = texel(i, raw.width);
            return Err(DecodeError::Overflow { column, row, value, scaled });
        }
        result.raw_range = (result.raw_range.0.min(value), result.raw_range.1.max(value));
        result.heights.push(height);
    }
    Ok(result)
}

/// The values that mean no data: each as given, and rounded to the samples' own type.
fn no_data_values<T: Sample>(given: [Option<f64>; 2]) -> Vec<f64> {
    given.into_iter().flatten().flat_map(|value| [value, T::round(value)]).collect()
}

/// Column and row of the texel at an index.
pub(crate) fn texel(index: usize, width: u32) -> (u32, u32) {
    ((index % width as usize) as u32, (index / width as usize) as u32)
}
