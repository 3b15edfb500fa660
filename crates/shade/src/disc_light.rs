//! A light that is a disc: the sun, or a lamp close by.

use glam::DVec3;

/// A disc that faces the place it lights, in the frame (u, v, height) of the map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DiscLight {
    /// Unit vector from the place towards the disc's centre.
    pub towards: DVec3,
    /// Half the angle that the disc fills, in radians, in [0, π/2): the sun's is 0.0047. 0 is a point.
    pub angular_radius_radians: f64,
    /// Length along the base plane from the place to below the disc's centre, in the map's length unit: infinite for a sun.
    pub level_distance: f64,
}

impl DiscLight {
    /// A light beyond all relief, seen at `towards`, a unit vector, the same from everywhere.
    #[must_use]
    pub fn sun(towards: DVec3, angular_radius_radians: f64) -> Self {
        Self { towards, angular_radius_radians, level_distance: f64::INFINITY }
    }

    /// A disc of a radius about `centre`, seen from the place as the origin, both in the map's length unit. A disc about the place
    /// itself shines from the zenith.
    #[must_use]
    pub fn near(centre: DVec3, radius: f64) -> Self {
        Self {
            towards: centre.try_normalize().unwrap_or(DVec3::Z),
            angular_radius_radians: libm::atan2(radius, centre.length()),
            level_distance: centre.truncate().length(),
        }
    }

    /// The azimuth of its centre, in radians: 0 along +u, a quarter turn up the picture.
    #[must_use]
    pub fn azimuth_radians(&self) -> f64 {
        libm::atan2(self.towards.y, self.towards.x)
    }

    /// How wide its penumbra is on level ground, along the light: from where the disc begins to be seen to where it is all seen, about
    /// a place that sees half of it over a straight level edge square to the light, `distance` away along the base plane. In the unit
    /// of lengths.
    ///
    /// With θ the elevation of the light and α′ the angular radius of its disc as the edge sees it, tan α′ = tan α · D / (D − d),
    ///
    /// > w = d tan θ (cot(θ − α′) − cot(θ + α′)) = 2 d tan θ tan α′ / (sin² θ − cos² θ tan² α′).
    ///
    /// It is exact for a sun, and for a disc close by as it faces that place. 0 for an edge behind the light; infinite where the
    /// light sets, θ ≤ α′.
    #[must_use]
    pub fn penumbra_width(&self, distance: f64) -> f64 {
        if distance >= self.level_distance {
            return 0.0;
        }
        let spread = libm::tan(self.angular_radius_radians) / (1.0 - distance / self.level_distance);
        let (level, height) = (self.towards.truncate().length(), self.towards.z);
        let above_ground = level * (height * height - level * level * spread * spread);
        if height > 0.0 && above_ground > 0.0 { 2.0 * distance * height * spread / above_ground } else { f64::INFINITY }
    }
}
