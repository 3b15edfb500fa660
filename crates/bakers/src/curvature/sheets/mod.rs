//! A mesh as smooth sheets of surface.
//!
//! A fit of curvature wants points with their neighbours around them, on a surface that is smooth and has one front. Files hold something
//! else: vertices twice at the seam of a texture or once per triangle, triangles facing either way, edges that are meant to be sharp,
//! edges with three triangles. The steps, one file each:
//!
//! 1. [`weld`] vertices to places;
//! 2. [`edges`] between places, duplicate triangles left out; where more than two triangles meet, [`branch`] joins those that continue
//!    each other;
//! 3. [`creases`] cut the surface along hard edges;
//! 4. [`orient`] gives every connected piece one front, and cuts where there is none;
//! 5. [`fans`] around a place are its points; where there are several, they are [`split`]; each gets a [`normal`].
//!
//! A triangle of three places on one line has no area and no say in normals, but joins its neighbours: so programs close T-junctions.
//!
//! Nothing depends on the order of triangles or on which corner comes first, but for what is arbitrary: where an unorientable surface is
//! cut, which way a piece faces of which exactly half the area faces either way, and which of two equal fans speaks for a vertex.

mod branch;
mod creases;
mod edges;
mod fans;
mod normal;
mod orient;
mod split;
mod surface;
#[cfg(test)]
mod tests;
mod weld;

use barchan_asset::VertexFlags;
use barchan_field::Mesh;
use glam::DVec3;

use self::fans::{Layout, Points};
use self::surface::{MOST_TRIANGLES, NONE, Surface};
use self::weld::Places;
use super::MeshReport;
use crate::{BakeError, Exec};

/// Places, points or triangles that one piece of work takes.
const PIECE: usize = 1 << 14;

/// Smooth, consistently oriented sheets: a *point* is a place on one sheet, shared by all vertices that are welded there.
#[derive(Debug, Clone, Default)]
pub(super) struct Sheets {
    /// Where every point is.
    pub(super) positions: Vec<DVec3>,
    /// Unit normals of points, of their triangles weighted by angle; zero where no triangle has an area.
    pub(super) normals: Vec<DVec3>,
    /// `neighbours[starts[p]..starts[p + 1]]` are the points that share an edge with point p, counter-clockwise: from one end to the
    /// other on the boundary, else from the neighbour with the smallest number. A slit that ends in p is in the list twice.
    pub(super) starts: Vec<u32>,
    /// See `starts`.
    pub(super) neighbours: Vec<u32>,
    /// Remarks on points: [`VertexFlags::BOUNDARY`], [`VertexFlags::NON_MANIFOLD`].
    pub(super) flags: Vec<VertexFlags>,
    /// The point that speaks for a vertex, that of most area where several sheets meet in it; `None` if no triangle with three places
    /// has a corner at its place.
    pub(super) point_of_vertex: Vec<Option<u32>>,
    /// What was mended.
    pub(super) report: MeshReport,
}

impl Sheets {
    /// The points that share an edge with a point.
    pub(super) fn around(&self, point: usize) -> &[u32] {
        &self.neighbours[self.starts[point] as usize..self.starts[point + 1] as usize]
    }

    /// Welds, orients and cuts a mesh.
    pub(super) fn of(mesh: &Mesh, hard_edge_degrees: f64, exec: &Exec) -> Self {
        let mut places = weld::weld(mesh, exec);
        let mut report = MeshReport::default();
        let (mut corners, collapsed) = corners_of(mesh, &places, exec);
        report.collapsed_triangles = collapsed;
        if collapsed > 0 {
            forget_unused(&mut places, &mut corners);
        }
        let (mut surface, duplicates) = join(corners, &places, &mut report, exec);
        report.hard_edges = creases::cut_hard_edges(&mut surface, mesh, hard_edge_degrees);
        let turned = orient::orient(&mut surface, &places.positions, exec);
        report.flipped_triangles = turned.triangles;
        report.unorientable_edges = turned.unorientable_edges;
        assemble(mesh, places, &surface, &duplicates, report, exec)
    }
}

/// Refuses more triangles than have numbers.
///
/// # Errors
/// What they take and how much is allowed.
pub(super) fn check_size(triangles: usize) -> Result<(), BakeError> {
    if triangles <= MOST_TRIANGLES {
        return Ok(());
    }
    let bytes = |triangles: usize| triangles as u64 * size_of::<[u32; 3]>() as u64;
    Err(BakeError::TooLarge {
        what: "a mesh's list of triangles",
        bytes: bytes(triangles),
        limit: bytes(MOST_TRIANGLES),
    })
}

/// The place of every vertex that a triangle uses: vertices at one place are welded, hard edges aside.
pub(super) fn places(mesh: &Mesh, exec: &Exec) -> Vec<Option<u32>> {
    let of_vertex = weld::weld(mesh, exec).of_vertex;
    of_vertex.into_iter().map(|place| (place != NONE).then_some(place)).collect()
}

/// Three places per triangle, and how many triangles have fewer.
fn corners_of(mesh: &Mesh, places: &Places, exec: &Exec) -> (Vec<u32>, u64) {
    let mut corners = vec![NONE; mesh.triangles().len() * 3];
    let mut collapsed = vec![0; mesh.triangles().len().div_ceil(PIECE)];
    let pieces = corners.chunks_mut(PIECE * 3).zip(mesh.triangles().chunks(PIECE)).zip(&mut collapsed);
    exec.for_each_quietly(pieces.collect(), |_, ((corners, triangles), collapsed)| {
        for (corners, triangle) in corners.chunks_exact_mut(3).zip(triangles) {
            let [a, b, c] = triangle.map(|vertex| places.of_vertex[vertex as usize]);
            if a == b || b == c || c == a {
                *collapsed += 1;
            } else {
                corners.copy_from_slice(&[a, b, c]);
            }
        }
    });
    (corners, collapsed.into_iter().sum())
}

/// Leaves out places that have no triangle any more.
fn forget_unused(places: &mut Places, corners: &mut [u32]) {
    let mut renumbered = vec![NONE; places.positions.len()];
    for &place in corners.iter().filter(|&&place| place != NONE) {
        renumbered[place as usize] = 0;
    }
    let mut kept = Vec::with_capacity(renumbered.len());
    for (place, number) in renumbered.iter_mut().enumerate().filter(|(_, number)| **number == 0) {
        *number = kept.len() as u32;
        kept.push(places.positions[place]);
    }
    places.positions = kept;
    for place in corners.iter_mut().chain(&mut places.of_vertex).filter(|place| **place != NONE) {
        *place = renumbered[*place as usize];
    }
}

/// Joins triangles along their edges; (left out, kept) duplicates.
fn join(mut corners: Vec<u32>, places: &Places, report: &mut MeshReport, exec: &Exec) -> (Surface, Vec<(u32, u32)>) {
    let mut edges = edges::find(&corners, places.positions.len(), exec);
    let mut duplicates = Vec::new();
    if !edges.suspects.is_empty() {
        duplicates = edges::drop_duplicates(&mut corners, edges.suspects);
        edges = edges::find(&corners, places.positions.len(), exec);
    }
    report.duplicate_triangles = duplicates.len() as u64;
    report.non_manifold_edges = edges.crowded.len() as u64;
    let mut surface = Surface::new(corners, edges.twins);
    for sides in &edges.crowded {
        branch::join_straightest(&mut surface, sides, &places.positions);
    }
    (surface, duplicates)
}

/// Points from the fans around places.
fn assemble(
    mesh: &Mesh,
    places: Places,
    surface: &Surface,
    duplicates: &[(u32, u32)],
    mut report: MeshReport,
    exec: &Exec,
) -> Sheets {
    let Places { of_vertex, mut positions } = places;
    let corners = fans::corner_of_each_place(surface, positions.len());
    let layout = Layout { surface, positions: &positions, corners: &corners, points: &[] };
    let mut points = fans::walk(&layout, exec);
    let left_out = report.collapsed_triangles as usize + duplicates.len();
    let mut point_of_vertex: Vec<Option<u32>> =
        of_vertex.iter().map(|&place| (place != NONE).then_some(place)).collect();
    let mut non_manifold = Vec::new();
    if points.triangles < (mesh.triangles().len() - left_out) * 3 {
        let split = split::split(surface, mesh, &positions, corners);
        let layout = Layout { surface, positions: &positions, corners: &split.corners, points: &split.points };
        points = fans::walk(&layout, exec);
        split.speak(surface, mesh, duplicates, &mut point_of_vertex);
        positions = split.corners.iter().map(|&corner| positions[surface.from(corner) as usize]).collect();
        non_manifold = split.non_manifold;
    }
    report.points = positions.len() as u64;
    report.mean_edge = points.length / points.neighbours.len().max(1) as f64;
    let flags = flags(&points, &non_manifold);
    let Points { starts, neighbours, normals, .. } = points;
    Sheets { positions, normals, starts, neighbours, flags, point_of_vertex, report }
}

fn flags(points: &Points, non_manifold: &[u32]) -> Vec<VertexFlags> {
    let boundary = |&open: &bool| if open { VertexFlags::BOUNDARY } else { VertexFlags::NONE };
    let mut flags: Vec<VertexFlags> = points.open.iter().map(boundary).collect();
    for &point in non_manifold {
        flags[point as usize] = flags[point as usize] | VertexFlags::NON_MANIFOLD;
    }
    flags
}
