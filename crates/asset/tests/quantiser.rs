//! The promise of the quantiser: no value is farther off than stated, in any f32 arithmetic a shader may use, and no
//! decoded value leaves the legal range. And what was measured is what happened.

use barchan_asset::{
    ApertureConeTable, Azimuths, BentNormalTable, Component, DistanceTable, EncodeError, Encoding, HeightTable,
    HorizonTable, LengthUnit, MAX_ELEVATION, SkyVisibilityTable, TableEncoder, TableFacts, TableGrid, TextureTable,
    Transfer, Wrap,
};
use proptest::prelude::*;

const EVERY: [Encoding; 4] = Encoding::ALL;

fn row(width: usize) -> TableGrid {
    TableGrid {
        width: width as u32,
        height: 1,
        spacing_u: 1.0,
        spacing_v: 1.0,
        length_unit: LengthUnit::Metre,
        wrap_u: Wrap::Clamp,
        wrap_v: Wrap::Clamp,
    }
}

fn heights(values: &[f32], encoding: Encoding) -> Result<TextureTable, EncodeError> {
    HeightTable { grid: row(values.len()), values }.encode(encoding)
}

fn elevations(values: &[f32], encoding: Encoding) -> Result<TextureTable, EncodeError> {
    HorizonTable { grid: row(values.len()), azimuths: Azimuths::full_circle(1), radius: 1.0, values }.encode(encoding)
}

fn distances(values: &[f32], radius: f32, encoding: Encoding) -> Result<TextureTable, EncodeError> {
    let (azimuths, radius) = (Azimuths::full_circle(1), f64::from(radius));
    DistanceTable { grid: row(values.len()), azimuths, radius, values }.encode(encoding)
}

/// The stored number `i`, as the format page defines it.
fn stored(table: &TextureTable, i: usize) -> f32 {
    let bytes = table.payload();
    match table.descriptor().format.component() {
        Component::Unorm8 => f32::from(bytes[i]) / 255.0,
        Component::Float16 => half::f16::from_le_bytes([bytes[2 * i], bytes[2 * i + 1]]).to_f32(),
        Component::Float32 => f32::from_le_bytes(bytes[4 * i..4 * i + 4].try_into().unwrap()),
    }
}

/// Zero for a subnormal, as a GPU may flush it.
fn flushed(x: f32) -> f32 {
    if x.is_subnormal() { 0.0 } else { x }
}

/// What a shader may make of number `i`: as defined, fused, or with subnormals flushed at every step.
fn decodings(table: &TextureTable, i: usize) -> [f32; 3] {
    let descriptor = table.descriptor();
    let (scale, bias, x) = (descriptor.scale as f32, descriptor.bias as f32, stored(table, i));
    let flush = flushed(flushed(flushed(scale) * flushed(x)) + flushed(bias));
    let numbers = match descriptor.format.component() {
        Component::Float32 => [x; 3],
        _ => [scale * x + bias, scale.mul_add(x, bias), flush],
    };
    numbers.map(|t| descriptor.transfer.value(t))
}

fn check(values: &[f32], table: &TextureTable, legal: (f32, f32)) -> Result<(), TestCaseError> {
    let descriptor = table.descriptor();
    let constant = values.iter().all(|v| v == &values[0]) && descriptor.transfer == Transfer::Identity;
    let decoded: Vec<f32> = (0..values.len()).map(|i| table.view().unwrap().channel_of(i)).collect();
    for (i, &value) in values.iter().enumerate() {
        for decoded in decodings(table, i).into_iter().take(if constant { 2 } else { 3 }) {
            let error = (f64::from(decoded) - f64::from(value)).abs();
            prop_assert!(error <= descriptor.worst_case_error, "{value}: {error} > {}", descriptor.worst_case_error);
        }
        let [as_defined, fused, _] = decodings(table, i);
        prop_assert_eq!(as_defined, decoded[i]);
        prop_assert!(legal.0 <= as_defined && as_defined <= legal.1, "{} of {} is not legal", as_defined, value);
        prop_assert!(legal.0 <= fused && fused <= legal.1, "{} of {} is not legal", fused, value);
    }
    let least = decoded.iter().copied().fold(f32::INFINITY, f32::min);
    let greatest = decoded.iter().copied().fold(f32::NEG_INFINITY, f32::max);
    prop_assert_eq!((descriptor.range_min, descriptor.range_max), (f64::from(least), f64::from(greatest)));
    prop_assert!(!constant || descriptor.worst_case_error == 0.0);
    measured(values, &decoded, table)
}

/// The loss stated is the loss of the decoded values.
fn measured(values: &[f32], decoded: &[f32], table: &TextureTable) -> Result<(), TestCaseError> {
    let loss = table.loss().unwrap();
    let errors = values.iter().zip(decoded).map(|(&value, &decoded)| f64::from(decoded) - f64::from(value));
    let max = errors.clone().fold(0.0, |max: f64, error| max.max(error.abs()));
    let rms = (errors.map(|error| error * error).sum::<f64>() / values.len() as f64).sqrt();
    prop_assert_eq!((loss.values, loss.max), (values.len() as u64, max));
    prop_assert!((loss.rms - rms).abs() <= 1e-12 * rms, "{} against {rms}", loss.rms);
    Ok(())
}

/// Numbers of a table of one row, channels and all.
trait Numbers {
    fn channel_of(&self, index: usize) -> f32;
}

impl Numbers for barchan_asset::TableView<'_> {
    fn channel_of(&self, index: usize) -> f32 {
        let channels = self.descriptor().format.channels() as usize;
        self.channel(0, (index / channels) as u32, 0, (index % channels) as u32)
    }
}

fn encodings() -> impl Strategy<Value = Encoding> {
    prop::sample::select(EVERY.to_vec())
}

/// Any finite f32 at all.
fn height() -> impl Strategy<Value = f32> {
    any::<f32>().prop_map(|x| if x.is_finite() { x } else { f32::MAX })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_heights(values in prop::collection::vec(height(), 1..40), encoding in encodings()) {
        match heights(&values, encoding) {
            Err(EncodeError::TooWide { min, max, .. }) => {
                prop_assert!(encoding == Encoding::U8 && max - min == f32::INFINITY);
            }
            table => check(&values, &table.unwrap(), (f32::MIN, f32::MAX))?,
        }
    }

    #[test]
    fn heights_that_differ_in_their_last_bits(
        base in -1e6_f32..1e6, steps in prop::collection::vec(0..40_u32, 1..40), encoding in encodings(),
    ) {
        let values: Vec<f32> = steps.into_iter().map(|n| f32::from_bits(base.to_bits() + n)).collect();
        check(&values, &heights(&values, encoding).unwrap(), (f32::MIN, f32::MAX))?;
    }

    #[test]
    fn elevations_up_to_the_wall(
        values in prop::collection::vec(-MAX_ELEVATION..=MAX_ELEVATION, 1..40),
        wall in prop::sample::select(vec![MAX_ELEVATION, -MAX_ELEVATION]),
        encoding in encodings(),
    ) {
        let values: Vec<f32> = values.into_iter().chain([wall]).collect();
        check(&values, &elevations(&values, encoding).unwrap(), (-MAX_ELEVATION, MAX_ELEVATION))?;
    }

    #[test]
    fn elevations_of_gentle_ground_and_of_one_slope(
        centre in -1.5_f32..1.5, parts in prop::collection::vec(-1.0_f32..1.0, 1..40), width in 0.0_f32..0.07,
        encoding in encodings(),
    ) {
        let values: Vec<f32> = parts.into_iter().map(|part| centre + part * width * width).collect();
        check(&values, &elevations(&values, encoding).unwrap(), (-MAX_ELEVATION, MAX_ELEVATION))?;
    }

    #[test]
    fn distances_up_to_the_radius(
        parts in prop::collection::vec(0.0_f32..=1.0, 1..40), radius in 1e-30_f32..1e30, encoding in encodings(),
    ) {
        let values: Vec<f32> = parts.into_iter().map(|part| (part * radius).min(radius)).chain([radius]).collect();
        check(&values, &distances(&values, radius, encoding).unwrap(), (0.0, radius))?;
    }

    #[test]
    fn distances_far_from_the_radius(
        values in prop::collection::vec(1e-3_f32..1e3, 1..40), encoding in encodings(),
    ) {
        check(&values, &distances(&values, f32::MAX, encoding).unwrap(), (0.0, f32::MAX))?;
    }

    #[test]
    fn shares_of_the_sky(values in prop::collection::vec(0.0_f32..=1.0, 1..40), encoding in encodings()) {
        let table = SkyVisibilityTable { grid: row(values.len()), radius: 1.0, values: &values };
        check(&values, &table.encode(encoding).unwrap(), (0.0, 1.0))?;
    }

    #[test]
    fn directions_of_two_and_of_four_channels(
        values in prop::collection::vec(-1.0_f32..=1.0, 4..40), encoding in encodings(),
    ) {
        let values = &values[..values.len() / 4 * 4];
        let bent = BentNormalTable { grid: row(values.len() / 2), radius: 1.0, values };
        check(values, &bent.encode(encoding).unwrap(), (-1.0, 1.0))?;
        let cone = ApertureConeTable { grid: row(values.len() / 4), radius: 1.0, values };
        check(values, &cone.encode(encoding).unwrap(), (-1.0, 1.0))?;
    }

    #[test]
    fn bounds_wider_than_the_values(
        values in prop::collection::vec(0.1_f32..=0.9, 1..40), encoding in encodings(), below in 0.0_f32..0.1,
    ) {
        let facts = TableFacts::horizon(row(values.len()), Azimuths::full_circle(1), 1.0);
        let mut encoder = TableEncoder::new(&facts, encoding, -below..=0.9 + below).unwrap();
        let payload = encoder.layer(0, &values).unwrap();
        let (descriptor, loss) = encoder.finish().unwrap();
        let table = TextureTable::new(descriptor, payload).unwrap();
        let decoded: Vec<f32> = table.view().unwrap().row(0, 0).collect();
        let least = decoded.iter().copied().fold(f32::INFINITY, f32::min);
        prop_assert_eq!(table.descriptor().range_min, f64::from(least));
        prop_assert!(loss.max <= table.descriptor().worst_case_error);
        for (&value, &decoded) in values.iter().zip(&decoded) {
            prop_assert!((f64::from(value) - f64::from(decoded)).abs() <= loss.max);
        }
    }

    #[test]
    fn constant_tables_are_exact(value in height(), encoding in encodings()) {
        let table = heights(&[value; 3], encoding).unwrap();
        let descriptor = table.descriptor();
        prop_assert_eq!((descriptor.range_min, descriptor.range_max), (f64::from(value), f64::from(value)));
        prop_assert_eq!(descriptor.worst_case_error, 0.0);
    }
}

#[test]
fn the_stated_error_of_an_angle_table_is_small() {
    let error =
        |values: &[f32], encoding| elevations(values, encoding).unwrap().descriptor().worst_case_error.to_degrees();
    let table = [-MAX_ELEVATION, MAX_ELEVATION];
    assert_eq!(error(&table, Encoding::F32), 0.0);
    assert!(error(&table, Encoding::F16) < 0.0221, "{}", error(&table, Encoding::F16));
    assert!(error(&table, Encoding::U8) < 0.3531, "{}", error(&table, Encoding::U8));
    // A byte of the sine is good where light grazes the ground, and poor at walls.
    assert!(error(&table, Encoding::Compact) < 5.08, "{}", error(&table, Encoding::Compact));
    let gentle = [-10_f32, 45.0].map(f32::to_radians);
    assert!(error(&gentle, Encoding::Compact) < 0.1401, "{}", error(&gentle, Encoding::Compact));
}

#[test]
fn a_byte_of_the_root_resolves_near_points() {
    let values = [0.0, 0.01, 64.0];
    let decoded: Vec<f32> = distances(&values, 64.0, Encoding::Compact).unwrap().view().unwrap().row(0, 0).collect();
    assert_eq!((decoded[0], decoded[2]), (0.0, 64.0));
    assert!((decoded[1] - values[1]).abs() < 0.003, "{}", decoded[1]);
}

#[test]
fn bounds_that_are_none_or_leave_the_legal_range_are_refused() {
    let facts = TableFacts::distance(row(1), Azimuths::full_circle(1), 5.0);
    for bounds in [-1.0..=1.0, 0.0..=5.1, f32::NAN..=1.0, 0.0..=f32::NAN, core::ops::RangeInclusive::new(2.0, 1.0)] {
        let refused = TableEncoder::new(&facts, Encoding::U8, bounds);
        assert!(matches!(refused, Err(EncodeError::Bounds { .. })));
    }
    let mut encoder = TableEncoder::new(&facts, Encoding::U8, 1.0..=2.0).unwrap();
    assert!(matches!(encoder.layer(0, &[2.5]), Err(EncodeError::Value { index: 0, .. })));
    assert!(matches!(encoder.layer(1, &[1.5]), Err(EncodeError::Layer { layer: 1, layers: 1 })));
    assert!(matches!(encoder.finish(), Err(EncodeError::Missing { layer: 0, layers: 1 })));
}
