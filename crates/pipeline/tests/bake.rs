//! Plans carried out: the file, the report, the provenance and the error that is claimed.

mod common;

use std::sync::Mutex;

use barchan_asset::{
    ApertureConeView, Asset, BentNormalView, HorizonView, Limits, Section, SkyVisibilityView, SweptDistanceView,
    SweptHorizonView, validate,
};
use barchan_bakers::horizon::{Azimuths, HorizonParams, Method, reference};
use barchan_field::shapes::FractalTerrain;
use barchan_field::{Edge, Grid, HeightField, LengthUnit, Shape, Spacing};
use barchan_pipeline::{
    Compression, HorizonAccuracy, HorizonMethod, InputProvenance, PROVENANCE_SCHEMA, PipelineError, Provenance, Recipe,
    Scene, ShapeSource, Source, Table, TableEncoding,
};

use crate::common::{Baked, bake_on};

const SHAPE: Shape =
    Shape::FractalTerrain(FractalTerrain { height: 9.0, hurst: 0.8, features_across: 2, octaves: 4, seed: 5 });
const DIRECTIONS: u32 = 6;
const RADIUS: f64 = 12.0;

fn recipe() -> Recipe {
    let mut recipe = Recipe::bare(Source::Shape(ShapeSource { shape: SHAPE, width: 24, height: 20 }));
    recipe.spacing = Spacing::new(0.5, 0.75).unwrap();
    (recipe.edge, recipe.unit) = (Edge::Wrap, Some(LengthUnit::Metre));
    (recipe.horizon.directions, recipe.horizon.radius) = (DIRECTIONS, Some(RADIUS));
    (recipe.hemisphere.rings, recipe.hemisphere.azimuths, recipe.hemisphere.size) = (3, 4, Some((12, 9)));
    recipe
}

fn field() -> HeightField {
    let spacing = Spacing::new(0.5, 0.75).unwrap();
    SHAPE.rasterize(Grid { width: 24, height: 20, spacing, unit: LengthUnit::Metre, edge: Edge::Wrap }).unwrap()
}

fn baked(recipe: Recipe, only: Option<&[Table]>) -> Baked {
    bake_on(2, recipe, only, &|_, _, _| {}).unwrap()
}

fn fails(recipe: Recipe, only: Option<&[Table]>) -> PipelineError {
    bake_on(1, recipe, only, &|_, _, _| {}).unwrap_err()
}

/// [`recipe`] for surfaces of a range of curvatures.
fn curved_recipe() -> Recipe {
    let mut recipe = recipe();
    recipe.scene = Some(Scene { curvature: Some((-0.02, 0.04)), ..Scene::default() });
    recipe.curved.points = Some(3);
    recipe
}

/// Every table that is baked from heights.
fn textures() -> Vec<Table> {
    Table::ALL.into_iter().filter(|table| !table.is_of_a_mesh()).collect()
}

fn section(asset: &Asset<'_>, table: Table) -> Vec<u8> {
    asset.section(table.kind()).unwrap().payload(&Limits::default()).unwrap().into_owned()
}

fn provenance(asset: &Asset<'_>) -> Provenance {
    let payload = asset.sections().last().unwrap().payload(&Limits::default()).unwrap().into_owned();
    serde_json::from_slice(&payload).unwrap()
}

#[test]
fn what_is_baked_is_valid_and_said_in_the_report() {
    let Baked { bytes, report } = baked(recipe(), None);
    assert_eq!(validate(&bytes, &Limits::default()), []);
    let asset = Asset::open(&bytes).unwrap();
    assert_eq!(report.file_bytes, bytes.len() as u64);
    let tables: Vec<_> = report.tables.iter().map(|table| (table.table, table.layers, table.unit)).collect();
    let expected = [
        ("height", 1, "m"),
        ("horizon", DIRECTIONS, "rad"),
        ("distance", DIRECTIONS, "m"),
        ("sky_visibility", 1, ""),
        ("bent_normal", 1, ""),
    ];
    assert_eq!(tables, expected);
    for (table, section) in report.tables.iter().zip(asset.sections()) {
        assert_eq!((table.stored_bytes, table.raw_bytes), (section.stored_length(), section.raw_length()));
        assert_eq!(table.worst_case_error, section.texture().unwrap().worst_case_error);
    }
    let grid = report.grid.unwrap();
    assert_eq!((grid.width, grid.height, grid.edge), (24, 20, "wrap"));
    assert_eq!((grid.lowest, grid.highest), field().range());
    assert_eq!(report.source.as_deref(), Some("generated fractal_terrain"));
}

#[test]
fn provenance_reads_back_as_it_was_written() {
    let mut recipe = recipe();
    let scene = Scene { soft_shadows: true, ..Scene::default() };
    recipe.scene = Some(scene);
    recipe.horizon.encoding = TableEncoding::U8;
    let Baked { bytes, report } = baked(recipe, None);
    let asset = Asset::open(&bytes).unwrap();
    let provenance = provenance(&asset);
    assert_eq!(provenance.schema, PROVENANCE_SCHEMA);
    let shape = ShapeSource { shape: SHAPE, width: 24, height: 20 };
    assert_eq!(provenance.input, Some(InputProvenance::Shape(shape)));
    assert_eq!(provenance.recipe.spacing, (0.5, 0.75));
    assert_eq!((provenance.recipe.unit, provenance.recipe.edge), (LengthUnit::Metre, Edge::Wrap));
    assert_eq!(provenance.horizon, report.horizon);
    assert_eq!(provenance.recipe.tables, ["height", "horizon", "distance"]);
    assert_eq!(provenance.recipe.horizon_encoding, TableEncoding::U8);
    assert_eq!(provenance.recipe.scene, Some(scene));
    // Round trip to the bit: what a program reads and writes again is the same section.
    let stored = asset.sections().last().unwrap();
    let again = serde_json::to_string_pretty(&provenance).unwrap();
    assert_eq!(stored.raw_payload(), Some(again.as_bytes()));
}

#[test]
fn a_default_radius_is_spelled_out() {
    let mut recipe = recipe();
    recipe.horizon.radius = None;
    let horizon = baked(recipe, None).report.horizon.unwrap();
    assert_eq!((horizon.directions, horizon.radius), (DIRECTIONS, 20.0 * 0.75));
}

#[test]
fn the_error_that_is_claimed_is_the_one_against_the_reference() {
    let Baked { bytes, report } = baked(recipe(), None);
    let asset = Asset::open(&bytes).unwrap();
    let horizon = asset.section(Table::Horizon.kind()).unwrap();
    let payload = section(&asset, Table::Horizon);
    let view = HorizonView::new(horizon.texture().unwrap(), &payload).unwrap();
    let claimed = report.horizon.unwrap().accuracy.unwrap();

    let params = HorizonParams {
        azimuths: Azimuths::full_circle(DIRECTIONS),
        radius: RADIUS,
        distance: false,
        method: Method::default(),
    };
    let field = field();
    let places = (0..DIRECTIONS).flat_map(|k| (0..20).flat_map(move |row| (0..24).map(move |column| (k, column, row))));
    let errors = places.map(|(k, column, row)| {
        let truth = reference::horizon(&field, &params, k, column, row).slope.atan();
        (f64::from(view.elevation_radians(k, column, row)) - truth).to_degrees()
    });
    let stats = barchan_metrics::ErrorStats::of(errors);
    // The claim is made on a sample of the texels: it cannot be above the maximum of all, and its mean is near theirs.
    assert!(claimed.stored_max_degrees <= stats.max() * (1.0 + 1e-9), "{claimed:?}, {}", stats.max());
    assert!(claimed.stored_max_degrees >= 0.5 * stats.max(), "{claimed:?}, {}", stats.max());
    assert!((claimed.stored_rms_degrees / stats.rms() - 1.0).abs() < 0.25, "{claimed:?}, {}", stats.rms());
}

#[test]
fn encoding_adds_its_own_error_and_no_more() {
    let accuracy = |encoding| -> HorizonAccuracy {
        let mut recipe = recipe();
        recipe.horizon.encoding = encoding;
        let Baked { bytes, report } = baked(recipe, None);
        let asset = Asset::open(&bytes).unwrap();
        let stated = asset.section(Table::Horizon.kind()).unwrap().texture().unwrap().worst_case_error.to_degrees();
        let accuracy = report.horizon.unwrap().accuracy.unwrap();
        assert!(accuracy.stored_max_degrees <= accuracy.sweep_max_degrees + stated + 1e-5, "{accuracy:?}, {stated}");
        accuracy
    };
    let (exact, half, byte) = (accuracy(TableEncoding::F32), accuracy(TableEncoding::F16), accuracy(TableEncoding::U8));
    assert_eq!(
        (exact.stored_rms_degrees, exact.stored_max_degrees),
        (exact.sweep_rms_degrees, exact.sweep_max_degrees)
    );
    let compact = accuracy(TableEncoding::Compact);
    for other in [half, byte, compact] {
        assert_eq!(other.sweep_rms_degrees, exact.sweep_rms_degrees, "the same sweep, the same sample");
    }
    assert!(byte.stored_rms_degrees > half.stored_rms_degrees);
}

#[test]
fn without_a_horizon_table_nothing_is_claimed_about_it() {
    let report = baked(recipe(), Some(&[Table::Distance])).report;
    assert_eq!(report.horizon.unwrap().accuracy, None);
    let report = baked(recipe(), Some(&[Table::Height])).report;
    assert_eq!((report.horizon, report.mtexel_directions_per_second), (None, None));
}

#[test]
fn what_is_left_out_is_weighed() {
    let mut recipe = recipe();
    recipe.scene = Some(Scene::default());
    recipe.distance.encoding = TableEncoding::F32;
    let report = baked(recipe, None).report;
    let left_out: Vec<_> = report.left_out.iter().map(|left| (left.table, left.bytes_saved)).collect();
    let (texels, directions) = (24 * 20, u64::from(DIRECTIONS));
    let expected = [
        ("distance", texels * directions * 4),
        ("swept_horizon", texels * directions),
        ("swept_distance", texels * directions),
        ("sky_visibility", texels),
        ("bent_normal", 2 * texels),
        ("aperture_cone", 4 * texels),
        ("hemisphere", 12 * 9 * 3 * 4),
        ("cone_map", 2 * texels),
        ("relaxed_cone_map", 2 * texels),
        ("maximum_mip", 2 * (texels + 12 * 10 + 6 * 5 + 3 * 2 + 1)),
    ];
    assert_eq!(left_out, expected);
}

#[test]
fn packing_keeps_every_table() {
    let mut raw = recipe();
    // Large enough that a packed table takes fewer pages.
    raw.source = Some(Source::Shape(ShapeSource { shape: SHAPE, width: 96, height: 80 }));
    let packed = Recipe { compression: Compression::Zstd, ..raw.clone() };
    let (raw, packed) = (baked(raw, None).bytes, baked(packed, None).bytes);
    assert!(packed.len() < raw.len());
    let (raw, packed) = (Asset::open(&raw).unwrap(), Asset::open(&packed).unwrap());
    for table in [Table::Height, Table::Horizon, Table::Distance, Table::SkyVisibility, Table::BentNormal] {
        assert_eq!(section(&raw, table), section(&packed, table));
    }
    let codecs =
        |asset: &Asset<'_>| asset.sections().map(|section: Section<'_>| section.codec_number()).collect::<Vec<_>>();
    assert_eq!(codecs(&raw)[..3], [0; 3]);
    assert_eq!(codecs(&packed)[..3], [1; 3]);
}

#[test]
fn every_stage_is_announced_and_timed_in_order() {
    let steps = Mutex::new(Vec::new());
    let progress = |stage, done, total| steps.lock().unwrap().push((stage, done, total));
    let report = bake_on(1, recipe(), None, &progress).unwrap().report;
    let stages: Vec<_> = report.stages.iter().map(|stage| stage.stage).collect();
    assert_eq!(stages, ["source", "encode", "write", "bounds", "horizon", "sky", "measure", "checksum"]);
    let mut announced: Vec<_> = steps.lock().unwrap().iter().map(|(stage, ..)| *stage).collect();
    announced.dedup();
    assert_eq!(announced, ["source", "horizon", "measure", "checksum"]);
    for direction in 0..=DIRECTIONS as usize {
        assert!(steps.lock().unwrap().contains(&("horizon", direction, DIRECTIONS as usize)));
    }
}

#[test]
fn whoever_must_act_is_told_apart() {
    let fails = |recipe: Recipe| fails(recipe, None);
    let missing = fails(Recipe::parse("(source: HeightMap(path: \"none.png\"))").unwrap());
    assert!(missing.is_io());
    assert!(
        missing
            .to_string()
            .ends_with("none.png: there is no such file; a PNG, EXR, TIFF, NPY, OBJ, PLY or glTF file is needed")
    );
    let mut none = recipe();
    none.horizon.directions = 0;
    let none = fails(none);
    assert!(!none.is_io() && matches!(none, PipelineError::Bake { .. }));
    assert_eq!(none.to_string(), "horizon: directions is 0; 1 to 2048 azimuths are accepted");
    let huge = Recipe::bare(Source::Shape(ShapeSource { shape: SHAPE, width: 1 << 20, height: 1 << 20 }));
    assert_eq!(
        fails(huge).to_string(),
        "source: 1048576 × 1048576 texels are 1099511627776; at most 268435456 are accepted"
    );
}

#[test]
fn an_arc_is_baked_from_end_to_end_and_said_in_the_provenance() {
    let mut arc = recipe();
    arc.horizon.arc = Some((180.0, 300.0));
    arc.horizon.directions = 3;
    let Baked { bytes, report } = baked(arc, None);
    assert_eq!(validate(&bytes, &Limits::default()), []);
    let asset = Asset::open(&bytes).unwrap();
    assert_eq!(provenance(&asset).horizon.unwrap().arc, Some((180.0, 300.0)));
    let texture = asset.section(Table::Horizon.kind()).unwrap().texture().unwrap();
    let azimuths: Vec<_> = (0..3).map(|k| texture.azimuths().unwrap().radians(k).to_degrees().round()).collect();
    assert_eq!(azimuths, [180.0, 240.0, 300.0]);
    // The same azimuths of a full circle have the same values.
    let circle = baked(recipe(), None).bytes;
    let circle = Asset::open(&circle).unwrap();
    let (arc, circle) = (section(&asset, Table::Horizon), section(&circle, Table::Horizon));
    let layer = |payload: &[u8], k: usize| payload[512 * k..][..480].to_vec();
    for k in 0..3 {
        assert_eq!(layer(&arc, k), layer(&circle, k + 3));
    }
    let sky = report.left_out.iter().find(|left| left.table == "sky_visibility").unwrap();
    assert_eq!(sky.reason, "an arc of azimuths does not see all of the sky");
}

#[test]
fn the_sky_is_the_one_its_baker_makes_of_the_same_horizons() {
    use barchan_bakers::{Exec, sky};
    let mut recipe = recipe();
    recipe.sky.encoding = TableEncoding::F32;
    recipe.scene = Some(Scene { ambient_light: true, area_lights: true, ..Scene::default() });
    let Baked { bytes, report } = baked(recipe, None);
    assert_eq!(validate(&bytes, &Limits::default()), []);
    let asset = Asset::open(&bytes).unwrap();
    let texture = |table: Table| asset.section(table.kind()).unwrap().texture().unwrap();
    let payload = |table| section(&asset, table);
    let (visibility, bent, cone) =
        (payload(Table::SkyVisibility), payload(Table::BentNormal), payload(Table::ApertureCone));
    let visibility = SkyVisibilityView::new(texture(Table::SkyVisibility), &visibility).unwrap();
    let bent = BentNormalView::new(texture(Table::BentNormal), &bent).unwrap();
    let cone = ApertureConeView::new(texture(Table::ApertureCone), &cone).unwrap();
    let params = HorizonParams {
        azimuths: Azimuths::full_circle(DIRECTIONS),
        radius: RADIUS,
        distance: false,
        method: Method::default(),
    };
    let expected = sky::bake(&field(), &params, sky::SkyParams::ALL, &Exec::new(1).unwrap()).unwrap();
    for texel in 0..24 * 20_u32 {
        let (column, row, index) = (texel % 24, texel / 24, texel as usize);
        let near = |a: f32, b: f32| (a - b).abs() < 1e-6;
        assert!(near(visibility.visibility(column, row), expected.visibility.as_ref().unwrap()[index]));
        assert!(near(bent.normal(column, row)[1], expected.bent_normal.as_ref().unwrap()[2 * index + 1]));
        let cosine = cone.cosine_of_half_angle(column, row);
        assert!(near(cosine, expected.aperture_cone.as_ref().unwrap()[4 * index + 3]));
    }
    assert_eq!(provenance(&asset).sky.unwrap().algorithm, sky::ALGORITHM);
    let reasons: Vec<_> = report.tables.iter().map(|table| (table.table, table.reason)).skip(2).collect();
    let expected = [
        ("sky_visibility", "dims the light of the sky"),
        ("bent_normal", "turns the light of the sky"),
        ("aperture_cone", "cuts area lights"),
    ];
    assert_eq!(reasons, expected);
}

#[test]
fn further_points_for_curved_surfaces_lie_beside_their_horizon() {
    let Baked { bytes, report } = baked(curved_recipe(), None);
    assert_eq!(validate(&bytes, &Limits::default()), []);
    let asset = Asset::open(&bytes).unwrap();
    let texture = asset.section(Table::SweptHorizon.kind()).unwrap().texture().unwrap();
    assert_eq!((texture.candidates, texture.layers), (2, 2 * DIRECTIONS));
    assert_eq!((texture.curvature_min, texture.curvature_max), (-0.02, 0.04));
    assert_eq!((provenance(&asset).swept.unwrap().points, report.swept.unwrap().points), (3, 3));
    let (elevations, distances) = (section(&asset, Table::SweptHorizon), section(&asset, Table::SweptDistance));
    let elevations = SweptHorizonView::new(texture, &elevations).unwrap();
    let distance_texture = asset.section(Table::SweptDistance.kind()).unwrap().texture().unwrap();
    let distances = SweptDistanceView::new(distance_texture, &distances).unwrap();
    let horizon = section(&asset, Table::Horizon);
    let horizon = HorizonView::new(asset.section(Table::Horizon.kind()).unwrap().texture().unwrap(), &horizon).unwrap();
    let places = (0..DIRECTIONS).flat_map(|k| (0..20).flat_map(move |row| (0..24).map(move |column| (k, column, row))));
    let stated = |table: Table| asset.section(table.kind()).unwrap().texture().unwrap().worst_case_error;
    let tolerance = (stated(Table::Horizon) + stated(Table::SweptHorizon)) as f32 + 1e-5;
    let mut further = 0;
    for (k, column, row) in places {
        let flat = horizon.elevation_radians(k, column, row);
        for candidate in 0..2 {
            let elevation = elevations.elevation_radians(candidate, k, column, row);
            assert!(elevation <= flat + tolerance, "a point above the horizon: {elevation} {flat}");
            further += u32::from(elevation < flat - tolerance);
            assert!((0.0..=RADIUS as f32).contains(&distances.distance(candidate, k, column, row)));
        }
    }
    assert!(further > 100, "{further}");
}

#[test]
fn points_are_as_few_as_keep_the_error() {
    let points = |degrees: f64| {
        let mut recipe = curved_recipe();
        (recipe.curved.points, recipe.curved.max_error_degrees) = (None, Some(degrees));
        baked(recipe, None)
    };
    let (coarse, fine) = (points(80.0), points(0.5));
    assert_eq!(coarse.report.swept.unwrap().points, 1);
    let left_out = coarse.report.left_out.iter().find(|left| left.table == "swept_horizon").unwrap();
    assert_eq!(left_out.reason, "the flat horizon alone keeps the error asked for");
    assert!(fine.report.swept.unwrap().points > 1);
    assert_eq!(validate(&coarse.bytes, &Limits::default()), []);
}

#[test]
fn the_same_bytes_on_one_thread_and_on_several_whatever_is_baked() {
    for recipe in [recipe(), curved_recipe()] {
        let on = |threads| bake_on(threads, recipe.clone(), Some(&every_table(&recipe)), &|_, _, _| {}).unwrap().bytes;
        let one = on(1);
        for threads in [2, 3] {
            assert!(on(threads) == one, "{threads} threads");
        }
    }
}

/// All tables that a recipe can have.
fn every_table(recipe: &Recipe) -> Vec<Table> {
    let swept = recipe.scene.is_some_and(|scene| scene.curvature.is_some());
    textures().into_iter().filter(|table| swept || !table.is_swept()).collect()
}

#[test]
fn every_encoding_of_every_table_is_valid_and_keeps_its_bound() {
    for encoding in [TableEncoding::F32, TableEncoding::F16, TableEncoding::U8, TableEncoding::Compact] {
        let mut recipe = curved_recipe();
        (recipe.height.encoding, recipe.horizon.encoding, recipe.distance.encoding) = (encoding, encoding, encoding);
        (recipe.curved.encoding, recipe.sky.encoding) = (encoding, encoding);
        (recipe.hemisphere.encoding, recipe.cone_map.encoding, recipe.maximum_mip.encoding) =
            (encoding, encoding, encoding);
        let Baked { bytes, report } = baked(recipe, Some(&textures()));
        assert_eq!(validate(&bytes, &Limits::default()), []);
        let asset = Asset::open(&bytes).unwrap();
        let provenance = provenance(&asset);
        assert_eq!((report.tables.len(), provenance.encodings.len()), (12, 12));
        for (table, stored) in report.tables.iter().zip(&provenance.encodings) {
            assert_eq!((table.table, table.encoding_rms, table.encoding_max), (&*stored.table, stored.rms, stored.max));
            assert!(table.encoding_max <= table.worst_case_error, "{table:?}");
            assert!(table.encoding_rms <= table.encoding_max, "{table:?}");
            assert_eq!(encoding == TableEncoding::F32, table.encoding_max == 0.0, "{table:?}");
        }
    }
}

#[test]
fn an_exact_bake_is_more_exact_than_a_sweep() {
    let accuracy = |method| {
        let mut recipe = recipe();
        (recipe.horizon.method, recipe.horizon.encoding) = (method, TableEncoding::F32);
        let Baked { bytes, report } = baked(recipe, None);
        let asset = Asset::open(&bytes).unwrap();
        assert_eq!(provenance(&asset).horizon.unwrap().method, Some(method));
        report.horizon.unwrap().accuracy.unwrap()
    };
    let [sweep, accurate, exact] = [HorizonMethod::Sweep, HorizonMethod::Accurate, HorizonMethod::Exact].map(accuracy);
    assert!(exact.sweep_max_degrees < 1e-3, "{exact:?}");
    assert!(exact.sweep_rms_degrees <= accurate.sweep_rms_degrees, "{accurate:?}");
    assert!(accurate.sweep_rms_degrees <= sweep.sweep_rms_degrees, "{sweep:?}");
}

#[test]
fn what_a_table_needs_and_the_recipe_does_not_say_is_asked_for() {
    let says = |change: &dyn Fn(&mut Recipe), only: Option<&[Table]>| {
        let mut recipe = recipe();
        change(&mut recipe);
        fails(recipe, only).to_string()
    };
    assert_eq!(
        says(&|_| {}, Some(&[Table::SweptHorizon])),
        "scene: `curvature` is missing; swept_horizon needs a range, such as `curvature: (0.0, 0.02)`"
    );
    let ambient = Some(Scene { ambient_light: true, ..Scene::default() });
    let arc = |recipe: &mut Recipe| (recipe.scene, recipe.horizon.arc) = (ambient, Some((0.0, 90.0)));
    let whole = "the sky is all around a texel: only the full circle of azimuths is accepted where it is baked";
    assert_eq!(says(&arc, None), format!("horizon: arc is 0 to 90; {whole}"));
    let two = |recipe: &mut Recipe| (recipe.scene, recipe.horizon.directions) = (ambient, 2);
    assert_eq!(says(&two, None), "horizon: directions is 2; 3 to 2048 azimuths are accepted where a sky is baked");
    let backwards = |recipe: &mut Recipe| recipe.horizon.arc = Some((90.0, 0.0));
    let accepted = "degrees from within ±360 to a larger number, less than 360 beyond, are accepted";
    assert_eq!(says(&backwards, None), format!("horizon: arc is 90 to 0; {accepted}"));
    let curvature = |range| Some(Scene { curvature: Some(range), ..Scene::default() });
    let swapped = |recipe: &mut Recipe| recipe.scene = curvature((0.1, -0.1));
    let finite = "two finite numbers, the smaller first, are accepted";
    assert_eq!(says(&swapped, None), format!("curved: curvature is 0.1 to -0.1; {finite}"));
    let many = |recipe: &mut Recipe| (recipe.scene, recipe.curved.points) = (curvature((0.0, 0.1)), Some(9));
    assert_eq!(says(&many, None), "curved: points is 9; 1 to 8 points are accepted");
}

#[test]
fn level_ground_is_stored_exactly_in_any_encoding() {
    for encoding in [TableEncoding::F32, TableEncoding::F16, TableEncoding::U8, TableEncoding::Compact] {
        let mut recipe = curved_recipe();
        let level = Shape::Plane(barchan_field::shapes::Plane { slope_u: 0.0, slope_v: 0.0 });
        recipe.source = Some(Source::Shape(ShapeSource { shape: level, width: 12, height: 9 }));
        (recipe.horizon.encoding, recipe.curved.encoding, recipe.sky.encoding) = (encoding, encoding, encoding);
        let Baked { bytes, report } = baked(recipe, Some(&textures()));
        assert_eq!(validate(&bytes, &Limits::default()), []);
        for table in report.tables.iter().filter(|table| ["horizon", "sky_visibility"].contains(&table.table)) {
            assert_eq!(table.encoding_max, 0.0, "{table:?}");
        }
        let asset = Asset::open(&bytes).unwrap();
        let range = |table: Table| asset.section(table.kind()).unwrap().texture().map(|t| (t.range_min, t.range_max));
        assert_eq!(range(Table::Horizon), Ok((0.0, 0.0)));
        assert_eq!(range(Table::SkyVisibility), Ok((1.0, 1.0)));
    }
}
