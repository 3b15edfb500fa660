//! Pictures of relief seen from a side.

use serde_json::Value;

use crate::support::{Place, rgb};

const RELIEF: &str = "(
    source: Shape(
        shape: FractalTerrain(height: 9.0, hurst: 0.8, features_across: 3, octaves: 5, seed: 1), width: 48, height: 48,
    ),
    edge: wrap, scene: (relief_mapping: (least_elevation_degrees: 15.0)),
    hemisphere: (rings: 6, azimuths: 8, size: (16, 16), encoding: u8),
)";

/// All of the relief's tables but those of other searches.
fn baked() -> Place {
    let place = Place::new();
    place.bake(RELIEF);
    place
}

fn number(report: &Value, path: &str) -> f64 {
    report.pointer(path).and_then(Value::as_f64).unwrap_or_else(|| panic!("no {path} in {report}"))
}

#[test]
fn by_default_it_is_what_is_traced() {
    let place = baked();
    for flags in
        ["--eye-elevation 20", "--eye-azimuth 30", "--eye-elevation 60 --eye-azimuth -100", "--eye-elevation 90"]
    {
        let report = place.json(&format!("render out.barchan {flags} --elevation 25 --size 96 --compare -o seen.png"));
        assert_eq!((&report["search"], &report["start"]), (&"maximum_mip".into(), &"depth_map".into()));
        assert_eq!(number(&report, "/comparison/other_point_share"), 0.0, "{flags}");
        assert!(number(&report, "/comparison/max_depth_error") < 1e-6, "{flags}");
        assert!(number(&report, "/comparison/wrong_shadow_share") < 1e-3, "{flags}");
        assert_eq!(rgb(&place.read("seen.png")).dimensions(), (3 * 96 + 2 * 8, 72));
    }
}

#[test]
fn a_tile_that_repeats_fills_the_picture_however_low_the_eye_is() {
    let place = baked();
    for elevation in [2, 5, 20, 90] {
        let report = place.json(&format!("render out.barchan --eye-elevation {elevation} --size 32 -o seen.png"));
        assert_eq!(number(&report, "/seen_share"), 1.0, "{elevation}");
    }
}

#[test]
fn a_heat_map_stands_beside_that_of_linear_search_and_is_cooler() {
    let place = baked();
    let report = place.json("render out.barchan --eye-elevation 40 --size 96 --heat -o heat.png");
    let fetches = |path: &str| {
        number(&report, &format!("{path}/mean_height_fetches")) + number(&report, &format!("{path}/mean_table_fetches"))
    };
    assert!(2.0 * fetches("/view") < fetches("/heat/baseline"), "{report}");
    // The legend is below both.
    let (width, height) = rgb(&place.read("heat.png")).dimensions();
    assert!(width == 2 * 96 + 8 && height > 72, "{width} × {height}");
    assert_eq!((&report["width"], &report["height"]), (&width.into(), &height.into()));
}

#[test]
fn the_sky_is_dimmed_in_hollows_and_the_sun_by_shadows() {
    let place = baked();
    let lit = place.json("render out.barchan --eye-elevation 50 --elevation 12 --size 64 -o lit.png");
    assert!(number(&lit, "/sun/shadow_share") > 0.05 && number(&lit, "/mean_occlusion") > 0.02, "{lit}");
    let high = place.json("render out.barchan --eye-elevation 50 --elevation 80 --size 64 -o lit.png");
    assert!(number(&high, "/sun/shadow_share") < number(&lit, "/sun/shadow_share"));
    let clouds = place.json("render out.barchan --eye-elevation 50 --ambient --size 64 -o clouds.png");
    assert_eq!((&clouds["mean_occlusion"], &clouds["sun"]), (&lit["mean_occlusion"], &Value::Null));
}

#[test]
fn a_ball_fills_its_circle_and_a_clamped_tile_its_own_outline() {
    let place = baked();
    let ball = place.json("render out.barchan --eye-elevation 10 --on sphere --size 80 -o ball.png");
    let circle = std::f64::consts::FRAC_PI_4 / (1.04 * 1.04);
    assert!((number(&ball, "/seen_share") - circle).abs() < 0.01, "{ball}");
    place.bake(&RELIEF.replace("edge: wrap", "edge: clamp"));
    let tile = place.json("render out.barchan --eye-elevation 30 --eye-azimuth 225 --size 80 -o tile.png");
    // A square from its corner: half of the picture.
    assert!((number(&tile, "/seen_share") - 0.5 / (1.04 * 1.04)).abs() < 0.02, "{tile}");
    assert_eq!(
        place.fails(1, "render out.barchan --eye-elevation 30 --on sphere -o ball.png"),
        "out.barchan: --on sphere needs a tile whose edges wrap; these are clamped"
    );
}

#[test]
fn the_best_search_is_the_one_whose_table_is_there() {
    let place = Place::with("relief.ron", RELIEF);
    for (only, search, start) in [
        ("height", "linear", "top"),
        ("height,hemisphere", "linear", "depth_map"),
        ("height,maximum_mip", "maximum_mip", "top"),
        ("height,relaxed_cone_map", "relaxed_cone_steps", "top"),
        ("height,cone_map", "cone_steps", "top"),
        ("height,relaxed_cone_map,maximum_mip,cone_map", "maximum_mip", "top"),
    ] {
        place.ok(&format!("bake relief.ron --only {only} -o out.barchan"));
        let report = place.json("render out.barchan --eye-elevation 45 --size 32 --compare -o seen.png");
        assert_eq!((&report["search"], &report["start"]), (&search.into(), &start.into()), "{only}");
        assert!(number(&report, "/comparison/rms_depth_error") < 0.05, "{only}: {report}");
    }
}

#[test]
fn a_table_that_is_missing_is_named_with_what_bakes_it() {
    let place = Place::with("relief.ron", RELIEF);
    place.ok("bake relief.ron --only height -o out.barchan");
    for (flags, table, asked) in [
        ("--search cone_steps", "cone_map", "--search cone_steps"),
        ("--search relaxed_cone_steps", "relaxed_cone_map", "--search relaxed_cone_steps"),
        ("--search maximum_mip", "maximum_mip", "--search maximum_mip"),
        ("--start depth_map", "hemisphere", "--start depth_map"),
        ("--ambient", "hemisphere", "--ambient"),
    ] {
        assert_eq!(
            place.fails(2, &format!("render out.barchan --eye-elevation 45 {flags} -o seen.png")),
            format!(
                "out.barchan: there is no {table} table, which {asked} needs; bake it with `relief_mapping` in the recipe's \
                 scene, or from a height map with `--only height,{table}`"
            )
        );
    }
    place.ok("bake relief.ron --only hemisphere -o out.barchan");
    assert_eq!(
        place.fails(2, "render out.barchan --eye-elevation 45 -o seen.png"),
        "out.barchan: there is no height table; the file has hemisphere"
    );
    assert!(!place.names().contains(&"seen.png".to_owned()));
}

#[test]
fn flags_of_this_picture_need_an_eye_above_the_ground() {
    let place = baked();
    for flags in [
        "--heat",
        "--search linear",
        "--start top",
        "--on sphere",
        "--tiles 3",
        "--size 64",
        "--eye-elevation 0",
        "--eye-elevation 91",
        "--eye-elevation 30 --tiles 0",
        "--eye-elevation 30 --size 2049",
        "--eye-elevation 30 --search bisection",
        "--eye-elevation 30 --heat --compare",
        "--eye-elevation 30 --scale 2",
    ] {
        assert_eq!(place.run(&format!("render out.barchan {flags} -o seen.png")).code, Some(1), "{flags}");
    }
}
