//! Commands, run from the workspace root.

use std::path::PathBuf;
use std::process::{Command, Stdio};

use anyhow::{Context, Result, ensure};

/// The workspace root.
pub(crate) fn root() -> PathBuf {
    // xtask is one folder below it.
    let xtask = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    xtask.parent().map_or_else(|| PathBuf::from("."), PathBuf::from)
}

/// Cargo with arguments separated by spaces; fails if it does.
pub(crate) fn cargo(arguments: &str) -> Result<()> {
    cargo_with(arguments, &[])
}

/// [`cargo`] with environment variables.
pub(crate) fn cargo_with(arguments: &str, variables: &[(&str, &str)]) -> Result<()> {
    eprintln!("\n> cargo {arguments}");
    let mut command = Command::new(cargo_program());
    command.args(arguments.split_whitespace()).envs(variables.iter().copied());
    run(&mut command, arguments)
}

/// Runs an example. It is built with the features of the whole workspace, as the tests are: by itself it would have its own, and cargo
/// would build all it stands on a second time.
pub(crate) fn example(name: &str, arguments: &str) -> Result<()> {
    cargo(&format!("build --quiet --workspace --all-features --example {name}"))?;
    let program = target().join("debug/examples").join(format!("{name}{}", std::env::consts::EXE_SUFFIX));
    eprintln!("\n> {name} {arguments}");
    run(Command::new(program).args(arguments.split_whitespace()), name)
}

/// The folder that cargo builds into, wherever this machine keeps it.
pub(crate) fn target() -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from)
}

/// Runs a command from the root and fails if it does.
pub(crate) fn run(command: &mut Command, name: &str) -> Result<()> {
    let status = command.current_dir(root()).status().with_context(|| format!("`{name}` cannot be started"))?;
    ensure!(status.success(), "`{name}` failed: {status}");
    Ok(())
}

/// Whether a program answers to `--version`.
pub(crate) fn answers(program: &str, arguments: &[&str]) -> bool {
    let mut command = Command::new(program);
    command.args(arguments).arg("--version").stdout(Stdio::null()).stderr(Stdio::null());
    command.status().is_ok_and(|status| status.success())
}

/// The cargo that runs this, so that `cargo +toolchain xtask` means that toolchain all the way down.
pub(crate) fn cargo_program() -> String {
    std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned())
}
