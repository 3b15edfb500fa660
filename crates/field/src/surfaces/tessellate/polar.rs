//! Delaunay triangulation on a sphere, by stereographic projection from its last vertex, the north pole: what is Delaunay in the plane
//! is a face of the convex hull in space (Brown, 1979).
//!
//! A point at v lies at the distance tan(πv/2) from the image of the south pole. Its logarithm is Mercator's coordinate, in which the
//! sphere is conformal; dividing that by the aspect, a root of the distance, draws the triangles out along the meridians.

use std::f64::consts::{PI, TAU};

use glam::DVec2;

use super::delaunay;

/// Triangles between points of a sphere, the first of which is the south pole and the last the north pole.
pub(super) fn triangulated(parameters: &[DVec2], stretch: f64) -> Option<Vec<[u32; 3]>> {
    let north = parameters.len() - 1;
    let projected = parameters[..north].iter().enumerate().map(|(index, at)| {
        if index == 0 {
            return DVec2::ZERO;
        }
        let distance = libm::pow(libm::tan(0.5 * PI * at.y), 1.0 / stretch);
        DVec2::new(libm::cos(TAU * at.x), libm::sin(TAU * at.x)) * distance
    });
    let found = delaunay::triangulated(projected)?;
    // Seen from the north pole, through the sphere, its outside is behind.
    let inner = found.triangles.into_iter().map(|[a, b, c]| [a, c, b]);
    let around_north = found.hull.into_iter().map(|[a, b]| [a, b, north as u32]);
    Some(inner.chain(around_north).collect())
}
