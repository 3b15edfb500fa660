//! The command line: what may be typed.

mod bake;
mod dump;
mod plan;
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
use self::words::{elevation, finite, not_negative};

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
    /// Draw the height field lit by a sun, with its horizon shadows
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

#[derive(Debug, Args)]
#[command(after_help = "Examples:
  barchan render dunes.barchan -o dunes.png
  barchan render dunes.barchan --azimuth 135 --elevation 10 --compare -o check.png
  barchan render dunes.barchan --ambient -o overcast.png")]
pub(crate) struct RenderArguments {
    /// The .barchan file; it needs the height table, and that of the horizon or, with --ambient, of the sky
    pub(crate) file: PathBuf,
    /// Where to write the PNG
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: PathBuf,
    /// Where the sun stands, in degrees counter-clockwise from +u (the right of the picture)
    #[arg(long, value_name = "DEGREES", default_value_t = 135.0, allow_hyphen_values = true, value_parser = finite)]
    pub(crate) azimuth: f64,
    /// How high it stands, in degrees above the base plane
    #[arg(long, value_name = "DEGREES", default_value_t = 20.0, allow_hyphen_values = true, value_parser = elevation)]
    pub(crate) elevation: f64,
    /// Pixels per texel
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=64))]
    pub(crate) scale: u32,
    /// Put a ray-traced shadow and the difference beside it: red is too dark, blue too light
    #[arg(long)]
    pub(crate) compare: bool,
    /// Light it by an overcast sky instead of a sun; the file needs sky_visibility, and uses bent_normal
    #[arg(long, conflicts_with_all = ["azimuth", "elevation", "compare"])]
    pub(crate) ambient: bool,
}
