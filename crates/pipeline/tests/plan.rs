//! What is baked, what is left out, and why.

use barchan_field::Shape;
use barchan_field::shapes::Plane;
use barchan_pipeline::{
    Decision, HemisphereMode, HorizonRecipe, MeshFile, MeshSource, Plan, Recipe, ReliefMapping, ReliefSearch, Scene,
    ShapeSource, Source, Table,
};

const NO_MESH: &str = "there is no mesh";

fn plan(scene: Option<Scene>, only: Option<&[Table]>) -> Plan {
    let shape = Shape::Plane(Plane { slope_u: 0.5, slope_v: 0.0 });
    let mut recipe = Recipe::bare(Source::Shape(ShapeSource { shape, width: 4, height: 4 }));
    recipe.scene = scene;
    Plan::new(recipe, only)
}

/// Baked or not, and why, for each table.
fn decisions(plan: &Plan) -> [(bool, &'static str); 13] {
    Table::ALL.map(|table| {
        let planned = plan.tables.iter().find(|planned| planned.table == table).unwrap();
        assert_eq!(plan.bakes(table), planned.decision == Decision::Bake);
        (plan.bakes(table), planned.reason)
    })
}

#[test]
fn without_a_scene_everything_is_baked_that_is_small_or_can_be() {
    let unsaid = (true, "no recipe says that the scene does without it");
    let range = (false, "no recipe says between which curvatures");
    let cone = (false, "no recipe says that the scene has area lights");
    let (height, horizon) = ((true, "the surface itself"), (true, "shadows"));
    let rays = (false, "no recipe says that rays are followed to the relief");
    let expected =
        [height, horizon, unsaid, range, range, unsaid, unsaid, cone, rays, rays, rays, rays, (false, NO_MESH)];
    assert_eq!(decisions(&plan(None, None)), expected);
}

#[test]
fn azimuths_that_do_not_go_round_have_no_sky() {
    let sky = |horizon: HorizonRecipe| {
        let mut recipe = plan(None, None).recipe;
        recipe.horizon = horizon;
        decisions(&Plan::new(recipe, None))[5]
    };
    let all = HorizonRecipe::default();
    assert!(sky(HorizonRecipe { directions: 3, ..all }).0);
    let few = (false, "fewer than 3 azimuths do not see all of the sky");
    assert_eq!(sky(HorizonRecipe { directions: 2, ..all }), few);
    let arc = (false, "an arc of azimuths does not see all of the sky");
    assert_eq!(sky(HorizonRecipe { arc: Some((0.0, 90.0)), ..all }), arc);
}

#[test]
fn a_scene_decides_on_the_distance() {
    let scene = |curved_surfaces, soft_shadows| {
        decisions(&plan(Some(Scene { curved_surfaces, soft_shadows, ..Scene::default() }), None))
    };
    for (decisions, distance) in [
        (scene(false, false), (false, "the scene has no curved surfaces and no soft shadows")),
        (scene(true, false), (true, "corrects the horizon on curved surfaces")),
        (scene(false, true), (true, "sizes penumbrae")),
        (scene(true, true), (true, "corrects the horizon on curved surfaces")),
    ] {
        assert_eq!(decisions[..3], [(true, "the surface itself"), (true, "shadows"), distance]);
    }
}

#[test]
fn a_range_of_curvatures_asks_for_swept_tables_and_distances() {
    let scene = |curved_surfaces, curvature| {
        decisions(&plan(Some(Scene { curved_surfaces, curvature, ..Scene::default() }), None))
    };
    let kept = (true, "keeps the horizon right over the range of curvatures");
    let corrected = (true, "corrects the horizon on curved surfaces");
    for curved in [false, true] {
        assert_eq!(scene(curved, Some((0.0, 0.1)))[2..5], [corrected, kept, kept]);
    }
    assert_eq!(scene(true, None)[3], (false, "the scene does not say between which curvatures"));
    assert_eq!(scene(false, None)[3], (false, "the scene has no curved surfaces"));
}

#[test]
fn a_scene_decides_on_the_sky() {
    let scene = |ambient_light, area_lights| {
        decisions(&plan(Some(Scene { ambient_light, area_lights, ..Scene::default() }), None))[5..8].to_vec()
    };
    let dark = (false, "the scene has no ambient light");
    let (dims, turns) = ((true, "dims the light of the sky"), (true, "turns the light of the sky"));
    let (points, cuts) = ((false, "the scene has no area lights"), (true, "cuts area lights"));
    assert_eq!(scene(false, false), [dark, dark, points]);
    assert_eq!(scene(true, false), [dims, turns, points]);
    assert_eq!(scene(false, true), [dark, dark, cuts]);
    assert_eq!(scene(true, true), [dims, turns, cuts]);
}

/// What becomes of hemisphere, cone map, relaxed cone map and maximum mip.
fn search_tables(scene: Scene, mode: HemisphereMode) -> Vec<(bool, &'static str)> {
    let mut recipe = plan(Some(scene), None).recipe;
    recipe.hemisphere.mode = mode;
    decisions(&Plan::new(recipe, None))[8..12].to_vec()
}

#[test]
fn without_relief_mapping_no_table_is_baked_for_it() {
    let all = Scene { curved_surfaces: true, ambient_light: true, ..Scene::default() };
    let none = (false, "the scene has no relief mapping");
    assert_eq!(search_tables(all, HemisphereMode::Conservative), [none; 4]);
}

#[test]
fn a_search_has_its_own_table_and_a_start() {
    let searched = |search| {
        let mapping = ReliefMapping { search, ..ReliefMapping::default() };
        let scene = Scene { relief_mapping: Some(mapping), ..Scene::default() };
        search_tables(scene, HemisphereMode::Conservative)
    };
    let start = (true, "starts rays where none has hit before");
    let expected = |own: [bool; 3], reason| [vec![start], own.map(|own| (own, reason)).to_vec()].concat();
    for (search, own, reason) in [
        (ReliefSearch::ConeSteps, [true, false, false], "the search is by cone steps"),
        (ReliefSearch::RelaxedConeSteps, [false, true, false], "the search is by relaxed cone steps"),
        (ReliefSearch::MaximumMip, [false, false, true], "the search is by maximum mips"),
        (ReliefSearch::Linear, [false, false, false], "the search is by steps of one length"),
    ] {
        assert_eq!(searched(search), expected(own, reason), "{search:?}");
    }
}

#[test]
fn a_start_by_the_nearest_ray_says_that_it_may_be_beyond() {
    let scene = Scene { relief_mapping: Some(ReliefMapping::default()), ..Scene::default() };
    let start = search_tables(scene, HemisphereMode::Nearest)[0];
    assert_eq!(start, (true, "starts rays near their hits, some beyond"));
}

#[test]
fn tables_of_relief_search_need_no_horizon() {
    let plan = plan(None, Some(&[Table::Hemisphere, Table::ConeMap]));
    assert!(plan.serves_relief_search() && !plan.needs_horizon());
    assert!(!self::plan(None, Some(&[Table::Horizon])).serves_relief_search());
}

#[test]
fn only_has_the_last_word() {
    let all = Scene { curved_surfaces: true, soft_shadows: true, ambient_light: true, ..Scene::default() };
    for scene in [None, Some(Scene::default()), Some(all)] {
        for named in [vec![], vec![Table::Distance], vec![Table::Horizon, Table::ApertureCone], Table::ALL.to_vec()] {
            let plan = plan(scene, Some(&named));
            let expected = Table::ALL.map(|table| match named.contains(&table) {
                true => (true, "named by --only"),
                false if table == Table::Curvature => (false, NO_MESH),
                false => (false, "not named by --only"),
            });
            assert_eq!(decisions(&plan), expected);
            assert_eq!(plan.needs_horizon(), !named.is_empty());
        }
    }
}

#[test]
fn of_a_mesh_alone_there_is_curvature() {
    let mesh = MeshSource::File(MeshFile { path: "a.obj".into(), mesh: None });
    let plan = Plan::new(Recipe::bare_mesh(mesh), None);
    let mut expected = [(false, "there is no height map"); 13];
    expected[12] = (true, "what the mesh is there for");
    assert_eq!(decisions(&plan), expected);
    assert!(plan.tables[..12].iter().all(|planned| planned.decision == Decision::NoInput));
    assert!(!plan.needs_horizon());
}

#[test]
fn tables_are_planned_in_the_order_of_the_file() {
    let tables: Vec<_> = plan(None, Some(&[Table::Distance])).tables.iter().map(|planned| planned.table).collect();
    assert_eq!(tables, Table::ALL);
    let names = [
        "height",
        "horizon",
        "distance",
        "swept_horizon",
        "swept_distance",
        "sky_visibility",
        "bent_normal",
        "aperture_cone",
        "hemisphere",
        "cone_map",
        "relaxed_cone_map",
        "maximum_mip",
        "curvature",
    ];
    assert_eq!(Table::ALL.map(Table::name), names);
}
