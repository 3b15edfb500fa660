//! OpenEXR: any flat layer, scan lines or tiles, one channel of f16, f32 or u32.

use std::{collections::HashSet, io::Cursor};

use exr::{
    block::{UncompressedBlock, lines::LineRef, reader::ChunksReader},
    error::{Error, Result as ExrResult},
    io::Data,
    math::Vec2,
    meta::{attribute, header::Header},
};

use crate::{
    DecodeError, Format, HeightMapOptions,
    channel::{Channels, Pick, list, pick},
    exr_guard,
    samples::{RawMap, SampleType, Samples},
};

const FORMAT: Format = Format::Exr;

pub(crate) fn decode(bytes: &[u8], options: &HeightMapOptions) -> Result<RawMap, DecodeError> {
    let reader = exr::block::read(Cursor::new(bytes), false).map_err(damaged)?;
    exr_guard::check_blocks(reader.headers(), bytes.len())?;
    let (layer, pick) = choose(reader.headers(), options.channel.as_deref())?;
    let header = &reader.headers()[layer];
    let (width, height) = exr_guard::check_layer(header, bytes.len(), options.max_texels)?;

    let names = names(header);
    let indices = pick.indices();
    let sample_type = common_type(header, &indices)?;
    let texels = width as usize * height as usize;
    let Some(samples) = Samples::zeroed(sample_type, texels * indices.len()) else {
        return Err(DecodeError::damaged(FORMAT, &"a channel is of no known type"));
    };
    let mut planes = Planes { indices, width: width as usize, texels, samples: samples?, seen: HashSet::new() };
    let level = Vec2(0, 0);
    let chunks =
        reader.filter_chunks(false, |_, _, block| block.layer == layer && block.level == level).map_err(damaged)?;
    let (meta_data, expected) = (chunks.meta_data().clone(), chunks.expected_chunk_count());
    let header = &meta_data.headers[layer];
    for chunk in chunks {
        let chunk = chunk.map_err(damaged)?;
        exr_guard::check_chunk(&chunk, layer, header)?;
        let block = UncompressedBlock::decompress_chunk(chunk, &meta_data, false).map_err(damaged)?;
        planes.insert(&block, header).map_err(damaged)?;
    }
    if planes.seen.len() != expected {
        return Err(DecodeError::damaged(FORMAT, &"blocks of pixels are missing"));
    }

    let count = planes.indices.len();
    let channels = Channels { format: FORMAT, width, height, count, planar: true, samples: planes.samples };
    let channel = pick.name(&names);
    Ok(RawMap {
        format: FORMAT,
        width,
        height,
        samples: channels.take(pick.among_wanted())?,
        sample_type,
        channel,
        no_data: None,
    })
}

fn damaged(error: Error) -> DecodeError {
    let reason = match error {
        Error::NotSupported(reason) | Error::Invalid(reason) => reason.into_owned(),
        other => other.to_string(),
    };
    DecodeError::damaged(FORMAT, &reason)
}

fn names(header: &Header) -> Vec<String> {
    header.channels.list.iter().map(|channel| channel.name.to_string()).collect()
}

/// The first flat layer that has the channel, and the channel.
fn choose(headers: &[Header], wanted: Option<&str>) -> Result<(usize, Pick), DecodeError> {
    let flat = || headers.iter().enumerate().filter(|(_, header)| !header.deep);
    if flat().next().is_none() {
        let found = "deep data only".to_owned();
        return Err(DecodeError::Unsupported { format: FORMAT, found, accepted: "a flat image" });
    }
    if let Some(found) = flat().find_map(|(i, header)| Some((i, pick(FORMAT, &names(header), wanted).ok()?))) {
        return Ok(found);
    }
    let layer = |header: &Header| match &header.own_attributes.layer_name {
        Some(name) if headers.len() > 1 => format!("{} (layer {})", list(&names(header)), list(&[name.to_string()])),
        _ => list(&names(header)),
    };
    let present = flat().map(|(_, header)| layer(header)).collect::<Vec<_>>().join("; ");
    Err(match wanted {
        Some(wanted) => DecodeError::NoSuchChannel { format: FORMAT, wanted: wanted.to_owned(), present },
        None => DecodeError::WhichChannel { format: FORMAT, present },
    })
}

fn common_type(header: &Header, indices: &[usize]) -> Result<SampleType, DecodeError> {
    let types: Vec<SampleType> = indices
        .iter()
        .map(|&i| match header.channels.list[i].sample_type {
            attribute::SampleType::F16 => SampleType { kind: 'f', bits: 16 },
            attribute::SampleType::F32 => SampleType { kind: 'f', bits: 32 },
            attribute::SampleType::U32 => SampleType { kind: 'u', bits: 32 },
        })
        .collect();
    if types.iter().any(|&t| t != types[0]) {
        let found = "R, G and B of different types".to_owned();
        return Err(DecodeError::Unsupported { format: FORMAT, found, accepted: "naming one `channel`" });
    }
    Ok(types[0])
}

/// The wanted channels, one whole plane after the other, while blocks come in.
struct Planes {
    /// Which of the layer's channels the planes are.
    indices: Vec<usize>,
    width: usize,
    texels: usize,
    samples: Samples,
    /// Top left corners of the blocks so far: a file may repeat one and lack another.
    seen: HashSet<(usize, usize)>,
}

impl Planes {
    fn insert(&mut self, block: &UncompressedBlock, header: &Header) -> ExrResult<()> {
        let Vec2(x, y) = block.index.pixel_position;
        if block.index.level != Vec2(0, 0) || !self.seen.insert((x, y)) {
            return Err(Error::Invalid("a block of pixels is not where the offset table says".into()));
        }
        for line in block.lines(&header.channels) {
            if let Some(plane) = self.indices.iter().position(|&i| i == line.location.channel) {
                self.insert_line(plane, line)?;
            }
        }
        Ok(())
    }

    fn insert_line(&mut self, plane: usize, line: LineRef<'_>) -> ExrResult<()> {
        let Vec2(x, y) = line.location.position;
        let count = line.location.sample_count;
        if x + count > self.width || (y + 1) * self.width > self.texels {
            return Err(Error::Invalid("a block of pixels lies outside the data window".into()));
        }
        let start = plane * self.texels + y * self.width + x;
        match &mut self.samples {
            Samples::F16(v) => read(line, &mut v[start..start + count]),
            Samples::F32(v) => read(line, &mut v[start..start + count]),
            Samples::U32(v) => read(line, &mut v[start..start + count]),
            _ => Err(Error::Invalid("a channel is of no known type".into())),
        }
    }
}

fn read<T: Data>(line: LineRef<'_>, samples: &mut [T]) -> ExrResult<()> {
    line.read_samples_into_slice(samples)
}
