//! What a recipe says of a mesh: where it is, and what is to be found of its curvature.

use std::path::PathBuf;

use barchan_asset::Encoding;
use barchan_bakers::curvature::{CurvatureMethod as Method, CurvatureParams};
use barchan_field::ParametricSurface;
use barchan_field::surfaces::{Pattern, Tessellation};
use serde::{Deserialize, Serialize};

/// Where the mesh comes from.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(try_from = "MeshText")]
pub enum MeshSource {
    /// A mesh on disk.
    File(MeshFile),
    /// A closed form.
    Surface(Box<SurfaceSource>),
}

/// A mesh on disk: OBJ, PLY or glTF, which its bytes tell.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MeshFile {
    /// The file; relative paths start at the recipe's folder.
    pub path: PathBuf,
    /// Which mesh of a glTF file that has several: its name, or its number counted from 0.
    pub mesh: Option<String>,
}

/// A closed form, cut into triangles.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SurfaceSource {
    /// The form and its parameters.
    pub surface: ParametricSurface,
    /// Where its vertices lie.
    pub tessellation: Tessellation,
}

/// `mesh: (path: "rock.obj")` or `mesh: (surface: Sphere(radius: 2.0), vertices: 4000)`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct MeshText {
    #[serde(default)]
    path: Option<PathBuf>,
    #[serde(default)]
    mesh: Option<String>,
    #[serde(default)]
    surface: Option<ParametricSurface>,
    #[serde(default)]
    vertices: Option<u32>,
    #[serde(default)]
    pattern: Option<Pattern>,
    #[serde(default)]
    seed: Option<u64>,
    #[serde(default)]
    uv_seam: Option<bool>,
}

impl TryFrom<MeshText> for MeshSource {
    type Error = String;

    fn try_from(text: MeshText) -> Result<Self, String> {
        let of_surface = [
            ("vertices", text.vertices.is_some()),
            ("pattern", text.pattern.is_some()),
            ("seed", text.seed.is_some()),
            ("uv_seam", text.uv_seam.is_some()),
        ];
        match (text.path, text.surface) {
            (None, None) => Err("neither `path` nor `surface` is there; one of them is needed".to_owned()),
            (Some(_), Some(_)) => Err("`path` and `surface` are both there; one of them is accepted".to_owned()),
            (Some(path), None) => match of_surface.into_iter().find(|(_, is_there)| *is_there) {
                Some((field, _)) => Err(format!("`{field}` is for a `surface`; beside `path` only `mesh` is accepted")),
                None => Ok(Self::File(MeshFile { path, mesh: text.mesh })),
            },
            (None, Some(_)) if text.mesh.is_some() => Err("`mesh` is for a `path`, of a glTF file".to_owned()),
            (None, Some(surface)) => {
                let tessellation = Tessellation {
                    vertices: text.vertices.ok_or("the field `vertices` is missing")?,
                    pattern: text.pattern.unwrap_or(Pattern::Jittered),
                    seed: text.seed.unwrap_or(0),
                    uv_seam: text.uv_seam.unwrap_or(false),
                };
                Ok(Self::Surface(Box::new(SurfaceSource { surface, tessellation })))
            }
        }
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
