//! The light of an overcast sky on a point that sees a part of it.
//!
//! An overcast sky is three times as bright at the zenith as at the horizon: L(θ) = L₀ (1 + 2 sin θ) / 3 at the elevation
//! θ, Parry Moon, Domina Spencer, *Illumination from a nonuniform sky*, 1942. Its irradiance on a point is π times the
//! visible share of the sky times its mean brightness there, which is taken at the mean direction of the visible sky: the
//! bent normal. Without bent normals the sky is evenly bright.

use barchan_asset::{BentNormalView, SkyVisibilityView};

use crate::Texture;

/// What the light of the sky needs of an asset.
#[derive(Debug, Clone, PartialEq)]
pub struct SkyLight {
    visibility: Texture,
    /// Components along u and v.
    bent_normal: Option<[Texture; 2]>,
}

impl SkyLight {
    /// Decodes the tables.
    #[must_use]
    pub fn new(visibility: &SkyVisibilityView<'_>, bent_normal: Option<&BentNormalView<'_>>) -> Self {
        let components =
            |view: &BentNormalView<'_>| [0, 1].map(|channel| Texture::of_channel(&view.table(), 0, channel));
        Self { visibility: Texture::new(&visibility.table(), 0), bent_normal: bent_normal.map(components) }
    }

    /// The visible share of the sky at a place, weighted by the cosine to the surface normal.
    #[must_use]
    pub fn visibility(&self, x: f64, y: f64) -> f64 {
        self.visibility.sample(x, y)
    }

    /// The irradiance at a place over that of a level point in the open under a sky as bright as the zenith: 0 to 1.
    #[must_use]
    pub fn irradiance(&self, x: f64, y: f64) -> f64 {
        let brightness = self.bent_normal.as_ref().map_or(1.0, |[u, v]| {
            let (u, v) = (u.sample(x, y), v.sample(x, y));
            (1.0 + 2.0 * (1.0 - u * u - v * v).max(0.0).sqrt()) / 3.0
        });
        self.visibility(x, y) * brightness
    }
}
