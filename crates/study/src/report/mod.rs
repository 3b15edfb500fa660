//! How records read in the docs: one block of markdown per file of records, and the charts that belong to it.
//!
//! Both are pure functions of the file, so that a document can be checked against it.

mod accuracy;
mod curvature;
mod curved;
mod effect;
mod gpu_size;
mod gpu_time;
mod gpu_upload;
mod gpu_words;
mod hemisphere_occlusion;
mod hemisphere_paper;
mod hemisphere_speed;
mod interpolation;
mod mesh_accuracy;
mod mesh_speed;
mod numbers;
mod promises;
mod relief_search;
mod relief_start;
mod relief_words;
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
    /// Where curvature matters: [`curved_effect`](crate::curved_effect).
    CurvedEffect,
    /// What the shader decides on curved surfaces: [`curved_shadow`](crate::curved_shadow).
    CurvedShadow,
    /// Curvature between vertices: [`curvature_interpolation`](crate::curvature_interpolation).
    CurvatureInterpolation,
    /// How exact baked curvature is: [`curvature_accuracy`](crate::curvature_accuracy).
    CurvatureAccuracy,
    /// How fast it is baked: [`curvature_speed`](crate::curvature_speed).
    CurvatureSpeed,
    /// The paper's claims: [`hemisphere_paper`](crate::hemisphere_paper).
    HemispherePaper,
    /// All ways to find a hit: [`relief_search`](crate::relief_search).
    ReliefSearch,
    /// Where hemisphere depths let rays start: [`relief_start`](crate::relief_start).
    ReliefStart,
    /// Occlusion and shadow from them: [`hemisphere_occlusion`](crate::hemisphere_occlusion).
    HemisphereOcclusion,
    /// How fast they are baked: [`hemisphere_speed`](crate::hemisphere_speed).
    HemisphereSpeed,
    /// What techniques cost on a GPU: [`gpu_time`](crate::gpu_time).
    GpuTime,
    /// How long files take to get there: [`gpu_upload`](crate::gpu_upload).
    GpuUpload,
    /// What the reader adds to a program: [`gpu_size`](crate::gpu_size).
    GpuSize,
}

impl Block {
    /// Every block, in the order of the docs.
    pub const ALL: [Self; 17] = [
        Self::Bench,
        Self::Accuracy,
        Self::Shadow,
        Self::Kappa,
        Self::CurvedEffect,
        Self::CurvedShadow,
        Self::CurvatureInterpolation,
        Self::CurvatureAccuracy,
        Self::CurvatureSpeed,
        Self::HemispherePaper,
        Self::ReliefSearch,
        Self::ReliefStart,
        Self::HemisphereOcclusion,
        Self::HemisphereSpeed,
        Self::GpuTime,
        Self::GpuUpload,
        Self::GpuSize,
    ];

    /// The name of the file, without `.csv`, and of the block.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Bench => "bench",
            Self::Accuracy => "accuracy",
            Self::Shadow => "shadow",
            Self::Kappa => "kappa",
            Self::CurvedEffect => "curved_effect",
            Self::CurvedShadow => "curved_shadow",
            Self::CurvatureInterpolation => "curvature_interpolation",
            Self::CurvatureAccuracy => "curvature_accuracy",
            Self::CurvatureSpeed => "curvature_speed",
            Self::HemispherePaper => "hemisphere_paper",
            Self::ReliefSearch => "relief_search",
            Self::ReliefStart => "relief_start",
            Self::HemisphereOcclusion => "hemisphere_occlusion",
            Self::HemisphereSpeed => "hemisphere_speed",
            Self::GpuTime => "gpu_time",
            Self::GpuUpload => "gpu_upload",
            Self::GpuSize => "gpu_size",
        }
    }

    /// The block's markdown; `csv` is the file's text, `None` if there is no such file yet.
    ///
    /// # Errors
    /// A text that is not of this file's columns.
    pub fn render(self, csv: Option<&str>) -> Result<String, StudyError> {
        let Some(csv) = csv else { return Ok("*Not measured yet.*\n".to_owned()) };
        let file = RecordFile::from_csv(csv)?;
        Ok(match self {
            Self::Bench => speed::render(&file),
            Self::Accuracy => accuracy::render(&file),
            Self::Shadow => shadow::render(&file),
            Self::Kappa => curvature::render(&file),
            Self::CurvedEffect => effect::render(&file),
            Self::CurvedShadow => curved::render(&file),
            Self::CurvatureInterpolation => interpolation::render(&file),
            Self::CurvatureAccuracy => mesh_accuracy::render(&file),
            Self::CurvatureSpeed => mesh_speed::render(&file),
            Self::HemispherePaper => hemisphere_paper::render(&file),
            Self::ReliefSearch => relief_search::render(&file),
            Self::ReliefStart => relief_start::render(&file),
            Self::HemisphereOcclusion => hemisphere_occlusion::render(&file),
            Self::HemisphereSpeed => hemisphere_speed::render(&file),
            Self::GpuTime => gpu_time::render(&file),
            Self::GpuUpload => gpu_upload::render(&file),
            Self::GpuSize => gpu_size::render(&file),
        })
    }

    /// The charts that belong to the block, as SVG, and their names without `.svg`.
    ///
    /// # Errors
    /// As for [`Block::render`].
    pub fn charts(self, csv: Option<&str>) -> Result<Vec<(&'static str, String)>, StudyError> {
        match (self, csv) {
            (Self::CurvedEffect, Some(csv)) => effect::charts(&RecordFile::from_csv(csv)?),
            (Self::ReliefSearch, Some(csv)) => relief_search::charts(&RecordFile::from_csv(csv)?),
            _ => Ok(Vec::new()),
        }
    }
}
