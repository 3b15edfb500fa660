//! A cylinder round the z axis, from outside or inside.

use std::f64::consts::TAU;

use glam::{DMat2, DVec2, DVec3};

use super::{BaseSurface, Foot, Ray, SurfacePoint, ball_crossings};
use crate::{FundamentalForms, TangentFrame};

/// An endless round cylinder, rolled up from a plane: its chart keeps lengths as far as `chart` does.
///
/// Arc 0 is along +x, and grows towards +y.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cylinder {
    /// Of its circle.
    pub radius: f64,
    /// Whether relief is on the inside, the concave one.
    pub hollow: bool,
    /// Lengths along the arc and the axis of one unit of u (first column) and v; of any determinant but 0.
    pub chart: DMat2,
}

impl Cylinder {
    fn side(&self) -> f64 {
        if self.hollow { -1.0 } else { 1.0 }
    }
}

impl BaseSurface for Cylinder {
    fn point(&self, uv: DVec2) -> SurfacePoint {
        let rolled = self.chart * uv;
        let (sin, cos) = libm::sincos(rolled.x / self.radius);
        let (out, round) = (DVec3::new(cos, sin, 0.0), DVec3::new(-sin, cos, 0.0));
        let along = |column: DVec2| round * column.x + DVec3::Z * column.y;
        let frame = TangentFrame {
            along_u: along(self.chart.x_axis),
            along_v: along(self.chart.y_axis),
            normal: out * self.side(),
        };
        SurfacePoint { position: out * self.radius + DVec3::Z * rolled.y, frame }
    }

    fn forms(&self, uv: DVec2) -> FundamentalForms {
        let (u, v) = (self.chart.x_axis.x, self.chart.y_axis.x);
        let curvature = self.side() / self.radius;
        FundamentalForms {
            first: self.point(uv).frame.first_form(),
            second: [u * u, u * v, v * v].map(|k| k * curvature),
        }
    }

    fn foot(&self, position: DVec3, near: Option<DVec2>) -> Foot {
        let circumference = TAU * self.radius;
        let arc = libm::atan2(position.y, position.x) * self.radius;
        let near_arc = near.map_or(0.0, |uv| (self.chart * uv).x);
        let arc = arc + ((near_arc - arc) / circumference).round() * circumference;
        let uv = self.chart.inverse() * DVec2::new(arc, position.z);
        Foot { uv, height: self.side() * (position.truncate().length() - self.radius), beyond_edge: false }
    }

    fn escapes(&self, ray: &Ray, height: f64) -> bool {
        let (origin, direction) = (ray.origin.truncate(), ray.direction.truncate());
        // Along the axis, the height never changes.
        if direction == DVec2::ZERO {
            return self.foot(ray.origin, None).height > height;
        }
        let crossings = ball_crossings(
            origin.length_squared(),
            origin.dot(direction),
            direction.length_squared(),
            (self.radius + height).max(0.0),
        );
        !self.hollow && crossings.is_none_or(|(_, leaves)| leaves < 0.0)
    }

    fn hit(&self, ray: &Ray) -> Option<DVec2> {
        let (origin, direction) = (ray.origin.truncate(), ray.direction.truncate());
        let (enters, leaves) =
            ball_crossings(origin.length_squared(), origin.dot(direction), direction.length_squared(), self.radius)?;
        let distance = if self.hollow { leaves } else { enters };
        (distance >= 0.0).then(|| self.foot(ray.at(distance), None).uv)
    }
}
