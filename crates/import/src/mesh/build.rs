//! The last step of every format: what is missing is found, and the mesh made.

use barchan_field::{LengthUnit, Mesh};
use glam::{DVec2, DVec3};

use super::{ImportedMesh, MeshError, MeshOptions, MeshSourceInfo};
use crate::{DecodeError, Format};

/// What stands for "the file states none here"; files cannot say it, as what they state is checked.
pub(crate) const NO_UV: DVec2 = DVec2::NAN;

/// As [`NO_UV`]. A normal that is not finite or has no length is none.
pub(crate) const NO_NORMAL: DVec3 = DVec3::NAN;

/// A decoded file. Per-vertex lists are empty or have one entry per position.
pub(crate) struct RawMesh {
    pub(crate) format: Format,
    pub(crate) name: Option<String>,
    pub(crate) positions: Vec<DVec3>,
    pub(crate) triangles: Vec<[u32; 3]>,
    pub(crate) uvs: Vec<DVec2>,
    pub(crate) normals: Vec<DVec3>,
    pub(crate) polygons: u64,
    pub(crate) seam_vertices: u64,
    pub(crate) ignored: u64,
    pub(crate) buffers: Vec<String>,
}

impl RawMesh {
    pub(crate) fn build(self, options: &MeshOptions) -> Result<ImportedMesh, DecodeError> {
        let Self {
            format,
            name,
            positions,
            triangles,
            mut uvs,
            mut normals,
            polygons,
            seam_vertices,
            ignored,
            buffers,
        } = self;
        let vertices = positions.len() as u64;
        options.check_vertices(format, vertices)?;
        options.check_triangles(format, triangles.len() as u64)?;
        if triangles.is_empty() {
            return Err(MeshError::NoTriangles { format, vertices }.into());
        }
        let mut mesh = Mesh::new(positions, triangles)?;
        let mut uvs_missing = 0;
        if uvs.iter().any(|uv| !uv.is_nan()) {
            uvs_missing = fill_uvs(&mut uvs, &mesh);
            mesh = mesh.with_uvs(uvs)?;
        }
        let mut normals_missing = 0;
        if normals.iter().any(is_usable) {
            normals_missing = fill_normals(&mut normals, &mesh);
            mesh = mesh.with_normals(normals)?;
        }
        let unit = options.unit.unwrap_or(match format {
            Format::Gltf => LengthUnit::Metre,
            _ => LengthUnit::SceneUnit,
        });
        let triangles = mesh.triangles().len() as u64;
        let source = MeshSourceInfo {
            format,
            name,
            vertices,
            triangles,
            polygons,
            seam_vertices,
            uvs_missing,
            normals_missing,
            ignored,
            buffers,
        };
        Ok(ImportedMesh { mesh, unit, source })
    }
}

/// (0, 0) where there is none: a triangle of such corners has no area in the texture, which bakers know to handle.
fn fill_uvs(uvs: &mut [DVec2], mesh: &Mesh) -> u64 {
    fill(uvs, |uv| !uv.is_nan(), DVec2::ZERO, mesh)
}

/// No length where there is none, or none that points anywhere: such a normal says nothing of hard edges.
fn fill_normals(normals: &mut [DVec3], mesh: &Mesh) -> u64 {
    fill(normals, is_usable, DVec3::ZERO, mesh)
}

fn is_usable(normal: &DVec3) -> bool {
    normal.is_finite() && *normal != DVec3::ZERO
}

/// Puts `nothing` where a value does not count, and counts the vertices of triangles among them.
fn fill<T: Copy>(values: &mut [T], counts: impl Fn(&T) -> bool, nothing: T, mesh: &Mesh) -> u64 {
    if values.iter().all(&counts) {
        return 0;
    }
    let mut is_used = vec![false; values.len()];
    for &corner in mesh.triangles().iter().flatten() {
        is_used[corner as usize] = true;
    }
    let mut missing = 0;
    for (value, is_used) in values.iter_mut().zip(is_used).filter(|(value, _)| !counts(value)) {
        *value = nothing;
        missing += u64::from(is_used);
    }
    missing
}
