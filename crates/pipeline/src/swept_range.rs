//! The range of curvatures that relief on a mesh is baked for, where nobody names another.

use barchan_bakers::curvature::MeshCurvature;
use barchan_field::Grid;
use serde::{Deserialize, Serialize};

/// A range taken from a mesh, in 1 / length unit.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct MeshRange {
    /// All curvatures of the mesh but the 0.1 % of the vertices that are bent most to either side.
    pub mesh: (f64, f64),
    /// What was swept: that range, cut to what a horizon can be swept over, a radius of curvature of one texel, and in hollows of the
    /// search radius / π.
    pub swept: (f64, f64),
}

impl MeshRange {
    pub(crate) fn new(mesh: (f64, f64), grid: &Grid, radius: f64) -> Self {
        // A hair inside of what `CurvatureRange::check` refuses.
        let tightest = (1.0 - 1e-9) / grid.spacing.u().min(grid.spacing.v());
        let hollow = (1.0 - 1e-9) * std::f64::consts::PI / radius;
        let cut = |curvature: f64| curvature.clamp(-tightest.min(hollow), tightest);
        Self { mesh, swept: (cut(mesh.0), cut(mesh.1)) }
    }
}

/// The range of the curvatures that are known, but for the most bent 0.1 % of the vertices to either side: single spikes would cost
/// every texel. `None` if none is known.
pub(crate) fn of_mesh(found: &MeshCurvature) -> Option<(f64, f64)> {
    let known = found.vertices.iter().filter(|vertex| !vertex.flags.is_unknown());
    let (mut least, mut greatest): (Vec<_>, Vec<_>) =
        known.map(|vertex| (vertex.principal[1], vertex.principal[0])).unzip();
    let beyond = least.len() / 1000;
    let (_, least, _) = (beyond < least.len()).then(|| least.select_nth_unstable_by(beyond, f64::total_cmp))?;
    let last = greatest.len() - 1 - beyond;
    let (_, greatest, _) = greatest.select_nth_unstable_by(last, f64::total_cmp);
    Some((*least, *greatest))
}
