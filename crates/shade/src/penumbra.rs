//! Soft shadows of a disc light on a flat base surface.

use barchan_asset::{Azimuths, DistanceView, HorizonView};

use crate::curved_shadow::{MismatchedTables, bilinear, check, check_fits};
use crate::{DiscLight, Texture};

/// A disc no larger than this is a point: what f32 tells apart of angles.
const SMALLEST_DISC: f64 = 1e-6;

/// Fewer blocking taps than this darken nothing that could be seen.
const LEAST_COVERAGE: f64 = 1e-6;

/// The decoded tables of a map, for lights from anywhere: every place may see its own.
#[derive(Debug, Clone)]
pub struct Penumbra {
    azimuths: Azimuths,
    layers: Vec<Layer>,
}

/// The horizon of every texel towards one azimuth.
#[derive(Debug, Clone)]
struct Layer {
    elevation: Texture,
    distance: Texture,
}

impl Penumbra {
    /// Decodes the tables of a map.
    ///
    /// # Errors
    /// Tables that do not fit each other.
    pub fn new(horizon: &HorizonView<'_>, distance: &DistanceView<'_>) -> Result<Self, MismatchedTables> {
        let (elevations, distances) = (horizon.table(), distance.table());
        check_fits(&elevations, &distances, "distance")?;
        check(horizon.azimuths() == distance.azimuths(), "distance")?;
        let layer = |direction| Layer {
            elevation: Texture::new(&elevations, direction),
            distance: Texture::new(&distances, direction),
        };
        Ok(Self { azimuths: horizon.azimuths(), layers: (0..horizon.directions()).map(layer).collect() })
    }

    /// How much of the disc is seen from a place, 0 to 1.
    #[must_use]
    pub fn visibility(&self, place: (f64, f64), light: &DiscLight) -> f64 {
        let (first, second, weight) = self.azimuths.neighbours(light.azimuth_radians());
        let towards = |direction: u32| self.layers[direction as usize].blocking(place, light.level_distance);
        let ((c1, e1), (c2, e2), weight) = (towards(first), towards(second), f64::from(weight));
        let (coverage, elevation) = (c1 + (c2 - c1) * weight, e1 + (e2 - e1) * weight);
        let horizon = elevation / coverage.max(LEAST_COVERAGE);
        let above = (light.elevation_radians() - horizon) / light.angular_radius_radians.max(SMALLEST_DISC);
        (1.0 - coverage * (1.0 - share_above(above))).max(0.0).min(1.0)
    }
}

impl Layer {
    /// The share of taps whose horizon is nearer than the light, and their elevations, weighted.
    fn blocking(&self, (x, y): (f64, f64), level_distance: f64) -> (f64, f64) {
        let ((elevations, within), (distances, _)) = (self.elevation.cell(x, y), self.distance.cell(x, y));
        let blocks = distances.map(|distance| distance < level_distance);
        let elevation = |tap: usize| if blocks[tap] { elevations[tap] } else { 0.0 };
        let coverage = blocks.map(|blocks| f64::from(u8::from(blocks)));
        (bilinear(coverage, within), bilinear([0, 1, 2, 3].map(elevation), within))
    }
}

/// The share of a disc above a straight line whose distance below the centre is `above` radii.
fn share_above(above: f64) -> f64 {
    let t = above.max(-1.0).min(1.0);
    0.5 + (t * (1.0 - t * t).sqrt() + libm::asin(t)) * std::f64::consts::FRAC_1_PI
}
