//! What a recipe says of a mesh: where it is, and what is to be found of its curvature.

use std::path::PathBuf;

use barchan_asset::Encoding;
use barchan_bakers::curvature::{CurvatureMethod as Method, CurvatureParams};
use serde::{Deserialize, Serialize};

/// Where the mesh comes from.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(from = "MeshFile")]
pub enum MeshSource {
    /// A mesh on disk.
    File(MeshFile),
}

/// A mesh on disk: OBJ, PLY or glTF, which its bytes tell.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MeshFile {
    /// The file; relative paths start at the recipe's folder.
    pub path: PathBuf,
    /// Which mesh of a glTF file that has several: its name, or its number counted from 0.
    #[serde(default)]
    pub mesh: Option<String>,
}

impl From<MeshFile> for MeshSource {
    fn from(file: MeshFile) -> Self {
        Self::File(file)
    }
}

/// The curvature table.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct CurvatureRecipe {
    /// How exactly, at what speed.
    pub method: CurvatureMethod,
    /// Where the mesh's normals on the two sides of an edge differ by more, in degrees, the surface is not smooth across it.
    pub hard_edge_degrees: f64,
    /// How it is stored.
    pub encoding: CurvatureEncoding,
    /// Whether principal directions are stored in three dimensions; `None` stores them where the mesh has no texture coordinates,
    /// and so no fundamental forms to stand for them.
    pub directions: Option<bool>,
    /// Whether principal directions are stored in texture coordinates too, as the paper has them.
    pub uv_directions: bool,
}

impl CurvatureRecipe {
    /// What to bake, in the baker's words.
    #[must_use]
    pub fn params(&self) -> CurvatureParams {
        CurvatureParams { method: self.method.into(), hard_edge_degrees: self.hard_edge_degrees }
    }
}

impl Default for CurvatureRecipe {
    fn default() -> Self {
        let CurvatureParams { method: _, hard_edge_degrees } = CurvatureParams::default();
        Self {
            method: CurvatureMethod::default(),
            hard_edge_degrees,
            encoding: CurvatureEncoding::default(),
            directions: None,
            uv_directions: false,
        }
    }
}

/// `fast` or `accurate`, as recipes and flags spell it.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum CurvatureMethod {
    /// For previews.
    Fast,
    /// Degree and neighbourhood of the fit chosen by the data.
    #[default]
    Accurate,
}

impl CurvatureMethod {
    /// `fast` or `accurate`.
    #[must_use]
    pub fn name(self) -> &'static str {
        Method::from(self).name()
    }
}

impl From<CurvatureMethod> for Method {
    fn from(method: CurvatureMethod) -> Self {
        match method {
            CurvatureMethod::Fast => Self::Fast,
            CurvatureMethod::Accurate => Self::Accurate,
        }
    }
}

/// `f32` or `f16`, as recipes spell it: bytes would cut curvature, which spans decades, into visible steps.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum CurvatureEncoding {
    /// As baked, rounded to single floats.
    F32,
    /// Half floats and a factor for each column.
    #[default]
    F16,
}

impl CurvatureEncoding {
    /// `f32` or `f16`.
    #[must_use]
    pub fn name(self) -> &'static str {
        Encoding::from(self).name()
    }
}

impl From<CurvatureEncoding> for Encoding {
    fn from(encoding: CurvatureEncoding) -> Self {
        match encoding {
            CurvatureEncoding::F32 => Self::F32,
            CurvatureEncoding::F16 => Self::F16,
        }
    }
}
