//! Height maps without a recipe.

use std::io::Cursor;

use barchan_asset::{Asset, SectionKind};
use exr::prelude::{WritableImage, f16};
use image::{ImageBuffer, ImageFormat, Luma};

use crate::support::{Place, bumpy, npy};

/// The integer samples of a little map, 0 to 65535.
fn samples16() -> Vec<u16> {
    bumpy(12, 10).iter().map(|height| (height * 65535.0).round() as u16).collect()
}

fn png16() -> Vec<u8> {
    let image = ImageBuffer::<Luma<u16>, _>::from_raw(12, 10, samples16()).unwrap();
    let mut bytes = Cursor::new(Vec::new());
    image.write_to(&mut bytes, ImageFormat::Png).unwrap();
    bytes.into_inner()
}

fn tiff32() -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    let mut encoder = tiff::encoder::TiffEncoder::new(&mut bytes).unwrap();
    encoder.write_image::<tiff::encoder::colortype::Gray32Float>(12, 10, &bumpy(12, 10)).unwrap();
    bytes.into_inner()
}

fn exr16() -> Vec<u8> {
    let heights = bumpy(12, 10);
    let mut bytes = Cursor::new(Vec::new());
    let pixel = |at: exr::math::Vec2<usize>| (f16::from_f32(heights[at.1 * 12 + at.0]),);
    exr::prelude::Image::from_channels(
        (12, 10),
        exr::prelude::SpecificChannels::build().with_channel("Z").with_pixel_fn(pixel),
    )
    .write()
    .to_buffered(&mut bytes)
    .unwrap();
    bytes.into_inner()
}

#[test]
fn every_format_of_a_height_map_gives_the_same_heights() {
    let place = Place::with("a.npy", npy(12, &bumpy(12, 10)));
    place.write("b.png", png16());
    place.write("c.tif", tiff32());
    place.write("d.exr", exr16());
    for map in ["a.npy", "b.png", "c.tif", "d.exr"] {
        place.ok(&format!(
            "bake {map} --height-scale 3 --height-offset -1 --encoding f32 --directions 4 -o {map}.barchan"
        ));
        let heights = place.array(&format!("{map}.barchan"), "height");
        assert_eq!(heights.shape, [10, 12]);
        for (found, sample) in heights.values.iter().zip(bumpy(12, 10)) {
            // Sixteenths are exact but in 16-bit integers, which miss them by half a step at most.
            assert!((found - (3.0 * sample - 1.0)).abs() <= 3.0 * 0.5 / 65535.0 + 1e-6, "{map}: {found}, {sample}");
        }
    }
}

#[test]
fn the_content_tells_the_format_not_the_name() {
    let place = Place::with("map.tif", png16());
    assert!(place.json("bake map.tif --directions 4")["source"].as_str().unwrap().ends_with("(PNG u16)"));
}

#[test]
fn every_flag_reaches_the_file() {
    let place = Place::with("map.npy", npy(12, &bumpy(12, 10)));
    let flags = "--directions 6 --edge wrap --spacing 0.5,0.25 --unit centimetre --height-scale 2 --height-offset 1 \
                 --radius 1.5 --encoding u8 --compression zstd --channel Y --no-data 99 --fill nearest";
    place.ok(&format!("bake map.npy {flags}"));
    let inspected = place.json("inspect map.barchan");
    let [height, horizon, distance] = [0, 1, 2].map(|section| &inspected["sections"][section]);
    // Heights in bytes would be steps: they are halves at least.
    for (section, format) in [(height, "R16_SFLOAT"), (horizon, "R8_UNORM"), (distance, "R8_UNORM")] {
        let table = &section["table"];
        assert_eq!((&section["codec"], &table["format"]), (&"zstd".into(), &format.into()));
        assert_eq!((&table["spacing_u"], &table["spacing_v"]), (&0.5.into(), &0.25.into()));
        assert_eq!((&table["length_unit"], &table["wrap_u"]), (&"centimetre".into(), &"repeat".into()));
    }
    assert_eq!((&height["table"]["minimum"], &height["table"]["maximum"]), (&1.0.into(), &3.0.into()));
    assert_eq!((&horizon["table"]["layers"], &distance["table"]["layers"]), (&6.into(), &6.into()));
    assert_eq!(horizon["table"]["search_radius"], 1.5);
    let input = &inspected["provenance"]["input"]["height_map"];
    assert_eq!((&input["format"], &input["height_scale"]), (&"NPY f32".into(), &2.0.into()));
    assert_eq!(input["blake3"].as_str().map(str::len), Some(64));
    assert_eq!((&input["channel"], &input["no_data"], &input["fill"]), (&"Y".into(), &99.0.into(), &"nearest".into()));
    let recipe = &inspected["provenance"]["recipe"];
    assert_eq!((&recipe["edge"], &recipe["unit"]), (&"wrap".into(), &"centimetre".into()));
}

#[test]
fn integers_are_a_share_of_full_scale_or_raw() {
    let place = Place::with("map.png", png16());
    place.ok("bake map.png --height-scale 65535 --encoding f32 --directions 4 -o share.barchan");
    place.ok("bake map.png --integers raw --encoding f32 --directions 4 -o raw.barchan");
    let (share, raw) = (place.array("share.barchan", "height"), place.array("raw.barchan", "height"));
    assert_eq!(share.values, raw.values);
    assert!(raw.values.iter().any(|&height| height > 60000.0) && raw.values.iter().all(|height| height.fract() == 0.0));
}

#[test]
fn the_defaults_are_sensible() {
    let place = Place::with("map.npy", npy(12, &bumpy(12, 10)));
    let report = place.json("bake map.npy");
    assert_eq!((&report["grid"]["edge"], &report["grid"]["unit"]), (&"clamp".into(), &"units".into()));
    let tables: Vec<_> = report["tables"].as_array().unwrap().iter().map(|table| table["table"].as_str()).collect();
    assert_eq!(tables, ["height", "horizon", "distance", "sky_visibility", "bent_normal"].map(Some));
    assert_eq!(report["horizon"]["method"], "accurate");
    assert_eq!(report["tables"][0]["format"], "R16_SFLOAT");
    let horizon = &report["tables"][1];
    assert_eq!((&horizon["layers"], &horizon["format"]), (&32.into(), &"R8_UNORM".into()));
    // From anywhere on a clamped map everything is seen.
    let radius = report["horizon"]["radius"].as_f64().unwrap();
    assert_eq!(radius, 12_f64.hypot(10.0));
    assert_eq!(place.json("bake map.npy --edge wrap")["horizon"]["radius"], 12.0);
}

#[test]
fn missing_heights_are_filled_as_told_and_counted() {
    let mut heights = bumpy(12, 10);
    (heights[5], heights[30]) = (f32::NAN, -9999.0);
    let place = Place::with("map.npy", npy(12, &heights));
    for (fill, expected) in [("lowest", 0.0), ("0.75", 0.75), ("nearest", heights[4])] {
        let report = place.json(&format!(
            "bake map.npy --directions 4 --encoding f32 --no-data -9999 --fill {fill} -o filled.barchan"
        ));
        assert_eq!(report["filled_texels"], 2);
        assert_eq!(place.array("filled.barchan", "height").values[5], expected, "{fill}");
    }
    assert!(place.ok("bake map.npy --no-data -9999 --fill lowest").contains(" units, 2 texels filled\n"));
}

#[test]
fn the_file_opens_without_any_of_the_tools() {
    let place = Place::with("map.npy", npy(12, &bumpy(12, 10)));
    place.ok("bake map.npy --directions 4");
    let file = place.read("map.barchan");
    let asset = Asset::open(&file).unwrap();
    let kinds: Vec<_> = asset.sections().map(|section| section.kind()).collect();
    let expected = [
        SectionKind::HEIGHT,
        SectionKind::HORIZON,
        SectionKind::DISTANCE,
        SectionKind::SKY_VISIBILITY,
        SectionKind::BENT_NORMAL,
        SectionKind::PROVENANCE,
    ];
    assert_eq!(kinds, expected);
}
