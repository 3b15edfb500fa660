//! Tables for relief search, baked by a recipe: from the heights as stored, over the directions that the scene has, and as good as is
//! said of them.

mod common;

use std::f64::consts::TAU;
use std::sync::Mutex;

use barchan_asset::{
    Asset, ConeMapView, DepthMode, HeightView, HemisphereView, Limits, MaximumMipView, RelaxedConeMapView, RingSpacing,
    TextureDescriptor, validate,
};
use barchan_bakers::cone::{self, ConeKind};
use barchan_bakers::hemisphere::reference::FirstHits;
use barchan_bakers::hemisphere::{self, HemisphereParams};
use barchan_bakers::{Exec, maximum_mip};
use barchan_field::shapes::FractalTerrain;
use barchan_field::{Edge, Grid, HeightField, LengthUnit, Shape, Spacing};
use barchan_pipeline::{
    Compression, HemisphereMode, HemisphereSpacing, Provenance, Recipe, ReliefMapping, ReliefSearch, Scene,
    ShapeSource, Source, Table, TableEncoding,
};
use glam::DVec3;

use crate::common::{Baked, bake_on};

const SHAPE: Shape =
    Shape::FractalTerrain(FractalTerrain { height: 9.0, hurst: 0.8, features_across: 2, octaves: 4, seed: 5 });
const SEARCH: [Table; 4] = [Table::Hemisphere, Table::ConeMap, Table::RelaxedConeMap, Table::MaximumMip];
const WIDTH: u32 = 24;
const HEIGHT: u32 = 20;

/// Fractal relief that is searched by cone steps, in few directions.
fn recipe() -> Recipe {
    let mut recipe = Recipe::bare(Source::Shape(ShapeSource { shape: SHAPE, width: WIDTH, height: HEIGHT }));
    recipe.spacing = Spacing::new(0.5, 0.75).unwrap();
    (recipe.edge, recipe.unit) = (Edge::Wrap, Some(LengthUnit::Metre));
    (recipe.horizon.directions, recipe.horizon.radius) = (4, Some(4.0));
    (recipe.hemisphere.rings, recipe.hemisphere.azimuths, recipe.hemisphere.size) = (4, 6, Some((8, 5)));
    let mapping = ReliefMapping { search: ReliefSearch::ConeSteps, ..ReliefMapping::default() };
    recipe.scene = Some(Scene { relief_mapping: Some(mapping), ..Scene::default() });
    recipe
}

fn mapping(recipe: &mut Recipe) -> &mut ReliefMapping {
    recipe.scene.as_mut().unwrap().relief_mapping.as_mut().unwrap()
}

fn baked(recipe: Recipe, only: Option<&[Table]>) -> Baked {
    let baked = bake_on(2, recipe, only, &|_, _, _| {}).unwrap();
    let findings = validate(&baked.bytes, &Limits::default());
    // What is of a surface that is not in the file is said, and no error.
    let has_heights = baked.report.tables[0].table == "height";
    assert!(findings.iter().all(|finding| finding.id == "B0704" && !has_heights), "{findings:?}");
    baked
}

impl Baked {
    fn table(&self, table: Table) -> (TextureDescriptor, Vec<u8>) {
        let asset = Asset::open(&self.bytes).unwrap();
        let section = asset.section(table.kind()).unwrap();
        (section.texture().unwrap(), section.payload(&Limits::default()).unwrap().into_owned())
    }

    fn provenance(&self) -> serde_json::Value {
        let asset = Asset::open(&self.bytes).unwrap();
        let payload = asset.sections().last().unwrap().payload(&Limits::default()).unwrap().into_owned();
        serde_json::from_slice(&payload).unwrap()
    }

    /// The heights that a reader decodes.
    fn heights(&self) -> HeightField {
        let (texture, payload) = self.table(Table::Height);
        let view = HeightView::new(texture, &payload).unwrap();
        let texels = (0..HEIGHT).flat_map(|row| (0..WIDTH).map(move |column| (column, row)));
        let samples = texels.map(|(column, row)| view.height_at(column, row)).collect();
        let spacing = Spacing::new(0.5, 0.75).unwrap();
        let grid = Grid { width: WIDTH, height: HEIGHT, spacing, unit: LengthUnit::Metre, edge: Edge::Wrap };
        HeightField::new(grid, samples).unwrap()
    }
}

/// All tables of relief search in floats, from heights that bytes have made coarse.
fn coarse_heights() -> Recipe {
    let mut recipe = recipe();
    recipe.height.encoding = TableEncoding::U8;
    (recipe.hemisphere.encoding, recipe.cone_map.encoding, recipe.maximum_mip.encoding) =
        (TableEncoding::F32, TableEncoding::F32, TableEncoding::F32);
    recipe
}

#[test]
fn depths_are_those_of_the_heights_as_stored() {
    for mode in [HemisphereMode::Conservative, HemisphereMode::Nearest] {
        let mut recipe = coarse_heights();
        recipe.hemisphere.mode = mode;
        let baked = baked(recipe, Some(&[Table::Height, Table::Hemisphere]));
        let (texture, payload) = baked.table(Table::Hemisphere);
        let view = HemisphereView::new(texture, &payload).unwrap();
        let params = HemisphereParams { directions: view.directions(), width: 8, height: 5, mode: mode.into() };
        let map = hemisphere::bake(&baked.heights(), &params, &Exec::new(1).unwrap()).unwrap();
        assert_eq!((view.mode(), view.relief()), (mode.into(), map.relief));
        for layer in 0..24 {
            let texels = (0..5).flat_map(|row| (0..8).map(move |column| (column, row)));
            let depths: Vec<_> = texels.map(|(column, row)| view.depth(layer, column, row)).collect();
            assert_eq!(depths, map.layer(layer), "{mode:?}, layer {layer}");
        }
    }
}

#[test]
fn cones_and_mips_are_those_of_the_heights_as_stored() {
    let baked = baked(coarse_heights(), Some(&[&[Table::Height][..], &SEARCH].concat()));
    let (field, exec) = (baked.heights(), Exec::new(1).unwrap());
    let texels = || (0..HEIGHT).flat_map(|row| (0..WIDTH).map(move |column| (column, row)));
    let (texture, payload) = baked.table(Table::ConeMap);
    let view = ConeMapView::new(texture, &payload).unwrap();
    let values: Vec<_> = texels().flat_map(|(x, y)| [view.depth(x, y), view.ratio(x, y)]).collect();
    let cones = cone::bake(&field, ConeKind::Strict, &exec).unwrap();
    assert_eq!((values, view.relief()), (cones.values, cones.relief));
    let (texture, payload) = baked.table(Table::RelaxedConeMap);
    let view = RelaxedConeMapView::new(texture, &payload).unwrap();
    let values: Vec<_> = texels().flat_map(|(x, y)| [view.depth(x, y), view.ratio(x, y)]).collect();
    assert_eq!(values, cone::bake(&field, ConeKind::Relaxed, &exec).unwrap().values);
    let (texture, payload) = baked.table(Table::MaximumMip);
    let view = MaximumMipView::new(texture, &payload).unwrap();
    let mip = maximum_mip::bake(&field, &exec).unwrap();
    assert_eq!(view.levels() as usize, mip.levels.len());
    for (level, expected) in (0..).zip(&mip.levels) {
        let (width, height) = view.extent(level);
        let texels = (0..height).flat_map(|row| (0..width).map(move |column| (column, row)));
        let values: Vec<_> = texels.map(|(column, row)| view.value(level, column, row)).collect();
        assert_eq!(values, expected.values, "level {level}");
    }
}

#[test]
fn without_a_height_table_heights_are_taken_as_it_would_store_them() {
    let (with, without) = (vec![Table::Height, Table::Hemisphere], vec![Table::Hemisphere]);
    let [with, without] = [with, without].map(|only| baked(coarse_heights(), Some(&only)));
    assert!(with.table(Table::Hemisphere) == without.table(Table::Hemisphere));
    assert_eq!(without.report.tables.len(), 1);
}

#[test]
fn rings_and_azimuths_cover_what_the_scene_says_and_no_more() {
    let directions = |change: &dyn Fn(&mut Recipe)| {
        let mut recipe = recipe();
        change(&mut recipe);
        baked(recipe, Some(&[Table::Hemisphere])).table(Table::Hemisphere).0.directions().unwrap()
    };
    let whole = directions(&|_| {});
    assert_eq!((whole.rings, whole.azimuths.count(), whole.spacing), (4, 6, RingSpacing::SquaredTangents));
    assert!(whole.azimuths.is_full_circle());
    assert_eq!(whole.max_polar_radians.to_degrees().round(), 80.0);
    let high = directions(&|recipe| mapping(recipe).least_elevation_degrees = 20.0);
    assert_eq!(high.max_polar_radians.to_degrees().round(), 70.0);
    let unsaid = directions(&|recipe| recipe.scene = None);
    assert_eq!(unsaid.max_polar_radians, whole.max_polar_radians);
    let equal = directions(&|recipe| recipe.hemisphere.spacing = HemisphereSpacing::EqualAngles);
    assert_eq!(equal.spacing, RingSpacing::EqualAngles);
    let arc = directions(&|recipe| mapping(recipe).arc = Some((-30.0, 120.0))).azimuths;
    let degrees: Vec<_> = (0..6).map(|index| arc.radians(index).to_degrees().round()).collect();
    assert_eq!(degrees, [-30.0, 0.0, 30.0, 60.0, 90.0, 120.0]);
}

#[test]
fn a_smaller_table_has_wider_texels_over_the_same_tile() {
    let (texture, _) = baked(recipe(), None).table(Table::Hemisphere);
    assert_eq!((texture.width, texture.height), (8, 5));
    assert_eq!((texture.spacing_u, texture.spacing_v), (1.5, 3.0));
}

#[test]
fn what_is_claimed_of_starts_holds_for_other_rays() {
    for mode in [HemisphereMode::Conservative, HemisphereMode::Nearest] {
        let mut recipe = recipe();
        recipe.hemisphere.mode = mode;
        let baked = baked(recipe, None);
        let claimed = baked.report.relief_search.as_ref().unwrap().hemisphere.as_ref().unwrap().accuracy;
        let (texture, payload) = baked.table(Table::Hemisphere);
        let view = HemisphereView::new(texture, &payload).unwrap();
        let (directions, heights) = (view.directions(), baked.heights());
        let first_hits = FirstHits::of(&heights);
        let (mut starts, mut hits, mut beyond) = (0.0, 0.0, 0);
        // Every layer alike, low-discrepancy numbers within; nothing of the sample that the claim was made on.
        const RAYS: u32 = 24 * 256;
        for index in 0..RAYS {
            let random = |step: f64| (f64::from(index) * step).fract();
            let (ring, azimuth) = directions.ring_and_azimuth(index % 24);
            let (inner, outer) = (directions.tangent_of_edge(ring), directions.tangent_of_edge(ring + 1));
            let tangent = inner + random(0.754_877) * (outer - inner);
            let angle = directions.azimuths.radians(azimuth) + (random(0.569_840) - 0.5) * TAU / 6.0;
            let (u, v) = (random(0.819_172), random(0.671_043));
            let start: f64 = view.depth(index % 24, (u * 8.0) as u32, (v * 5.0) as u32).into();
            let towards = DVec3::new(tangent * angle.cos(), tangent * angle.sin(), 1.0);
            let hit = first_hits.find(u * f64::from(WIDTH) - 0.5, v * f64::from(HEIGHT) - 0.5, towards);
            (starts, hits) = (starts + start, hits + hit);
            beyond += u32::from(start > hit + 1e-6);
        }
        let mean = |sum: f64| sum / f64::from(RAYS);
        assert!((mean(starts) - claimed.mean_start).abs() < 0.02, "{} {claimed:?}", mean(starts));
        assert!((mean(hits) - claimed.mean_hit).abs() < 0.02, "{} {claimed:?}", mean(hits));
        let share = mean(beyond.into());
        assert!((share - claimed.beyond_share).abs() < 0.02, "{share} {claimed:?}");
        match mode {
            HemisphereMode::Conservative => {
                assert_eq!((share, claimed.beyond_share, claimed.beyond_max), (0.0, 0.0, 0.0));
            }
            HemisphereMode::Nearest => assert!(share > 0.02 && claimed.beyond_max > 0.01, "{share} {claimed:?}"),
        }
        assert_eq!(view.mode() == DepthMode::Nearest, mode == HemisphereMode::Nearest);
    }
}

#[test]
fn the_same_bytes_on_one_thread_and_on_several() {
    for mode in [HemisphereMode::Conservative, HemisphereMode::Nearest] {
        let mut recipe = recipe();
        recipe.hemisphere.mode = mode;
        let on = |threads| bake_on(threads, recipe.clone(), Some(&SEARCH), &|_, _, _| {}).unwrap().bytes;
        let one = on(1);
        for threads in [2, 3] {
            assert!(on(threads) == one, "{mode:?} on {threads} threads");
        }
    }
}

#[test]
fn packing_keeps_every_table() {
    let packed = Recipe { compression: Compression::Zstd, ..recipe() };
    let [raw, packed] = [recipe(), packed].map(|recipe| baked(recipe, Some(&SEARCH)));
    for table in SEARCH {
        assert!(raw.table(table) == packed.table(table), "{table:?}");
    }
}

#[test]
fn provenance_says_what_was_baked_and_nothing_of_what_was_not() {
    let baked_all = baked(recipe(), Some(&SEARCH));
    let json = baked_all.provenance();
    let provenance: Provenance = serde_json::from_value(json.clone()).unwrap();
    assert_eq!(serde_json::to_value(&provenance).unwrap(), json);
    let search = provenance.relief_search.unwrap();
    assert_eq!(Some(&search), baked_all.report.relief_search.as_ref());
    let hemisphere = search.hemisphere.unwrap();
    assert_eq!(hemisphere.algorithm, "hemisphere-conservative-1");
    assert_eq!((hemisphere.rings, hemisphere.azimuths, hemisphere.size), (4, 6, (8, 5)));
    assert_eq!((hemisphere.max_polar_degrees, hemisphere.arc), (80.0, None));
    assert_eq!(search.maximum_mip.as_deref(), Some(maximum_mip::ALGORITHM));
    assert_eq!(provenance.recipe.hemisphere, Some(recipe().hemisphere));
    let heights = baked(recipe(), Some(&[Table::Height])).provenance();
    assert_eq!(heights.get("relief_search"), None);
    for field in ["hemisphere", "cone_map_encoding", "maximum_mip_encoding"] {
        assert!(json["recipe"][field] != serde_json::Value::Null, "{field}");
        assert_eq!(heights["recipe"].get(field), None, "{field}");
    }
}

#[test]
fn every_stage_is_announced_and_rays_are_counted() {
    let steps = Mutex::new(Vec::new());
    let progress = |stage, done, total| steps.lock().unwrap().push((stage, done, total));
    let report = bake_on(1, recipe(), Some(&SEARCH), &progress).unwrap().report;
    let stages: Vec<_> = report.stages.iter().map(|stage| stage.stage).collect();
    let own = ["hemisphere", "starts", "cone_map", "relaxed_cone_map", "maximum_mip"];
    assert_eq!(stages.iter().filter(|stage| own.contains(stage)).copied().collect::<Vec<_>>(), own);
    for layer in 0..=24 {
        assert!(steps.lock().unwrap().contains(&("hemisphere", layer, 24)));
    }
    let seconds = report.stages.iter().find(|stage| stage.stage == "hemisphere").unwrap().seconds;
    let rays = f64::from(WIDTH * HEIGHT * 24);
    assert!((report.mrays_per_second.unwrap() * seconds * 1e6 / rays - 1.0).abs() < 1e-9);
    let table = &report.tables[0];
    assert_eq!((table.table, table.layers, table.rings, table.mips), ("hemisphere", 24, 4, 1));
    assert_eq!((report.tables[3].table, report.tables[3].mips), ("maximum_mip", 5));
}

#[test]
fn every_search_bakes_what_it_needs() {
    for (search, own) in [
        (ReliefSearch::ConeSteps, Some("cone_map")),
        (ReliefSearch::RelaxedConeSteps, Some("relaxed_cone_map")),
        (ReliefSearch::MaximumMip, Some("maximum_mip")),
        (ReliefSearch::Linear, None),
    ] {
        let mut recipe = recipe();
        mapping(&mut recipe).search = search;
        let names: Vec<_> = baked(recipe, None).report.tables.iter().map(|table| table.table).collect();
        let expected: Vec<_> = ["height", "horizon", "hemisphere"].into_iter().chain(own).collect();
        assert_eq!(names, expected);
    }
}

#[test]
fn level_ground_has_no_depth_and_starts_where_it_is_hit() {
    let mut recipe = recipe();
    let level = Shape::Plane(barchan_field::shapes::Plane { slope_u: 0.0, slope_v: 0.0 });
    recipe.source = Some(Source::Shape(ShapeSource { shape: level, width: 12, height: 9 }));
    let baked = baked(recipe, Some(&SEARCH));
    let accuracy = baked.report.relief_search.as_ref().unwrap().hemisphere.as_ref().unwrap().accuracy;
    assert_eq!((accuracy.mean_start, accuracy.mean_hit, accuracy.beyond_share), (0.0, 0.0, 0.0));
    assert_eq!(baked.table(Table::Hemisphere).0.relief().unwrap().thickness, 0.0);
}

#[test]
fn what_no_table_can_be_is_refused_before_anything_is_baked() {
    let says = |change: &dyn Fn(&mut Recipe)| {
        let mut recipe = recipe();
        change(&mut recipe);
        let stages = Mutex::new(Vec::new());
        let progress = |stage, _, _| stages.lock().unwrap().push(stage);
        let error = bake_on(1, recipe, None, &progress).unwrap_err();
        assert!(!error.is_io());
        assert!(stages.lock().unwrap().iter().all(|stage| *stage == "source"));
        error.to_string()
    };
    let accepted = "more than 0 and less than 90 degrees are accepted";
    for (degrees, shown) in [(0.0, "0"), (-5.0, "-5"), (90.0, "90"), (f64::NAN, "NaN"), (f64::INFINITY, "inf")] {
        let said = says(&|recipe| mapping(recipe).least_elevation_degrees = degrees);
        assert_eq!(said, format!("scene.relief_mapping: least_elevation_degrees is {shown}; {accepted}"));
    }
    assert_eq!(says(&|recipe| recipe.hemisphere.rings = 0), "hemisphere: rings is 0; 1 or more are accepted");
    assert_eq!(
        says(&|recipe| recipe.hemisphere.azimuths = 0),
        "hemisphere: azimuths is 0; 1 or more around the circle, or 2 or more in an arc, are accepted"
    );
    assert_eq!(
        says(&|recipe| (recipe.hemisphere.rings, recipe.hemisphere.azimuths) = (64, 33)),
        "hemisphere: rings × azimuths is 64 × 33; at most 2048 directions are accepted"
    );
    assert_eq!(
        says(&|recipe| recipe.hemisphere.size = Some((32, 8))),
        "hemisphere: size is 32 × 8 for a height map of 24 × 20; no more texels along a side than the height map has are \
         accepted"
    );
    assert_eq!(
        says(&|recipe| recipe.hemisphere.size = Some((8, 0))),
        "hemisphere: size is 8 × 0; at least 1 texel along each side is accepted"
    );
    let degrees = "degrees from within ±360 to a larger number, less than 360 beyond, are accepted";
    assert_eq!(
        says(&|recipe| mapping(recipe).arc = Some((90.0, 0.0))),
        format!("scene.relief_mapping: arc is 90 to 0; {degrees}")
    );
    let alone = |recipe: &mut Recipe| {
        recipe.hemisphere.azimuths = 1;
        mapping(recipe).arc = Some((0.0, 90.0));
    };
    assert_eq!(says(&alone), "hemisphere: azimuths is 1; 2 or more are accepted in an arc, which bakes both its ends");
}
