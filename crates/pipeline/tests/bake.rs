//! Plans carried out: the file, the report, the provenance and the error that is claimed.

use std::path::Path;
use std::sync::Mutex;

use barchan_asset::{Asset, HorizonView, Limits, Section, validate};
use barchan_bakers::horizon::{Azimuths, HorizonParams, Method, reference};
use barchan_field::shapes::FractalTerrain;
use barchan_field::{Edge, Grid, HeightField, LengthUnit, Shape, Spacing};
use barchan_pipeline::{
    Baked, Compression, HorizonAccuracy, InputProvenance, PROVENANCE_SCHEMA, PipelineError, Plan, Provenance, Recipe,
    Scene, ShapeSource, Source, Table, TableEncoding, bake,
};

const SHAPE: Shape =
    Shape::FractalTerrain(FractalTerrain { height: 9.0, hurst: 0.8, features_across: 2, octaves: 4, seed: 5 });
const DIRECTIONS: u32 = 6;
const RADIUS: f64 = 12.0;

fn recipe() -> Recipe {
    let mut recipe = Recipe::bare(Source::Shape(ShapeSource { shape: SHAPE, width: 24, height: 20 }));
    recipe.spacing = Spacing::new(0.5, 0.75).unwrap();
    (recipe.edge, recipe.unit) = (Edge::Wrap, LengthUnit::Metre);
    (recipe.horizon.directions, recipe.horizon.radius) = (DIRECTIONS, Some(RADIUS));
    recipe
}

fn field() -> HeightField {
    let spacing = Spacing::new(0.5, 0.75).unwrap();
    SHAPE.rasterize(Grid { width: 24, height: 20, spacing, unit: LengthUnit::Metre, edge: Edge::Wrap }).unwrap()
}

fn baked(recipe: Recipe, only: Option<&[Table]>) -> Baked {
    bake(&Plan::new(recipe, only), Path::new(""), 2, &|_, _, _| {}).unwrap()
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
    assert_eq!(tables, [("height", 1, "m"), ("horizon", DIRECTIONS, "rad"), ("distance", DIRECTIONS, "m")]);
    for (table, section) in report.tables.iter().zip(asset.sections()) {
        assert_eq!((table.stored_bytes, table.raw_bytes), (section.stored_length(), section.raw_length()));
        assert_eq!(table.worst_case_error, section.texture().unwrap().worst_case_error);
    }
    assert_eq!((report.grid.width, report.grid.height, report.grid.edge), (24, 20, "wrap"));
    assert_eq!((report.grid.lowest, report.grid.highest), field().range());
    assert_eq!(report.source, "generated fractal_terrain");
}

#[test]
fn provenance_reads_back_as_it_was_written() {
    let mut recipe = recipe();
    recipe.scene = Some(Scene { curved_surfaces: false, soft_shadows: true });
    recipe.horizon.encoding = TableEncoding::U8;
    let Baked { bytes, report } = baked(recipe, None);
    let asset = Asset::open(&bytes).unwrap();
    let provenance = provenance(&asset);
    assert_eq!(provenance.schema, PROVENANCE_SCHEMA);
    assert_eq!(provenance.input, InputProvenance::Shape(ShapeSource { shape: SHAPE, width: 24, height: 20 }));
    assert_eq!(provenance.recipe.spacing, (0.5, 0.75));
    assert_eq!((provenance.recipe.unit, provenance.recipe.edge), (LengthUnit::Metre, Edge::Wrap));
    assert_eq!(provenance.horizon, report.horizon);
    assert_eq!(provenance.recipe.tables, ["height", "horizon", "distance"]);
    assert_eq!(provenance.recipe.horizon_encoding, TableEncoding::U8);
    assert_eq!(provenance.recipe.scene, Some(Scene { curved_surfaces: false, soft_shadows: true }));
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
    for other in [half, byte] {
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
    let [left_out] = &report.left_out[..] else { panic!("{:?}", report.left_out) };
    assert_eq!((left_out.table, left_out.bytes_saved), ("distance", 24 * 20 * u64::from(DIRECTIONS) * 4));
}

#[test]
fn packing_keeps_every_table() {
    let mut packed = recipe();
    packed.compression = Compression::Zstd;
    let (raw, packed) = (baked(recipe(), None).bytes, baked(packed, None).bytes);
    assert!(packed.len() < raw.len());
    let (raw, packed) = (Asset::open(&raw).unwrap(), Asset::open(&packed).unwrap());
    for table in Table::ALL {
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
    let report = bake(&Plan::new(recipe(), None), Path::new(""), 1, &progress).unwrap().report;
    let stages: Vec<_> = report.stages.iter().map(|stage| stage.stage).collect();
    assert_eq!(stages, ["source", "horizon", "encode", "measure", "pack"]);
    let mut announced: Vec<_> = steps.lock().unwrap().iter().map(|(stage, ..)| *stage).collect();
    announced.dedup();
    assert_eq!(announced, stages);
    for direction in 1..=DIRECTIONS as usize {
        assert!(steps.lock().unwrap().contains(&("horizon", direction, DIRECTIONS as usize)));
    }
}

#[test]
fn whoever_must_act_is_told_apart() {
    let fails = |recipe: Recipe| bake(&Plan::new(recipe, None), Path::new("maps"), 1, &|_, _, _| {}).unwrap_err();
    let missing = fails(Recipe::parse("(source: HeightMap(path: \"none.png\"))").unwrap());
    assert!(missing.is_io());
    assert!(missing.to_string().ends_with("none.png: there is no such file; a PNG, EXR, TIFF or NPY file is needed"));
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
