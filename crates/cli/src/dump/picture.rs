//! Grey pictures: black is the least value of the table, white the greatest.

use std::io::Cursor;

use image::{ExtendedColorType, ImageEncoder, codecs::png::PngEncoder};

use super::Selection;
use crate::failure::Failure;

/// One layer as it is, several as a contact sheet, left to right and top to bottom.
pub(super) fn encode(selection: &Selection<'_>) -> Result<Vec<u8>, Failure> {
    let layers = selection.layers.len();
    let across = (layers as f64).sqrt().ceil() as usize;
    let (width, height) = (selection.width(), selection.height());
    let (sheet_width, sheet_height) = (across * width, layers.div_ceil(across) * height);
    let mut sheet = vec![0_u16; sheet_width * sheet_height];
    for (index, layer) in selection.layers.clone().enumerate() {
        let (left, top) = (index % across * width, index / across * height);
        let grey: Vec<u16> = selection.layer_values(layer).map(|value| grey(selection, value)).collect();
        for (row, texels) in grey.chunks_exact(width).enumerate() {
            sheet[(top + row) * sheet_width + left..][..width].copy_from_slice(texels);
        }
    }
    // The encoder takes 16-bit samples in the machine's byte order and swaps them itself.
    let samples: Vec<u8> = sheet.iter().flat_map(|grey| grey.to_ne_bytes()).collect();
    let mut bytes = Cursor::new(Vec::new());
    PngEncoder::new(&mut bytes)
        .write_image(&samples, sheet_width as u32, sheet_height as u32, ExtendedColorType::L16)
        .map_err(|error| Failure::Io(format!("the picture cannot be encoded: {error}")))?;
    Ok(bytes.into_inner())
}

fn grey(selection: &Selection<'_>, value: f32) -> u16 {
    let (min, max) = (selection.table.descriptor.range_min, selection.table.descriptor.range_max);
    let range = max - min;
    if range > 0.0 { (65535.0 * (f64::from(value) - min) / range).round() as u16 } else { 0 }
}
