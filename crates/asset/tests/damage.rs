//! Damage: every flipped bit and every missing or added byte of a small file is noticed.

use barchan_asset::{
    Asset, AssetWriter, Azimuths, Codec, Encoding, HorizonTable, LengthUnit, Limits, OpenError, Severity, TableGrid,
    Wrap, validate,
};

/// Two sections, padding of every sort: behind the descriptor, between layers, between sections.
fn small_file() -> Vec<u8> {
    let length_unit = LengthUnit::Metre;
    let grid = TableGrid {
        width: 2,
        height: 2,
        spacing_u: 1.0,
        spacing_v: 1.0,
        length_unit,
        wrap_u: Wrap::Clamp,
        wrap_v: Wrap::Clamp,
    };
    let values = [0.1, 0.2, 0.3, 0.4, -0.1, -0.2, 1.0, 1.1];
    let mut writer = AssetWriter::new();
    let table = HorizonTable { grid, azimuths: Azimuths::full_circle(2), radius: 3.0, values: &values };
    writer.add_table(table.encode(Encoding::F16).unwrap(), Codec::Raw).unwrap().provenance("{}").unwrap();
    writer.finish().unwrap()
}

fn has_error(file: &[u8]) -> bool {
    validate(file, &Limits::default()).iter().any(|finding| finding.severity == Severity::Error)
}

#[test]
fn every_flipped_bit_is_an_error() {
    let mut file = small_file();
    assert!(!has_error(&file));
    for bit in 0..8 * file.len() {
        file[bit / 8] ^= 1 << (bit % 8);
        assert!(has_error(&file), "bit {} of byte {} flipped without an error", bit % 8, bit / 8);
        file[bit / 8] ^= 1 << (bit % 8);
    }
}

#[test]
fn every_truncation_is_refused_at_open() {
    let file = small_file();
    for length in 0..file.len() {
        let error = Asset::open(&file[..length]).unwrap_err();
        let expected = matches!(error, OpenError::TooShort { .. } | OpenError::FileSize { .. });
        assert!(expected, "{length}: {error}");
    }
}

#[test]
fn appended_bytes_are_refused_at_open() {
    let mut file = small_file();
    let stated = file.len() as u64;
    for _ in 0..300 {
        file.push(0);
        let actual = file.len() as u64;
        assert_eq!(Asset::open(&file).unwrap_err(), OpenError::FileSize { stated, actual });
    }
}
