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

/// One test per sample, and a list to hold against the folder.
macro_rules! samples {
    ($($name:ident),* $(,)?) => {
        $(#[test] fn $name() { follow(stringify!($name)); })*
        const SAMPLES: &[&str] = &[$(stringify!($name)),*];
    };
}

samples!(cylinder_bumps, dunes, fractal_terrain, jacksboro, reptile_skin, ripples);

#[test]
fn no_sample_is_forgotten() {
    let recipes = files(&workspace("samples"), "ron");
    let names: Vec<_> = recipes.iter().map(|path| path.file_stem().unwrap().to_str().unwrap()).collect();
    assert_eq!(names, SAMPLES, "add the recipe to the list above");
}
