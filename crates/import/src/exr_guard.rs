//! What must hold of an EXR before the decoder (exr 1.74) may allocate or compute for it.

use exr::{
    block::chunk::{Chunk, CompressedBlock},
    compression::Compression,
    error::Error,
    meta::{BlockDescription, header::Header},
};

use crate::{
    DecodeError, Format,
    limits::{Claim, MAX_RATIO},
};

const FORMAT: Format = Format::Exr;
/// The decoder makes room for a stored block before it reads it, as much as the block says, if it could be so large.
const MAX_BLOCK_BYTES: u128 = 64 << 20;

/// To be called on every layer: a block may claim to be of any.
pub(crate) fn check_blocks(headers: &[Header], file_bytes: usize) -> Result<(), DecodeError> {
    for header in headers {
        let compression = match header.compression {
            // The decoder adds unchecked there. It is no loss: B44 keeps six bits of a height.
            Compression::B44 | Compression::B44A => Some("B44"),
            Compression::HTJ2K32 | Compression::HTJ2K256 => Some("HTJ2K"),
            _ => None,
        };
        if let Some(name) = compression {
            let accepted = "no, RLE, ZIP, PIZ, PXR24 or DWA compression";
            return Err(DecodeError::Unsupported { format: FORMAT, found: format!("{name} compression"), accepted });
        }
        let [width, height] = block_size(header);
        let bytes = width as u128 * height as u128 * header.channels.bytes_per_pixel as u128;
        if bytes > MAX_BLOCK_BYTES.max(16 * file_bytes as u128) {
            let found = format!("blocks of {width} × {height} texels, {bytes} bytes");
            return Err(DecodeError::Unsupported { format: FORMAT, found, accepted: "blocks of up to 64 MiB" });
        }
    }
    Ok(())
}

/// Width and height of a whole tile or block of lines.
fn block_size(header: &Header) -> [usize; 2] {
    match header.blocks {
        BlockDescription::Tiles(tiles) => [tiles.tile_size.width(), tiles.tile_size.height()],
        BlockDescription::ScanLines => [header.layer_size.width(), header.compression.scan_lines_per_block()],
    }
}

/// To be called on a stored block of a layer that passed [`check_layer`].
pub(crate) fn check_chunk(chunk: &Chunk, layer: usize, header: &Header) -> Result<(), DecodeError> {
    let stored = match &chunk.compressed_block {
        CompressedBlock::ScanLine(block) => &block.compressed_pixels_le,
        CompressedBlock::Tile(block) => &block.compressed_pixels_le,
        _ => return Err(DecodeError::damaged(FORMAT, &"it has deep data in a flat layer")),
    };
    if chunk.layer_index != layer {
        return Err(DecodeError::damaged(FORMAT, &"a block of pixels is of another layer than the offset table says"));
    }
    if matches!(header.compression, Compression::DWAA(_) | Compression::DWAB(_)) {
        let damaged = |error: Error| DecodeError::damaged(FORMAT, &error);
        let place = header.get_block_data_indices(&chunk.compressed_block).map_err(damaged)?;
        let size = header.get_absolute_block_pixel_coordinates(place).map_err(damaged)?.size;
        // A block that would not shrink is stored as it is.
        if stored.len() != size.area() * header.channels.bytes_per_pixel {
            check_dwa(stored, [size.width(), size.height()], header.channels.list.len())?;
        }
    }
    Ok(())
}

/// A DWA block begins with eleven counts, which the decoder takes for lengths to allocate. Of those that say how much comes
/// out of a stream (1, 6, 7, 8, 9), none exceeds twice the bytes of a block of whole 8 × 8 squares in f32.
fn check_dwa(stored: &[u8], [width, height]: [usize; 2], channels: usize) -> Result<(), DecodeError> {
    let most = 2 * 64 * 4 * (width.div_ceil(8) * height.div_ceil(8) * channels) as u64;
    let counts = stored.as_chunks().0.iter().map(|&bytes| u64::from_le_bytes(bytes)).take(11);
    match counts.enumerate().find(|&(i, count)| matches!(i, 1 | 6..=9) && count > most) {
        Some((_, count)) => {
            Err(DecodeError::damaged(FORMAT, &format_args!("a DWA block says {count} where {most} is the most")))
        }
        None => Ok(()),
    }
}

/// The extent of the layer to be read, if it is plausible and its channels are.
pub(crate) fn check_layer(header: &Header, file_bytes: usize, max_texels: u64) -> Result<(u32, u32), DecodeError> {
    let max_ratio = match header.compression {
        // A flat square of 8 × 8 becomes two numbers, which are then deflated; but each block has a header of its own.
        // OpenEXR's own files of one constant reach 13667 : 1 (f16, 16384 × 16384, DWAB).
        Compression::DWAA(_) | Compression::DWAB(_) => MAX_RATIO * 16,
        _ => MAX_RATIO,
    };
    if header.channels.list.iter().any(|channel| channel.sampling.0 != 1 || channel.sampling.1 != 1) {
        let found = "channels with fewer samples than pixels".to_owned();
        return Err(DecodeError::Unsupported {
            format: FORMAT,
            found,
            accepted: "a sample per pixel in every channel",
        });
    }
    let (width, height) = (header.layer_size.width() as u64, header.layer_size.height() as u64);
    let claim = Claim::new(FORMAT, width, height, header.channels.bytes_per_pixel as u64 * 8);
    Claim { max_ratio, ..claim }.check(file_bytes, max_texels)
}
