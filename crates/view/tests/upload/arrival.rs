//! What arrives on a device is what is in the file, whatever the shape, the part or the codec.

use std::f32::consts::TAU;

use barchan_asset::{Codec, CurvatureColumn, Semantic, Wrap, vectors};
use barchan_view::Probe;
use barchan_wgpu::{DeviceLimits, Reader, Sampling, Selection, Shape, TablePart, Technique, UploadPlan};

use crate::support::{Drawing, all_over, apart, file, gpu, heights, horizon, plan, small_gpu, upload, vector};

/// A low light at an azimuth, in turns.
fn lit_from(turns: f32, probe: Probe) -> Probe {
    let azimuth = turns * TAU;
    Probe { light: [0.8 * azimuth.cos(), 0.8 * azimuth.sin(), 0.6], ..probe }
}

#[test]
fn every_vector_is_uploaded() {
    let gpu = gpu();
    for vector in vectors::all().unwrap().iter().filter(|vector| !vector.name.starts_with("refused/")) {
        let plan = plan(&vector.bytes, &DeviceLimits::of(&gpu.device));
        let asset = upload(&gpu, &vector.bytes, &plan).unwrap_or_else(|error| panic!("{}: {error}", vector.name));
        for texture in plan.textures() {
            assert!(asset.texture(texture.table).is_some());
        }
        for column in plan.curvature().map_or(&[][..], |curvature| &curvature.columns) {
            assert!(asset.column(column.column).is_some());
        }
    }
}

#[test]
fn heights_arrive_as_they_are() {
    let values: Vec<f32> = (0..49).map(|i| (i * i % 23) as f32 - 3.5).collect();
    let bytes = file(vec![heights(&values, Wrap::Clamp)], Codec::Raw);
    let probe = Probe { size: (7, 7), ..Probe::default() };
    let found = Drawing::new(Technique::Surface, &probe).draw(&gpu(), &bytes);
    assert_eq!(found.iter().map(|pixel| pixel[0]).collect::<Vec<_>>(), values);
}

#[test]
fn a_volume_has_the_values_of_a_layered_texture() {
    let gpu = gpu();
    let bytes = file(vec![horizon(16, 12, Wrap::Repeat)], Codec::Raw);
    for turns in [0.0, 0.3, 0.97] {
        let probe = lit_from(turns, all_over(16));
        for sampling in [Sampling::Loaded, Sampling::Filtered] {
            let layered = Drawing { sampling, ..Drawing::new(Technique::HorizonShadow, &probe) };
            let limits = DeviceLimits { max_layers: 11, ..layered.limits };
            assert_eq!(plan(&bytes, &layered.limits).textures()[0].shape, Shape::D2Array);
            assert_eq!(plan(&bytes, &limits).textures()[0].shape, Shape::D3);
            let volume = Drawing { limits, ..Drawing::new(Technique::HorizonShadow, &probe) };
            let volume = Drawing { sampling, ..volume };
            let apart = apart(&volume.draw(&gpu, &bytes), &layered.draw(&gpu, &bytes));
            assert!(apart < 1e-6, "{sampling:?} {turns}: {apart}");
        }
    }
}

#[test]
fn an_arc_over_the_seam_has_the_values_of_the_circle() {
    let gpu = gpu();
    let bytes = file(vec![horizon(8, 12, Wrap::Repeat)], Codec::Raw);
    // The azimuths 10, 11, 0 and 1.
    for step in [0.0, 0.4, 1.0, 1.5, 2.3, 2.99] {
        let probe = lit_from((10.0 + step) / 12.0, all_over(8));
        let circle = Drawing::new(Technique::HorizonShadow, &probe);
        let arc = Drawing { selection: Selection::everything().with_azimuths(10, 4), ..circle };
        let found = arc.draw(&gpu, &bytes);
        let apart = apart(&found, &Drawing::new(Technique::HorizonShadow, &probe).draw(&gpu, &bytes));
        assert!(apart < 2e-6, "{step}: {apart}");
    }
}

#[test]
fn one_azimuth_alone_is_the_circle_there() {
    let gpu = gpu();
    let bytes = file(vec![horizon(8, 12, Wrap::Repeat)], Codec::Raw);
    let probe = lit_from(7.0 / 12.0, all_over(8));
    let circle = Drawing::new(Technique::HorizonShadow, &probe);
    for sampling in [Sampling::Loaded, Sampling::Filtered] {
        let selection = Selection::everything().with_azimuths(7, 1);
        let one = Drawing { selection, sampling, ..Drawing::new(Technique::HorizonShadow, &probe) };
        // A sampler's weights have 8 bits, and texels differ by 0.012 at most.
        let slack = if sampling == Sampling::Loaded { 2e-6 } else { 1e-4 };
        let apart = apart(&one.draw(&gpu, &bytes), &circle.draw(&gpu, &bytes));
        assert!(apart < slack, "{sampling:?}: {apart}");
    }
}

#[test]
fn a_compressed_file_has_the_values_of_a_raw_one() {
    let gpu = gpu();
    let tables = || vec![horizon(16, 5, Wrap::Repeat), heights(&[0.0, 1.0, 2.0, 3.0], Wrap::Repeat)];
    let probe = lit_from(0.15, all_over(16));
    let drawing = Drawing::new(Technique::HorizonShadow, &probe);
    let [raw, packed] = [Codec::Raw, Codec::Zstd].map(|codec| drawing.draw(&gpu, &file(tables(), codec)));
    assert_eq!(raw, packed);
}

#[test]
fn tables_with_edges_of_their_own_keep_them() {
    let gpu = gpu();
    let values: Vec<f32> = (0..64).map(|i| (i * 5 % 17) as f32).collect();
    let bytes = file(vec![horizon(8, 3, Wrap::Repeat), heights(&values, Wrap::Clamp)], Codec::Raw);
    // Beyond the edges on all sides.
    let probe = Probe { size: (48, 48), place: [-2.0; 2], ..lit_from(0.1, all_over(8)) };
    for (technique, slack) in [(Technique::HorizonShadow, 1e-4), (Technique::Surface, 0.1)] {
        let loaded = Drawing::new(technique, &probe);
        let filtered = Drawing { sampling: Sampling::Filtered, ..Drawing::new(technique, &probe) };
        let apart = apart(&filtered.draw(&gpu, &bytes), &loaded.draw(&gpu, &bytes));
        assert!(apart < slack, "{technique:?}: {apart}");
    }
}

#[test]
fn two_assets_on_one_device_do_not_disturb_each_other() {
    let gpu = gpu();
    let values = [[0.0, 1.0, 2.0, 3.0], [10.0, -4.0, 7.5, 0.5]];
    let files = values.map(|values| file(vec![heights(&values, Wrap::Clamp)], Codec::Raw));
    let probe = Probe { size: (2, 2), ..Probe::default() };
    let drawing = Drawing::new(Technique::Surface, &probe);
    let loaded = files.each_ref().map(|bytes| {
        let plan = plan(bytes, &drawing.limits);
        let asset = upload(&gpu, bytes, &plan).unwrap();
        (plan, asset)
    });
    for k in [0, 1, 0, 1, 1, 0] {
        let found = drawing.draw_asset(&gpu, &loaded[k].0, &loaded[k].1);
        assert_eq!(found.iter().map(|pixel| pixel[0]).collect::<Vec<_>>(), values[k]);
    }
}

#[test]
fn what_is_not_a_number_is_uploaded_and_drawn() {
    let mut bytes = file(vec![heights(&[1.0; 16], Wrap::Clamp)], Codec::Raw);
    let payload = bytes.len() - 64;
    bytes[payload..].fill(0xFF);
    vectors::reseal(&mut bytes);
    let probe = all_over(4);
    let found = Drawing::new(Technique::Surface, &probe).draw(&gpu(), &bytes);
    assert!(found.iter().all(|pixel| pixel[0].is_nan()));
}

#[test]
fn a_device_of_the_least_limits_has_the_same_values() {
    let probe = lit_from(0.4, all_over(16));
    let bytes = file(vec![horizon(16, 12, Wrap::Repeat)], Codec::Raw);
    let small = small_gpu(|limits| (limits.max_texture_array_layers, limits.max_texture_dimension_3d) = (8, 16));
    let limits = DeviceLimits::of(&small.device);
    assert_eq!((limits.max_layers, limits.max_3d), (8, 16));
    let on_small = Drawing { limits, ..Drawing::new(Technique::HorizonShadow, &probe) };
    let found = on_small.draw(&small, &bytes);
    assert!(apart(&found, &Drawing::new(Technique::HorizonShadow, &probe).draw(&gpu(), &bytes)) < 1e-6);
}

#[test]
fn curvature_alone_is_vertex_buffers() {
    let gpu = gpu();
    let bytes = vector("curvature-f32");
    let plan = plan(&bytes, &DeviceLimits::of(&gpu.device));
    assert!(plan.textures().is_empty());
    let asset = upload(&gpu, &bytes, &plan).unwrap();
    for column in &plan.curvature().unwrap().columns {
        let buffer = asset.column(column.column).unwrap();
        assert_eq!((buffer.size(), buffer.usage().contains(wgpu::BufferUsages::VERTEX)), (column.bytes, true));
    }
    let reader = Reader::open(&bytes).unwrap();
    let few = Selection::everything().with_columns(&[CurvatureColumn::Principal]);
    let few = UploadPlan::new(&reader, &few, &DeviceLimits::WEBGPU).unwrap();
    assert!(upload(&gpu, &bytes, &few).unwrap().column(CurvatureColumn::FirstForm).is_none());
}

#[test]
fn levels_of_a_table_are_levels_of_a_texture() {
    let gpu = gpu();
    let bytes = vector("relief-f32");
    let part = TablePart { first_level: 1, ..TablePart::default() };
    let selection = Selection::everything().with_part(Semantic::MaximumHeight, part);
    let reader = Reader::open(&bytes).unwrap();
    let plan = UploadPlan::new(&reader, &selection, &DeviceLimits::of(&gpu.device)).unwrap();
    let asset = upload(&gpu, &bytes, &plan).unwrap();
    let texture = asset.texture(Semantic::MaximumHeight).unwrap().texture();
    assert_eq!((texture.width(), texture.height(), texture.mip_level_count()), (2, 1, 2));
}
