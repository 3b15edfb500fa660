//! Recipes.

use crate::support::Place;

/// The complaint about a recipe, without the file's name; nothing is written.
fn complaint(recipe: &str) -> String {
    let place = Place::with("r.ron", recipe);
    let message = place.fails(2, "bake r.ron");
    assert_eq!(place.names(), ["r.ron"]);
    message.strip_prefix("r.ron:").unwrap_or_else(|| panic!("the recipe is not named: {message}")).to_owned()
}

/// A recipe with a line of fields, on line 3.
fn with(fields: &str) -> String {
    format!("(\n    source: Shape(shape: Plane(slope_u: 0.5, slope_v: 0.0), width: 8, height: 8),\n{fields}\n)")
}

#[test]
fn an_unknown_field_names_the_nearest_known_one() {
    for (fields, expected) in [
        ("spacng: 1.0,", "3:1: unknown field `spacng`; did you mean `spacing`?"),
        ("horzion: (),", "3:1: unknown field `horzion`; did you mean `horizon`?"),
        ("horizon: (radus: 3.0),", "3:11: unknown field `radus`; did you mean `radius`?"),
        ("horizon: (direction: 3),", "3:11: unknown field `direction`; did you mean `directions`?"),
        ("height: (encodng: u8),", "3:10: unknown field `encodng`; did you mean `encoding`?"),
        ("scene: (soft_shadow: true),", "3:9: unknown field `soft_shadow`; did you mean `soft_shadows`?"),
        ("edge: warp,", "3:7: unknown value `warp`; did you mean `wrap`?"),
        ("unit: meter,", "3:7: unknown value `meter`; did you mean `metre`?"),
        ("distance: (encoding: f8),", "3:22: unknown value `f8`; did you mean `u8`?"),
        ("horizon: (method: exakt),", "3:19: unknown value `exakt`; did you mean `exact`?"),
        ("scene: (ambient_ligt: true),", "3:9: unknown field `ambient_ligt`; did you mean `ambient_light`?"),
        ("curved: (point: 3),", "3:10: unknown field `point`; did you mean `points`?"),
        ("sky: (encoding: compct),", "3:17: unknown value `compct`; did you mean `compact`?"),
        ("compression: zst,", "3:14: unknown value `zst`; did you mean `zstd`?"),
    ] {
        let found = complaint(&with(fields));
        assert!(found.starts_with(expected), "{found}\n{expected}");
        assert!(found.contains("? (accepted: `"), "{found}");
    }
}

#[test]
fn a_field_near_to_nothing_is_shown_what_there_is() {
    assert_eq!(
        complaint(&with("scene: (zzz: true),")),
        "3:9: unknown field `zzz` (accepted: `curved_surfaces`, `curvature`, `soft_shadows`, `ambient_light`, `area_lights`, \
         `relief_mapping`)"
    );
}

#[test]
fn unknown_sources_shapes_and_parameters_name_the_nearest_too() {
    for (source, expected) in [
        ("Shap(shape: 1)", "1:10: unknown value `Shap`; did you mean `Shape`? (accepted: `HeightMap`, `Shape`)"),
        ("HeightMap(pth: \"a\")", "1:20: unknown field `pth`; did you mean `path`?"),
        ("Shape(shape: Dune(), width: 1)", "1:23: unknown value `Dune`; did you mean `Dunes`? (accepted: `Plane`, "),
        (
            "Shape(shape: Plane(slope: 1.0))",
            "1:29: unknown field `slope`; did you mean `slope_u`? (accepted: `slope_u`, `slope_v`)",
        ),
        ("Shape(shape: Ripples(amplitud: 1.0))", "1:31: unknown field `amplitud`; did you mean `amplitude`?"),
    ] {
        let found = complaint(&format!("(source: {source})"));
        assert!(found.starts_with(expected), "{found}\n{expected}");
    }
}

#[test]
fn a_value_of_the_wrong_type_is_named_with_its_field() {
    for (fields, expected) in [
        ("horizon: (directions: \"8\"),", "`horizon.directions` is `\"8\"`; a whole number is needed"),
        (
            "horizon: (directions: -8),",
            "`horizon.directions` is `-8`; a whole number within the field's range is needed",
        ),
        ("horizon: (radius: far),", "`horizon.radius` is `far`; a number is needed"),
        ("scene: (soft_shadows: 1),", "`scene.soft_shadows` is `1`; true or false is needed"),
        ("horizon: (arc: 90),", "`horizon.arc` is `90`; a pair of numbers in parentheses is needed"),
        ("scene: (curvature: 0.1),", "`scene.curvature` is `0.1`; a pair of numbers in parentheses is needed"),
        ("edge: \"wrap\",", "`edge` is `\"wrap\"`; a name without quotes is needed"),
        ("height: 3,", "`height` is `3`; a list of fields in parentheses is needed"),
        (
            "spacing: \"wide\",",
            "`spacing` is `\"wide\"`; a length per texel, or two in parentheses (along u and along v), is needed",
        ),
    ] {
        let found = complaint(&with(fields));
        let (place, words) = found.split_once(": ").unwrap();
        assert_eq!(words, expected);
        assert!(place.starts_with("3:"), "{place}");
    }
    assert_eq!(
        complaint("(source: Shape(shape: Plane(slope_u: steep)))"),
        "1:37: `source.Shape.shape.Plane.slope_u` is `steep`; a number is needed"
    );
}

#[test]
fn what_is_missing_double_or_unfinished_is_said() {
    for (recipe, expected) in [
        ("", "1:1: a list of fields in parentheses is needed"),
        ("(source: HeightMap())", "1:20: source.HeightMap: the field `path` is missing"),
        (&with("edge: wrap, edge: clamp,"), "3:13: the field `edge` is there twice"),
        ("(source: HeightMap(path: \"a.png\")", "1:33: a comma or a closing `)` is needed"),
        ("(source: HeightMap(path: \"a.png\")) more", "1:35: nothing may follow the recipe's closing `)`"),
        ("(source: HeightMap(path: \"a.png", "1:26: source.HeightMap.path: a closing `\"` is needed"),
    ] {
        assert_eq!(complaint(recipe), expected, "{recipe}");
    }
}

#[test]
fn a_number_out_of_range_is_named_with_what_is_accepted() {
    let spacing = "is needed";
    for (fields, expected) in [
        ("spacing: 0.0,", format!(" spacing u is 0; a positive, finite length per texel {spacing}")),
        ("spacing: (1.0, -2.0),", format!(" spacing v is -2; a positive, finite length per texel {spacing}")),
        ("horizon: (directions: 0),", " horizon: directions is 0; 1 to 2048 azimuths are accepted".into()),
        ("horizon: (directions: 2049),", " horizon: directions is 2049; 1 to 2048 azimuths are accepted".into()),
    ] {
        assert_eq!(complaint(&with(fields)), expected);
    }
    let arc = "degrees from within ±360 to a larger number, less than 360 beyond, are accepted";
    let range = "two finite numbers, the smaller first, are accepted";
    let hollow = "a concave radius of more than 1/π of the search radius is accepted: half round a hollow is behind";
    for (fields, expected) in [
        ("horizon: (arc: (90, 0)),", format!(" horizon: arc is 90 to 0; {arc}")),
        ("horizon: (arc: (0, 360)),", format!(" horizon: arc is 0 to 360; {arc}")),
        ("horizon: (arc: (-400, -300)),", format!(" horizon: arc is -400 to -300; {arc}")),
        ("horizon: (arc: (0, NaN)),", format!(" horizon: arc is 0 to NaN; {arc}")),
        (
            "horizon: (arc: (0, 90), directions: 1),",
            " horizon: directions is 1; 2 to 2048 azimuths are accepted in an arc, which bakes both its ends".into(),
        ),
        (
            "horizon: (directions: 2), scene: (ambient_light: true),",
            " horizon: directions is 2; 3 to 2048 azimuths are accepted where a sky is baked".into(),
        ),
        (
            "horizon: (arc: (0, 90)), scene: (area_lights: true),",
            " horizon: arc is 0 to 90; the sky is all around a texel: only the full circle of azimuths is accepted where it \
             is baked"
                .into(),
        ),
        ("scene: (curvature: (1, 0)),", format!(" curved: curvature is 1 to 0; {range}")),
        ("scene: (curvature: (0, inf)),", format!(" curved: curvature is 0 to inf; {range}")),
        ("scene: (curvature: (-1, 0)),", format!(" curved: curvature is -1 to 0; {hollow}")),
        (
            "scene: (curvature: (0, 2)),",
            " curved: curvature is 0 to 2; a radius of curvature of at least one texel is accepted".into(),
        ),
        (
            "scene: (curvature: (0, 0.1)), curved: (points: 9),",
            " curved: points is 9; 1 to 8 points are accepted".into(),
        ),
        (
            "scene: (curvature: (0, 0.1)), curved: (max_error_degrees: 0),",
            " curved: max_error_degrees is 0; a positive number of degrees is accepted".into(),
        ),
        (
            "curved: (points: 2, max_error_degrees: 1),",
            " curved: `points` and `max_error_degrees` are both there; one of them is accepted".into(),
        ),
    ] {
        assert_eq!(complaint(&with(fields)), expected);
    }
    for radius in ["0.0", "-1.0", "1e9", "inf", "NaN"] {
        let found = complaint(&with(&format!("horizon: (radius: {radius}),")));
        let value = radius.parse::<f64>().unwrap();
        let accepted = "a positive length of at most 131072 texels is accepted";
        assert_eq!(found, format!(" horizon: radius is {value}; {accepted}"));
    }
}

#[test]
fn a_shape_that_cannot_be_is_refused() {
    let shape =
        |words: &str, width: u32| complaint(&format!("(source: Shape(shape: {words}, width: {width}, height: 8))"));
    assert_eq!(
        shape("Plane(slope_u: inf, slope_v: 0.0)", 8),
        " source: plane: slope_u is inf; a slope from -1e6 to 1e6 is needed"
    );
    let plane = "Plane(slope_u: 0.5, slope_v: 0.0)";
    assert_eq!(shape(plane, 0), " source: the height field is 0 × 8 texels; both sides must be at least 1");
    assert_eq!(
        shape(plane, u32::MAX),
        " source: 4294967295 × 8 texels are 34359738360; at most 268435456 are accepted"
    );
}

#[test]
fn one_texel_has_no_horizon_but_a_height() {
    let recipe = "(source: Shape(shape: Plane(slope_u: 0.5, slope_v: 0.0), width: 1, height: 1))";
    assert_eq!(complaint(recipe), " source: the height map is 1 × 1 texels; a horizon needs at least 2 texels");
    let place = Place::with("r.ron", recipe);
    place.ok("bake r.ron --only height");
    assert_eq!(place.json("validate r.barchan")["findings"], serde_json::json!([]));
}

#[test]
fn a_recipe_is_a_text() {
    let place = Place::with("r.ron", b"(source: \xff)");
    assert_eq!(place.fails(2, "bake r.ron"), "r.ron: byte 9 is not UTF-8; a recipe is a RON text");
}

#[test]
fn a_height_map_of_a_recipe_is_named_by_its_own_path() {
    let place = Place::with("r.ron", "(source: HeightMap(path: \"a.png\"))");
    place.write("a.png", "");
    assert_eq!(place.fails(2, "bake r.ron"), "a.png: the file is empty; a PNG, EXR, TIFF or NPY file is needed");
    place.write("r.ron", "(source: HeightMap(path: \"a.png\", height_scale: inf))");
    assert_eq!(place.fails(2, "bake r.ron"), "a.png: `height_scale` is inf; a finite number is needed");
}

#[test]
fn relief_mapping_that_no_table_can_serve_is_refused() {
    let mapped = |mapping: &str, hemisphere: &str| {
        complaint(&with(&format!("scene: (relief_mapping: ({mapping})), hemisphere: ({hemisphere}),")))
    };
    let degrees = "more than 0 and less than 90 degrees are accepted";
    for (value, shown) in [("0", "0"), ("90.0", "90"), ("-3.5", "-3.5")] {
        let found = mapped(&format!("least_elevation_degrees: {value}"), "");
        assert_eq!(found, format!(" scene.relief_mapping: least_elevation_degrees is {shown}; {degrees}"));
    }
    assert_eq!(mapped("", "rings: 0"), " hemisphere: rings is 0; 1 or more are accepted");
    assert_eq!(
        mapped("", "size: (9, 4)"),
        " hemisphere: size is 9 × 4 for a height map of 8 × 8; no more texels along a side than the height map has are \
         accepted"
    );
    assert_eq!(
        mapped("arc: (10, 5)", ""),
        " scene.relief_mapping: arc is 10 to 5; degrees from within ±360 to a larger number, less than 360 beyond, are \
         accepted"
    );
}
