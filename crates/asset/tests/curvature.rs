//! Curvature tables: what goes in comes out, exactly or within what the descriptor says; what is no curvature is refused.

use barchan_asset::{
    Asset, AssetWriter, Codec, ColumnLayout, CurvatureColumn, CurvatureDescriptor, CurvatureError, CurvatureTable,
    CurvatureView, EncodeError, EncodedCurvature, Encoding, LengthUnit, Limits, SectionKind, SurfaceForms, VertexFlags,
    VertexFormat, validate,
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
