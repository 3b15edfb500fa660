//! What is planned, held against what is then baked.

use std::fs;

use serde_json::{Value, json};

use crate::support::{Place, Torus, files, noise, npy, workspace};

/// Entries of a list in a report, by the name of their table.
fn by_table<'a>(report: &'a Value, list: &str) -> Vec<(&'a str, &'a Value)> {
    let entries = report[list].as_array().unwrap();
    entries.iter().map(|entry| (entry["table"].as_str().unwrap(), entry)).collect()
}

fn decided<'a>(plan: &'a Value, decision: &str) -> Vec<(&'a str, &'a Value)> {
    by_table(plan, "tables").into_iter().filter(|(_, table)| table["decision"] == decision).collect()
}

/// Plans and bakes the same words: decisions, reasons, formats, layers and, where the plan knows them, sizes are those of the bake.
/// A swept table may turn out as not needed, which only a bake can tell.
fn agrees(place: &Place, words: &str) -> (Value, Value) {
    let plan = place.json(&format!("plan {words}"));
    let bake = place.json(&format!("bake {words} -o out.barchan"));
    let flat_alone = "the flat horizon alone keeps the error asked for";
    let is_open = |table: &Value| table["layers"].is_null();
    let baked = by_table(&bake, "tables");
    for (name, outline) in decided(&plan, "bake") {
        let Some((_, table)) = baked.iter().find(|(baked, _)| *baked == name) else {
            assert!(is_open(outline), "{words}: {name} is planned and not baked");
            assert!(by_table(&bake, "left_out").iter().any(|(left, why)| *left == name && why["reason"] == flat_alone));
            continue;
        };
        for field in ["format", "reason", "rings", "layers", "candidates", "mips", "raw_bytes"] {
            let is_known = !outline[field].is_null();
            assert!(!is_known || outline[field] == table[field], "{words}: {field} of {name}: {outline} {table}");
        }
    }
    for (name, _) in &baked {
        assert!(decided(&plan, "bake").iter().any(|(planned, _)| planned == name), "{words}: {name} is not planned");
    }
    let left_out = decided(&plan, "leave_out");
    for (name, entry) in by_table(&bake, "left_out") {
        // Parts of tables and tables without input are left out of a bake too.
        let Some((_, outline)) = left_out.iter().find(|(planned, _)| *planned == name) else { continue };
        assert_eq!(outline["reason"], entry["reason"], "{words}: {name}");
        assert!(outline["raw_bytes"].is_null() || outline["raw_bytes"] == entry["bytes_saved"], "{words}: {name}");
    }
    let said: Vec<_> = by_table(&bake, "left_out").iter().map(|(name, _)| *name).collect();
    if bake["grid"].is_object() {
        let missing = left_out.iter().find(|(name, _)| !said.contains(name) && *name != "curvature");
        assert_eq!(missing, None, "{words}");
    }
    (plan, bake)
}

fn shape(width: u32, height: u32, fields: &str) -> String {
    let ripples = "Ripples(amplitude: 2.0, waves_u: 3, waves_v: 1)";
    format!(
        "(source: Shape(shape: {ripples}, width: {width}, height: {height}), edge: wrap, \
         horizon: (directions: 4, radius: 6.0), {fields})"
    )
}

#[test]
fn a_plan_is_what_is_then_baked() {
    for (index, fields) in [
        "",
        "scene: ()",
        "scene: (soft_shadows: true, area_lights: true), distance: (encoding: f32)",
        "scene: (curvature: (0.0, 0.02)), curved: (points: 3)",
        "scene: (curvature: (0.0, 0.02)), curved: (points: 1)",
        "scene: (curvature: (0.0, 0.02)), curved: (max_error_degrees: 89)",
        "scene: (relief_mapping: (least_elevation_degrees: 20)), hemisphere: (rings: 3, azimuths: 4)",
        "scene: (relief_mapping: (search: maximum_mip)), hemisphere: (rings: 2, azimuths: 3, size: (7, 5), encoding: f16)",
        "scene: (relief_mapping: (search: relaxed_cone_steps)), hemisphere: (rings: 1, azimuths: 1, mode: nearest)",
        "scene: (relief_mapping: (search: linear)), hemisphere: (rings: 1, azimuths: 2)",
    ]
    .into_iter()
    .enumerate()
    {
        // Rows that are no multiples of what pictures are aligned to.
        let place = Place::with("r.ron", shape(29, 13, fields));
        let (plan, _) = agrees(&place, "r.ron");
        let grid = json!({
            "width": 29, "height": 13, "spacing_u": 1.0, "spacing_v": 1.0, "unit": "units", "edge": "wrap"
        });
        assert_eq!((&plan["schema"], &plan["grid"]), (&"barchan.plan/1".into(), &grid), "{index}");
    }
    let place = Place::with("r.ron", shape(29, 13, "hemisphere: (rings: 2, azimuths: 2)"));
    let (plan, bake) = agrees(&place, "r.ron --only height,hemisphere,maximum_mip");
    assert_eq!(decided(&plan, "bake").len(), 3);
    assert_eq!(bake["tables"][2]["mips"], 5);
}

#[test]
fn a_plan_of_a_bare_file_is_what_is_then_baked() {
    let place = Place::with("map.npy", npy(14, &noise(14, 11)));
    let (plan, _) = agrees(&place, "map.npy --directions 4");
    assert_eq!((&plan["source"], &plan["grid"]), (&"map.npy".into(), &Value::Null));
    assert_eq!(plan["unread"], json!(["map.npy"]));
    let tables = "--only height,hemisphere,cone_map,maximum_mip --rings 3 --azimuths 4";
    let (plan, _) = agrees(&place, &format!("map.npy {tables} --size 5,11 --encoding f32"));
    let baked = decided(&plan, "bake");
    assert_eq!(baked[1].1["raw_bytes"], json!(11 * (5 * 11 * 4_u32).next_multiple_of(256) + 5 * 11 * 4));
    assert_eq!((&baked[2].1["raw_bytes"], &baked[2].1["bytes_per_texel"]), (&Value::Null, &8.into()));
    place.write("torus.obj", Torus { around: 12, along: 8 }.obj());
    let (plan, _) = agrees(&place, "torus.obj --encoding f32");
    assert_eq!(plan["unread"], json!(["torus.obj"]));
    assert_eq!(decided(&plan, "bake")[0].1["format"], "float32x2");
    assert_eq!(decided(&plan, "no_input").len(), 12);
}

#[test]
fn a_plan_reads_and_writes_nothing_and_says_what_it_leaves_open() {
    let place = Place::with("map.npy", "no height map, which nobody looks at");
    place.write(
        "r.ron",
        "(source: HeightMap(path: \"map.npy\"), horizon: (directions: 16), scene: (curvature: (0.0, 0.02), relief_mapping: (search: cone_steps)))",
    );
    let words = place.ok("plan r.ron");
    for line in [
        "planned        7 tables to bake; 5 left out, 1 without input\n",
        "source         map.npy\n",
        "checked        all that can be checked without map.npy\n",
        "\nheight            baked     R16_SFLOAT                                             2 B a texel   the surface itself\n",
        "\nhorizon           baked     R8_UNORM × 16 directions                               16 B a texel  shadows\n",
        "\nswept_horizon     baked     R8_UNORM × as few points as keep 0.5° × 16 directions  needs a bake  ",
        "\nhemisphere        baked     R8_UNORM × 32 rings × 16 azimuths                      needs the map  ",
        "\nmaximum_mip       left out  R16_SFLOAT × levels down to one texel                  needs the map  ",
        "\ncurvature         no input  -                                                      -             there is no mesh\n",
    ] {
        let squeezed = |text: &str| text.split(' ').filter(|word| !word.is_empty()).collect::<Vec<_>>().join(" ");
        assert!(squeezed(&words).contains(&squeezed(line)), "{line}\n{words}");
    }
    assert_eq!(place.names(), ["map.npy", "r.ron"]);
}

#[test]
fn the_next_command_is_the_bake_of_the_same_words() {
    let place = Place::with("a plan.npy", npy(14, &noise(14, 11)));
    let words = place.run_words(&["plan", "a plan.npy", "--only", "height,cone_map", "--edge", "wrap"]).stdout;
    let line = words.lines().find(|line| line.starts_with("next ")).unwrap();
    assert!(line.ends_with(" bake 'a plan.npy' --only height,cone_map --edge wrap"), "{line}");
}

#[cfg(target_os = "linux")]
#[test]
fn a_name_that_is_no_text_is_planned_too() {
    let place = Place::with("map.npy", npy(14, &noise(14, 11)));
    let run =
        place.shell("name=$(printf '\\377.npy'); cp map.npy \"$name\"; \"$BARCHAN\" plan \"$name\" --only height");
    let failed = place.shell("\"$BARCHAN\" plan \"$(printf '\\376.npy')\"");
    assert_eq!((run.code, failed.code), (Some(0), Some(4)), "{}", run.stderr);
}

#[test]
fn every_sample_has_a_plan() {
    for recipe in files(&workspace("samples"), "ron") {
        let place = Place::new();
        let plan = place.json(&format!("plan {}", recipe.display()));
        assert_eq!(plan["tables"].as_array().unwrap().len(), 13);
        assert!(!decided(&plan, "bake").is_empty(), "{}", recipe.display());
        assert_eq!(fs::read_dir(place.path("")).unwrap().count(), 0);
    }
}
