//! What would otherwise be a shell script: `cargo xtask --help`.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a tool for the terminal")]

mod bench;
mod run;
mod samples;
mod shaders;
mod test;
mod tidy;
mod tools;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

#[derive(Parser)]
#[command(about = "Barchan's chores")]
struct Arguments {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    /// Install the programs that the tests need and that are missing, on Debian
    Setup,
    /// Everything that must hold before a commit: formatting, lints, tidiness, shaders, tests, docs
    Test,
    /// What the compiler cannot check: the crates' arrows, links in the docs, lints switched on, figures in the docs
    Tidy,
    /// Bake every sample and draw the pictures of the README into samples/gallery
    Samples,
    /// Write the golden pictures and texts anew, where the reference agrees
    Goldens,
    /// Write the published vectors that are missing; one that exists is never changed
    Vectors,
    /// Write the published shaders and their translations to crates/wgpu/shaders, and have them compiled
    Shaders,
    /// Measure speed and error, write the records and the tables of MEASUREMENTS.md
    Bench(bench::Options),
}

fn main() -> ExitCode {
    let done = match Arguments::parse().task {
        Task::Setup => tools::setup(),
        Task::Test => test::test(),
        Task::Tidy => tidy::tidy(),
        Task::Samples => samples::samples(),
        Task::Goldens => test::goldens(),
        Task::Vectors => run::cargo("run -p barchan-asset --features write --example write_vectors"),
        Task::Shaders => shaders::shaders(),
        Task::Bench(options) => bench::bench(&options),
    };
    if let Err(error) = done {
        eprintln!("xtask: {error:#}");
        return ExitCode::FAILURE;
    }
    ExitCode::SUCCESS
}
