//! False colour for errors: one map for sizes, one for signed values.

/// What is not a number: a colour that neither map contains.
const NOT_A_NUMBER: [u8; 3] = [255, 0, 255];

/// Viridis by Stéfan van der Walt and Nathaniel Smith (matplotlib, 2015, released to the public domain under CC0),
/// sampled at 17 even steps. Linear interpolation stays within 6/255 of the published 256 steps.
const VIRIDIS: [[u8; 3]; 17] = [
    [68, 1, 84],
    [72, 24, 106],
    [71, 45, 123],
    [66, 64, 134],
    [59, 82, 139],
    [51, 99, 141],
    [44, 114, 142],
    [38, 129, 142],
    [33, 144, 140],
    [31, 159, 136],
    [40, 174, 128],
    [62, 188, 116],
    [93, 201, 99],
    [130, 211, 76],
    [171, 220, 50],
    [213, 226, 26],
    [253, 231, 37],
];

/// The 11 classes of RdBu by Cynthia Brewer (*ColorBrewer*, 2003), from blue to red, with its middle made pure white.
const BLUE_WHITE_RED: [[u8; 3]; 11] = [
    [5, 48, 97],
    [33, 102, 172],
    [67, 147, 195],
    [146, 197, 222],
    [209, 229, 240],
    [255, 255, 255],
    [253, 219, 199],
    [244, 165, 130],
    [214, 96, 77],
    [178, 24, 43],
    [103, 0, 31],
];

/// A colour, sRGB, for a size `t` from 0 (dark violet) to 1 (yellow); lightness grows with `t`. Values beyond are
/// clamped, a NaN is magenta.
#[must_use]
pub fn false_colour(t: f64) -> [u8; 3] {
    along(&VIRIDIS, t)
}

/// A colour, sRGB, for a signed value `t` from −1 (dark blue) over 0 (white) to 1 (dark red). Values beyond are clamped, a
/// NaN is magenta.
#[must_use]
pub fn signed_colour(t: f64) -> [u8; 3] {
    along(&BLUE_WHITE_RED, 0.5 + 0.5 * t)
}

/// Linear interpolation between evenly spaced colours.
fn along(table: &[[u8; 3]], t: f64) -> [u8; 3] {
    if t.is_nan() {
        return NOT_A_NUMBER;
    }
    let last = table.len() - 1;
    let x = t.clamp(0.0, 1.0) * last as f64;
    let i = (x as usize).min(last - 1);
    let fraction = x - i as f64;
    std::array::from_fn(|channel| {
        let (a, b) = (f64::from(table[i][channel]), f64::from(table[i + 1][channel]));
        (a + (b - a) * fraction).round() as u8
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Relative luminance of an sRGB colour (IEC 61966-2-1).
    fn luminance(colour: [u8; 3]) -> f64 {
        let linear = colour.map(|byte| {
            let c = f64::from(byte) / 255.0;
            if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
        });
        0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
    }

    #[test]
    fn luminance_grows_with_every_step() {
        // At 256 steps rounding to bytes outweighs a step, in the published table as well.
        let levels: Vec<f64> = (0..=200).map(|k| luminance(false_colour(f64::from(k) / 200.0))).collect();
        assert!(levels.windows(2).all(|pair| pair[0] < pair[1]));
    }

    #[test]
    fn the_signed_map_darkens_away_from_white_on_both_sides() {
        for side in [-1.0, 1.0] {
            let levels: Vec<f64> = (0..128).map(|k| luminance(signed_colour(side * f64::from(k) / 127.0))).collect();
            assert!(levels.windows(2).all(|pair| pair[0] > pair[1]));
        }
        assert_eq!(signed_colour(0.0), [255; 3]);
        assert_eq!((signed_colour(-1.0), signed_colour(1.0)), ([5, 48, 97], [103, 0, 31]));
    }

    #[test]
    fn values_beyond_the_ends_are_clamped_and_a_nan_stands_out() {
        assert_eq!((false_colour(-3.0), false_colour(f64::INFINITY)), ([68, 1, 84], [253, 231, 37]));
        assert_eq!((false_colour(f64::NAN), signed_colour(f64::NAN)), ([255, 0, 255], [255, 0, 255]));
        assert_eq!((signed_colour(f64::NEG_INFINITY), signed_colour(9.0)), (signed_colour(-1.0), signed_colour(1.0)));
    }
}
