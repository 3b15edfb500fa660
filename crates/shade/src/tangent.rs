//! The light in the tangent frame of a textured surface.
//!
//! # Theory
//!
//! A texture lies on a surface by P(u, v). What a horizon map calls a direction is a direction in the *texture*, what it
//! calls a length is a length of the map's own grid, its spacing; on the surface both are something else. Towards the
//! light, the tangent plane has the step (du, dv) with du Pu + dv Pv = the light's projection: a 2×2 system in the first
//! fundamental form. The azimuth of that step on the map's grid says which layers to read; how long it is on the surface
//! over how long it is on the grid, the *stretch* s, says what is read: a distance d on the map is s d on the surface, and a
//! slope δ is δ / s, as heights are the same.
//!
//! # What is exact
//!
//! Heights of relief and lengths of the surface are in one unit. Where the chart is affine along the ray, up to the
//! horizon point, this is exact, sheared and anisotropic charts included: one direction of the texture is one direction
//! on the surface, with one stretch. Elsewhere the stretch of the texel stands for all of the ray, and the straight line of
//! the texture for the geodesic of the surface: errors of first order in how much the chart changes within the distance
//! to the horizon. A map's points for a range of curvatures serve κ s², not κ: stretched relief bends further over a texel.
//!
//! # Departures
//!
//! The paper, Koiichi Onoue, Nelson Max, Tomoyuki Nishita, *Bumpmap Shadows on Curved Surfaces*, divides the normal by the
//! root of |Pu × Pv|: its relief grows with its texture, evenly in all directions. Here relief has the height it is said to
//! have, and directions may be stretched differently.

use glam::{DVec2, DVec3};

/// How a texture lies on a surface at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TangentFrame {
    /// Pu: length along the surface per unit of u.
    pub along_u: DVec3,
    /// Pv: length along the surface per unit of v.
    pub along_v: DVec3,
    /// The unit normal of the geometry, out of the surface.
    pub normal: DVec3,
}

impl TangentFrame {
    /// The frame of Pu and Pv. `mirrored` texture coordinates run clockwise seen from the front: Pu × Pv points into
    /// the surface.
    ///
    /// `None` where Pu × Pv is null or not finite: there is no tangent plane.
    #[must_use]
    pub fn new(along_u: DVec3, along_v: DVec3, mirrored: bool) -> Option<Self> {
        let normal = along_u.cross(along_v).try_normalize()?;
        Some(Self { along_u, along_v, normal: if mirrored { -normal } else { normal } })
    }

    /// Whether Pu × Pv points into the surface.
    #[must_use]
    pub fn mirrored(&self) -> bool {
        self.along_u.cross(self.along_v).dot(self.normal) < 0.0
    }

    /// E, F, G: the first fundamental form.
    #[must_use]
    pub fn first_form(&self) -> [f64; 3] {
        let Self { along_u, along_v, .. } = self;
        [along_u.dot(*along_u), along_u.dot(*along_v), along_v.dot(*along_v)]
    }

    /// The step in the texture whose image on the surface is the vector's projection to the tangent plane; null where
    /// the chart has no area.
    #[must_use]
    pub fn texture_step(&self, vector: DVec3) -> DVec2 {
        let [e, f, g] = self.first_form();
        let (on_u, on_v) = (vector.dot(self.along_u), vector.dot(self.along_v));
        let area_squared = e * g - f * f;
        if area_squared > 0.0 {
            DVec2::new(g * on_u - f * on_v, e * on_v - f * on_u) / area_squared
        } else {
            DVec2::ZERO
        }
    }

    /// The unit normal of relief on the surface, whose height grows by `per_u` and `per_v` per unit of texture
    /// coordinate: James Blinn, *Simulation of Wrinkled Surfaces*, 1978. It takes the surface as flat over the height of
    /// the relief.
    #[must_use]
    pub fn bump_normal(&self, per_u: f64, per_v: f64) -> DVec3 {
        let [e, f, g] = self.first_form();
        let area_squared = e * g - f * f;
        if area_squared <= 0.0 {
            return self.normal;
        }
        let uphill = self.along_u * (g * per_u - f * per_v) + self.along_v * (e * per_v - f * per_u);
        (self.normal - uphill / area_squared).normalize()
    }
}

/// A light, as relief at one point of a surface sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TangentLight {
    /// L′z: the sine of its elevation above the tangent plane. Negative behind the terminator.
    pub height: f64,
    /// |L′xy|: the cosine of its elevation.
    pub level: f64,
    /// The direction it comes from in the texture, (du, dv), of any length. Curvature is asked for along it.
    pub direction: DVec2,
    /// The same on the map's grid, in radians: 0 along +u, counter-clockwise with v up the picture.
    pub azimuth_radians: f64,
    /// Length on the surface per length of the map's grid, along the direction.
    pub stretch: f64,
}

impl TangentLight {
    /// A light seen from a point. `towards` is a unit vector from the surface towards the light, `extent` how long the map's own
    /// grid is along one unit of u and of v: its texels times their spacing.
    ///
    /// A light at the zenith has no azimuth: 0 is given, and a stretch of 1.
    #[must_use]
    pub fn new(frame: &TangentFrame, towards: DVec3, extent: (f64, f64)) -> Self {
        let height = towards.dot(frame.normal);
        let tangent = towards - frame.normal * height;
        let (level, direction) = (tangent.length(), frame.texture_step(tangent));
        let on_grid = DVec2::new(direction.x * extent.0, direction.y * extent.1);
        let grid_length = on_grid.length();
        if level == 0.0 || grid_length == 0.0 {
            return Self { height, level, direction, azimuth_radians: 0.0, stretch: 1.0 };
        }
        let azimuth_radians = libm::atan2(on_grid.y, on_grid.x);
        Self { height, level, direction, azimuth_radians, stretch: level / grid_length }
    }
}
