//! Why an upload failed.

use std::fmt;

use crate::ReadError;

/// Why an upload failed. Whatever was made of it on the device is gone again.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum UploadError {
    /// The plan was made of another file, or of other bytes of it.
    OtherFile,
    /// A section that cannot be read or decoded.
    Read(ReadError),
    /// The device refused.
    Device {
        /// What it says.
        reason: String,
    },
    /// The device has no memory left.
    OutOfMemory,
    /// The device is lost, before or on the way.
    Lost,
}

impl From<ReadError> for UploadError {
    fn from(error: ReadError) -> Self {
        Self::Read(error)
    }
}

impl fmt::Display for UploadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OtherFile => write!(f, "the upload was planned for another file; plan it again for this one"),
            Self::Read(error) => write!(f, "{error}"),
            Self::Device { reason } => write!(f, "the device refused the upload: {reason}"),
            Self::OutOfMemory => {
                write!(f, "the device has no memory left for the upload; load fewer tables, or parts of them")
            }
            Self::Lost => write!(f, "the device is lost; make another one and upload again"),
        }
    }
}

impl std::error::Error for UploadError {}
