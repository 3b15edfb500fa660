//! Why a table was refused: one sentence each, naming the field, its value and what would be accepted.

use core::fmt;

use super::DESCRIPTOR_BYTES;
use crate::{SectionKind, Semantic, Transfer};

/// Why a texture descriptor, or the payload beside it, was refused.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum DescriptorError {
    /// The section is not a table of texels.
    NotATexture {
        /// The section's kind.
        kind: SectionKind,
    },
    /// The section's version is not supported.
    Version {
        /// The section's version.
        found: u16,
        /// The newest one that is read.
        newest: u16,
    },
    /// The descriptor has another length than 256 bytes.
    Length {
        /// Its length in bytes.
        found: u64,
    },
    /// A reserved byte is not zero.
    Reserved {
        /// Its offset in the descriptor.
        offset: usize,
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
    /// A count that is zero or too large.
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
    /// A real number outside what the format allows.
    Number {
        /// The field.
        field: &'static str,
        /// Its value.
        found: f64,
        /// What would be accepted.
        accepted: &'static str,
    },
    /// The semantic is another than expected from the section's kind or the view's type.
    Semantic {
        /// The descriptor's semantic.
        found: Semantic,
        /// The only semantic accepted.
        expected: Semantic,
    },
    /// The format has another number of channels than the semantic asks for.
    Channels {
        /// Channels of the format.
        found: u32,
        /// The only number accepted.
        expected: u32,
        /// The descriptor's semantic.
        semantic: Semantic,
    },
    /// A transfer that values of the semantic are not stored through.
    Transfer {
        /// The descriptor's transfer.
        found: Transfer,
        /// The descriptor's semantic.
        semantic: Semantic,
    },
    /// Azimuths that are neither the full circle nor an arc.
    Azimuths {
        /// The first azimuth in radians.
        first: f64,
        /// The step in radians.
        step: f64,
        /// How many azimuths there are.
        count: u32,
    },
    /// Candidates of a table that is not swept, none of one that is, or a number that does not divide the layers.
    Candidates {
        /// The descriptor's candidates.
        found: u32,
        /// The descriptor's layers.
        layers: u32,
    },
    /// Rings that do not divide the layers of a hemisphere table, or rings of another table.
    Rings {
        /// The descriptor's rings.
        found: u32,
        /// The descriptor's layers.
        layers: u32,
    },
    /// The payload's length does not follow from the extent.
    PayloadLength {
        /// Bytes there are.
        found: u64,
        /// Bytes the extent asks for.
        expected: u64,
    },
}

impl DescriptorError {
    /// The number of the finding that `validate` reports for this error; listed in `formats/barchan-v1.md`.
    #[must_use]
    pub fn id(&self) -> &'static str {
        match self {
            Self::NotATexture { .. } => "B0406",
            Self::Version { .. } => "B0215",
            Self::Length { .. } => "B0401",
            Self::Reserved { .. } => "B0402",
            Self::Enumeration { .. } => "B0403",
            Self::Extent { .. } => "B0404",
            Self::Number { .. } => "B0405",
            Self::Semantic { .. } => "B0406",
            Self::PayloadLength { .. } => "B0407",
            Self::Channels { .. } => "B0408",
            Self::Transfer { .. } => "B0409",
            Self::Azimuths { .. } => "B0410",
            Self::Candidates { .. } => "B0411",
            Self::Rings { .. } => "B0414",
        }
    }
}

impl fmt::Display for DescriptorError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotATexture { kind } => write!(f, "a {kind} section is not a table of texels"),
            Self::Version { found, newest } => {
                write!(f, "section version {found} is not supported; the newest this reader reads is {newest}")
            }
            Self::Length { found } => {
                write!(f, "the texture descriptor has {found} bytes; {DESCRIPTOR_BYTES} are accepted")
            }
            Self::Reserved { offset } => write!(f, "the reserved descriptor byte at {offset} is not zero"),
            Self::Enumeration { field, found, accepted } => write!(f, "{field} is {found}; accepted: {accepted}"),
            Self::Extent { field, found, min, max } if min == max => {
                write!(f, "{field} is {found}; {min} is accepted")
            }
            Self::Extent { field, found, min, max } => write!(f, "{field} is {found}; {min} to {max} is accepted"),
            Self::Number { field, found, accepted } => write!(f, "{field} is {found}; accepted: {accepted}"),
            Self::Semantic { found, expected } => {
                write!(f, "the table holds {}, but {} was expected", found.name(), expected.name())
            }
            Self::PayloadLength { found, expected } => {
                write!(f, "the payload has {found} bytes; its extent asks for {expected}")
            }
            Self::Channels { found, expected, semantic } => {
                write!(f, "vk_format has {found} channels; {} has {expected}", semantic.name())
            }
            Self::Transfer { found, semantic } => {
                write!(
                    f,
                    "transfer is {} ({}), which {} is not stored through",
                    found.number(),
                    found.name(),
                    semantic.name()
                )
            }
            Self::Azimuths { first, step, count } => write!(
                f,
                "{count} azimuths from {first} by {step}; accepted: from 0 by 2π / {count}, or an arc that starts \
                 within ±2π and is shorter than 2π"
            ),
            Self::Candidates { found, layers } => write!(
                f,
                "candidates is {found} of {layers} layers; a divisor of the layers is accepted for a swept table, else 0"
            ),
            Self::Rings { found, layers } => write!(
                f,
                "rings is {found} of {layers} layers; a divisor of the layers is accepted for hemisphere depths, else 0"
            ),
        }
    }
}

impl core::error::Error for DescriptorError {}
