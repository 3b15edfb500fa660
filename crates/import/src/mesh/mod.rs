//! Meshes: the two entrances, and what they give. The conventions are in the crate's documentation.

mod build;
mod error;
mod gltf;
mod obj;
mod options;
mod ply;
mod polygon;
mod seams;

use std::{fs, io, path::Path};

use barchan_field::{LengthUnit, Mesh};

pub use error::MeshError;
pub use options::MeshOptions;

use crate::{
    DecodeError, Format, ImportError,
    detect::{MESHES, detect_needed},
    height_map::read_regular,
    read_file,
};

/// A mesh and what was learnt of its source.
#[derive(Debug, Clone, PartialEq)]
pub struct ImportedMesh {
    /// Finite positions, triangles, and what the file says of texture coordinates (v up) and normals.
    pub mesh: Mesh,
    /// What positions are measured in.
    pub unit: LengthUnit,
    /// Where it came from.
    pub source: MeshSourceInfo,
}

/// What the file was, and what was done where it does not fit a mesh of one row per vertex.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshSourceInfo {
    /// The file format.
    pub format: Format,
    /// The name of the mesh, where the format has names and the file uses one.
    pub name: Option<String>,
    /// Vertices of the mesh, those of seams included.
    pub vertices: u64,
    /// Triangles of the mesh.
    pub triangles: u64,
    /// Faces of more than three corners, which were cut into triangles.
    pub polygons: u64,
    /// Vertices that an OBJ file does not have as `v`: one for each further pair of texture coordinate and normal.
    pub seam_vertices: u64,
    /// Vertices of triangles that have no texture coordinate where others have one; theirs is (0, 0).
    pub uvs_missing: u64,
    /// Vertices of triangles without a usable normal where others have one; theirs has no length and says nothing.
    pub normals_missing: u64,
    /// Points, lines, curves and faces of fewer than three corners, which are no surface and were left out.
    pub ignored: u64,
    /// Files beside this one that were read, as paths below its folder.
    pub buffers: Vec<String>,
}

/// Reads a file and decodes it: [`read_file`], then [`decode_mesh`] with [`buffers_beside`] it; every error begins with
/// the path.
pub fn read_mesh(path: &Path, options: &MeshOptions) -> Result<ImportedMesh, ImportError> {
    let bytes = read_file(path)?;
    decode_mesh(&bytes, options, &mut buffers_beside(path))
        .map_err(|cause| ImportError::Content { path: path.to_owned(), cause })
}

/// Decodes the bytes of an OBJ, PLY or glTF file.
///
/// `read_buffer` is asked for the buffers that a glTF keeps in other files, by relative paths such as `duck.bin` or
/// `buffers/duck.bin`: `/` separates, percent signs are decoded, and no part is empty, `.` or `..`. [`buffers_beside`]
/// reads them from a folder, [`no_buffers`] refuses.
pub fn decode_mesh(
    bytes: &[u8],
    options: &MeshOptions,
    read_buffer: &mut dyn FnMut(&str) -> io::Result<Vec<u8>>,
) -> Result<ImportedMesh, DecodeError> {
    let format = detect_needed(bytes, MESHES)?;
    if let (Format::Obj | Format::Ply, Some(wanted)) = (format, options.mesh.clone()) {
        let present = "none (it holds one mesh)".to_owned();
        return Err(MeshError::NoSuchMesh { format, wanted, present }.into());
    }
    let raw = match format {
        Format::Obj => obj::decode(bytes, options)?,
        Format::Ply => ply::decode(bytes, options)?,
        Format::Gltf => gltf::decode(bytes, options, read_buffer)?,
        image @ (Format::Png | Format::Exr | Format::Tiff | Format::Npy) => return Err(image.refused(MESHES)),
    };
    raw.build(options)
}

/// Reads buffers from the folder of `path` and its folders, and from nowhere else: a link that leads out is refused,
/// too.
pub fn buffers_beside(path: &Path) -> impl FnMut(&str) -> io::Result<Vec<u8>> {
    let folder = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent.to_owned(),
        _ => Path::new(".").to_owned(),
    };
    move |name| {
        let folder = fs::canonicalize(&folder)?;
        let file = fs::canonicalize(folder.join(name))?;
        if !file.starts_with(&folder) {
            return Err(io::Error::other("it lies outside the folder of the glTF file"));
        }
        read_regular(&file)
    }
}

/// For files that need nothing beside them.
pub fn no_buffers(_: &str) -> io::Result<Vec<u8>> {
    Err(io::Error::other("files beside this one are not read here"))
}
