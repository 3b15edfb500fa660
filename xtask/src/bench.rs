//! `cargo xtask bench`: the figures of MEASUREMENTS.md, measured by the example `study`.

use anyhow::Result;
use clap::Args;

use crate::run::{cargo, example};

#[derive(Args)]
pub(crate) struct Options {
    /// Seconds instead of minutes, to see that it runs: records go to target/study, MEASUREMENTS.md stays as it is
    #[arg(long)]
    quick: bool,
    /// Measure only these, separated by commas: the names of the files in crates/study/records
    #[arg(long, value_name = "RECORDS")]
    only: Option<String>,
    /// Measure nothing: write the tables of MEASUREMENTS.md and the charts from the records there are
    #[arg(long, conflicts_with_all = ["quick", "only"])]
    render: bool,
}

/// Measures, writes `crates/study/records/*.csv`, prints the tables and writes them to MEASUREMENTS.md and the charts to the gallery.
pub(crate) fn bench(options: &Options) -> Result<()> {
    if options.render {
        return cargo("run --quiet -p barchan-study --example study -- render");
    }
    let quick = if options.quick { "--quick" } else { "" };
    let only = options.only.as_ref().map_or_else(String::new, |only| format!("--only {only}"));
    cargo(&format!("run --release -p barchan-study --example study -- measure {quick} {only}"))
}

/// Fails if the tables of MEASUREMENTS.md or the charts are not those of the records.
pub(crate) fn check() -> Result<()> {
    example("study", "check")
}
