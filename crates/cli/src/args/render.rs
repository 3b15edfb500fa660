//! What `barchan render` takes.

use std::path::PathBuf;

use clap::{ArgGroup, Args, ValueEnum};

use super::words::{above_horizon, elevation, finite};

#[derive(Debug, Args)]
#[command(after_help = "Examples:
  barchan render dunes.barchan -o dunes.png
  barchan render dunes.barchan --azimuth 135 --elevation 10 --compare -o check.png
  barchan render dunes.barchan --ambient -o overcast.png
  barchan render relief.barchan --eye-elevation 35 --azimuth 200 -o relief.png
  barchan render relief.barchan --eye-elevation 35 --heat -o fetches.png
  barchan render relief.barchan --eye-azimuth 20 --search linear --start top --compare -o check.png
  barchan render relief.barchan --eye-azimuth 0 --on sphere --tiles 8 -o ball.png
  barchan render dunes.barchan --gpu -o dunes.png
  barchan render relief.barchan --eye-elevation 35 --gpu --compare -o check.png")]
pub(crate) struct RenderArguments {
    /// The .barchan file; it needs the height table, and that of the horizon or, with --ambient, of the sky. Seen from a side it needs
    /// the tables of its search
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
    #[arg(conflicts_with = "eye")]
    pub(crate) scale: u32,
    /// Put what is ray-traced and the difference beside it: red is too dark, blue too light. With --gpu, put the picture of the CPU, that
    /// of the GPU and their difference side by side
    #[arg(long)]
    pub(crate) compare: bool,
    /// Light it by an overcast sky instead of a sun; the file needs sky_visibility, and uses bent_normal. Seen from a side it needs
    /// hemisphere
    #[arg(long, conflicts_with_all = ["azimuth", "elevation"])]
    pub(crate) ambient: bool,
    /// Draw it by the GPU, real or software, through the composed shaders; the program must be built with the feature `gpu`
    #[arg(long)]
    pub(crate) gpu: bool,
    #[command(flatten)]
    pub(crate) view: ReliefViewArguments,
}

/// Relief seen from a side, by relief rays.
#[derive(Debug, Args)]
#[command(next_help_heading = "Relief mapping, drawn where an eye is given")]
#[command(group = ArgGroup::new("eye").args(["eye_azimuth", "eye_elevation"]).multiple(true))]
pub(crate) struct ReliefViewArguments {
    /// Where the eye stands, in degrees counter-clockwise from +u; 270, below the picture, where only its elevation is given
    #[arg(long, value_name = "DEGREES", allow_hyphen_values = true, value_parser = finite)]
    pub(crate) eye_azimuth: Option<f64>,
    /// How high it stands, in degrees above the base plane; 35 where only its azimuth is given
    #[arg(long, value_name = "DEGREES", allow_hyphen_values = true, value_parser = above_horizon)]
    pub(crate) eye_elevation: Option<f64>,
    /// What the relief lies on
    #[arg(long, value_name = "BASE", default_value = "plane", requires = "eye")]
    pub(crate) on: BaseName,
    /// How many tiles are seen side by side, or go round the sphere; a clamped tile is seen once
    #[arg(long, value_name = "N", requires = "eye", value_parser = clap::value_parser!(u32).range(1..=64))]
    pub(crate) tiles: Option<u32>,
    /// Pixels of the longer side of a picture
    #[arg(long, value_name = "PIXELS", default_value_t = 640, requires = "eye")]
    #[arg(value_parser = clap::value_parser!(u32).range(16..=2048))]
    pub(crate) size: u32,
    /// What finds the hit of a ray: maximum_mip, cone_steps, relaxed_cone_steps, linear, parallax_occlusion [default: the first of
    /// these that the file has the table for]
    #[arg(long, value_name = "SEARCH", requires = "eye", hide_possible_values = true)]
    pub(crate) search: Option<SearchName>,
    /// Where rays start: depth_map, top [default: depth_map if the file has the hemisphere table]
    #[arg(long, value_name = "START", requires = "eye", hide_possible_values = true)]
    pub(crate) start: Option<StartName>,
    /// Draw how often every pixel reads a table instead: linear search of 64 steps at the left, the chosen one at the right
    #[arg(long, requires = "eye", conflicts_with_all = ["azimuth", "elevation", "compare", "ambient", "gpu"])]
    pub(crate) heat: bool,
}

impl ReliefViewArguments {
    /// The azimuth and the elevation of the eye, in degrees, if one is asked for.
    pub(crate) fn eye(&self) -> Option<(f64, f64)> {
        let asked = self.eye_azimuth.is_some() || self.eye_elevation.is_some();
        asked.then(|| (self.eye_azimuth.unwrap_or(270.0), self.eye_elevation.unwrap_or(35.0)))
    }
}

/// What relief lies on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum BaseName {
    /// A plane
    Plane,
    /// A sphere, the tile round its equator
    Sphere,
}

/// What finds the hit of a relief ray, best first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
#[value(rename_all = "snake_case")]
pub(crate) enum SearchName {
    /// Traversal of a maximum mip
    MaximumMip,
    /// Cone steps that end in an exact hit
    ConeSteps,
    /// Relaxed cone steps and a bisection
    RelaxedConeSteps,
    /// 64 steps and a bisection
    Linear,
    /// 64 steps and a secant
    ParallaxOcclusion,
}

/// Where relief rays start.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
#[value(rename_all = "snake_case")]
pub(crate) enum StartName {
    /// Where the hemisphere table says
    DepthMap,
    /// At the top plane
    Top,
}
