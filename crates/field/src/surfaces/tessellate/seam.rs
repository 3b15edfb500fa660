//! Texture coordinates of closed surfaces: the mesh is cut where they would jump from 1 to 0.
//!
//! A triangle across the seam keeps its size in (u, v) by going beyond 1, and vertices that are seen on both sides of the seam are
//! repeated. At a pole u is free: each triangle there has a corner of its own, in the middle of the other two.

use std::collections::HashMap;

use glam::DVec2;

use super::Connected;
use super::layout::Ends;

/// The mesh cut open, and the texture coordinates of its vertices. Vertices keep their place with the coordinates that are used first;
/// the others follow behind the last, in order of first use.
pub(super) fn cut(mesh: &Connected, ends: Ends) -> (Connected, Vec<DVec2>) {
    let mut parameters = mesh.parameters.clone();
    let mut uvs: Vec<Option<DVec2>> = vec![None; parameters.len()];
    let mut copies = HashMap::new();
    let triangles = mesh.triangles.iter().map(|&corners| {
        let at = unwrapped(corners, mesh, ends);
        std::array::from_fn(|corner| {
            let (vertex, uv) = (corners[corner], at[corner]);
            *copies.entry((vertex, uv.x.to_bits(), uv.y.to_bits())).or_insert_with(|| {
                let first = &mut uvs[vertex as usize];
                if first.is_none() {
                    *first = Some(uv);
                    return vertex;
                }
                uvs.push(Some(uv));
                parameters.push(mesh.parameters[vertex as usize]);
                (uvs.len() - 1) as u32
            })
        })
    });
    let triangles = triangles.collect();
    // Every vertex of a sound mesh is used.
    let uvs = uvs.into_iter().map(Option::unwrap_or_default).collect();
    (Connected { parameters, triangles }, uvs)
}

/// Texture coordinates of a triangle's corners, none further from another than half a turn.
fn unwrapped(corners: [u32; 3], mesh: &Connected, ends: Ends) -> [DVec2; 3] {
    let mut at = corners.map(|vertex| mesh.parameters[vertex as usize]);
    let is_pole = |vertex: u32| ends.poles && (vertex == 0 || vertex as usize == mesh.parameters.len() - 1);
    if let Some(pole) = (0..3).find(|&corner| is_pole(corners[corner])) {
        let [next, last] = [(pole + 1) % 3, (pole + 2) % 3];
        let us = continued([at[next].x, at[last].x]);
        (at[next].x, at[last].x) = (us[0], us[1]);
        at[pole].x = 0.5 * (us[0] + us[1]);
        return at;
    }
    let us = continued(at.map(|at| at.x));
    let vs = if ends.closed_v { continued(at.map(|at| at.y)) } else { at.map(|at| at.y) };
    std::array::from_fn(|corner| DVec2::new(us[corner], vs[corner]))
}

/// Turns from 0 to 1, those before the jump from 1 to 0 raised by 1 if there is one between them.
fn continued<const N: usize>(turns: [f64; N]) -> [f64; N] {
    let (least, most) = turns.iter().fold((1.0_f64, 0.0_f64), |(least, most), &t| (least.min(t), most.max(t)));
    if most - least > 0.5 { turns.map(|t| if t < 0.5 { t + 1.0 } else { t }) } else { turns }
}
