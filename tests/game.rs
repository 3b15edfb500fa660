//! The game that `barchan-wgpu` has as an example, as it is, without its window.

use std::path::{Path, PathBuf};

use barchan_pipeline::{Plan, Recipe, Run, bake};
use image::RgbImage;

#[expect(dead_code, reason = "a test has a main of its own")]
#[path = "../crates/wgpu/examples/game.rs"]
mod game;

/// A folder of this test's own, empty.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("game").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// Bakes a recipe whose paths start at the samples.
fn baked(folder: &Path, recipe: &str) -> String {
    let samples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../samples");
    let path = folder.join("game.barchan");
    let out = std::fs::File::options().read(true).write(true).create_new(true).open(&path).unwrap();
    let run = Run { folder: &samples, threads: 0, progress: &|_, _, _| {} };
    bake(&Plan::new(Recipe::parse(recipe).unwrap(), None), &run, out).unwrap();
    path.to_str().unwrap().to_owned()
}

fn play(words: &[&str]) -> anyhow::Result<()> {
    game::run(words.iter().map(|word| (*word).to_owned()))
}

/// What the game says when it refuses.
fn refusal(words: &[&str]) -> String {
    format!("{:#}", play(words).unwrap_err())
}

fn drawn(asset: &str, folder: &Path, seconds: &str) -> RgbImage {
    let path = folder.join(format!("{seconds}.png"));
    play(&[asset, "-o", path.to_str().unwrap(), "-t", seconds]).unwrap();
    image::open(path).unwrap().into_rgb8()
}

/// The mean green of a part of the picture.
fn light(picture: &RgbImage, columns: std::ops::Range<u32>, rows: std::ops::Range<u32>) -> f64 {
    let pixels: Vec<_> = rows.flat_map(|y| columns.clone().map(move |x| picture.get_pixel(x, y).0[1])).collect();
    pixels.iter().map(|&green| f64::from(green)).sum::<f64>() / pixels.len() as f64
}

#[test]
fn its_sample_is_lit_from_where_the_sun_is() {
    let folder = folder("lit");
    let asset = baked(&folder, include_str!("../samples/game.ron"));
    // When the sun is straight on the right of the camera, and on its left.
    let [right, left] = ["0.75", "8.25"].map(|seconds| drawn(&asset, &folder, seconds));
    let background = right.get_pixel(0, 0).0;
    for picture in [&right, &left] {
        assert_eq!(picture.dimensions(), (960, 640));
        // Seen through the hole.
        assert_eq!(picture.get_pixel(480, 320).0, background);
        // Scales are lit on one side and dark on the other.
        let greens = || (200..760).map(|x| picture.get_pixel(x, 500).0[1]);
        let (darkest, brightest) = (greens().min().unwrap(), greens().max().unwrap());
        assert!(darkest < 60 && brightest > 120, "{darkest} to {brightest}");
    }
    // The outside of the torus is lit where it faces the sun.
    let outside = |picture| light(picture, 730..790, 280..380) - light(picture, 170..230, 280..380);
    assert!(outside(&right) > 10.0, "{}", outside(&right));
    assert!(outside(&left) < -10.0, "{}", outside(&left));
}

#[test]
fn what_is_missing_in_an_asset_is_said() {
    let relief =
        "source: Shape(shape: Ripples(amplitude: 1.0, waves_u: 2, waves_v: 0), width: 16, height: 16), edge: wrap";
    let [flat, other] = ["flat", "other"].map(folder);
    let flat = baked(&flat, &format!("({relief})"));
    assert_eq!(refusal(&[&flat, "-o", "never.png"]), "the asset has no curvature; bake it with its mesh");
    let torus =
        "mesh: (surface: Torus(major: 20.0, minor: 7.0), vertices: 100, pattern: Regular(aspect: 1.0), uv_seam: true)";
    let other = baked(&other, &format!("({relief}, {torus})"));
    let said = refusal(&[&other, "-o", "never.png"]);
    assert!(
        said.starts_with("the asset is for a mesh of ") && said.ends_with(" vertices, the game's has 4181"),
        "{said}"
    );
}

#[test]
fn what_is_no_asset_is_refused() {
    let said = refusal(&["nowhere.barchan", "-o", "never.png"]);
    assert!(said.starts_with("nowhere.barchan cannot be read: "), "{said}");
    let text = concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml");
    assert!(refusal(&[text, "-o", "never.png"]).contains("barchan"), "{}", refusal(&[text, "-o", "never.png"]));
    for words in [&[][..], &["a", "b"], &["a", "-o"], &["a", "-t", "soon"], &["--help"]] {
        assert!(refusal(words).starts_with("usage: game ASSET"), "{words:?}: {}", refusal(words));
    }
}
