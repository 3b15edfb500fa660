//! Is a mesh what its surface is: a manifold, oriented throughout, whole, with borders only where the surface has them?

use glam::DVec2;

use super::Connected;
use super::layout::Ends;

/// Brings triangles into an order that does not depend on how they were found: least vertex first.
pub(super) fn sort(triangles: &mut [[u32; 3]]) {
    for triangle in triangles.iter_mut() {
        let least = (0..3).min_by_key(|&corner| triangle[corner]).unwrap_or(0);
        triangle.rotate_left(least);
    }
    triangles.sort_unstable();
}

/// A manifold of the right kind: sphere 2, disc 1, tube and torus 0 (Euler's characteristic).
pub(super) fn is_sound(mesh: &Connected, ends: Ends) -> bool {
    let Connected { parameters, triangles } = mesh;
    let mut used = vec![false; parameters.len()];
    triangles.iter().flatten().for_each(|&vertex| used[vertex as usize] = true);
    let edges = edges(triangles);
    let distinct = edges.chunk_by(|a, b| a[..2] == b[..2]).count();
    let characteristic = parameters.len() as i64 - distinct as i64 + triangles.len() as i64;
    let expected = match (ends.poles, ends.closed_u) {
        (true, _) => 2,
        (false, true) => 0,
        (false, false) => 1,
    };
    used.into_iter().all(|used| used) && characteristic == expected && fits(&edges, parameters, ends)
}

/// Does each edge belong to two triangles that run along it in opposite directions, or to one on a border of the surface?
pub(super) fn is_manifold(triangles: &[[u32; 3]], parameters: &[DVec2], ends: Ends) -> bool {
    fits(&edges(triangles), parameters, ends)
}

/// Every edge of every triangle, sorted: lesser vertex, greater vertex, 1 if it runs from the greater to the lesser.
fn edges(triangles: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let directed = triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let mut edges: Vec<_> = directed.map(|[a, b]| [a.min(b), a.max(b), u32::from(a > b)]).collect();
    edges.sort_unstable();
    edges
}

fn fits(edges: &[[u32; 3]], parameters: &[DVec2], ends: Ends) -> bool {
    let on_border = |a: u32, b: u32| {
        let (a, b) = (parameters[a as usize], parameters[b as usize]);
        let same_end = |a: f64, b: f64| a == b && (a == 0.0 || a == 1.0);
        (!ends.closed_u && same_end(a.x, b.x)) || (ends.open_v() && same_end(a.y, b.y))
    };
    edges.chunk_by(|a, b| a[..2] == b[..2]).all(|uses| match *uses {
        [[a, b, _]] => a != b && on_border(a, b),
        [[a, b, one], [_, _, other]] => a != b && one != other,
        _ => false,
    })
}
