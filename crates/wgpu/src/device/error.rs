//! Why an upload failed.

use std::fmt;

use barchan_asset::SectionKind;

/// Why an upload failed: nothing is left on the device.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum UploadError {
    /// The plan was made of another file.
    OtherFile {
        /// The section that is not as planned.
        kind: SectionKind,
    },
    /// A compressed section does not decode.
    Payload {
        /// Which section.
        kind: SectionKind,
        /// What the decoder says.
        reason: String,
    },
    /// The device refused, or is lost.
    Device {
        /// What it says.
        reason: String,
    },
}

impl fmt::Display for UploadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OtherFile { kind } => {
                write!(f, "section {kind} is not as it was planned; plan and file must belong together")
            }
            Self::Payload { kind, reason } => write!(f, "section {kind}: {reason}"),
            Self::Device { reason } => write!(f, "the device refused the upload: {reason}"),
        }
    }
}

impl std::error::Error for UploadError {}
