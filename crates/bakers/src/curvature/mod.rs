//! Principal curvature per vertex of a mesh.
//!
//! # Theory
//!
//! Seen from the tangent plane of one of its points a surface is a height over that plane. Its Taylor polynomial, the *osculating jet*, is
//! found by least squares from the points around, and κ1, κ2 and their directions are eigenvalues and eigenvectors of its second
//! fundamental form against its first: Frédéric Cazals, Marc Pouget, *Estimating differential quantities using polynomial fitting of
//! osculating jets*, 2005. A jet of degree d errs by h^(d−1), whatever the triangulation; averages of face normals or dihedral angles do
//! not converge on irregular ones.
//!
//! # Steps
//!
//! 1. `sheets`: the mesh becomes smooth, oriented sheets of welded points.
//! 2. `neighbourhood`: around each point the nearest ones along the surface, in an ellipse where triangles are long; the frame leans to the
//!    sphere that follows them best, and they are *flattened*: space is bent conformally so that this sphere is a plane. The polynomial
//!    has far less left to follow: at 4000 vertices the error is a tenth on an ellipsoid, and rounding on a sphere of any tessellation.
//! 3. `jet`: jets of all degrees at once, eight points in lockstep; `estimate` takes the highest that the neighbours support: degree 6
//!    on 44 neighbours inside, 8 on 60 at the edge of a surface, where a jet has to look out of its neighbourhood; lower where
//!    points lie in too few rows. Where the surface is too coarse for them, smaller
//!    neighbourhoods compete.
//! 4. `noise`: if what the jets leave over is noise and not shape, neighbourhoods widen as far as the surface allows, and degrees fall.
//! 5. [`forms`] carries curvature over to texture coordinates.
//!
//! [`CurvatureMethod::Fast`] is a cubic jet on 18 neighbours without step 4.
//!
//! # Departures
//!
//! - Cazals and Pouget fit one degree, unflattened, by singular values: [`reference`](mod@reference) does so by reflections.
//! - Onoue, Max and Nishita, *Bumpmap Shadows on Curved Surfaces*, want κ1, κ2 and two directions in texture coordinates. What a shader
//!   should interpolate is the two fundamental forms ([`VertexForms`]): directions have no sign, and at an umbilic no meaning.
//!
//! # Conventions
//!
//! κ in 1 / length unit, positive where the surface is convex seen from the front of its triangles, after neighbours have been
//! made to agree on the front. One row per vertex, in the mesh's own order; vertices of one point agree to the bit. What cannot be known is
//! 0 and flagged. |κ| ends where the mean edge of a point would be a circle's diameter.
//!
//! What it costs and how far it is from closed forms is printed by `cargo xtask bench`.

mod chart;
mod estimate;
mod frame;
mod jet;
mod narrow;
mod neighbourhood;
mod noise;
mod params;
mod patch;
pub mod reference;
mod sheets;
mod sphere;
mod table;
mod tensor;

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
    let mut noise = None;
    if params.method == CurvatureMethod::Accurate {
        noise = noise::noise(&found);
        match noise {
            Some(noise) => noise::refit(&sheets, noise, &mut found, exec),
            None => narrow::resolve(&sheets, &mut found, exec),
        }
    }
    let mut used = vec![false; mesh.positions().len()];
    for &vertex in mesh.triangles().as_flattened() {
        used[vertex as usize] = true;
    }
    let of_vertex = |(vertex, point): (usize, &Option<u32>)| match point {
        Some(point) => found[*point as usize].curvature,
        None => {
            let flags = if used[vertex] { VertexFlags::DEGENERATE } else { VertexFlags::ISOLATED };
            VertexCurvature { flags, ..VertexCurvature::UNKNOWN }
        }
    };
    let vertices = sheets.point_of_vertex.iter().enumerate().map(of_vertex).collect();
    Ok(MeshCurvature { vertices, report: sheets.report, noise: noise.map_or(0.0, f64::sqrt) })
}
