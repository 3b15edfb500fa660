//! Principal curvature per vertex of a mesh.

mod chart;
mod estimate;
mod frame;
mod jet;
mod knob;
mod narrow;
mod neighbourhood;
mod params;
mod sheets;
mod table;

pub use chart::{VertexForms, forms};
pub use params::{CurvatureMethod, CurvatureParams};
pub use table::{MeshCurvature, MeshReport, VertexCurvature};

use barchan_asset::VertexFlags;
use barchan_field::Mesh;

use narrow::Reach;
use sheets::Sheets;

use crate::{BakeError, Exec};

/// Bakes the curvature of every vertex.
///
/// # Errors
/// Parameters out of range.
pub fn bake(mesh: &Mesh, params: &CurvatureParams, exec: &Exec) -> Result<MeshCurvature, BakeError> {
    params.check()?;
    let sheets = Sheets::of(mesh, params.hard_edge_degrees, exec);
    let reach = match params.method {
        CurvatureMethod::Fast => Reach { degree: 3, neighbours: 18 },
        CurvatureMethod::Accurate => Reach { degree: 6, neighbours: std::env::var("NN").map_or(48, |v| v.parse().unwrap()) },
    };
    let found = narrow::fit_all(&sheets, reach, exec);
    let of_point = |point: &Option<u32>| match point {
        Some(point) => found[*point as usize].curvature,
        None => VertexCurvature { flags: VertexFlags::ISOLATED, ..VertexCurvature::UNKNOWN },
    };
    let vertices = sheets.point_of_vertex.iter().map(of_point).collect();
    Ok(MeshCurvature { vertices, report: sheets.report, noise: 0.0 })
}
