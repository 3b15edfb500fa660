use std::path::PathBuf;

use barchan_asset::{EncodeError, WriteError};
use barchan_bakers::BakeError;
use barchan_field::FieldError;
use barchan_import::ImportError;
use thiserror::Error;

use crate::RecipeError;

/// Why there is no asset.
#[derive(Debug, Error)]
pub enum PipelineError {
    /// The recipe's text.
    #[error("{}: {error}", path.display())]
    Recipe {
        /// The recipe.
        path: PathBuf,
        /// What is wrong with it.
        error: RecipeError,
    },
    /// The height map.
    #[error(transparent)]
    Import(#[from] ImportError),
    /// The shape's parameters.
    #[error("source: {0}")]
    Shape(#[from] FieldError),
    /// The parameters of a surface.
    #[error("mesh: {0}")]
    Surface(FieldError),
    /// A generated field that would not fit.
    #[error("source: {width} × {height} texels are {texels}; at most {limit} are accepted")]
    ShapeTooLarge {
        /// Texels along u.
        width: u32,
        /// Texels along v.
        height: u32,
        /// Their product.
        texels: u64,
        /// The bound.
        limit: u64,
    },
    /// A baker refused.
    #[error("{subject}: {error}")]
    Bake {
        /// The source or table it is about.
        subject: String,
        /// The baker's reason.
        error: BakeError,
    },
    /// A table that cannot be baked from what the recipe has.
    #[error("{table} cannot be baked: {missing}")]
    NoInput {
        /// The table.
        table: &'static str,
        /// `there is no mesh` or `there is no height map`.
        missing: &'static str,
    },
    /// Directions in texture coordinates that a mesh does not have.
    #[error("curvature: `uv_directions` is true; the mesh has no texture coordinates, so only false is accepted")]
    NoTextureCoordinates,
    /// A table whose range of curvatures nobody named.
    #[error("scene: `curvature` is missing; {table} needs a range, such as `curvature: (0.0, 0.02)`")]
    NoCurvature {
        /// The table.
        table: &'static str,
    },
    /// Values that the encoding cannot hold.
    #[error("{table}: {error}")]
    Encode {
        /// The table.
        table: &'static str,
        /// The encoder's reason.
        error: EncodeError,
    },
    /// A file that the format cannot hold.
    #[error(transparent)]
    Write(#[from] WriteError),
}

impl PipelineError {
    /// Whether the disk or the system failed, and not what is on it.
    #[must_use]
    pub fn is_io(&self) -> bool {
        match self {
            Self::Import(error) => error.is_io(),
            Self::Bake { error, .. } => matches!(error, BakeError::Threads { .. } | BakeError::Memory { .. }),
            Self::Write(error) => matches!(error, WriteError::Io { .. } | WriteError::OutOfMemory { .. }),
            _ => false,
        }
    }
}

/// A baker's refusal, with what it is about. A field that is too small is the source's fault, whoever noticed.
pub(crate) fn refused(subject: &str, error: BakeError) -> PipelineError {
    let subject = if matches!(error, BakeError::Field { .. }) { "source" } else { subject };
    PipelineError::Bake { subject: subject.to_owned(), error }
}
