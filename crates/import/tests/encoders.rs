//! Files of every format and depth, written by the Rust encoders we do not read with where there are such: exact samples.

mod common;

use std::io::Cursor;

use barchan_import::{HeightMapOptions, decode_height_map};
use common::options;
use half::f16;
use image::{DynamicImage, ImageBuffer, ImageFormat, Luma, LumaA, Pixel, Rgb, Rgba};
use npyz::WriterBuilder;
use tiff::encoder::{Compression, DeflateLevel, TiffEncoder, colortype};

/// Decodes and returns the heights, with the type and channel reported.
fn heights(bytes: &[u8], scale: f64, channel: Option<&str>) -> (Vec<f32>, String, String) {
    let options = HeightMapOptions { height_scale: scale, channel: channel.map(str::to_owned), ..options() };
    let map = decode_height_map(bytes, &options).unwrap();
    assert_eq!((map.field.grid().width, map.field.grid().height), (3, 2));
    (map.field.samples().to_vec(), map.source.sample_type, map.source.channel)
}

fn png<P: Pixel>(samples: Vec<P::Subpixel>) -> Vec<u8>
where
    DynamicImage: From<ImageBuffer<P, Vec<P::Subpixel>>>,
{
    let mut bytes = Cursor::new(Vec::new());
    let image = ImageBuffer::<P, _>::from_vec(3, 2, samples).unwrap();
    DynamicImage::from(image).write_to(&mut bytes, ImageFormat::Png).unwrap();
    bytes.into_inner()
}

/// Repeats each value by the pattern: `v` stands for itself.
fn spread<T: Copy>(values: [T; 6], pattern: impl Fn(T) -> Vec<T>) -> Vec<T> {
    values.into_iter().flat_map(pattern).collect()
}

#[test]
fn png_depths_and_colours() {
    let (small, large) = ([0_u8, 1, 2, 127, 254, 255], [0_u16, 1, 255, 256, 40000, 65535]);
    let (small_f, large_f) = (small.map(f32::from).to_vec(), large.map(f32::from).to_vec());
    let is = |bytes: &[u8], scale, expected: &[f32], sample_type: &str, channel: &str| {
        assert_eq!(heights(bytes, scale, None), (expected.to_vec(), sample_type.into(), channel.into()));
    };
    is(&png::<Luma<u8>>(small.to_vec()), 255.0, &small_f, "u8", "Y");
    is(&png::<Luma<u16>>(large.to_vec()), 65535.0, &large_f, "u16", "Y");
    is(&png::<LumaA<u8>>(spread(small, |v| vec![v, 9])), 255.0, &small_f, "u8", "Y");
    is(&png::<LumaA<u16>>(spread(large, |v| vec![v, 9])), 65535.0, &large_f, "u16", "Y");
    is(&png::<Rgb<u8>>(spread(small, |v| vec![v, v, v])), 255.0, &small_f, "u8", "R=G=B");
    is(&png::<Rgba<u16>>(spread(large, |v| vec![v, v, v, 9])), 65535.0, &large_f, "u16", "R=G=B");

    let rgba = png::<Rgba<u16>>(spread(large, |v| vec![1, 2, v, 4]));
    assert_eq!(heights(&rgba, 65535.0, Some("B")), (large_f, "u16".into(), "B".into()));
    assert_eq!(heights(&rgba, 65535.0, Some("A")).0, [4.0; 6]);
}

#[test]
fn tiff_types_and_compressions() {
    macro_rules! check {
        ($color:ty, $name:literal, $full:expr, $values:expr) => {
            for (name, compression) in [
                ("none", Compression::Uncompressed),
                ("LZW", Compression::Lzw),
                ("deflate", Compression::Deflate(DeflateLevel::Balanced)),
                ("PackBits", Compression::Packbits),
            ] {
                let values = $values;
                let mut bytes = Cursor::new(Vec::new());
                let mut encoder = TiffEncoder::new(&mut bytes).unwrap().with_compression(compression);
                encoder.write_image::<$color>(3, 2, &values).unwrap();
                let expected = values.map(|v| f64::from(v) as f32).to_vec();
                assert_eq!(heights(bytes.get_ref(), $full, None), (expected, $name.into(), "Y".into()), "{name}");
            }
        };
    }
    check!(colortype::Gray8, "u8", 255.0, [0_u8, 1, 2, 127, 254, 255]);
    check!(colortype::Gray16, "u16", 65535.0, [0_u16, 1, 255, 256, 40000, 65535]);
    check!(colortype::Gray32, "u32", f64::from(u32::MAX), [0_u32, 1, 65536, 1 << 31, 99, u32::MAX]);
    check!(colortype::GrayI8, "i8", 127.0, [0_i8, 1, -1, 127, -128, 50]);
    check!(colortype::GrayI16, "i16", 32767.0, [0_i16, 1, -1, 32767, -32768, 500]);
    check!(colortype::GrayI32, "i32", f64::from(i32::MAX), [0_i32, 1, -1, i32::MAX, i32::MIN, 500]);
    check!(colortype::Gray32Float, "f32", 1.0, [0.1_f32, -2.5, 1e-40, f32::MAX, f32::MIN, -0.0]);
    check!(colortype::Gray64Float, "f64", 1.0, [0.1_f64, -2.5, 1e-40, 1e30, -7.0, 1.0 / 3.0]);
}

#[test]
fn exr_types_and_layers() {
    use exr::prelude::*;
    let write = |channels: Vec<(&str, FlatSamples)>, encoding: Encoding| {
        let list = channels.into_iter().map(|(name, samples)| AnyChannel::new(name, samples)).collect();
        let layer = Layer::new((3, 2), LayerAttributes::default(), encoding, AnyChannels::sort(list));
        let mut bytes = Cursor::new(Vec::new());
        Image::from_layer(layer).write().to_buffered(&mut bytes).unwrap();
        bytes.into_inner()
    };
    let values = [0.5_f32, -2.0, 1024.0, 0.25, 8.0, -0.125];
    let (f32s, f16s) = (FlatSamples::F32(values.to_vec()), FlatSamples::F16(values.map(f16::from_f32).to_vec()));
    for encoding in [Encoding::UNCOMPRESSED, Encoding::FAST_LOSSLESS, Encoding::SMALL_LOSSLESS] {
        let bytes = write(vec![("relief", f32s.clone())], encoding);
        assert_eq!(heights(&bytes, 1.0, None), (values.to_vec(), "f32".into(), "relief".into()));
        let other = FlatSamples::U32(vec![0, 1, 2, 3, 4, u32::MAX]);
        let bytes = write(vec![("Y", f16s.clone()), ("Z", other)], encoding);
        assert_eq!(heights(&bytes, 1.0, None), (values.to_vec(), "f16".into(), "Y".into()));
        assert_eq!(
            heights(&bytes, f64::from(u32::MAX), Some("Z")),
            (vec![0.0, 1.0, 2.0, 3.0, 4.0, u32::MAX as f32], "u32".into(), "Z".into())
        );
    }
}

#[test]
fn npy_types_and_orders() {
    fn write<T: npyz::AutoSerialize>(order: npyz::Order, values: [T; 6]) -> Vec<u8> {
        let mut bytes = Vec::new();
        let options = npyz::WriteOptions::new().default_dtype().shape(&[2, 3]).order(order);
        let mut writer = options.writer(&mut bytes).begin_nd().unwrap();
        writer.extend(values).unwrap();
        writer.finish().unwrap();
        bytes
    }
    macro_rules! check {
        ($name:literal, $full:expr, $values:expr) => {
            let values = $values;
            let [a, b, c, d, e, f] = values.map(|v| f64::from(v) as f32);
            let rows = heights(&write(npyz::Order::C, values), $full, None);
            assert_eq!(rows, (vec![a, b, c, d, e, f], $name.into(), "Y".into()));
            let columns = heights(&write(npyz::Order::Fortran, values), $full, None);
            assert_eq!(columns.0, [a, c, e, b, d, f]);
        };
    }
    check!("u8", 255.0, [0_u8, 1, 2, 127, 254, 255]);
    check!("u16", 65535.0, [0_u16, 1, 255, 256, 40000, 65535]);
    check!("u32", f64::from(u32::MAX), [0_u32, 1, 65536, 1 << 31, 99, u32::MAX]);
    check!("i8", 127.0, [0_i8, 1, -1, 127, -128, 50]);
    check!("i16", 32767.0, [0_i16, 1, -1, 32767, -32768, 500]);
    check!("i32", f64::from(i32::MAX), [0_i32, 1, -1, i32::MAX, i32::MIN, 500]);
    check!("f32", 1.0, [0.1_f32, -2.5, 1e-40, f32::MAX, f32::MIN, -0.0]);
    check!("f64", 1.0, [0.1_f64, -2.5, 1e-40, 1e30, -7.0, 1.0 / 3.0]);
}

#[test]
fn npy_byte_orders() {
    for (descr, data) in [
        ("<f2", f16::from_f32(1.5).to_le_bytes().to_vec()),
        (">f2", f16::from_f32(1.5).to_be_bytes().to_vec()),
        ("<f4", 1.5_f32.to_le_bytes().to_vec()),
        (">f4", 1.5_f32.to_be_bytes().to_vec()),
        ("<f8", 1.5_f64.to_le_bytes().to_vec()),
        (">f8", 1.5_f64.to_be_bytes().to_vec()),
    ] {
        let map = decode_height_map(&common::npy(descr, false, 1, 1, &data), &options()).unwrap();
        assert_eq!(map.field.samples(), [1.5], "{descr}");
    }
    for (descr, data) in [("<u2", [1, 2]), (">u2", [2, 1]), ("<i2", [1, 2]), (">i2", [2, 1])] {
        let map = decode_height_map(&common::npy(descr, false, 1, 1, &data), &options()).unwrap();
        assert_eq!(map.source.raw_range, (513.0, 513.0), "{descr}");
    }
}
