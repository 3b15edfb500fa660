//! Shadows from a horizon map on a flat base surface.
//!
//! A point is in shadow iff the light stands below its horizon, L′z < δ · |L′xy|: Koiichi Onoue, Nelson Max, Tomoyuki
//! Nishita, *Bumpmap Shadows on Curved Surfaces*. The table holds the elevation ε = atan δ, so both sides are multiplied
//! by cos ε > 0: L′z cos ε < |L′xy| sin ε, which needs no division and has no pole at a wall or at the zenith.
//!
//! The elevation at a place is interpolated bilinearly within the layers of the two azimuths beside the light's, and
//! linearly in azimuth between them, the last layer being beside the first.

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
        let (layer, next, weight) = neighbouring_layers(horizon.directions(), light.azimuth_radians);
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

/// The layers on both sides of an azimuth in [0, 2π), and how far the second one counts, in [0, 1).
fn neighbouring_layers(directions: u32, azimuth_radians: f64) -> (u32, u32, f32) {
    let position = azimuth_radians / std::f64::consts::TAU * f64::from(directions);
    // An azimuth a hair below 2π may round up to the last layer's successor, which is the first.
    let layer = position.floor();
    let index = layer as u32 % directions;
    (index, (index + 1) % directions, (position - layer) as f32)
}

#[cfg(test)]
mod tests {
    use super::neighbouring_layers;
    use std::f64::consts::TAU;

    #[test]
    fn an_azimuth_lies_between_its_neighbours_and_wraps() {
        assert_eq!(neighbouring_layers(8, 0.0), (0, 1, 0.0));
        assert_eq!(neighbouring_layers(8, TAU / 8.0), (1, 2, 0.0));
        assert_eq!(neighbouring_layers(8, TAU * 7.5 / 8.0), (7, 0, 0.5));
        assert_eq!(neighbouring_layers(1, TAU / 3.0).0, 0);
        let (layer, next, _) = neighbouring_layers(8, TAU.next_down());
        assert!(layer < 8 && next < 8);
    }
}
