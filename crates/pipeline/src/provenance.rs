//! Where an asset comes from, stored in it as JSON: enough to bake it again and to know how good it is. Nothing in it
//! depends on the machine, the time or a path, so the same input gives the same bytes.

use barchan_bakers::horizon::ALGORITHM;
use barchan_field::{Edge, LengthUnit};
use barchan_import::{Fill, Integers};
use serde::{Deserialize, Serialize};

use crate::accuracy::HorizonAccuracy;
use crate::{Recipe, Scene, ShapeSource, TableEncoding};

/// Names the layout of [`Provenance`] as JSON.
pub const PROVENANCE_SCHEMA: &str = "barchan.provenance/1";

/// The provenance section.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Provenance {
    /// [`PROVENANCE_SCHEMA`].
    pub schema: String,
    /// The program and its version.
    pub generator: String,
    /// What was baked from.
    pub input: InputProvenance,
    /// The recipe with every default spelled out.
    pub recipe: CanonicalRecipe,
    /// The horizon's baker, if it ran.
    pub horizon: Option<HorizonProvenance>,
}

/// What was baked from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum InputProvenance {
    /// A file, by the BLAKE3 of its bytes, in hexadecimal.
    HeightMap {
        /// The digest.
        blake3: String,
        /// File format and sample type.
        format: String,
        /// The channel that was named, if one was.
        channel: Option<String>,
        /// What a whole number in the file means.
        integers: Integers,
        /// Height of a sample of 1.
        height_scale: f64,
        /// Height of a sample of 0.
        height_offset: f64,
        /// The raw sample that stands for no data, if one was named.
        no_data: Option<f64>,
        /// What stands in for texels without a height.
        fill: Option<Fill>,
        /// Texels whose height a fill rule made up.
        filled_texels: u64,
    },
    /// A closed form, its parameters and extent.
    Shape(ShapeSource),
}

/// The settings that shaped the tables. How sections are packed is not among them: it does not change the content.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CanonicalRecipe {
    /// Length per texel along u and v.
    pub spacing: (f64, f64),
    /// The unit of lengths.
    pub unit: LengthUnit,
    /// What lies beyond the edge.
    pub edge: Edge,
    /// What the scene does, if anyone said.
    pub scene: Option<Scene>,
    /// The tables baked.
    pub tables: Vec<String>,
    /// How heights are stored.
    pub height_encoding: TableEncoding,
    /// How the horizon is stored.
    pub horizon_encoding: TableEncoding,
    /// How distances are stored.
    pub distance_encoding: TableEncoding,
}

impl CanonicalRecipe {
    pub(crate) fn new(recipe: &Recipe, tables: Vec<String>) -> Self {
        Self {
            spacing: (recipe.spacing.u(), recipe.spacing.v()),
            unit: recipe.unit,
            edge: recipe.edge,
            scene: recipe.scene,
            tables,
            height_encoding: recipe.height.encoding,
            horizon_encoding: recipe.horizon.encoding,
            distance_encoding: recipe.distance.encoding,
        }
    }
}

/// What baked the horizon, with what, and how exactly.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct HorizonProvenance {
    /// Changes when the same input gives other bytes.
    pub algorithm: String,
    /// Azimuths.
    pub directions: u32,
    /// Search radius in the length unit.
    pub radius: f64,
    /// Measured error; `null` if no horizon table was stored.
    pub accuracy: Option<HorizonAccuracy>,
}

impl HorizonProvenance {
    pub(crate) fn new(directions: u32, radius: f64, accuracy: Option<HorizonAccuracy>) -> Self {
        Self { algorithm: ALGORITHM.to_owned(), directions, radius, accuracy }
    }
}
