//! What an asset says of the mesh its curvature is of, and of how that curvature was found.

use barchan_asset::VertexFlags;
use barchan_bakers::curvature::{self, MeshCurvature, MeshReport};
use serde::{Deserialize, Serialize};

use crate::{CurvatureMethod, CurvatureRecipe, SurfaceSource};

/// The mesh that was baked from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MeshProvenance {
    /// Where it came from.
    pub source: MeshOrigin,
    /// Vertices, which is also the length of the table.
    pub vertices: u64,
    /// Triangles.
    pub triangles: u64,
}

/// Where a mesh came from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum MeshOrigin {
    /// A file.
    File {
        /// BLAKE3 of its bytes, and of the buffers that a glTF file keeps beside it, in hexadecimal.
        blake3: String,
        /// Its format.
        format: String,
        /// Which of its meshes, if one was named.
        mesh: Option<String>,
    },
    /// A closed form.
    Surface(Box<SurfaceSource>),
}

/// What baked the curvature, with what, and what it found on the way.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CurvatureProvenance {
    /// Changes when the same input gives other bytes.
    pub algorithm: String,
    /// How exactly.
    pub method: CurvatureMethod,
    /// Where the surface is not smooth across an edge, in degrees between the mesh's normals.
    pub hard_edge_degrees: f64,
    /// What was mended.
    pub mended: MendedMesh,
    /// Standard deviation of the vertices off the smooth surface, in the length unit; 0 where none can be told.
    pub noise: f64,
    /// The least κ2 and the greatest κ1 of the vertices whose curvature is known, in 1 / length unit, before encoding; `None` if
    /// there is none.
    pub range: Option<(f64, f64)>,
    /// How many vertices have each remark that any has.
    pub flagged: Vec<FlagCount>,
}

/// A remark, and on how many vertices.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct FlagCount {
    /// The remark's name, as [`VertexFlags::ALL`] has it.
    pub flag: String,
    /// Vertices.
    pub vertices: u64,
}

/// What was mended in a mesh, or could not be: [`MeshReport`], for files.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct MendedMesh {
    /// Mean length of the edges between distinct points.
    pub mean_edge: f64,
    /// Places on smooth sheets that the vertices were welded into.
    pub points: u64,
    /// Triangles turned over so that neighbours agree.
    pub flipped_triangles: u64,
    /// Edges across which no orientation is consistent.
    pub unorientable_edges: u64,
    /// Triangles left out because two of their corners are one point.
    pub collapsed_triangles: u64,
    /// Triangles left out because another has the same corners.
    pub duplicate_triangles: u64,
    /// Edges at which more than two triangles meet.
    pub non_manifold_edges: u64,
    /// Edges across which the mesh's normals say that the surface is not smooth.
    pub hard_edges: u64,
}

impl From<MeshReport> for MendedMesh {
    fn from(report: MeshReport) -> Self {
        Self {
            mean_edge: report.mean_edge,
            points: report.points,
            flipped_triangles: report.flipped_triangles,
            unorientable_edges: report.unorientable_edges,
            collapsed_triangles: report.collapsed_triangles,
            duplicate_triangles: report.duplicate_triangles,
            non_manifold_edges: report.non_manifold_edges,
            hard_edges: report.hard_edges,
        }
    }
}

impl CurvatureProvenance {
    /// `flags` are all remarks on each vertex, those on texture coordinates too.
    pub(crate) fn new(recipe: &CurvatureRecipe, found: &MeshCurvature, flags: &[VertexFlags]) -> Self {
        let count = |flag| flags.iter().filter(|flags| flags.contains(flag)).count() as u64;
        let counts = VertexFlags::ALL.into_iter().map(|(flag, name)| (name.to_owned(), count(flag)));
        Self {
            algorithm: curvature::ALGORITHM.to_owned(),
            method: recipe.method,
            hard_edge_degrees: recipe.hard_edge_degrees,
            mended: found.report.into(),
            noise: found.noise,
            range: range(found),
            flagged: counts
                .filter(|(_, vertices)| *vertices > 0)
                .map(|(flag, vertices)| FlagCount { flag, vertices })
                .collect(),
        }
    }
}

/// The least κ2 and the greatest κ1, if any is known.
fn range(found: &MeshCurvature) -> Option<(f64, f64)> {
    let known = found.vertices.iter().filter(|vertex| !vertex.flags.is_unknown());
    known.map(|vertex| (vertex.principal[1], vertex.principal[0])).reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
}
