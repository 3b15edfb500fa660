//! A picture of the mesh in the colours of its curvature.

use barchan_asset::CurvatureView;
use barchan_pipeline::{MeshInput, MeshOrigin};
use barchan_shade::{ColouredMesh, MeshView, Picture, UpAxis};

use super::colouring::Colouring;
use crate::args::{MeshPictureArguments, UpAxisName};

/// From a little above, and a little to the right of the front.
const THREE_QUARTERS: (f64, f64) = (30.0, 25.0);

/// Pixels of the longer side.
const SIZE: u32 = 800;

/// All of the mesh. Files are taken to have y up, as glTF has it; surfaces of recipes have z up.
pub(super) fn draw(
    mesh: &MeshInput,
    view: &CurvatureView<'_>,
    colouring: &Colouring,
    arguments: &MeshPictureArguments,
) -> Picture {
    let up = match (arguments.up, &mesh.provenance.source) {
        (Some(UpAxisName::Y), _) | (None, MeshOrigin::File { .. }) => UpAxis::Y,
        (Some(UpAxisName::Z), _) | (None, MeshOrigin::Surface(_)) => UpAxis::Z,
    };
    let (azimuth, elevation) = arguments.view.unwrap_or(THREE_QUARTERS);
    let colours: Vec<_> = (0..view.vertices()).map(|vertex| colouring.colour(view, vertex)).collect();
    let mesh = ColouredMesh { positions: mesh.mesh.positions(), colours: &colours, triangles: mesh.mesh.triangles() };
    Picture::of_mesh(&mesh, &MeshView::from_degrees(up, azimuth, elevation), arguments.size.unwrap_or(SIZE))
}
