//! Sine, tangent, arcsine and square root in f64 without a maths library: the same bits on every machine, `no_std` or not.
//!
//! Only sums, products and quotients are used, which IEEE 754 rounds in one way. Errors are below 2⁻⁵⁰, so that rounding
//! a result to f32 gives, but for about one argument in 2²⁵, the f32 nearest to the truth.

use core::f64::consts::FRAC_PI_2;

/// (asin √z / √z − 1) / z on [0, ¼], by powers of z: interpolated at the Chebyshev points, 6e-17 off at most.
const ARCSINE: [f64; 12] = [
    0.166_666_666_666_666_5,
    0.075_000_000_000_207_64,
    0.044_642_857_103_423_646,
    0.030_381_947_367_098_48,
    0.022_372_047_631_744_51,
    0.017_355_259_955_786_323,
    0.013_929_652_902_326_633,
    0.011_875_494_382_636_922,
    0.007_802_949_477_353_317,
    0.016_035_514_349_148_825,
    -0.010_749_050_339_697_81,
    0.028_169_218_060_881_414,
];

/// The angle in [−π/2, π/2] with that sine, in radians. A sine beyond ±1 counts as ±1; NaN stays NaN.
pub(crate) fn arcsine(sine: f64) -> f64 {
    let size = sine.abs();
    let angle = if size <= 0.5 {
        small_arcsine(size, size * size)
    } else {
        // asin x = π/2 − 2 asin √((1 − x)/2).
        let square = 0.5 * (1.0 - size.min(1.0));
        FRAC_PI_2 - 2.0 * small_arcsine(square_root(square), square)
    };
    if sine.is_nan() { sine } else { angle.copysign(sine) }
}

/// asin x for 0 ≤ x ≤ ½, given x².
fn small_arcsine(x: f64, square: f64) -> f64 {
    let series = ARCSINE.iter().rev().fold(0.0, |sum, coefficient| sum * square + coefficient);
    x + x * (square * series)
}

/// The sine of an angle in [−π/2, π/2], in radians: its Taylor series up to the 23rd power.
pub(crate) fn sine(angle: f64) -> f64 {
    let square = angle * angle;
    let series = (1..=11_i32).rev().fold(1.0, |sum, k| {
        let factor = f64::from(2 * k * (2 * k + 1));
        1.0 - square / factor * sum
    });
    angle * series
}

/// The tangent of an angle in [0, π/2), in radians; relative error below 2⁻⁴⁸ even beside π/2.
pub(crate) fn tangent(angle: f64) -> f64 {
    /// What π/2 is more than the f64 nearest to it.
    const FRAC_PI_2_REST: f64 = 6.123_233_995_736_766e-17;
    sine(angle) / sine(FRAC_PI_2 - angle + FRAC_PI_2_REST)
}

/// √x for 0 ≤ x ≤ 4; 0 for a negative x, NaN for NaN. Newton's iteration for 1/√x, which doubles the right digits each time.
pub(crate) fn square_root(x: f64) -> f64 {
    if x.is_nan() {
        return x;
    }
    if x < f64::MIN_POSITIVE {
        return 0.0;
    }
    // Halving the exponent is right to 4 %: Chris Lomont, Fast inverse square root, 2003.
    let mut inverse = f64::from_bits(0x5FE6_EB50_C7B5_37A9 - (x.to_bits() >> 1));
    for _ in 0..4 {
        inverse *= 1.5 - 0.5 * x * inverse * inverse;
    }
    // One more step on the root itself removes the rounding of the last product.
    let root = x * inverse;
    root + 0.5 * inverse * (x - root * root)
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;

    /// Every 101st f32 in [0, 1].
    fn unit_interval() -> impl Iterator<Item = f32> {
        (0..=0x3F80_0000_u32).step_by(101).chain([0x3F80_0000]).map(f32::from_bits)
    }

    #[test]
    fn arcsine_and_sine_are_right_to_f64() {
        for x in unit_interval().map(f64::from) {
            assert!((arcsine(x) - x.asin()).abs() < 5e-16, "asin {x}");
            assert_eq!(arcsine(-x), -arcsine(x));
            let angle = x * FRAC_PI_2;
            assert!((sine(angle) - angle.sin()).abs() < 5e-16, "sin {angle}");
            assert!((square_root(x) - x.sqrt()).abs() < 3e-16, "sqrt {x}");
        }
    }

    #[test]
    fn tangent_is_right_up_to_the_right_angle() {
        assert_eq!(tangent(0.0), 0.0);
        for angle in unit_interval().map(|x| f64::from(x) * FRAC_PI_2.next_down()) {
            assert!((tangent(angle) - angle.tan()).abs() <= 4e-15 * angle.tan(), "tan {angle}");
        }
    }

    #[test]
    fn rounded_to_f32_arcsine_never_falls() {
        let mut before = -1.0;
        for angle in unit_interval().map(|x| arcsine(f64::from(x)) as f32) {
            assert!(angle >= before);
            before = angle;
        }
    }

    #[test]
    fn ends_and_beyond() {
        assert_eq!([arcsine(0.0), arcsine(1.0), arcsine(-7.0)], [0.0, FRAC_PI_2, -FRAC_PI_2]);
        assert!(arcsine(f64::NAN).is_nan());
        assert_eq!([square_root(0.0), square_root(-1.0), square_root(1.0)], [0.0, 0.0, 1.0]);
        assert!(square_root(f64::NAN).is_nan() && square_root(-f64::NAN).is_nan());
    }
}
