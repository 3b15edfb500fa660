//! What a person writes: a RON file that says where the relief and the mesh come from, what the scene does with them, and how
//! to store the tables. `samples/dunes.ron` shows every field that is for relief.

use std::path::PathBuf;

use barchan_field::{Edge, FieldError, LengthUnit, Shape, Spacing};
use barchan_import::{Fill, Integers};
use ron::extensions::Extensions;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_path_to_error::{Path, Segment};
use thiserror::Error;

use crate::mesh_recipe::{CurvatureRecipe, MeshSource};
use crate::relief_recipe::{CurvedRecipe, DistanceRecipe, HeightRecipe, HorizonRecipe, SkyRecipe};
use crate::scene::Scene;
use crate::search_recipe::{ConeMapRecipe, HemisphereRecipe, MaximumMipRecipe};
use crate::spacing::SpacingText;
use crate::syntax;

/// A recipe, with every default filled in.
#[derive(Debug, Clone, PartialEq)]
pub struct Recipe {
    /// Where the heights come from. A parsed recipe has this, [`Self::mesh`] or both.
    pub source: Option<Source>,
    /// Where the mesh comes from.
    pub mesh: Option<MeshSource>,
    /// Length per texel.
    pub spacing: Spacing,
    /// The unit of heights, spacing and radius, and of the mesh; `None` is the scene's own, but for a mesh alone what its format
    /// says.
    pub unit: Option<LengthUnit>,
    /// What lies beyond the edge.
    pub edge: Edge,
    /// What the scene does with the tables; `None` when nobody said, so that nothing may be left out.
    pub scene: Option<Scene>,
    /// The height table.
    pub height: HeightRecipe,
    /// The horizon table.
    pub horizon: HorizonRecipe,
    /// The distance table.
    pub distance: DistanceRecipe,
    /// The swept tables, which follow the horizon over a range of curvatures.
    pub curved: CurvedRecipe,
    /// Sky visibility, bent normal and aperture cone.
    pub sky: SkyRecipe,
    /// Where rays first hit the relief.
    pub hemisphere: HemisphereRecipe,
    /// Cone map and relaxed cone map.
    pub cone_map: ConeMapRecipe,
    /// The maximum mip.
    pub maximum_mip: MaximumMipRecipe,
    /// The curvature of the mesh.
    pub curvature: CurvatureRecipe,
    /// How sections are packed.
    pub compression: Compression,
}

/// Where the heights come from.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub enum Source {
    /// A height map on disk.
    HeightMap(HeightMapSource),
    /// A closed form.
    Shape(ShapeSource),
}

/// A height map on disk and how its samples become heights.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HeightMapSource {
    /// The file; relative paths start at the recipe's folder.
    pub path: PathBuf,
    /// What a whole number in the file means: `normalised`, so that full scale is 1, or `raw`.
    #[serde(default)]
    pub integers: Integers,
    /// Height of a sample of 1: of white, if integers are normalised.
    #[serde(default = "one")]
    pub height_scale: f64,
    /// Height of a sample of 0.
    #[serde(default)]
    pub height_offset: f64,
    /// The channel that holds the height, if the file leaves a choice.
    #[serde(default)]
    pub channel: Option<String>,
    /// The raw sample that stands for no data.
    #[serde(default)]
    pub no_data: Option<f64>,
    /// What stands in for texels without a height.
    #[serde(default)]
    pub fill: Option<Fill>,
}

fn one() -> f64 {
    1.0
}

impl HeightMapSource {
    /// A file, its samples taken with a height scale and nothing else said.
    #[must_use]
    pub fn new(path: PathBuf, height_scale: f64) -> Self {
        Self {
            path,
            integers: Integers::default(),
            height_scale,
            height_offset: 0.0,
            channel: None,
            no_data: None,
            fill: None,
        }
    }
}

/// A closed form, sampled.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ShapeSource {
    /// The form and its parameters.
    pub shape: Shape,
    /// Texels along u.
    pub width: u32,
    /// Texels along v.
    pub height: u32,
}

/// How sections are packed in the file.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Compression {
    /// Ready to upload from a mapped file.
    #[default]
    None,
    /// Smaller on disk; decoded when read.
    Zstd,
}

/// The recipe as written, before anything is checked.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename = "Recipe")]
struct RecipeText {
    #[serde(default)]
    source: Option<Source>,
    #[serde(default)]
    mesh: Option<MeshSource>,
    #[serde(default)]
    spacing: SpacingText,
    #[serde(default)]
    unit: Option<LengthUnit>,
    #[serde(default = "clamp")]
    edge: Edge,
    #[serde(default)]
    scene: Option<Scene>,
    #[serde(default)]
    height: HeightRecipe,
    #[serde(default)]
    horizon: HorizonRecipe,
    #[serde(default)]
    distance: DistanceRecipe,
    #[serde(default)]
    curved: CurvedRecipe,
    #[serde(default)]
    sky: SkyRecipe,
    #[serde(default)]
    hemisphere: HemisphereRecipe,
    #[serde(default)]
    cone_map: ConeMapRecipe,
    #[serde(default)]
    maximum_mip: MaximumMipRecipe,
    #[serde(default)]
    curvature: CurvatureRecipe,
    #[serde(default)]
    compression: Compression,
}

fn clamp() -> Edge {
    Edge::Clamp
}

/// Why a text is not a recipe. The caller knows the file's name and puts it in front.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum RecipeError {
    /// Not RON, or not these fields.
    #[error("line {line}, column {column}: {reason}")]
    Syntax {
        /// Counted from 1.
        line: usize,
        /// Counted from 1.
        column: usize,
        /// What was found and what would be accepted.
        reason: String,
    },
    /// Nothing to bake from.
    #[error(
        "neither `source` nor `mesh` is there; at least one is needed, such as `mesh: (path: \"rock.obj\")` or \
         `source: HeightMap(path: \"rock.png\")`"
    )]
    NoInput,
    /// Two fields that say the same thing.
    #[error("curved: `points` and `max_error_degrees` are both there; one of them is accepted")]
    PointsTwice,
    /// A value that no field has.
    #[error(transparent)]
    Field(#[from] FieldError),
}

impl Recipe {
    /// A recipe for a bare source: every default, and nothing left out.
    #[must_use]
    pub fn bare(source: Source) -> Self {
        Self { source: Some(source), ..Self::empty() }
    }

    /// A recipe for a bare mesh: every default.
    #[must_use]
    pub fn bare_mesh(mesh: MeshSource) -> Self {
        Self { mesh: Some(mesh), ..Self::empty() }
    }

    fn empty() -> Self {
        Self {
            source: None,
            mesh: None,
            spacing: Spacing::UNIT,
            unit: None,
            edge: Edge::Clamp,
            scene: None,
            height: HeightRecipe::default(),
            horizon: HorizonRecipe::default(),
            distance: DistanceRecipe::default(),
            curved: CurvedRecipe::default(),
            sky: SkyRecipe::default(),
            hemisphere: HemisphereRecipe::default(),
            cone_map: ConeMapRecipe::default(),
            maximum_mip: MaximumMipRecipe::default(),
            curvature: CurvatureRecipe::default(),
            compression: Compression::default(),
        }
    }

    /// The unit of heights, spacing and radius.
    #[must_use]
    pub fn height_unit(&self) -> LengthUnit {
        self.unit.unwrap_or_default()
    }

    /// The unit of the mesh: that of the heights where there are any. `None` leaves it to the mesh's format.
    #[must_use]
    pub fn mesh_unit(&self) -> Option<LengthUnit> {
        self.unit.or(self.source.as_ref().map(|_| self.height_unit()))
    }

    /// Parses a recipe.
    pub fn parse(text: &str) -> Result<Self, RecipeError> {
        let options = ron::Options::default()
            .with_default_extension(Extensions::UNWRAP_VARIANT_NEWTYPES | Extensions::IMPLICIT_SOME);
        let text: RecipeText = read(text, &options)?;
        let (spacing_u, spacing_v) = text.spacing.lengths();
        if text.curved.points.is_some() && text.curved.max_error_degrees.is_some() {
            return Err(RecipeError::PointsTwice);
        }
        if text.source.is_none() && text.mesh.is_none() {
            return Err(RecipeError::NoInput);
        }
        Ok(Self {
            source: text.source,
            mesh: text.mesh,
            spacing: Spacing::new(spacing_u, spacing_v)?,
            unit: text.unit,
            edge: text.edge,
            scene: text.scene,
            height: text.height,
            horizon: text.horizon,
            distance: text.distance,
            curved: text.curved,
            sky: text.sky,
            hemisphere: text.hemisphere,
            cone_map: text.cone_map,
            maximum_mip: text.maximum_mip,
            curvature: text.curvature,
            compression: text.compression,
        })
    }
}

/// Deserializes a text and remembers in which field an error arose.
fn read<T: DeserializeOwned>(text: &str, options: &ron::Options) -> Result<T, RecipeError> {
    let mut ron =
        ron::Deserializer::from_str_with_options(text, options).map_err(|error| syntax::error(text, "", &error))?;
    let value = serde_path_to_error::deserialize(&mut ron).map_err(|error| {
        let field = field_name(error.path());
        syntax::error(text, &field, &ron.span_error(error.into_inner()))
    })?;
    ron.end().map_err(|error| syntax::error(text, "", &ron.span_error(error)))?;
    Ok(value)
}

/// `horizon.directions`; empty for the recipe itself.
fn field_name(path: &Path) -> String {
    let known = path.iter().filter(|segment| !matches!(segment, Segment::Unknown));
    known.map(ToString::to_string).collect::<Vec<_>>().join(".")
}
