//! Places at which several fans meet: each fan is a point of its own.

use std::collections::HashSet;

use barchan_field::Mesh;
use glam::DVec3;

use super::fans::Fan;
use super::orient::double_area;
use super::surface::{NONE, Surface, next, previous};

/// Points where places do not suffice.
#[derive(Debug)]
pub(super) struct Split {
    /// A corner of each point. Point p < places is the fan of most area at place p; the other fans follow, place by place.
    pub(super) corners: Vec<u32>,
    /// The point at each corner.
    pub(super) points: Vec<u32>,
    /// Points at whose place fans meet that are not joined even across hard edges.
    pub(super) non_manifold: Vec<u32>,
    /// (vertex, point) of the vertices at those places, largest fan first.
    pub(super) vertices: Vec<(u32, u32)>,
}

impl Split {
    /// Says which point speaks for a vertex whose place has several.
    ///
    /// A vertex of duplicate triangles alone is where the triangle is that was kept.
    pub(super) fn speak(
        &self,
        surface: &Surface,
        mesh: &Mesh,
        duplicates: &[(u32, u32)],
        of_vertex: &mut [Option<u32>],
    ) {
        let places: Vec<Option<u32>> = duplicates
            .iter()
            .flat_map(|&(dropped, _)| mesh.triangles()[dropped as usize])
            .map(|vertex| of_vertex[vertex as usize])
            .collect();
        let mut spoken_for: HashSet<u32> = HashSet::new();
        for &(vertex, point) in &self.vertices {
            if spoken_for.insert(vertex) {
                of_vertex[vertex as usize] = Some(point);
            }
        }
        let vertices = duplicates
            .iter()
            .flat_map(|&(dropped, kept)| mesh.triangles()[dropped as usize].map(|vertex| (vertex, kept)));
        for ((vertex, kept), place) in vertices.zip(places) {
            let corner = (kept * 3..kept * 3 + 3).find(|&corner| Some(surface.from(corner)) == place);
            if let Some(corner) = corner.filter(|_| spoken_for.insert(vertex)) {
                of_vertex[vertex as usize] = Some(self.points[corner as usize]);
            }
        }
    }
}

/// Divides places into fans; `corners` names a corner of each place.
pub(super) fn split(surface: &Surface, mesh: &Mesh, positions: &[DVec3], mut corners: Vec<u32>) -> Split {
    let crowded = crowded_places(surface, &corners);
    let mut points = surface.corners.clone();
    let mut non_manifold = Vec::new();
    let mut vertices = Vec::new();
    for place in crowded.chunk_by(|a, b| a.0 == b.0) {
        let fans = fans(surface, positions, place, &mut points);
        let numbers: Vec<u32> = (0..fans.len())
            .map(|rank| match rank {
                0 => place[0].0,
                _ => (corners.len() + rank - 1) as u32,
            })
            .collect();
        for (fan, &point) in fans.iter().zip(&numbers) {
            for &corner in &fan.sides {
                points[corner as usize] = point;
                vertices.push((surface.vertex(corner, mesh.triangles()), point));
            }
        }
        corners[place[0].0 as usize] = fans[0].sides[0];
        corners.extend(fans[1..].iter().map(|fan| fan.sides[0]));
        if !joined_across_cuts(surface, &fans, &numbers, &points) {
            non_manifold.extend(numbers);
        }
    }
    Split { corners, points, non_manifold, vertices }
}

/// (place, corner) of all corners at places where one fan does not reach every corner, in order.
fn crowded_places(surface: &Surface, corners: &[u32]) -> Vec<(u32, u32)> {
    let mut unreached = vec![0_u32; corners.len()];
    for &place in surface.corners.iter().filter(|&&place| place != NONE) {
        unreached[place as usize] += 1;
    }
    let mut fan = Fan::default();
    for (place, &corner) in corners.iter().enumerate() {
        fan.around(surface, corner);
        unreached[place] -= fan.sides.len() as u32;
    }
    let mut crowded: Vec<(u32, u32)> = surface
        .sides()
        .map(|corner| (surface.from(corner), corner))
        .filter(|&(place, _)| place != NONE && unreached[place as usize] > 0)
        .collect();
    crowded.sort_unstable();
    crowded
}

/// The fans at a place, the one of most area first; of equal ones that with the smallest neighbour.
fn fans(surface: &Surface, positions: &[DVec3], place: &[(u32, u32)], points: &mut [u32]) -> Vec<Fan> {
    let mut fans = Vec::new();
    for &(_, corner) in place {
        points[corner as usize] = NONE;
    }
    for &(place, corner) in place {
        if points[corner as usize] != NONE {
            continue;
        }
        let mut fan = Fan::default();
        fan.around(surface, corner);
        let mut area = 0.0;
        for &side in &fan.sides {
            points[side as usize] = place;
            area += double_area(surface, positions, side / 3);
        }
        let first_neighbour = fan.sides.iter().map(|&side| surface.to(side)).min();
        fans.push((area, first_neighbour, fan));
    }
    fans.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    fans.into_iter().map(|(_, _, fan)| fan).collect()
}

/// Whether the fans at a place are one surface but for cuts.
fn joined_across_cuts(surface: &Surface, fans: &[Fan], numbers: &[u32], points: &[u32]) -> bool {
    let mut reached = vec![false; fans.len()];
    let mut open = vec![0];
    reached[0] = true;
    while let Some(fan) = open.pop() {
        for &side in &fans[fan].sides {
            for outward in [side, previous(side)] {
                let Some(twin) = surface.twin(outward) else { continue };
                let middle = surface.from(side);
                let corner = if surface.from(twin) == middle { twin } else { next(twin) };
                let other = numbers.binary_search(&points[corner as usize]).unwrap_or(fan);
                if !reached[other] {
                    reached[other] = true;
                    open.push(other);
                }
            }
        }
    }
    reached.into_iter().all(|reached| reached)
}
