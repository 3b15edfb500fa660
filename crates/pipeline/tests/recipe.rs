//! Recipes as people write them.

use barchan_field::shapes::{Dunes, Plane};
use barchan_field::surfaces::{Pattern, Tessellation};
use barchan_field::{Edge, LengthUnit, ParametricSurface, Shape, Spacing};
use barchan_import::Fill;
use barchan_pipeline::{
    Compression, ConeMapRecipe, CurvatureEncoding, CurvatureMethod, CurvatureRecipe, CurvedRecipe, DistanceRecipe,
    HeightMapSource, HeightRecipe, HemisphereMode, HemisphereRecipe, HemisphereSpacing, HorizonMethod, HorizonRecipe,
    MaximumMipRecipe, MeshFile, MeshSource, Recipe, RecipeError, ReliefMapping, ReliefSearch, Scene, ShapeSource,
    SkyRecipe, Source, SurfaceSource, TableEncoding,
};

const PLANE: &str = "source: Shape(shape: Plane(slope_u: 0.5, slope_v: -0.25), width: 3, height: 2)";

fn plane() -> Source {
    Source::Shape(ShapeSource { shape: Shape::Plane(Plane { slope_u: 0.5, slope_v: -0.25 }), width: 3, height: 2 })
}

/// A recipe of a plane and more fields.
fn parse(fields: &str) -> Result<Recipe, RecipeError> {
    Recipe::parse(&format!("({PLANE}, {fields})"))
}

/// What the parser says about a recipe of a plane and more fields, which begin at column 82.
fn complaint(fields: &str) -> String {
    parse(fields).unwrap_err().to_string()
}

#[test]
fn only_the_source_is_needed() {
    assert_eq!(parse("").unwrap(), Recipe::bare(plane()));
}

#[test]
fn a_bare_recipe_is_clamped_square_and_leaves_nothing_out() {
    let recipe = Recipe::bare(plane());
    assert_eq!(
        (recipe.spacing, recipe.height_unit(), recipe.edge),
        (Spacing::UNIT, LengthUnit::SceneUnit, Edge::Clamp)
    );
    assert_eq!((recipe.scene, recipe.compression), (None, Compression::None));
    assert_eq!((recipe.horizon.directions, recipe.horizon.radius), (32, None));
    assert_eq!((recipe.horizon.arc, recipe.horizon.method), (None, HorizonMethod::Accurate));
    assert_eq!((recipe.curved.points, recipe.curved.max_error_degrees), (None, None));
    let Recipe { horizon, distance, curved, sky, hemisphere, cone_map, maximum_mip, .. } = &recipe;
    assert_eq!(recipe.height.encoding, TableEncoding::F16);
    let encodings = [horizon.encoding, distance.encoding, curved.encoding, sky.encoding];
    assert_eq!(encodings, [TableEncoding::Compact; 4]);
    assert_eq!([hemisphere.encoding, cone_map.encoding, maximum_mip.encoding], [TableEncoding::Compact; 3]);
}

#[test]
fn hemisphere_tables_are_the_papers_where_nothing_else_is_said() {
    let hemisphere = Recipe::bare(plane()).hemisphere;
    assert_eq!((hemisphere.rings, hemisphere.azimuths), (32, 16));
    assert_eq!(
        (hemisphere.spacing, hemisphere.mode),
        (HemisphereSpacing::SquaredTangents, HemisphereMode::Conservative)
    );
    // No larger than the heights.
    assert_eq!([hemisphere.size_for(512, 64), hemisphere.size_for(40, 700)], [(64, 64), (40, 64)]);
    let scene = parse("scene: (relief_mapping: ())").unwrap().scene.unwrap();
    let expected = ReliefMapping { least_elevation_degrees: 10.0, arc: None, search: ReliefSearch::ConeSteps };
    assert_eq!(scene.relief_mapping, Some(expected));
}

#[test]
fn what_relief_mapping_cannot_be_is_said_with_what_it_can() {
    let words = |fields: &str| complaint(fields).split_once(": ").unwrap().1.to_owned();
    for (fields, expected) in [
        (
            "scene: (relief_mapping: (search: cones))",
            "unknown value `cones` (accepted: `cone_steps`, `relaxed_cone_steps`, `maximum_mip`, `linear`)",
        ),
        ("hemisphere: (mode: bold)", "unknown value `bold` (accepted: `conservative`, `nearest`)"),
        ("hemisphere: (size: 64)", "`hemisphere.size` is `64`; a pair of numbers in parentheses is needed"),
        ("hemisphere: (rings: -1)", "`hemisphere.rings` is `-1`; a whole number within the field's range is needed"),
        (
            "hemisphere: (ring: 8)",
            "unknown field `ring`; did you mean `rings`? (accepted: `rings`, `azimuths`, `spacing`, `size`, `mode`, \
             `encoding`)",
        ),
    ] {
        assert_eq!(words(fields), expected);
    }
}

#[test]
fn every_field_is_read() {
    let text = "(
        source: Shape(
            shape: Dunes(
                dune_height: 18.0, dunes_across: 2, ripple_height: 0.35, ripples_across: 44, sinuosity: 0.85,
                slip_degrees: 32.0, seed: 7,
            ),
            width: 512, height: 256,
        ),
        mesh: (path: \"meshes/a.glb\", mesh: \"body\"),
        spacing: (0.5, 0.25),
        unit: kilometre,
        edge: wrap,
        scene: (
            curved_surfaces: true, curvature: (-0.01, 0.02), soft_shadows: false, ambient_light: true, area_lights: true,
            relief_mapping: (least_elevation_degrees: 20.5, arc: (10, 170), search: maximum_mip),
        ),
        height: (encoding: f32),
        horizon: (directions: 48, arc: (-90, 90.5), radius: 128.5, method: exact, encoding: u8),
        distance: (encoding: u8),
        curved: (points: 3, encoding: f16),
        sky: (encoding: f32),
        hemisphere: (rings: 8, azimuths: 9, spacing: equal_angles, size: (32, 16), mode: nearest, encoding: f16),
        cone_map: (encoding: f16),
        maximum_mip: (encoding: f32),
        curvature: (method: fast, hard_edge_degrees: 12.5, encoding: f32, directions: true, uv_directions: true),
        compression: zstd,
    )";
    let dunes = Dunes {
        dune_height: 18.0,
        dunes_across: 2,
        ripple_height: 0.35,
        ripples_across: 44,
        sinuosity: 0.85,
        slip_degrees: 32.0,
        seed: 7,
    };
    let expected = Recipe {
        source: Some(Source::Shape(ShapeSource { shape: Shape::Dunes(dunes), width: 512, height: 256 })),
        mesh: Some(MeshSource::File(MeshFile { path: "meshes/a.glb".into(), mesh: Some("body".into()) })),
        spacing: Spacing::new(0.5, 0.25).unwrap(),
        unit: Some(LengthUnit::Kilometre),
        edge: Edge::Wrap,
        scene: Some(Scene {
            curved_surfaces: true,
            curvature: Some((-0.01, 0.02)),
            soft_shadows: false,
            ambient_light: true,
            area_lights: true,
            relief_mapping: Some(ReliefMapping {
                least_elevation_degrees: 20.5,
                arc: Some((10.0, 170.0)),
                search: ReliefSearch::MaximumMip,
            }),
        }),
        height: HeightRecipe { encoding: TableEncoding::F32 },
        horizon: HorizonRecipe {
            directions: 48,
            arc: Some((-90.0, 90.5)),
            radius: Some(128.5),
            method: HorizonMethod::Exact,
            encoding: TableEncoding::U8,
        },
        distance: DistanceRecipe { encoding: TableEncoding::U8 },
        curved: CurvedRecipe { points: Some(3), max_error_degrees: None, encoding: TableEncoding::F16 },
        sky: SkyRecipe { encoding: TableEncoding::F32 },
        hemisphere: HemisphereRecipe {
            rings: 8,
            azimuths: 9,
            spacing: HemisphereSpacing::EqualAngles,
            size: Some((32, 16)),
            mode: HemisphereMode::Nearest,
            encoding: TableEncoding::F16,
        },
        cone_map: ConeMapRecipe { encoding: TableEncoding::F16 },
        maximum_mip: MaximumMipRecipe { encoding: TableEncoding::F32 },
        curvature: CurvatureRecipe {
            method: CurvatureMethod::Fast,
            hard_edge_degrees: 12.5,
            encoding: CurvatureEncoding::F32,
            directions: Some(true),
            uv_directions: true,
        },
        compression: Compression::Zstd,
    };
    assert_eq!(Recipe::parse(text).unwrap(), expected);
}

#[test]
fn every_field_of_a_height_map_is_read() {
    let text = "(source: HeightMap(
        path: \"maps/a.tif\", height_scale: 12.5, height_offset: -3, channel: \"R\", no_data: -9999, fill: value(1.5),
    ))";
    let expected = HeightMapSource {
        height_scale: 12.5,
        height_offset: -3.0,
        channel: Some("R".to_owned()),
        no_data: Some(-9999.0),
        fill: Some(Fill::Value(1.5)),
        ..HeightMapSource::new("maps/a.tif".into(), 1.0)
    };
    assert_eq!(Recipe::parse(text).unwrap().source, Some(Source::HeightMap(expected)));
    let bare = Recipe::parse("(source: HeightMap(path: \"a.png\"))").unwrap();
    assert_eq!(bare.source, Some(Source::HeightMap(HeightMapSource::new("a.png".into(), 1.0))));
    for (words, fill) in [("lowest", Fill::Lowest), ("nearest", Fill::Nearest)] {
        let recipe = Recipe::parse(&format!("(source: HeightMap(path: \"a.png\", fill: {words}))")).unwrap();
        let Some(Source::HeightMap(source)) = recipe.source else { panic!("a height map") };
        assert_eq!(source.fill, Some(fill));
    }
}

#[test]
fn a_spacing_is_one_length_or_two() {
    for (text, (u, v)) in [
        ("2", (2.0, 2.0)),
        ("0.25", (0.25, 0.25)),
        ("(74, 93)", (74.0, 93.0)),
        ("(0.5, 1)", (0.5, 1.0)),
        ("1e-30", (1e-30, 1e-30)),
    ] {
        assert_eq!(parse(&format!("spacing: {text}")).unwrap().spacing, Spacing::new(u, v).unwrap(), "{text}");
    }
}

#[test]
fn an_optional_value_is_written_with_or_without_some() {
    for radius in ["3.0", "Some(3.0)", "3"] {
        assert_eq!(parse(&format!("horizon: (radius: {radius})")).unwrap().horizon.radius, Some(3.0), "{radius}");
    }
    assert_eq!(parse("horizon: (radius: None)").unwrap().horizon.radius, None);
    assert_eq!(parse("scene: ()").unwrap().scene, Some(Scene::default()));
}

#[test]
fn a_spacing_that_is_no_length_is_refused() {
    let needed = "a positive, finite length per texel is needed";
    for (text, found) in [
        ("0", "u is 0"),
        ("-1.5", "u is -1.5"),
        ("(1, 0)", "v is 0"),
        ("NaN", "u is NaN"),
        ("inf", "u is inf"),
        ("(1.0, -inf)", "v is -inf"),
    ] {
        assert_eq!(complaint(&format!("spacing: {text}")), format!("spacing {found}; {needed}"));
    }
    let words = "a length per texel, or two in parentheses (along u and along v), is needed";
    assert_eq!(complaint("spacing: true"), format!("line 1, column 91: `spacing` is `true`; {words}"));
    assert_eq!(complaint("spacing: (1.0)"), format!("line 1, column 95: `spacing` is `1.0`; {words}"));
}

#[test]
fn a_complaint_tells_line_and_column_and_the_nearest_field() {
    let text = format!("(\n  {PLANE},\n  horizon: (\n    directions: 3,\n    radious: 2.0,\n  ),\n)");
    let RecipeError::Syntax { line, column, reason } = Recipe::parse(&text).unwrap_err() else { panic!("syntax") };
    assert_eq!((line, column), (5, 5));
    assert_eq!(
        reason,
        "unknown field `radious`; did you mean `radius`? (accepted: `directions`, `arc`, `radius`, `method`, \
         `encoding`)"
    );
    assert_eq!(
        complaint("colour: 3"),
        "line 1, column 82: unknown field `colour` (accepted: `source`, `mesh`, `spacing`, `unit`, `edge`, `scene`, \
         `height`, `horizon`, `distance`, `curved`, `sky`, `hemisphere`, `cone_map`, `maximum_mip`, `curvature`, \
         `compression`)"
    );
    assert_eq!(
        complaint("unit: kilometer"),
        "line 1, column 88: unknown value `kilometer`; did you mean `kilometre`? (accepted: `scene_unit`, `metre`, \
         `centimetre`, `millimetre`, `kilometre`)"
    );
}

#[test]
fn a_value_of_the_wrong_type_is_shown_with_its_field() {
    let words = |fields: &str| complaint(fields).split_once(": ").unwrap().1.to_owned();
    assert_eq!(words("horizon: (directions: many)"), "`horizon.directions` is `many`; a whole number is needed");
    assert_eq!(words("horizon: (directions: )"), "`horizon.directions` has no value; a whole number is needed");
    assert_eq!(
        words("horizon: (directions: -1)"),
        "`horizon.directions` is `-1`; a whole number within the field's range is needed"
    );
    assert_eq!(words("scene: (soft_shadows: yes)"), "`scene.soft_shadows` is `yes`; true or false is needed");
    let long = "x".repeat(60);
    let cut = format!("`horizon.radius` is `{}…`; a number is needed", "x".repeat(40));
    assert_eq!(words(&format!("horizon: (radius: {long})")), cut);
}

#[test]
fn points_are_counted_or_follow_from_an_error() {
    assert_eq!(parse("curved: (max_error_degrees: 0.2)").unwrap().curved.max_error_degrees, Some(0.2));
    assert_eq!(
        complaint("curved: (points: 3, max_error_degrees: 0.2)"),
        "curved: `points` and `max_error_degrees` are both there; one of them is accepted"
    );
}

#[test]
fn what_follows_a_recipe_or_is_missing_from_it_is_said() {
    let says = |text: &str| Recipe::parse(text).unwrap_err().to_string();
    assert_eq!(says(""), "line 1, column 1: a list of fields in parentheses is needed");
    assert_eq!(Recipe::parse("()"), Err(RecipeError::NoInput));
    assert_eq!(says(&format!("({PLANE}) x")), "line 1, column 81: nothing may follow the recipe's closing `)`");
    assert_eq!(complaint("edge: wrap, edge: wrap"), "line 1, column 94: the field `edge` is there twice");
}

#[test]
fn comments_and_line_ends_of_any_kind_are_accepted() {
    let text = format!("// a comment\r\n(\r\n  /* another */ {PLANE}, // and one more\r\n)\r\n");
    assert_eq!(Recipe::parse(&text).unwrap(), Recipe::bare(plane()));
}

/// A mesh of a recipe, or what the parser says about it.
fn mesh(fields: &str) -> Result<MeshSource, String> {
    let recipe = Recipe::parse(&format!("(mesh: ({fields}))")).map_err(|error| error.to_string())?;
    Ok(recipe.mesh.unwrap())
}

#[test]
fn a_mesh_may_stand_alone_with_every_default() {
    let file = MeshFile { path: "a.ply".into(), mesh: None };
    let recipe = Recipe::parse("(mesh: (path: \"a.ply\"))").unwrap();
    assert_eq!(recipe, Recipe::bare_mesh(MeshSource::File(file)));
    let CurvatureRecipe { method, hard_edge_degrees, encoding, directions, uv_directions } = recipe.curvature;
    assert_eq!((method, hard_edge_degrees, encoding), (CurvatureMethod::Accurate, 30.0, CurvatureEncoding::F16));
    assert_eq!((directions, uv_directions), (None, false));
}

#[test]
fn a_surface_is_a_mesh_too() {
    let surface = ParametricSurface::Torus { major: 2.0, minor: 0.5 };
    let of = |pattern, seed, uv_seam| {
        let tessellation = Tessellation { vertices: 4000, pattern, seed, uv_seam };
        Ok(MeshSource::Surface(Box::new(SurfaceSource { surface, tessellation })))
    };
    let torus = "surface: Torus(major: 2.0, minor: 0.5), vertices: 4000";
    assert_eq!(mesh(torus), of(Pattern::Jittered, 0, false));
    let all = format!("{torus}, pattern: LongThin(aspect: 20.0), seed: 7, uv_seam: true");
    assert_eq!(mesh(&all), of(Pattern::LongThin { aspect: 20.0 }, 7, true));
}

#[test]
fn a_mesh_is_a_file_or_a_surface() {
    let sphere = "surface: Sphere(radius: 1.0)";
    for (fields, expected) in [
        ("", "neither `path` nor `surface` is there; one of them is needed"),
        (&format!("path: \"a\", {sphere}"), "`path` and `surface` are both there; one of them is accepted"),
        ("path: \"a\", seed: 1", "`seed` is for a `surface`; beside `path` only `mesh` is accepted"),
        (&format!("{sphere}, mesh: \"a\""), "`mesh` is for a `path`, of a glTF file"),
        (sphere, "the field `vertices` is missing"),
    ] {
        let found = mesh(fields).unwrap_err();
        assert!(found.starts_with("line 1, column ") && found.ends_with(&format!(": mesh: {expected}")), "{found}");
    }
}

#[test]
fn the_mesh_has_the_unit_of_the_heights() {
    let units = |text: &str| {
        let recipe = Recipe::parse(text).unwrap();
        (recipe.height_unit(), recipe.mesh_unit())
    };
    // A mesh alone is left to its format, which may know.
    assert_eq!(units("(mesh: (path: \"a\"))"), (LengthUnit::SceneUnit, None));
    assert_eq!(units("(mesh: (path: \"a\"), unit: metre)"), (LengthUnit::Metre, Some(LengthUnit::Metre)));
    let both = format!("({PLANE}, mesh: (path: \"a\"))");
    assert_eq!(units(&both), (LengthUnit::SceneUnit, Some(LengthUnit::SceneUnit)));
}
