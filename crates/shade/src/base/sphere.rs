//! A sphere round the origin, from outside or inside.

use std::f64::consts::TAU;

use glam::{DVec2, DVec3};

use super::{BaseSurface, Foot, Ray, SurfacePoint, ball_crossings};
use crate::{FundamentalForms, TangentFrame};

/// How a texture lies on a sphere; there is no way that keeps lengths. Around (u, v) = (0, 0), which is on the +x axis with u
/// towards +y and v towards +z, both do.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SphereChart {
    /// u is longitude and v latitude: what most models have. Stretched by the cosine of the latitude along u alone.
    Geographic,
    /// Projected from the point opposite: stretched the same in all directions, 1 / (1 + r²/4R²) at the distance r in the
    /// texture. The point opposite is at infinity.
    Stereographic,
}

/// A sphere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sphere {
    /// 1 / κ.
    pub radius: f64,
    /// Whether relief is on the inside, the concave one.
    pub hollow: bool,
    /// How the texture lies on it.
    pub chart: SphereChart,
    /// Length of one unit of u and of v at (0, 0); not 0. One negative length mirrors the texture.
    pub tile: DVec2,
}

impl Sphere {
    fn side(&self) -> f64 {
        if self.hollow { -1.0 } else { 1.0 }
    }

    fn geographic(&self, uv: DVec2) -> [DVec3; 3] {
        let (sin_longitude, cos_longitude) = libm::sincos(uv.x * self.tile.x / self.radius);
        let (sin_latitude, cos_latitude) = libm::sincos(uv.y * self.tile.y / self.radius);
        let out = DVec3::new(cos_latitude * cos_longitude, cos_latitude * sin_longitude, sin_latitude);
        let east = DVec3::new(-sin_longitude, cos_longitude, 0.0) * cos_latitude;
        let north = DVec3::new(-sin_latitude * cos_longitude, -sin_latitude * sin_longitude, cos_latitude);
        [out, east, north]
    }

    fn stereographic(&self, uv: DVec2) -> [DVec3; 3] {
        // In radii, halved: (y, z) / 2R of the plane at (R, 0, 0).
        let DVec2 { x: p, y: q } = uv * self.tile / (2.0 * self.radius);
        let square = 1.0 + p * p + q * q;
        let out = DVec3::new(2.0 - square, 2.0 * p, 2.0 * q) / square;
        let scale = 1.0 / (square * square);
        let along_p = DVec3::new(-2.0 * p, square - 2.0 * p * p, -2.0 * p * q) * scale;
        let along_q = DVec3::new(-2.0 * q, -2.0 * p * q, square - 2.0 * q * q) * scale;
        [out, along_p, along_q]
    }
}

impl BaseSurface for Sphere {
    fn point(&self, uv: DVec2) -> SurfacePoint {
        let [out, u, v] = match self.chart {
            SphereChart::Geographic => self.geographic(uv),
            SphereChart::Stereographic => self.stereographic(uv),
        };
        let frame = TangentFrame { along_u: u * self.tile.x, along_v: v * self.tile.y, normal: out * self.side() };
        SurfacePoint { position: out * self.radius, frame }
    }

    fn forms(&self, uv: DVec2) -> FundamentalForms {
        let first = self.point(uv).frame.first_form();
        FundamentalForms { first, second: first.map(|k| k * self.side() / self.radius) }
    }

    fn foot(&self, position: DVec3, near: Option<DVec2>) -> Foot {
        let length = position.length();
        let lengths = match self.chart {
            SphereChart::Geographic => {
                let longitude = libm::atan2(position.y, position.x);
                let near_longitude = near.map_or(0.0, |uv| uv.x * self.tile.x / self.radius);
                let longitude = longitude + ((near_longitude - longitude) / TAU).round() * TAU;
                let latitude = libm::atan2(position.z, libm::hypot(position.x, position.y));
                DVec2::new(longitude, latitude) * self.radius
            }
            SphereChart::Stereographic => {
                // Opposite to the centre, anything far away is as good as infinity.
                let towards = (length + position.x).max(1e-12 * length);
                let scale = if towards > 0.0 { 2.0 * self.radius / towards } else { 0.0 };
                DVec2::new(position.y, position.z) * scale
            }
        };
        Foot { uv: lengths / self.tile, height: self.side() * (length - self.radius), beyond_edge: false }
    }

    fn escapes(&self, ray: &Ray, height: f64) -> bool {
        let crossings = ball_crossings(
            ray.origin.length_squared(),
            ray.origin.dot(ray.direction),
            ray.direction.length_squared(),
            ((self.radius + height).max(0.0)).max(0.0),
        );
        !self.hollow && crossings.is_none_or(|(_, leaves)| leaves < 0.0)
    }

    fn hit(&self, ray: &Ray) -> Option<DVec2> {
        let along = ray.origin.dot(ray.direction);
        let squared = ray.direction.length_squared();
        let (enters, leaves) = ball_crossings(ray.origin.length_squared(), along, squared, self.radius)?;
        let distance = if self.hollow { leaves } else { enters };
        (distance >= 0.0).then(|| self.foot(ray.at(distance), None).uv)
    }
}
