//! What a recipe says of the tables that are baked from heights, but for those of relief mapping: heights, horizons, distances and the sky.

use barchan_asset::Encoding;
use barchan_bakers::horizon::{Azimuths, Method};
use barchan_bakers::swept::{CurvatureRange, Points, SweptParams};
use serde::{Deserialize, Serialize};

use crate::pair;

/// The height table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct HeightRecipe {
    /// How it is stored.
    pub encoding: TableEncoding,
}

impl Default for HeightRecipe {
    /// Half floats: bytes cut most relief into visible steps.
    fn default() -> Self {
        Self { encoding: TableEncoding::F16 }
    }
}

/// The horizon table.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct HorizonRecipe {
    /// Azimuths: evenly spaced from +u, counter-clockwise, or over the arc, both its ends included.
    pub directions: u32,
    /// The first and the last azimuth in degrees, counter-clockwise from +u, where a light never comes from elsewhere; `None`
    /// goes all the way round.
    #[serde(deserialize_with = "pair::optional")]
    pub arc: Option<(f64, f64)>,
    /// How far to look, in the length unit; `None` takes what the edge policy suggests.
    pub radius: Option<f64>,
    /// How exactly, at what speed.
    pub method: HorizonMethod,
    /// How it is stored.
    pub encoding: TableEncoding,
}

impl HorizonRecipe {
    /// Azimuths where none are asked for: every 11.25°.
    pub const DEFAULT_DIRECTIONS: u32 = 32;

    /// The azimuths in the baker's words.
    #[must_use]
    pub fn azimuths(&self) -> Azimuths {
        match self.arc {
            None => Azimuths::full_circle(self.directions),
            Some((first_degrees, last_degrees)) => {
                Azimuths::Arc { first_degrees, last_degrees, count: self.directions }
            }
        }
    }
}

impl Default for HorizonRecipe {
    fn default() -> Self {
        Self {
            directions: Self::DEFAULT_DIRECTIONS,
            arc: None,
            radius: None,
            method: HorizonMethod::default(),
            encoding: TableEncoding::default(),
        }
    }
}

/// `sweep`, `accurate` or `exact`, as recipes and flags spell it.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum HorizonMethod {
    /// The fastest, for previews.
    Sweep,
    /// What the eye cannot tell from exact.
    #[default]
    Accurate,
    /// The reference's horizon, but for the rounding of f32.
    Exact,
}

impl HorizonMethod {
    /// `sweep`, `accurate` or `exact`.
    #[must_use]
    pub fn name(self) -> &'static str {
        Method::from(self).name()
    }
}

impl From<HorizonMethod> for Method {
    fn from(method: HorizonMethod) -> Self {
        match method {
            HorizonMethod::Sweep => Self::Sweep,
            HorizonMethod::Accurate => Self::Accurate,
            HorizonMethod::Exact => Self::Exact,
        }
    }
}

/// The distance table. It has the horizon's azimuths and radius.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct DistanceRecipe {
    /// How it is stored.
    pub encoding: TableEncoding,
}

/// The swept tables. They have the horizon's azimuths and radius.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct CurvedRecipe {
    /// Points per texel and azimuth, that of the flat horizon among them; `None` takes as few as keep the error.
    pub points: Option<u32>,
    /// The error of the angle that 99 of 100 texels and azimuths must keep at the worst curvature, in degrees, where
    /// the number of points is not given.
    pub max_error_degrees: Option<f64>,
    /// How they are stored.
    pub encoding: TableEncoding,
}

impl CurvedRecipe {
    /// The error kept where nobody asks for another, in degrees: a sun's diameter.
    pub const DEFAULT_MAX_ERROR_DEGREES: f64 = 0.5;

    /// What to bake over a range of curvatures, in the baker's words.
    #[must_use]
    pub fn params(&self, (min, max): (f64, f64)) -> SweptParams {
        let error = self.max_error_degrees.unwrap_or(Self::DEFAULT_MAX_ERROR_DEGREES);
        let points = self.points.map_or(Points::MaxErrorDegrees(error), Points::Count);
        SweptParams { range: CurvatureRange { min, max }, points }
    }
}

/// Sky visibility, bent normal and aperture cone. They are summed over the horizon's azimuths.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct SkyRecipe {
    /// How they are stored.
    pub encoding: TableEncoding,
}

/// `f32`, `f16`, `u8` or `compact`, as recipes and flags spell it.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum TableEncoding {
    /// As baked; not filterable on every GPU.
    F32,
    /// Half floats over the table's range.
    F16,
    /// Bytes over the table's range.
    U8,
    /// What suits the table: bytes of the sine of an elevation, of the root of a distance, of a share of the sky; half
    /// floats of a height.
    #[default]
    Compact,
}

impl From<TableEncoding> for Encoding {
    fn from(encoding: TableEncoding) -> Self {
        match encoding {
            TableEncoding::F32 => Self::F32,
            TableEncoding::F16 => Self::F16,
            TableEncoding::U8 => Self::U8,
            TableEncoding::Compact => Self::Compact,
        }
    }
}
