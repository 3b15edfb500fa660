//! Pictures: grey from the least value of the table to the greatest, shares from black to white, and vectors in colour.

use std::io::Cursor;

use barchan_asset::Semantic;
use image::{ExtendedColorType, ImageEncoder, codecs::png::PngEncoder};

use super::Selection;
use crate::failure::Failure;

/// One layer as it is, several as a contact sheet, left to right and top to bottom.
pub(super) fn encode(selection: &Selection<'_>) -> Result<Vec<u8>, Failure> {
    let layers = selection.layers.len();
    // PNG has no pictures of two colours: the third stays black.
    let channels = match selection.numbers().len() {
        2 => 3,
        channels => channels,
    };
    let across = (layers as f64).sqrt().ceil() as usize;
    let (width, height) = (selection.width(), selection.height());
    let (sheet_width, sheet_height) = (across * width, layers.div_ceil(across) * height);
    let mut sheet = vec![0_u16; sheet_width * sheet_height * channels];
    for (index, layer) in selection.layers.clone().enumerate() {
        let (left, top) = (index % across * width, index / across * height);
        let samples = samples(selection, layer, channels);
        for (row, texels) in samples.chunks_exact(width * channels).enumerate() {
            sheet[((top + row) * sheet_width + left) * channels..][..texels.len()].copy_from_slice(texels);
        }
    }
    let colour = match channels {
        1 => ExtendedColorType::L16,
        3 => ExtendedColorType::Rgb16,
        _ => ExtendedColorType::Rgba16,
    };
    // The encoder takes 16-bit samples in the machine's byte order and swaps them itself.
    let samples: Vec<u8> = sheet.iter().flat_map(|sample| sample.to_ne_bytes()).collect();
    let mut bytes = Cursor::new(Vec::new());
    PngEncoder::new(&mut bytes)
        .write_image(&samples, sheet_width as u32, sheet_height as u32, colour)
        .map_err(|error| Failure::Io(format!("the picture cannot be encoded: {error}")))?;
    Ok(bytes.into_inner())
}

/// A layer as 16 bits, `channels` to a texel.
fn samples(selection: &Selection<'_>, layer: u32, channels: usize) -> Vec<u16> {
    let (values, numbers) = (selection.layer_values(layer), selection.numbers().len());
    let mut samples = vec![0; values.len() / numbers * channels];
    for (texel, values) in samples.chunks_exact_mut(channels).zip(values.chunks_exact(numbers)) {
        for (channel, (sample, &value)) in texel.iter_mut().zip(values).enumerate() {
            *sample = as_sample(selection, channel, value);
        }
    }
    samples
}

/// A number of a texel as 16 bits: components of vectors as in every normal map, from -1 to 1.
fn as_sample(selection: &Selection<'_>, channel: usize, value: f32) -> u16 {
    let descriptor = &selection.table.descriptor;
    let (min, max) = match descriptor.semantic {
        Semantic::BentNormal | Semantic::ApertureCone if channel < 3 => (-1.0, 1.0),
        Semantic::BentNormal | Semantic::ApertureCone | Semantic::SkyVisibility => (0.0, 1.0),
        Semantic::HemisphereDepth => (0.0, 1.0),
        Semantic::ConeMap | Semantic::RelaxedConeMap if channel == 0 => (0.0, 1.0),
        _ => (descriptor.range_min, descriptor.range_max),
    };
    let range = max - min;
    if range > 0.0 { (65535.0 * (f64::from(value) - min) / range).round() as u16 } else { 0 }
}
