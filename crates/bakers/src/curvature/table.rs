//! What is found: the curvature of every vertex, in the mesh's own order.

use barchan_asset::VertexFlags;
use glam::DVec3;

/// The curvature of the surface at one vertex.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VertexCurvature {
    /// κ1 ≥ κ2 in 1 / length unit, positive where the surface is convex seen from the front of its triangles.
    pub principal: [f64; 2],
    /// Unit tangents along which they are found; their sign means nothing. With [`Self::normal`] they are an orthonormal frame.
    pub directions: [DVec3; 2],
    /// The unit normal of the surface, towards the front.
    pub normal: DVec3,
    /// Remarks. Those on texture coordinates belong to [`forms`](super::forms).
    pub flags: VertexFlags,
}

impl VertexCurvature {
    /// What stands for a curvature that cannot be known, before its cause is flagged.
    pub const UNKNOWN: Self =
        Self { principal: [0.0; 2], directions: [DVec3::X, DVec3::Y], normal: DVec3::Z, flags: VertexFlags::NONE };
}

/// Curvature per vertex.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshCurvature {
    /// One per vertex of the mesh, in its order.
    pub vertices: Vec<VertexCurvature>,
    /// What was found out about the mesh on the way.
    pub report: MeshReport,
    /// Standard deviation of the vertices off the smooth surface, in the mesh's length unit; 0 where none can be told from the
    /// surface's own shape.
    pub noise: f64,
}

/// What was mended in a mesh, or could not be.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct MeshReport {
    /// Mean length of the edges between distinct points.
    pub mean_edge: f64,
    /// Places on sheets that vertices were welded into.
    pub points: u64,
    /// Triangles turned over so that neighbours agree.
    pub flipped_triangles: u64,
    /// Edges across which no orientation is consistent, as on a Möbius strip: the surface is cut there.
    pub unorientable_edges: u64,
    /// Triangles left out because two of their corners are one point.
    pub collapsed_triangles: u64,
    /// Triangles left out because another has the same corners.
    pub duplicate_triangles: u64,
    /// Edges at which more than two triangles meet: the two that continue each other most smoothly stay together.
    pub non_manifold_edges: u64,
    /// Edges across which the mesh's normals say that the surface is not smooth.
    pub hard_edges: u64,
}
