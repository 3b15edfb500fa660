//! What may be typed after `barchan dump`.

use std::path::PathBuf;

use barchan_pipeline::{CurvaturePart, Table};
use clap::{Args, ValueEnum};

use super::words::{part, table, view};

#[derive(Debug, Args)]
#[command(
    after_help = "Values: heights and distances in the length unit, horizons as the slope (tangent of the elevation) \
in npy, as degrees in text, as both in csv, as radians in exr, over the table's range in png; sky visibility from 0 to 1; bent \
normal and aperture cone as u, v, height and cosine of the half-angle, in png as red, green, blue and alpha; depths from 0 at the \
top of the relief to 1 at its bottom, with ratios of cones in png as red and green; curvatures in 1 / length unit, positive \
where convex, in ply and png as a colour from blue (concave) over white to red (convex).

Examples:
  barchan dump dunes.barchan horizon --format npy -o horizon.npy     float32 [directions, height, width]
  barchan dump dunes.barchan height --format exr -o height.exr
  barchan dump dunes.barchan horizon --layer 4 --format png -o east.png
  barchan dump dunes.barchan height --format csv | head
  barchan dump rock.barchan hemisphere --format npy -o depths.npy    float32 [rings, azimuths, height, width]
  barchan dump rock.barchan maximum_mip --mip 3 --format text
  barchan dump rock.barchan curvature --format npy -o rock.npy       float32 [vertices, 2]
  barchan dump rock.barchan curvature --format ply --mesh rock.obj -o coloured.ply
  barchan dump rock.barchan curvature --format png --mesh rock.obj --view -30,15 -o rock.png"
)]
pub(crate) struct DumpArguments {
    /// The .barchan file
    pub(crate) file: PathBuf,
    /// height, horizon, distance, swept_horizon, swept_distance, sky_visibility, bent_normal, aperture_cone, hemisphere, cone_map,
    /// relaxed_cone_map, maximum_mip or curvature; may be left out if the file has one table
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
    /// One layer only: a direction, or of a hemisphere table ring × azimuths + azimuth
    #[arg(long, value_name = "N")]
    pub(crate) layer: Option<u32>,
    /// Level of a maximum mip [default: 0]
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
    /// The mesh that was baked, which ply and png colour: a .barchan file holds no geometry
    #[arg(long, value_name = "FILE")]
    pub(crate) mesh: Option<PathBuf>,
    /// What ply and png colour the mesh by [default: mean]
    #[arg(long, value_name = "CURVATURE")]
    pub(crate) by: Option<ColouredBy>,
    #[command(flatten)]
    pub(crate) picture: MeshPictureArguments,
}

/// How the picture of a mesh is drawn.
#[derive(Debug, Args)]
#[command(next_help_heading = "For curvature in png")]
pub(crate) struct MeshPictureArguments {
    /// From where the mesh is seen, in degrees: counter-clockwise from above, from +z where y is up and from +x where z is,
    /// and above the horizon [default: 30,25]
    #[arg(long, value_name = "AZIMUTH,ELEVATION", allow_hyphen_values = true, value_parser = view)]
    pub(crate) view: Option<(f64, f64)>,
    /// The axis that points up [default: y for the mesh of a file, z for the surface of a recipe]
    #[arg(long, value_name = "AXIS")]
    pub(crate) up: Option<UpAxisName>,
    /// Pixels of the longer side [default: 800]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=i64::from(barchan_shade::MAX_MESH_PICTURE)))]
    pub(crate) size: Option<u32>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum UpAxisName {
    /// As in glTF
    Y,
    /// As on maps
    Z,
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
    /// A picture of 16 bits, in colour for vectors; layers in a contact sheet; for curvature the mesh in colour
    Png,
    /// Float channels, one per layer and number
    Exr,
    /// The mesh in colour, for any viewer; for curvature
    Ply,
}
