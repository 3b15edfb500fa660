//! What a plan says: shapes, copies, and what is refused with which words.

mod support;

use barchan_asset::{
    Azimuths, DepthMode, Encoding, HemisphereDirections, HemisphereTable, ReliefRange, RingSpacing, Semantic, Wrap,
};
use barchan_wgpu::{DeviceLimits, Reader, Selection, Shape, UploadPlan};
use support::{ROOMY, accepted, carried_out, file, heights, horizon, plan, square, stored, vector};

#[test]
fn the_copies_of_a_plan_are_the_tables_of_the_file() {
    for vector in accepted() {
        let reader = Reader::open(&vector.bytes).unwrap();
        let Ok(plan) = UploadPlan::new(&reader, &Selection::everything(), &ROOMY) else {
            assert!(!cfg!(feature = "zstd") && vector.name.contains("zstd"), "{}", vector.name);
            continue;
        };
        assert_eq!(plan.textures().len(), reader.textures().len());
        for texture in plan.textures() {
            let pictures = carried_out(&reader, texture);
            assert_eq!(pictures.len() as u32, texture.descriptor.pictures());
            for (k, picture) in (0..).zip(&pictures) {
                assert_eq!(*picture, stored(&reader, texture.table, k), "{} {:?} {k}", vector.name, texture.table);
            }
        }
    }
}

#[test]
fn a_raw_payload_is_the_files_own_bytes() {
    let bytes = vector("horizon-distance-f16");
    let reader = Reader::open(&bytes).unwrap();
    for texture in plan(&reader, &Selection::everything()).textures() {
        let payload = reader.payload(texture.table.kind()).unwrap();
        let start = texture.payload_offset.unwrap() as usize;
        assert_eq!(payload.as_ptr(), bytes[start..].as_ptr());
    }
}

#[test]
fn layers_without_a_gap_are_one_copy() {
    // 16 × 16 bytes are 256, so nothing lies between layers; after 15 × 15 there is padding.
    for (side, copies) in [(16, 1), (15, 8)] {
        let bytes = file(vec![horizon(side, 8, Wrap::Repeat, Encoding::U8)]);
        let reader = Reader::open(&bytes).unwrap();
        assert_eq!(plan(&reader, &Selection::everything()).textures()[0].copies.len(), copies);
    }
}

fn shape(bytes: &[u8], limits: &DeviceLimits) -> Shape {
    let reader = Reader::open(bytes).unwrap();
    UploadPlan::new(&reader, &Selection::everything(), limits).unwrap().textures()[0].shape
}

#[test]
fn layers_are_a_layered_texture_and_beyond_its_limit_a_volume() {
    let (rings, azimuths) = (16, Azimuths::full_circle(32));
    let directions =
        HemisphereDirections { rings, azimuths, spacing: RingSpacing::EqualAngles, max_polar_radians: 1.4 };
    let relief = ReliefRange { top: 1.0, thickness: 1.0 };
    let values = vec![0.5; 2 * 2 * 512];
    let grid = square(2, Wrap::Repeat);
    let table = HemisphereTable { grid, directions, mode: DepthMode::Conservative, relief, values: &values };
    let hemisphere = file(vec![table.encode(Encoding::Compact).unwrap()]);
    assert_eq!(shape(&hemisphere, &ROOMY), Shape::D2Array);
    assert_eq!(shape(&hemisphere, &DeviceLimits::WEBGPU), Shape::D3);
    assert_eq!(shape(&vector("height-f16-clamp"), &DeviceLimits::WEBGPU), Shape::D2);
}

#[test]
fn layers_that_would_be_taken_for_cubes_are_a_volume() {
    let limits = DeviceLimits { guesses_cubes: true, ..ROOMY };
    for (azimuths, expected) in [(1, Shape::D2), (5, Shape::D2Array), (6, Shape::D3), (12, Shape::D3)] {
        assert_eq!(
            shape(&file(vec![horizon(4, azimuths, Wrap::Clamp, Encoding::F16)]), &limits),
            expected,
            "{azimuths}"
        );
    }
}

#[test]
fn floats_of_32_bits_are_filtered_where_the_device_can() {
    for (encoding, can, expected) in
        [(Encoding::F32, false, false), (Encoding::F32, true, true), (Encoding::F16, false, true)]
    {
        let bytes = file(vec![heights(4, Wrap::Clamp, encoding)]);
        let limits = DeviceLimits { filters_float32: can, ..ROOMY };
        let plan = UploadPlan::new(&Reader::open(&bytes).unwrap(), &Selection::everything(), &limits).unwrap();
        assert_eq!(plan.textures()[0].is_filterable, expected);
    }
}

#[test]
fn a_table_whose_edges_are_not_the_samplers_is_not_filtered_by_it() {
    let bytes = file(vec![heights(4, Wrap::Clamp, Encoding::F16), horizon(4, 3, Wrap::Repeat, Encoding::F16)]);
    let plan = plan(&Reader::open(&bytes).unwrap(), &Selection::everything());
    let filtered = plan.textures().iter().filter(|texture| texture.is_filterable).collect::<Vec<_>>();
    assert_eq!(filtered.len(), 1);
    assert_eq!((filtered[0].descriptor.wrap_u, filtered[0].descriptor.wrap_v), plan.edges());
}

fn refused(bytes: &[u8], selection: &Selection, limits: &DeviceLimits) -> String {
    UploadPlan::new(&Reader::open(bytes).unwrap(), selection, limits).unwrap_err().to_string()
}

#[test]
fn a_table_that_fits_in_no_shape_is_refused_by_name_with_what_it_needs() {
    let bytes = file(vec![horizon(16, 8, Wrap::Clamp, Encoding::F16)]);
    let limits = DeviceLimits { max_2d: 15, max_3d: 12, ..ROOMY };
    assert_eq!(
        refused(&bytes, &Selection::everything(), &limits),
        "table HORZ needs a texture of 16 × 16 texels and 8 layers; the device has 15 × 15 texels and 2048 layers at most, or a \
         volume of 12 along each side; bake it smaller, or load a part of it"
    );
}

#[test]
fn levels_that_are_left_out_need_no_room() {
    let bytes = vector("relief-f16");
    let reader = Reader::open(&bytes).unwrap();
    let limits = DeviceLimits { max_2d: 2, ..ROOMY };
    let only = Selection::tables(&[Semantic::MaximumHeight]);
    assert!(UploadPlan::new(&reader, &only, &limits).is_err());
    let part = barchan_wgpu::TablePart { first_level: 1, ..Default::default() };
    let plan = UploadPlan::new(&reader, &only.with_part(Semantic::MaximumHeight, part), &limits).unwrap();
    assert_eq!((plan.textures()[0].extent, plan.textures()[0].levels), ((2, 1), 2));
}

#[test]
fn a_column_that_fits_in_no_buffer_is_refused_by_name() {
    let message = refused(&vector("curvature-f32"), &Selection::everything(), &DeviceLimits { max_buffer: 4, ..ROOMY });
    assert_eq!(message, "curvature column principal needs a buffer of 40 bytes; the device has 4 at most");
}

#[cfg(not(feature = "zstd"))]
#[test]
fn a_compressed_table_is_refused_with_what_to_do() {
    let bytes = vector("horizon-distance-u8-zstd");
    let expected = "section HORZ is compressed, which this program does not read; bake with `compression: none`, or build the \
                    program with the feature `zstd` of barchan-wgpu";
    assert_eq!(refused(&bytes, &Selection::everything(), &ROOMY), expected);
    let reader = Reader::open(&bytes).unwrap();
    assert_eq!(reader.payload(Semantic::HorizonElevation.kind()).unwrap_err().to_string(), expected);
}

#[cfg(feature = "zstd")]
#[test]
fn a_compressed_table_is_decoded_within_limits() {
    let packed = vector("horizon-distance-u8-zstd");
    let reader = Reader::open(&packed).unwrap();
    let plan = plan(&reader, &Selection::everything());
    assert!(plan.textures().iter().all(|texture| texture.payload_offset.is_none()));
    let few = barchan_asset::Limits { max_decoded_bytes: 100, ..Default::default() };
    let message = reader.with_limits(few).payload(Semantic::HorizonElevation.kind()).unwrap_err().to_string();
    assert_eq!(message, "section HORZ: raw_length is 832; at most 100 bytes are accepted");
}
