//! A mesh as smooth sheets of surface.

use barchan_asset::VertexFlags;
use barchan_field::Mesh;
use glam::DVec3;

use super::MeshReport;

/// Smooth, consistently oriented sheets: a *point* is a place on one sheet, shared by all vertices that are welded there.
#[derive(Debug, Clone, Default)]
pub(super) struct Sheets {
    /// Where every point is.
    pub(super) positions: Vec<DVec3>,
    /// Unit normals of points, of their triangles weighted by angle; zero where no triangle has an area.
    pub(super) normals: Vec<DVec3>,
    /// `neighbours[starts[p]..starts[p + 1]]` are the points that share an edge with point p.
    pub(super) starts: Vec<u32>,
    /// See `starts`.
    pub(super) neighbours: Vec<u32>,
    /// Remarks on points: [`VertexFlags::BOUNDARY`], [`VertexFlags::NON_MANIFOLD`].
    pub(super) flags: Vec<VertexFlags>,
    /// The point that speaks for a vertex; `None` if no triangle uses it, or only such as have fewer than three points.
    pub(super) point_of_vertex: Vec<Option<u32>>,
    /// What was mended.
    pub(super) report: MeshReport,
}

impl Sheets {
    /// Welds, orients and cuts a mesh.
    pub(super) fn of(mesh: &Mesh, hard_edge_degrees: f64) -> Self {
        let _ = (mesh, hard_edge_degrees);
        Self::default()
    }
}
