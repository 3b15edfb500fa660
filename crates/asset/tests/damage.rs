//! Damage: every flipped bit and every missing or added byte of a small file is noticed.

use barchan_asset::{
    Asset, AssetWriter, Azimuths, BentNormalTable, Codec, ConeMapTable, CurvatureSweep, CurvatureTable, DepthMode,
    Encoding, HeightTable, HemisphereDirections, HemisphereTable, HorizonTable, LengthUnit, Limits, MaximumMipTable,
    OpenError, ReliefRange, RingSpacing, Severity, SurfaceForms, SweptHorizonTable, TableGrid, VertexFlags, Wrap,
    validate,
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

/// All that version 2 of the descriptor brought, in one file.
fn small_file_of_version_2() -> Vec<u8> {
    let (length_unit, wrap) = (LengthUnit::Metre, Wrap::Clamp);
    let grid =
        TableGrid { width: 2, height: 1, spacing_u: 1.0, spacing_v: 1.0, length_unit, wrap_u: wrap, wrap_v: wrap };
    let (azimuths, radius) = (Azimuths::arc(5.0, 7.0, 2), 3.0);
    let sweep = CurvatureSweep { candidates: 1, curvature_min: -0.25, curvature_max: 0.5 };
    let values = [0.1, 0.2, -0.3, 0.7];
    let mut writer = AssetWriter::new();
    for table in [
        HorizonTable { grid, azimuths, radius, values: &values }.encode(Encoding::Compact),
        SweptHorizonTable { grid, azimuths, radius, sweep, values: &values }.encode(Encoding::Compact),
        BentNormalTable { grid, radius, values: &values }.encode(Encoding::Compact),
    ] {
        writer.add_table(table.unwrap(), Codec::Raw).unwrap();
    }
    writer.finish().unwrap()
}

/// Columns with padding between them and behind every vector.
fn small_file_of_curvature() -> Vec<u8> {
    let frame = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let forms = SurfaceForms { first: [2.0, 0.5, 1.0], second: [0.25, 0.0, -3.0] };
    let table = CurvatureTable {
        length_unit: LengthUnit::Metre,
        principal: &[[0.5, -3.0], [0.0, 0.0]],
        directions: Some(&[frame; 2]),
        forms: Some(&[forms; 2]),
        uv_directions: Some(&[[[1.0, 0.0], [0.5, 2.0]]; 2]),
        flags: &[VertexFlags::NONE, VertexFlags::ISOLATED],
    };
    let mut writer = AssetWriter::new();
    writer.add_curvature(table.encode(Encoding::Compact).unwrap(), Codec::Raw).unwrap();
    writer.finish().unwrap()
}

/// All that version 3 of the descriptor brought, in one file.
fn small_file_of_version_3() -> Vec<u8> {
    let (length_unit, wrap) = (LengthUnit::Metre, Wrap::Clamp);
    let grid =
        TableGrid { width: 2, height: 1, spacing_u: 1.0, spacing_v: 1.0, length_unit, wrap_u: wrap, wrap_v: wrap };
    let relief = ReliefRange { top: 2.0, thickness: 1.0 };
    let (azimuths, spacing) = (Azimuths::full_circle(2), RingSpacing::EqualAngles);
    let directions = HemisphereDirections { rings: 1, azimuths, spacing, max_polar_radians: 1.0 };
    let (mode, values) = (DepthMode::Conservative, [0.0, 1.0, 0.25, 0.75]);
    let mut writer = AssetWriter::new();
    for table in [
        HeightTable { grid, values: &[1.0, 2.0] }.encode(Encoding::F32),
        HemisphereTable { grid, directions, mode, relief, values: &values }.encode(Encoding::Compact),
        ConeMapTable { grid, relief, values: &values }.encode(Encoding::Compact),
        MaximumMipTable { grid, levels: &[&[1.5, 2.0], &[2.0]] }.encode(Encoding::Compact),
    ] {
        writer.add_table(table.unwrap(), Codec::Raw).unwrap();
    }
    writer.finish().unwrap()
}

/// One of every sort.
fn small_files() -> [Vec<u8>; 4] {
    [small_file(), small_file_of_version_2(), small_file_of_version_3(), small_file_of_curvature()]
}

fn has_error(file: &[u8]) -> bool {
    validate(file, &Limits::default()).iter().any(|finding| finding.severity == Severity::Error)
}

fn check_every_flipped_bit(mut file: Vec<u8>) {
    assert_eq!(validate(&file, &Limits::default()), []);
    for bit in 0..8 * file.len() {
        file[bit / 8] ^= 1 << (bit % 8);
        assert!(has_error(&file), "bit {} of byte {} flipped without an error", bit % 8, bit / 8);
        file[bit / 8] ^= 1 << (bit % 8);
    }
}

#[test]
fn every_flipped_bit_is_an_error() {
    check_every_flipped_bit(small_file());
}

#[test]
fn every_flipped_bit_of_version_2_is_an_error() {
    check_every_flipped_bit(small_file_of_version_2());
}

#[test]
fn every_flipped_bit_of_version_3_is_an_error() {
    check_every_flipped_bit(small_file_of_version_3());
}

#[test]
fn every_flipped_bit_of_curvature_is_an_error() {
    check_every_flipped_bit(small_file_of_curvature());
}

#[test]
fn every_truncation_is_refused_at_open() {
    for file in small_files() {
        for length in 0..file.len() {
            let error = Asset::open(&file[..length]).unwrap_err();
            let expected = matches!(error, OpenError::TooShort { .. } | OpenError::FileSize { .. });
            assert!(expected, "{length}: {error}");
        }
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
