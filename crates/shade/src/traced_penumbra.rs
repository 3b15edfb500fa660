//! The baseline without any table: shadow rays to all of a disc.

use std::f64::consts::PI;

use glam::DVec3;

use crate::{DirectionalLight, DiscLight, Surface, TracedShadow};

/// The golden angle: no two points of a spiral that turns by it come close.
const GOLDEN_ANGLE: f64 = PI * (3.0 - 2.236_067_977_499_79);

/// Traces rays to points spread evenly over discs.
#[derive(Debug, Clone)]
pub struct TracedPenumbra<'a> {
    surface: &'a Surface,
    range: (f32, f32),
    radius: f64,
    samples: u32,
}

impl<'a> TracedPenumbra<'a> {
    /// `samples` rays to each disc look `radius` far along the base plane, in the surface's length unit, and no farther than the light. Light
    /// from the zenith itself has no level distance: its rays look as far as the others.
    #[must_use]
    pub fn new(surface: &'a Surface, radius: f64, samples: u32) -> Self {
        Self { surface, range: surface.heights().range(), radius, samples }
    }

    /// How much of the disc is seen from a place on the surface, 0 to 1.
    #[must_use]
    pub fn visibility(&self, (x, y): (f64, f64), light: &DiscLight) -> f64 {
        let reaches = |sample: &u32| {
            let (towards, level_distance) = self.sample(light, *sample);
            let light = DirectionalLight { towards, azimuth_radians: libm::atan2(towards.y, towards.x) };
            !TracedShadow::within(self.surface, self.range, &light, self.radius.min(level_distance)).in_shadow(x, y)
        };
        let seen = (0..self.samples).filter(reaches).count();
        seen as f64 / f64::from(self.samples.max(1))
    }

    /// Towards a point of the disc, and how far along the base plane it is: of a spiral with as much area from one point to the next.
    fn sample(&self, light: &DiscLight, sample: u32) -> (DVec3, f64) {
        let part = (f64::from(sample) + 0.5) / f64::from(self.samples);
        let (sin, cos) = libm::sincos(GOLDEN_ANGLE * f64::from(sample));
        let (right, up) = light.towards.any_orthonormal_pair();
        let off_centre = part.sqrt() * libm::tan(light.angular_radius_radians);
        let point = light.towards + (right * cos + up * sin) * off_centre;
        // The disc at the distance 1 is as far along the base plane as the light's direction is level. NaN at the zenith, which
        // `f64::min` passes over.
        let scale = light.level_distance / light.towards.truncate().length();
        (point.normalize(), point.truncate().length() * scale)
    }
}
