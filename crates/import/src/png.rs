//! PNG: 1 to 16 bits, grey or colour, with or without alpha, interlaced or not. Palettes are expanded to R, G, B.

use std::io::Cursor;

use image::{ColorType, ImageDecoder, ImageError, codecs::png::PngDecoder};

use crate::{
    DecodeError, Format, HeightMapOptions,
    channel::{Channels, pick},
    limits::{Claim, MAX_RATIO, zeroed},
    samples::{RawMap, SampleType, Samples},
};

const FORMAT: Format = Format::Png;
const PALETTE: u8 = 3;

pub(crate) fn decode(bytes: &[u8], options: &HeightMapOptions) -> Result<RawMap, DecodeError> {
    let header = Header::read(bytes)?;
    let claim = Claim::new(FORMAT, header.width.into(), header.height.into(), header.bits_per_texel());
    let (width, height) = claim.check(bytes.len(), options.max_texels)?;

    let (color, data) = pixels(bytes)?;
    let names: &[&str] = match color {
        ColorType::L8 | ColorType::L16 => &["Y"],
        ColorType::La8 | ColorType::La16 => &["Y", "A"],
        ColorType::Rgb8 | ColorType::Rgb16 => &["R", "G", "B"],
        _ => &["R", "G", "B", "A"],
    };
    let names: Vec<String> = names.iter().map(|&name| name.to_owned()).collect();
    let pick = pick(FORMAT, &names, options.channel.as_deref())?;

    let sample_type = SampleType { kind: 'u', bits: header.sample_bits() };
    let samples = unpack(data, sample_type.bits);
    let channels = Channels { format: FORMAT, width, height, count: names.len(), planar: false, samples };
    let channel = pick.name(&names);
    Ok(RawMap { format: FORMAT, width, height, samples: channels.take(pick)?, sample_type, channel, no_data: None })
}

/// What the first chunk says, read before any decoder sees the file.
struct Header {
    width: u32,
    height: u32,
    /// Bits per sample, or per index into the palette.
    bits: u8,
    color: u8,
}

impl Header {
    fn read(bytes: &[u8]) -> Result<Self, DecodeError> {
        let chunk = bytes.get(8..33).filter(|chunk| chunk.starts_with(b"\0\0\0\x0dIHDR"));
        let chunk = chunk.ok_or_else(|| DecodeError::damaged(FORMAT, &"it does not begin with a whole IHDR chunk"))?;
        let side = |at: usize| u32::from_be_bytes([chunk[at], chunk[at + 1], chunk[at + 2], chunk[at + 3]]);
        Ok(Self { width: side(8), height: side(12), bits: chunk[16], color: chunk[17] })
    }

    fn bits_per_texel(&self) -> u64 {
        let samples = match self.color {
            2 => 3,
            4 => 2,
            6 => 4,
            _ => 1,
        };
        samples * u64::from(self.bits)
    }

    /// A palette's entries have 8 bits, whatever its indices have.
    fn sample_bits(&self) -> u8 {
        if self.color == PALETTE { 8 } else { self.bits }
    }
}

/// Bytes in native order; samples of fewer than 8 bits have been spread over 0 … 255.
fn pixels(bytes: &[u8]) -> Result<(ColorType, Vec<u8>), DecodeError> {
    let damaged = |error: ImageError| DecodeError::damaged(FORMAT, &error);
    let mut limits = image::Limits::no_limits();
    limits.max_alloc = Some((bytes.len() as u64).saturating_mul(MAX_RATIO));
    let decoder = PngDecoder::with_limits(Cursor::new(bytes), limits).map_err(damaged)?;
    let len = usize::try_from(decoder.total_bytes()).unwrap_or(usize::MAX);
    let color = decoder.color_type();
    let mut data = zeroed(len)?;
    decoder.read_image(&mut data).map_err(damaged)?;
    Ok((color, data))
}

/// Bytes to samples as the file had them: four bits of 15 were decoded to 255, and become 15 again.
fn unpack(mut data: Vec<u8>, bits: u8) -> Samples {
    match bits {
        16 => Samples::U16(data.as_chunks().0.iter().map(|&pair| u16::from_ne_bytes(pair)).collect()),
        1 | 2 | 4 => {
            let step = 255 / ((1 << bits) - 1) as u8;
            data.iter_mut().for_each(|sample| *sample /= step);
            Samples::U8(data)
        }
        _ => Samples::U8(data),
    }
}
