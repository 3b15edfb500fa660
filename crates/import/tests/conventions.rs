//! Scale, offset, no data, fill, channels: what the crate's documentation promises, and the words of its refusals.

mod common;

use std::path::Path;

use barchan_field::{Edge, LengthUnit, Spacing};
use barchan_import::{Fill, HeightMapOptions, Integers, decode_height_map, read_height_map};
use common::{file, npy, npy_f32, npy_with, options};

fn message(bytes: &[u8], options: &HeightMapOptions) -> String {
    decode_height_map(bytes, options).unwrap_err().to_string()
}

fn heights(bytes: &[u8], options: &HeightMapOptions) -> Vec<f32> {
    decode_height_map(bytes, options).unwrap().field.samples().to_vec()
}

#[test]
fn a_height_is_rounded_once() {
    let (scale, offset) = (8848.86, -0.1);
    let bytes: Vec<u8> = (0..=u16::MAX).flat_map(u16::to_le_bytes).collect();
    let options = HeightMapOptions { height_scale: scale, height_offset: offset, ..options() };
    let found = heights(&npy("<u2", false, 256, 256, &bytes), &options);
    for (sample, height) in found.into_iter().enumerate() {
        assert_eq!(height, (sample as f64 / 65535.0 * scale + offset) as f32);
    }
}

#[test]
fn whole_metres_are_heights_when_integers_are_raw() {
    let bytes: Vec<u8> = (i16::MIN..=i16::MAX).flat_map(i16::to_le_bytes).collect();
    let file = npy("<i2", false, 256, 256, &bytes);
    let expected: Vec<f32> = (i16::MIN..=i16::MAX).map(f32::from).collect();
    assert_eq!(heights(&file, &HeightMapOptions { integers: Integers::Raw, ..options() }), expected);
    // Dividing by the full scale and multiplying by it again loses nothing either.
    assert_eq!(heights(&file, &HeightMapOptions { height_scale: 32767.0, ..options() }), expected);
}

#[test]
fn the_grid_is_the_callers() {
    let options = HeightMapOptions {
        spacing: Spacing::new(74.0, 93.0).unwrap(),
        unit: LengthUnit::Metre,
        edge: Edge::Wrap,
        ..options()
    };
    let map = decode_height_map(&npy_f32(3, &[0.0; 6]), &options).unwrap();
    let grid = map.field.grid();
    assert_eq!((grid.width, grid.height, grid.spacing), (3, 2, options.spacing));
    assert_eq!((grid.unit, grid.edge), (LengthUnit::Metre, Edge::Wrap));
}

#[test]
fn a_texel_without_a_height_is_refused() {
    let bytes = npy_f32(3, &[0.0, 1.0, 2.0, 3.0, f32::NAN, f32::INFINITY]);
    assert_eq!(
        message(&bytes, &options()),
        "the sample at column 1, row 1 is NaN (2 of 6 texels have no height); \
         `fill` as value(HEIGHT), lowest or nearest would accept it"
    );
    let bytes = npy_f32(3, &[0.0, 1.0, f32::NEG_INFINITY, 3.0, 4.0, 5.0]);
    assert!(message(&bytes, &options()).starts_with("the sample at column 2, row 0 is -inf (1 of 6 texels"));
    let options = HeightMapOptions { no_data: Some(5.0), ..options() };
    assert_eq!(
        message(&npy_f32(3, &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0]), &options),
        "the sample at column 2, row 1 is 5, which stands for no data (1 of 6 texels have no height); \
         `fill` as value(HEIGHT), lowest or nearest would accept it"
    );
}

#[test]
fn fills() {
    let bytes = npy_f32(4, &[f32::NAN, 1.0, 2.0, f32::NAN, -3.0, f32::NAN, f32::INFINITY, 7.0]);
    let filled = |fill, edge| {
        let options = HeightMapOptions { height_scale: 2.0, fill: Some(fill), edge, ..options() };
        let map = decode_height_map(&bytes, &options).unwrap();
        assert_eq!((map.source.filled, map.source.raw_range), (4, (-3.0, 7.0)));
        map.field.samples().to_vec()
    };
    assert_eq!(filled(Fill::Value(0.5), Edge::Clamp), [0.5, 2.0, 4.0, 0.5, -6.0, 0.5, 0.5, 14.0]);
    assert_eq!(filled(Fill::Lowest, Edge::Clamp), [-6.0, 2.0, 4.0, -6.0, -6.0, -6.0, -6.0, 14.0]);
    assert_eq!(filled(Fill::Nearest, Edge::Clamp), [2.0, 2.0, 4.0, 4.0, -6.0, 2.0, 4.0, 14.0]);
    let wrapped = decode_height_map(
        &npy_f32(4, &[f32::NAN, 1.0, 2.0, 3.0, f32::NAN, f32::NAN, f32::NAN, 4.0]),
        &HeightMapOptions { fill: Some(Fill::Nearest), edge: Edge::Wrap, ..options() },
    );
    assert_eq!(wrapped.unwrap().field.samples(), [1.0, 1.0, 2.0, 3.0, 4.0, 1.0, 2.0, 4.0]);
}

#[test]
fn a_recipe_names_a_fill() {
    for (text, fill) in [("value(-1.5)", Fill::Value(-1.5)), ("lowest", Fill::Lowest), ("nearest", Fill::Nearest)] {
        assert_eq!(ron::from_str::<Fill>(text), Ok(fill));
        assert_eq!(ron::to_string(&fill).unwrap(), text);
    }
}

#[test]
fn no_data_is_compared_before_scaling_and_in_the_samples_type() {
    let fill = Some(Fill::Value(9.0));
    // 0.1 is not an f32, and −3.4028235e38 is how some writers abbreviate f32's lowest.
    for (no_data, sample) in [(0.1, 0.1_f32), (-3.402_823_5e38, f32::MIN), (f64::from(0.1_f32), 0.1)] {
        let options = HeightMapOptions { no_data: Some(no_data), fill, height_scale: 0.5, ..options() };
        assert_eq!(heights(&npy_f32(2, &[sample, 4.0]), &options), [9.0, 2.0], "{no_data}");
    }
    // An integer sample is never taken for a number it is not.
    for (no_data, expected) in [(0.4, [0.0, 255.0]), (-9999.0, [0.0, 255.0]), (255.0, [0.0, 9.0])] {
        let options = HeightMapOptions { no_data: Some(no_data), fill, height_scale: 255.0, ..options() };
        assert_eq!(heights(&npy("|u1", false, 1, 2, &[0, 255]), &options), expected, "{no_data}");
    }
}

#[test]
fn nothing_to_go_by() {
    let options = HeightMapOptions { fill: Some(Fill::Value(0.0)), ..options() };
    assert_eq!(
        message(&npy_f32(2, &[f32::NAN, f32::NAN]), &options),
        "none of the 2 texels has a height (the first sample is NaN); at least one is needed"
    );
}

#[test]
fn a_height_beyond_f32_is_refused() {
    let options = HeightMapOptions { height_scale: f64::from(1 << 30), fill: Some(Fill::Lowest), ..options() };
    assert_eq!(
        message(&npy_f32(2, &[0.0, 1.0, 2.0, (1_u128 << 100) as f32]), &options),
        "the sample at column 1, row 1 is 1.2676506002282294e30, which makes a height of 1.361129467683754e39; \
         heights up to 3.4028234663852886e38 would be accepted"
    );
}

#[test]
fn options_are_checked_first() {
    for (options, expected) in [
        (HeightMapOptions { height_scale: f64::NAN, ..options() }, "`height_scale` is NaN; a finite number is needed"),
        (
            HeightMapOptions { height_offset: f64::INFINITY, ..options() },
            "`height_offset` is inf; a finite number is needed",
        ),
        (
            HeightMapOptions { fill: Some(Fill::Value(1e39)), ..options() },
            "`fill` is 1e39; a height within the range of f32 is needed",
        ),
    ] {
        assert_eq!(message(&npy_f32(1, &[0.0]), &options), expected);
    }
}

#[test]
fn channels() {
    let parts = file("parts.exr");
    let ask = |channel: &str| HeightMapOptions { channel: Some(channel.into()), ..options() };
    assert_eq!(decode_height_map(&parts, &ask("V")).unwrap().source.channel, "V");
    assert_eq!(
        message(&parts, &ask("Q")),
        "`channel` is `Q`, which the EXR file does not have; U, V (layer flow); Y (layer relief) would be accepted"
    );
    assert_eq!(
        message(&npy_f32(1, &[0.0]), &ask("R")),
        "`channel` is `R`, which the NPY file does not have; Y would be accepted"
    );
    let png = image::RgbImage::from_fn(4, 3, |x, y| image::Rgb([9, 9, if (x, y) == (1, 2) { 8 } else { 9 }]));
    let mut bytes = std::io::Cursor::new(Vec::new());
    png.write_to(&mut bytes, image::ImageFormat::Png).unwrap();
    assert_eq!(
        message(bytes.get_ref(), &options()),
        "the PNG image is in colour: at column 1, row 2, R, G and B are 9, 9 and 8; \
         name the `channel` that is the height"
    );
}

#[test]
fn the_path_leads_the_message_and_the_disk_is_told_from_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    std::fs::write(at("empty.png"), []).unwrap();
    std::fs::write(at("photo.png"), b"\xff\xd8\xff\xe0").unwrap();
    std::fs::write(at("text.exr"), b"hello").unwrap();
    std::fs::write(at("is-npy.tif"), npy_f32(1, &[3.0])).unwrap();
    let check = |path: &Path, is_io: bool, rest: &str| {
        let error = read_height_map(path, &options()).unwrap_err();
        assert_eq!(error.is_io(), is_io);
        assert_eq!(error.to_string(), format!("{}: {rest}", path.display()));
    };
    check(&at("none.png"), true, "there is no such file; a PNG, EXR, TIFF, NPY, OBJ, PLY or glTF file is needed");
    check(folder.path(), true, "this is a folder; a PNG, EXR, TIFF, NPY, OBJ, PLY or glTF file is needed");
    check(&at("empty.png"), false, "the file is empty; a PNG, EXR, TIFF or NPY file is needed");
    check(&at("photo.png"), false, "the file is a JPEG; a PNG, EXR, TIFF or NPY file is needed");
    check(
        &at("text.exr"),
        false,
        "the file is of an unknown format (it begins with 68 65 6c 6c 6f); a PNG, EXR, TIFF or NPY file is needed",
    );
    assert_eq!(read_height_map(&at("is-npy.tif"), &options()).unwrap().field.samples(), [3.0]);
}

#[test]
fn shapes_that_are_no_maps() {
    assert_eq!(
        message(&npy("<f4", false, 0, 4, &[]), &options()),
        "the NPY image is 4 × 0 texels; both sides must be from 1 to 4294967295"
    );
    assert_eq!(
        message(&npy("<f4", false, 2, 3, &[0; 23]), &options()),
        "the NPY file is damaged: its header promises 24 bytes of samples, and 23 follow"
    );
    assert_eq!(
        message(&npy_with("{'descr': '<f4', 'fortran_order': False, 'shape': (3, 4, 1)}", &[0; 48]), &options()),
        "the NPY file has an array of 3 dimensions (3 × 4 × 1); an array of rows × columns would be accepted"
    );
}
