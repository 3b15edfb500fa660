//! Files that other software wrote (`files/README.md`): every sample is as its formula says.

mod common;

use barchan_import::{DecodeError, Fill, Format, HeightMap, HeightMapOptions, decode_height_map};
use common::{file, options};

/// Loads a file with integer samples undone from their normalisation.
fn load(name: &str, full_scale: f64) -> HeightMap {
    decode_height_map(&file(name), &HeightMapOptions { height_scale: full_scale, ..options() }).expect(name)
}

/// The map is `width` × `height`, and the height at each column and row is as given.
fn expect(map: &HeightMap, [width, height]: [u32; 2], tolerance: f32, formula: impl Fn(usize, usize) -> f32) {
    let grid = map.field.grid();
    assert_eq!((grid.width, grid.height), (width, height));
    for (i, &h) in map.field.samples().iter().enumerate() {
        let (column, row) = (i % width as usize, i / width as usize);
        let expected = formula(column, row);
        assert!((h - expected).abs() <= tolerance, "{:?} at {column}, {row}: {h}, not {expected}", map.source);
    }
}

const SMALL: [u32; 2] = [7, 5];

fn u8_map(column: usize, row: usize) -> f32 {
    (7 * (7 * row + column)) as f32
}

fn u16_map(column: usize, row: usize) -> f32 {
    (1871 * (7 * row + column)) as f32
}

fn float_map(column: usize, row: usize) -> f32 {
    (7 * row + column) as f32 * 0.375 - 3.0
}

fn steps(column: usize, row: usize) -> f32 {
    (column / 8 + 2 * (row / 8)) as f32 / 8.0 - 3.0
}

#[test]
fn png() {
    expect(&load("grey16.png", 65535.0), SMALL, 0.0, u16_map);
    expect(&load("interlaced16.png", 65535.0), SMALL, 0.0, u16_map);
    expect(&load("grey4.png", 15.0), SMALL, 0.0, |column, row| ((7 * row + column) % 16) as f32);
    expect(&load("grey1.png", 1.0), SMALL, 0.0, |column, row| f32::from((7 * row + column).is_multiple_of(3)));
    expect(&load("palette_grey.png", 255.0), SMALL, 0.0, u8_map);

    let source = load("grey4.png", 1.0).source;
    assert_eq!((source.format, source.sample_type.as_str(), source.channel.as_str()), (Format::Png, "u4", "Y"));
    assert_eq!((source.raw_range, source.filled), ((0.0, 15.0), 0));
    assert_eq!(load("palette_grey.png", 1.0).source.channel, "R=G=B");
}

#[test]
fn tiff() {
    for name in ["f32_tiled_lzw_p3.tif", "f32_big_deflate_p3.tif", "f16_be.tif"] {
        expect(&load(name, 1.0), SMALL, 0.0, float_map);
    }
    expect(&load("u16_lzw_p2.tif", 65535.0), SMALL, 0.0, u16_map);
    expect(&load("u8_packbits.tif", 255.0), SMALL, 0.0, u8_map);
    expect(&load("rgba_planes_tiled.tif", 255.0), SMALL, 0.0, u8_map);
    expect(&load("ramp_tiled_lzw.tif", 1.0), [24, 20], 0.0, |column, row| (column + 2 * row) as f32 / 8.0 - 3.0);
    let alpha = HeightMapOptions { channel: Some("A".into()), height_scale: 255.0, ..options() };
    let alpha = decode_height_map(&file("rgba_planes_tiled.tif"), &alpha).unwrap();
    expect(&alpha, SMALL, 0.0, |column, row| 255.0 - u8_map(column, row));
}

#[test]
fn exr() {
    for name in ["half_zip.exr", "half_piz.exr", "half_pxr24.exr", "f32_piz.exr"] {
        expect(&load(name, 1.0), [64, 48], 0.0, steps);
    }
    expect(&load("half_rle.exr", 1.0), [64, 16], 0.0, steps);
    // DWA loses; OpenEXR's own decoder is off by as much, one last place of f16.
    expect(&load("half_dwaa.exr", 1.0), [64, 48], 0.001_953_125, steps);
    for name in ["tiled.exr", "half_dwaa_raw.exr", "window.exr", "rgb_grey.exr", "parts.exr"] {
        expect(&load(name, 1.0), SMALL, 0.0, float_map);
    }
    expect(&load("u32.exr", 65535.0), SMALL, 0.0, u16_map);
    assert_eq!(load("u32.exr", 1.0).source.sample_type, "u32");
    let second = HeightMapOptions { channel: Some("U".into()), ..options() };
    expect(&decode_height_map(&file("parts.exr"), &second).unwrap(), SMALL, 0.0, |x, y| -float_map(x, y));
}

#[test]
fn npy() {
    expect(&load("f32.npy", 1.0), SMALL, 0.0, float_map);
    expect(&load("f64_fortran_be.npy", 1.0), SMALL, 0.0, float_map);
    expect(&load("i16.npy", 32767.0), SMALL, 0.0, |column, row| u16_map(column, row) - 32000.0);
    assert_eq!(load("i16.npy", 1.0).source.raw_range, (-32000.0, 31614.0));
}

#[test]
fn the_gdal_tag_marks_no_data() {
    let bytes = file("gdal_nodata.tif");
    assert_eq!(
        decode_height_map(&bytes, &options()).unwrap_err(),
        DecodeError::NoHeight { column: 2, row: 1, value: -9999.0, count: 2, total: 35 }
    );
    let filled = decode_height_map(&bytes, &HeightMapOptions { fill: Some(Fill::Value(-5.0)), ..options() }).unwrap();
    assert_eq!((filled.source.filled, filled.source.raw_range), (2, (-3.0, 9.375)));
    let hole = |column, row| (column, row) == (2, 1) || (column, row) == (6, 4);
    expect(&filled, SMALL, 0.0, |column, row| if hole(column, row) { -5.0 } else { float_map(column, row) });
}

#[test]
fn what_is_refused_is_named() {
    for (name, message) in [
        ("zstd.tif", "the TIFF file has ZSTD compression; no compression, LZW, deflate or PackBits would be accepted"),
        (
            "half_b44.exr",
            "the EXR file has B44 compression; no, RLE, ZIP, PIZ, PXR24 or DWA compression would be accepted",
        ),
        (
            "i64.npy",
            "the NPY file has the dtype `<i8`; u1, u2, u4, i1, i2, i4, f2, f4 or f8, in either byte order, would be accepted",
        ),
    ] {
        assert_eq!(decode_height_map(&file(name), &options()).unwrap_err().to_string(), message);
    }
}
