//! What a curvature table may not say: every refusal by its number.

use barchan_asset::{
    Asset, CurvatureColumn, CurvatureDescriptor, CurvatureError, Limits, SectionKind, validate,
    vectors::{self, reseal},
};

fn vector(name: &str) -> Vec<u8> {
    vectors::all().unwrap().into_iter().find(|vector| vector.name == name).unwrap().bytes
}

/// The findings, but for the identity, of a vector with bytes of its curvature section overwritten.
fn findings(name: &str, patches: &[(usize, &[u8])]) -> Vec<&'static str> {
    let mut file = vector(name);
    let at = Asset::open(&file).unwrap().section(SectionKind::CURVATURE).unwrap().offset() as usize;
    for (offset, bytes) in patches {
        file[at + offset..at + offset + bytes.len()].copy_from_slice(bytes);
    }
    reseal(&mut file);
    let findings = validate(&file, &Limits::default());
    findings.into_iter().map(|finding| finding.id).filter(|&id| id != "B0111").collect()
}

/// Where a field of a column's record lies: 0 column, 4 vk_format, 8 scale, 12 and 16 range, 20 error.
fn field(column: CurvatureColumn, at: usize) -> usize {
    16 + 24 * (column.number() as usize - 1) + at
}

/// Where the numbers of a vertex lie: behind the padded descriptor, five vertices to a column.
fn numbers(column: CurvatureColumn, stride: usize, vertex: usize) -> usize {
    256 + 256 * (column.number() as usize - 1) + stride * vertex
}

fn floats<const N: usize>(numbers: [f32; N]) -> Vec<u8> {
    numbers.iter().flat_map(|number| number.to_le_bytes()).collect()
}

use CurvatureColumn::{Direction1, Direction2, FirstForm, Flags, Principal, SecondForm, UvDirections};

#[test]
fn words_that_do_not_fit() {
    let word = |at, value: u32| findings("curvature-f32", &[(at, &value.to_le_bytes())]);
    assert_eq!(word(0, 0), ["B0404"]);
    assert_eq!(word(0, 6), ["B0407"]);
    assert_eq!(word(0, u32::MAX), ["B0407"]);
    assert_eq!(word(4, 1), ["B0403"]);
    assert_eq!(word(8, 0), ["B0404"]);
    assert_eq!(word(8, 8), ["B0404"]);
    assert_eq!(word(8, 6), ["B0412"]);
    assert_eq!(word(12, 1), ["B0402"]);
    assert_eq!(word(field(Principal, 0), 8), ["B0403"]);
    // Formats: none, one of another number of components, that of flags.
    for format in [0, 106, 98] {
        assert_eq!(word(field(Principal, 4), format), ["B0403"], "{format}");
    }
    assert_eq!(word(field(Flags, 4), 103), ["B0403"]);
    // A legal format of other bytes.
    assert_eq!(
        findings("curvature-principal", &[(field(Principal, 4), &[103]), (field(Principal, 8), &floats([1.0]))]),
        ["B0407"]
    );
}

#[test]
fn columns_come_once_in_order_and_with_their_companions() {
    let records = |numbers: &[u32]| {
        let mut descriptor = vec![0; 16];
        descriptor[0] = 1;
        descriptor[4] = 3;
        descriptor[8] = numbers.len() as u8;
        for &number in numbers {
            let column = CurvatureColumn::from_number(number).unwrap();
            descriptor.extend(number.to_le_bytes());
            descriptor.extend(column.formats()[0].number().to_le_bytes());
            descriptor.extend(floats([1.0, 0.0, 0.0, 0.0]));
        }
        CurvatureDescriptor::parse(&descriptor).map(|_| ()).map_err(|error| (error.id(), error.to_string()))
    };
    let refused = |sentence: &str| Err(("B0413", sentence.to_owned()));
    assert_eq!(records(&[1]), Ok(()));
    assert_eq!(records(&[1, 4, 5]), Ok(()));
    assert_eq!(records(&[1, 2, 3, 7]), Ok(()));
    assert_eq!(records(&[2, 3]), refused("there is no principal, which every table has"));
    assert_eq!(records(&[1, 2]), refused("direction_1 is there without direction_2"));
    assert_eq!(records(&[1, 5]), refused("second_form is there without first_form"));
    assert_eq!(
        records(&[1, 1]),
        refused("principal comes twice or too late; columns are accepted once each, by number")
    );
    assert_eq!(records(&[1, 7, 6]).unwrap_err().0, "B0413");
}

#[test]
fn a_descriptor_of_any_other_length_is_refused() {
    let file = vector("curvature-f16");
    let whole = Asset::open(&file).unwrap().section(SectionKind::CURVATURE).unwrap().descriptor_bytes();
    assert!(CurvatureDescriptor::parse(whole).is_ok());
    for length in 0..whole.len() {
        let error = CurvatureDescriptor::parse(&whole[..length]).unwrap_err();
        assert!(matches!(error, CurvatureError::Length { .. }), "{length}: {error}");
    }
    let long = [whole, &[0]].concat();
    assert_eq!(CurvatureDescriptor::parse(&long), Err(CurvatureError::Length { found: 185, expected: 184 }));
}

#[test]
fn real_numbers_that_do_not_fit() {
    let real = |name, column, at, value: f32| findings(name, &[(field(column, at), &value.to_le_bytes())]);
    // A scale is a power of two for halves, and 1 for whatever else.
    for scale in [0.0, -0.5, 0.75, f32::NAN, f32::INFINITY, 1e-40, 2.0_f32.powi(-103), 2.0_f32.powi(97)] {
        assert_eq!(real("curvature-f16", Principal, 8, scale), ["B0405"], "{scale}");
    }
    assert_eq!(real("curvature-f32", Principal, 8, 2.0), ["B0405"]);
    assert_eq!(real("curvature-f16", Flags, 8, 2.0), ["B0405"]);
    for (at, value) in
        [(12, f32::NAN), (12, 3.0), (12, -2e30), (16, f32::INFINITY), (16, 2e30), (20, -1.0), (20, f32::NAN)]
    {
        assert_eq!(real("curvature-f32", Principal, at, value), ["B0405"], "{at} {value}");
    }
    for at in [12, 16, 20] {
        assert_eq!(real("curvature-f32", Flags, at, 1.0), ["B0405"], "{at}");
    }
}

#[test]
fn numbers_are_finite_and_span_the_stated_range() {
    let nan = floats([f32::NAN]);
    for (column, stride) in [(Principal, 8), (Direction2, 12), (SecondForm, 12), (UvDirections, 16)] {
        assert_eq!(findings("curvature-f32", &[(numbers(column, stride, 3), &nan)]), ["B0501"], "{column:?}");
    }
    assert_eq!(findings("curvature-f16", &[(numbers(FirstForm, 8, 0), &[0x00, 0x7C])]), ["B0501"]);
    assert_eq!(findings("curvature-f32", &[(numbers(Principal, 8, 0), &floats([9.0]))]), ["B0502"]);
    assert_eq!(findings("curvature-f32", &[(field(Principal, 16), &floats([3.0]))]), ["B0503"]);
    assert_eq!(findings("curvature-f16", &[(field(UvDirections, 12), &floats([-3.0]))]), ["B0503"]);
}

#[test]
fn padding_is_zero() {
    assert_eq!(findings("curvature-f32", &[(numbers(Principal, 8, 5), &[1])]), ["B0504"]);
    assert_eq!(findings("curvature-f16", &[(numbers(UvDirections, 8, 5), &[1])]), ["B0504"]);
    // The fourth half of a vector.
    assert_eq!(findings("curvature-f16", &[(numbers(Direction1, 8, 2) + 6, &[1])]), ["B0504"]);
}

#[test]
fn the_first_curvature_is_not_below_the_second() {
    assert_eq!(findings("curvature-f32", &[(numbers(Principal, 8, 1), &floats([0.25, 1.0]))]), ["B0507"]);
}

#[test]
fn directions_are_a_frame() {
    let vertex =
        |column, numbers_at: [f32; 3]| findings("curvature-f32", &[(numbers(column, 12, 0), &floats(numbers_at))]);
    assert_eq!(vertex(Direction1, [1.0, 0.002, 0.0]), ["B0506"]);
    assert_eq!(vertex(Direction1, [0.0; 3]), ["B0506"]);
    assert_eq!(vertex(Direction2, [0.6, 0.8, 0.0]), ["B0508"]);
    // A half is as near to a unit vector as its error says, and no nearer is asked for; but not farther.
    assert_eq!(findings("curvature-f16", &[(numbers(Direction1, 8, 0), &[0xFF, 0x73])]), [""; 0]);
    assert_eq!(findings("curvature-f16", &[(numbers(Direction1, 8, 0), &[0x00, 0x70])]), ["B0506"]);
}

#[test]
fn a_first_form_measures_every_direction() {
    let form = |first: [f32; 3]| findings("curvature-f32", &[(numbers(FirstForm, 12, 1), &floats(first))]);
    assert_eq!(form([1.0, 1.0, 2.0]), [""; 0]);
    assert_eq!(form([1.0, 1.0, 1.0]), ["B0509"]);
    assert_eq!(form([0.0, 0.0, 2.0]), ["B0509"]);
}

#[test]
fn a_remark_stands_for_something() {
    assert_eq!(findings("curvature-f32", &[(numbers(Flags, 4, 2), &[0x80])]), ["B0510"]);
    assert_eq!(findings("curvature-f32", &[(numbers(Flags, 4, 2) + 3, &[0x80])]), ["B0510"]);
    for unknown in [2, 4] {
        assert_eq!(findings("curvature-f32", &[(numbers(Flags, 4, 0), &[unknown])]), ["B0511"]);
    }
}

#[test]
fn a_later_version_is_passed_over_where_it_may_be() {
    let mut file = vector("curvature-principal");
    // The first row of the section table: not critical, version 2.
    (file[128 + 4], file[128 + 8]) = (0, 2);
    reseal(&mut file);
    let ids: Vec<_> = validate(&file, &Limits::default()).iter().map(|finding| finding.id).collect();
    assert_eq!(ids, ["B0215", "B0111"]);
    let error = Asset::open(&file).unwrap().section(SectionKind::CURVATURE).unwrap().curvature().unwrap_err();
    assert_eq!(error.to_string(), "section version 2 is not supported; this reader reads 1");
    // As critical as it was written, it is refused.
    file[128 + 4] = 1;
    reseal(&mut file);
    let ids: Vec<_> = validate(&file, &Limits::default()).iter().map(|finding| finding.id).collect();
    assert_eq!(ids, ["B0205"]);
}
