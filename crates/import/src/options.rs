//! What the caller decides.

use barchan_field::{Edge, LengthUnit, Spacing};
use serde::{Deserialize, Serialize};

use crate::DecodeError;

/// What turns the samples of a file into a height field.
#[derive(Debug, Clone, PartialEq)]
pub struct HeightMapOptions {
    /// What a whole number in the file means.
    pub integers: Integers,
    /// Height of a sample of 1.
    pub height_scale: f64,
    /// Height of a sample of 0.
    pub height_offset: f64,
    /// Length per texel.
    pub spacing: Spacing,
    /// What heights and spacings are measured in.
    pub unit: LengthUnit,
    /// What lies beyond the edge; also whether [`Fill::Nearest`] looks across it.
    pub edge: Edge,
    /// The channel to read; `None` chooses as the crate's documentation says.
    pub channel: Option<String>,
    /// A raw sample value that stands for "no height here", besides the one the file may declare itself.
    pub no_data: Option<f64>,
    /// The height of texels that have none; `None` refuses them.
    pub fill: Option<Fill>,
    /// The most texels to accept.
    pub max_texels: u64,
}

impl Default for HeightMapOptions {
    /// Samples are heights, in the scene's unit, one texel per unit, clamped at the edge; nothing is filled; 2³⁰ texels.
    fn default() -> Self {
        Self {
            integers: Integers::default(),
            height_scale: 1.0,
            height_offset: 0.0,
            spacing: Spacing::UNIT,
            unit: LengthUnit::SceneUnit,
            edge: Edge::Clamp,
            channel: None,
            no_data: None,
            fill: None,
            max_texels: 1 << 30,
        }
    }
}

/// What a whole number in a file means. Float samples are always taken as they are.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Integers {
    /// A share of the largest value of its type, as in displacement maps: full scale is 1.
    #[default]
    Normalised,
    /// Itself, as in elevation models in whole metres.
    Raw,
}

/// The height of texels that have none. In a recipe: `value(0.0)`, `lowest` or `nearest`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Fill {
    /// This height, after scale and offset.
    Value(f64),
    /// The lowest height in the map.
    Lowest,
    /// The height of the texel the fewest steps away along rows and columns; of several, the first in row order.
    Nearest,
}

impl HeightMapOptions {
    /// Refuses what no file can make up for.
    ///
    /// # Errors
    /// The first such option, its value, and what would be accepted.
    pub fn check(&self) -> Result<(), DecodeError> {
        let accepted = "a finite number";
        for (field, value) in [("height_scale", self.height_scale), ("height_offset", self.height_offset)] {
            if !value.is_finite() {
                return Err(DecodeError::Option { field, value, accepted });
            }
        }
        match self.fill {
            Some(Fill::Value(value)) if !(value as f32).is_finite() => {
                Err(DecodeError::Option { field: "fill", value, accepted: "a height within the range of f32" })
            }
            _ => Ok(()),
        }
    }
}
