//! How records read in the docs: one block of markdown per file of records.
//!
//! A block is a pure function of the file, so that a document can be checked against it.

mod accuracy;
mod curvature;
mod numbers;
mod promises;
mod shadow;
mod speed;

use crate::{RecordFile, StudyError};

/// A file of records, and the block of the same name that it fills.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Block {
    /// How fast: [`horizon_speed`](crate::horizon_speed).
    Bench,
    /// How exact: [`horizon_accuracy`](crate::horizon_accuracy).
    Accuracy,
    /// What the shader decides: [`horizon_shadow`](crate::horizon_shadow).
    Shadow,
    /// What curved bases do to it: [`horizon_curvature`](crate::horizon_curvature).
    Kappa,
}

impl Block {
    /// Every block, in the order of the docs.
    pub const ALL: [Self; 4] = [Self::Bench, Self::Accuracy, Self::Shadow, Self::Kappa];

    /// The name of the file, without `.csv`, and of the block.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Bench => "bench",
            Self::Accuracy => "accuracy",
            Self::Shadow => "shadow",
            Self::Kappa => "kappa",
        }
    }

    /// The block's markdown; `csv` is the file's text, `None` if there is no such file yet.
    ///
    /// # Errors
    /// A text that is not of this file's columns.
    pub fn render(self, csv: Option<&str>) -> Result<String, StudyError> {
        let Some(csv) = csv else { return Ok("*Not measured yet.*\n".to_owned()) };
        match self {
            Self::Bench => Ok(speed::render(&RecordFile::from_csv(csv)?)),
            Self::Accuracy => Ok(accuracy::render(&RecordFile::from_csv(csv)?)),
            Self::Shadow => Ok(shadow::render(&RecordFile::from_csv(csv)?)),
            Self::Kappa => Ok(curvature::render(&RecordFile::from_csv(csv)?)),
        }
    }
}
