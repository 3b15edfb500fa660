//! Curvature per vertex of a mesh. `formats/curvature-v1.md` is the law.
//!
//! A table is columns, each of which a vertex buffer binds as it is: a number of every vertex, or a few, tight. Unlike a
//! texture it has no extent and no filter; what lies between vertices is the rasteriser's to interpolate.

mod column;
mod descriptor;
mod error;
mod flags;
mod forms;
mod view;

pub use column::{CurvatureColumn, VertexFormat};
pub use descriptor::{CURVATURE_VERSION, ColumnLayout, CurvatureDescriptor};
#[cfg(feature = "write")]
pub(crate) use descriptor::{GREATEST_NUMBER, LEAST_SCALE, UNIT_SLACK};
pub use error::CurvatureError;
pub use flags::VertexFlags;
pub use forms::SurfaceForms;
pub use view::CurvatureView;
