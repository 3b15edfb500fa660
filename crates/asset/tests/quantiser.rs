//! The promise of the quantiser: no value is farther off than stated, in any f32 arithmetic a shader may use, and no
//! decoded value leaves the legal range.

use barchan_asset::{EncodeError, Encoded, Encoding, Format, MAX_ELEVATION, encode};
use proptest::prelude::*;

/// The stored number of texel `i`, as the format page defines it.
fn stored(encoded: &Encoded, i: usize) -> f32 {
    match encoded.format {
        Format::R8Unorm => f32::from(encoded.bytes[i]) / 255.0,
        Format::R16Float => half::f16::from_le_bytes([encoded.bytes[2 * i], encoded.bytes[2 * i + 1]]).to_f32(),
        Format::R32Float => f32::from_le_bytes(encoded.bytes[4 * i..4 * i + 4].try_into().unwrap()),
    }
}

/// Zero for a subnormal, as a GPU may flush it.
fn flushed(x: f32) -> f32 {
    if x.is_subnormal() { 0.0 } else { x }
}

/// What a shader may make of texel `i`: as defined, fused, or with subnormals flushed at every step.
fn decodings(encoded: &Encoded, i: usize) -> [f32; 3] {
    let (scale, bias, x) = (encoded.scale, encoded.bias, stored(encoded, i));
    if encoded.format == Format::R32Float {
        return [x; 3];
    }
    let flush = flushed(flushed(flushed(scale) * flushed(x)) + flushed(bias));
    [scale * x + bias, scale.mul_add(x, bias), flush]
}

fn check(values: &[f32], encoding: Encoding, legal: (f32, f32)) -> Result<(), TestCaseError> {
    let encoded = match encode(values, 1, values.len() as u64, encoding, legal.0..=legal.1) {
        Err(EncodeError::TooWide { min, max, .. }) => {
            prop_assert!(encoding == Encoding::U8 && max - min == f32::INFINITY);
            return Ok(());
        }
        encoded => encoded.unwrap(),
    };
    let constant = values.iter().all(|v| v == &values[0]);
    for (i, &value) in values.iter().enumerate() {
        for decoded in decodings(&encoded, i).into_iter().take(if constant { 2 } else { 3 }) {
            let error = (f64::from(decoded) - f64::from(value)).abs();
            prop_assert!(error <= encoded.worst_case_error, "{value}: {error} > {}", encoded.worst_case_error);
        }
        let [decoded, fused, _] = decodings(&encoded, i);
        prop_assert!(encoded.range.0 <= decoded && decoded <= encoded.range.1);
        prop_assert!(legal.0 <= decoded && decoded <= legal.1, "{decoded} of {value} is not legal");
        prop_assert!(legal.0 <= fused && fused <= legal.1, "{fused} of {value} is not legal");
    }
    prop_assert!(!constant || encoded.worst_case_error == 0.0);
    Ok(())
}

fn encodings() -> impl Strategy<Value = Encoding> {
    prop::sample::select(Encoding::ALL.to_vec())
}

/// Any finite f32 at all.
fn height() -> impl Strategy<Value = f32> {
    any::<f32>().prop_map(|x| if x.is_finite() { x } else { f32::MAX })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_heights(values in prop::collection::vec(height(), 1..40), encoding in encodings()) {
        check(&values, encoding, (f32::MIN, f32::MAX))?;
    }

    #[test]
    fn heights_that_differ_in_their_last_bits(
        base in -1e6_f32..1e6, steps in prop::collection::vec(0..40_u32, 1..40), encoding in encodings(),
    ) {
        let values: Vec<f32> = steps.into_iter().map(|n| f32::from_bits(base.to_bits() + n)).collect();
        check(&values, encoding, (f32::MIN, f32::MAX))?;
    }

    #[test]
    fn elevations_up_to_the_wall(
        values in prop::collection::vec(-MAX_ELEVATION..=MAX_ELEVATION, 1..40),
        wall in prop::sample::select(vec![MAX_ELEVATION, -MAX_ELEVATION]),
        encoding in encodings(),
    ) {
        let values: Vec<f32> = values.into_iter().chain([wall]).collect();
        check(&values, encoding, (-MAX_ELEVATION, MAX_ELEVATION))?;
    }

    #[test]
    fn distances_up_to_the_radius(
        parts in prop::collection::vec(0.0_f32..=1.0, 1..40), radius in 1e-30_f32..1e30, encoding in encodings(),
    ) {
        let values: Vec<f32> = parts.into_iter().map(|part| (part * radius).min(radius)).chain([radius]).collect();
        check(&values, encoding, (0.0, radius))?;
    }

    #[test]
    fn constant_tables_are_exact(value in height(), encoding in encodings()) {
        let encoded = encode(&[value; 3], 3, 1, encoding, f32::MIN..=f32::MAX).unwrap();
        prop_assert_eq!(encoded.range, (value, value));
        prop_assert_eq!(encoded.worst_case_error, 0.0);
    }
}

#[test]
fn the_stated_error_of_an_angle_table_is_small() {
    let table = [-MAX_ELEVATION, MAX_ELEVATION];
    let error = |encoding| encode(&table, 1, 2, encoding, -MAX_ELEVATION..=MAX_ELEVATION).unwrap().worst_case_error;
    assert_eq!(error(Encoding::F32), 0.0);
    assert!(error(Encoding::F16).to_degrees() < 0.0221, "{}", error(Encoding::F16).to_degrees());
    assert!(error(Encoding::U8).to_degrees() < 0.3531, "{}", error(Encoding::U8).to_degrees());
}
