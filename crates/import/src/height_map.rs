//! The two entrances, and what they give.

use std::{fs, io, path::Path};

use barchan_field::{Grid, HeightField};

use crate::{
    DecodeError, Format, HeightMapOptions, ImportError,
    detect::{HEIGHT_MAPS, detect_needed},
    exr,
    fill::fill,
    heights::heights,
    npy, png, tiff,
};

/// A height field and what was learnt of its source.
#[derive(Debug, Clone, PartialEq)]
pub struct HeightMap {
    /// Finite heights.
    pub field: HeightField,
    /// Where they came from.
    pub source: SourceInfo,
}

/// What the file was.
#[derive(Debug, Clone, PartialEq)]
pub struct SourceInfo {
    /// The file format.
    pub format: Format,
    /// How the file stores a sample: `u1` … `u32`, `i8` … `i32`, `f16`, `f32` or `f64`.
    pub sample_type: String,
    /// The channel read, `Y` for the only one of a grey image, `R=G=B` for grey saved as colour.
    pub channel: String,
    /// Texels whose height came from [`HeightMapOptions::fill`].
    pub filled: u64,
    /// Lowest and highest raw sample, before normalisation and scale; those of filled texels do not count.
    pub raw_range: (f64, f64),
}

/// Reads a file and decodes it: [`read_file`], then [`decode_height_map`], with its path in the message of every error.
pub fn read_height_map(path: &Path, options: &HeightMapOptions) -> Result<HeightMap, ImportError> {
    let bytes = read_file(path)?;
    decode_height_map(&bytes, options).map_err(|cause| ImportError::Content { path: path.to_owned(), cause })
}

/// The bytes of a file. Folders are told from files here, and pipes and devices, which may have no end, are not read.
pub fn read_file(path: &Path) -> Result<Vec<u8>, ImportError> {
    read_regular(path).map_err(|cause| ImportError::Io { path: path.to_owned(), cause })
}

/// Whether there is a file that [`read_file`] would begin to read; nothing of it is.
pub fn check_file(path: &Path) -> Result<(), ImportError> {
    check_regular(path).map_err(|cause| ImportError::Io { path: path.to_owned(), cause })
}

pub(crate) fn read_regular(path: &Path) -> io::Result<Vec<u8>> {
    check_regular(path)?;
    fs::read(path)
}

fn check_regular(path: &Path) -> io::Result<()> {
    let about = fs::metadata(path)?;
    if about.is_dir() {
        return Err(io::ErrorKind::IsADirectory.into());
    }
    if !about.is_file() {
        return Err(io::Error::other("it is a pipe or a device; a file on disk is needed"));
    }
    Ok(())
}

/// Decodes the bytes of a PNG, EXR, TIFF or NPY file. What is done to them is in the crate's documentation.
pub fn decode_height_map(bytes: &[u8], options: &HeightMapOptions) -> Result<HeightMap, DecodeError> {
    options.check()?;
    let raw = match detect_needed(bytes, HEIGHT_MAPS)? {
        Format::Png => png::decode(bytes, options)?,
        Format::Exr => exr::decode(bytes, options)?,
        Format::Tiff => tiff::decode(bytes, options)?,
        Format::Npy => npy::decode(bytes, options)?,
        mesh @ (Format::Obj | Format::Ply | Format::Gltf) => return Err(mesh.refused(HEIGHT_MAPS)),
    };
    let mut map = heights(&raw, options)?;
    fill(&mut map, raw.width, options.edge, options.fill)?;
    let source = SourceInfo {
        format: raw.format,
        sample_type: raw.sample_type.name(),
        channel: raw.channel,
        filled: map.missing,
        raw_range: map.raw_range,
    };
    let HeightMapOptions { spacing, unit, edge, .. } = *options;
    let grid = Grid { width: raw.width, height: raw.height, spacing, unit, edge };
    Ok(HeightMap { field: HeightField::new(grid, map.heights)?, source })
}
