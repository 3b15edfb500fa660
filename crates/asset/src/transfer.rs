//! From what a table stores to the value it stands for.

use crate::Transfer;
use crate::angle::{arcsine, sine};

/// The greatest elevation a table holds: the largest f32 below π/2, in radians. The least is its negative.
///
/// The f32 nearest to π/2 is *above* π/2, so a wall's elevation has to be cut to this before it is encoded.
pub const MAX_ELEVATION: f32 = f32::from_bits(0x3FC9_0FDA);

impl Transfer {
    /// The value of `t = scale · stored + bias`: t itself, asin t in radians, or t².
    ///
    /// The arcsine is rounded to f32, cut to ±[`MAX_ELEVATION`], and has the same bits on every machine; a t beyond ±1,
    /// which no valid file holds, counts as ±1.
    #[must_use]
    pub fn value(self, t: f32) -> f32 {
        match self {
            Self::Identity => t,
            Self::Sine => elevation_of_sine(t),
            Self::Square => t * t,
        }
    }
}

/// The elevation in radians with that sine.
fn elevation_of_sine(sine: f32) -> f32 {
    (arcsine(f64::from(sine)) as f32).clamp(-MAX_ELEVATION, MAX_ELEVATION)
}

/// The sine of an elevation in radians, within ±[`MAX_ELEVATION`] in a valid file.
pub(crate) fn sine_of_elevation(elevation_radians: f32) -> f32 {
    sine(f64::from(elevation_radians)) as f32
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::FRAC_PI_2;

    #[test]
    fn the_greatest_elevation_is_the_last_f32_below_a_right_angle() {
        assert!(f64::from(MAX_ELEVATION) < FRAC_PI_2);
        assert!(f64::from(MAX_ELEVATION.next_up()) > FRAC_PI_2);
    }

    #[test]
    fn a_wall_survives_its_sine() {
        assert_eq!(sine_of_elevation(MAX_ELEVATION), 1.0);
        assert_eq!(Transfer::Sine.value(1.0), MAX_ELEVATION);
        assert_eq!(Transfer::Sine.value(-1.5), -MAX_ELEVATION);
        assert!(Transfer::Sine.value(f32::NAN).is_nan());
    }
}
