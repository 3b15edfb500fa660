//! What a recipe says of the tables for relief mapping.

use barchan_asset::{DepthMode, RingSpacing};
use serde::{Deserialize, Serialize};

use crate::{TableEncoding, pair};

/// The hemisphere table: where rays from a grid of directions first hit the relief.
///
/// Its rings end where [`crate::ReliefMapping`] says that no eye and no light stands lower, and its azimuths cover the arc said there.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct HemisphereRecipe {
    /// Rings around the normal.
    pub rings: u32,
    /// Azimuths of each ring: evenly spaced from +u, counter-clockwise, or over the arc, both its ends included.
    pub azimuths: u32,
    /// How the polar angle is cut into rings.
    pub spacing: HemisphereSpacing,
    /// Texels along u and v, at most as many as the heights have; `None` takes 64, or as many as there are.
    #[serde(deserialize_with = "pair::optional")]
    pub size: Option<(u32, u32)>,
    /// What a depth says of the rays of its cell.
    pub mode: HemisphereMode,
    /// How it is stored.
    pub encoding: TableEncoding,
}

impl HemisphereRecipe {
    /// Rings and azimuths where none are asked for.
    pub const DEFAULT_RINGS: u32 = 32;
    /// Azimuths of each ring where none are asked for: every 22.5°.
    pub const DEFAULT_AZIMUTHS: u32 = 16;
    /// Texels along either side where none are asked for and the heights have as many.
    pub const DEFAULT_SIZE: u32 = 64;

    /// Texels along u and v for heights of a width and a height.
    #[must_use]
    pub fn size_for(&self, width: u32, height: u32) -> (u32, u32) {
        self.size.unwrap_or((width.min(Self::DEFAULT_SIZE), height.min(Self::DEFAULT_SIZE)))
    }
}

impl Default for HemisphereRecipe {
    fn default() -> Self {
        Self {
            rings: Self::DEFAULT_RINGS,
            azimuths: Self::DEFAULT_AZIMUTHS,
            spacing: HemisphereSpacing::default(),
            size: None,
            mode: HemisphereMode::default(),
            encoding: TableEncoding::default(),
        }
    }
}

/// `squared_tangents` or `equal_angles`, as recipes spell it.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum HemisphereSpacing {
    /// Narrow rings around the normal: starts nearer the surface, and a ring found without an arccosine.
    #[default]
    SquaredTangents,
    /// Rings as wide as each other.
    EqualAngles,
}

impl HemisphereSpacing {
    /// `squared_tangents` or `equal_angles`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::SquaredTangents => "squared_tangents",
            Self::EqualAngles => "equal_angles",
        }
    }
}

impl From<HemisphereSpacing> for RingSpacing {
    fn from(spacing: HemisphereSpacing) -> Self {
        match spacing {
            HemisphereSpacing::SquaredTangents => Self::SquaredTangents,
            HemisphereSpacing::EqualAngles => Self::EqualAngles,
        }
    }
}

/// `conservative` or `nearest`, as recipes and flags spell it.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum HemisphereMode {
    /// No ray of the cell hits earlier.
    #[default]
    Conservative,
    /// The ray in the middle of the cell's azimuths, on the edge nearest the normal: other rays may hit earlier.
    Nearest,
}

impl HemisphereMode {
    /// `conservative` or `nearest`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Conservative => "conservative",
            Self::Nearest => "nearest",
        }
    }
}

impl From<HemisphereMode> for DepthMode {
    fn from(mode: HemisphereMode) -> Self {
        match mode {
            HemisphereMode::Conservative => Self::Conservative,
            HemisphereMode::Nearest => Self::Nearest,
        }
    }
}

/// The cone map, relaxed or not: how far a ray above a texel may step.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct ConeMapRecipe {
    /// How it is stored.
    pub encoding: TableEncoding,
}

/// The maximum mip: the greatest heights of ever larger squares.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct MaximumMipRecipe {
    /// How it is stored.
    pub encoding: TableEncoding,
}
