//! A ray through relief, by its depth.

use glam::DVec3;

/// The longest way to the floor, in texels along u and v together: what a walk from cell to cell can be asked to go.
const LONGEST_WAY_TEXELS: f64 = (1 << 20) as f64;

/// The farthest place, in texels: there a place is still known to 2⁻¹² of a texel.
const FARTHEST_TEXELS: f64 = (1_u64 << 40) as f64;

/// A ray that enters the top plane of a relief: [`crate::Relief::ray`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReliefRay {
    pub(crate) place: (f64, f64),
    /// Texels moved, along columns and rows, from depth 0 to depth 1.
    pub(crate) step: (f64, f64),
    towards: DVec3,
    tangent: f64,
}

impl ReliefRay {
    pub(crate) fn new(
        thickness: f64,
        (spacing_u, spacing_v): (f64, f64),
        place: (f64, f64),
        towards: DVec3,
    ) -> Option<Self> {
        // Written so that what is not a number is refused, too.
        let is_near = place.0.abs() <= FARTHEST_TEXELS && place.1.abs() <= FARTHEST_TEXELS;
        if !(towards.z > 0.0 && is_near) {
            return None;
        }
        // Away from the eye; rows count down the picture.
        let run = thickness / towards.z;
        let step = (-run * towards.x / spacing_u, run * towards.y / spacing_v);
        let tangent = towards.truncate().length() / towards.z;
        let is_short = step.0.abs() + step.1.abs() <= LONGEST_WAY_TEXELS && tangent.is_finite();
        is_short.then_some(Self { place, step, towards, tangent })
    }

    /// Where the ray stands at a depth, in texels.
    #[inline]
    #[must_use]
    pub fn at(&self, depth: f64) -> (f64, f64) {
        (self.place.0 + depth * self.step.0, self.place.1 + depth * self.step.1)
    }

    /// The tangent of its angle from the normal: length moved along the plane per length of height.
    #[inline]
    #[must_use]
    pub fn tangent(&self) -> f64 {
        self.tangent
    }

    /// The vector towards where it comes from, as given.
    #[inline]
    #[must_use]
    pub fn towards(&self) -> DVec3 {
        self.towards
    }

    /// The azimuth it comes from in radians, −π to π: 0 along +u, counter-clockwise as seen; 0 for a ray along the normal.
    #[must_use]
    pub fn azimuth_radians(&self) -> f64 {
        libm::atan2(self.towards.y, self.towards.x)
    }
}
