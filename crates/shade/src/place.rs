//! All that shading asks for at one place of a textured surface under one light.

use glam::{DVec2, DVec3};

use crate::{BaseSurface, FundamentalForms, Surface, TangentFrame, TangentLight};

/// A place on a surface under a light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// Texture coordinates: one tile of the relief is 1 by 1, v up the picture.
    pub uv: DVec2,
    /// The same in texels from the centre of texel (0, 0), rows downwards.
    pub texel: (f64, f64),
    /// The point of the base surface.
    pub position: DVec3,
    /// How the texture lies there.
    pub frame: TangentFrame,
    /// How the base surface bends there.
    pub forms: FundamentalForms,
    /// The light as the place sees it.
    pub light: TangentLight,
}

impl Place {
    /// The place at (u, v) of a base surface that wears `relief`, under a light from `towards`, a unit vector.
    #[must_use]
    pub fn new(base: &(impl BaseSurface + ?Sized), relief: &Surface, uv: DVec2, towards: DVec3) -> Self {
        let point = base.point(uv);
        Self {
            uv,
            texel: relief.texel_of(uv),
            position: point.position,
            frame: point.frame,
            forms: base.forms(uv),
            light: TangentLight::new(&point.frame, towards, relief.extent()),
        }
    }

    /// The curvature of the base surface along the light, in 1 / length.
    #[must_use]
    pub fn curvature(&self) -> f64 {
        self.forms.along(self.light.direction.x, self.light.direction.y)
    }

    /// The unit normal of the relief, smoothed as [`Surface::normal`] does.
    #[must_use]
    pub fn bump_normal(&self, relief: &Surface) -> DVec3 {
        let ((slope_u, slope_v), (extent_u, extent_v)) = (relief.slopes(self.texel.0, self.texel.1), relief.extent());
        self.frame.bump_normal(slope_u * extent_u, slope_v * extent_v)
    }

    /// Lambert's cosine on the relief, 0 to 1, wherever the base surface faces: what it turns away from the light, a bump may
    /// turn back.
    #[must_use]
    pub fn lambert(&self, relief: &Surface, towards: DVec3) -> f64 {
        self.bump_normal(relief).dot(towards).max(0.0)
    }
}
