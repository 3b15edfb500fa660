//! Why an upload cannot be planned.

use std::fmt;

use barchan_asset::{CurvatureColumn, SectionKind, Semantic};

use super::DeviceLimits;
use crate::ReadError;

/// Why an upload cannot be planned: one sentence each.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum PlanError {
    /// A table was asked for by name, and the file does not have it.
    Missing {
        /// Which.
        table: Semantic,
    },
    /// A part was asked for that the table does not have.
    Part {
        /// Which table.
        table: Semantic,
        /// What of it.
        field: &'static str,
        /// What was asked for.
        found: u32,
        /// The least that is accepted.
        least: u32,
        /// The most that is accepted.
        most: u32,
    },
    /// A texture that the device cannot hold in any shape.
    TooLarge {
        /// Which table.
        table: Semantic,
        /// Texels along u and v, and layers.
        extent: (u32, u32, u32),
        /// What the device has.
        limits: DeviceLimits,
    },
    /// A vertex buffer that is larger than the device allows.
    Buffer {
        /// Which column.
        column: CurvatureColumn,
        /// Its bytes.
        bytes: u64,
        /// The most there may be.
        most: u64,
    },
    /// A codec that this build does not decode.
    Codec {
        /// Of which section.
        kind: SectionKind,
        /// The codec's number.
        found: u16,
    },
}

impl fmt::Display for PlanError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Missing { table } => write!(f, "table {} is not in the file", table.kind()),
            Self::Part { table, field, found, least, most } => {
                write!(f, "table {}: {field} is {found}; {least} to {most} is accepted", table.kind())
            }
            Self::TooLarge { table, extent: (width, height, layers), limits } => write!(
                f,
                "table {} needs a texture of {width} × {height} texels and {layers} layers; the device has {side} × {side} texels and {} \
                 layers at most, or a volume of {} along each side; bake it smaller, or load a part of it",
                table.kind(),
                limits.max_layers,
                limits.max_3d,
                side = limits.max_2d,
            ),
            Self::Buffer { column, bytes, most } => {
                write!(
                    f,
                    "curvature column {} needs a buffer of {bytes} bytes; the device has {most} at most",
                    column.name()
                )
            }
            Self::Codec { kind, found } => write!(f, "{}", ReadError::Codec { kind: *kind, found: *found }),
        }
    }
}

impl std::error::Error for PlanError {}
