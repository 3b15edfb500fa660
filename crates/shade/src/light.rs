//! A light so far away that its rays are parallel.

use glam::DVec3;

/// A directional light in the frame (u, v, height).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DirectionalLight {
    /// Unit vector from the surface towards the light.
    pub towards: DVec3,
    /// The azimuth it comes from, in radians in [0, 2π): 0 along +u, counter-clockwise as seen in the picture.
    pub azimuth_radians: f64,
}

impl DirectionalLight {
    /// A light seen at an azimuth and an elevation above the base plane, in degrees. Both must be finite.
    #[must_use]
    pub fn from_degrees(azimuth: f64, elevation: f64) -> Self {
        // Taken modulo a full turn in degrees, where it is exact.
        let azimuth_radians = azimuth.rem_euclid(360.0).to_radians();
        let (sin_azimuth, cos_azimuth) = libm::sincos(azimuth_radians);
        let (sin_elevation, cos_elevation) = libm::sincos(elevation.to_radians());
        let towards = DVec3::new(cos_elevation * cos_azimuth, cos_elevation * sin_azimuth, sin_elevation);
        Self { towards, azimuth_radians }
    }

    /// Length of the direction's projection on the base plane: the cosine of the elevation.
    #[must_use]
    pub fn level_length(&self) -> f64 {
        self.towards.truncate().length()
    }
}
