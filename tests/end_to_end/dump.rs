//! Tables in formats that other programs read, held against the definition of a horizon.

use std::io::Cursor;

use barchan_bakers::horizon::{Azimuths, HorizonParams, HorizonPoint, Method, reference};
use barchan_field::{Edge, Grid, HeightField, LengthUnit, Spacing};
use exr::prelude::{FlatSamples, ReadChannels, ReadLayers};
use image::{ImageFormat, ImageReader};

use crate::support::{Array, Place, noise, npy};

const WIDTH: u32 = 14;
const HEIGHT: u32 = 11;
const RADIUS: f64 = 5.0;

/// A map without a pattern, baked into `map.barchan`.
fn baked(encoding: &str, directions: u32) -> Place {
    let place = Place::with("map.npy", npy(WIDTH as usize, &noise(WIDTH as usize, HEIGHT as usize)));
    let flags = "--edge wrap --spacing 0.5,0.75 --radius 5";
    place.ok(&format!("bake map.npy {flags} --encoding {encoding} --directions {directions}"));
    place
}

/// The truth about it, `[direction][row][column]`.
fn truth(directions: u32) -> Vec<HorizonPoint> {
    let spacing = Spacing::new(0.5, 0.75).unwrap();
    let grid = Grid { width: WIDTH, height: HEIGHT, spacing, unit: LengthUnit::SceneUnit, edge: Edge::Wrap };
    let field = HeightField::new(grid, noise(WIDTH as usize, HEIGHT as usize)).unwrap();
    let params = HorizonParams {
        azimuths: Azimuths::full_circle(directions),
        radius: RADIUS,
        distance: true,
        method: Method::default(),
    };
    let texels = (0..HEIGHT).flat_map(|row| (0..WIDTH).map(move |column| (column, row)));
    (0..directions)
        .flat_map(|direction| texels.clone().map(move |(column, row)| (direction, column, row)))
        .map(|(direction, column, row)| reference::horizon(&field, &params, direction, column, row))
        .collect()
}

/// The greatest error that a table of `map.barchan` states, in its unit.
fn stated_error(place: &Place, table: &str) -> f64 {
    let inspected = place.json("inspect map.barchan");
    let section = inspected["sections"].as_array().unwrap().iter().find(|section| section["name"] == table).unwrap();
    section["table"]["worst_case_error"].as_f64().unwrap()
}

#[test]
fn a_horizon_dumped_as_npy_holds_the_slopes_of_the_definition() {
    // Along the axes a sweep passes through texel centres, so it is exact: what is left is the encoding's error.
    let truth = truth(4);
    for encoding in ["f32", "f16", "u8"] {
        let place = baked(encoding, 4);
        let slopes = place.array("map.barchan", "horizon");
        assert_eq!(slopes.shape, [4, HEIGHT.into(), WIDTH.into()]);
        let tolerance = stated_error(&place, "horizon") + 1e-6;
        for (slope, point) in slopes.values.iter().zip(&truth) {
            let error = f64::from(*slope).atan() - point.slope.atan();
            assert!(error.abs() <= tolerance, "{encoding}: {slope} for {point:?}, tolerance {tolerance}");
        }
    }
}

#[test]
fn oblique_horizons_are_near_the_definition() {
    let place = baked("f32", 16);
    let slopes = place.array("map.barchan", "horizon");
    let errors = slopes
        .values
        .iter()
        .zip(truth(16))
        .map(|(slope, point)| (f64::from(*slope).atan() - point.slope.atan()).to_degrees());
    let stats = barchan_metrics::ErrorStats::of(errors);
    assert!(stats.rms() < 0.1, "{} degrees RMS", stats.rms());
    let stored = &place.json("inspect map.barchan")["provenance"]["horizon"]["accuracy"];
    let claimed = stored["stored_rms_degrees"].as_f64().unwrap();
    // The claim rests on a sample, and few texels hold most of the error.
    assert!((0.5..2.0).contains(&(claimed / stats.rms())), "{} is not what the file claims, {claimed}", stats.rms());
}

#[test]
fn a_distance_dumped_as_npy_is_in_the_length_unit() {
    let truth = truth(4);
    for encoding in ["f32", "f16", "u8"] {
        let place = baked(encoding, 4);
        let distances = place.array("map.barchan", "distance");
        assert_eq!(distances.shape, [4, HEIGHT.into(), WIDTH.into()]);
        let tolerance = stated_error(&place, "distance") + 1e-5;
        for (distance, point) in distances.values.iter().zip(&truth) {
            let error = f64::from(*distance) - point.distance;
            assert!(error.abs() <= tolerance, "{encoding}: {distance} for {point:?}, tolerance {tolerance}");
        }
    }
}

#[test]
fn one_layer_has_no_layer_axis() {
    let place = baked("f16", 8);
    let all = place.array("map.barchan", "horizon");
    place.ok("dump map.barchan horizon --layer 5 --format npy -o layer.npy");
    let layer = Array::read(&place.read("layer.npy"));
    assert_eq!(layer.shape, [u64::from(HEIGHT), WIDTH.into()]);
    assert_eq!(layer.values, all.layer(5));
}

#[test]
fn heights_are_dumped_as_they_went_in() {
    let place = baked("f32", 4);
    let heights = place.array("map.barchan", "height");
    assert_eq!(
        heights,
        Array { shape: vec![HEIGHT.into(), WIDTH.into()], values: noise(WIDTH as usize, HEIGHT as usize) }
    );
}

#[test]
fn csv_reads_back_to_the_bit() {
    let place = baked("f16", 4);
    let slopes = place.array("map.barchan", "horizon");
    let csv = place.ok("dump map.barchan horizon --format csv");
    let mut lines = csv.lines();
    assert_eq!(lines.next(), Some("direction,azimuth_degrees,row,column,elevation_degrees,slope"));
    for (index, line) in lines.by_ref().enumerate() {
        let cells: Vec<_> = line.split(',').collect();
        let whole = |cell: &str| cell.parse::<usize>().unwrap();
        let (direction, row, column) = (whole(cells[0]), whole(cells[2]), whole(cells[3]));
        assert_eq!((direction * HEIGHT as usize + row) * WIDTH as usize + column, index);
        assert_eq!(cells[1].parse::<f64>().unwrap(), 90.0 * direction as f64);
        let slope: f32 = cells[5].parse().unwrap();
        assert_eq!(slope.to_bits(), slopes.values[index].to_bits());
        let tangent = cells[4].parse::<f64>().unwrap().to_radians().tan();
        assert!((tangent - f64::from(slope)).abs() <= 1e-6 * (1.0 + tangent * tangent), "{line}");
    }
    assert_eq!(csv.lines().count(), slopes.values.len() + 1);
    assert!(place.ok("dump map.barchan height --format csv").starts_with("row,column,height\n0,0,"));
    let distances = place.ok("dump map.barchan distance --format csv");
    assert!(distances.starts_with("direction,azimuth_degrees,row,column,distance\n0,0,0,0,"));
}

#[test]
fn text_shows_degrees_under_a_heading_per_direction() {
    let place = baked("f32", 4);
    let slopes = place.array("map.barchan", "horizon");
    let text = place.ok("dump map.barchan horizon");
    let (headings, rows): (Vec<_>, Vec<_>) = text.lines().partition(|line| line.starts_with('#'));
    assert_eq!(headings[1], "# horizon elevation in degrees, direction 1, azimuth 90°, 14 × 11");
    let degrees = rows.iter().flat_map(|row| row.split_whitespace()).map(|cell| cell.parse::<f64>().unwrap());
    assert_eq!(degrees.clone().count(), slopes.values.len());
    for (degrees, slope) in degrees.zip(&slopes.values) {
        assert!((degrees - f64::from(*slope).atan().to_degrees()).abs() <= 0.006, "{degrees} for slope {slope}");
    }
}

#[test]
fn exr_has_a_channel_of_radians_per_direction() {
    let place = baked("f16", 12);
    let slopes = place.array("map.barchan", "horizon");
    place.ok("dump map.barchan horizon --format exr -o map.exr");
    let image = exr::prelude::read().no_deep_data().largest_resolution_level().all_channels().first_valid_layer();
    let image = image.all_attributes().from_file(place.path("map.exr")).unwrap();
    assert_eq!((image.layer_data.size.0, image.layer_data.size.1), (WIDTH as usize, HEIGHT as usize));
    let channels = &image.layer_data.channel_data.list;
    assert_eq!(channels.len(), 12);
    for (direction, channel) in channels.iter().enumerate() {
        assert_eq!(channel.name.to_string(), format!("horizon.{direction:04}"));
        let FlatSamples::F32(radians) = &channel.sample_data else { panic!("not f32") };
        let tangents = radians.iter().map(|radians| f64::from(*radians).tan() as f32);
        assert!(tangents.eq(slopes.layer(direction).iter().copied()), "direction {direction}");
    }
    place.ok("dump map.barchan height --format exr -o height.exr");
    place.ok("bake height.exr --encoding f32 --only height -o again.barchan");
    assert_eq!(place.array("again.barchan", "height"), place.array("map.barchan", "height"));
}

#[test]
fn png_is_a_contact_sheet_over_the_range_of_the_table() {
    let place = baked("f32", 5);
    let distances = place.array("map.barchan", "distance");
    place.ok("dump map.barchan distance --format png -o map.png");
    let sheet = ImageReader::with_format(Cursor::new(place.read("map.png")), ImageFormat::Png).decode().unwrap();
    let sheet = sheet.as_luma16().expect("16-bit grey");
    assert_eq!(sheet.dimensions(), (3 * WIDTH, 2 * HEIGHT));
    let (least, greatest) = distances.values.iter().fold((f32::MAX, f32::MIN), |(l, g), &v| (l.min(v), g.max(v)));
    for (index, &distance) in distances.values.iter().enumerate() {
        let index = index as u32;
        let (layer, row, column) = (index / (WIDTH * HEIGHT), index / WIDTH % HEIGHT, index % WIDTH);
        let grey = sheet.get_pixel(layer % 3 * WIDTH + column, layer / 3 * HEIGHT + row).0[0];
        let found = least + (greatest - least) * f32::from(grey) / 65535.0;
        assert!((found - distance).abs() <= (greatest - least) / 65535.0, "layer {layer}, row {row}, column {column}");
    }
}

#[test]
fn a_packed_file_dumps_what_a_raw_one_does() {
    let place = baked("f16", 4);
    let raw = place.array("map.barchan", "horizon");
    place.ok("bake map.npy --edge wrap --spacing 0.5,0.75 --radius 5 --directions 4 --encoding f16 --compression zstd");
    assert_eq!(place.array("map.barchan", "horizon"), raw);
}

#[test]
fn what_is_asked_for_must_be_there() {
    let place = baked("f16", 4);
    assert_eq!(
        place.fails(1, "dump map.barchan horizon --layer 4"),
        "map.barchan: --layer is 4; horizon has layers 0 to 3"
    );
    assert_eq!(place.fails(1, "dump map.barchan horizon --mip 1"), "map.barchan: --mip is 1; horizon has mips 0 to 0");
    assert_eq!(
        place.fails(1, "dump map.barchan"),
        "map.barchan: the file has height, horizon, distance, sky_visibility and bent_normal; name one of them"
    );
    let only_text = "-o is missing: only text and csv go to stdout, and not with --json";
    assert_eq!(place.fails(1, "dump map.barchan height --format npy"), only_text);
    assert_eq!(place.run("--json dump map.barchan height").message(), only_text);
}

/// Every table of a small curved scene, in `map.barchan`.
fn every_table() -> Place {
    let place = Place::with("map.npy", npy(WIDTH as usize, &noise(WIDTH as usize, HEIGHT as usize)));
    place.write(
        "map.ron",
        "(source: HeightMap(path: \"map.npy\"), edge: wrap, horizon: (directions: 6, radius: 5.0, encoding: f32),
        scene: (curvature: (0.0, 0.1), ambient_light: true, area_lights: true),
        distance: (encoding: f32), curved: (points: 3, encoding: f32), sky: (encoding: f32))",
    );
    place.ok("bake map.ron");
    place
}

#[test]
fn further_points_have_an_axis_of_their_own_and_lie_below_the_horizon() {
    let place = every_table();
    let (slopes, further) = (place.array("map.barchan", "horizon"), place.array("map.barchan", "swept_horizon"));
    assert_eq!(further.shape, [2, 6, HEIGHT.into(), WIDTH.into()]);
    assert!(further.values.iter().zip(slopes.values.iter().cycle()).all(|(point, flat)| *point <= flat + 1e-4));
    let distances = place.array("map.barchan", "swept_distance");
    assert!(distances.values.iter().all(|distance| (0.0..=5.0).contains(distance)));
    let csv = place.ok("dump map.barchan swept_horizon --layer 7 --format csv");
    let lines: Vec<_> = csv.lines().take(2).collect();
    assert_eq!(lines[0], "point,direction,azimuth_degrees,row,column,elevation_degrees,slope");
    assert!(lines[1].starts_with("1,1,60,0,0,"), "{}", lines[1]);
    let text = place.ok("dump map.barchan swept_distance --layer 7");
    assert!(text.starts_with("# swept horizon distance in units, point 1, direction 1, azimuth 60°, 14 × 11\n"));
}

#[test]
fn a_vector_is_three_numbers_and_a_colour() {
    let place = every_table();
    let bent = place.array("map.barchan", "bent_normal");
    assert_eq!(bent.shape, [HEIGHT.into(), WIDTH.into(), 3]);
    for normal in bent.values.chunks_exact(3) {
        let length = normal.iter().map(|component| component * component).sum::<f32>();
        assert!((length - 1.0).abs() < 1e-5 && normal[2] >= 0.0, "{normal:?}");
    }
    place.ok("dump map.barchan bent_normal --format png -o bent.png");
    let picture = ImageReader::with_format(Cursor::new(place.read("bent.png")), ImageFormat::Png).decode().unwrap();
    let picture = picture.as_rgb16().expect("16 bits of red, green and blue");
    for (pixel, normal) in picture.pixels().zip(bent.values.chunks_exact(3)) {
        for (sample, component) in pixel.0.iter().zip(normal) {
            assert!((f32::from(*sample) / 32767.5 - 1.0 - component).abs() < 4e-5);
        }
    }
    place.ok("dump map.barchan aperture_cone --format png -o cone.png");
    let cone = ImageReader::with_format(Cursor::new(place.read("cone.png")), ImageFormat::Png).decode().unwrap();
    assert!(cone.as_rgba16().is_some());
    let csv = place.ok("dump map.barchan aperture_cone --format csv");
    assert!(csv.starts_with("row,column,u,v,height,cosine_of_half_angle\n0,0,"));
    assert!(
        place.ok("dump map.barchan bent_normal").starts_with("# bent normal, u, v, height of each texel, 14 × 11\n")
    );
}

#[test]
fn a_share_of_the_sky_is_as_bright_as_it_is_large() {
    let place = every_table();
    let shares = place.array("map.barchan", "sky_visibility");
    place.ok("dump map.barchan sky_visibility --format png -o sky.png");
    let picture = ImageReader::with_format(Cursor::new(place.read("sky.png")), ImageFormat::Png).decode().unwrap();
    for (pixel, share) in picture.as_luma16().unwrap().pixels().zip(&shares.values) {
        assert!((f32::from(pixel.0[0]) / 65535.0 - share).abs() < 2e-5);
    }
}

#[test]
fn exr_has_a_channel_per_number() {
    let place = every_table();
    place.ok("dump map.barchan bent_normal --format exr -o bent.exr");
    let image = exr::prelude::read().no_deep_data().largest_resolution_level().all_channels().first_valid_layer();
    let image = image.all_attributes().from_file(place.path("bent.exr")).unwrap();
    let names: Vec<_> = image.layer_data.channel_data.list.iter().map(|channel| channel.name.to_string()).collect();
    assert_eq!(names, ["bent_normal.height", "bent_normal.u", "bent_normal.v"]);
}
