//! The mesh a recipe names, read or generated, and what is to be said of it.

use std::path::Path;

use barchan_field::{LengthUnit, Mesh};
use barchan_import::{ImportError, MeshOptions, MeshSourceInfo, buffers_beside, check_file, decode_mesh, read_file};

use crate::mesh_provenance::{MeshOrigin, MeshProvenance};
use crate::report::MeshReport;
use crate::{MeshFile, MeshSource, PipelineError, Recipe, SurfaceSource};

/// A mesh and where it came from.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshInput {
    /// The mesh.
    pub mesh: Mesh,
    /// What its positions are measured in.
    pub unit: LengthUnit,
    /// What an asset says of it.
    pub provenance: MeshProvenance,
    /// What a report says of it.
    pub report: MeshReport,
}

/// Reads or generates the mesh of a recipe. Relative paths start at `folder`.
pub(crate) fn load(recipe: &Recipe, source: &MeshSource, folder: &Path) -> Result<MeshInput, PipelineError> {
    match source {
        MeshSource::Surface(surface) => generate_mesh(surface, recipe.mesh_unit().unwrap_or_default()),
        MeshSource::File(file) => {
            let file = MeshFile { path: folder.join(&file.path), ..file.clone() };
            Ok(read_mesh_file(&file, recipe.mesh_unit())?)
        }
    }
}

/// Refuses what [`load`] would refuse before it reads a file or cuts a surface.
pub(crate) fn foresee(source: &MeshSource, folder: &Path) -> Result<(), PipelineError> {
    match source {
        MeshSource::Surface(source) => {
            let SurfaceSource { surface, tessellation } = source.as_ref();
            surface.validate().and_then(|()| tessellation.validate()).map_err(PipelineError::Surface)
        }
        MeshSource::File(file) => Ok(check_file(&folder.join(&file.path))?),
    }
}

/// A mesh in words, its file as a path from the current folder.
pub(crate) fn words(source: &MeshSource, folder: &Path) -> String {
    match source {
        MeshSource::Surface(source) => surface_words(source),
        MeshSource::File(file) => folder.join(&file.path).display().to_string(),
    }
}

fn surface_words(source: &SurfaceSource) -> String {
    format!("generated {}", source.surface.name())
}

/// Cuts a closed form into triangles.
///
/// # Errors
/// Parameters of the form or of the tessellation that are out of range.
pub fn generate_mesh(source: &SurfaceSource, unit: LengthUnit) -> Result<MeshInput, PipelineError> {
    let SurfaceSource { surface, tessellation } = source;
    let mesh = surface.tessellate(tessellation).map_err(PipelineError::Surface)?.mesh;
    let (vertices, triangles) = (mesh.positions().len() as u64, mesh.triangles().len() as u64);
    Ok(MeshInput {
        mesh,
        unit,
        provenance: MeshProvenance { source: MeshOrigin::Surface(Box::new(*source)), vertices, triangles },
        report: MeshReport {
            source: surface_words(source),
            path: None,
            vertices,
            triangles,
            unit: unit.symbol(),
            seam_vertices: 0,
            polygons: 0,
            uvs_missing: 0,
            normals_missing: 0,
            ignored: 0,
        },
    })
}

/// Reads a mesh; a `unit` overrides what its format says.
///
/// # Errors
/// A file that cannot be read or is no mesh; each begins with the path.
pub fn read_mesh_file(file: &MeshFile, unit: Option<LengthUnit>) -> Result<MeshInput, ImportError> {
    let MeshFile { path, mesh: name } = file;
    let bytes = read_file(path)?;
    let mut digest = blake3::Hasher::new();
    digest.update(&bytes);
    let mut beside = buffers_beside(path);
    // A glTF file may keep its numbers in others: the digest is of all of them, in the order in which they are read.
    let mut read_buffer = |name: &str| {
        let buffer = beside(name)?;
        digest.update(&buffer);
        Ok(buffer)
    };
    let options = MeshOptions { unit, mesh: name.clone(), ..MeshOptions::default() };
    let imported = decode_mesh(&bytes, &options, &mut read_buffer)
        .map_err(|cause| ImportError::Content { path: path.clone(), cause })?;
    let blake3 = digest.finalize().to_hex().to_string();
    let (unit, source) = (imported.unit, &imported.source);
    Ok(MeshInput {
        provenance: MeshProvenance {
            source: MeshOrigin::File { blake3, format: source.format.to_string(), mesh: name.clone() },
            vertices: source.vertices,
            triangles: source.triangles,
        },
        report: report(path, unit, source),
        mesh: imported.mesh,
        unit,
    })
}

fn report(path: &Path, unit: LengthUnit, source: &MeshSourceInfo) -> MeshReport {
    let name = source.name.as_ref().map(|name| format!(", {name:?}")).unwrap_or_default();
    MeshReport {
        source: format!("{} ({}{name})", path.display(), source.format),
        path: Some(path.to_owned()),
        vertices: source.vertices,
        triangles: source.triangles,
        unit: unit.symbol(),
        seam_vertices: source.seam_vertices,
        polygons: source.polygons,
        uvs_missing: source.uvs_missing,
        normals_missing: source.normals_missing,
        ignored: source.ignored,
    }
}
