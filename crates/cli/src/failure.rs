//! Why a command stopped, sorted by who must act, and the exit code that says so.

use std::path::Path;
use std::process::ExitCode;

use barchan_pipeline::PipelineError;
use thiserror::Error;

/// What the program tells its caller.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ExitStatus {
    /// All is well.
    Success = 0,
    /// The command line is wrong.
    Usage = 1,
    /// A file's content is wrong.
    BadInput = 2,
    /// Two files differ.
    Difference = 3,
    /// The disk or the system failed.
    Io = 4,
}

impl From<ExitStatus> for ExitCode {
    fn from(status: ExitStatus) -> Self {
        Self::from(status as u8)
    }
}

/// Why a command stopped. Each message is one sentence that names the file or flag.
#[derive(Debug, Error)]
pub(crate) enum Failure {
    /// Whoever typed the command must act.
    #[error("{0}")]
    Usage(String),
    /// Whoever made the file must act.
    #[error("{0}")]
    BadInput(String),
    /// Whoever runs the machine must act.
    #[error("{0}")]
    Io(String),
}

impl Failure {
    pub(crate) fn status(&self) -> ExitStatus {
        match self {
            Self::Usage(_) => ExitStatus::Usage,
            Self::BadInput(_) => ExitStatus::BadInput,
            Self::Io(_) => ExitStatus::Io,
        }
    }

    /// The system refused something about a path.
    pub(crate) fn io(path: &Path, doing: &str, error: &std::io::Error) -> Self {
        Self::Io(format!("{}: {doing}: {error}", path.display()))
    }

    /// A file's content is wrong.
    pub(crate) fn content(path: &Path, error: impl std::fmt::Display) -> Self {
        Self::BadInput(format!("{}: {error}", path.display()))
    }
}

impl From<PipelineError> for Failure {
    fn from(error: PipelineError) -> Self {
        if error.is_io() { Self::Io(error.to_string()) } else { Self::BadInput(error.to_string()) }
    }
}
