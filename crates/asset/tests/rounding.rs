//! Bounds stay bounds: what is rounded to one side never decodes to the other, however awkward the value, and is never
//! farther off than stated.

use barchan_asset::{
    Azimuths, Component, ConeMapTable, DepthMode, EncodeError, Encoding, HemisphereDirections, HemisphereTable,
    LengthUnit, MaximumMipTable, RelaxedConeMapTable, ReliefRange, RingSpacing, TableGrid, TextureTable, Wrap,
};
use proptest::prelude::*;

const RELIEF: ReliefRange = ReliefRange { top: 0.0, thickness: 1.0 };

fn row(width: usize) -> TableGrid {
    let (length_unit, wrap) = (LengthUnit::Metre, Wrap::Clamp);
    let width = width as u32;
    TableGrid { width, height: 1, spacing_u: 1.0, spacing_v: 1.0, length_unit, wrap_u: wrap, wrap_v: wrap }
}

fn depths(values: &[f32], mode: DepthMode, encoding: Encoding) -> TextureTable {
    let (azimuths, spacing) = (Azimuths::full_circle(1), RingSpacing::EqualAngles);
    let directions = HemisphereDirections { rings: 1, azimuths, spacing, max_polar_radians: 1.0 };
    let table = HemisphereTable { grid: row(values.len()), directions, mode, relief: RELIEF, values };
    table.encode(encoding).unwrap()
}

/// What a reader makes of the first layer, channels interleaved.
fn decoded(table: &TextureTable) -> Vec<f32> {
    table.view().unwrap().row(0, 0).collect()
}

/// What a shader that fuses product and sum makes of the `i`th number.
fn fused(table: &TextureTable, i: usize) -> f32 {
    let (descriptor, bytes) = (table.descriptor(), table.payload());
    let stored = match descriptor.format.component() {
        Component::Unorm8 => f32::from(bytes[i]) / 255.0,
        Component::Float16 => half::f16::from_le_bytes([bytes[2 * i], bytes[2 * i + 1]]).to_f32(),
        Component::Float32 => f32::from_le_bytes(bytes[4 * i..4 * i + 4].try_into().unwrap()),
    };
    if descriptor.semantic.is_plain(i as u32 % descriptor.format.channels()) {
        return stored;
    }
    descriptor.transfer.value((descriptor.scale as f32).mul_add(stored, descriptor.bias as f32))
}

/// Every decoded number is on the right side of what was given and within the stated error, fused or not.
fn check(given: &[f32], table: &TextureTable, right: fn(f32, f32) -> bool) -> Result<(), TestCaseError> {
    let stated = table.descriptor().worst_case_error;
    for (i, (&value, decoded)) in given.iter().zip(decoded(table)).enumerate() {
        prop_assert!(right(decoded, value), "{decoded} of {value}");
        for decoded in [decoded, fused(table, i)] {
            let error = (f64::from(decoded) - f64::from(value)).abs();
            prop_assert!(error <= stated, "{value}: {error} > {stated}");
        }
    }
    Ok(())
}

fn at_most(decoded: f32, value: f32) -> bool {
    decoded <= value
}

fn at_least(decoded: f32, value: f32) -> bool {
    decoded >= value
}

/// A depth: any at all, a byte's or a half's own value, or a hair beside one.
fn depth() -> impl Strategy<Value = f32> {
    let own = prop_oneof![
        (0..=255_u8).prop_map(|k| f32::from(k) / 255.0),
        (0..=0x3C00_u16).prop_map(|bits| half::f16::from_bits(bits).to_f32()),
        (0..=0x3F80_0000_u32).prop_map(f32::from_bits),
        0.0..=1.0_f32,
        prop::sample::select(vec![0.0, -0.0, 1.0, f32::MIN_POSITIVE, f32::from_bits(1), 0.5]),
    ];
    (own, 0..3_usize).prop_map(|(x, hair): (f32, usize)| [x, x.next_up(), x.next_down()][hair].clamp(0.0, 1.0))
}

/// A ratio, from nothing to far beyond what is of use.
fn ratio() -> impl Strategy<Value = f32> {
    prop_oneof![depth(), 0.0..=64.0_f32, (0..=f32::MAX.to_bits()).prop_map(f32::from_bits)]
}

fn encodings() -> impl Strategy<Value = Encoding> {
    prop::sample::select(Encoding::ALL.to_vec())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 3000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn conservative_depths_are_never_deeper(
        values in prop::collection::vec(depth(), 1..60),
        squeeze in prop::sample::select(vec![1.0, 0.125, 1e-3, 1e-6]),
        offset in 0.0..=0.875_f32,
        encoding in encodings(),
    ) {
        // Narrow ranges far from 0 have their bias many times as large as their scale.
        let values: Vec<f32> = values.into_iter().map(|x| (x * squeeze + offset).min(1.0)).collect();
        let table = depths(&values, DepthMode::Conservative, encoding);
        check(&values, &table, at_most)?;
        prop_assert!(table.descriptor().range_min >= 0.0 && table.descriptor().range_max <= 1.0);
    }

    #[test]
    fn nearest_depths_are_the_nearest(values in prop::collection::vec(depth(), 1..60), encoding in encodings()) {
        check(&values, &depths(&values, DepthMode::Nearest, encoding), |_, _| true)?;
    }

    #[test]
    fn cones_are_never_deeper_nor_wider(
        texels in prop::collection::vec((depth(), ratio()), 1..60),
        encoding in encodings(),
    ) {
        let values: Vec<f32> = texels.into_iter().flat_map(|(depth, ratio)| [depth, ratio]).collect();
        let strict = ConeMapTable { grid: row(values.len() / 2), relief: RELIEF, values: &values };
        check(&values, &strict.encode(encoding).unwrap(), at_most)?;
        let relaxed = RelaxedConeMapTable { grid: row(values.len() / 2), relief: RELIEF, values: &values };
        prop_assert_eq!(decoded(&relaxed.encode(encoding).unwrap()), decoded(&strict.encode(encoding).unwrap()));
    }

    #[test]
    fn maxima_are_never_lower(
        values in prop::collection::vec(any::<f32>().prop_filter("finite", |x| x.is_finite()), 2..4),
        squeeze in prop::sample::select(vec![1.0, 1e-20, 1e-36]),
        offset in prop::sample::select(vec![0.0, 1000.0, -0.3]),
        encoding in encodings(),
    ) {
        let values: Vec<f32> = values.into_iter().map(|x| (x * squeeze + offset).clamp(f32::MIN, f32::MAX)).collect();
        let top = [values.iter().copied().fold(f32::MIN, f32::max)];
        let levels: [&[f32]; 2] = [&values, &top];
        match (MaximumMipTable { grid: row(values.len()), levels: &levels }).encode(encoding) {
            // Only what is as wide as f32 itself has no room to be rounded up.
            Err(EncodeError::TooWide { min, max, .. }) => prop_assert!(f64::from(max) - f64::from(min) > 3e38),
            table => check(&values, &table.unwrap(), at_least)?,
        }
    }
}

#[test]
fn a_bound_is_the_tightest_byte() {
    // Of the numbers k/255 the greatest that is not above, so less than a step is lost.
    let values: Vec<f32> = (0..=20_000_u16).map(|i| f32::from(i) / 20_000.0).collect();
    let table = depths(&values, DepthMode::Conservative, Encoding::U8);
    for (&value, decoded) in values.iter().zip(decoded(&table)) {
        assert!(decoded <= value && value < decoded + 1.000_001 / 255.0, "{decoded} of {value}");
    }
}

#[test]
fn a_constant_table_is_exact() {
    for encoding in [Encoding::F32, Encoding::F16, Encoding::U8] {
        let table = depths(&[0.3; 4], DepthMode::Conservative, encoding);
        assert_eq!((decoded(&table), table.descriptor().worst_case_error), (vec![0.3; 4], 0.0));
        let levels: [&[f32]; 2] = [&[7.3; 2], &[7.3]];
        let table = MaximumMipTable { grid: row(2), levels: &levels }.encode(encoding).unwrap();
        assert_eq!((decoded(&table), table.descriptor().worst_case_error), (vec![7.3; 2], 0.0));
    }
}
