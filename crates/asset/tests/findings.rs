//! What version 2 of the descriptor may not say: every refusal by its number.

use barchan_asset::{
    Asset, Azimuths, DescriptorError, Limits, SectionKind, TextureDescriptor, validate,
    vectors::{self, reseal},
};

fn vector(name: &str) -> Vec<u8> {
    vectors::all().unwrap().into_iter().find(|vector| vector.name == name).unwrap().bytes
}

/// The findings, but for the identity, of a vector with bytes overwritten in one of its sections.
fn findings(name: &str, kind: SectionKind, patches: &[(usize, &[u8])]) -> Vec<&'static str> {
    let mut file = vector(name);
    let at = Asset::open(&file).unwrap().section(kind).unwrap().offset() as usize;
    for (offset, bytes) in patches {
        file[at + offset..at + offset + bytes.len()].copy_from_slice(bytes);
    }
    reseal(&mut file);
    let findings = validate(&file, &Limits::default());
    findings.into_iter().map(|finding| finding.id).filter(|&id| id != "B0111").collect()
}

const HORIZON: SectionKind = SectionKind::HORIZON;
const SWEPT: SectionKind = SectionKind::SWEPT_HORIZON;
const CURVATURE_MIN: usize = 136;
const CURVATURE_MAX: usize = 144;

#[test]
fn words_that_do_not_fit() {
    let word = |name, kind, at, value: u32| findings(name, kind, &[(at, &value.to_le_bytes())]);
    // Formats: another number of channels, and one that stands for nothing.
    assert_eq!(word("sky-f32", SectionKind::BENT_NORMAL, 0, 109), ["B0408"]);
    assert_eq!(word("sky-f32", SectionKind::SKY_VISIBILITY, 0, 98), ["B0403"]);
    // Transfers: a square of an elevation, a sine of a share, one that stands for nothing.
    assert_eq!(word("horizon-distance-compact", HORIZON, 128, 2), ["B0409"]);
    assert_eq!(word("sky-compact", SectionKind::SKY_VISIBILITY, 128, 1), ["B0409"]);
    assert_eq!(word("horizon-distance-compact", HORIZON, 128, 3), ["B0403"]);
    // Candidates: none of a swept table, no divisor, any of another table.
    assert_eq!(word("swept-horizon", SWEPT, 132, 0), ["B0411"]);
    assert_eq!(word("swept-horizon", SWEPT, 132, 4), ["B0411"]);
    assert_eq!(word("horizon-arc", HORIZON, 132, 1), ["B0411"]);
    // Semantic and unit.
    assert_eq!(word("sky-f32", SectionKind::SKY_VISIBILITY, 20, 9), ["B0403"]);
    assert_eq!(word("sky-f32", SectionKind::SKY_VISIBILITY, 24, 1), ["B0403"]);
    // Layers of what has no direction.
    assert_eq!(word("sky-f32", SectionKind::SKY_VISIBILITY, 12, 2), ["B0404"]);
}

#[test]
fn real_numbers_that_do_not_fit() {
    let real = |name, kind, at, value: f64| findings(name, kind, &[(at, &value.to_le_bytes())]);
    for (at, value) in [(104, 7.0), (104, f64::NAN), (112, 0.0), (112, -0.5), (112, 3.2), (112, f64::INFINITY)] {
        assert_eq!(real("horizon-arc", HORIZON, at, value), ["B0410"], "{at} {value}");
    }
    for (at, value) in [(CURVATURE_MIN, f64::NAN), (CURVATURE_MIN, 0.5), (CURVATURE_MAX, f64::INFINITY)] {
        assert_eq!(real("swept-horizon", SWEPT, at, value), ["B0405"], "{at} {value}");
    }
    assert_eq!(real("horizon-arc", HORIZON, CURVATURE_MAX, 1.0), ["B0405"]);
    assert_eq!(real("sky-f32", SectionKind::BENT_NORMAL, 104, 1.0), ["B0405"]);
    assert_eq!(real("sky-f32", SectionKind::BENT_NORMAL, 120, 0.0), ["B0405"]);
    assert_eq!(real("sky-f32", SectionKind::SKY_VISIBILITY, 72, 1.5), ["B0405"]);
}

#[test]
fn reserved_bytes_move_with_the_version() {
    assert_eq!(findings("horizon-arc", HORIZON, &[(152, &[1])]), ["B0402"]);
    assert_eq!(findings("horizon-arc", HORIZON, &[(255, &[1])]), ["B0402"]);
    assert_eq!(findings("horizon-f32-extremes", HORIZON, &[(128, &[1])]), ["B0402"]);
}

#[test]
fn version_1_keeps_to_what_it_could_say() {
    let word = |at, value: u32| findings("horizon-f32-extremes", HORIZON, &[(at, &value.to_le_bytes())]);
    assert_eq!(word(0, 16), ["B0403"]);
    assert_eq!(word(20, 4), ["B0403"]);
    let arc = findings("horizon-f32-extremes", HORIZON, &[(104, &0.5_f64.to_le_bytes())]);
    assert_eq!(arc, ["B0405"]);
}

#[test]
fn stored_numbers_outside_the_domain() {
    // Scale and bias such that byte 255 is a sine above 1: still within the stated range, since it counts as 1.
    let scale = 2.0_f64.to_le_bytes();
    let wall = f64::from(barchan_asset::MAX_ELEVATION).to_le_bytes();
    let patches: [(usize, &[u8]); 2] = [(48, &scale), (72, &wall)];
    assert_eq!(findings("horizon-distance-compact", HORIZON, &patches), ["B0505"]);
    let bias = (-1.0_f64).to_le_bytes();
    assert_eq!(findings("horizon-distance-compact", SectionKind::DISTANCE, &[(56, &bias)]), ["B0505"]);
}

#[test]
fn directions_have_unit_length() {
    let payload = 256;
    let long = [0.9_f32.to_le_bytes(), 0.9_f32.to_le_bytes()].concat();
    assert_eq!(findings("sky-f32", SectionKind::BENT_NORMAL, &[(payload, &long)]), ["B0506"]);
    let none = [0_u8; 12];
    assert_eq!(findings("sky-f32", SectionKind::APERTURE_CONE, &[(payload, &none)]), ["B0506"]);
}

#[test]
fn a_sine_table_of_another_arcsine_is_valid() {
    let mut file = vector("horizon-distance-compact");
    let section = Asset::open(&file).unwrap().section(HORIZON).unwrap();
    let (at, max) = (section.offset() as usize + 72, section.texture().unwrap().range_max as f32);
    for (other, valid) in [(max.next_up(), true), (max.next_down(), true), (max + 1e-5, false)] {
        file[at..at + 8].copy_from_slice(&f64::from(other).to_le_bytes());
        reseal(&mut file);
        let found = validate(&file, &Limits::default()).iter().any(|finding| finding.id != "B0111");
        assert_eq!(found, !valid, "{other}");
    }
}

#[test]
fn swept_tables_lie_as_their_companions_do() {
    let spacing = 0.75_f64.to_le_bytes();
    assert_eq!(findings("swept-horizon", HORIZON, &[(88, &spacing)]), ["B0701"]);
    assert_eq!(findings("swept-horizon", SWEPT, &[(88, &spacing)]), ["B0701", "B0701"]);
    let curvature = 0.125_f64.to_le_bytes();
    assert_eq!(findings("swept-horizon", SWEPT, &[(CURVATURE_MAX, &curvature)]), ["B0701"]);
}

#[test]
fn a_swept_table_alone_is_a_warning() {
    let file = vector("swept-horizon");
    let asset = Asset::open(&file).unwrap();
    let mut writer = barchan_asset::AssetWriter::new();
    let section = asset.section(SWEPT).unwrap();
    let table = section.texture().unwrap();
    let table = barchan_asset::TextureTable::new(table, section.raw_payload().unwrap().to_vec()).unwrap();
    writer.add_table(table, barchan_asset::Codec::Raw).unwrap();
    let alone = writer.finish().unwrap();
    let ids: Vec<_> = validate(&alone, &Limits::default()).iter().map(|finding| finding.id).collect();
    assert_eq!(ids, ["B0702"]);
}

#[test]
fn a_message_names_what_is_accepted() {
    let file = vector("horizon-arc");
    let section = Asset::open(&file).unwrap().section(HORIZON).unwrap();
    let descriptor = section.texture().unwrap();
    let message = |change: &dyn Fn(&mut TextureDescriptor)| {
        let mut changed = descriptor;
        change(&mut changed);
        changed.check().unwrap_err().to_string()
    };
    assert_eq!(
        message(&|d| d.azimuth_step = 4.0),
        "3 azimuths from -0.7853981633974483 by 4; accepted: from 0 by 2π / 3, or an arc that starts within ±2π and is \
         shorter than 2π"
    );
    assert_eq!(
        message(&|d| d.candidates = 2),
        "candidates is 2 of 3 layers; a divisor of the layers is accepted for a swept table, else 0"
    );
    let version = TextureDescriptor::parse(&descriptor.to_bytes(), 4).unwrap_err();
    assert_eq!(version, DescriptorError::Version { found: 4, newest: 3 });
    assert_eq!(
        descriptor.azimuths().unwrap(),
        Azimuths::arc(-0.25 * std::f64::consts::PI, 0.25 * std::f64::consts::PI, 3)
    );
}
