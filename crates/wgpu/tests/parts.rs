//! A part of a table has the values that the whole has there.

mod support;

use std::f64::consts::TAU;

use barchan_asset::{CurvatureColumn, Encoding, Semantic, TextureDescriptor, Wrap};
use barchan_wgpu::{
    DeviceLimits, PARAMETER_BYTES, Reader, ReliefSearch, Selection, Shader, ShaderOptions, TablePart, Technique,
    TexturePlan, UploadPlan,
};
use support::{accepted, carried_out, file, horizon, plan, stored, vector};

/// What a layer is: its candidate or ring, counted in the table, and its azimuth in turns.
fn meaning(table: &TextureDescriptor, layer: u32) -> (u32, f64) {
    let azimuths = table.azimuths().unwrap();
    let turns = azimuths.radians(layer % azimuths.count()) / TAU;
    (layer / azimuths.count(), turns - turns.floor())
}

/// Every layer of the texture is the layer of the table that means the same.
fn check_layers(reader: &Reader<'_>, texture: &TexturePlan) {
    let whole = reader.texture(texture.table).unwrap().descriptor;
    assert_eq!(texture.descriptor.layers, texture.layers);
    for (layer, bytes) in (0..).zip(carried_out(reader, texture)) {
        let (group, azimuth) = meaning(&texture.descriptor, layer);
        let same = |&other: &u32| {
            let (other_group, other_azimuth) = meaning(&whole, other);
            let apart = (other_azimuth - azimuth).abs();
            other_group == group && apart.min(1.0 - apart) < 1e-12
        };
        let sources: Vec<u32> = (0..whole.layers).filter(same).collect();
        assert_eq!(sources.len(), 1, "{:?} layer {layer}", texture.table);
        assert_eq!(bytes, stored(reader, texture.table, sources[0]), "{:?} layer {layer}", texture.table);
    }
}

fn with(table: Semantic, part: TablePart) -> Selection {
    Selection::tables(&[table]).with_part(table, part)
}

#[test]
fn an_arc_of_a_circle_may_cross_its_seam() {
    let bytes = file(vec![horizon(4, 8, Wrap::Repeat, Encoding::F16)]);
    let reader = Reader::open(&bytes).unwrap();
    for first in 0..8 {
        for count in 1..=8 {
            let part = TablePart { azimuths: Some((first, count)), ..TablePart::default() };
            let plan = plan(&reader, &with(Semantic::HorizonElevation, part));
            let texture = &plan.textures()[0];
            assert_eq!(texture.layers, count);
            texture.descriptor.check().unwrap();
            check_layers(&reader, texture);
        }
    }
}

#[test]
fn candidates_and_azimuths_of_all_horizon_tables_go_together() {
    let bytes = vector("swept-horizon");
    let reader = Reader::open(&bytes).unwrap();
    let plan = plan(&reader, &Selection::everything().with_azimuths(2, 2).with_candidates(1));
    assert_eq!(plan.textures().len(), 4);
    for texture in plan.textures() {
        assert_eq!(texture.layers, 2);
        texture.descriptor.check().unwrap();
        check_layers(&reader, texture);
    }
    let left = plan.texture(Semantic::SweptDistance).unwrap().descriptor.candidates;
    assert_eq!(left, 1);
}

#[test]
fn rings_end_where_they_did() {
    let bytes = vector("relief-f16");
    let reader = Reader::open(&bytes).unwrap();
    let whole = reader.texture(Semantic::HemisphereDepth).unwrap().descriptor.directions().unwrap();
    let part = TablePart { rings: Some(1), azimuths: Some((2, 2)), ..TablePart::default() };
    let plan = plan(&reader, &with(Semantic::HemisphereDepth, part));
    let texture = &plan.textures()[0];
    texture.descriptor.check().unwrap();
    check_layers(&reader, texture);
    let left = texture.descriptor.directions().unwrap();
    assert_eq!(left.rings, 1);
    assert!((left.tangent_of_edge(1) / whole.tangent_of_edge(1) - 1.0).abs() < 1e-12);
}

#[test]
fn levels_keep_their_numbers() {
    let bytes = vector("relief-f32");
    let reader = Reader::open(&bytes).unwrap();
    for first_level in 0..3 {
        let part = TablePart { first_level, ..TablePart::default() };
        let plan = plan(&reader, &with(Semantic::MaximumHeight, part));
        let texture = &plan.textures()[0];
        assert_eq!((texture.first_level, texture.levels), (first_level, 3 - first_level));
        for (level, picture) in (first_level..).zip(carried_out(&reader, texture)) {
            assert_eq!(picture, stored(&reader, Semantic::MaximumHeight, level));
        }
    }
}

#[test]
fn a_part_that_is_not_there_is_refused_by_name() {
    let bytes = vector("swept-horizon");
    let reader = Reader::open(&bytes).unwrap();
    let refused =
        |table, part| UploadPlan::new(&reader, &with(table, part), &DeviceLimits::WEBGPU).unwrap_err().to_string();
    let none = TablePart::default();
    for (table, part, message) in [
        (
            Semantic::SweptDistance,
            TablePart { candidates: Some(3), ..none },
            "table SWDS: candidates is 3; 1 to 2 is accepted",
        ),
        (
            Semantic::HorizonElevation,
            TablePart { azimuths: Some((3, 1)), ..none },
            "table HORZ: first azimuth is 3; 0 to 2 is accepted",
        ),
        (
            Semantic::HorizonElevation,
            TablePart { azimuths: Some((1, 4)), ..none },
            "table HORZ: number of azimuths is 4; 1 to 3 is accepted",
        ),
        (Semantic::HemisphereDepth, none, "table HEMI is not in the file"),
    ] {
        assert_eq!(refused(table, part), message);
    }
}

#[test]
fn an_arc_ends_where_the_file_ends_it() {
    let bytes = vector("horizon-arc");
    let reader = Reader::open(&bytes).unwrap();
    let selection = |azimuths| Selection::everything().with_azimuths(1, azimuths);
    check_layers(&reader, &plan(&reader, &selection(2)).textures()[0]);
    let message = UploadPlan::new(&reader, &selection(3), &DeviceLimits::WEBGPU).unwrap_err().to_string();
    assert_eq!(message, "table HORZ: number of azimuths is 3; 1 to 2 is accepted");
}

#[test]
fn parts_that_do_not_go_together_are_refused_by_the_shader() {
    let bytes = vector("horizon-distance-f16");
    let reader = Reader::open(&bytes).unwrap();
    let compose = |selection: Selection| {
        Shader::compose(&plan(&reader, &selection), &[Technique::Penumbra], &ShaderOptions::default())
    };
    assert!(compose(Selection::everything().with_azimuths(3, 2)).is_ok());
    let part = TablePart { azimuths: Some((3, 2)), ..TablePart::default() };
    let error = compose(Selection::everything().with_part(Semantic::HorizonDistance, part)).unwrap_err();
    assert_eq!(error.to_string(), "penumbra needs the same azimuths of the tables DIST and HORZ; theirs differ");
}

fn tables(bytes: &[u8], techniques: &[Technique]) -> Vec<Semantic> {
    let reader = Reader::open(bytes).unwrap();
    let plan = plan(&reader, &Selection::of_techniques(&reader, techniques));
    plan.textures().iter().map(|texture| texture.table).collect()
}

#[test]
fn a_selection_of_techniques_is_what_they_read() {
    let sky = vector("sky-f16");
    assert_eq!(tables(&sky, &[Technique::Sky]), [Semantic::SkyVisibility, Semantic::BentNormal]);
    assert_eq!(tables(&sky, &[Technique::ApertureCone]), [Semantic::ApertureCone]);
    let relief = vector("relief-f16");
    let search = [Technique::Relief(ReliefSearch::MaximumMip), Technique::ReliefShadow];
    assert_eq!(tables(&relief, &search), [Semantic::Height, Semantic::HemisphereDepth, Semantic::MaximumHeight]);
    let reader = Reader::open(&relief).unwrap();
    let plan = plan(&reader, &Selection::of_techniques(&reader, &search));
    assert_eq!(plan.texture(Semantic::MaximumHeight).unwrap().first_level, 1);
}

#[test]
fn what_a_technique_requires_is_missed_by_name() {
    let bytes = vector("horizon-arc");
    let reader = Reader::open(&bytes).unwrap();
    let selection = Selection::of_techniques(&reader, &[Technique::Penumbra]);
    let message = UploadPlan::new(&reader, &selection, &DeviceLimits::WEBGPU).unwrap_err().to_string();
    assert_eq!(message, "table DIST is not in the file");
}

#[test]
fn curvature_is_loaded_column_by_column() {
    let bytes = vector("curvature-f32");
    let reader = Reader::open(&bytes).unwrap();
    let (descriptor, section) = reader.curvature().unwrap();
    let payload = section.raw_payload().unwrap();
    let chosen = [CurvatureColumn::FirstForm, CurvatureColumn::SecondForm];
    let plan = plan(&reader, &Selection::everything().with_columns(&chosen));
    let curvature = plan.curvature().unwrap();
    assert_eq!(curvature.columns.iter().map(|column| column.column).collect::<Vec<_>>(), chosen);
    let view = barchan_asset::CurvatureView::new(*descriptor, payload).unwrap();
    for column in &curvature.columns {
        assert_eq!(column.of(payload), view.column(column.column));
    }
}

#[test]
fn a_file_of_curvature_alone_has_parameters_of_zero() {
    let bytes = vector("curvature-f16");
    let plan = plan(&Reader::open(&bytes).unwrap(), &Selection::everything());
    assert!(plan.textures().is_empty() && plan.curvature().is_some());
    assert_eq!(plan.parameters(), [0; PARAMETER_BYTES]);
}

#[test]
fn nothing_may_be_selected() {
    for vector in accepted() {
        let reader = Reader::open(&vector.bytes).unwrap();
        let nothing = Selection::tables(&[]).with_columns(&[]);
        assert_eq!(plan(&reader, &nothing).bytes(), 0, "{}", vector.name);
    }
}
