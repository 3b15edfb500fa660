//! The baseline without any table: a shadow ray, followed cell by cell over the bilinear surface.
//!
//! Inside a cell the surface along the ray is a parabola and the ray a line, so whether the surface rises above the ray
//! is decided exactly: at the cell's ends and at the parabola's top.

use crate::{DirectionalLight, Surface};

/// How far above the ray a surface must rise to shade, as a part of the surface's whole relief: f64 noise must not.
const SELF_SHADOW_TOLERANCE: f64 = 1e-12;

/// Traces shadow rays towards one light.
#[derive(Debug, Clone)]
pub struct TracedShadow<'a> {
    surface: &'a Surface,
    radius: f64,
    tolerance: f64,
    highest: f64,
    /// Height gained per unit of length along the base plane.
    climb: f64,
    /// Columns and rows (downwards) moved per unit of length.
    step: (f64, f64),
}

impl<'a> TracedShadow<'a> {
    /// Rays look `radius` far along the base plane, in the surface's length unit.
    #[must_use]
    pub fn new(surface: &'a Surface, light: &DirectionalLight, radius: f64) -> Self {
        Self::within(surface, surface.heights().range(), light, radius)
    }

    /// The same, with the lowest and the highest height given.
    pub(crate) fn within(surface: &'a Surface, (low, high): (f32, f32), light: &DirectionalLight, radius: f64) -> Self {
        let (sin, cos) = libm::sincos(light.azimuth_radians);
        let (spacing_u, spacing_v) = surface.spacing();
        Self {
            surface,
            radius,
            highest: f64::from(high),
            tolerance: SELF_SHADOW_TOLERANCE * f64::from(high - low),
            climb: light.towards.z / light.level_length(),
            step: (cos / spacing_u, -sin / spacing_v),
        }
    }

    /// Whether the surface comes between a place on it and the light.
    #[must_use]
    pub fn in_shadow(&self, x: f64, y: f64) -> bool {
        let eye = self.surface.heights().sample(x, y);
        let mut start = 0.0;
        while start < self.radius {
            // Above everything there is, the ray meets nothing any more.
            if self.climb > 0.0 && self.climb * start > self.highest - eye {
                return false;
            }
            let end = self.next_crossing(x, y, start).min(self.radius);
            if self.rises_above_ray(x, y, eye, start, end) {
                return true;
            }
            start = end;
        }
        false
    }

    /// Where the ray leaves the cell it is in just after `start`.
    fn next_crossing(&self, x: f64, y: f64, start: f64) -> f64 {
        let to_border = |place: f64, step: f64| {
            if step == 0.0 {
                return f64::INFINITY;
            }
            let here = place + start * step;
            let border = if step > 0.0 { here.floor() + 1.0 } else { here.ceil() - 1.0 };
            (border - place) / step
        };
        let next = to_border(x, self.step.0).min(to_border(y, self.step.1));
        // Rounding may put a crossing on the wrong side of `start`; the walk must go on regardless.
        next.max(start + 1e-9 / self.step.0.abs().max(self.step.1.abs()))
    }

    fn rises_above_ray(&self, x: f64, y: f64, eye: f64, start: f64, end: f64) -> bool {
        let length = end - start;
        let at = |s: f64| (x + s * self.step.0, y + s * self.step.1);
        let middle = at(0.5 * (start + end));
        let ([h00, h10, h01, h11], (fx, fy)) = self.surface.heights().cell(middle.0, middle.1);
        // The parabola about the middle of the cell's part of the ray, above the ray's own height.
        let (along_x, along_y, twist) = (h10 - h00, h01 - h00, h00 - h10 - h01 + h11);
        let height = h00 + along_x * fx + along_y * fy + twist * fx * fy;
        let slope = along_x * self.step.0 + along_y * self.step.1 + twist * (fx * self.step.1 + fy * self.step.0);
        let bend = twist * self.step.0 * self.step.1;
        let above = |t: f64| {
            let s = 0.5 * (start + end) + t;
            height + t * (slope + t * bend) - eye - s * self.climb > self.tolerance
        };
        let half = 0.5 * length;
        let top = (self.climb - slope) / (2.0 * bend);
        above(-half) || above(half) || (bend < 0.0 && top.abs() < half && above(top))
    }
}
