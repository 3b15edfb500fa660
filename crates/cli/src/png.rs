//! Pictures as PNG files.

use std::io::Cursor;

use barchan_shade::Picture;
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder};

use crate::failure::Failure;

/// 8 bits of red, green and blue.
pub(crate) fn encode(picture: &Picture) -> Result<Vec<u8>, Failure> {
    let mut bytes = Cursor::new(Vec::new());
    PngEncoder::new(&mut bytes)
        .write_image(&picture.rgb, picture.width, picture.height, ExtendedColorType::Rgb8)
        .map_err(|error| Failure::Io(format!("the picture cannot be encoded: {error}")))?;
    Ok(bytes.into_inner())
}
