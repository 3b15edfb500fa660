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
        let mut normals_replaced = 0;
        if normals.iter().any(is_usable) {
            normals_replaced = replace_normals(&mut normals, &mesh);
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
            normals_replaced,
            ignored,
            buffers,
        };
        Ok(ImportedMesh { mesh, unit, source })
    }
}

/// Which vertices a triangle has.
fn used(mesh: &Mesh) -> Vec<bool> {
    let mut used = vec![false; mesh.positions().len()];
    for &corner in mesh.triangles().iter().flatten() {
        used[corner as usize] = true;
    }
    used
}

/// (0, 0) where there is none: a triangle of such corners has no area in the texture, which bakers know to handle.
fn fill_uvs(uvs: &mut [DVec2], mesh: &Mesh) -> u64 {
    if uvs.iter().all(|uv| !uv.is_nan()) {
        return 0;
    }
    let mut missing = 0;
    for (uv, is_used) in uvs.iter_mut().zip(used(mesh)).filter(|(uv, _)| uv.is_nan()) {
        *uv = DVec2::ZERO;
        missing += u64::from(is_used);
    }
    missing
}

fn is_usable(normal: &DVec3) -> bool {
    normal.is_finite() && *normal != DVec3::ZERO
}

/// The normal of the triangles around a vertex, weighed by area, where it has no usable one; +z where they have none
/// either.
fn replace_normals(normals: &mut [DVec3], mesh: &Mesh) -> u64 {
    let is_missing: Vec<bool> = normals.iter().map(|normal| !is_usable(normal)).collect();
    if !is_missing.contains(&true) {
        return 0;
    }
    for (normal, _) in normals.iter_mut().zip(&is_missing).filter(|(_, is_missing)| **is_missing) {
        *normal = DVec3::ZERO;
    }
    for &triangle in mesh.triangles() {
        let [a, b, c] = triangle.map(|corner| mesh.positions()[corner as usize]);
        let normal = (b - a).cross(c - a);
        for corner in triangle.map(|corner| corner as usize).into_iter().filter(|&corner| is_missing[corner]) {
            normals[corner] += normal;
        }
    }
    let mut replaced = 0;
    let marks = is_missing.iter().zip(used(mesh));
    for (normal, (_, is_used)) in normals.iter_mut().zip(marks).filter(|(_, (is_missing, _))| **is_missing) {
        *normal = normal.try_normalize().unwrap_or(DVec3::Z);
        replaced += u64::from(is_used);
    }
    replaced
}
