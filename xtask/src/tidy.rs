//! `cargo xtask tidy`: what the compiler cannot check.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result, bail, ensure};
use serde_json::Value;

use crate::bench;
use crate::run::{cargo_program, root};

/// The crates and the crates of ours each may use; ARCHITECTURE.md says why. Tests and benches may use more.
const ARROWS: [(&str, &[&str]); 12] = [
    ("asset", &[]),
    ("bakers", &["asset", "field"]),
    // The last two by the feature `gpu` alone, which `TREES` sees to.
    ("cli", &["asset", "field", "import", "metrics", "pipeline", "shade", "view", "wgpu"]),
    ("field", &[]),
    ("import", &["field"]),
    ("metrics", &[]),
    ("pipeline", &["asset", "bakers", "field", "import", "metrics"]),
    ("shade", &["asset"]),
    // What the reader costs is measured like the rest, on a GPU that `view` opens.
    ("study", &["asset", "bakers", "field", "metrics", "shade", "view", "wgpu"]),
    ("view", &["asset", "wgpu"]),
    ("wgpu", &["asset"]),
    ("xtask", &[]),
];

/// Trees of dependencies that must stay short, as arguments of `cargo tree`: the packages whose names begin so, and which of these
/// are accepted.
const TREES: [(&str, &str, &[&str]); 3] = [
    // What a game links is the format and the reader, whatever the features; and with a device of its own, nothing else at all.
    ("-p barchan-wgpu --all-features", "barchan-", &["barchan-asset", "barchan-wgpu"]),
    ("-p barchan-wgpu --no-default-features", "", &["barchan-asset", "barchan-wgpu"]),
    // The program as it is built by default, without a GPU.
    ("-p barchan-cli", "wgpu", &[]),
];

/// Documents whose relative links must lead somewhere.
const DOCUMENTS: [&str; 18] = [
    "README.md",
    "MEASUREMENTS.md",
    "ARCHITECTURE.md",
    "CONTRIBUTING.md",
    "CHANGELOG.md",
    "crates/wgpu/README.md",
    "crates/wgpu/examples/game.md",
    "crates/wgpu/shaders/README.md",
    "formats/barchan-v1.md",
    "formats/cone-v1.md",
    "formats/curvature-v1.md",
    "formats/height-v1.md",
    "formats/hemisphere-v1.md",
    "formats/horizon-v1.md",
    "formats/maximum-v1.md",
    "formats/sky-v1.md",
    "samples/README.md",
    "tests/README.md",
];

pub(crate) fn tidy() -> Result<()> {
    eprintln!("\n> tidy");
    let problems: Vec<String> = [arrows()?, trees()?, lints()?, links()?].concat();
    if !problems.is_empty() {
        bail!("not tidy:\n  {}", problems.join("\n  "));
    }
    bench::check()
}

/// Arrows that the map does not have, crates it does not know, and crates that are gone.
fn arrows() -> Result<Vec<String>> {
    let allowed: BTreeMap<_, _> = ARROWS.into_iter().collect();
    let found = crates()?;
    let mut problems = Vec::new();
    for (name, uses) in &found {
        match allowed.get(name.as_str()) {
            None => problems.push(format!("crate `{name}` is not on the map in xtask/src/tidy.rs")),
            Some(may_use) => {
                let forbidden = uses.iter().filter(|used| !may_use.contains(&used.as_str()));
                problems.extend(forbidden.map(|used| format!("`{name}` must not use `{used}`")));
            }
        }
    }
    let gone = allowed.keys().filter(|name| !found.contains_key(**name));
    problems.extend(gone.map(|name| format!("crate `{name}` is on the map but not in the workspace")));
    Ok(problems)
}

/// Our crates, and for each the crates of ours it depends on outside tests.
fn crates() -> Result<BTreeMap<String, Vec<String>>> {
    let mut command = Command::new(cargo_program());
    command.current_dir(root()).args(["metadata", "--no-deps", "--format-version", "1"]);
    let output = command.output().context("`cargo metadata` cannot be started")?;
    ensure!(output.status.success(), "`cargo metadata` failed: {}", String::from_utf8_lossy(&output.stderr));
    let metadata: Value = serde_json::from_slice(&output.stdout)?;
    let packages = metadata["packages"].as_array().context("cargo metadata lists packages")?;
    Ok(packages.iter().map(|package| (ours(&package["name"]), uses(package))).collect())
}

fn uses(package: &Value) -> Vec<String> {
    let dependencies = package["dependencies"].as_array().into_iter().flatten();
    let built_in = dependencies.filter(|dependency| dependency["kind"].as_str() != Some("dev"));
    let named = built_in.filter(|dependency| dependency["name"].as_str().is_some_and(|n| n.starts_with("barchan-")));
    named.map(|dependency| ours(&dependency["name"])).collect()
}

fn ours(name: &Value) -> String {
    name.as_str().unwrap_or_default().trim_start_matches("barchan-").to_owned()
}

/// Packages in a tree where they are not accepted. Tests and builds may use more.
fn trees() -> Result<Vec<String>> {
    let mut problems = Vec::new();
    for (arguments, beginning, accepted) in TREES {
        let mut command = Command::new(cargo_program());
        command.current_dir(root()).args(["tree", "--edges", "normal", "--prefix", "none", "--format", "{p}"]);
        let output = command.args(arguments.split(' ')).output().context("`cargo tree` cannot be started")?;
        ensure!(output.status.success(), "`cargo tree` failed: {}", String::from_utf8_lossy(&output.stderr));
        let tree = String::from_utf8_lossy(&output.stdout);
        let names: BTreeSet<_> = tree.lines().filter_map(|line| line.split(' ').next()).collect();
        let looked_at = names.iter().filter(|name| name.starts_with(beginning));
        let forbidden = looked_at.filter(|name| !accepted.contains(name));
        problems.extend(forbidden.map(|name| format!("`{name}` must not be in `cargo tree {arguments}`")));
    }
    Ok(problems)
}

/// Every package must switch the workspace's lints on: they forbid `unsafe`.
fn lints() -> Result<Vec<String>> {
    let mut manifests = vec![root().join("xtask/Cargo.toml")];
    for entry in fs::read_dir(root().join("crates"))? {
        manifests.push(entry?.path().join("Cargo.toml"));
    }
    let mut problems = Vec::new();
    for manifest in manifests {
        if !fs::read_to_string(&manifest)?.contains("[lints]\nworkspace = true") {
            problems.push(format!("{} does not switch on the workspace's lints", manifest.display()));
        }
    }
    Ok(problems)
}

fn links() -> Result<Vec<String>> {
    let mut problems = Vec::new();
    for document in DOCUMENTS {
        let path = root().join(document);
        let text = fs::read_to_string(&path).with_context(|| format!("{document} is missing"))?;
        let folder = path.parent().unwrap_or(Path::new("."));
        for target in link_targets(&text) {
            let file = target.split('#').next().unwrap_or_default();
            if !target.contains("://") && !file.is_empty() && !folder.join(file).exists() {
                problems.push(format!("{document} links to {target}, which does not exist"));
            }
        }
    }
    Ok(problems)
}

/// The `target` of every `](target)` and `src="target"`.
fn link_targets(markdown: &str) -> impl Iterator<Item = &str> {
    let between = |start, end: char| markdown.split(start).skip(1).filter_map(move |rest: &str| rest.split(end).next());
    between("](", ')').chain(between("src=\"", '"'))
}
