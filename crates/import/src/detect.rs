//! What a file is, by its first bytes.

use std::fmt;

use crate::DecodeError;

/// A file format that height maps are read from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Format {
    /// Portable Network Graphics.
    Png,
    /// OpenEXR.
    Exr,
    /// TIFF or BigTIFF.
    Tiff,
    /// A NumPy array.
    Npy,
}

impl Format {
    /// The name in capitals, as in messages.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Png => "PNG",
            Self::Exr => "EXR",
            Self::Tiff => "TIFF",
            Self::Npy => "NPY",
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

const OURS: [(&[u8], Format); 7] = [
    (b"\x89PNG\r\n\x1a\n", Format::Png),
    (b"\x76\x2f\x31\x01", Format::Exr),
    (b"II*\0", Format::Tiff),
    (b"MM\0*", Format::Tiff),
    (b"II+\0", Format::Tiff),
    (b"MM\0+", Format::Tiff),
    (b"\x93NUMPY", Format::Npy),
];

/// Files people try, for a message that helps.
const OTHERS: [(&[u8], &str); 15] = [
    (b"\x89BARCHAN", "a .barchan file, which is baked already"),
    (b"\x89PNG", "a PNG damaged in transfer (its line ends were converted)"),
    (b"\xff\xd8\xff", "a JPEG"),
    (b"GIF8", "a GIF"),
    (b"BM", "a BMP"),
    (b"RIFF", "a RIFF file, perhaps WebP"),
    (b"#?RADIANCE", "a Radiance HDR"),
    (b"#?RGBE", "a Radiance HDR"),
    (b"DDS ", "a DDS"),
    (b"\xabKTX", "a KTX"),
    (b"8BPS", "a Photoshop document"),
    (b"PK\x03\x04", "a ZIP archive, perhaps NPZ"),
    (b"\x1f\x8b", "compressed with gzip"),
    (b"\x89HDF", "an HDF5 file, perhaps NetCDF"),
    (b"ncols", "an ESRI ASCII grid"),
];

/// The format of `bytes`, or what they seem to be instead.
pub(crate) fn detect(bytes: &[u8]) -> Result<Format, DecodeError> {
    if bytes.is_empty() {
        return Err(DecodeError::EmptyFile);
    }
    if let Some((_, format)) = OURS.iter().find(|(magic, _)| bytes.starts_with(magic)) {
        return Ok(*format);
    }
    let found = match OTHERS.iter().find(|(magic, _)| bytes.starts_with(magic)) {
        Some((_, name)) => (*name).to_owned(),
        None => {
            let hex: Vec<String> = bytes.iter().take(8).map(|b| format!("{b:02x}")).collect();
            format!("of an unknown format (it begins with {})", hex.join(" "))
        }
    };
    Err(DecodeError::UnknownFormat { found })
}
