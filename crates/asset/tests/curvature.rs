//! Curvature tables: what goes in comes out, exactly or within what the descriptor says; what is no curvature is refused.

use barchan_asset::{
    Asset, AssetWriter, Codec, ColumnLayout, CurvatureColumn, CurvatureDescriptor, CurvatureError, CurvatureTable,
    CurvatureView, EncodedCurvature, Encoding, LengthUnit, Limits, SectionKind, SurfaceForms, VertexFlags, validate,
};
use proptest::prelude::*;

/// Five vertices of everything.
struct Mesh {
    principal: Vec<[f32; 2]>,
    directions: Vec<[[f32; 3]; 2]>,
    forms: Vec<SurfaceForms>,
    uv_directions: Vec<[[f32; 2]; 2]>,
    flags: Vec<VertexFlags>,
}

impl Mesh {
    fn new() -> Self {
        let frame = [[0.6, 0.8, 0.0], [-0.8, 0.6, 0.0]];
        let forms = |k: f32| SurfaceForms { first: [4.0 + k, 0.5 * k, 9.0], second: [-0.1 * k, 0.01, 1.5] };
        Self {
            principal: (0..5).map(|k| [k as f32 / 3.0, -0.001 * k as f32]).collect(),
            directions: vec![frame; 5],
            forms: (0..5).map(|k| forms(k as f32)).collect(),
            uv_directions: (0..5).map(|k| [[0.1, k as f32], [-7.0, 1e-4]]).collect(),
            flags: (0..5).map(|k| VertexFlags(k % 2 * 8)).collect(),
        }
    }

    fn table(&self) -> CurvatureTable<'_> {
        CurvatureTable {
            length_unit: LengthUnit::Metre,
            principal: &self.principal,
            directions: Some(&self.directions),
            forms: Some(&self.forms),
            uv_directions: Some(&self.uv_directions),
            flags: &self.flags,
        }
    }
}

/// A table without anything but principal curvature.
fn bare(principal: &[[f32; 2]]) -> CurvatureTable<'_> {
    let length_unit = LengthUnit::SceneUnit;
    CurvatureTable { length_unit, principal, directions: None, forms: None, uv_directions: None, flags: &[] }
}

fn file(table: EncodedCurvature, codec: Codec) -> Vec<u8> {
    let mut writer = AssetWriter::new();
    writer.add_curvature(table, codec).unwrap();
    writer.finish().unwrap()
}

#[test]
fn floats_come_back_to_the_bit() {
    let mesh = Mesh::new();
    for codec in [Codec::Raw, Codec::Zstd] {
        let file = file(mesh.table().encode(Encoding::F32).unwrap(), codec);
        assert_eq!(validate(&file, &Limits::default()), []);
        let asset = Asset::open(&file).unwrap();
        let section = asset.section(SectionKind::CURVATURE).unwrap();
        assert!(section.is_critical() && !section.kind().is_texture());
        let payload = section.payload(&Limits::default()).unwrap();
        let view = CurvatureView::new(section.curvature().unwrap(), &payload).unwrap();
        assert_eq!((view.vertices(), view.descriptor().length_unit()), (5, LengthUnit::Metre));
        for (i, k) in (0..5).zip(0..) {
            assert_eq!(view.principal(i), mesh.principal[k]);
            assert_eq!(view.directions(i), Some(mesh.directions[k]));
            assert_eq!(view.forms(i), Some(mesh.forms[k]));
            assert_eq!(view.uv_directions(i), Some(mesh.uv_directions[k]));
            assert_eq!(view.flags(i), mesh.flags[k]);
        }
    }
}

#[test]
fn what_is_not_given_is_not_there() {
    let encoded = bare(&[[2.0, -1.0]]).encode(Encoding::Compact).unwrap();
    let view = encoded.view().unwrap();
    assert_eq!(view.principal(0), [2.0, -1.0]);
    assert_eq!(view.descriptor().curvature_range(), (-1.0, 2.0));
    assert_eq!((view.directions(0), view.forms(0), view.uv_directions(0)), (None, None, None));
    assert_eq!(view.flags(0), VertexFlags::NONE);
    assert_eq!(view.payload().len(), 4);
    assert_eq!(
        view.descriptor().columns().map(|layout| layout.column).collect::<Vec<_>>(),
        [CurvatureColumn::Principal]
    );
    // Flags of which none is set are as good as none.
    let quiet = CurvatureTable { flags: &[VertexFlags::NONE], ..bare(&[[2.0, -1.0]]) };
    assert_eq!(quiet.encode(Encoding::Compact).unwrap(), encoded);
}

/// What a game does: the bytes of a column, as they are, in the format that it states.
#[test]
fn a_column_is_a_vertex_buffer() {
    let mesh = Mesh::new();
    let encoded = mesh.table().encode(Encoding::F16).unwrap();
    let view = encoded.view().unwrap();
    let expected = [
        (CurvatureColumn::Principal, "float16x2", 4),
        (CurvatureColumn::Direction1, "float16x4", 8),
        (CurvatureColumn::Direction2, "float16x4", 8),
        (CurvatureColumn::FirstForm, "float16x4", 8),
        (CurvatureColumn::SecondForm, "float16x4", 8),
        (CurvatureColumn::UvDirections, "float16x4", 8),
        (CurvatureColumn::Flags, "uint32", 4),
    ];
    for (k, (column, format, stride)) in expected.into_iter().enumerate() {
        let layout = view.descriptor().column(column).unwrap();
        assert_eq!((layout.format.name(), layout.format.stride()), (format, stride));
        assert_eq!(view.column(column).unwrap().len(), 5 * stride as usize);
        assert_eq!(view.descriptor().offset(column), Some(256 * k as u64));
    }
    let scale = view.descriptor().column(CurvatureColumn::FirstForm).unwrap().scale;
    let first: Vec<f32> = view.column(CurvatureColumn::FirstForm).unwrap()[8..16]
        .chunks_exact(2)
        .map(|half| scale * half::f16::from_le_bytes([half[0], half[1]]).to_f32())
        .collect();
    assert_eq!(first, [5.0, 0.5, 9.0, 0.0]);
}

/// Numbers of both signs over sixty decades, and zero.
fn number() -> impl Strategy<Value = f32> {
    let sized = (-30.0_f32..30.0, any::<bool>()).prop_map(|(decade, negative)| {
        let size = 10.0_f32.powf(decade);
        if negative { -size } else { size }
    });
    prop_oneof![9 => sized, 1 => Just(0.0)]
}

fn principal() -> impl Strategy<Value = [f32; 2]> {
    (number(), number()).prop_map(|(a, b)| [a.max(b), a.min(b)])
}

/// The first form of a chart of any size and any shear down to 1e-8 radians.
fn sheared() -> impl Strategy<Value = [f64; 3]> {
    (-10.0..10.0, -10.0..10.0, -8.0..0.0_f64).prop_map(|(a, b, shear): (f64, f64, f64)| {
        let (pu, pv, angle) = (10.0_f64.powf(a), 10.0_f64.powf(b), 10.0_f64.powf(shear));
        [pu * pu, pu * pv * angle.cos(), pv * pv]
    })
}

/// Every half of a column against what was given.
fn assert_near(layout: &ColumnLayout, given: &[f32], decoded: &[f32], steps: f32) {
    let largest = given.iter().fold(0.0_f32, |largest, number| largest.max(number.abs()));
    for (&given, &decoded) in given.iter().zip(decoded) {
        let error = (given - decoded).abs();
        assert!(error <= layout.worst_case_error, "{given} became {decoded}");
        // The page's promise: eleven bits, however small beside the largest.
        if given.abs() >= largest / 2.0_f32.powi(28) && layout.scale > 2.0_f32.powi(-102) {
            assert!(error <= steps * given.abs() / 2048.0, "{given} became {decoded} beside {largest}");
        }
    }
}

proptest! {
    #[test]
    fn halves_keep_eleven_bits_and_the_order(rows in prop::collection::vec(principal(), 1..20)) {
        let encoded = bare(&rows).encode(Encoding::F16).unwrap();
        let view = encoded.view().unwrap();
        let decoded: Vec<[f32; 2]> = (0..view.vertices()).map(|i| view.principal(i)).collect();
        prop_assert!(decoded.iter().all(|[first, second]| first >= second));
        let layout = view.descriptor().column(CurvatureColumn::Principal).unwrap();
        assert_near(layout, rows.as_flattened(), decoded.as_flattened(), 1.0);
        prop_assert_eq!(validate(&file(encoded, Codec::Raw), &Limits::default()), []);
    }

    #[test]
    fn a_first_form_stays_positive(charts in prop::collection::vec(sheared(), 1..8)) {
        let forms: Vec<SurfaceForms> = charts.iter().map(|&first| SurfaceForms::nearest(first, [1.0; 3])).collect();
        // A shear that f64 itself does not see has no area to keep.
        prop_assume!(charts.iter().all(|[e, f, g]| e * g > f * f));
        prop_assert!(forms.iter().all(SurfaceForms::is_positive));
        let principal = vec![[0.0, 0.0]; forms.len()];
        let table = CurvatureTable { forms: Some(&forms), ..bare(&principal) };
        let encoded = table.encode(Encoding::F16).unwrap();
        let view = encoded.view().unwrap();
        let decoded: Vec<[f32; 3]> = (0..view.vertices()).map(|i| view.forms(i).unwrap().first).collect();
        let given: Vec<f32> = forms.iter().flat_map(|forms| forms.first).collect();
        let layout = view.descriptor().column(CurvatureColumn::FirstForm).unwrap();
        assert_near(layout, &given, decoded.as_flattened(), 2.0);
        prop_assert_eq!(validate(&file(encoded, Codec::Raw), &Limits::default()), []);
    }
}

/// E of a million and a curvature of a millionth: each column has its own scale, so no half overflows or fades away.
#[test]
fn forms_of_unlike_size_do_not_hurt_each_other() {
    let forms = [SurfaceForms { first: [1e6, 2e5, 3e6], second: [1.0, 0.25, 2.0] }; 2];
    let table = CurvatureTable { forms: Some(&forms), ..bare(&[[1e-6, 6e-7]; 2]) };
    let encoded = table.encode(Encoding::Compact).unwrap();
    let view = encoded.view().unwrap();
    let SurfaceForms { first, second } = view.forms(0).unwrap();
    let relative = |decoded: f32, given: f32| (decoded / given - 1.0).abs();
    for k in 0..3 {
        assert!(relative(first[k], forms[0].first[k]) < 1.0 / 2048.0);
        assert!(relative(second[k], forms[0].second[k]) < 1.0 / 2048.0);
    }
    assert!(relative(view.principal(0)[0], 1e-6) < 1.0 / 2048.0);
}

#[test]
fn the_largest_and_the_least_scale_are_legal() {
    for rows in [[[2.0_f32.powi(100), -2.0_f32.powi(100).next_down()]], [[0.0, 0.0]], [[1e-44, -1e-44]]] {
        let encoded = bare(&rows).encode(Encoding::F16).unwrap();
        let view = encoded.view().unwrap();
        let layout = view.descriptor().column(CurvatureColumn::Principal).unwrap();
        for k in 0..2 {
            assert!((view.principal(0)[k] - rows[0][k]).abs() <= layout.worst_case_error);
        }
        assert_eq!(validate(&file(encoded, Codec::Raw), &Limits::default()), []);
    }
}

#[test]
fn the_loss_is_measured_on_what_a_reader_reads() {
    let mesh = Mesh::new();
    let encoded = mesh.table().encode(Encoding::F16).unwrap();
    let view = encoded.view().unwrap();
    let errors: Vec<f64> = (0..5)
        .flat_map(|i| [0, 1].map(|k| f64::from(view.principal(i)[k]) - f64::from(mesh.principal[i as usize][k])))
        .collect();
    let (column, loss) = encoded.losses()[0];
    assert_eq!((column, loss.values), (CurvatureColumn::Principal, 10));
    assert_eq!(loss.max, errors.iter().fold(0.0_f64, |largest, error| largest.max(error.abs())));
    let rms = (errors.iter().map(|error| error * error).sum::<f64>() / 10.0).sqrt();
    assert!(loss.max > 0.0 && (loss.rms - rms).abs() < 1e-12);
    assert_eq!(encoded.losses().len(), 6);
    let exact = mesh.table().encode(Encoding::F32).unwrap();
    assert!(exact.losses().iter().all(|(_, loss)| loss.max == 0.0));
}

fn refusal(table: &CurvatureTable<'_>) -> String {
    table.encode(Encoding::F32).unwrap_err().to_string()
}

#[test]
fn what_is_no_curvature_is_not_written() {
    assert_eq!(
        bare(&[[1.0, 0.0]]).encode(Encoding::U8).unwrap_err().to_string(),
        "curvature cannot be stored as u8; f32, f16 or compact is accepted"
    );
    assert_eq!(refusal(&bare(&[])), "vertex_count is 0; 1 to 4294967295 is accepted");
    let ordered = "κ1 ≥ κ2 within ±2¹⁰⁰ is accepted";
    assert_eq!(refusal(&bare(&[[1.0, 0.0], [0.0, 1.0]])), format!("principal of vertex 1 is [0.0, 1.0]; {ordered}"));
    for row in [[f32::NAN, 0.0], [0.0, f32::NAN], [f32::INFINITY, 0.0], [2e30, 0.0], [0.0, -2e30]] {
        assert!(refusal(&bare(&[row])).ends_with(ordered), "{row:?}");
    }
    let mesh = Mesh::new();
    let short = CurvatureTable { directions: Some(&mesh.directions[1..]), ..mesh.table() };
    assert_eq!(refusal(&short), "directions has 4 vertices; 5 is accepted");
    let short = CurvatureTable { flags: &mesh.flags[..4], ..mesh.table() };
    assert_eq!(refusal(&short), "flags has 4 vertices; 5 is accepted");
    for directions in
        [[[1.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [[1.0, 0.0, 0.0]; 2], [[f32::NAN, 0.0, 0.0], [0.0, 1.0, 0.0]]]
    {
        let table = CurvatureTable { directions: Some(&[directions]), ..bare(&[[0.0; 2]]) };
        assert!(refusal(&table).ends_with("; two unit vectors at right angles are accepted"), "{directions:?}");
    }
    for first in [[1.0, 1.0, 1.0], [0.0, 0.0, 0.0], [-1.0, 0.0, -1.0], [1.0, 0.0, f32::NAN], [2e30, 0.0, 1.0]] {
        let forms = [SurfaceForms { first, second: [0.0; 3] }];
        let table = CurvatureTable { forms: Some(&forms), ..bare(&[[0.0; 2]]) };
        assert!(refusal(&table).ends_with("E > 0 and EG − F² > 0 are accepted"), "{first:?}");
    }
    let table = CurvatureTable { uv_directions: Some(&[[[f32::NAN; 2]; 2]]), ..bare(&[[0.0; 2]]) };
    assert!(refusal(&table).starts_with("uv_directions of vertex 0 is "));
    let table = CurvatureTable { flags: &[VertexFlags(128)], ..bare(&[[0.0; 2]]) };
    assert_eq!(refusal(&table), "flags of vertex 0 is VertexFlags(128); known bits are accepted");
    let flags = [VertexFlags::NONE, VertexFlags::ISOLATED];
    let table = CurvatureTable { flags: &flags, ..bare(&[[1.0, 0.0]; 2]) };
    assert_eq!(
        refusal(&table),
        "principal of vertex 1 is ([1.0, 0.0], VertexFlags(2)); 0 is accepted where a vertex is isolated or degenerate"
    );
}

#[test]
fn another_section_holds_no_curvature() {
    let mut writer = AssetWriter::new();
    writer.provenance("{}").unwrap();
    let file = writer.finish().unwrap();
    let error = Asset::open(&file).unwrap().section(SectionKind::PROVENANCE).unwrap().curvature().unwrap_err();
    assert_eq!(error.to_string(), "a PROV section does not hold curvature; CURV does");
}

#[test]
fn a_view_wants_the_whole_payload_and_nothing_else() {
    let encoded = bare(&[[1.0, 0.0]; 3]).encode(Encoding::F32).unwrap();
    let (descriptor, payload) = (*encoded.descriptor(), encoded.payload());
    let error = CurvatureView::new(descriptor, &payload[..23]).unwrap_err();
    assert_eq!(error, CurvatureError::PayloadLength { found: 23, expected: 24 });
}

/// The greatest table there can be: lengths are computed, nothing is allocated.
#[test]
fn four_billion_vertices_have_a_length() {
    let layout = |column: CurvatureColumn| {
        let format = column.formats()[0];
        ColumnLayout { column, format, scale: 1.0, range_min: 0.0, range_max: 0.0, worst_case_error: 0.0 }
    };
    let columns = CurvatureColumn::ALL.map(layout);
    let descriptor = CurvatureDescriptor::new(u32::MAX, LengthUnit::Metre, &columns).unwrap();
    let last = descriptor.offset(CurvatureColumn::Flags).unwrap();
    assert_eq!(
        last,
        [8_u64, 12, 12, 12, 12, 16].map(|stride| (stride << 32) - stride).map(|n| n.next_multiple_of(256)).iter().sum()
    );
    assert_eq!(descriptor.payload_length(), last + (4 << 32) - 4);
    assert!(CurvatureView::new(descriptor, &[]).is_err());
}
