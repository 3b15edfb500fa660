//! A picture of a bump-mapped curved surface: the outline is that of the smooth base surface, what is on it looks like relief.
//!
//! Lambert's law is for the normal of the relief, and no light is cut off where the base surface turns away: what lies there is
//! for shadows to say. So bumps behind the terminator are lit where they reach into the light, as in figure 4 of Koiichi Onoue,
//! Nelson Max, Tomoyuki Nishita, *Bumpmap Shadows on Curved Surfaces*.

use glam::DVec3;

use crate::picture::{BACKGROUND, to_srgb};
use crate::{BaseSurface, Camera, Palette, Picture, Place, Surface};

/// What the pixels of a picture see of a surface.
#[derive(Debug, Clone)]
pub struct CurvedPixels {
    width: u32,
    height: u32,
    towards: DVec3,
    /// Row by row from the top.
    places: Vec<Option<Place>>,
}

impl CurvedPixels {
    /// What a camera sees of a base surface that wears `relief`, under a light from `towards`, a unit vector.
    #[must_use]
    pub fn new(camera: &Camera, base: &(impl BaseSurface + ?Sized), relief: &Surface, towards: DVec3) -> Self {
        let place = |ray| Some(Place::new(base, relief, base.hit(&ray)?, towards));
        Self { width: camera.width, height: camera.height, towards, places: camera.rays().map(place).collect() }
    }

    /// The places seen, row by row from the top, and nothing for the background.
    #[must_use]
    pub fn places(&self) -> &[Option<Place>] {
        &self.places
    }

    /// A decision for each pixel that sees the surface; the background is not in shadow.
    pub fn decide(&self, mut in_shadow: impl FnMut(&Place) -> bool) -> Vec<bool> {
        self.places.iter().map(|place| place.as_ref().is_some_and(&mut in_shadow)).collect()
    }

    /// The picture, in the sun where `shadow` says it reaches, under an even sky everywhere.
    ///
    /// # Panics
    /// If `shadow` does not hold one value per pixel.
    #[must_use]
    pub fn picture(&self, relief: &Surface, shadow: &[bool], palette: &Palette) -> Picture {
        assert_eq!(shadow.len(), self.places.len(), "one shadow value per pixel");
        let colour = |(place, &shadow): (&Option<Place>, &bool)| {
            let Some(place) = place else { return BACKGROUND };
            let normal = place.bump_normal(relief);
            let sun = if shadow { 0.0 } else { normal.dot(self.towards).max(0.0) };
            let sky = 0.5 + 0.5 * normal.dot(place.frame.normal);
            to_srgb(palette.albedo * (palette.sun * sun + palette.sky * sky))
        };
        let colours: Vec<[u8; 3]> = self.places.iter().zip(shadow).map(colour).collect();
        Picture { width: self.width, height: self.height, rgb: colours.into_flattened() }
    }
}
