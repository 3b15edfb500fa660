//! `cargo xtask test`: everything that must hold.

use std::time::Instant;

use anyhow::{Result, bail};

use crate::run::{answers, cargo, cargo_program, cargo_with};
use crate::tidy;

pub(crate) fn test() -> Result<()> {
    let start = Instant::now();
    check_tools()?;
    cargo("fmt --all --check")?;
    tidy::tidy()?;
    cargo("clippy --workspace --all-targets --all-features -- -D warnings")?;
    // What a game links has neither std nor dependencies: the features the workspace unites must not hide a mistake.
    cargo("clippy -p barchan-asset -- -D warnings")?;
    cargo_with("doc --workspace --no-deps --all-features", &[("RUSTDOCFLAGS", "-D warnings")])?;
    // Unit, property, golden and end-to-end tests, and the examples in the documentation.
    cargo("test --workspace --all-features")?;
    // An engine of one's own, without a device and without zstd.
    cargo("clippy -p barchan-wgpu --no-default-features --all-targets -- -D warnings")?;
    cargo("test -p barchan-wgpu --no-default-features")?;
    println!("\neverything holds, after {:.0} s", start.elapsed().as_secs_f64());
    Ok(())
}

/// Writes goldens anew. The tests themselves refuse where the reference disagrees.
pub(crate) fn goldens() -> Result<()> {
    cargo_with("test -p barchan-cli --test goldens", &[("BARCHAN_WRITE_GOLDENS", "1")])
}

/// Says exactly what to install, rather than fail in the middle.
fn check_tools() -> Result<()> {
    let compiler = std::env::var("CC").unwrap_or_else(|_| "cc".to_owned());
    let cargo = cargo_program();
    let needed = [
        (answers(&cargo, &["fmt"]), "rustfmt: rustup component add rustfmt"),
        (answers(&cargo, &["clippy"]), "clippy: rustup component add clippy"),
        (cfg!(windows) || answers(&compiler, &[]), "a C compiler, for zstd: apt-get install gcc libc6-dev"),
    ];
    let missing: Vec<_> = needed.iter().filter(|(found, _)| !found).map(|(_, what)| *what).collect();
    if !missing.is_empty() {
        bail!("install what is missing, then try again:\n  {}", missing.join("\n  "));
    }
    Ok(())
}
