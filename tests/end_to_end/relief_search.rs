//! Tables for relief search: baked, shown, dumped and compared.

use std::io::Cursor;

use exr::prelude::{ReadChannels, ReadLayers};

use crate::support::{Array, Place, noise, npy};

const FLAGS: &str = "--edge wrap --only height,hemisphere,cone_map,maximum_mip --rings 3 --azimuths 4 --size 5,11";

/// A map of 14 × 11 texels without a pattern, baked into `map.barchan`.
fn baked(more: &str) -> Place {
    let place = Place::with("map.npy", npy(14, &noise(14, 11)));
    place.ok(&format!("bake map.npy {FLAGS} {more}"));
    place
}

#[test]
fn a_scene_with_relief_mapping_says_what_it_bakes_and_how_near_rays_start() {
    let place = Place::with(
        "ripples.ron",
        "(
            source: Shape(shape: Ripples(amplitude: 2.0, waves_u: 3, waves_v: 1), width: 40, height: 24),
            edge: wrap, horizon: (directions: 8, radius: 6.0),
            scene: (relief_mapping: (least_elevation_degrees: 20, arc: (0, 90), search: maximum_mip)),
            hemisphere: (rings: 3, azimuths: 4, size: (10, 8)),
        )",
    );
    let words = place.ok("bake ripples.ron");
    for line in [
        "\nhemisphere     R8_UNORM × 3 rings × 4 azimuths, ",
        ": starts rays where none has hit before\n",
        "\nmaximum_mip    R16_SFLOAT × 6 levels, ",
        ": the search is by maximum mips\n",
        "\nleft out       cone_map and relaxed_cone_map, saving 3.8 KiB: the search is by maximum mips\n",
        "; none beyond its hit (4096 rays)\n",
        " Mray/s on ",
    ] {
        assert!(words.contains(line), "{line}\n{words}");
    }
    let words = place.ok("inspect ripples.barchan");
    for line in [
        "10 × 8 texels of 4 × 3 units × 3 rings × 4 azimuths from 0° to 90°, R8_UNORM, repeat / repeat\n",
        "               conservative, rings to 70° from the normal by squared_tangents\n",
        "               depth 0 at 2 units, depth 1 at -2 units\n",
        "provenance     hemisphere-conservative-1 conservative, 3 rings to 70° by squared_tangents, 4 azimuths from 0° to 90°\n",
        "provenance     maximum-mip-1\n",
    ] {
        assert!(words.contains(line), "{line}\n{words}");
    }
    assert_eq!(place.json("validate ripples.barchan")["findings"], serde_json::json!([]));
    let sections = &place.json("inspect ripples.barchan")["sections"];
    let directions = serde_json::json!({
        "rings": 3, "azimuths": 4, "ring_spacing": "squared_tangents", "max_polar_degrees": 70.0,
        "depth_mode": "conservative",
    });
    assert_eq!(sections[2]["table"]["directions"], directions);
    assert_eq!(sections[0]["table"].get("directions"), None);
}

#[test]
fn depths_are_dumped_by_ring_and_azimuth() {
    let place = baked("--encoding f32");
    let all = place.array("map.barchan", "hemisphere");
    assert_eq!(all.shape, [3, 4, 11, 5]);
    assert!(all.values.iter().all(|depth| (0.0..=1.0).contains(depth)));
    place.ok("dump map.barchan hemisphere --layer 6 --format npy -o one.npy");
    let one = Array::read(&place.read("one.npy"));
    assert_eq!((&one.shape, &one.values[..]), (&vec![11, 5], &all.values[6 * 55..7 * 55]));
    let text = place.ok("dump map.barchan hemisphere --layer 6");
    // Ring 1 of 3 to 80°: its tangent is a ninth of the greatest.
    assert!(text.starts_with("# hemisphere depth, ring 1 from 32.22°, direction 2, azimuth 180°, 5 × 11\n"), "{text}");
    let csv = place.ok("dump map.barchan hemisphere --format csv");
    let mut lines = csv.lines();
    assert_eq!(lines.next(), Some("ring,polar_degrees,direction,azimuth_degrees,row,column,depth"));
    assert_eq!(lines.next(), Some(&*format!("0,0,0,0,0,0,{}", all.values[0])));
    assert_eq!(csv.lines().count(), 1 + 12 * 55);
    let said = place.ok("dump map.barchan hemisphere --format png -o depths.png");
    let words = "12 layers of 5 × 11, 16-bit grey from the top of the relief, black, to its bottom\n";
    assert!(said.ends_with(words), "{said}");
}

#[test]
fn cones_are_two_channels() {
    let place = baked("--encoding f32");
    let cones = place.array("map.barchan", "cone_map");
    assert_eq!(cones.shape, [11, 14, 2]);
    assert!(place.ok("dump map.barchan cone_map").starts_with("# cone map, depth, ratio of each texel, 14 × 11\n"));
    assert!(place.ok("dump map.barchan cone_map --format csv").starts_with("row,column,depth,ratio\n0,0,"));
    place.ok("dump map.barchan cone_map --format exr -o cones.exr");
    let image = exr::prelude::read().no_deep_data().largest_resolution_level().all_channels().first_valid_layer();
    let image = image.all_attributes().from_buffered(Cursor::new(place.read("cones.exr"))).unwrap();
    let names: Vec<_> = image.layer_data.channel_data.list.iter().map(|channel| channel.name.to_string()).collect();
    assert_eq!(names, ["cone_map.depth", "cone_map.ratio"]);
    place.ok("dump map.barchan cone_map --format png -o cones.png");
    let picture = image::load_from_memory(&place.read("cones.png")).unwrap().into_rgb16();
    assert_eq!(picture.dimensions(), (14, 11));
    for (texel, pixel) in cones.values.chunks_exact(2).zip(picture.pixels()) {
        let depth = (65535.0 * f64::from(texel[0])).round() as u16;
        assert_eq!((pixel.0[0], pixel.0[2]), (depth, 0));
    }
}

#[test]
fn levels_are_dumped_one_by_one() {
    let place = baked("--encoding f32");
    let finest = place.array("map.barchan", "maximum_mip");
    assert_eq!(finest.shape, [11, 14]);
    let greatest = finest.values.iter().copied().fold(f32::MIN, f32::max);
    for (mip, shape) in [(1, [5, 7]), (2, [2, 3]), (3, [1, 1])] {
        let said = place.ok(&format!("dump map.barchan maximum_mip --mip {mip} --format npy -o level.npy"));
        let (height, width) = (shape[0], shape[1]);
        let words = format!("dumped    maximum_mip to level.npy: level {mip}, {width} × {height}, the length unit\n");
        assert_eq!(said, words);
        let level = Array::read(&place.read("level.npy"));
        assert_eq!(level.shape, shape);
        assert_eq!(level.values.iter().copied().fold(f32::MIN, f32::max), greatest);
    }
    let text = place.ok("dump map.barchan maximum_mip --mip 3");
    assert!(text.starts_with("# maximum height in units, level 3, 1 × 1\n"), "{text}");
    let says = |words: &str| place.fails(1, &format!("dump map.barchan {words}"));
    assert_eq!(says("maximum_mip --mip 4"), "map.barchan: --mip is 4; maximum_mip has mips 0 to 3");
    assert_eq!(says("hemisphere --mip 1"), "map.barchan: --mip is 1; hemisphere has mips 0 to 0");
    assert_eq!(says("hemisphere --layer 12"), "map.barchan: --layer is 12; hemisphere has layers 0 to 11");
}

#[test]
fn tables_of_other_directions_are_not_compared_and_values_are_placed() {
    let place = baked("--encoding f32");
    assert!(place.ok("compare map.barchan map.barchan").contains("\nmaximum_mip    RMS 0 units, at most 0 units\n"));
    place.ok(&format!("bake map.npy {FLAGS} --depth-mode nearest -o nearest.barchan"));
    let words = place.run("compare map.barchan nearest.barchan").stdout;
    let modes = "grid of directions is 3 rings of squared_tangents to 80°, conservative in one and 3 rings of squared_tangents \
                 to 80°, nearest in the other";
    assert!(words.contains(modes), "{words}");
    let mut heights = noise(14, 11);
    heights[5 * 14 + 9] -= 0.125;
    place.write("other.npy", npy(14, &heights));
    place.ok(&format!("bake other.npy {FLAGS} --encoding f32"));
    let run = place.run("compare map.barchan other.barchan --json");
    assert_eq!(run.code, Some(3));
    let report = crate::support::parse_json(&run.stdout);
    let mip = report["tables"].as_array().unwrap().iter().find(|table| table["table"] == "maximum_mip").unwrap();
    for place in ["first", "worst"] {
        let at = &mip["values"][place];
        assert!(at.is_null() || at["mip"].is_u64(), "{mip}");
    }
}

#[test]
fn flags_of_a_height_map_are_not_for_recipes() {
    let place = Place::with("r.ron", "(source: HeightMap(path: \"map.npy\"))");
    for flag in ["--rings 3", "--azimuths 4", "--size 5", "--depth-mode nearest"] {
        let name = flag.split(' ').next().unwrap();
        assert_eq!(
            place.fails(1, &format!("bake r.ron {flag}")),
            format!("{name} is for a height map without a recipe; set it in r.ron")
        );
    }
}
