//! Where an asset comes from, stored in it as JSON: enough to bake it again and to know how good it is. Nothing in it
//! depends on the machine, the time or a path, so the same input gives the same bytes.

use barchan_bakers::horizon::{self, HorizonParams};
use barchan_bakers::{sky, swept};
use barchan_field::{Edge, LengthUnit};
use barchan_import::{Fill, Integers};
use serde::{Deserialize, Serialize};

use crate::accuracy::HorizonAccuracy;
use crate::mesh_provenance::{CurvatureProvenance, MeshProvenance};
use crate::search_provenance::ReliefSearchProvenance;
use crate::sink::WrittenTable;
use crate::{
    CurvatureRecipe, CurvedRecipe, HemisphereRecipe, HorizonMethod, HorizonRecipe, MeshRange, Recipe, Scene,
    ShapeSource, Table, TableEncoding,
};

/// Names the layout of [`Provenance`] as JSON.
pub const PROVENANCE_SCHEMA: &str = "barchan.provenance/1";

/// The provenance section.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Provenance {
    /// [`PROVENANCE_SCHEMA`].
    pub schema: String,
    /// The program and its version.
    pub generator: String,
    /// The heights that were baked from, if any were.
    pub input: Option<InputProvenance>,
    /// The mesh that was baked from, if any was.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mesh: Option<MeshProvenance>,
    /// The recipe with every default spelled out.
    pub recipe: CanonicalRecipe,
    /// The horizon's baker, if it ran.
    pub horizon: Option<HorizonProvenance>,
    /// The baker of points for curved surfaces, if it ran.
    #[serde(default)]
    pub swept: Option<SweptProvenance>,
    /// The baker of the sky, if it ran.
    #[serde(default)]
    pub sky: Option<SkyProvenance>,
    /// The bakers of tables for relief search, if any ran.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub relief_search: Option<ReliefSearchProvenance>,
    /// The baker of curvature, if it ran.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub curvature: Option<CurvatureProvenance>,
    /// What storing cost each table.
    #[serde(default)]
    pub encodings: Vec<EncodingProvenance>,
}

impl Provenance {
    /// What is known before anything was baked.
    pub(crate) fn of_recipe(recipe: &Recipe, tables: &[Table]) -> Self {
        Self {
            schema: PROVENANCE_SCHEMA.to_owned(),
            generator: concat!("barchan ", env!("CARGO_PKG_VERSION")).to_owned(),
            input: None,
            mesh: None,
            recipe: CanonicalRecipe::new(recipe, tables),
            horizon: None,
            swept: None,
            sky: None,
            relief_search: None,
            curvature: None,
            encodings: Vec::new(),
        }
    }
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
///
/// What came later is `None` in older files.
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
    /// How many points were asked for on curved surfaces, and how they are stored.
    #[serde(default)]
    pub curved: Option<CurvedRecipe>,
    /// How sky visibility, bent normal and aperture cone are stored.
    #[serde(default)]
    pub sky_encoding: Option<TableEncoding>,
    /// The hemisphere table, where it was baked.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hemisphere: Option<HemisphereRecipe>,
    /// How cone maps are stored, where one was baked.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cone_map_encoding: Option<TableEncoding>,
    /// How the maximum mip is stored, where it was baked.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub maximum_mip_encoding: Option<TableEncoding>,
    /// How curvature was found and is stored, where there is a mesh.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub curvature: Option<CurvatureRecipe>,
}

impl CanonicalRecipe {
    pub(crate) fn new(recipe: &Recipe, tables: &[Table]) -> Self {
        let has_cones = tables.contains(&Table::ConeMap) || tables.contains(&Table::RelaxedConeMap);
        Self {
            spacing: (recipe.spacing.u(), recipe.spacing.v()),
            unit: recipe.height_unit(),
            edge: recipe.edge,
            scene: recipe.scene,
            tables: tables.iter().map(|table| table.name().to_owned()).collect(),
            height_encoding: recipe.height.encoding,
            horizon_encoding: recipe.horizon.encoding,
            distance_encoding: recipe.distance.encoding,
            curved: Some(recipe.curved),
            sky_encoding: Some(recipe.sky.encoding),
            hemisphere: tables.contains(&Table::Hemisphere).then_some(recipe.hemisphere),
            cone_map_encoding: has_cones.then_some(recipe.cone_map.encoding),
            maximum_mip_encoding: tables.contains(&Table::MaximumMip).then_some(recipe.maximum_mip.encoding),
            curvature: recipe.mesh.is_some().then_some(recipe.curvature),
        }
    }
}

/// What baked the horizon, with what, and how exactly.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct HorizonProvenance {
    /// Changes when the same input gives other bytes.
    pub algorithm: String,
    /// How exactly; `None` in older files.
    #[serde(default)]
    pub method: Option<HorizonMethod>,
    /// Azimuths.
    pub directions: u32,
    /// The first and the last azimuth in degrees; `None` all the way round.
    #[serde(default)]
    pub arc: Option<(f64, f64)>,
    /// Search radius in the length unit.
    pub radius: f64,
    /// Measured error; `null` if no horizon table was stored.
    pub accuracy: Option<HorizonAccuracy>,
}

impl HorizonProvenance {
    pub(crate) fn new(recipe: &HorizonRecipe, params: &HorizonParams, accuracy: Option<HorizonAccuracy>) -> Self {
        Self {
            algorithm: horizon::ALGORITHM.to_owned(),
            method: Some(recipe.method),
            directions: params.directions(),
            arc: recipe.arc,
            radius: params.radius,
            accuracy,
        }
    }
}

/// What baked the points for curved surfaces.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SweptProvenance {
    /// Changes when the same input gives other bytes.
    pub algorithm: String,
    /// Points per texel and azimuth, that of the flat horizon among them.
    pub points: u32,
    /// The range of curvatures, where it was taken from the mesh.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub on_mesh: Option<MeshRange>,
}

impl SweptProvenance {
    pub(crate) fn new(points: u32, on_mesh: Option<MeshRange>) -> Self {
        Self { algorithm: swept::ALGORITHM.to_owned(), points, on_mesh }
    }
}

/// What baked the tables of the sky.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SkyProvenance {
    /// Changes when the same input gives other bytes.
    pub algorithm: String,
}

impl SkyProvenance {
    pub(crate) fn new() -> Self {
        Self { algorithm: sky::ALGORITHM.to_owned() }
    }
}

/// What storing cost a table: decoded, by the arithmetic of a shader, minus baked, over every value of it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct EncodingProvenance {
    /// The table.
    pub table: String,
    /// How a texel is stored.
    pub format: String,
    /// The symbol of the unit of the errors; empty for plain numbers.
    pub unit: String,
    /// RMS error.
    pub rms: f64,
    /// The largest error.
    pub max: f64,
}

impl EncodingProvenance {
    pub(crate) fn new(written: &WrittenTable) -> Self {
        let WrittenTable { table, descriptor, loss } = written;
        Self {
            table: table.name().to_owned(),
            format: descriptor.format.name().to_owned(),
            unit: descriptor.unit.symbol().to_owned(),
            rms: loss.rms,
            max: loss.max,
        }
    }
}
