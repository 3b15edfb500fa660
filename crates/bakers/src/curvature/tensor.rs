//! Curvature as a tensor in space: shapes of different points, in different frames, can be compared and averaged.

use glam::DVec3;

use super::VertexCurvature;
use super::frame::Frame;

/// κ1 t1 t1ᵀ + κ2 t2 t2ᵀ: xx, yy, zz, xy, yz, zx.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Tensor(pub(super) [f64; 6]);

impl Tensor {
    pub(super) fn of(principal: [f64; 2], directions: [DVec3; 2]) -> Self {
        let mut components = [0.0; 6];
        for (curvature, along) in principal.into_iter().zip(directions) {
            let DVec3 { x, y, z } = along;
            for (component, product) in components.iter_mut().zip([x * x, y * y, z * z, x * y, y * z, z * x]) {
                *component += curvature * product;
            }
        }
        Self(components)
    }

    /// Σ of the squares of the differences of all nine components.
    pub(super) fn squared_difference(&self, other: &Self) -> f64 {
        let squares: [f64; 6] = std::array::from_fn(|index| {
            let difference = self.0[index] - other.0[index];
            difference * difference
        });
        squares[0] + squares[1] + squares[2] + 2.0 * (squares[3] + squares[4] + squares[5])
    }

    /// The vertex with this curvature instead of its own, as far as it lies in its tangent plane.
    pub(super) fn at(&self, vertex: &VertexCurvature) -> VertexCurvature {
        let Frame { x, y, .. } = Frame::with_normal(DVec3::ZERO, vertex.normal);
        let (xx, xy, yy) = (self.between(x, x), self.between(x, y), self.between(y, y));
        let (principal, [a, b]) = principal(xx, xy, yy);
        VertexCurvature { principal, directions: [x * a + y * b, y * a - x * b], ..*vertex }
    }

    fn between(&self, a: DVec3, b: DVec3) -> f64 {
        let [xx, yy, zz, xy, yz, zx] = self.0;
        let image =
            DVec3::new(xx * b.x + xy * b.y + zx * b.z, xy * b.x + yy * b.y + yz * b.z, zx * b.x + yz * b.y + zz * b.z);
        a.dot(image)
    }
}

/// Eigenvalues of a symmetric tensor of the plane, the larger first, and the unit eigenvector of that.
pub(super) fn principal(xx: f64, xy: f64, yy: f64) -> ([f64; 2], [f64; 2]) {
    let (mean, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
    let spread = (half * half + xy * xy).sqrt();
    // Of the two forms of the eigenvector, the one that does not cancel.
    let [a, b] = if half >= 0.0 { [half + spread, xy] } else { [xy, spread - half] };
    let length = (a * a + b * b).sqrt();
    let direction = if length > 0.0 { [a / length, b / length] } else { [1.0, 0.0] };
    ([mean + spread, mean - spread], direction)
}
