//! A device that refuses, is lost or is given the wrong plan: an error, and nothing half made.

use std::time::Duration;

use barchan_asset::{Codec, Wrap, vectors};
use barchan_view::Gpu;
use barchan_wgpu::{DeviceLimits, GpuAsset, Reader, Selection, UploadError, UploadPlan};

use crate::support::{file, gpu, heights, horizon, plan, small_gpu, upload, vector};

fn refused(result: Result<GpuAsset, UploadError>) -> String {
    match result.unwrap_err() {
        UploadError::Device { reason } => reason,
        other => panic!("{other}"),
    }
}

/// The device is none the worse for what it refused.
fn check_is_well(gpu: &Gpu) {
    let bytes = file(vec![heights(&[1.0; 4], Wrap::Clamp)], Codec::Raw);
    assert!(upload(gpu, &bytes, &plan(&bytes, &DeviceLimits::WEBGPU)).is_ok());
}

#[test]
fn a_table_larger_than_the_device_allows_is_refused_before_anything_is_made() {
    let bytes = file(vec![horizon(64, 4, Wrap::Repeat)], Codec::Raw);
    let small = small_gpu(|limits| (limits.max_texture_dimension_2d, limits.max_texture_dimension_3d) = (32, 32));
    let reader = Reader::open(&bytes).unwrap();
    let message = UploadPlan::new(&reader, &Selection::everything(), &DeviceLimits::of(&small.device)).unwrap_err();
    let expected = "table HORZ needs a texture of 64 × 64 texels and 4 layers; the device has 32 × 32 texels and";
    assert!(message.to_string().starts_with(expected), "{message}");
}

#[test]
fn a_plan_for_a_larger_device_is_refused_by_the_device() {
    let bytes = file(vec![horizon(64, 4, Wrap::Repeat)], Codec::Raw);
    let small = small_gpu(|limits| limits.max_texture_dimension_2d = 32);
    // What is not caught here would end the test: `wgpu`'s own handler panics.
    let reason = refused(upload(&small, &bytes, &plan(&bytes, &DeviceLimits::WEBGPU)));
    assert!(reason.contains("64") && reason.contains("32"), "{reason}");
}

#[test]
fn a_plan_of_another_file_is_refused() {
    let gpu = gpu();
    let [one, other] = [[1.0; 4], [2.0; 4]].map(|values| file(vec![heights(&values, Wrap::Clamp)], Codec::Raw));
    let plan = plan(&one, &DeviceLimits::WEBGPU);
    assert!(upload(&gpu, &one, &plan).is_ok());
    assert_eq!(upload(&gpu, &other, &plan).unwrap_err(), UploadError::OtherFile);
}

#[test]
fn a_plan_of_a_larger_file_that_says_it_is_the_same_is_refused() {
    let gpu = gpu();
    let small = file(vec![heights(&[1.0; 4], Wrap::Clamp)], Codec::Raw);
    let mut large = file(vec![heights(&[2.0; 64], Wrap::Clamp)], Codec::Raw);
    // The identity.
    large[48..80].copy_from_slice(&small[48..80]);
    vectors::reseal(&mut large);
    let large = plan(&large, &DeviceLimits::WEBGPU);
    assert_eq!(upload(&gpu, &small, &large).unwrap_err(), UploadError::OtherFile);
}

#[test]
fn a_compressed_section_that_does_not_decode_is_refused_by_name() {
    let gpu = gpu();
    let mut bytes = vector("horizon-distance-u8-zstd");
    let plan = plan(&bytes, &DeviceLimits::WEBGPU);
    // The magic of the frame, behind the descriptor.
    bytes[4096 + 256] ^= 0xFF;
    let UploadError::Read(error) = upload(&gpu, &bytes, &plan).unwrap_err() else { panic!() };
    assert!(error.to_string().starts_with("section HORZ: the zstd frame cannot be decoded"), "{error}");
    check_is_well(&gpu);
}

#[test]
fn a_device_that_is_lost_before_is_an_error() {
    let gpu = gpu();
    gpu.device.destroy();
    for name in ["relief-f16", "curvature-f32", "horizon-distance-u8-zstd"] {
        let bytes = vector(name);
        let error = upload(&gpu, &bytes, &plan(&bytes, &DeviceLimits::WEBGPU)).unwrap_err();
        assert_eq!(error, UploadError::Lost, "{name}");
    }
}

#[test]
fn a_device_that_is_lost_on_the_way_is_an_error_or_was_too_late() {
    let bytes = file(vec![horizon(256, 64, Wrap::Repeat)], Codec::Raw);
    let plan = plan(&bytes, &DeviceLimits::WEBGPU);
    let mut lost = 0;
    for round in 0..24 {
        let gpu = gpu();
        let device = gpu.device.clone();
        let breaker = std::thread::spawn(move || {
            std::thread::sleep(Duration::from_micros(100 * round));
            device.destroy();
        });
        match upload(&gpu, &bytes, &plan) {
            Ok(asset) => drop(asset),
            Err(UploadError::Lost) => lost += 1,
            Err(other) => panic!("{other}"),
        }
        breaker.join().unwrap();
    }
    assert!(lost > 0, "no upload was under way when the device went");
}

#[test]
fn an_upload_may_move_from_thread_to_thread() {
    fn moves(_: impl Send) {}
    let gpu = gpu();
    let bytes = vector("sky-f16");
    let (reader, plan) = (Reader::open(&bytes).unwrap(), plan(&bytes, &DeviceLimits::WEBGPU));
    moves(GpuAsset::upload(&gpu.device, &gpu.queue, &reader, &plan));
}

/// A horizon that says it has 2³⁹ texels, in a frame of a few bytes.
fn immense() -> Vec<u8> {
    let (row, descriptor) = (128, 4096);
    let mut bytes = vector("horizon-distance-u8-zstd");
    let mut put = |at: usize, number: &[u8]| bytes[at..at + number.len()].copy_from_slice(number);
    for (at, number) in [(4, 1 << 14), (8, 1 << 14), (12, 1_u32 << 11)] {
        put(descriptor + at, &number.to_le_bytes());
    }
    put(descriptor + 112, &(std::f64::consts::TAU / 2048.0).to_le_bytes());
    put(row + 32, &(1_u64 << 39).to_le_bytes());
    vectors::reseal(&mut bytes);
    bytes
}

#[test]
fn a_table_that_there_is_no_memory_for_is_an_error_before_it_is_decoded() {
    let gpu = gpu();
    let bytes = immense();
    let limits = DeviceLimits { max_2d: 1 << 14, max_layers: 1 << 11, ..DeviceLimits::WEBGPU };
    let error = upload(&gpu, &bytes, &plan(&bytes, &limits)).unwrap_err();
    assert!(matches!(error, UploadError::OutOfMemory | UploadError::Device { .. }), "{error}");
    check_is_well(&gpu);
}
