//! Programs that are weighed: cargo builds them, and the file system says what they weigh.

use std::path::PathBuf;
use std::process::Command;
use std::{env, fs};

use anyhow::{Context, Result, ensure};
use barchan_study::gpu_size::{PROFILE, PROGRAMS, Program, record};
use barchan_study::{Record, Scale};

/// Builds every program and weighs it; a quick run takes the profile that is built most often, whose bytes are worth nothing.
pub(crate) fn weigh(scale: Scale) -> Result<Vec<Record>> {
    let (profile, folder) = if scale == Scale::Full { (PROFILE, PROFILE) } else { ("dev", "debug") };
    PROGRAMS.iter().map(|program| Ok(record(program, bytes(program, profile, folder)?))).collect()
}

fn bytes(program: &Program, profile: &str, folder: &str) -> Result<u64> {
    let mut command = Command::new(env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned()));
    command.args(["build", "--package", "barchan-wgpu", "--example", program.example, "--profile", profile]);
    if !program.has_device {
        command.arg("--no-default-features");
    }
    let status = command.current_dir(super::root()).status().context("`cargo` cannot be started")?;
    ensure!(status.success(), "`cargo build --example {}` failed: {status}", program.example);
    let path = beside_this_program(folder)?.join(program.example).with_extension(env::consts::EXE_EXTENSION);
    Ok(fs::metadata(&path).with_context(|| format!("{} cannot be found", path.display()))?.len())
}

/// The examples of another profile, in the target folder that this program is in: `target/release/examples/study`.
fn beside_this_program(folder: &str) -> Result<PathBuf> {
    let program = env::current_exe().context("this program cannot say where it is")?;
    let target = program.ancestors().nth(3).context("this program is not in a target folder")?;
    Ok(target.join(folder).join("examples"))
}
