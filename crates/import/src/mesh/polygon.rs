//! Polygons into triangles.
//!
//! A strictly convex polygon is a fan from its first corner. Any other is cut into ears (G. H. Meisters, *Polygons have
//! ears*, 1975) in the plane of its mean normal (Newell's): the first corner that is convex and whose triangle holds no
//! other corner is cut off, again and again. Where no ear is left, in a polygon that crosses itself or has no area, the
//! rest is a fan; so is a polygon of more than [`MAX_EARS`] corners, since the search takes the square of their number.

use glam::{DVec2, DVec3};

use super::MeshOptions;
use crate::{DecodeError, Format, limits::reserved};

/// Corners beyond which a polygon is not searched for ears.
const MAX_EARS: usize = 1024;

/// Faces of three and more corners, in file order.
#[derive(Default)]
pub(crate) struct Polygons {
    pub(crate) corners: Vec<u32>,
    /// Corners of each.
    pub(crate) sizes: Vec<u32>,
}

impl Polygons {
    /// Triangles of all polygons, and how many polygons had more than three corners. Every corner must name a position.
    pub(crate) fn triangles(
        &self,
        format: Format,
        positions: &[DVec3],
        options: &MeshOptions,
    ) -> Result<(Vec<[u32; 3]>, u64), DecodeError> {
        let count = self.corners.len() - 2 * self.sizes.len();
        options.check_triangles(format, count as u64)?;
        let mut triangles = reserved(count)?;
        let (mut cut, mut rest) = (0, self.corners.as_slice());
        for &size in &self.sizes {
            let (polygon, tail) = rest.split_at(size as usize);
            rest = tail;
            match *polygon {
                [a, b, c] => triangles.push([a, b, c]),
                _ => {
                    cut += 1;
                    triangulate(polygon, positions, &mut triangles);
                }
            }
        }
        Ok((triangles, cut))
    }
}

fn triangulate(polygon: &[u32], positions: &[DVec3], triangles: &mut Vec<[u32; 3]>) {
    let mut outline = Outline::new(polygon, positions);
    let is_convex = (0..polygon.len()).all(|at| outline.turn(at) > 0.0);
    if !is_convex && polygon.len() <= MAX_EARS {
        outline.mark_ears();
        while outline.remaining > 3 {
            let Some(at) = outline.ear() else { break };
            triangles.push(outline.cut(at).map(|corner| polygon[corner]));
        }
    }
    let left: Vec<usize> = outline.left().collect();
    triangles.extend(left.windows(2).skip(1).map(|pair| [left[0], pair[0], pair[1]].map(|corner| polygon[corner])));
}

/// A polygon in its plane, counter-clockwise, of which ears are cut.
struct Outline {
    flat: Vec<DVec2>,
    next: Vec<usize>,
    previous: Vec<usize>,
    is_ear: Vec<bool>,
    start: usize,
    remaining: usize,
}

impl Outline {
    fn new(polygon: &[u32], positions: &[DVec3]) -> Self {
        let n = polygon.len();
        // Relative to a corner, so that a mesh far from the origin loses nothing.
        let origin = positions[polygon[0] as usize];
        let at = |i: usize| positions[polygon[i % n] as usize] - origin;
        let normal: DVec3 = (0..n).map(|i| at(i).cross(at(i + 1))).sum();
        let size = normal.abs();
        let flatten = |p: DVec3| {
            // The coordinate plane the polygon faces most, seen from the polygon's front.
            let (p, sign) = if size.z >= size.x && size.z >= size.y {
                (DVec2::new(p.x, p.y), normal.z)
            } else if size.x >= size.y {
                (DVec2::new(p.y, p.z), normal.x)
            } else {
                (DVec2::new(p.z, p.x), normal.y)
            };
            if sign < 0.0 { DVec2::new(-p.x, p.y) } else { p }
        };
        Self {
            flat: (0..n).map(|i| flatten(at(i))).collect(),
            next: (0..n).map(|i| (i + 1) % n).collect(),
            previous: (0..n).map(|i| (i + n - 1) % n).collect(),
            is_ear: Vec::new(),
            start: 0,
            remaining: n,
        }
    }

    /// The corners that are left, in order.
    fn left(&self) -> impl Iterator<Item = usize> {
        std::iter::successors(Some(self.start), |&at| Some(self.next[at])).take(self.remaining)
    }

    /// Positive where the outline turns left.
    fn turn(&self, at: usize) -> f64 {
        area(self.flat[self.previous[at]], self.flat[at], self.flat[self.next[at]])
    }

    fn mark_ears(&mut self) {
        self.is_ear = (0..self.flat.len()).map(|at| self.test_ear(at)).collect();
    }

    /// The first marked ear, in order.
    fn ear(&self) -> Option<usize> {
        self.left().find(|&at| self.is_ear[at])
    }

    fn test_ear(&self, at: usize) -> bool {
        let (before, after) = (self.previous[at], self.next[at]);
        let [a, b, c] = [before, at, after].map(|corner| self.flat[corner]);
        let is_inside = |p: DVec2| area(a, b, p) >= 0.0 && area(b, c, p) >= 0.0 && area(c, a, p) >= 0.0;
        area(a, b, c) > 0.0
            && self.left().filter(|&other| other != before && other != at && other != after).all(|other| {
                // Only a corner that is not convex can be the first to enter.
                self.turn(other) > 0.0 || !is_inside(self.flat[other])
            })
    }

    fn cut(&mut self, at: usize) -> [usize; 3] {
        let (before, after) = (self.previous[at], self.next[at]);
        self.next[before] = after;
        self.previous[after] = before;
        self.remaining -= 1;
        if self.start == at {
            self.start = after;
        }
        for corner in [before, after] {
            self.is_ear[corner] = self.test_ear(corner);
        }
        [before, at, after]
    }
}

/// Twice the area of a triangle, positive counter-clockwise.
fn area(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}
