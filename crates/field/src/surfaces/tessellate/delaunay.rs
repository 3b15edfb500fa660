//! The Delaunay triangulation of points in the plane (crate `spade`, with exact predicates).

use glam::DVec2;
use spade::{DelaunayTriangulation, HasPosition, Point2, Triangulation};

struct Site {
    position: DVec2,
    index: u32,
}

impl HasPosition for Site {
    type Scalar = f64;

    fn position(&self) -> Point2<f64> {
        Point2::new(self.position.x, self.position.y)
    }
}

/// Triangles between points, counter-clockwise, and the edges of their convex hull.
pub(super) struct Delaunay {
    pub(super) triangles: Vec<[u32; 3]>,
    /// Counter-clockwise: the triangles lie to the left.
    pub(super) hull: Vec<[u32; 2]>,
}

/// None if two points agree, or if a coordinate is not finite.
pub(super) fn triangulated(points: impl Iterator<Item = DVec2>) -> Option<Delaunay> {
    let sites: Vec<Site> = points.enumerate().map(|(index, position)| Site { position, index: index as u32 }).collect();
    let count = sites.len();
    let found = DelaunayTriangulation::<Site>::bulk_load(sites).ok()?;
    if found.num_vertices() != count {
        return None;
    }
    let triangles = found.inner_faces().map(|face| face.vertices().map(|vertex| vertex.data().index)).collect();
    // The library walks the hull clockwise.
    let hull = found.convex_hull().map(|edge| [edge.to().data().index, edge.from().data().index]).collect();
    Some(Delaunay { triangles, hull })
}
