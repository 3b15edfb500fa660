//! A mesh in, its curvature out.

use serde_json::{Value, json};

use crate::support::{Array, Place, Torus, noise, npy};

/// A place with a torus, and no texture coordinates, as `torus.obj`.
fn place() -> Place {
    Place::with("torus.obj", Torus::USUAL.obj())
}

/// RMS of what is found minus what is true over RMS of the largest true curvature.
fn relative_error(found: &Array, truth: &[[f64; 2]]) -> f64 {
    assert_eq!(found.shape, [truth.len() as u64, 2]);
    let errors =
        found.values.iter().zip(truth.as_flattened()).map(|(&found, truth)| (f64::from(found) - truth).powi(2));
    let largest = truth.iter().map(|[k1, k2]| k1.abs().max(k2.abs()).powi(2));
    (0.5 * errors.sum::<f64>() / largest.sum::<f64>()).sqrt()
}

fn names(list: &Value, key: &str) -> Vec<String> {
    list.as_array().unwrap().iter().map(|entry| entry[key].as_str().unwrap().to_owned()).collect()
}

#[test]
fn a_mesh_alone_is_baked_whatever_its_name_is() {
    let torus = Torus::USUAL;
    for (bytes, format, unit) in
        [(torus.obj().into_bytes(), "OBJ", "units"), (torus.ply(), "PLY", "units"), (torus.glb(), "glTF", "m")]
    {
        let place = Place::with("file", bytes);
        let report = place.json("bake file");
        assert_eq!(report["mesh"]["source"], format!("file ({format})"));
        assert_eq!(report["mesh"]["unit"], unit);
        assert_eq!((&report["mesh"]["vertices"], &report["mesh"]["triangles"]), (&json!(1152), &json!(2304)));
        assert_eq!(
            (&report["source"], &report["grid"], &report["horizon"]),
            (&Value::Null, &Value::Null, &Value::Null)
        );
        assert_eq!(names(&report["tables"], "table"), ["curvature"]);
        assert_eq!(place.json("validate file.barchan")["findings"], json!([]));
    }
}

#[test]
fn the_curvature_of_a_torus_is_that_of_the_closed_form() {
    let torus = Torus { around: 96, along: 48 };
    let place = Place::with("torus.obj", torus.obj());
    for (flags, bound) in [("--encoding f32", 1e-3), ("", 1e-3), ("--method fast --encoding f32", 1e-2)] {
        place.ok(&format!("bake torus.obj {flags}"));
        let found = place.array("torus.barchan", "curvature");
        let error = relative_error(&found, &torus.curvature());
        assert!(error < bound, "{flags}: {error}");
    }
}

#[test]
fn every_format_gives_the_same_curvature() {
    let torus = Torus::USUAL;
    let place = place();
    place.write("torus.ply", torus.ply());
    place.write("torus.glb", torus.glb());
    for name in ["obj", "ply", "glb"] {
        place.ok(&format!("bake torus.{name} --unit metre -o {name}.barchan"));
    }
    for name in ["ply", "glb"] {
        assert!(place.ok(&format!("compare obj.barchan {name}.barchan")).ends_with("the same at tolerance 0\n"));
    }
}

#[test]
fn the_same_bytes_for_any_number_of_threads() {
    let place = Place::with("torus.obj", Torus::USUAL.obj_with_uvs());
    for jobs in ["1", "2", "3"] {
        place.ok(&format!("bake torus.obj -j {jobs} -o {jobs}.barchan"));
    }
    let first = place.read("1.barchan");
    assert!(place.read("2.barchan") == first && place.read("3.barchan") == first);
}

#[test]
fn columns_that_nobody_needs_are_left_out_and_said() {
    let left_out = |report: &Value| {
        let left = report["left_out"].as_array().unwrap().iter();
        left.map(|left| (left["table"].as_str().unwrap().to_owned(), left["reason"].as_str().unwrap().to_owned()))
            .collect::<Vec<_>>()
    };
    let pair = |table: &str, reason: &str| (format!("curvature.{table}"), reason.to_owned());
    let (no_uvs, plain) = ("the mesh has no texture coordinates", "there is nothing to remark on any vertex");

    let place = place();
    let report = place.json("bake torus.obj");
    assert_eq!(left_out(&report), [pair("forms", no_uvs), pair("uv_directions", no_uvs), pair("flags", plain)]);
    assert_eq!(names(&report["tables"][0]["columns"], "column"), ["principal", "direction_1", "direction_2"]);
    assert_eq!(report["left_out"][0]["bytes_saved"], 1152 * 16);

    place.write("torus.obj", Torus::USUAL.obj_with_uvs());
    let report = place.json("bake torus.obj");
    let expected = [
        pair("directions", "the forms hold them, in texture coordinates"),
        pair("uv_directions", "the recipe does not ask for them: the forms are what to interpolate"),
        pair("flags", plain),
    ];
    assert_eq!(left_out(&report), expected);
    assert_eq!(names(&report["tables"][0]["columns"], "column"), ["principal", "first_form", "second_form"]);
    assert_eq!(report["mesh"]["seam_vertices"], 48 + 24 + 1);

    place.write("all.ron", "(mesh: (path: \"torus.obj\"), curvature: (directions: true, uv_directions: true))");
    let report = place.json("bake all.ron");
    assert_eq!(left_out(&report), [pair("flags", plain)]);
    assert_eq!(report["tables"][0]["columns"].as_array().unwrap().len(), 6);
}

#[test]
fn vertices_are_flagged_by_cause_and_counted() {
    let torus = Torus::USUAL.obj();
    // A vertex that nothing uses, and a triangle by itself, with a border all round.
    let place = Place::with("a.obj", format!("{torus}v 9 9 9\nv 20 0 0\nv 21 0 0\nv 20 1 0\nf -3 -2 -1\n"));
    let words = place.ok("bake a.obj");
    assert!(words.contains("\nflagged        of 1156 vertices, unknown and stored as 0: 1 isolated"), "{words}");
    let inspected = place.json("inspect a.barchan");
    let flagged = &inspected["sections"][0]["curvature"]["flagged"];
    assert_eq!(flagged, &inspected["provenance"]["curvature"]["flagged"]);
    assert_eq!(flagged[0], json!({ "flag": "isolated", "vertices": 1 }));
    let flags = place.ok("dump a.barchan --column flags");
    let lines: Vec<_> = flags.lines().collect();
    assert_eq!((lines[0], lines[1], lines[1153]), ("# curvature, flags, 1156 vertices", "", "isolated"));
    let array = place.array("a.barchan", "curvature --column principal");
    assert_eq!(array.values[2 * 1152..][..2], [0.0, 0.0]);
}

#[test]
fn the_report_says_what_was_read_found_and_how_fast() {
    let place = Place::with("torus.obj", Torus::USUAL.obj_with_uvs());
    let words = place.ok("bake torus.obj -j 1");
    let (seams, quads) = ("73 of the vertices behind the last `v`, for seams", "1152 polygons cut into triangles");
    let mesh = format!("mesh           torus.obj (OBJ), 1225 vertices, 2304 triangles, {seams}, {quads}\n");
    assert!(words.contains(&mesh), "{words}");
    assert!(words.contains("\nwelded         1225 vertices to 1152 points of smooth sheets, mean edge 0."), "{words}");
    assert!(words.contains("\nfound          κ from -0.") && words.contains(" per unit, no noise that can"), "{words}");
    assert!(words.contains("\ntime           mesh ") && words.contains(" Mvertex/s on 1 thread), "), "{words}");

    let report = place.json("bake torus.obj -j 1");
    let names = names(&report["stages"], "stage");
    assert_eq!(names, ["mesh", "curvature", "forms", "encode", "write", "checksum", "save"]);
    let (speed, seconds) = (&report["mvertices_per_second"], &report["stages"][1]["seconds"]);
    assert!((speed.as_f64().unwrap() * seconds.as_f64().unwrap() - 1225e-6).abs() < 1e-9);
}

#[test]
fn inspect_shows_columns_ranges_and_provenance() {
    let place = Place::with("torus.obj", Torus::USUAL.obj_with_uvs());
    place.ok("bake torus.obj --unit millimetre --hard-edge 45 --method fast");
    let words = place.ok("inspect torus.barchan");
    for expected in [
        "curvature      CURV at 4096, raw ",
        "               1225 vertices, κ from -0.",
        "               of 1225 vertices, unknown and stored as 0: none; remarks: none\n",
        "               principal float16x2, 4.8 KiB, -0.",
        "               second_form float16x4, 9.6 KiB, ",
        "provenance     curvature-jets-1 fast, hard edges beyond 45°\n",
        "provenance     1225 vertices to 1152 points of smooth sheets, mean edge 0.",
    ] {
        assert!(words.contains(expected), "{expected}\n{words}");
    }
    let inspected = place.json("inspect torus.barchan");
    let curvature = &inspected["sections"][0]["curvature"];
    assert_eq!((&curvature["vertices"], &curvature["length_unit"]), (&json!(1225), &json!("millimetre")));
    assert_eq!(names(&curvature["columns"], "column"), ["principal", "first_form", "second_form"]);
    let provenance = &inspected["provenance"];
    assert_eq!(provenance["mesh"]["source"]["file"]["format"], "OBJ");
    let recipe = &provenance["recipe"]["curvature"];
    assert_eq!((&recipe["method"], &recipe["hard_edge_degrees"]), (&json!("fast"), &json!(45.0)));
}

#[test]
fn provenance_names_no_path() {
    let place = place();
    place.ok("bake torus.obj -o a.barchan");
    std::fs::create_dir(place.path("secret")).unwrap();
    place.write("secret/other.obj", Torus::USUAL.obj());
    place.ok("bake secret/other.obj -o b.barchan");
    assert!(place.read("a.barchan") == place.read("b.barchan"));
}

#[test]
fn packing_changes_the_bytes_and_not_the_identity() {
    let place = place();
    let raw = place.json("bake torus.obj -o raw.barchan");
    let zstd = place.json("bake torus.obj --compression zstd -o zstd.barchan");
    assert!(zstd["file_bytes"].as_u64() < raw["file_bytes"].as_u64());
    assert_eq!(raw["identity"], zstd["identity"]);
    assert!(place.ok("compare raw.barchan zstd.barchan").ends_with("the same at tolerance 0\n"));
    assert_eq!(place.json("validate zstd.barchan")["findings"], json!([]));
}

#[test]
fn compare_finds_where_curvatures_differ() {
    let place = Place::with("torus.obj", Torus::USUAL.obj_with_uvs());
    place.ok("bake torus.obj --encoding f32 -o exact.barchan");
    place.ok("bake torus.obj --encoding f16 -o small.barchan");
    let run = place.run("--json compare exact.barchan small.barchan");
    assert_eq!(run.code, Some(3));
    let report = crate::support::parse_json(&run.stdout);
    assert_eq!(names(&report["tables"], "table"), ["curvature.principal", "curvature.forms"]);
    let values = &report["tables"][0]["values"];
    assert_eq!(values["unit"], "per unit");
    assert!(values["worst"]["vertex"].is_u64() && ["k1", "k2"].contains(&values["worst"]["number"].as_str().unwrap()));
    // A curvature of at most 2 has 11 bits.
    assert!(values["max"].as_f64().unwrap() <= 2.0 / 2048.0);
    place.ok("compare exact.barchan small.barchan --tolerance 0.1");
    assert_eq!(place.run("compare exact.barchan small.barchan").code, Some(3));

    place.write("b.obj", Torus::USUAL.obj());
    place.ok("bake b.obj -o b.barchan");
    let words = place.run("compare exact.barchan b.barchan").stdout;
    assert!(words.contains("curvature      vertex count is 1225 in one and 1152 in the other\n"), "{words}");
}

#[test]
fn the_commands_a_bake_proposes_run() {
    let place = Place::with("it's.obj", Torus::USUAL.obj());
    place.write("sphere.ron", "(mesh: (surface: Sphere(radius: 2.0), vertices: 200))");
    for input in ["it's.obj", "sphere.ron"] {
        let words = place.run_words(&["bake", input]).stdout;
        let (_, next) = words.split_once("next ").unwrap();
        assert_eq!(next.lines().count(), 2);
        for command in next.lines() {
            let run = place.shell(command);
            assert_eq!(run.code, Some(0), "{command}\n{}", run.stderr);
        }
    }
    assert!(place.names().contains(&"it's.curvature.ply".to_owned()));
}

#[test]
fn progress_tells_how_far_the_curvature_is() {
    let place = place();
    let run = place.run("bake torus.obj --progress plain");
    let steps: Vec<_> = run.stderr.lines().collect();
    assert_eq!(steps[..2], ["mesh 0/1", "mesh 1/1"]);
    assert!(steps.iter().any(|step| step.starts_with("curvature ")), "{steps:?}");
}

#[test]
fn heights_and_a_mesh_go_into_one_file() {
    let place = place();
    place.write("map.npy", npy(16, &noise(16, 16)));
    let recipe = |scene: &str| {
        let map = "source: HeightMap(path: \"map.npy\", height_scale: 0.1), mesh: (path: \"torus.obj\")";
        format!(
            "({map}, spacing: 0.05, unit: metre, horizon: (directions: 4, radius: 0.4), curved: (points: 2){scene})"
        )
    };
    place.write("both.ron", recipe(""));
    let report = place.json("bake both.ron");
    let tables = names(&report["tables"], "table");
    let swept = ["height", "horizon", "distance", "swept_horizon", "swept_distance"];
    assert_eq!((&tables[..5], tables.last().unwrap().as_str()), (&swept.map(str::to_owned)[..], "curvature"));
    assert_eq!((&report["mesh"]["unit"], &report["grid"]["unit"]), (&json!("m"), &json!("m")));
    assert_eq!(place.json("validate both.barchan")["findings"], json!([]));

    // Nobody names a range, so the horizons are right on the mesh: from the inner equator to the tube.
    let range = &report["swept"]["on_mesh"]["swept"];
    let [least, greatest] = [0, 1].map(|end| range[end].as_f64().unwrap());
    assert!((least + 2.0 / 3.0).abs() < 0.05 && (greatest - 2.0).abs() < 0.1, "{range}");
    let stored = &place.json("inspect both.barchan")["sections"][3]["table"]["curvature"];
    assert_eq!(stored, range);
    let words = place.ok("bake both.ron");
    assert!(words.contains("\nswept          over the curvatures of the mesh, -0."), "{words}");

    place.write("named.ron", recipe(", scene: (curvature: (0.0, 0.5))"));
    let report = place.json("bake named.ron");
    assert_eq!(report["swept"].get("on_mesh"), None);
    assert_eq!(place.json("inspect named.barchan")["sections"][3]["table"]["curvature"], json!([0.0, 0.5]));
}

#[test]
fn a_range_that_texels_cannot_follow_is_cut_and_said() {
    let place = place();
    place.write("map.npy", npy(16, &noise(16, 16)));
    let map = "source: HeightMap(path: \"map.npy\"), mesh: (path: \"torus.obj\")";
    place.write("wide.ron", format!("({map}, horizon: (directions: 4, radius: 8), curved: (points: 2))"));
    let words = place.ok("bake wide.ron");
    let said = "\nswept          over -0.3927 to 1 per unit, as much of the mesh's -0.";
    assert!(words.contains(said), "{words}");
}

#[test]
fn only_chooses_between_heights_and_mesh() {
    let place = place();
    place.write("map.npy", npy(8, &noise(8, 8)));
    place.write("both.ron", "(source: HeightMap(path: \"map.npy\"), mesh: (path: \"torus.obj\"))");
    let report = place.json("bake both.ron --only height");
    assert_eq!(names(&report["tables"], "table"), ["height"]);
    assert_eq!(report["left_out"].as_array().unwrap().last().unwrap()["table"], "curvature");
    let report = place.json("bake both.ron --only curvature");
    assert_eq!(names(&report["tables"], "table"), ["curvature"]);
    assert_eq!(place.json("bake torus.obj --only curvature")["left_out"].as_array().unwrap().len(), 3);
}
