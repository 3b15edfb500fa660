//! A mesh coloured by its curvature: binary little-endian PLY, which every viewer reads.

use barchan_asset::CurvatureView;
use barchan_field::Mesh;

use super::colouring::Colouring;

/// Positions as doubles, so that a mesh far from its origin keeps its shape; colours, κ1 and κ2 per vertex; triangles.
pub(super) fn encode(mesh: &Mesh, view: &CurvatureView<'_>, colouring: &Colouring) -> Vec<u8> {
    let mut bytes = header(mesh, colouring).into_bytes();
    for (vertex, position) in (0..).zip(mesh.positions()) {
        bytes.extend(position.to_array().iter().flat_map(|coordinate| coordinate.to_le_bytes()));
        bytes.extend(colouring.colour(view, vertex));
        bytes.extend(view.principal(vertex).iter().flat_map(|curvature| curvature.to_le_bytes()));
    }
    for triangle in mesh.triangles() {
        bytes.push(3);
        bytes.extend(triangle.iter().flat_map(|corner| corner.to_le_bytes()));
    }
    bytes
}

fn header(mesh: &Mesh, colouring: &Colouring) -> String {
    let (vertices, triangles) = (mesh.positions().len(), mesh.triangles().len());
    let (version, comment) = (env!("CARGO_PKG_VERSION"), colouring.comment());
    format!(
        "ply\n\
         format binary_little_endian 1.0\n\
         comment made by barchan {version}\n\
         comment {comment}\n\
         element vertex {vertices}\n\
         property double x\n\
         property double y\n\
         property double z\n\
         property uchar red\n\
         property uchar green\n\
         property uchar blue\n\
         property float k1\n\
         property float k2\n\
         element face {triangles}\n\
         property list uchar uint vertex_indices\n\
         end_header\n"
    )
}
