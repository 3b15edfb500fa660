//! The arc tangent for sixteen slopes at a time, the same bits on every machine.

use fearless_simd::{Simd, f32x16, prelude::*};

/// atan in radians, within 2 units in the last place: Stephen Moshier, *Cephes*, `atanf`: reduced to ±tan 22.5° and a
/// polynomial of degree 9.
#[inline(always)]
pub(crate) fn atan<S: Simd>(simd: S, slope: f32x16<S>) -> f32x16<S> {
    const TAN_67_5: f32 = 2.414_213_6;
    const TAN_22_5: f32 = 0.414_213_57;
    let splat = |value: f32| f32x16::splat(simd, value);
    let (zero, one) = (splat(0.0), splat(1.0));
    let size = slope.abs();
    let steep = size.simd_gt(splat(TAN_67_5));
    let middle = size.simd_gt(splat(TAN_22_5));
    let turned =
        steep.select(splat(std::f32::consts::FRAC_PI_2), middle.select(splat(std::f32::consts::FRAC_PI_4), zero));
    let numerator = steep.select(zero - one, middle.select(size - one, size));
    let denominator = steep.select(size, middle.select(size + one, one));
    let x = numerator / denominator;
    let z = x * x;
    let polynomial = ((z * 8.053_744_5e-2 - 1.387_768_6e-1) * z + 1.997_771_1e-1) * z - 3.333_295e-1;
    (turned + (polynomial * z * x + x)).copysign(slope)
}

#[cfg(test)]
mod tests {
    use super::*;
    use fearless_simd::{Level, dispatch};

    #[test]
    fn every_slope_has_its_angle() {
        let level = Level::new();
        let mut worst = 0.0_f64;
        for start in (-40_000..40_000).step_by(16) {
            let slopes: [f32; 16] = std::array::from_fn(|k| {
                let t = (start + k as i32) as f32 / 2000.0;
                t.powi(7) * 1e-3 + t * 0.01
            });
            let angles: [f32; 16] = dispatch!(level, simd => {
                let slopes: f32x16<_> = slopes.simd_into(simd);
                let angles: [f32; 16] = atan(simd, slopes).into();
                angles
            });
            for (slope, angle) in slopes.iter().zip(angles) {
                let error = f64::from(angle) - f64::from(*slope).atan();
                worst = worst.max(error.abs() / f64::from(angle.abs()).max(1e-30));
            }
        }
        assert!(worst < 2.5e-7, "{worst}");
    }

    #[test]
    fn the_ends_are_a_right_angle() {
        let slopes = [f32::MAX, -f32::MAX, f32::INFINITY, 0.0, -0.0, f32::MIN_POSITIVE, 1.0, -1.0];
        let slopes: [f32; 16] = std::array::from_fn(|k| slopes[k % 8]);
        let angles: [f32; 16] = dispatch!(Level::new(), simd => {
            let slopes: f32x16<_> = slopes.simd_into(simd);
            let angles: [f32; 16] = atan(simd, slopes).into();
            angles
        });
        use std::f32::consts::{FRAC_PI_2, FRAC_PI_4};
        let expected = [FRAC_PI_2, -FRAC_PI_2, FRAC_PI_2, 0.0, 0.0, f32::MIN_POSITIVE, FRAC_PI_4, -FRAC_PI_4];
        assert_eq!(angles[..8], expected);
    }
}
