//! TIFF and BigTIFF: the first image, in strips or tiles.
//!
//! Decoded here, on top of `flate2` and `weezl`. The `tiff` crate (0.11.3), tried first, refuses most tiled LZW files with
//! "no lzw end code found" (its issue 395), which is how elevation is commonly published; asserts on separate planes in
//! padded tiles; and multiplies sides, strips and planes of a header unchecked. It writes the files of our tests.

mod block;
mod directory;
mod header;

use block::BlockDecoder;
use header::Header;

use crate::{
    DecodeError, Format, HeightMapOptions,
    channel::{Channels, pick},
    limits::{Claim, zeroed},
    samples::{RawMap, Sample, Samples, with_samples},
};

const FORMAT: Format = Format::Tiff;

pub(crate) fn decode(bytes: &[u8], options: &HeightMapOptions) -> Result<RawMap, DecodeError> {
    let header = Header::read(bytes)?;
    let sample_type = header.check_variety()?;
    let (width, height) = header.claim().check(bytes.len(), options.max_texels)?;
    let names = header.channel_names();
    let pick = pick(FORMAT, &names, options.channel.as_deref())?;

    let wanted = pick.indices();
    let texels = width as usize * height as usize;
    let Some(samples) = Samples::zeroed(sample_type, texels * wanted.len()) else {
        return Err(damaged("its samples are of no known type"));
    };
    let layout = Layout::new(&header, width as usize, height as usize)?;
    let samples = with_samples!(samples?, v => wrap layout.read(bytes, &header, &wanted, v)?);
    let channels = Channels { format: FORMAT, width, height, count: wanted.len(), planar: true, samples };
    Ok(RawMap {
        format: FORMAT,
        width,
        height,
        samples: channels.take(pick.among_wanted())?,
        sample_type,
        channel: pick.name(&names),
        no_data: header.no_data,
    })
}

fn damaged(reason: impl Into<String>) -> DecodeError {
    DecodeError::damaged(FORMAT, &reason.into())
}

impl Header {
    /// What the header promises, padding of tiles included.
    fn claim(&self) -> Claim {
        let mut claim = Claim::new(FORMAT, self.width, self.height, self.bits * u64::from(self.channels));
        if let Some([tile_width, tile_height]) = self.tile {
            let padded = |side: u64, tile: u64| u128::from(side.div_ceil(tile)) * u128::from(tile);
            let texels = padded(self.width, tile_width).saturating_mul(padded(self.height, tile_height));
            claim.stored_bits = texels.saturating_mul((self.bits * u64::from(self.channels)).into());
        }
        claim
    }
}

/// How blocks, that is strips or tiles, cover the image.
struct Layout {
    width: usize,
    height: usize,
    block_width: usize,
    block_height: usize,
    /// Tiles are stored whole; the last strip ends with the image.
    is_padded: bool,
    across: usize,
    down: usize,
}

impl Layout {
    fn new(header: &Header, width: usize, height: usize) -> Result<Self, DecodeError> {
        let clamp = |side: u64| usize::try_from(side).unwrap_or(usize::MAX);
        let (block_width, block_height) = match header.tile {
            Some([tile_width, tile_height]) => (clamp(tile_width), clamp(tile_height)),
            None => (width, clamp(header.rows_per_strip).min(height)),
        };
        let (across, down) = (width.div_ceil(block_width), height.div_ceil(block_height));
        let blocks = across as u128 * down as u128 * header.planes() as u128;
        let (offsets, counts) = (header.offsets.len() as u128, header.byte_counts.len() as u128);
        if offsets != blocks || counts != blocks {
            return Err(damaged(format!("it has {blocks} blocks, but {offsets} offsets and {counts} byte counts")));
        }
        Ok(Self { width, height, block_width, block_height, is_padded: header.tile.is_some(), across, down })
    }

    /// Fills `samples` with the wanted channels, one whole plane after the other.
    fn read<T: Sample>(
        &self,
        bytes: &[u8],
        header: &Header,
        wanted: &[usize],
        mut samples: Vec<T>,
    ) -> Result<Vec<T>, DecodeError> {
        let interleaved = if header.is_planar() { 1 } else { usize::from(header.channels) };
        let decoder = BlockDecoder::new(header, self.block_width, interleaved);
        let mut block = zeroed(decoder.row_bytes * self.block_height)?;
        for (target, &channel) in samples.chunks_exact_mut(self.width * self.height).zip(wanted) {
            let (plane, first) = if header.is_planar() { (channel, 0) } else { (0, channel) };
            for i in 0..self.across * self.down {
                let (x, y) = (i % self.across * self.block_width, i / self.across * self.block_height);
                let (columns, rows) = (self.block_width.min(self.width - x), self.block_height.min(self.height - y));
                let stored = if self.is_padded { self.block_height } else { rows };
                let block = &mut block[..stored * decoder.row_bytes];
                decoder.decode(header.block(bytes, plane * self.across * self.down + i)?, block)?;
                for (row, source) in block.chunks_exact(decoder.row_bytes).take(rows).enumerate() {
                    let start = (y + row) * self.width + x;
                    let texels = source.chunks_exact(T::BYTES * interleaved);
                    for (sample, texel) in target[start..start + columns].iter_mut().zip(texels) {
                        *sample = T::from_native(&texel[first * T::BYTES..]);
                    }
                }
            }
        }
        Ok(samples)
    }
}
