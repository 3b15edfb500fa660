use barchan_asset::{DescriptorError, EncodeError, WriteError};
use barchan_bakers::BakeError;
use barchan_field::FieldError;
use barchan_shade::{MismatchedRelief, MismatchedTables};
use barchan_view::GpuError;
use barchan_wgpu::{ComposeError, PlanError, ReadError, UploadError};
use thiserror::Error;

/// Why a study cannot go on.
#[derive(Debug, Error)]
pub enum StudyError {
    /// There is no scene of that name.
    #[error("there is no scene `{name}`; {known} are known")]
    Scene {
        /// The name asked for.
        name: String,
        /// The names there are.
        known: String,
    },
    /// A scene cannot be made.
    #[error(transparent)]
    Field(#[from] FieldError),
    /// A baker refused.
    #[error(transparent)]
    Bake(#[from] BakeError),
    /// A table cannot be stored.
    #[error(transparent)]
    Encode(#[from] EncodeError),
    /// A file cannot be put together.
    #[error(transparent)]
    Write(#[from] WriteError),
    /// There is no GPU, or it refuses.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// A stored table cannot be read.
    #[error(transparent)]
    Table(#[from] DescriptorError),
    /// Tables do not fit each other.
    #[error(transparent)]
    Tables(#[from] MismatchedTables),
    /// A table for relief search is not of the relief.
    #[error(transparent)]
    Relief(#[from] MismatchedRelief),
    /// A mesh that is to be shaded has no texture coordinates.
    #[error("the mesh has no texture coordinates, so it has no fundamental forms")]
    NoTextureCoordinates,
    /// Text is not a setting.
    #[error("`{text}` is not a setting; words like `method=sweep directions=32` are accepted")]
    Setting {
        /// The text.
        text: String,
    },
    /// A file of records cannot be read or written.
    #[error("records: {0}")]
    Records(#[from] ::csv::Error),
    /// A chart cannot be drawn.
    #[error("chart: {message}")]
    Chart {
        /// What the drawing says.
        message: String,
    },
    /// A document has no place for a table.
    #[error("the document has no lines `<!-- {name}:begin -->` and `<!-- {name}:end -->` in this order, once each")]
    Markers {
        /// The block's name.
        name: String,
    },
}

/// What the reader refuses comes in words of the GPU's.
macro_rules! by_the_gpu {
    ($($error:ty),+) => {
        $(impl From<$error> for StudyError {
            fn from(error: $error) -> Self {
                Self::Gpu(error.into())
            }
        })+
    };
}

by_the_gpu!(ReadError, PlanError, ComposeError, UploadError);
