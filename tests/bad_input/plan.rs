//! Plans: refused as their bake would be.

use crate::support::{Place, bumpy, npy};

/// What `plan` and `bake` say of the same words, which is the same, and with the same exit code; nothing is written.
fn both_refuse(place: &Place, code: i32, words: &str) -> String {
    let names = place.names();
    let message = place.fails(code, &format!("plan {words}"));
    assert_eq!(place.fails(code, &format!("bake {words} -o out.barchan")), message, "{words}");
    assert_eq!(place.names(), names);
    message
}

const PLANE: &str = "source: Shape(shape: Plane(slope_u: 0.5, slope_v: 0.0), width: 8, height: 8)";
const MAP: &str = "source: HeightMap(path: \"map.npy\")";

#[test]
fn recipes_are_refused_with_the_sentences_of_a_bake() {
    let place = Place::new();
    for (recipe, expected) in [
        ("(edge: wrp)", "r.ron:1:8: unknown value `wrp`; did you mean `wrap`? (accepted: `wrap`, `clamp`)"),
        (
            "(source: Shape(shape: Plane(slope_u: inf, slope_v: 0.0), width: 8, height: 8))",
            "r.ron: source: plane: slope_u is inf; a slope from -1e6 to 1e6 is needed",
        ),
        (
            "(source: Shape(shape: Plane(slope_u: 0.5, slope_v: 0.0), width: 0, height: 8))",
            "r.ron: source: the height field is 0 × 8 texels; both sides must be at least 1",
        ),
        (
            "(source: Shape(shape: Plane(slope_u: 0.5, slope_v: 0.0), width: 4294967295, height: 8))",
            "r.ron: source: 4294967295 × 8 texels are 34359738360; at most 268435456 are accepted",
        ),
        (
            "(source: Shape(shape: Plane(slope_u: 0.5, slope_v: 0.0), width: 1, height: 1))",
            "r.ron: source: the height map is 1 × 1 texels; a horizon needs at least 2 texels",
        ),
        ("(mesh: (surface: Sphere(radius: -2.0), vertices: 400))", "r.ron: mesh: "),
        (
            "(mesh: (surface: Sphere(radius: 2.0), vertices: 400), curvature: (hard_edge_degrees: 200))",
            "r.ron: curvature: hard_edge_degrees is 200; an angle from 0 to 180 is accepted",
        ),
    ] {
        place.write("r.ron", recipe);
        let message = both_refuse(&place, 2, "r.ron");
        assert!(message.starts_with(expected), "{message}\n{expected}");
    }
}

#[test]
fn parameters_are_refused_whether_the_heights_are_known_or_not() {
    let place = Place::with("map.npy", npy(8, &bumpy(8, 8)));
    let arc = "degrees from within ±360 to a larger number, less than 360 beyond, are accepted";
    for (fields, expected) in [
        ("horizon: (directions: 0)", "horizon: directions is 0; 1 to 2048 azimuths are accepted"),
        ("horizon: (arc: (90, 0))", &format!("horizon: arc is 90 to 0; {arc}")),
        (
            "horizon: (radius: 1e9)",
            "horizon: radius is 1000000000; a positive length of at most 131072 texels is accepted",
        ),
        (
            "horizon: (directions: 2), scene: (ambient_light: true)",
            "horizon: directions is 2; 3 to 2048 azimuths are accepted where a sky is baked",
        ),
        (
            "scene: (curvature: (0, 2))",
            "curved: curvature is 0 to 2; a radius of curvature of at least one texel is accepted",
        ),
        (
            "scene: (curvature: (-1, 0)), horizon: (radius: 8)",
            "curved: curvature is -1 to 0; a concave radius of more than 1/π of the search radius is accepted: half round a \
             hollow is behind",
        ),
        ("scene: (curvature: (0, 0.1)), curved: (points: 9)", "curved: points is 9; 1 to 8 points are accepted"),
        (
            "scene: (curvature: (0, 0.1)), curved: (max_error_degrees: 0)",
            "curved: max_error_degrees is 0; a positive number of degrees is accepted",
        ),
        (
            "scene: (relief_mapping: (least_elevation_degrees: 90))",
            "scene.relief_mapping: least_elevation_degrees is 90; more than 0 and less than 90 degrees are accepted",
        ),
        ("scene: (relief_mapping: (arc: (10, 5)))", &format!("scene.relief_mapping: arc is 10 to 5; {arc}")),
        ("scene: (relief_mapping: ()), hemisphere: (rings: 0)", "hemisphere: rings is 0; 1 or more are accepted"),
        (
            "scene: (relief_mapping: ()), hemisphere: (rings: 64, azimuths: 33)",
            "hemisphere: rings × azimuths is 64 × 33; at most 2048 directions are accepted",
        ),
        (
            "scene: (relief_mapping: ()), hemisphere: (size: (8, 0))",
            "hemisphere: size is 8 × 0; at least 1 texel along each side is accepted",
        ),
    ] {
        for source in [PLANE, MAP] {
            place.write("r.ron", format!("({source}, {fields})"));
            assert_eq!(both_refuse(&place, 2, "r.ron"), format!("r.ron: {expected}"), "{source}");
        }
    }
    let size = "scene: (relief_mapping: ()), hemisphere: (size: (9, 4))";
    let expected = "r.ron: hemisphere: size is 9 × 4 for a height map of 8 × 8; no more texels along a side than the height map has \
                    are accepted";
    place.write("r.ron", format!("({PLANE}, {size})"));
    assert_eq!(both_refuse(&place, 2, "r.ron"), expected);
    // Only the map says how many texels it has.
    place.write("r.ron", format!("({MAP}, {size})"));
    assert!(place.ok("plan r.ron").contains("\nchecked        all that can be checked without map.npy\n"));
    assert_eq!(place.fails(2, "bake r.ron"), expected);
}

#[test]
fn what_is_left_out_is_not_checked() {
    let place =
        Place::with("r.ron", format!("({PLANE}, scene: (), hemisphere: (rings: 0, azimuths: 0, size: (0, 0)))"));
    let words = place.ok("plan r.ron");
    assert!(words.contains("the scene has no relief mapping"), "{words}");
    let huge =
        "horizon: (directions: 4294967295), curved: (points: 4294967295), hemisphere: (size: (4294967295, 4294967295))";
    place.write("r.ron", format!("({PLANE}, {huge})"));
    place.ok("plan r.ron --only height");
}

#[test]
fn words_and_files_are_refused_with_the_exit_codes_of_a_bake() {
    let place = Place::with("map.npy", npy(8, &bumpy(8, 8)));
    place.write("r.ron", format!("({PLANE})"));
    place.write("missing.ron", "(source: HeightMap(path: \"maps/none.tif\"))");
    place.write("scale.ron", "(source: HeightMap(path: \"map.npy\", height_scale: inf))");
    let all = "a PNG, EXR, TIFF, NPY, OBJ, PLY or glTF file is needed";
    for (code, words, expected) in [
        (1, "r.ron --edge wrap", "--edge is for a height map without a recipe; set it in r.ron".to_owned()),
        (1, "map.npy --hard-edge 3", "--hard-edge is for meshes; map.npy is a height map".to_owned()),
        (1, "map.npy --only curvature", "map.npy: curvature cannot be baked: there is no mesh".to_owned()),
        (
            1,
            "map.npy --only swept_horizon",
            "map.npy: swept_horizon needs a recipe that names `scene: (curvature: (min, max))`".to_owned(),
        ),
        (
            2,
            "r.ron --only swept_horizon",
            "r.ron: scene: `curvature` is missing; swept_horizon needs a range, such as `curvature: (0.0, 0.02)`"
                .to_owned(),
        ),
        (2, "scale.ron", "map.npy: `height_scale` is inf; a finite number is needed".to_owned()),
        (4, "none.ron", "none.ron: cannot be read: No such file or directory (os error 2)".to_owned()),
        (4, "none.png", format!("none.png: there is no such file; {all}")),
        (4, "missing.ron", format!("maps/none.tif: there is no such file; {all}")),
        (4, ".", format!(".: this is a folder; {all}")),
    ] {
        assert_eq!(both_refuse(&place, code, words), expected);
    }
    for words in ["plan", "plan map.npy extra", "plan map.npy -o x.barchan", "plan map.npy --only heat"] {
        let run = place.run(words);
        assert_eq!((run.code, run.stdout.as_str()), (Some(1), ""), "barchan {words}");
    }
    let run = place.run("--json plan none.png");
    assert_eq!(run.code, Some(4));
    assert_eq!(crate::support::parse_json(&run.stdout)["schema"], "barchan.error/1");
}
