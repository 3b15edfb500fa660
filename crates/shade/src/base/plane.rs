//! The plane z = 0, seen from above.

use glam::{DMat2, DVec2, DVec3};

use super::{BaseSurface, Foot, Ray, SurfacePoint};
use crate::{FundamentalForms, TangentFrame};

/// An endless plane under an affine chart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane {
    /// Lengths along x and y of one unit of u (first column) and v; of any determinant but 0.
    pub chart: DMat2,
}

impl BaseSurface for Plane {
    fn point(&self, uv: DVec2) -> SurfacePoint {
        let frame = TangentFrame {
            along_u: self.chart.x_axis.extend(0.0),
            along_v: self.chart.y_axis.extend(0.0),
            normal: DVec3::Z,
        };
        SurfacePoint { position: (self.chart * uv).extend(0.0), frame }
    }

    fn forms(&self, uv: DVec2) -> FundamentalForms {
        FundamentalForms { first: self.point(uv).frame.first_form(), second: [0.0; 3] }
    }

    fn foot(&self, position: DVec3, _near: Option<DVec2>) -> Foot {
        let uv = self.chart.inverse() * position.truncate();
        Foot { uv, height: position.z, beyond_edge: false }
    }

    fn escapes(&self, ray: &Ray, height: f64) -> bool {
        ray.origin.z > height && ray.direction.z >= 0.0
    }

    fn hit(&self, ray: &Ray) -> Option<DVec2> {
        let distance = -ray.origin.z / ray.direction.z;
        (ray.direction.z < 0.0 && distance >= 0.0).then(|| self.foot(ray.at(distance), None).uv)
    }
}
