//! PNG, EXR, TIFF and NPY files into height fields; every convention is decided here.
//!
//! [`read_height_map`] reads a file, [`decode_height_map`] bytes in memory. Both give a [`HeightMap`]: a
//! [`HeightField`](barchan_field::HeightField) of finite heights and what was learnt of its source.
//!
//! # From file to sample
//!
//! - The **format** is told by the first bytes, never by the file's name: PNG (1 to 16 bits), OpenEXR (f16, f32, u32; all
//!   compressions but B44 and HTJ2K; scan lines and tiles), TIFF and BigTIFF (8-, 16- and 32-bit integers, f16, f32, f64; strips
//!   and tiles; uncompressed, LZW, deflate, PackBits; predictors), NPY (u1 to u4, i1 to i4, f2, f4, f8; two dimensions; C
//!   and Fortran order; either byte order). Of several images in a TIFF the first is read, of several levels in an EXR the
//!   largest.
//! - **Row 0** of the file is the top of the picture; in NPY the first index is the row. A TIFF orientation other than
//!   top-left is refused. EXR pixels are those of the data window; where the display window lies does not matter.
//! - **Samples are numbers, not colours**: no sRGB, gamma or colour profile is ever applied, and GDAL's scale and offset
//!   metadata is not read. A PNG palette is expanded to R, G, B; a TIFF palette is refused.
//!
//! # From channels to one
//!
//! A named [`channel`](HeightMapOptions::channel) is taken as it is. If none is named: the only channel that is not alpha;
//! else `Y`; else `R` if R, G and B are equal in every texel (grey saved as colour); else an error that lists the choices.
//! The channel of a grey PNG, TIFF or NPY is called `Y`, alpha `A`, the bands of a many-band TIFF `1`, `2`, …; EXR
//! channels have the names they have in the file, and the first layer that answers is used.
//!
//! # From sample to height
//!
//! - `height = sample × height_scale + height_offset`, in f64, rounded once to f32. Float samples are taken as they are.
//!   **Integer samples are divided by the largest value of their type first**: 0 stays 0 and full scale becomes 1, for
//!   signed types too. [`Integers::Raw`] takes them as they are, for elevation models in whole metres.
//! - A **texel without a height** is one whose sample is NaN, infinite, or a no-data value: the caller's
//!   [`no_data`](HeightMapOptions::no_data) or the file's own GDAL_NODATA tag, both compared with the raw sample, exactly
//!   and (for float samples) after rounding to the sample's type. Without a [`Fill`] such a texel is an error.
//! - A finite sample whose height leaves the range of f32 is always an error.
//!
//! # Strangers' files
//!
//! No input makes this crate panic, and nothing is allocated on the word of a header alone: an image may have
//! [`max_texels`](HeightMapOptions::max_texels) at most, and its samples may take 2048 bytes for each byte of the file.
//! Deflate, the densest compression these formats share, reaches 1032, TIFF's LZW 1363. EXR's DWA, which makes two numbers
//! of a flat square of 8 × 8 and deflates them, is allowed 16 times more.

mod channel;
mod detect;
mod error;
mod exr;
mod exr_guard;
mod fill;
mod height_map;
mod heights;
mod limits;
mod mesh;
mod npy;
mod options;
mod png;
mod samples;
mod tiff;

pub use detect::{Format, detect};
pub use error::{DecodeError, ImportError};
pub use height_map::{HeightMap, SourceInfo, decode_height_map, read_file, read_height_map};
pub use mesh::{
    ImportedMesh, MeshError, MeshOptions, MeshSourceInfo, buffers_beside, decode_mesh, no_buffers, read_mesh,
};
pub use options::{Fill, HeightMapOptions, Integers};
