//! The command line: what may be typed.

use std::path::PathBuf;

use barchan_field::{Edge, LengthUnit, Spacing};
use barchan_import::{Fill, Integers};
use barchan_pipeline::{Compression, CurvatureMethod, CurvaturePart, HorizonMethod, Table, TableEncoding};
use clap::{Args, Parser, Subcommand, ValueEnum};

/// Bakes relief into tables that a shader can read.
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

#[derive(Debug, Args)]
#[command(after_help = "Examples:
  barchan bake samples/dunes.ron
  barchan bake rock.obj
  barchan bake statue.ply --method fast --encoding f32 -o statue.barchan
  barchan bake rock.png --height-scale 12 --edge wrap --method exact --encoding f16 -o rock.barchan
  barchan bake rock.png --height-scale 12 --arc 180,360 --directions 17
  barchan bake elevation.tif --integers raw --spacing 74,93 --unit metre --radius 20000 --json")]
pub(crate) struct BakeArguments {
    /// A recipe (.ron), a height map (PNG, EXR, TIFF, NPY) or a mesh (OBJ, PLY, glTF)
    pub(crate) input: PathBuf,
    /// Where to write [default: the input's name with .barchan, in this folder]
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// Bake these tables and no others: height, horizon, distance, swept_horizon, swept_distance, sky_visibility,
    /// bent_normal, aperture_cone; of a mesh: curvature
    #[arg(long, value_name = "TABLE,..", value_delimiter = ',', value_parser = table)]
    pub(crate) only: Option<Vec<Table>>,
    /// Worker threads, at most 1024; 0 is one per core
    #[arg(short = 'j', long, value_name = "N", default_value_t = 0, value_parser = jobs)]
    pub(crate) jobs: usize,
    #[command(flatten)]
    pub(crate) bare: BareArguments,
    #[command(flatten)]
    pub(crate) height_map: HeightMapArguments,
    #[command(flatten)]
    pub(crate) mesh: MeshArguments,
}

/// What a recipe would say of either, for a height map or a mesh without one.
#[derive(Debug, Args)]
#[command(next_help_heading = "For a height map or a mesh without a recipe")]
pub(crate) struct BareArguments {
    /// How the horizon of a height map is found: sweep (fastest), accurate or exact; how the curvature of a mesh is: fast or
    /// accurate [default: accurate]
    #[arg(long, value_parser = method)]
    pub(crate) method: Option<MethodName>,
    /// The unit of heights, spacing and radius, or of the mesh: metre, centimetre, millimetre, kilometre
    /// [default: scene_unit]
    #[arg(long, value_parser = unit)]
    pub(crate) unit: Option<LengthUnit>,
    /// How tables are stored: f32, f16, u8 or compact; heights and curvatures are f16 at least [default: compact]
    #[arg(long, value_parser = encoding)]
    pub(crate) encoding: Option<TableEncoding>,
    /// How sections are packed: none or zstd [default: none]
    #[arg(long, value_parser = compression)]
    pub(crate) compression: Option<Compression>,
}

/// What a recipe would say, for a height map without one.
#[derive(Debug, Args)]
#[command(next_help_heading = "For a height map without a recipe")]
pub(crate) struct HeightMapArguments {
    /// Azimuths to bake, the first along +u, counter-clockwise [default: 32]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=i64::from(barchan_asset::MAX_LAYERS)))]
    pub(crate) directions: Option<u32>,
    /// Bake azimuths from FIRST to LAST only, in degrees counter-clockwise from +u: where the sun never stands elsewhere
    #[arg(long, value_name = "FIRST,LAST", allow_hyphen_values = true, value_parser = arc)]
    pub(crate) arc: Option<(f64, f64)>,
    /// What lies beyond the edge: wrap or clamp [default: clamp]
    #[arg(long, value_name = "EDGE", value_parser = edge)]
    pub(crate) edge: Option<Edge>,
    /// Length per texel, or two: along u and along v [default: 1]
    #[arg(long, value_name = "LENGTH[,LENGTH]", allow_hyphen_values = true, value_parser = spacing)]
    pub(crate) spacing: Option<Spacing>,
    /// What a whole number in the file means: normalised (full scale is 1) or raw [default: normalised]
    #[arg(long, value_parser = integers)]
    pub(crate) integers: Option<Integers>,
    /// Height of a sample of 1: of white, if integers are normalised [default: 1]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true, value_parser = finite)]
    pub(crate) height_scale: Option<f64>,
    /// Height of a sample of 0 [default: 0]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true, value_parser = finite)]
    pub(crate) height_offset: Option<f64>,
    /// How far the horizon is searched [default: the diagonal; the longer side if the map wraps]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true, value_parser = positive)]
    pub(crate) radius: Option<f64>,
    /// The channel that holds the height
    #[arg(long, value_name = "NAME")]
    pub(crate) channel: Option<String>,
    /// The raw sample that stands for no data
    #[arg(long, value_name = "SAMPLE", allow_hyphen_values = true, value_parser = finite)]
    pub(crate) no_data: Option<f64>,
    /// The height of texels without data: lowest, nearest or a length
    #[arg(long, value_name = "RULE", allow_hyphen_values = true, value_parser = fill)]
    pub(crate) fill: Option<Fill>,
}

/// What a recipe would say, for a mesh without one.
#[derive(Debug, Args)]
#[command(next_help_heading = "For a mesh without a recipe")]
pub(crate) struct MeshArguments {
    /// Where the mesh's normals on the two sides of an edge differ by more, the surface is not smooth across it [default: 30]
    #[arg(long, value_name = "DEGREES", allow_hyphen_values = true, value_parser = hard_edge)]
    pub(crate) hard_edge: Option<f64>,
    /// Which mesh of a glTF file that has several: its name, or its number counted from 0
    #[arg(long, value_name = "NAME")]
    pub(crate) mesh: Option<String>,
}

/// The methods of both bakers: which of them a word may name, the input decides.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum MethodName {
    /// Horizons.
    Sweep,
    /// Curvature.
    Fast,
    /// Either.
    Accurate,
    /// Horizons.
    Exact,
}

impl MethodName {
    const ALL: [Self; 4] = [Self::Sweep, Self::Fast, Self::Accurate, Self::Exact];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Sweep => "sweep",
            Self::Fast => "fast",
            Self::Accurate => "accurate",
            Self::Exact => "exact",
        }
    }

    /// The method of a horizon that is called so.
    pub(crate) fn of_a_horizon(self) -> Option<HorizonMethod> {
        match self {
            Self::Sweep => Some(HorizonMethod::Sweep),
            Self::Accurate => Some(HorizonMethod::Accurate),
            Self::Exact => Some(HorizonMethod::Exact),
            Self::Fast => None,
        }
    }

    /// The method of curvature that is called so.
    pub(crate) fn of_curvature(self) -> Option<CurvatureMethod> {
        match self {
            Self::Fast => Some(CurvatureMethod::Fast),
            Self::Accurate => Some(CurvatureMethod::Accurate),
            Self::Sweep | Self::Exact => None,
        }
    }
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
#[command(
    after_help = "Values: heights and distances in the length unit, horizons as the slope (tangent of the elevation) \
in npy, as degrees in text, as both in csv, as radians in exr, over the table's range in png; sky visibility from 0 to 1; bent \
normal and aperture cone as u, v, height and cosine of the half-angle, in png as red, green, blue and alpha; curvatures in 1 / \
length unit, positive where convex, in ply as a colour from blue (concave) over white to red (convex).

Examples:
  barchan dump dunes.barchan horizon --format npy -o horizon.npy     float32 [directions, height, width]
  barchan dump dunes.barchan height --format exr -o height.exr
  barchan dump dunes.barchan horizon --layer 4 --format png -o east.png
  barchan dump dunes.barchan height --format csv | head
  barchan dump rock.barchan curvature --format npy -o rock.npy       float32 [vertices, 2]
  barchan dump rock.barchan curvature --format ply --mesh rock.obj -o coloured.ply"
)]
pub(crate) struct DumpArguments {
    /// The .barchan file
    pub(crate) file: PathBuf,
    /// height, horizon, distance, swept_horizon, swept_distance, sky_visibility, bent_normal, aperture_cone or curvature; may
    /// be left out if the file has one table
    #[arg(value_parser = table)]
    pub(crate) table: Option<Table>,
    #[arg(long, default_value = "text")]
    pub(crate) format: DumpFormat,
    /// Where to write; text and csv go to stdout by default
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) texture: TextureDumpArguments,
    #[command(flatten)]
    pub(crate) curvature: CurvatureDumpArguments,
}

/// What of a texture is dumped.
#[derive(Debug, Args)]
#[command(next_help_heading = "For textures")]
pub(crate) struct TextureDumpArguments {
    /// One layer (direction) only
    #[arg(long, value_name = "N")]
    pub(crate) layer: Option<u32>,
    /// Mip level [default: 0]
    #[arg(long, value_name = "N")]
    pub(crate) mip: Option<u32>,
}

/// What of the curvature of a mesh is dumped.
#[derive(Debug, Args)]
#[command(next_help_heading = "For curvature")]
pub(crate) struct CurvatureDumpArguments {
    /// Which numbers in npy and text: principal, directions, forms, uv_directions or flags [default: principal]
    #[arg(long, value_name = "COLUMN", value_parser = part)]
    pub(crate) column: Option<CurvaturePart>,
    /// The mesh that was baked, which ply colours: a .barchan file holds no geometry
    #[arg(long, value_name = "FILE")]
    pub(crate) mesh: Option<PathBuf>,
    /// What ply colours the mesh by [default: mean]
    #[arg(long, value_name = "CURVATURE")]
    pub(crate) by: Option<ColouredBy>,
}

#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum ColouredBy {
    /// H = (κ1 + κ2) / 2
    #[default]
    Mean,
    /// K = κ1 κ2
    Gaussian,
    /// The greatest curvature
    K1,
    /// The least curvature
    K2,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum DumpFormat {
    /// Rows of numbers for people
    Text,
    /// A line per value
    Csv,
    /// A float32 NumPy array
    Npy,
    /// A picture of 16 bits, in colour for vectors; layers in a contact sheet
    Png,
    /// Float channels, one per layer and number
    Exr,
    /// The mesh in colour, for any viewer; for curvature
    Ply,
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
    /// The difference to accept: degrees for horizons, the length unit for heights and distances, plain numbers for the sky
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

/// A parser of words from a fixed list.
fn word<T: Copy>(text: &str, words: &[(&str, T)]) -> Result<T, String> {
    let found = words.iter().find(|(word, _)| *word == text);
    found.map(|(_, value)| *value).ok_or_else(|| {
        let accepted: Vec<_> = words.iter().map(|(word, _)| *word).collect();
        format!("accepted: {}", accepted.join(", "))
    })
}

fn table(text: &str) -> Result<Table, String> {
    word(text, &Table::ALL.map(|table| (table.name(), table)))
}

fn part(text: &str) -> Result<CurvaturePart, String> {
    word(text, &CurvaturePart::ALL.map(|part| (part.name(), part)))
}

fn edge(text: &str) -> Result<Edge, String> {
    word(text, &[Edge::Wrap, Edge::Clamp].map(|edge| (edge.name(), edge)))
}

fn unit(text: &str) -> Result<LengthUnit, String> {
    let units = [
        ("scene_unit", LengthUnit::SceneUnit),
        ("metre", LengthUnit::Metre),
        ("centimetre", LengthUnit::Centimetre),
        ("millimetre", LengthUnit::Millimetre),
        ("kilometre", LengthUnit::Kilometre),
    ];
    word(text, &units)
}

fn integers(text: &str) -> Result<Integers, String> {
    word(text, &[("normalised", Integers::Normalised), ("raw", Integers::Raw)])
}

fn encoding(text: &str) -> Result<TableEncoding, String> {
    let encodings = [
        ("f32", TableEncoding::F32),
        ("f16", TableEncoding::F16),
        ("u8", TableEncoding::U8),
        ("compact", TableEncoding::Compact),
    ];
    word(text, &encodings)
}

fn method(text: &str) -> Result<MethodName, String> {
    word(text, &MethodName::ALL.map(|method| (method.name(), method)))
}

fn hard_edge(text: &str) -> Result<f64, String> {
    number(text, "0 to 180 degrees", |value| (0.0..=180.0).contains(&value))
}

fn arc(text: &str) -> Result<(f64, f64), String> {
    let accepted = || "accepted: degrees from within ±360 to a larger number, less than 360 beyond".to_owned();
    let (first, last) = text.split_once(',').ok_or_else(accepted)?;
    let (first, last) = (finite(first).map_err(|_| accepted())?, finite(last).map_err(|_| accepted())?);
    let is_arc = first.abs() <= 360.0 && last > first && last - first < 360.0;
    if is_arc { Ok((first, last)) } else { Err(accepted()) }
}

fn compression(text: &str) -> Result<Compression, String> {
    word(text, &[("none", Compression::None), ("zstd", Compression::Zstd)])
}

fn fill(text: &str) -> Result<Fill, String> {
    match text {
        "lowest" => Ok(Fill::Lowest),
        "nearest" => Ok(Fill::Nearest),
        length => finite(length).map(Fill::Value).map_err(|_| "accepted: lowest, nearest or a length".to_owned()),
    }
}

fn jobs(text: &str) -> Result<usize, String> {
    // Beyond that a machine spends its time on starting threads, or fails to.
    text.parse().ok().filter(|&jobs| jobs <= 1024).ok_or_else(|| "accepted: 0 to 1024".to_owned())
}

fn finite(text: &str) -> Result<f64, String> {
    number(text, "a finite number", |value| value.is_finite())
}

fn positive(text: &str) -> Result<f64, String> {
    number(text, "a positive number", |value| value > 0.0 && value.is_finite())
}

fn not_negative(text: &str) -> Result<f64, String> {
    number(text, "a number that is not negative", |value| value >= 0.0 && value.is_finite())
}

fn elevation(text: &str) -> Result<f64, String> {
    number(text, "-90 to 90 degrees", |value| (-90.0..=90.0).contains(&value))
}

fn number(text: &str, accepted: &str, accepts: impl Fn(f64) -> bool) -> Result<f64, String> {
    text.trim().parse().ok().filter(|&value| accepts(value)).ok_or_else(|| format!("accepted: {accepted}"))
}

fn spacing(text: &str) -> Result<Spacing, String> {
    let (u, v) = text.split_once(',').unwrap_or((text, text));
    let length = |text: &str| text.trim().parse().map_err(|_| "accepted: a length, or two with a comma".to_owned());
    Spacing::new(length(u)?, length(v)?).map_err(|error| error.to_string())
}
