//! What can go wrong between here and a GPU.

use barchan_wgpu::{ComposeError, PlanError, ReadError, UploadError};

/// Why nothing was drawn.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum GpuError {
    /// There is no GPU, not even a software one.
    #[error("no GPU was found: {reason}; a software one is enough: on Debian, {INSTALL}")]
    NoAdapter {
        /// What the system says.
        reason: String,
    },
    /// The device refused something, or is lost.
    #[error("the GPU refused: {reason}")]
    Device {
        /// What it says.
        reason: String,
    },
    /// The file was refused.
    #[error(transparent)]
    Read(#[from] ReadError),
    /// The upload cannot be planned.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// The shader cannot be put together.
    #[error(transparent)]
    Compose(#[from] ComposeError),
    /// The upload failed.
    #[error(transparent)]
    Upload(#[from] UploadError),
}

/// What installs a software GPU.
const INSTALL: &str = "apt-get install -y mesa-vulkan-drivers libvulkan1";
