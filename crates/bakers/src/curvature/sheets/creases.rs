//! Edges across which the mesh's own normals say that the surface is not smooth.

use barchan_field::Mesh;
use glam::DVec3;

use super::surface::{Surface, next};

/// Cosines closer than this are one: file formats round normals.
const SLACK: f64 = 1e-12;

/// Cuts the surface along hard edges and counts them.
///
/// An edge is hard if at either of its ends the normals stated for its two sides differ by more than `degrees`. Where the two triangles
/// are not turned the same way, as one was flipped with or without its normals, opposite normals are taken as equal. A normal of no length
/// says nothing.
pub(super) fn cut_hard_edges(surface: &mut Surface, mesh: &Mesh, degrees: f64) -> u64 {
    let Some(normals) = mesh.normals() else { return 0 };
    let least_cosine = libm::cos(degrees.to_radians()) - SLACK;
    let mut hard_edges = 0;
    for side in surface.sides() {
        let Some(twin) = surface.twin(side).filter(|&twin| side < twin) else { continue };
        let agree = surface.agree(side, twin);
        let [start, end] = if agree { [next(twin), twin] } else { [twin, next(twin)] };
        let hard = [(side, start), (next(side), end)].into_iter().any(|(corner, across)| {
            let vertices = [corner, across].map(|corner| surface.vertex(corner, mesh.triangles()) as usize);
            vertices[0] != vertices[1] && {
                let cosine = cosine(normals[vertices[0]], normals[vertices[1]]);
                cosine.is_some_and(|cosine| (if agree { cosine } else { cosine.abs() }) < least_cosine)
            }
        });
        if hard {
            surface.cut(side, twin);
            hard_edges += 1;
        }
    }
    hard_edges
}

fn cosine(a: DVec3, b: DVec3) -> Option<f64> {
    Some(unit(a)?.dot(unit(b)?))
}

/// Of any length but zero.
fn unit(normal: DVec3) -> Option<DVec3> {
    (normal / normal.abs().max_element()).try_normalize()
}
