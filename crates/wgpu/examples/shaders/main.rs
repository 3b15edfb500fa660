//! The published shaders, and the shader of an asset.
//!
//! ```text
//! cargo run -p barchan-wgpu --example shaders -- of FILE.barchan     what its tables allow: techniques, functions, bindings
//! cargo run -p barchan-wgpu --example shaders -- wgsl FILE.barchan   the WGSL of all that
//! cargo run -p barchan-wgpu --example shaders -- write               the files of crates/wgpu/shaders
//! cargo run -p barchan-wgpu --example shaders -- check               fails if these are not what the source gives
//! ```
//!
//! Names of techniques behind a file, such as `"curved shadow" sky`, leave out all others.
#![allow(clippy::print_stdout, reason = "an example for the terminal")]

#[path = "../../tests/support/every_table.rs"]
mod every_table;

mod functions;
mod languages;
mod names;
mod page;
mod published;

use std::collections::BTreeMap;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use barchan_wgpu::{BindingKind, DeviceLimits, Reader, Selection, Shader, ShaderOptions, Technique, UploadPlan};
use published::Published;

type Outcome<T> = Result<T, Box<dyn Error>>;

fn main() -> Outcome<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["of", path, ref names @ ..] => {
            of_file(Path::new(path), names).map(|(techniques, shader)| describe(&techniques, &shader))
        }
        ["wgsl", path, ref names @ ..] => {
            of_file(Path::new(path), names).map(|(_, shader)| println!("{}", shader.source()))
        }
        ["write"] => write(&files()?),
        ["check"] => check(&files()?),
        _ => Err("say `of FILE.barchan`, `wgsl FILE.barchan`, `write` or `check`".into()),
    }
}

/// What the tables of a file allow, or what of that is named, and the shader of it.
fn of_file(path: &Path, names: &[&str]) -> Outcome<(Vec<Technique>, Shader)> {
    let bytes = fs::read(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let plan = UploadPlan::new(&Reader::open(&bytes)?, &Selection::everything(), &DeviceLimits::WEBGPU)?;
    let allowed = Technique::of_plan(&plan);
    let name_of = |name: &&str| allowed.iter().copied().find(|technique| technique.name() == *name);
    let unknown = |name: &&str| format!("{} allows no {name:?}", path.display());
    let techniques = match names {
        [] => allowed.clone(),
        names => names.iter().map(|name| name_of(name).ok_or_else(|| unknown(name))).collect::<Result<_, _>>()?,
    };
    let shader = Shader::compose(&plan, &techniques, &ShaderOptions::default())?;
    Ok((techniques, shader))
}

/// Prints techniques, with their functions, and bindings.
fn describe(techniques: &[Technique], shader: &Shader) {
    for technique in techniques {
        let is_there = |name: &&&str| shader.source().contains(&format!("fn {name}("));
        let functions: Vec<_> = technique.functions().iter().filter(is_there).copied().collect();
        println!("{}: {}", technique.name(), functions.join(", "));
    }
    println!();
    for binding in shader.bindings() {
        println!("@group({}) @binding({})  {}", binding.group, binding.binding, described(binding.kind));
    }
}

/// What is bound, in a few words.
fn described(kind: BindingKind) -> String {
    match kind {
        BindingKind::Parameters => "uniform buffer: the numbers of the tables".to_owned(),
        BindingKind::Sampler => "sampler: linear".to_owned(),
        BindingKind::Texture { table, shape, .. } => {
            format!("{}: {}", names::shape(shape), table.kind().name().unwrap_or_default())
        }
        BindingKind::Probe => "uniform buffer: what probes draw".to_owned(),
    }
}

/// Where the published shaders are.
fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("shaders")
}

/// Every published file: its name, and its bytes.
fn files() -> Outcome<BTreeMap<String, Vec<u8>>> {
    let shaders = published::all()?;
    let mut files = BTreeMap::new();
    for shader in &shaders {
        files.extend(shader.files());
    }
    // The vertex stage is the same for all but for functions that it does not call.
    files.extend(shaders.first().map(Published::vertex_file));
    files.insert("README.md".to_owned(), page::page(&shaders)?.into_bytes());
    Ok(files)
}

fn write(files: &BTreeMap<String, Vec<u8>>) -> Outcome<()> {
    fs::create_dir_all(folder())?;
    for name in present()?.iter().filter(|name| !files.contains_key(*name)) {
        fs::remove_file(folder().join(name))?;
    }
    for (name, bytes) in files {
        fs::write(folder().join(name), bytes)?;
    }
    println!("wrote {} files, {} KiB", files.len(), files.values().map(Vec::len).sum::<usize>() / 1024);
    Ok(())
}

fn check(files: &BTreeMap<String, Vec<u8>>) -> Outcome<()> {
    let stale = files.iter().filter(|(name, bytes)| fs::read(folder().join(name)).ok().as_ref() != Some(bytes));
    let mut wrong: Vec<_> = stale.map(|(name, _)| name.clone()).collect();
    wrong.extend(present()?.into_iter().filter(|name| !files.contains_key(name)));
    if wrong.is_empty() {
        return Ok(());
    }
    let (count, first) = (wrong.len(), &wrong[0]);
    Err(format!(
        "crates/wgpu/shaders is not what the source gives ({count} files, {first} first); run `cargo xtask shaders`"
    )
    .into())
}

/// Names of the files that are there.
fn present() -> Outcome<Vec<String>> {
    let entries = fs::read_dir(folder()).into_iter().flatten();
    let names = entries.map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned()));
    names.collect()
}
