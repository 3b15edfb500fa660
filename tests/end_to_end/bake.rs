//! What a bake writes and says.

use crate::support::{Place, noise, npy, parse_json};

const RIPPLES: &str = "(
    source: Shape(shape: Ripples(amplitude: 2.0, waves_u: 3, waves_v: 1), width: 40, height: 24),
    spacing: (0.5, 0.25), unit: metre, edge: wrap, horizon: (directions: 8, radius: 6.0),
)";

/// [`RIPPLES`] with more fields.
fn ripples_with(fields: &str) -> String {
    RIPPLES.replace("\n)", &format!("\n{fields})"))
}

#[test]
fn the_same_bytes_for_any_number_of_threads_and_any_run() {
    let place = Place::with("recipe.ron", RIPPLES);
    // Every table there is.
    let all = "--only height,horizon,distance,swept_horizon,swept_distance,sky_visibility,bent_normal,aperture_cone,\
               hemisphere,cone_map,relaxed_cone_map,maximum_mip";
    let few = "hemisphere: (rings: 4, azimuths: 5, size: (11, 24)),";
    place.write("all.ron", ripples_with(&format!("scene: (curvature: (-0.1, 0.1)), {few}")));
    for jobs in ["1", "2"] {
        place.ok(&format!("bake all.ron {all} -j {jobs} -o all{jobs}.barchan"));
    }
    assert!(place.read("all1.barchan") == place.read("all2.barchan"));
    for (name, jobs) in [("a", "1"), ("b", "2"), ("c", "3"), ("d", "0"), ("e", "1")] {
        place.ok(&format!("bake recipe.ron -j {jobs} -o {name}.barchan"));
    }
    let first = place.read("a.barchan");
    for name in ["b", "c", "d", "e"] {
        assert!(place.read(&format!("{name}.barchan")) == first, "{name} differs from a");
    }
}

#[test]
fn packing_changes_the_bytes_and_not_the_identity() {
    let place = Place::with("raw.ron", RIPPLES);
    place.write("zstd.ron", ripples_with("compression: zstd,"));
    let (raw, zstd) = (place.json("bake raw.ron"), place.json("bake zstd.ron"));
    assert!(zstd["file_bytes"].as_u64() < raw["file_bytes"].as_u64());
    let (raw, zstd) = (place.json("inspect raw.barchan"), place.json("inspect zstd.barchan"));
    assert_eq!(raw["identity"], zstd["identity"]);
    assert!(place.ok("compare raw.barchan zstd.barchan").ends_with("the same at tolerance 0\n"));
    assert_eq!(place.json("validate zstd.barchan")["findings"], serde_json::json!([]));
}

#[test]
fn the_output_is_named_after_the_input_and_lies_in_the_current_folder() {
    let place = Place::new();
    std::fs::create_dir(place.path("maps")).unwrap();
    place.write("maps/hill.ron", RIPPLES);
    assert!(place.ok("bake maps/hill.ron").starts_with("baked          hill.barchan, "));
    assert_eq!(place.names(), ["hill.barchan", "maps"]);
}

#[test]
fn a_scene_leaves_out_what_it_does_not_need_and_says_why() {
    let place = Place::with("recipe.ron", ripples_with("scene: (),"));
    let words = place.ok("bake recipe.ron");
    let reason = "the scene has no curved surfaces and no soft shadows";
    assert!(words.contains(&format!("left out       distance, saving 7.5 KiB: {reason}\n")), "{words}");
    // Neighbours that one reason leaves out are on one line.
    let sky = "left out       sky_visibility and bent_normal, saving 2.8 KiB: the scene has no ambient light\n";
    assert!(words.contains(sky), "{words}");
    let report = place.json("bake recipe.ron");
    assert_eq!(report["left_out"][0]["table"], "distance");
    assert_eq!(report["left_out"][0]["bytes_saved"], 40 * 24 * 8);
    assert_eq!(report["left_out"].as_array().unwrap().len(), 10);
    assert_eq!(
        place.fails(2, "dump recipe.barchan distance --format text"),
        "recipe.barchan: there is no distance table; the file has height and horizon"
    );
}

#[test]
fn a_scene_that_needs_the_distance_gets_it() {
    for (scene, reason) in [
        ("scene: (soft_shadows: true),", "sizes penumbrae"),
        ("scene: (curved_surfaces: true),", "corrects the horizon on curved surfaces"),
        ("", "no recipe says that the scene does without it"),
    ] {
        let place = Place::with("recipe.ron", ripples_with(scene));
        let report = place.json("bake recipe.ron");
        assert!(report["left_out"].as_array().unwrap().iter().all(|left| left["table"] != "distance"));
        assert_eq!(
            (&report["tables"][2]["table"], &report["tables"][2]["reason"]),
            (&"distance".into(), &reason.into())
        );
    }
}

#[test]
fn only_overrides_the_scene() {
    let place = Place::with("recipe.ron", ripples_with("scene: (),"));
    let report = place.json("bake recipe.ron --only height,distance");
    let names = |list: &str| -> Vec<_> {
        report[list].as_array().unwrap().iter().map(|entry| entry["table"].as_str().unwrap().to_owned()).collect()
    };
    let left_out = [
        "horizon",
        "swept_horizon",
        "swept_distance",
        "sky_visibility",
        "bent_normal",
        "aperture_cone",
        "hemisphere",
        "cone_map",
        "relaxed_cone_map",
        "maximum_mip",
    ];
    assert_eq!(names("tables"), ["height", "distance"]);
    assert_eq!(names("left_out"), left_out);
    assert_eq!(report["left_out"][0]["reason"], "not named by --only");
    assert_eq!(place.json("validate recipe.barchan")["findings"], serde_json::json!([]));
}

#[test]
fn a_height_table_alone_needs_no_horizon() {
    let place = Place::with("recipe.ron", RIPPLES);
    let report = place.json("bake recipe.ron --only height");
    assert_eq!((&report["horizon"], &report["mtexel_directions_per_second"]), (&().into(), &().into()));
    // With one table, dump need not be told which.
    assert!(place.ok("dump recipe.barchan").starts_with("# height in m, 40 × 24\n"));
}

#[test]
fn the_report_tells_the_time_of_each_stage_and_the_speed() {
    let place = Place::with("recipe.ron", RIPPLES);
    let report = place.json("bake recipe.ron -j 2");
    let stages = report["stages"].as_array().unwrap();
    let names: Vec<_> = stages.iter().map(|stage| stage["stage"].as_str().unwrap()).collect();
    assert_eq!(names, ["source", "encode", "write", "bounds", "horizon", "sky", "measure", "checksum", "save"]);
    let seconds: f64 = stages.iter().map(|stage| stage["seconds"].as_f64().unwrap()).sum();
    assert!(seconds <= report["total_seconds"].as_f64().unwrap());
    let speed = report["mtexel_directions_per_second"].as_f64().unwrap();
    let horizon = stages[4]["seconds"].as_f64().unwrap();
    assert!((speed * horizon - 40.0 * 24.0 * 8.0 / 1e6).abs() < 1e-9);
    assert_eq!(report["threads"], 2);
}

#[test]
fn every_report_is_json_with_a_versioned_schema() {
    let place = Place::with("r.ron", RIPPLES);
    for (words, schema) in [
        ("bake r.ron", "barchan.bake/2"),
        ("inspect r.barchan", "barchan.inspect/1"),
        ("dump r.barchan height --format npy -o r.npy", "barchan.dump/1"),
        ("validate r.barchan", "barchan.validate/1"),
        ("compare r.barchan r.barchan", "barchan.compare/1"),
        ("render r.barchan -o r.png", "barchan.render/1"),
        ("render r.barchan --eye-elevation 30 --size 32 -o r.png", "barchan.render_relief/1"),
    ] {
        assert_eq!(place.json(words)["schema"], schema);
    }
    let run = place.run("--json inspect missing.barchan");
    let error = parse_json(&run.stdout);
    assert_eq!((&error["schema"], &error["exit_code"]), (&"barchan.error/1".into(), &4.into()));
    assert_eq!(error["error"].as_str(), Some(run.message().as_str()));
}

#[test]
fn progress_goes_to_stderr_and_results_to_stdout() {
    let place = Place::with("recipe.ron", RIPPLES);
    let plain = place.run("bake recipe.ron --progress plain");
    assert!(plain.stdout.starts_with("baked "));
    let steps: Vec<_> = plain.stderr.lines().collect();
    assert_eq!(steps[..3], ["source 0/1", "source 1/1", "horizon 0/8"]);
    assert!(steps.contains(&"horizon 8/8"), "{steps:?}");

    let json = place.run("--json bake recipe.ron --progress json");
    assert_eq!(parse_json(&json.stdout)["schema"], "barchan.bake/2");
    let lines: Vec<_> = json.stderr.lines().map(parse_json).collect();
    assert!(lines.iter().all(|line| line["schema"] == "barchan.progress/1"));
    assert!(lines.iter().any(|line| line["stage"] == "checksum" && line["done"] == 1 && line["total"] == 1));

    // Neither asked for nor a terminal: nothing.
    assert_eq!(place.run("bake recipe.ron --progress none").stderr, "");
    assert_eq!(place.run("bake recipe.ron").stderr, "");
}

#[test]
fn provenance_names_no_path_host_or_time() {
    let place = Place::with("secret-name.ron", RIPPLES);
    place.ok("bake secret-name.ron -o a.barchan");
    std::fs::create_dir(place.path("elsewhere")).unwrap();
    place.write("elsewhere/other.ron", RIPPLES);
    place.ok("bake elsewhere/other.ron -o b.barchan");
    assert!(place.read("a.barchan") == place.read("b.barchan"));
    let provenance = &place.json("inspect a.barchan")["provenance"];
    let keys = |value: &serde_json::Value| value.as_object().unwrap().keys().cloned().collect::<Vec<_>>();
    assert_eq!(keys(provenance), ["encodings", "generator", "horizon", "input", "recipe", "schema", "sky", "swept"]);
    assert_eq!(provenance["input"]["shape"]["shape"]["Ripples"]["amplitude"], 2.0);
    let text = provenance.to_string();
    for word in ["secret", "recipe.ron", "/", "\\"] {
        let found = text.replace("barchan.provenance/1", "").contains(word);
        assert!(!found, "{word} in {text}");
    }
}

#[test]
fn the_commands_a_bake_proposes_run() {
    for only in ["", "--only horizon"] {
        let place = Place::with("recipe.ron", RIPPLES);
        let words = place.ok(&format!("bake recipe.ron -o it.barchan {only}"));
        let (_, next) = words.split_once("next ").unwrap();
        let commands: Vec<_> = next.lines().map(str::trim).collect();
        assert_eq!(commands.len(), if only.is_empty() { 2 } else { 1 });
        for command in commands {
            let run = place.shell(command);
            assert_eq!(run.code, Some(0), "{command}\n{}", run.stderr);
        }
    }
}

#[test]
fn the_commands_a_bake_proposes_survive_a_shell() {
    let place = Place::with("r.ron", RIPPLES);
    let run = place.run_words(&["bake", "r.ron", "-o", "it's a file.barchan"]);
    for command in run.stdout.split_once("next ").unwrap().1.lines() {
        let run = place.shell(command);
        assert_eq!(run.code, Some(0), "{command}\n{}", run.stderr);
    }
    assert!(place.names().contains(&"it's a file.lit.png".to_owned()));
}

#[test]
fn a_method_and_an_arc_are_flags_and_stand_in_the_file() {
    let place = Place::with("map.npy", npy(24, &noise(24, 20)));
    for method in ["sweep", "accurate", "exact"] {
        place.ok(&format!("bake map.npy --method {method} --arc -90,90 --directions 5"));
        let inspected = place.json("inspect map.barchan");
        let horizon = &inspected["provenance"]["horizon"];
        assert_eq!((&horizon["method"], &horizon["arc"]), (&method.into(), &serde_json::json!([-90.0, 90.0])));
        let words = place.ok("inspect map.barchan");
        let said = format!(" {method}, 5 directions from -90° to 90°, radius ");
        assert!(words.contains(&said), "{words}");
        assert!(words.contains("× 5 directions from -90° to 90°, R8_UNORM of the sine, clamp / clamp"), "{words}");
    }
    let section = &place.json("inspect map.barchan")["sections"][1]["table"];
    assert_eq!((&section["arc_degrees"], &section["transfer"]), (&serde_json::json!([-90.0, 90.0]), &"sine".into()));
}

#[test]
fn what_storing_costs_is_measured_and_said() {
    let place = Place::with("map.npy", npy(24, &noise(24, 20)));
    let mut worst = Vec::new();
    for encoding in ["f32", "f16", "u8", "compact"] {
        let report = place.json(&format!("bake map.npy --encoding {encoding}"));
        let stored = &place.json("inspect map.barchan")["provenance"]["encodings"];
        for (table, stored) in report["tables"].as_array().unwrap().iter().zip(stored.as_array().unwrap()) {
            assert_eq!((&table["encoding_rms"], &table["encoding_max"]), (&stored["rms"], &stored["max"]));
            let [max, bound] = ["encoding_max", "worst_case_error"].map(|key| table[key].as_f64().unwrap());
            assert!(max <= bound, "{table}");
        }
        worst.push(report["tables"][1]["encoding_max"].as_f64().unwrap());
    }
    assert_eq!(worst[0], 0.0);
    assert!(worst[0] < worst[1] && worst[1] < worst[2] && worst[1] < worst[3], "{worst:?}");
    let words = place.ok("inspect map.barchan");
    assert!(words.contains("provenance     horizon stored as R8_UNORM: measured "), "{words}");
}

#[test]
fn a_range_of_curvatures_is_kept_by_as_few_points_as_the_error_asks_for() {
    let fields = |curved: &str| ripples_with(&format!("scene: (curvature: (0.0, 0.1)), curved: ({curved}),"));
    let place = Place::with("recipe.ron", fields("points: 3"));
    let report = place.json("bake recipe.ron");
    assert_eq!(report["swept"]["points"], 3);
    assert_eq!((&report["tables"][3]["table"], &report["tables"][3]["layers"]), (&"swept_horizon".into(), &16.into()));
    assert_eq!(place.json("validate recipe.barchan")["findings"], serde_json::json!([]));
    let words = place.ok("inspect recipe.barchan");
    assert!(words.contains("× 2 further points × 8 directions, R8_UNORM of the sine, "), "{words}");
    assert!(words.contains(", search radius 6 m, curvature 0 to 0.1 per m\n"), "{words}");
    assert!(words.contains("provenance     horizon-swept-1, 3 points\n"), "{words}");

    place.write("recipe.ron", fields("max_error_degrees: 89.0"));
    let words = place.ok("bake recipe.ron");
    let reason = "the flat horizon alone keeps the error asked for";
    assert!(
        words.contains(&format!("left out       swept_horizon and swept_distance, saving 15.0 KiB: {reason}\n")),
        "{words}"
    );
    assert_eq!(place.json("bake recipe.ron")["swept"]["points"], 1);
}

/// A plane that rises along u sees the same sky everywhere: half the sky that its slope leaves.
#[test]
fn the_sky_over_an_open_slope_is_that_of_the_closed_form() {
    let place = Place::new();
    place.bake(
        "(source: Shape(shape: Plane(slope_u: 0.75, slope_v: 0.0), width: 9, height: 9),
        scene: (ambient_light: true, area_lights: true), horizon: (directions: 64, radius: 3.0), sky: (encoding: f16))",
    );
    // Away from the edge, where the plane is cut to a terrace.
    let middle = |array: crate::support::Array, numbers: usize| array.values[40 * numbers..][..numbers].to_vec();
    let slope = 0.75_f32.atan();
    let near = |found: f32, expected: f32| assert!((found - expected).abs() < 0.01, "{found} {expected}");
    near(middle(place.array("out.barchan", "sky_visibility"), 1)[0], (1.0 + slope.cos()) / 2.0);
    let bent = place.array("out.barchan", "bent_normal");
    assert_eq!(bent.shape, [9, 9, 3]);
    let bent = middle(bent, 3);
    near(bent.iter().map(|component| component * component).sum(), 1.0);
    near(bent[1], 0.0);
    assert!(bent[0] < -0.3 && bent[2] > 0.7, "away from the slope and upwards: {bent:?}");
    let cone = place.array("out.barchan", "aperture_cone");
    assert_eq!(cone.shape, [9, 9, 4]);
    // The sky is a lune: a hemisphere but for the wedge that the slope hides.
    near(middle(cone, 4)[3], slope / std::f32::consts::PI);
}

/// All directions together are 128 MiB; the program gets 96, for everything.
#[cfg(target_os = "linux")]
#[test]
fn a_bake_holds_one_direction_in_memory_and_not_all() {
    let place = Place::new();
    place.write(
        "large.ron",
        "(
            source: Shape(shape: Ripples(amplitude: 2.0, waves_u: 3, waves_v: 1), width: 512, height: 512),
            edge: wrap, scene: (), horizon: (directions: 128, radius: 8.0, method: sweep, encoding: f32),
        )",
    );
    let run = place.shell("ulimit -v 98304; exec \"$BARCHAN\" bake large.ron -j 1");
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), ""));
    assert!(run.stdout.contains("R32_SFLOAT × 128 directions, 128.0 MiB, exact"), "{}", run.stdout);
    // Packing needs all of a table at once, and says so where there is no room.
    let recipe = place.text("large.ron").replace("scene: (),", "scene: (), compression: zstd,");
    place.write("packed.ron", recipe);
    let run = place.shell("ulimit -v 98304; exec \"$BARCHAN\" bake packed.ron -j 1");
    let message = "packed.ron: table HORZ: no memory for 134217728 bytes to compress; a raw table needs none";
    assert_eq!((run.code, run.message().as_str()), (Some(4), message));
    assert_eq!(place.names(), ["large.barchan", "large.ron", "packed.ron"]);
}
