//! The tags of the first image that matter to a height map.

use super::{FORMAT, damaged, directory::Directory};
use crate::{DecodeError, samples::SampleType};

/// What the first directory says.
pub(crate) struct Header {
    pub(crate) little_endian: bool,
    pub(crate) width: u64,
    pub(crate) height: u64,
    /// Width and height of a tile, neither 0; `None` if the image is in strips.
    pub(crate) tile: Option<[u64; 2]>,
    /// Not 0.
    pub(crate) rows_per_strip: u64,
    /// Where each block begins and how many bytes it has.
    pub(crate) offsets: Vec<u64>,
    pub(crate) byte_counts: Vec<u64>,
    pub(crate) bits: u64,
    /// Alpha and others included; not 0.
    pub(crate) channels: u16,
    pub(crate) compression: u64,
    pub(crate) predictor: u64,
    /// GDAL_NODATA.
    pub(crate) no_data: Option<f64>,
    /// 1 unsigned, 2 signed, 3 float.
    sample_format: u64,
    photometric: u64,
    planar: u64,
    orientation: u64,
    /// The meaning of the first channel beyond the colour; 1 and 2 are alpha.
    extra: u64,
}

const RGB: u64 = 2;

impl Header {
    pub(crate) fn read(bytes: &[u8]) -> Result<Self, DecodeError> {
        let directory = Directory::open(bytes)?;
        let one =
            |tag: u16, default: u64| directory.values(tag).map(|values| values.map_or(default, |values| values[0]));
        let all =
            |tag: u16, name: &str| directory.values(tag)?.ok_or_else(|| damaged(format!("its {name} tag is missing")));
        let uniform = |tag: u16, default: u64| match directory.values(tag)? {
            Some(values) if values.iter().any(|&v| v != values[0]) => {
                Err(damaged("its channels are of different types"))
            }
            values => Ok(values.map_or(default, |values| values[0])),
        };
        let is_tiled = directory.has(322);
        let (offsets, byte_counts) = if is_tiled {
            (all(324, "TileOffsets")?, all(325, "TileByteCounts")?)
        } else {
            (all(273, "StripOffsets")?, all(279, "StripByteCounts")?)
        };
        let header = Self {
            little_endian: directory.little_endian,
            width: all(256, "ImageWidth")?[0],
            height: all(257, "ImageLength")?[0],
            tile: if is_tiled { Some([one(322, 0)?, one(323, 0)?]) } else { None },
            rows_per_strip: one(278, u64::MAX)?,
            offsets,
            byte_counts,
            bits: uniform(258, 1)?,
            channels: u16::try_from(one(277, 1)?).unwrap_or(0),
            compression: one(259, 1)?,
            predictor: one(317, 1)?,
            no_data: directory.text(42113)?.map(no_data).transpose()?,
            sample_format: uniform(339, 1)?,
            photometric: all(262, "PhotometricInterpretation")?[0],
            planar: one(284, 1)?,
            orientation: one(274, 1)?,
            extra: one(338, 0)?,
        };
        if header.channels == 0 || header.rows_per_strip == 0 || header.tile.is_some_and(|tile| tile.contains(&0)) {
            return Err(damaged("its number of channels or the size of its strips or tiles is impossible"));
        }
        Ok(header)
    }

    /// The type of the samples, if this variety of TIFF is one that is read.
    pub(crate) fn check_variety(&self) -> Result<SampleType, DecodeError> {
        let unsupported = |found: String, accepted| Err(DecodeError::Unsupported { format: FORMAT, found, accepted });
        if !matches!(self.photometric, 1 | RGB) {
            let found = name(&PHOTOMETRICS, self.photometric, "photometric interpretation");
            return unsupported(found, "grey with black as 0, or RGB,");
        }
        if !matches!(self.compression, 1 | 5 | 8 | 32773 | 32946) {
            let found = name(&COMPRESSIONS, self.compression, "compression");
            return unsupported(found, "no compression, LZW, deflate or PackBits");
        }
        if self.orientation != 1 {
            return unsupported(format!("orientation {}", self.orientation), "orientation 1, top left,");
        }
        let kind = match (self.sample_format, self.bits) {
            (1, 8 | 16 | 32) => 'u',
            (2, 8 | 16 | 32) => 'i',
            (3, 16 | 32 | 64) => 'f',
            (format, bits) => {
                let kinds = [(1, "unsigned"), (2, "signed"), (3, "float")];
                let found = format!("{} samples of {bits} bits", name(&kinds, format, "format"));
                return unsupported(found, "integers of 8, 16 or 32 bits or floats of 16, 32 or 64 bits");
            }
        };
        if !matches!((self.predictor, kind), (1 | 2, _) | (3, 'f')) {
            return unsupported(format!("predictor {}", self.predictor), "predictor 1, 2, or 3 for floats,");
        }
        Ok(SampleType { kind, bits: self.bits as u8 })
    }

    pub(crate) fn channel_names(&self) -> Vec<String> {
        let color: &[&str] = match (self.photometric, self.channels) {
            (RGB, 3..) => &["R", "G", "B"],
            (_, 1) => &["Y"],
            (_, 2) if self.extra_is_alpha() => &["Y"],
            _ => &[],
        };
        let mut names: Vec<String> = color.iter().map(|&name| name.to_owned()).collect();
        if !names.is_empty() && names.len() < self.channels.into() && self.extra_is_alpha() {
            names.push("A".to_owned());
        }
        names.extend((names.len() + 1..=self.channels.into()).map(|i| i.to_string()));
        names
    }

    fn extra_is_alpha(&self) -> bool {
        matches!(self.extra, 1 | 2)
    }

    /// Whether each channel is stored as an image of its own.
    pub(crate) fn is_planar(&self) -> bool {
        self.planar == 2
    }

    pub(crate) fn planes(&self) -> u16 {
        if self.is_planar() { self.channels } else { 1 }
    }

    /// The stored bytes of a block.
    pub(crate) fn block<'a>(&self, bytes: &'a [u8], index: usize) -> Result<&'a [u8], DecodeError> {
        let (offset, count) = (self.offsets[index], self.byte_counts[index]);
        if count == 0 {
            let found = "blocks that are left out (a sparse file)".to_owned();
            return Err(DecodeError::Unsupported { format: FORMAT, found, accepted: "a file with every block" });
        }
        let range =
            usize::try_from(offset).ok().zip(offset.checked_add(count).and_then(|end| usize::try_from(end).ok()));
        let block = range.and_then(|(start, end)| bytes.get(start..end));
        block.ok_or_else(|| damaged(format!("block {index}, {count} bytes from {offset} on, is not within the file")))
    }
}

/// A number in decimal.
fn no_data(text: &[u8]) -> Result<f64, DecodeError> {
    let text = String::from_utf8_lossy(text);
    let text = text.trim_matches(|c: char| c.is_whitespace() || c == '\0');
    text.parse().map_err(|_| {
        let shown: String = text.chars().filter(|c| !c.is_control()).take(32).collect();
        damaged(format!("its GDAL_NODATA tag is `{shown}`, which is not a number"))
    })
}

const PHOTOMETRICS: [(u64, &str); 6] = [
    (0, "white as 0"),
    (3, "a palette"),
    (4, "a transparency mask"),
    (5, "CMYK colour"),
    (6, "YCbCr colour"),
    (8, "Lab colour"),
];

const COMPRESSIONS: [(u64, &str); 9] = [
    (2, "CCITT compression"),
    (3, "CCITT compression"),
    (4, "CCITT compression"),
    (6, "JPEG compression"),
    (7, "JPEG compression"),
    (34887, "LERC compression"),
    (34925, "LZMA compression"),
    (50000, "ZSTD compression"),
    (50001, "WebP compression"),
];

fn name(names: &[(u64, &str)], value: u64, what: &str) -> String {
    let known = names.iter().find(|(v, _)| *v == value);
    known.map_or_else(|| format!("{what} {value}"), |(_, name)| (*name).to_owned())
}
