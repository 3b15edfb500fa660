//! Curvature in texture coordinates.

use barchan_asset::VertexFlags;
use barchan_field::Mesh;
use glam::DVec2;

use super::MeshCurvature;
use crate::Exec;

/// The fundamental forms of the surface at one vertex, in the chart of its texture coordinates.
///
/// Along (du, dv) the normal curvature is κ = (e du² + 2f du dv + g dv²) / (E du² + 2F du dv + G dv²).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VertexForms {
    /// E, F, G: length² per unit of texture coordinate squared.
    pub first: [f64; 3],
    /// e, f, g: length per unit of texture coordinate squared, positive where convex.
    pub second: [f64; 3],
    /// The (u, v) images of the unit principal directions: V1, V2, per length.
    pub uv_directions: [DVec2; 2],
    /// [`VertexFlags::MIRRORED_UV`], [`VertexFlags::DEGENERATE_UV`].
    pub flags: VertexFlags,
}

/// The forms of every vertex; `None` for a mesh without texture coordinates.
#[must_use]
pub fn forms(mesh: &Mesh, curvature: &MeshCurvature, exec: &Exec) -> Option<Vec<VertexForms>> {
    let _ = (mesh.uvs()?, curvature, exec);
    None
}
