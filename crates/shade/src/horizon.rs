//! Shadows from a horizon map on a flat base surface.
//!
//! A point is in shadow iff the light stands below its horizon, L′z < δ · |L′xy|: Koiichi Onoue, Nelson Max, Tomoyuki
//! Nishita, *Bumpmap Shadows on Curved Surfaces*. The table holds the elevation ε = atan δ, so both sides are multiplied
//! by cos ε > 0: L′z cos ε < |L′xy| sin ε, which needs no division and has no pole at a wall or at the zenith.
//!
//! The elevation at a place is interpolated bilinearly within the layers of the two azimuths beside the light's, and
//! linearly in azimuth between them: `barchan_asset::Azimuths` knows which they are, on a full circle and on an arc.

use barchan_asset::HorizonView;

use crate::{DirectionalLight, Texture};

/// What one light's shadow needs of a horizon map: the horizon at the light's own azimuth.
#[derive(Debug, Clone, PartialEq)]
pub struct HorizonShadow {
    elevation_radians: Texture,
    light_height: f64,
    light_level: f64,
}

impl HorizonShadow {
    /// Takes the two layers beside the light's azimuth.
    #[must_use]
    pub fn new(horizon: &HorizonView<'_>, light: &DirectionalLight) -> Self {
        let (layer, next, weight) = horizon.neighbours(light.azimuth_radians);
        let table = horizon.table();
        let elevation = Texture::new(&table, layer);
        let elevation_radians = match weight {
            0.0 => elevation,
            _ => elevation.zip_map(&Texture::new(&table, next), |a, b| a + (b - a) * weight),
        };
        Self { elevation_radians, light_height: light.towards.z, light_level: light.level_length() }
    }

    /// The elevation of the horizon towards the light at a place, in radians.
    #[must_use]
    pub fn elevation_radians(&self, x: f64, y: f64) -> f64 {
        self.elevation_radians.sample(x, y)
    }

    /// Whether the light stands below the horizon of a place.
    #[must_use]
    pub fn in_shadow(&self, x: f64, y: f64) -> bool {
        let (sin, cos) = libm::sincos(self.elevation_radians(x, y));
        self.light_height * cos < self.light_level * sin
    }
}
