//! `cargo xtask shaders`: the published shaders, written by the example `shaders` of `barchan-wgpu`, and what compilers say of them.

use std::ffi::OsStr;
use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result, bail, ensure};

use crate::run::{example, root};

/// Writes `crates/wgpu/shaders`, and has it compiled.
pub(crate) fn shaders() -> Result<()> {
    example("shaders", "write")?;
    compile()
}

/// Fails if the published shaders are not what the source gives, or do not compile.
pub(crate) fn check() -> Result<()> {
    example("shaders", "check")?;
    compile()
}

/// Has every translation compiled by somebody else's compiler. Metal has none here.
fn compile() -> Result<()> {
    let mut compiled = 0;
    for entry in fs::read_dir(root().join("crates/wgpu/shaders"))? {
        let path = entry?.path();
        compiled += match path.extension().and_then(OsStr::to_str) {
            Some("spv") => one("spirv-val", &["--target-env", "vulkan1.0"], &path)?,
            Some("frag" | "vert") => one("glslangValidator", &[], &path)?,
            Some("hlsl") => hlsl(&path)?,
            _ => 0,
        };
    }
    // An empty folder would pass in silence.
    ensure!(compiled > 0, "crates/wgpu/shaders holds no shaders; run `cargo xtask shaders`");
    eprintln!("{compiled} shaders compile");
    Ok(())
}

/// Every entry point of an HLSL file; the WGSL beside it names them.
fn hlsl(path: &Path) -> Result<usize> {
    let source = path.with_extension("wgsl");
    let source = fs::read_to_string(&source).with_context(|| format!("{} is missing", source.display()))?;
    let out = root().join("target/shader.spv");
    let out = out.to_str().context("the path of the workspace is not UTF-8")?;
    let mut compiled = 0;
    for (attribute, stage) in [("@vertex\nfn ", "vert"), ("@fragment\nfn ", "frag")] {
        for rest in source.split(attribute).skip(1) {
            let entry_point = rest.split('(').next().unwrap_or_default();
            compiled += one("glslangValidator", &["-D", "-V", "-S", stage, "-e", entry_point, "-o", out], path)?;
        }
    }
    Ok(compiled)
}

/// One run of a compiler; what it says is shown if it fails.
fn one(program: &str, options: &[&str], path: &Path) -> Result<usize> {
    let output = Command::new(program).args(options).arg(path).output();
    let output = output.with_context(|| format!("`{program}` cannot be started; `cargo xtask setup` installs it"))?;
    if !output.status.success() {
        let said = [output.stdout, output.stderr].concat();
        bail!("{program} {} refuses {}:\n{}", options.join(" "), path.display(), String::from_utf8_lossy(&said));
    }
    Ok(1)
}
