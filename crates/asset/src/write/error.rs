//! Why a file could not be written.

use super::encode::EncodeError;
use crate::entry::MAX_DESCRIPTOR_BYTES;
use crate::{DescriptorError, PayloadError, SectionKind};

/// Why a file could not be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum WriteError {
    /// Values that the encoding cannot hold.
    #[error(transparent)]
    Encode(#[from] EncodeError),
    /// A descriptor outside the format.
    #[error("section {kind}: {error}")]
    Descriptor {
        /// The section's kind.
        kind: SectionKind,
        /// What is wrong with it.
        #[source]
        error: DescriptorError,
    },
    /// The kind is already there.
    #[error("section {kind} was added twice; kinds are unique within a file")]
    Duplicate {
        /// The kind.
        kind: SectionKind,
    },
    /// The kind is not four ASCII letters or digits.
    #[error("section kind \"{kind}\" is not four ASCII letters or digits")]
    Kind {
        /// The kind.
        kind: SectionKind,
    },
    /// The descriptor is too long.
    #[error("section {kind}: the descriptor has {length} bytes; at most {MAX_DESCRIPTOR_BYTES} are accepted")]
    DescriptorLength {
        /// The section's kind.
        kind: SectionKind,
        /// Its descriptor's length in bytes.
        length: usize,
    },
    /// A section without bytes.
    #[error("section {kind} has no bytes")]
    Empty {
        /// The section's kind.
        kind: SectionKind,
    },
    /// A file without sections, or with more or far fewer than room was made for.
    #[error("there are {found} sections; {min} to {max} are accepted")]
    SectionCount {
        /// How many there are.
        found: usize,
        /// The least number that the room is right for.
        min: u32,
        /// The greatest.
        max: u32,
    },
    /// A table that is not open: not opened yet, or closed.
    #[error("table {kind} is not open")]
    NotOpen {
        /// Its kind.
        kind: SectionKind,
    },
    /// A table that was not closed.
    #[error("table {kind} was not closed")]
    NotClosed {
        /// Its kind.
        kind: SectionKind,
    },
    /// A layer that the table does not have, or of another length.
    #[error("table {kind}: layer {layer} of {found} bytes; {layers} layers of {expected} bytes are accepted")]
    Layer {
        /// The table's kind.
        kind: SectionKind,
        /// The layer, counted from 0.
        layer: u32,
        /// Its length in bytes.
        found: u64,
        /// Layers of the table.
        layers: u32,
        /// Bytes of each.
        expected: u64,
    },
    /// A table was closed without one of its layers.
    #[error("table {kind}: layer {layer} was not written")]
    MissingLayer {
        /// The table's kind.
        kind: SectionKind,
        /// The first layer that is missing, counted from 0.
        layer: u32,
    },
    /// A table was closed with a descriptor that its bytes are not of.
    #[error("table {kind} was closed as another than it was opened: extent, format and section version must stay")]
    Changed {
        /// The table's kind.
        kind: SectionKind,
    },
    /// The machine has no room for a table that is to be compressed.
    #[error("table {kind}: no memory for {bytes} bytes to compress; a raw table needs none")]
    OutOfMemory {
        /// The table's kind.
        kind: SectionKind,
        /// Its bytes.
        bytes: u64,
    },
    /// An unknown section of another file is damaged or cannot be decoded, so it has no identity.
    #[error("section {kind} cannot be kept: {error}")]
    Copy {
        /// The section's kind.
        kind: SectionKind,
        /// What is wrong with it.
        #[source]
        error: PayloadError,
    },
    /// An unknown section of another file is damaged.
    #[error("section {kind} cannot be kept: its CRC-32 does not match its bytes")]
    Damaged {
        /// The section's kind.
        kind: SectionKind,
    },
    /// The compressor failed.
    #[error("section {kind}: zstd: {error}")]
    Zstd {
        /// The section's kind.
        kind: SectionKind,
        /// What it says.
        #[source]
        error: std::io::Error,
    },
    /// An earlier failure of the file was passed over.
    #[error("the file is not whole: writing it has failed before")]
    Failed,
    /// The file behind the writer failed: the disk is full, say.
    #[error("the file cannot be {action} at byte {offset}: {error}")]
    Io {
        /// `written`, `read back` or `flushed`.
        action: &'static str,
        /// Where in the file.
        offset: u64,
        /// What the system says.
        #[source]
        error: std::io::Error,
    },
}
