//! The command line: what may be typed.

mod bake;
mod dump;
mod plan;
mod render;
mod words;

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};

pub(crate) use self::bake::{
    BakeArguments, BareArguments, HeightMapArguments, MeshArguments, MethodName, WantedArguments,
};
pub(crate) use self::dump::{
    ColouredBy, CurvatureDumpArguments, DumpArguments, DumpFormat, MeshPictureArguments, TextureDumpArguments,
    UpAxisName,
};
pub(crate) use self::plan::PlanArguments;
pub(crate) use self::render::{BaseName, RenderArguments, SearchName, StartName};
use self::words::not_negative;

/// Bakes relief and the curvature of meshes into tables that a shader can read.
#[derive(Debug, Parser)]
#[command(name = "barchan", version, max_term_width = 100, after_help = EXIT_CODES)]
pub(crate) struct Arguments {
    /// Print the result as JSON with a versioned schema name
    #[arg(long, global = true)]
    pub(crate) json: bool,
    /// How to show progress on stderr
    #[arg(long, global = true, value_name = "STYLE", default_value = "auto")]
    pub(crate) progress: ProgressStyleName,
    #[command(subcommand)]
    pub(crate) command: Command,
}

const EXIT_CODES: &str = "Exit codes: 0 done, 1 wrong usage, 2 bad input, 3 difference found, 4 disk or system failed.";

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Bake a recipe, a height map or a mesh into a .barchan file
    Bake(BakeArguments),
    /// Show what a bake would bake, what it would leave out, and why
    Plan(PlanArguments),
    /// Show what a .barchan file holds
    #[command(after_help = "Examples:
  barchan inspect dunes.barchan
  barchan inspect dunes.barchan --json | jq .provenance.horizon.accuracy")]
    Inspect(FileArguments),
    /// Write a table's values as text, CSV, NPY, PNG, EXR or PLY
    Dump(DumpArguments),
    /// Check every byte of a .barchan file
    #[command(after_help = "Examples:
  barchan validate dunes.barchan
  barchan validate dunes.barchan --json | jq .findings")]
    Validate(FileArguments),
    /// Compare two .barchan files value by value
    Compare(CompareArguments),
    /// Draw the height field lit by a sun, from above with its horizon shadows, or from a side by relief mapping
    Render(RenderArguments),
}

#[derive(Debug, Args)]
pub(crate) struct FileArguments {
    /// The .barchan file
    pub(crate) file: PathBuf,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum ProgressStyleName {
    /// A bar if stderr is a terminal
    Auto,
    /// A line per step
    Plain,
    /// An object per line
    Json,
    /// Nothing
    None,
}

#[derive(Debug, Args)]
#[command(after_help = "Examples:
  barchan compare dunes.barchan old.barchan
  barchan compare dunes.barchan old.barchan --tolerance 0.1")]
pub(crate) struct CompareArguments {
    /// The first .barchan file
    pub(crate) a: PathBuf,
    /// The second
    pub(crate) b: PathBuf,
    /// The difference to accept: degrees for horizons, the length unit for heights and distances, plain numbers for the sky,
    /// 1 / length unit for curvatures
    #[arg(long, value_name = "VALUE", default_value_t = 0.0, allow_hyphen_values = true, value_parser = not_negative)]
    pub(crate) tolerance: f64,
}
