//! Principal curvature per vertex of a mesh.

mod chart;
mod estimate;
mod frame;
mod jet;
mod narrow;
mod neighbourhood;
mod noise;
mod params;
mod patch;
mod sheets;
mod table;

pub use chart::{VertexForms, forms};
pub use params::{CurvatureMethod, CurvatureParams};
pub use table::{MeshCurvature, MeshReport, VertexCurvature};

use barchan_asset::VertexFlags;
use barchan_field::Mesh;

use sheets::Sheets;

use crate::{BakeError, Exec};

/// Names the algorithm in provenance. It changes when a bake's bytes do.
pub const ALGORITHM: &str = "curvature-jets-1";

/// Bakes the curvature of every vertex.
///
/// # Errors
/// Parameters out of range, or more than 700 million triangles.
pub fn bake(mesh: &Mesh, params: &CurvatureParams, exec: &Exec) -> Result<MeshCurvature, BakeError> {
    params.check()?;
    sheets::check_size(mesh.triangles().len())?;
    let sheets = Sheets::of(mesh, params.hard_edge_degrees, exec);
    let mut found = narrow::fit_all(&sheets, params.method, exec);
    let noise = match params.method {
        CurvatureMethod::Fast => None,
        CurvatureMethod::Accurate => noise::noise(&found),
    };
    if let Some(noise) = noise {
        noise::refit(&sheets, noise, &mut found, exec);
    }
    let of_point = |point: &Option<u32>| match point {
        Some(point) => found[*point as usize].curvature,
        None => VertexCurvature { flags: VertexFlags::ISOLATED, ..VertexCurvature::UNKNOWN },
    };
    let vertices = sheets.point_of_vertex.iter().map(of_point).collect();
    Ok(MeshCurvature { vertices, report: sheets.report, noise: noise.map_or(0.0, f64::sqrt) })
}
