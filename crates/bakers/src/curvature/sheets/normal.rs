//! The normal of a point from the triangles around it.
//!
//! Triangles count by their angle at the point, so that it does not matter how a flat face was cut into triangles (Thürmer and
//! Wüthrich, Computing Vertex Normals from Polygonal Facets, 1998). Departure: a triangle thinner than a thousandth of its length loses
//! its say in proportion. A cap that closes a T-junction is an angle of 180° whose normal is rounding.

use core::f64::consts::PI;

use glam::DVec3;

/// Height over length of a triangle below which it loses its say.
const THIN: f64 = 1e-3;

/// The way to a neighbour.
#[derive(Debug, Clone, Copy)]
struct Arm {
    direction: DVec3,
    length: f64,
}

/// Sums the triangles between successive neighbours of a point.
#[derive(Debug)]
pub(super) struct Normal {
    middle: DVec3,
    /// A height that is all rounding.
    rounding: f64,
    /// The first and the latest neighbour.
    arms: Option<[Arm; 2]>,
    sum: DVec3,
}

impl Normal {
    pub(super) fn around(middle: DVec3) -> Self {
        let rounding = 4.0 * f64::EPSILON * middle.abs().max_element();
        Self { middle, rounding, arms: None, sum: DVec3::ZERO }
    }

    /// The next neighbour, counter-clockwise; how far it is.
    pub(super) fn go_on_to(&mut self, neighbour: DVec3) -> f64 {
        let offset = neighbour - self.middle;
        let length = offset.length();
        let arm = Arm { direction: offset / length, length };
        self.arms = Some(match self.arms {
            None => [arm; 2],
            Some([first, latest]) => {
                self.sum += self.say(latest, arm);
                [first, arm]
            }
        });
        length
    }

    /// The unit normal, or zero where no triangle has an area.
    pub(super) fn of_open_fan(&self) -> DVec3 {
        self.sum.normalize_or_zero()
    }

    /// The same, with the triangle between the last neighbour and the first.
    pub(super) fn of_closed_fan(&self) -> DVec3 {
        let closing = self.arms.map_or(DVec3::ZERO, |[first, latest]| self.say(latest, first));
        (self.sum + closing).normalize_or_zero()
    }

    /// Unit normal of the triangle between two arms, times its angle and its say.
    fn say(&self, a: Arm, b: Arm) -> DVec3 {
        let normal = a.direction.cross(b.direction);
        let (sine, cosine) = (normal.length(), a.direction.dot(b.direction));
        let product = a.length * b.length;
        let (a_squared, b_squared) = (a.length * a.length, b.length * b.length);
        let longest_squared = a_squared.max(b_squared).max(a_squared + b_squared - 2.0 * product * cosine);
        // Height and length of the triangle, both times its length.
        let (height, least) = (product * sine - self.rounding * (a.length + b.length), THIN * longest_squared);
        if height >= least {
            normal * angle_over_sine(sine, cosine)
        } else if height > 0.0 {
            normal * (angle_over_sine(sine, cosine) * (height / least))
        } else {
            DVec3::ZERO
        }
    }
}

/// An angle over its sine, given that and its cosine; to 2e-8 of the angle, which is a weight (Abramowitz and Stegun, Handbook of
/// Mathematical Functions, 4.4.46).
fn angle_over_sine(sine: f64, cosine: f64) -> f64 {
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
    let x = cosine.abs();
    let series = TERMS.iter().rev().fold(0.0, |sum, term| sum * x + term);
    // The source has √(1 − x), which is sine / √(1 + x) and does not cancel.
    let acute = series / (1.0 + x).sqrt();
    if cosine < 0.0 { PI / sine - acute } else { acute }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_angle_is_that_of_sine_and_cosine() {
        for step in 1..1000 {
            let expected = PI * f64::from(step) / 1000.0;
            let (sine, cosine) = (libm::sin(expected), libm::cos(expected));
            let found = sine * angle_over_sine(sine, cosine);
            assert!((found - expected).abs() < 3e-8, "{expected}: {found}");
        }
    }
}
