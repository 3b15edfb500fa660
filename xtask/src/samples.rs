//! `cargo xtask samples`: every recipe baked, every picture of the README drawn.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, ensure};

use crate::run::{cargo, root, run, target};

/// A lit picture of the gallery: its name, its recipe, and how it is drawn.
struct Picture {
    name: &'static str,
    recipe: &'static str,
    options: &'static str,
}

const GALLERY: [Picture; 14] = [
    Picture { name: "dunes", recipe: "dunes", options: "--azimuth 150 --elevation 14 --scale 2" },
    Picture { name: "dunes_dusk", recipe: "dunes", options: "--azimuth 150 --elevation 6" },
    Picture { name: "jacksboro", recipe: "jacksboro", options: "--azimuth 135 --elevation 10" },
    Picture { name: "jacksboro_compared", recipe: "jacksboro", options: "--azimuth 135 --elevation 10 --compare" },
    Picture { name: "reptile_skin", recipe: "reptile_skin", options: "--azimuth 135 --elevation 25" },
    Picture { name: "cylinder_bumps", recipe: "cylinder_bumps", options: "--azimuth 30 --elevation 20 --scale 2" },
    Picture { name: "fractal_terrain", recipe: "fractal_terrain", options: "--azimuth 120 --elevation 25" },
    Picture {
        name: "relief",
        recipe: "relief",
        options: "--eye-azimuth 250 --eye-elevation 40 --azimuth 190 --elevation 30 --tiles 1",
    },
    Picture { name: "relief_sky", recipe: "relief", options: "--eye-elevation 40 --ambient --tiles 1" },
    Picture { name: "relief_heat", recipe: "relief", options: "--eye-elevation 35 --size 480 --heat" },
    Picture {
        name: "relief_ball",
        recipe: "relief",
        options: "--eye-elevation 20 --on sphere --azimuth 220 --elevation 30",
    },
    // CPU, GPU and difference; without a GPU, not even a software one, the program says what installs one.
    Picture { name: "gpu_dunes", recipe: "dunes", options: "--azimuth 150 --elevation 5 --gpu --compare" },
    Picture {
        name: "gpu_relief",
        recipe: "relief",
        options: "--eye-azimuth 250 --eye-elevation 40 --azimuth 190 --elevation 30 --tiles 1 --size 400 --gpu --compare",
    },
    Picture {
        name: "gpu_ball",
        recipe: "relief",
        options: "--eye-elevation 20 --on sphere --azimuth 220 --elevation 30 --size 320 --gpu --compare",
    },
];

/// How the bust is drawn: from the front, a little to one side.
const BUST: &str = "--format png --view 30,-5 --size 640";

/// What the example game is told, from the root.
const GAME: &str = "target/samples/game.barchan -t 1.5 -o samples/gallery/game.png";

/// Draws `samples/gallery/*.png`; baked files go under `target/samples`.
pub(crate) fn samples() -> Result<()> {
    cargo("build --release --features gpu")?;
    let program = program()?;
    let baked = root().join("target/samples");
    let gallery = root().join("samples/gallery");
    fs::create_dir_all(&baked)?;
    fs::create_dir_all(&gallery)?;
    for recipe in recipes()? {
        let output = baked.join(recipe.with_extension("barchan").file_name().context("a recipe has a name")?);
        barchan(&program, &[&"bake", &recipe, &"-o", &output], "")?;
        barchan(&program, &[&"validate", &output], "")?;
    }
    for picture in &GALLERY {
        let asset = baked.join(picture.recipe).with_extension("barchan");
        let output = gallery.join(picture.name).with_extension("png");
        barchan(&program, &[&"render", &asset, &"-o", &output], picture.options)?;
    }
    let (asset, mesh) = (baked.join("demosthenes.barchan"), root().join("samples/demosthenes.ply"));
    let bust = gallery.join("demosthenes_curvature.png");
    barchan(&program, &[&"dump", &asset, &"curvature", &"--mesh", &mesh, &"-o", &bust], BUST)?;
    // What a game draws of its asset.
    cargo(&format!("run --release --quiet -p barchan-wgpu --example game -- {GAME}"))?;
    println!("{} pictures in {}", GALLERY.len() + 2, gallery.display());
    // Curved surfaces are no part of a recipe: the study has them.
    cargo("run --release --quiet -p barchan-study --example study -- pictures")
}

/// The program that cargo just built.
fn program() -> Result<PathBuf> {
    let program = target().join("release").join(format!("barchan{}", std::env::consts::EXE_SUFFIX));
    ensure!(program.exists(), "{} was not built", program.display());
    Ok(program)
}

fn recipes() -> Result<Vec<PathBuf>> {
    let files = fs::read_dir(root().join("samples"))?.map(|entry| Ok(entry?.path()));
    let mut recipes = files.collect::<Result<Vec<_>>>()?;
    recipes.retain(|path| path.extension().is_some_and(|extension| extension == "ron"));
    recipes.sort();
    Ok(recipes)
}

fn barchan(program: &Path, arguments: &[&dyn AsRef<std::ffi::OsStr>], options: &str) -> Result<()> {
    let mut command = Command::new(program);
    command.args(arguments.iter().map(|argument| argument.as_ref())).args(options.split_whitespace());
    run(&mut command, "barchan")
}
