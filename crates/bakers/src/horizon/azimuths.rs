//! The azimuths of a horizon map.

use super::params::MAX_DIRECTIONS;
use crate::BakeError;

/// Evenly spaced azimuths, counter-clockwise: 0° is +u, 90° is +v.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Azimuths {
    /// The whole circle, starting at 0°.
    FullCircle {
        /// How many: 360°/count apart.
        count: u32,
    },
    /// Part of the circle, both ends included: where a sun that never stands in the north can stand.
    Arc {
        /// The first azimuth in degrees, within ±360.
        first_degrees: f64,
        /// The last, counter-clockwise from the first, less than 360° from it.
        last_degrees: f64,
        /// How many: at least 2, so that both ends are baked.
        count: u32,
    },
}

impl Azimuths {
    /// The whole circle.
    #[must_use]
    pub fn full_circle(count: u32) -> Self {
        Self::FullCircle { count }
    }

    /// How many azimuths there are.
    #[must_use]
    pub fn count(&self) -> u32 {
        match *self {
            Self::FullCircle { count } | Self::Arc { count, .. } => count,
        }
    }

    /// An azimuth in degrees.
    #[must_use]
    pub fn degrees(&self, index: u32) -> f64 {
        match *self {
            Self::FullCircle { count } => 360.0 * f64::from(index) / f64::from(count),
            Self::Arc { first_degrees, last_degrees, count } => {
                // Written so that both ends are met exactly.
                let (index, last) = (f64::from(index), f64::from(count - 1));
                (first_degrees * (last - index) + last_degrees * index) / last
            }
        }
    }

    /// Cosine and sine of an azimuth: exact at multiples of 90°, and equal to each other at odd multiples of 45°, so that rays
    /// along the axes and diagonals stay on texel centres at any distance.
    #[must_use]
    pub fn vector(&self, index: u32) -> (f64, f64) {
        match *self {
            Self::FullCircle { count } => turn(4 * u64::from(index), u64::from(count)),
            Self::Arc { .. } => turn_by_degrees(self.degrees(index)),
        }
    }

    /// Refuses no or too many azimuths and an arc without a length.
    pub(crate) fn check(&self) -> Result<(), BakeError> {
        let refuse = |name, value: String, accepted| Err(BakeError::Parameter { name, value, accepted });
        match *self {
            Self::FullCircle { count } if (1..=MAX_DIRECTIONS).contains(&count) => Ok(()),
            Self::FullCircle { count } => refuse("directions", count.to_string(), "1 to 2048 azimuths are accepted"),
            Self::Arc { count, .. } if !(2..=MAX_DIRECTIONS).contains(&count) => refuse(
                "directions",
                count.to_string(),
                "2 to 2048 azimuths are accepted in an arc, which bakes both its ends",
            ),
            Self::Arc { first_degrees, last_degrees, .. } => {
                let span = last_degrees - first_degrees;
                if first_degrees.abs() <= 360.0 && span > 0.0 && span < 360.0 {
                    return Ok(());
                }
                let value = format!("{first_degrees} to {last_degrees}");
                refuse("arc", value, "degrees from within ±360 to a larger number, less than 360 beyond, are accepted")
            }
        }
    }
}

/// Cosine and sine of `90° · quarters / count`.
fn turn(quarters: u64, count: u64) -> (f64, f64) {
    let (cos, sin) = first_quadrant((quarters % count) as f64, count as f64);
    rotate(quarters / count % 4, (cos, sin))
}

fn turn_by_degrees(degrees: f64) -> (f64, f64) {
    let degrees = degrees.rem_euclid(360.0);
    rotate((degrees / 90.0) as u64, first_quadrant(degrees % 90.0, 90.0))
}

fn rotate(quarters: u64, (cos, sin): (f64, f64)) -> (f64, f64) {
    match quarters {
        0 => (cos, sin),
        1 => (-sin, cos),
        2 => (-cos, -sin),
        _ => (sin, -cos),
    }
}

/// Cosine and sine of `90° · part / whole`, folded at 45° so that the two halves mirror each other to the bit.
fn first_quadrant(part: f64, whole: f64) -> (f64, f64) {
    let angle = |part: f64| std::f64::consts::FRAC_PI_2 * part / whole;
    if part == 0.0 {
        (1.0, 0.0)
    } else if 2.0 * part == whole {
        (std::f64::consts::FRAC_1_SQRT_2, std::f64::consts::FRAC_1_SQRT_2)
    } else if 2.0 * part < whole {
        (libm::cos(angle(part)), libm::sin(angle(part)))
    } else {
        let mirrored = whole - part;
        (libm::sin(angle(mirrored)), libm::cos(angle(mirrored)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarter_turns_are_exact() {
        let turns: Vec<_> = (0..4).map(|k| Azimuths::full_circle(4).vector(k)).collect();
        assert_eq!(turns, [(1.0, 0.0), (-0.0, 1.0), (-1.0, -0.0), (0.0, -1.0)]);
    }

    #[test]
    fn every_vector_has_unit_length_and_the_azimuth_asked_for() {
        let arc = |first_degrees, last_degrees, count| Azimuths::Arc { first_degrees, last_degrees, count };
        let circles = [1, 2, 3, 5, 7, 8, 16, 17, 32, 360].map(Azimuths::full_circle);
        for azimuths in circles.into_iter().chain([arc(10.0, 170.0, 9), arc(-30.0, 30.0, 7), arc(350.0, 400.0, 2)]) {
            for k in 0..azimuths.count() {
                let (cos, sin) = azimuths.vector(k);
                let azimuth = azimuths.degrees(k).to_radians();
                let near = |a: f64, b: f64| (a - b).abs() < 2e-15;
                assert!(near(cos, azimuth.cos()) && near(sin, azimuth.sin()), "{azimuths:?} {k}");
            }
        }
    }

    #[test]
    fn an_arc_meets_both_ends_and_the_axes_between_exactly() {
        let arc = Azimuths::Arc { first_degrees: -45.0, last_degrees: 135.0, count: 5 };
        let half = std::f64::consts::FRAC_1_SQRT_2;
        let expected = [(half, -half), (1.0, 0.0), (half, half), (0.0, 1.0), (-half, half)];
        assert_eq!((0..5).map(|k| arc.vector(k)).collect::<Vec<_>>(), expected);
        assert_eq!((arc.degrees(0), arc.degrees(4)), (-45.0, 135.0));
    }

    #[test]
    fn an_arc_of_the_same_azimuths_is_the_circle_to_the_bit() {
        let (circle, arc) =
            (Azimuths::full_circle(32), Azimuths::Arc { first_degrees: 45.0, last_degrees: 180.0, count: 13 });
        for k in 0..13 {
            assert_eq!(arc.vector(k), circle.vector(k + 4));
        }
    }
}
