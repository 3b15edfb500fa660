//! The programs that the tests need besides cargo: which are missing, and `cargo xtask setup`, which installs them on Debian.

use std::path::Path;
use std::process::Command;

use anyhow::{Result, bail};

use crate::run::{answers, cargo_program, run};

/// Something that must be there.
struct Tool {
    name: &'static str,
    purpose: &'static str,
    source: Source,
    is_there: bool,
}

/// Where it comes from.
enum Source {
    Rustup,
    /// Packages of Debian.
    Debian(&'static [&'static str]),
}

impl Tool {
    /// What installs it.
    fn command(&self) -> String {
        match self.source {
            Source::Rustup => format!("rustup component add {}", self.name),
            Source::Debian(packages) => format!("apt-get install -y {}", packages.join(" ")),
        }
    }
}

fn tools() -> [Tool; 6] {
    let cargo = cargo_program();
    let compiler = std::env::var("CC").unwrap_or_else(|_| "cc".to_owned());
    let tool = |name, purpose, source, is_there| Tool { name, purpose, source, is_there };
    let (rustup, debian) = (|| Source::Rustup, Source::Debian);
    [
        tool("rustfmt", "to format", rustup(), answers(&cargo, &["fmt"])),
        tool("clippy", "for lints", rustup(), answers(&cargo, &["clippy"])),
        tool("a C compiler", "for zstd", debian(&["gcc", "libc6-dev"]), cfg!(windows) || answers(&compiler, &[])),
        tool(
            "a Vulkan driver",
            "to hold the GPU against the CPU; a software one is enough",
            debian(&["mesa-vulkan-drivers", "libvulkan1"]),
            has_vulkan(),
        ),
        tool("spirv-val", "to check shaders", debian(&["spirv-tools"]), answers("spirv-val", &[])),
        tool("glslangValidator", "to check shaders", debian(&["glslang-tools"]), answers("glslangValidator", &[])),
    ]
}

/// Whether a driver is registered where the Vulkan loader looks; elsewhere than on Linux the system brings one.
fn has_vulkan() -> bool {
    let is_named = ["VK_DRIVER_FILES", "VK_ICD_FILENAMES"].iter().any(|name| std::env::var_os(name).is_some());
    let folders = ["/usr/share/vulkan/icd.d", "/usr/local/share/vulkan/icd.d", "/etc/vulkan/icd.d"];
    let is_registered = |folder: &str| Path::new(folder).read_dir().is_ok_and(|mut files| files.next().is_some());
    !cfg!(target_os = "linux") || is_named || folders.into_iter().any(is_registered)
}

/// Says exactly what to install, rather than fail in the middle.
pub(crate) fn check() -> Result<()> {
    let missing = tools().into_iter().filter(|tool| !tool.is_there);
    let lines: Vec<_> = missing.map(|tool| format!("{}, {}: {}", tool.name, tool.purpose, tool.command())).collect();
    if !lines.is_empty() {
        bail!("install what is missing, on Debian with `cargo xtask setup`, then try again:\n  {}", lines.join("\n  "));
    }
    Ok(())
}

/// Installs what is missing, and says what it does.
pub(crate) fn setup() -> Result<()> {
    let missing: Vec<_> = tools().into_iter().filter(|tool| !tool.is_there).collect();
    let mut packages: Vec<&str> = Vec::new();
    for tool in &missing {
        match tool.source {
            Source::Rustup => spoken("rustup", &["component", "add", tool.name])?,
            Source::Debian(of_tool) => packages.extend(of_tool),
        }
    }
    if !packages.is_empty() {
        if !answers("apt-get", &[]) {
            bail!("there is no apt-get here; install by other means: {}", packages.join(" "));
        }
        as_root(&["apt-get", "update", "-q"])?;
        as_root(&[&["apt-get", "install", "-y", "-q", "--no-install-recommends"], &packages[..]].concat())?;
    }
    eprintln!("all tools are there");
    Ok(())
}

/// Runs a command, through sudo for who is not root.
fn as_root(command: &[&str]) -> Result<()> {
    let id = Command::new("id").arg("-u").output();
    let is_root = id.is_ok_and(|output| output.stdout.trim_ascii() == b"0");
    if is_root { spoken(command[0], &command[1..]) } else { spoken("sudo", command) }
}

fn spoken(program: &str, arguments: &[&str]) -> Result<()> {
    eprintln!("> {program} {}", arguments.join(" "));
    run(Command::new(program).args(arguments), program)
}
