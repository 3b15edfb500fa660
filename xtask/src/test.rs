//! `cargo xtask test`: everything that must hold.

use std::time::Instant;

use anyhow::Result;

use crate::run::{cargo, cargo_with};
use crate::{shaders, tidy, tools};

pub(crate) fn test() -> Result<()> {
    let start = Instant::now();
    tools::check()?;
    cargo("fmt --all --check")?;
    tidy::tidy()?;
    shaders::check()?;
    cargo("clippy --workspace --all-targets --all-features -- -D warnings")?;
    // What a game links has neither std nor dependencies: the features the workspace unites must not hide a mistake.
    cargo("clippy -p barchan-asset -- -D warnings")?;
    cargo_with("doc --workspace --no-deps --all-features", &[("RUSTDOCFLAGS", "-D warnings")])?;
    // Unit, property, golden and end-to-end tests, and the examples in the documentation.
    cargo("test --workspace --all-features")?;
    // The program as it is built by default, without a GPU.
    cargo("test -p barchan-cli --test end_to_end gpu")?;
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
