//! Why a curvature table was refused: one sentence each, naming the field, its value and what would be accepted.

use core::fmt;

use super::CURVATURE_VERSION;
use crate::{CurvatureColumn, SectionKind, VertexFormat};

/// Why a curvature descriptor, or the payload beside it, was refused.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum CurvatureError {
    /// The section does not hold curvature.
    NotCurvature {
        /// The section's kind.
        kind: SectionKind,
    },
    /// The section's version is not supported.
    Version {
        /// The section's version.
        found: u16,
    },
    /// The descriptor's length does not follow from its number of columns.
    Length {
        /// Its length in bytes.
        found: u64,
        /// What its columns ask for; the least there is if it ends before their number.
        expected: u64,
    },
    /// A reserved number is not zero.
    Reserved {
        /// The number.
        found: u32,
    },
    /// A number that stands for nothing.
    Enumeration {
        /// The field.
        field: &'static str,
        /// Its value.
        found: u32,
        /// What would be accepted.
        accepted: &'static str,
    },
    /// A count out of bounds.
    Extent {
        /// The field.
        field: &'static str,
        /// Its value.
        found: u32,
        /// The least value accepted.
        min: u32,
        /// The greatest value accepted.
        max: u32,
    },
    /// A column in a format that is not for it.
    Format {
        /// The column.
        column: CurvatureColumn,
        /// Its format.
        found: VertexFormat,
    },
    /// A real number outside what the format allows.
    Number {
        /// The column.
        column: CurvatureColumn,
        /// The field.
        field: &'static str,
        /// Its value.
        found: f32,
        /// What would be accepted.
        accepted: &'static str,
    },
    /// A column that comes twice or behind one of a greater number.
    Order {
        /// The column.
        column: CurvatureColumn,
    },
    /// A column that is missing.
    Missing {
        /// The column.
        column: CurvatureColumn,
    },
    /// The payload's length does not follow from vertices and columns.
    PayloadLength {
        /// Bytes there are.
        found: u64,
        /// Bytes that vertices and columns ask for.
        expected: u64,
    },
}

impl CurvatureError {
    /// The number of the finding that `validate` reports for this error; listed in `formats/barchan-v1.md`.
    #[must_use]
    pub fn id(&self) -> &'static str {
        match self {
            Self::NotCurvature { .. } => "B0406",
            Self::Version { .. } => "B0215",
            Self::Length { .. } => "B0412",
            Self::Reserved { .. } => "B0402",
            Self::Enumeration { .. } | Self::Format { .. } => "B0403",
            Self::Extent { .. } => "B0404",
            Self::Number { .. } => "B0405",
            Self::Order { .. } | Self::Missing { .. } => "B0413",
            Self::PayloadLength { .. } => "B0407",
        }
    }
}

impl fmt::Display for CurvatureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotCurvature { kind } => write!(f, "a {kind} section does not hold curvature; CURV does"),
            Self::Version { found } => {
                write!(f, "section version {found} is not supported; this reader reads {CURVATURE_VERSION}")
            }
            Self::Length { found, expected } => {
                write!(f, "the curvature descriptor has {found} bytes; its columns ask for {expected}")
            }
            Self::Reserved { found } => write!(f, "the reserved number of the descriptor is {found}; 0 is accepted"),
            Self::Enumeration { field, found, accepted } => write!(f, "{field} is {found}; accepted: {accepted}"),
            Self::Extent { field, found, min, max } => write!(f, "{field} is {found}; {min} to {max} is accepted"),
            Self::Format { column, found } => {
                let [exact, small] = column.formats().map(VertexFormat::name);
                write!(f, "{} is stored as {}; {exact} or {small} is accepted", column.name(), found.name())
            }
            Self::Number { column, field, found, accepted } => {
                write!(f, "{field} of {} is {found}; accepted: {accepted}", column.name())
            }
            Self::Order { column } => {
                write!(f, "{} comes twice or too late; columns are accepted once each, by number", column.name())
            }
            Self::Missing { column } => match column.companion() {
                Some(companion) => write!(f, "{} is there without {}", companion.name(), column.name()),
                None => write!(f, "there is no {}, which every table has", column.name()),
            },
            Self::PayloadLength { found, expected } => {
                write!(f, "the payload has {found} bytes; vertices and columns ask for {expected}")
            }
        }
    }
}

impl core::error::Error for CurvatureError {}
