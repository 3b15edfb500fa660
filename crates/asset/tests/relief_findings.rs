//! What version 3 of the descriptor may not say, and relief tables that do not lie over their heights: every refusal by
//! its number.

use barchan_asset::{
    Asset, AssetWriter, Codec, DescriptorError, Limits, SectionKind, TextureDescriptor, TextureTable, validate,
    vectors::{self, reseal},
};

const HEMISPHERE: SectionKind = SectionKind::HEMISPHERE;
const CONES: SectionKind = SectionKind::CONE_MAP;
const MAXIMA: SectionKind = SectionKind::MAXIMUM_MIP;
const HEIGHT: SectionKind = SectionKind::HEIGHT;
const PAYLOAD: usize = 256;

fn vector(name: &str) -> Vec<u8> {
    vectors::all().unwrap().into_iter().find(|vector| vector.name == name).unwrap().bytes
}

/// The findings, but for the identity, of a vector with bytes overwritten in one of its sections.
fn findings(name: &str, kind: SectionKind, at: usize, bytes: &[u8]) -> Vec<&'static str> {
    let mut file = vector(name);
    let at = Asset::open(&file).unwrap().section(kind).unwrap().offset() as usize + at;
    file[at..at + bytes.len()].copy_from_slice(bytes);
    reseal(&mut file);
    let findings = validate(&file, &Limits::default());
    findings.into_iter().map(|finding| finding.id).filter(|&id| id != "B0111").collect()
}

fn word(kind: SectionKind, at: usize, value: u32) -> Vec<&'static str> {
    findings("relief-f32", kind, at, &value.to_le_bytes())
}

fn real(kind: SectionKind, at: usize, value: f64) -> Vec<&'static str> {
    findings("relief-f32", kind, at, &value.to_le_bytes())
}

#[test]
fn words_that_do_not_fit() {
    // Rings: none, too many, no divisor of the layers, any of another table.
    assert_eq!(word(HEMISPHERE, 152, 0), ["B0404"]);
    assert_eq!(word(HEMISPHERE, 152, 2049), ["B0404"]);
    assert_eq!(word(HEMISPHERE, 152, 4), ["B0414"]);
    assert_eq!(word(CONES, 152, 1), ["B0404"]);
    // Ring spacing and depth mode: none, unknown, any of another table.
    for at in [156, 160] {
        assert_eq!(word(HEMISPHERE, at, 0), ["B0403"]);
        assert_eq!(word(HEMISPHERE, at, 3), ["B0403"]);
        assert_eq!(word(MAXIMA, at, 1), ["B0403"]);
    }
    // A filter that would mix what is true of one texel, and one that is not for heights.
    assert_eq!(word(HEMISPHERE, 40, 1), ["B0403"]);
    assert_eq!(word(MAXIMA, 40, 1), ["B0403"]);
    assert_eq!(word(CONES, 40, 2), ["B0403"]);
    assert_eq!(word(HEIGHT, 40, 2), ["B0403"]);
    // A reducer that does not make these levels.
    assert_eq!(word(MAXIMA, 44, 2), ["B0403"]);
    // Candidates, transfers, units.
    assert_eq!(word(HEMISPHERE, 132, 2), ["B0411"]);
    assert_eq!(word(HEMISPHERE, 128, 2), ["B0409"]);
    assert_eq!(word(CONES, 128, 1), ["B0409"]);
    assert_eq!(word(MAXIMA, 24, 7), ["B0403"]);
    assert_eq!(word(HEMISPHERE, 24, 3), ["B0403"]);
}

#[test]
fn mip_levels_are_one_or_all() {
    assert_eq!(word(MAXIMA, 16, 1), ["B0404"]);
    assert_eq!(word(MAXIMA, 16, 4), ["B0404"]);
    assert_eq!(word(MAXIMA, 12, 2), ["B0404"]);
    for kind in [HEIGHT, HEMISPHERE, CONES, SectionKind::RELAXED_CONE_MAP] {
        assert_eq!(word(kind, 16, 2), ["B0404"]);
    }
}

#[test]
fn real_numbers_that_do_not_fit() {
    for max_polar in [0.0, -0.5, std::f64::consts::FRAC_PI_2, f64::NAN] {
        assert_eq!(real(HEMISPHERE, 168, max_polar), ["B0405"], "{max_polar}");
    }
    for (kind, at, value) in [
        (CONES, 168, 1.0),
        (HEMISPHERE, 176, f64::INFINITY),
        (CONES, 184, -1.0),
        (CONES, 184, f64::NAN),
        (MAXIMA, 176, 4.0),
        (MAXIMA, 184, 5.0),
        (HEMISPHERE, 120, 1.0),
        (HEMISPHERE, 72, 1.5),
        (CONES, 64, -0.5),
        (CONES, 112, 1.0),
    ] {
        assert_eq!(real(kind, at, value), ["B0405"], "{kind} {at} {value}");
    }
    for (at, value) in [(104, 7.0), (112, 4.0), (112, -1.0)] {
        assert_eq!(real(HEMISPHERE, at, value), ["B0410"], "{at} {value}");
    }
    // One azimuth that is no circle.
    let arc = findings("hemisphere-arc", HEMISPHERE, 152, &4_u32.to_le_bytes());
    assert_eq!(arc, ["B0410"]);
}

#[test]
fn reserved_bytes_lie_between_and_behind() {
    for at in [164, 167, 192, 255] {
        assert_eq!(findings("relief-f32", CONES, at, &[1]), ["B0402"], "{at}");
    }
}

#[test]
fn each_version_keeps_to_its_own_tables() {
    let file = vector("relief-f32");
    let asset = Asset::open(&file).unwrap();
    let bytes = |kind| asset.section(kind).unwrap().descriptor_bytes();
    let semantic = |kind, version| match TextureDescriptor::parse(bytes(kind), version).unwrap_err() {
        DescriptorError::Enumeration { field, found, .. } => (field, found),
        other => panic!("{other}"),
    };
    assert_eq!(semantic(HEIGHT, 3), ("semantic", 1));
    assert_eq!(semantic(MAXIMA, 2), ("semantic", 12));
    assert!(TextureDescriptor::parse(bytes(CONES), 2).is_err());
    assert!(TextureDescriptor::parse(bytes(CONES), 4).is_err());
}

#[test]
fn depths_of_cones_are_depths() {
    // Range up to 2, so that nothing but the depth is wrong.
    assert_eq!(findings("relief-f32", CONES, PAYLOAD, &1.5_f32.to_le_bytes()), ["B0512"]);
    assert_eq!(findings("relief-f32", CONES, PAYLOAD, &f32::NAN.to_le_bytes()), ["B0501"]);
    // A negative root of a ratio.
    assert_eq!(findings("relief-compact", CONES, 56, &(-1.0_f64).to_le_bytes()), ["B0505"]);
}

#[test]
fn a_maximum_is_not_less_than_what_it_stands_for() {
    let one_texel = PAYLOAD + 512;
    assert_eq!(findings("relief-f32", MAXIMA, one_texel, &3.5_f32.to_le_bytes()), ["B0513"]);
    // The second column of level 1 stands for the third to the fifth of level 0.
    assert_eq!(findings("relief-f32", MAXIMA, PAYLOAD + 256 + 4, &1.0_f32.to_le_bytes()), ["B0513"]);
    assert_eq!(findings("relief-f32", MAXIMA, PAYLOAD + 60, &[1]), ["B0504"]);
}

#[test]
fn relief_tables_lie_over_the_heights() {
    for kind in [HEMISPHERE, CONES, SectionKind::RELAXED_CONE_MAP, MAXIMA] {
        assert_eq!(real(kind, 88, 0.625), ["B0703"], "{kind}");
        assert_eq!(word(kind, 36, 1), ["B0703"], "{kind}");
    }
    for (at, value) in [(176, 4.001), (184, 5.001)] {
        assert_eq!(real(HEMISPHERE, at, value), ["B0703"]);
        assert_eq!(real(CONES, at, value), ["B0703"]);
    }
    // The last place of f64 may be rounded in another way.
    assert_eq!(real(CONES, 184, 5.0_f64.next_up()), [""; 0]);
}

#[test]
fn relief_tables_alone_are_a_warning_each() {
    let file = vector("relief-f32");
    let asset = Asset::open(&file).unwrap();
    let mut writer = AssetWriter::new();
    for section in asset.sections().filter(|section| section.kind() != HEIGHT) {
        let (descriptor, payload) = (section.texture().unwrap(), section.raw_payload().unwrap().to_vec());
        writer.add_table(TextureTable::new(descriptor, payload).unwrap(), Codec::Raw).unwrap();
    }
    let alone = writer.finish().unwrap();
    let ids: Vec<_> = validate(&alone, &Limits::default()).iter().map(|finding| finding.id).collect();
    assert_eq!(ids, ["B0704"; 4]);
}
