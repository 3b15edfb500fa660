//! What a camera sees of relief on a surface, each pixel by a relief ray.
//!
//! # Theory
//!
//! The base surface is the top plane of the relief: nothing stands out of it. Where a ray of the camera hits it, the tangent frame takes
//! the direction to the eye into the frame of the relief, and a relief ray goes on from there as if the surface were flat: Fabio
//! Policarpo, Manuel Oliveira, João Comba, *Real-Time Relief Mapping on Arbitrary Polygonal Surfaces*, 2005. So it is exact on a plane, and on a
//! curved surface an approximation of relief that is thin against its radius. Charts that stretch or shear are taken into account at the
//! hit, and held for the ray.
//!
//! # Silhouettes
//!
//! The outline is that of the base. Under a wrapping edge the tile goes on for ever; under a clamped one the tile is seen through its
//! own top face alone, what enters beside it is background, and rays that leave the tile below find its outermost texels extruded.

use barchan_asset::Wrap;
use glam::{DVec2, DVec3};

use super::{Fetches, HemisphereOcclusion, Occlusion, Relief, ReliefRoad, ReliefShadow, ShadowAnswer};
use crate::picture::{BACKGROUND, to_srgb};
use crate::{BaseSurface, Camera, Palette, Picture, Surface, TangentFrame};

/// What a pixel sees.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReliefPixel {
    /// Where on the tile, in texels from the centre of texel (0, 0).
    pub texel: (f64, f64),
    /// How far below the top plane, as a part of the relief's whole depth.
    pub depth: f64,
    /// How the texture lies where the ray entered.
    pub frame: TangentFrame,
    /// What was read to find it.
    pub fetches: Fetches,
}

/// What the pixels of a picture see of relief on a base surface.
#[derive(Debug, Clone)]
pub struct ReliefPixels<'a> {
    surface: &'a Surface,
    width: u32,
    height: u32,
    /// Row by row from the top.
    pixels: Vec<Option<ReliefPixel>>,
}

/// What light does to the pixels of a picture, row by row from the top; values of the background are not looked at.
#[derive(Debug, Clone, Copy)]
pub struct ReliefLight<'a> {
    /// A unit vector towards the sun.
    pub sun: DVec3,
    /// Where the sun does not reach.
    pub shadow: &'a [bool],
    /// What part of the sky's light is cut off; nothing for an open sky.
    pub occlusion: Option<&'a [f64]>,
}

/// A direction of space in the frame of relief that lies on a surface, as a unit vector; lengths of the surface are stretched to
/// those of the relief's grid, of `extent` per unit of texture coordinates.
#[must_use]
pub fn relief_direction(frame: &TangentFrame, extent: (f64, f64), direction: DVec3) -> DVec3 {
    let step = frame.texture_step(direction);
    DVec3::new(step.x * extent.0, step.y * extent.1, direction.dot(frame.normal)).normalize_or_zero()
}

impl<'a> ReliefPixels<'a> {
    /// Follows a ray a pixel over a base surface that wears `relief`, to be found by `road`.
    #[must_use]
    pub fn new(
        camera: &Camera,
        base: &(impl BaseSurface + ?Sized),
        relief: &Relief<'a>,
        road: &ReliefRoad<'_>,
    ) -> Self {
        let surface = relief.surface();
        let see = |ray: crate::Ray| {
            let uv = base.hit(&ray).filter(|uv| is_covered(surface, *uv))?;
            let (frame, (x, y)) = (base.point(uv).frame, surface.texel_of(uv));
            let ray = relief.ray(x, y, relief_direction(&frame, surface.extent(), -ray.direction))?;
            let found = road.find(&ray);
            Some(ReliefPixel { texel: ray.at(found.depth), depth: found.depth, frame, fetches: found.fetches })
        };
        Self { surface, width: camera.width, height: camera.height, pixels: camera.rays().map(see).collect() }
    }

    /// Pixels across.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Pixels down.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.height
    }

    /// What is seen, row by row from the top, and nothing for the background.
    #[must_use]
    pub fn pixels(&self) -> &[Option<ReliefPixel>] {
        &self.pixels
    }

    /// Something of each pixel that sees relief, and `background` of the others.
    pub fn map<T: Clone>(&self, background: &T, mut of: impl FnMut(&ReliefPixel) -> T) -> Vec<T> {
        self.pixels.iter().map(|pixel| pixel.as_ref().map_or_else(|| background.clone(), &mut of)).collect()
    }

    /// Whether a pixel is in the shadow of a sun from `towards`, a unit vector in space: of the relief, as a flat one, or of the base
    /// surface where it turns away.
    #[must_use]
    pub fn in_shadow(&self, pixel: &ReliefPixel, shadow: &ReliefShadow<'_>, towards: DVec3) -> ShadowAnswer {
        let towards = relief_direction(&pixel.frame, self.surface.extent(), towards);
        shadow.at(pixel.texel, pixel.depth, towards)
    }

    /// What part of the light from above a pixel does not get, with the smoothed normal of the relief.
    #[must_use]
    pub fn occlusion(&self, pixel: &ReliefPixel, occlusion: &HemisphereOcclusion<'_>) -> Occlusion {
        occlusion.at(pixel.texel, pixel.depth, self.surface.normal(pixel.texel.0, pixel.texel.1))
    }

    /// The picture: Lambert's law for the sun where it reaches, an even sky for the rest.
    ///
    /// # Panics
    /// If `light` does not hold one value per pixel.
    #[must_use]
    pub fn picture(&self, light: &ReliefLight<'_>, palette: &Palette) -> Picture {
        assert_eq!(light.shadow.len(), self.pixels.len(), "one shadow value per pixel");
        assert!(light.occlusion.is_none_or(|all| all.len() == self.pixels.len()), "one occlusion per pixel");
        let extent = self.surface.extent();
        let colour = |(index, pixel): (usize, &Option<ReliefPixel>)| {
            let Some(ReliefPixel { texel: (x, y), frame, .. }) = pixel else { return BACKGROUND };
            let (slope_u, slope_v) = self.surface.slopes(*x, *y);
            let normal = frame.bump_normal(slope_u * extent.0, slope_v * extent.1);
            let sun = if light.shadow[index] { 0.0 } else { normal.dot(light.sun).max(0.0) };
            let open = 1.0 - light.occlusion.map_or(0.0, |occlusion| occlusion[index]);
            let sky = (0.5 + 0.5 * normal.dot(frame.normal)) * open;
            to_srgb(palette.albedo * (palette.sun * sun + palette.sky * sky))
        };
        let colours: Vec<[u8; 3]> = self.pixels.iter().enumerate().map(colour).collect();
        Picture { width: self.width, height: self.height, rgb: colours.into_flattened() }
    }
}

/// Whether the relief is where a ray enters: a clamped tile is not repeated.
fn is_covered(surface: &Surface, uv: DVec2) -> bool {
    let (wrap_u, wrap_v) = surface.heights().wrap();
    let within = |wrap: Wrap, place: f64| wrap != Wrap::Clamp || (0.0..=1.0).contains(&place);
    within(wrap_u, uv.x) && within(wrap_v, uv.y)
}
