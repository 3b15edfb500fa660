//! PNG, EXR, TIFF and NPY files into height fields, OBJ, PLY and glTF files into meshes; every convention is decided
//! here.
//!
//! [`read_height_map`] reads a file, [`decode_height_map`] bytes in memory. Both give a [`HeightMap`]: a
//! [`HeightField`](barchan_field::HeightField) of finite heights and what was learnt of its source. [`read_mesh`] and
//! [`decode_mesh`] give an [`ImportedMesh`]: a [`Mesh`](barchan_field::Mesh) and as much. [`detect`] tells which of
//! them a file is for.
//!
//! # From file to sample
//!
//! - The **format** is told by the content, never by the file's name: PNG (1 to 16 bits), OpenEXR (f16, f32, u32; all
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
//! # From file to mesh
//!
//! - **Formats**: OBJ; PLY in text and both byte orders; glTF 2.0 as `.gltf`, its buffers in base64 or in files beside
//!   it, and as `.glb`. Of a glTF with several meshes the caller names [one](MeshOptions::mesh); its nodes' transforms,
//!   morph targets and skins are not applied. Geometry compressed by Draco or meshopt is refused; quantised geometry is
//!   read in its own units.
//! - **Row i** is vertex i of the file. In glTF that is the accessors of its primitives one after the other, those that
//!   share them once. In OBJ it is the i-th `v`; where corners give one `v` several pairs of texture coordinate and
//!   normal, told apart by value, the first stays and the others follow behind the last `v`, in order of first use.
//!   Unused vertices are kept.
//! - **Positions** are f64: digits of a text and doubles keep their bits. One that is not finite is refused and named.
//! - **Triangles** keep the file's order and corners, counter-clockwise from the front. A polygon is a fan from its
//!   first corner if it is strictly convex, and is cut into ears otherwise. Strips and fans become triangles. Points,
//!   lines, curves and faces of fewer than three corners are left out and [counted](MeshSourceInfo::ignored); a file
//!   without any triangle is refused.
//! - **Texture coordinates** have v up the picture: those of OBJ and PLY as they are, `1 − v` of glTF, whose v runs
//!   down. One that is not finite is refused. If some vertices have one, those without get (0, 0) and are
//!   [counted](MeshSourceInfo::uvs_missing). In PLY, those of vertices are read, under the names (s, t), (u, v),
//!   (texture_u, texture_v) or (texture_s, texture_t); those of face corners are not.
//! - **Normals** are as stated, of any length. One that is missing, zero or not finite becomes a normal of no length,
//!   which says nothing, and is [counted](MeshSourceInfo::normals_missing); if none is usable, the mesh has none. No
//!   normal stops a bake.
//! - The **unit** is a label: metres in glTF, the scene's own elsewhere, unless [told](MeshOptions::unit) otherwise.
//!
//! # Strangers' files
//!
//! No input makes this crate panic, and nothing is allocated on the word of a header alone: an image may have
//! [`max_texels`](HeightMapOptions::max_texels) at most, and its samples may take 2048 bytes for each byte of the file.
//! Deflate, the densest compression these formats share, reaches 1032, TIFF's LZW 1363. EXR's DWA, which makes two numbers
//! of a flat square of 8 × 8 and deflates them, is allowed 16 times more.
//!
//! A mesh may have [`max_vertices`](MeshOptions::max_vertices) and [`max_triangles`](MeshOptions::max_triangles) at
//! most, the counts of its headers must fit the bytes there are, and a glTF has no more vertices or triangles than
//! bytes. Files beside a glTF are read from its folder and the folders in it, and from nowhere else.

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
pub use height_map::{HeightMap, SourceInfo, check_file, decode_height_map, read_file, read_height_map};
pub use mesh::{
    ImportedMesh, MeshError, MeshOptions, MeshSourceInfo, buffers_beside, decode_mesh, no_buffers, read_mesh,
};
pub use options::{Fill, HeightMapOptions, Integers};
