//! Remembers which compiler built this crate: a record names it.
#![allow(clippy::print_stdout, reason = "how a build script speaks to cargo")]

use std::process::Command;

fn main() {
    let compiler = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let output = Command::new(compiler).arg("--version").output();
    let version = output.ok().and_then(|output| String::from_utf8(output.stdout).ok()).unwrap_or_default();
    // "rustc 1.95.0 (59807616e 2026-04-14)": the hash says no more than the number.
    let version: Vec<&str> = version.split_whitespace().take(2).collect();
    println!("cargo:rustc-env=BARCHAN_COMPILER={}", version.join(" "));
    println!("cargo:rerun-if-changed=build.rs");
}
