//! Every sample, as it is.

use crate::support::{Array, Place, files, rgb, workspace};

/// Bakes a sample and does with it what a person would do next.
fn follow(sample: &str) {
    let place = Place::new();
    let recipe = workspace("samples").join(sample).with_extension("ron");
    let report = place.json(&format!("bake {} -o baked.barchan", recipe.display()));
    let accuracy = &report["horizon"]["accuracy"];
    // Less than half of what the sun measures across.
    assert!(accuracy["stored_rms_degrees"].as_f64().unwrap() < 0.2, "{accuracy}");
    assert!(report["mtexel_directions_per_second"].as_f64().unwrap() > 0.0);

    let findings = place.json("validate baked.barchan");
    assert_eq!((&findings["valid"], findings["findings"].as_array().unwrap().len()), (&true.into(), 0), "{findings}");

    let inspected = place.json("inspect baked.barchan");
    assert_eq!(inspected["identity"], report["identity"]);
    assert_eq!(inspected["file_bytes"], report["file_bytes"]);

    place.ok("dump baked.barchan horizon --layer 1 --format npy -o east.npy");
    let (width, height) = (report["grid"]["width"].as_u64().unwrap(), report["grid"]["height"].as_u64().unwrap());
    let east = Array::read(&place.read("east.npy"));
    assert_eq!(east.shape, [height, width]);
    assert!(east.values.iter().all(|slope| slope.is_finite()));

    // An azimuth of the bake, along which pixels are texels even where texels are not square: what is left is the error
    // of the sweep and of the encoding.
    let drawn = place.json("render baked.barchan --azimuth 0 --elevation 10 --compare -o lit.png");
    let wrong = drawn["comparison"]["wrong_share"].as_f64().unwrap();
    assert!(wrong < 0.01, "{wrong} of the pixels are wrong");
    assert_eq!(u64::from(rgb(&place.read("lit.png")).width()), drawn["width"].as_u64().unwrap());
}

/// Bakes a sample of a mesh and does with its curvature what a person would do next.
fn follow_mesh(sample: &str) {
    let place = Place::new();
    let recipe = workspace("samples").join(sample).with_extension("ron");
    let report = place.json(&format!("bake {} -o baked.barchan", recipe.display()));
    let findings = place.json("validate baked.barchan");
    assert_eq!((&findings["valid"], findings["findings"].as_array().unwrap().len()), (&true.into(), 0), "{findings}");
    let curvature = place.array("baked.barchan", "curvature");
    assert_eq!(curvature.shape, [report["mesh"]["vertices"].as_u64().unwrap(), 2]);
    assert!(curvature.values.chunks_exact(2).all(|pair| pair[0] >= pair[1] && pair[1].is_finite()));
    assert!(curvature.values.iter().any(|&curvature| curvature != 0.0));
    let mesh = report["mesh"]["path"].as_str().map(|path| format!("--mesh {path}")).unwrap_or_default();
    place.ok(&format!("dump baked.barchan curvature --format ply {mesh} -o coloured.ply"));
    let drawn = place.json(&format!("dump baked.barchan curvature --format png {mesh} -o coloured.png"));
    let (width, height) = rgb(&place.read("coloured.png")).dimensions();
    assert_eq!((width.max(height), &drawn["pixels"]), (800, &serde_json::json!([width, height])));
}

#[test]
fn demosthenes_curvature() {
    follow_mesh("demosthenes");
}

#[test]
fn game_curvature() {
    follow_mesh("game");
}

#[test]
fn rippled_torus_curvature() {
    follow_mesh("rippled_torus");
}

/// One test per sample of relief, and a list to hold against the folder.
macro_rules! samples {
    ($($name:ident),* $(,)?) => {
        $(#[test] fn $name() { follow(stringify!($name)); })*
        const SAMPLES: &[&str] = &[$(stringify!($name)),*];
    };
}

samples!(cylinder_bumps, dunes, fractal_terrain, game, jacksboro, relief, reptile_skin, rippled_torus, ripples);

/// Samples without relief.
const MESHES: &[&str] = &["demosthenes"];

#[test]
fn no_sample_is_forgotten() {
    let recipes = files(&workspace("samples"), "ron");
    let names: Vec<_> = recipes.iter().map(|path| path.file_stem().unwrap().to_str().unwrap()).collect();
    let mut known = [SAMPLES, MESHES].concat();
    known.sort_unstable();
    assert_eq!(names, known, "add the recipe to one of the lists above");
}
