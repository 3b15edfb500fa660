//! What may be typed after `barchan dump`.

use std::path::PathBuf;

use barchan_pipeline::{CurvaturePart, Table};
use clap::{Args, ValueEnum};

use super::words::{part, table};

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
