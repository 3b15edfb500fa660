//! Normals of a mesh, smooth where it bends little.

use std::collections::HashMap;

use glam::DVec3;

/// The cosine of 30°: a corner whose triangle is turned further from the others there belongs to a hard edge.
const HARD_COSINE: f64 = 0.866_025_403_784_438_6;

/// A unit vector per vertex: the mean of the triangles around its place, by their area, whichever vertices are there. Zero where
/// they cancel, or where there are none.
pub(crate) struct SmoothNormals(Vec<DVec3>);

impl SmoothNormals {
    pub(crate) fn new(points: &[DVec3], triangles: &[[u32; 3]]) -> Self {
        let mut firsts = HashMap::with_capacity(points.len());
        // Adding 0 makes −0 and 0 the same.
        let bits = |point: &DVec3| point.to_array().map(|coordinate| (coordinate + 0.0).to_bits());
        let place: Vec<usize> =
            points.iter().enumerate().map(|(vertex, point)| *firsts.entry(bits(point)).or_insert(vertex)).collect();
        let mut sums = vec![DVec3::ZERO; points.len()];
        for triangle in triangles {
            let area = area_vector(points, triangle);
            for corner in triangle {
                sums[place[*corner as usize]] += area;
            }
        }
        Self(place.into_iter().map(|first| sums[first].normalize_or_zero()).collect())
    }

    /// The normals at the corners of a triangle, on one side of it.
    pub(crate) fn of_corners(&self, points: &[DVec3], triangle: &[u32; 3]) -> [DVec3; 3] {
        let flat = area_vector(points, triangle).normalize_or_zero();
        triangle.map(|corner| {
            let smooth = self.0[corner as usize];
            let cosine = smooth.dot(flat);
            // Triangles that run round the other way than their neighbours are no edge.
            if cosine.abs() >= HARD_COSINE { smooth * cosine.signum() } else { flat }
        })
    }
}

/// Twice the area of a triangle, along its normal.
fn area_vector(points: &[DVec3], triangle: &[u32; 3]) -> DVec3 {
    let [a, b, c] = triangle.map(|corner| points[corner as usize]);
    (b - a).cross(c - a)
}
