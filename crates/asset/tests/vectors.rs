//! The published vectors: still written byte for byte, still read to the values they were made from.

use std::fs;
use std::path::PathBuf;

use barchan_asset::{
    Asset, DistanceView, HeightView, HorizonView, LengthUnit, Limits, MAX_ELEVATION, OpenError, SectionFault,
    SectionKind, Severity, Wrap, validate, vectors,
};

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../formats/vectors/v1")
}

/// A published file; a missing one fails.
fn published(name: &str) -> Vec<u8> {
    let path = folder().join(name).with_extension("barchan");
    fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The decoded values of the height section, row by row.
fn heights(file: &[u8]) -> Vec<f32> {
    let section = Asset::open(file).unwrap().section(SectionKind::HEIGHT).unwrap();
    let payload = section.payload(&Limits::default()).unwrap();
    let view = HeightView::new(section.texture().unwrap(), &payload).unwrap();
    (0..view.height()).flat_map(|row| view.table().row(0, row).collect::<Vec<_>>()).collect()
}

#[test]
fn the_writer_still_writes_every_published_byte() {
    for vector in vectors::all().unwrap() {
        let published = published(vector.name);
        // Another libzstd may compress otherwise: then the content is what must not have changed.
        let same_zstd = zstd_version() == 10507;
        if same_zstd || !vector.name.contains("zstd") {
            assert!(published == vector.bytes, "{} is not written as published", vector.name);
        } else {
            let identity = |bytes: &[u8]| Asset::open(bytes).unwrap().identity();
            assert_eq!(identity(&published), identity(&vector.bytes), "{}", vector.name);
        }
    }
}

fn zstd_version() -> u32 {
    zstd::zstd_safe::version_number()
}

#[test]
fn every_file_in_the_folder_is_listed() {
    let listed: Vec<PathBuf> =
        vectors::all().unwrap().iter().map(|v| folder().join(v.name).with_extension("barchan")).collect();
    for sub in [folder(), folder().join("refused")] {
        for file in fs::read_dir(sub).unwrap().map(|entry| entry.unwrap().path()).filter(|path| path.is_file()) {
            assert!(listed.contains(&file), "{} is not listed in src/vectors.rs", file.display());
        }
    }
}

#[test]
fn vectors_in_the_folder_itself_have_no_error() {
    for vector in vectors::all().unwrap().iter().filter(|vector| !vector.name.contains('/')) {
        let findings = validate(&published(vector.name), &Limits::default());
        let warnings: Vec<_> = findings.iter().map(|finding| (finding.id, finding.severity)).collect();
        let expected: &[_] = match vector.name {
            "unknown-ancillary" => &[("B0214", Severity::Warning)],
            "newer-minor" => &[("B0109", Severity::Warning), ("B0110", Severity::Warning)],
            _ => &[],
        };
        assert_eq!(warnings, expected, "{}", vector.name);
    }
}

#[test]
fn f32_heights_are_exact() {
    assert_eq!(heights(&published("height-f32-repeat")), vectors::HEIGHTS);
    assert_eq!(heights(&published("height-f32-stored-zstd-block")), vectors::HEIGHTS);
}

#[test]
fn f16_heights_decode_to_these_values() {
    // bias 1.5, scale 2.5; the halves nearest to −0.6, −0.2, 0.4 are not exact.
    let expected = [-0.000_244_140_63, 1.000_122_1, 2.499_755_9, -1.0, 0.25, 4.0];
    assert_eq!(heights(&published("height-f16-clamp")), expected);
    assert_eq!(heights(&published("newer-minor")), expected);
    assert_eq!(heights(&published("unknown-ancillary")), expected);
}

#[test]
fn u8_heights_decode_to_these_values() {
    // bias −1, scale 5; bytes 51, 51·2, 178, 0, 64, 255.
    assert_eq!(heights(&published("height-u8-repeat-clamp")), [0.0, 1.0, 2.490_196_2, -1.0, 0.254_902, 4.0]);
    assert_eq!(heights(&published("height-u8-constant")), [7.3; 6]);
}

#[test]
fn the_grid_is_read_as_it_was_written() {
    let file = published("height-u8-repeat-clamp");
    let section = Asset::open(&file).unwrap().section(SectionKind::HEIGHT).unwrap();
    let view = HeightView::new(section.texture().unwrap(), section.raw_payload().unwrap()).unwrap();
    assert_eq!((view.width(), view.height()), (3, 2));
    assert_eq!(view.spacing(), (0.5, 0.25));
    assert_eq!(view.wrap(), (Wrap::Repeat, Wrap::Clamp));
    assert_eq!(view.length_unit(), LengthUnit::Metre);
}

#[test]
fn directional_tables_decode_within_their_worst_case_error() {
    for name in ["horizon-distance-f16", "horizon-distance-u8-zstd"] {
        let file = published(name);
        let asset = Asset::open(&file).unwrap();
        let [horizon, distance] = [SectionKind::HORIZON, SectionKind::DISTANCE].map(|k| asset.section(k).unwrap());
        let payloads = [horizon, distance].map(|section| section.payload(&Limits::default()).unwrap());
        let horizon = HorizonView::new(horizon.texture().unwrap(), &payloads[0]).unwrap();
        let distance = DistanceView::new(distance.texture().unwrap(), &payloads[1]).unwrap();
        assert_eq!((horizon.directions(), horizon.radius()), (4, 8.0));
        assert_eq!(horizon.azimuth_radians(1), std::f64::consts::FRAC_PI_2);
        for (k, column, row) in (0..256).map(|i| (i / 64, i % 16, i / 16 % 4)) {
            let elevation = -0.5 + f64::from(k) / 4.0 + f64::from(column) / 16.0;
            let error = f64::from(horizon.elevation_radians(k, column, row)) - elevation;
            assert!(error.abs() <= horizon.descriptor().worst_case_error, "{name} {k} {column} {row}: {error}");
            let error = f64::from(distance.distance(k, column, row)) - (f64::from(k) + f64::from(row) / 4.0);
            assert!(error.abs() <= distance.descriptor().worst_case_error, "{name} {k} {column} {row}: {error}");
        }
        let provenance = asset.section(SectionKind::PROVENANCE).unwrap();
        assert_eq!(provenance.raw_payload(), Some(&br#"{"made_by":"barchan vectors"}"#[..]));
    }
}

#[test]
fn walls_keep_their_elevation() {
    let file = published("horizon-f32-extremes");
    let section = Asset::open(&file).unwrap().section(SectionKind::HORIZON).unwrap();
    let view = HorizonView::new(section.texture().unwrap(), section.raw_payload().unwrap()).unwrap();
    assert_eq!([0, 1, 2].map(|k| view.elevation_radians(k, 0, 0)), [MAX_ELEVATION, 0.0, -MAX_ELEVATION]);
}

#[test]
fn refused_vectors_are_refused_by_name() {
    let refusal = |name: &str| Asset::open(&published(name)).unwrap_err();
    assert_eq!(
        refusal("refused/unknown-critical"),
        OpenError::Section { index: 1, kind: SectionKind(*b"NOTE"), fault: SectionFault::UnknownCritical }
    );
    assert_eq!(refusal("refused/unknown-major"), OpenError::Major { found: 2 });
    assert_eq!(refusal("refused/required-feature"), OpenError::RequiredFeatures { unknown: 0x1_0000 });
    let damage = refusal("refused/newline-damage");
    assert!(damage.to_string().ends_with("newlines or 8-bit characters were altered in a transfer"), "{damage}");
}
