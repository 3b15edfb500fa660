//! The frame in which a point's neighbours are looked at: the surface is a height over its plane.

use glam::DVec3;

/// An orthonormal frame at a point of the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Frame {
    pub(super) origin: DVec3,
    pub(super) x: DVec3,
    pub(super) y: DVec3,
    pub(super) normal: DVec3,
}

impl Frame {
    /// A frame around a unit normal; one of zero length counts as Z.
    pub(super) fn with_normal(origin: DVec3, normal: DVec3) -> Self {
        let normal = if normal == DVec3::ZERO { DVec3::Z } else { normal };
        // Tom Duff et al., Building an Orthonormal Basis, Revisited, 2017.
        let sign = 1.0_f64.copysign(normal.z);
        let a = -1.0 / (sign + normal.z);
        let b = normal.x * normal.y * a;
        let x = DVec3::new(1.0 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x);
        let y = DVec3::new(b, sign + normal.y * normal.y * a, -normal.y);
        Self { origin, x, y, normal }
    }

    /// The frame turned about its normal so that x points along a direction of its plane, of any length.
    pub(super) fn turned(self, [along_x, along_y]: [f64; 2]) -> Self {
        let length = (along_x * along_x + along_y * along_y).sqrt();
        if length == 0.0 {
            return self;
        }
        let (cos, sin) = (along_x / length, along_y / length);
        Self { x: self.x * cos + self.y * sin, y: self.y * cos - self.x * sin, ..self }
    }
}
