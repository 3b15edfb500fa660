//! What may be typed after `barchan bake`.

use std::path::PathBuf;

use barchan_field::{Edge, LengthUnit, Spacing};
use barchan_import::{Fill, Integers};
use barchan_pipeline::{Compression, CurvatureMethod, HemisphereMode, HorizonMethod, Table, TableEncoding};
use clap::Args;

use super::words::{
    arc, compression, depth_mode, edge, encoding, fill, finite, hard_edge, integers, jobs, method, positive, size,
    spacing, table, unit,
};

#[derive(Debug, Args)]
#[command(after_help = "Examples:
  barchan bake samples/dunes.ron
  barchan bake rock.obj
  barchan bake statue.ply --method fast --encoding f32 -o statue.barchan
  barchan bake rock.png --height-scale 12 --edge wrap --method exact --encoding f16 -o rock.barchan
  barchan bake rock.png --height-scale 12 --arc 180,360 --directions 17
  barchan bake rock.png --height-scale 12 --only height,hemisphere,cone_map --rings 16 --size 32
  barchan bake elevation.tif --integers raw --spacing 74,93 --unit metre --radius 20000 --json")]
pub(crate) struct BakeArguments {
    /// Where to write [default: the input's name with .barchan, in this folder]
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// Worker threads, at most 1024; 0 is one per core
    #[arg(short = 'j', long, value_name = "N", default_value_t = 0, value_parser = jobs)]
    pub(crate) jobs: usize,
    #[command(flatten)]
    pub(crate) wanted: WantedArguments,
}

/// What is to be baked, of a recipe or of a bare file.
#[derive(Debug, Args)]
pub(crate) struct WantedArguments {
    /// A recipe (.ron), a height map (PNG, EXR, TIFF, NPY) or a mesh (OBJ, PLY, glTF)
    pub(crate) input: PathBuf,
    /// Bake these tables and no others: height, horizon, distance, swept_horizon, swept_distance, sky_visibility,
    /// bent_normal, aperture_cone, hemisphere, cone_map, relaxed_cone_map, maximum_mip; of a mesh: curvature
    #[arg(long, value_name = "TABLE,..", value_delimiter = ',', value_parser = table)]
    pub(crate) only: Option<Vec<Table>>,
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
    /// Rings of directions around the normal in the hemisphere table; the last ends at 80° [default: 32]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=i64::from(barchan_asset::MAX_LAYERS)))]
    pub(crate) rings: Option<u32>,
    /// Azimuths of each ring in the hemisphere table [default: 16]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=i64::from(barchan_asset::MAX_LAYERS)))]
    pub(crate) azimuths: Option<u32>,
    /// Texels of the hemisphere table, along u and along v [default: 64, or as many as the map has]
    #[arg(long, value_name = "N[,N]", value_parser = size)]
    pub(crate) size: Option<(u32, u32)>,
    /// What the hemisphere table holds: conservative, depths before which no ray hits, or nearest, the depth that one ray hits at
    /// [default: conservative]
    #[arg(long, value_name = "MODE", value_parser = depth_mode)]
    pub(crate) depth_mode: Option<HemisphereMode>,
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
    pub(super) const ALL: [Self; 4] = [Self::Sweep, Self::Fast, Self::Accurate, Self::Exact];

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
