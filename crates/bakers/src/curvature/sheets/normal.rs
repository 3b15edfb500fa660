//! The normal of a point from the triangles around it.
//!
//! Triangles count by their angle at the point, so that it does not matter how a flat face was cut into triangles (Thürmer and
//! Wüthrich, Computing Vertex Normals from Polygonal Facets, 1998). Departure: a triangle thinner than a thousandth of its length loses
//! its say in proportion. A cap that closes a T-junction is an angle of 180° whose normal is rounding.

use core::f64::consts::PI;

use glam::DVec3;

/// Height over length of a triangle below which it loses its say.
const THIN: f64 = 1e-3;

/// Sums the triangles between successive neighbours of a point.
#[derive(Debug)]
pub(super) struct Normal {
    middle: DVec3,
    /// A height that is all rounding.
    rounding: f64,
    first: DVec3,
    last: DVec3,
    sum: DVec3,
}

impl Normal {
    pub(super) fn around(middle: DVec3) -> Self {
        let rounding = 4.0 * f64::EPSILON * middle.abs().max_element();
        Self { middle, rounding, first: DVec3::ZERO, last: DVec3::ZERO, sum: DVec3::ZERO }
    }

    /// The next neighbour, counter-clockwise; how far it is.
    pub(super) fn go_on_to(&mut self, neighbour: DVec3) -> f64 {
        let arm = neighbour - self.middle;
        if self.first == DVec3::ZERO {
            self.first = arm;
        } else {
            self.sum += self.say(self.last, arm);
        }
        self.last = arm;
        arm.length()
    }

    /// The unit normal, or zero where no triangle has an area.
    pub(super) fn of_open_fan(&self) -> DVec3 {
        self.sum.normalize_or_zero()
    }

    /// The same, with the triangle between the last neighbour and the first.
    pub(super) fn of_closed_fan(&self) -> DVec3 {
        (self.sum + self.say(self.last, self.first)).normalize_or_zero()
    }

    /// Unit normal of the triangle between two arms, times its angle.
    fn say(&self, a: DVec3, b: DVec3) -> DVec3 {
        let normal = a.cross(b);
        let double_area = normal.length();
        let longest_squared = a.length_squared().max(b.length_squared()).max((b - a).length_squared());
        let longest = longest_squared.sqrt();
        // In units of length squared, so that nothing is divided by a height of zero.
        let height = double_area - self.rounding * longest;
        if height.is_nan() || height <= 0.0 {
            return DVec3::ZERO;
        }
        let share = (height / (THIN * longest_squared)).min(1.0);
        normal * (share * angle(double_area, a.dot(b), (a.length_squared() * b.length_squared()).sqrt()) / double_area)
    }
}

/// The angle of which `sine` and `cosine` are given times `scale`, to 2e-8: a weight. (Abramowitz and Stegun, Handbook of Mathematical Functions, 4.4.46.)
fn angle(sine: f64, cosine: f64, scale: f64) -> f64 {
    const TERMS: [f64; 8] = [
        1.570_796_305_0,
        -0.214_598_801_6,
        0.088_978_987_4,
        -0.050_174_304_6,
        0.030_891_881_0,
        -0.017_088_125_6,
        0.006_670_090_1,
        -0.001_262_491_1,
    ];
    let x = (cosine.abs() / scale).min(1.0);
    let series = TERMS.iter().rev().fold(0.0, |sum, term| sum * x + term);
    // √(1 − x) without its cancellation: sin² = (1 − x)(1 + x).
    let acute = sine / scale / (1.0 + x).sqrt() * series;
    if cosine < 0.0 { PI - acute } else { acute }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_angle_is_that_of_sine_and_cosine() {
        for step in 0..=1000 {
            let expected = PI * f64::from(step) / 1000.0;
            let found = angle(3.0 * libm::sin(expected), 3.0 * libm::cos(expected), 3.0);
            assert!((found - expected).abs() < 3e-8, "{expected}: {found}");
        }
    }
}
