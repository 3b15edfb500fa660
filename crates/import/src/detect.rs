//! What a file is, by its first bytes.

use std::fmt;

use crate::DecodeError;

/// A file format that height maps or meshes are read from.
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
    /// Wavefront OBJ.
    Obj,
    /// The Stanford polygon format.
    Ply,
    /// glTF 2.0, as JSON (.gltf) or in one piece (.glb).
    Gltf,
}

impl Format {
    /// The name as in messages.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Png => "PNG",
            Self::Exr => "EXR",
            Self::Tiff => "TIFF",
            Self::Npy => "NPY",
            Self::Obj => "OBJ",
            Self::Ply => "PLY",
            Self::Gltf => "glTF",
        }
    }

    /// Whether such a file holds a mesh, and not a height map.
    #[must_use]
    pub fn is_mesh(self) -> bool {
        matches!(self, Self::Obj | Self::Ply | Self::Gltf)
    }

    /// The error where a format of the other kind was given.
    pub(crate) fn refused(self, needed: &'static str) -> DecodeError {
        let article = if matches!(self, Self::Exr | Self::Npy | Self::Obj) { "an" } else { "a" };
        let kind = if self.is_mesh() { "mesh" } else { "image" };
        DecodeError::UnknownFormat { found: format!("{article} {self} {kind}"), needed }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// Files that height maps are read from.
pub(crate) const HEIGHT_MAPS: &str = "a PNG, EXR, TIFF or NPY file";
/// Files that meshes are read from.
pub(crate) const MESHES: &str = "an OBJ, PLY or glTF file";
/// Either.
pub(crate) const ALL: &str = "a PNG, EXR, TIFF, NPY, OBJ, PLY or glTF file";

const OURS: [(&[u8], Format); 10] = [
    (b"\x89PNG\r\n\x1a\n", Format::Png),
    (b"\x76\x2f\x31\x01", Format::Exr),
    (b"II*\0", Format::Tiff),
    (b"MM\0*", Format::Tiff),
    (b"II+\0", Format::Tiff),
    (b"MM\0+", Format::Tiff),
    (b"\x93NUMPY", Format::Npy),
    (b"ply\n", Format::Ply),
    (b"ply\r", Format::Ply),
    (b"glTF", Format::Gltf),
];

/// Files people try, for a message that helps.
const OTHERS: [(&[u8], &str); 19] = [
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
    (b"solid ", "an STL"),
    (b"OFF", "an OFF mesh"),
    (b"Kaydara FBX", "an FBX"),
    (b"# vtk DataFile", "a VTK file"),
];

/// First words of OBJ lines.
const OBJ_STATEMENTS: [&[u8]; 19] = [
    b"v", b"vt", b"vn", b"vp", b"f", b"fo", b"l", b"p", b"o", b"g", b"s", b"mg", b"mtllib", b"usemtl", b"usemap",
    b"maplib", b"cstype", b"deg", b"lod",
];

/// What the file is, by its content and never by its name. PNG, EXR, TIFF, NPY, PLY and binary glTF begin with a
/// signature; a text that begins with `{` is taken for glTF, and one whose first line that is neither blank nor a
/// comment is an OBJ statement, for OBJ.
///
/// # Errors
/// [`DecodeError::EmptyFile`] and [`DecodeError::UnknownFormat`], which says what the bytes seem to be instead.
pub fn detect(bytes: &[u8]) -> Result<Format, DecodeError> {
    detect_needed(bytes, ALL)
}

/// The format; the message of an error says what is `needed`.
pub(crate) fn detect_needed(bytes: &[u8], needed: &'static str) -> Result<Format, DecodeError> {
    if bytes.is_empty() {
        return Err(DecodeError::EmptyFile { needed });
    }
    if let Some((_, format)) = OURS.iter().find(|(magic, _)| bytes.starts_with(magic)) {
        return Ok(*format);
    }
    if let Some((_, name)) = OTHERS.iter().find(|(magic, _)| bytes.starts_with(magic)) {
        return Err(DecodeError::UnknownFormat { found: (*name).to_owned(), needed });
    }
    if let Some(format) = detect_text(bytes) {
        return Ok(format);
    }
    let hex: Vec<String> = bytes.iter().take(8).map(|b| format!("{b:02x}")).collect();
    Err(DecodeError::UnknownFormat {
        found: format!("of an unknown format (it begins with {})", hex.join(" ")),
        needed,
    })
}

fn detect_text(bytes: &[u8]) -> Option<Format> {
    let text = without_mark(bytes);
    let line = text.split(|&b| b == b'\n' || b == b'\r').map(<[u8]>::trim_ascii);
    let line = line.into_iter().find(|line| !line.is_empty() && line[0] != b'#')?;
    if line[0] == b'{' {
        return Some(Format::Gltf);
    }
    let word = line.split(u8::is_ascii_whitespace).next()?;
    OBJ_STATEMENTS.contains(&word).then_some(Format::Obj)
}

/// Without the byte order mark that some editors put before UTF-8.
pub(crate) fn without_mark(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes)
}
