//! What is baked, what is left out, and why.

use barchan_field::Shape;
use barchan_field::shapes::Plane;
use barchan_pipeline::{Decision, Plan, Recipe, Scene, ShapeSource, Source, Table};

fn plan(scene: Option<Scene>, only: Option<&[Table]>) -> Plan {
    let shape = Shape::Plane(Plane { slope_u: 0.5, slope_v: 0.0 });
    let mut recipe = Recipe::bare(Source::Shape(ShapeSource { shape, width: 4, height: 4 }));
    recipe.scene = scene;
    Plan::new(recipe, only)
}

/// Baked or not, and why, for each table.
fn decisions(plan: &Plan) -> [(bool, &'static str); 3] {
    Table::ALL.map(|table| {
        let planned = plan.tables.iter().find(|planned| planned.table == table).unwrap();
        assert_eq!(plan.bakes(table), planned.decision == Decision::Bake);
        (plan.bakes(table), planned.reason)
    })
}

#[test]
fn without_a_scene_everything_is_baked() {
    let reasons = ["the surface itself", "shadows", "no recipe says that the scene does without it"];
    assert_eq!(decisions(&plan(None, None)), reasons.map(|reason| (true, reason)));
}

#[test]
fn a_scene_decides_on_the_distance_alone() {
    let scene = |curved_surfaces, soft_shadows| plan(Some(Scene { curved_surfaces, soft_shadows }), None);
    for (plan, distance) in [
        (scene(false, false), (false, "the scene has no curved surfaces and no soft shadows")),
        (scene(true, false), (true, "corrects the horizon on curved surfaces")),
        (scene(false, true), (true, "sizes penumbrae")),
        (scene(true, true), (true, "corrects the horizon on curved surfaces")),
    ] {
        assert_eq!(decisions(&plan), [(true, "the surface itself"), (true, "shadows"), distance]);
    }
}

#[test]
fn only_has_the_last_word() {
    let all = Scene { curved_surfaces: true, soft_shadows: true };
    for scene in [None, Some(Scene::default()), Some(all)] {
        let (named, left) = ((true, "named by --only"), (false, "not named by --only"));
        assert_eq!(decisions(&plan(scene, Some(&[Table::Distance]))), [left, left, named]);
        assert_eq!(decisions(&plan(scene, Some(&[Table::Horizon, Table::Height]))), [named, named, left]);
        assert_eq!(decisions(&plan(scene, Some(&[]))), [left, left, left]);
    }
}

#[test]
fn tables_are_planned_in_the_order_of_the_file() {
    let tables: Vec<_> = plan(None, Some(&[Table::Distance])).tables.iter().map(|planned| planned.table).collect();
    assert_eq!(tables, Table::ALL);
    assert_eq!(Table::ALL.map(Table::name), ["height", "horizon", "distance"]);
}
