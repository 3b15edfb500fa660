//! Why a file was refused: one sentence each, naming the field, its value and what would be accepted.

use core::fmt;

use crate::SectionKind;
use crate::asset::{HEADER_BYTES, MAGIC, MAJOR, MAX_SECTIONS};
use crate::entry::MAX_DESCRIPTOR_BYTES;

/// Why [`crate::Asset::open`] refused a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum OpenError {
    /// Fewer bytes than a header.
    TooShort {
        /// Bytes given.
        length: u64,
    },
    /// The first 12 bytes are not the magic.
    Magic {
        /// The first 12 bytes.
        found: [u8; 12],
    },
    /// A major version this reader does not know.
    Major {
        /// The file's major version.
        found: u16,
    },
    /// The header states another length than the file has: cut short, or something was appended.
    FileSize {
        /// Bytes stated in the header.
        stated: u64,
        /// Bytes given.
        actual: u64,
    },
    /// Zero sections, too many, or more than the file has room to list.
    SectionCount {
        /// The header's section count.
        found: u32,
    },
    /// The header or the section table is damaged.
    HeaderCrc {
        /// CRC-32 stated in the header.
        stated: u32,
        /// CRC-32 of the bytes.
        computed: u32,
    },
    /// The file needs a feature this reader does not know.
    RequiredFeatures {
        /// The unknown bits.
        unknown: u64,
    },
    /// A reserved header byte is not zero.
    ReservedHeader {
        /// Its offset in the file.
        offset: u64,
    },
    /// A row of the section table is refused.
    Section {
        /// The row, counted from 0.
        index: u32,
        /// Its kind.
        kind: SectionKind,
        /// What is wrong.
        fault: SectionFault,
    },
    /// The last section does not end where the file does.
    End {
        /// End of the last section.
        sections_end: u64,
        /// Bytes in the file.
        file_size: u64,
    },
}

/// What is wrong with one row of the section table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum SectionFault {
    /// The kind is not four ASCII letters or digits.
    Kind,
    /// The kind occurs twice.
    Duplicate,
    /// Flag bits that no version knows.
    Flags {
        /// The flags.
        found: u32,
    },
    /// A critical section of a kind this reader does not know.
    UnknownCritical,
    /// A critical section in a version this reader does not know.
    Version {
        /// The section's version.
        found: u16,
        /// The newest one that it knows.
        newest: u16,
    },
    /// A critical section in a codec this reader does not know.
    Codec {
        /// The codec's number.
        found: u16,
    },
    /// The descriptor is too long.
    DescriptorLength {
        /// Its length in bytes.
        found: u32,
    },
    /// The section is not where the rows before it put it.
    Offset {
        /// The row's offset.
        found: u64,
        /// The only offset that leaves no hole and no overlap.
        expected: u64,
    },
    /// The section reaches beyond the file.
    Extent {
        /// The row's offset.
        offset: u64,
        /// The row's stored length.
        stored: u64,
        /// Bytes in the file.
        file_size: u64,
    },
    /// A raw section whose two lengths differ.
    RawLength {
        /// The row's stored length.
        stored: u64,
        /// The row's raw length.
        raw: u64,
    },
    /// A section without bytes, or a compressed one of nothing.
    Empty,
    /// A reserved byte of the row is not zero.
    Reserved {
        /// Its offset in the row.
        offset: usize,
    },
}

impl OpenError {
    /// The number of the finding that `validate` reports for this error; listed in `formats/barchan-v1.md`.
    #[must_use]
    pub fn id(&self) -> &'static str {
        match self {
            Self::TooShort { .. } => "B0101",
            Self::Magic { .. } => "B0102",
            Self::Major { .. } => "B0103",
            Self::FileSize { .. } => "B0104",
            Self::SectionCount { .. } => "B0105",
            Self::HeaderCrc { .. } => "B0106",
            Self::RequiredFeatures { .. } => "B0107",
            Self::ReservedHeader { .. } => "B0108",
            Self::Section { fault, .. } => fault.id(),
            Self::End { .. } => "B0213",
        }
    }
}

impl SectionFault {
    fn id(&self) -> &'static str {
        match self {
            Self::Kind => "B0201",
            Self::Duplicate => "B0202",
            Self::Flags { .. } => "B0203",
            Self::UnknownCritical => "B0204",
            Self::Version { .. } => "B0205",
            Self::Codec { .. } => "B0206",
            Self::DescriptorLength { .. } => "B0207",
            Self::Offset { .. } => "B0208",
            Self::Extent { .. } => "B0209",
            Self::RawLength { .. } => "B0210",
            Self::Empty => "B0211",
            Self::Reserved { .. } => "B0212",
        }
    }
}

impl fmt::Display for OpenError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooShort { length } => {
                write!(f, "the file has {length} bytes, fewer than the {HEADER_BYTES} of a .barchan header")
            }
            Self::Magic { found } => magic(f, found),
            Self::Major { found } => write!(f, "format version {found} is not supported; this reader reads {MAJOR}"),
            Self::FileSize { stated, actual } => {
                write!(f, "the header states file_size {stated}, but the file has {actual} bytes")
            }
            Self::SectionCount { found } => {
                write!(f, "section_count is {found}; 1 to {MAX_SECTIONS}, all rows inside the file, are accepted")
            }
            Self::HeaderCrc { stated, computed } => {
                write!(f, "the header is damaged: it states CRC-32 {stated:#010x}, its bytes have {computed:#010x}")
            }
            Self::RequiredFeatures { unknown } => {
                write!(f, "the file requires features {unknown:#018x}, which this reader does not know")
            }
            Self::ReservedHeader { offset } => write!(f, "the reserved header byte at {offset} is not zero"),
            Self::Section { index, kind, fault } => write!(f, "section {index} ({kind}): {fault}"),
            Self::End { sections_end, file_size } => {
                write!(f, "the last section ends at {sections_end}, but file_size is {file_size}; they must be equal")
            }
        }
    }
}

fn magic(f: &mut fmt::Formatter<'_>, found: &[u8; 12]) -> fmt::Result {
    let damaged = found[1..8] == MAGIC[1..8];
    let cause = if damaged { "; newlines or 8-bit characters were altered in a transfer" } else { "" };
    write!(f, "not a .barchan file: it starts with \"{}\"{cause}", found.escape_ascii())
}

impl fmt::Display for SectionFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Kind => write!(f, "the kind must be four ASCII letters or digits"),
            Self::Duplicate => write!(f, "the kind occurs twice; kinds are unique within a file"),
            Self::Flags { found } => write!(f, "flags are {found:#010x}; only bit 0 (critical) is defined"),
            Self::UnknownCritical => write!(f, "the section is critical and this reader does not know its kind"),
            Self::Version { found, newest } => {
                write!(f, "the section is critical and has version {found}; the newest this reader reads is {newest}")
            }
            Self::Codec { found } => {
                write!(f, "the section is critical and has codec {found}; 0 (raw) and 1 (zstd) are accepted")
            }
            Self::DescriptorLength { found } => {
                write!(f, "descriptor_length is {found}; at most {MAX_DESCRIPTOR_BYTES} is accepted")
            }
            Self::Offset { found, expected } => {
                write!(f, "offset is {found}; {expected} is where the rows before it put it")
            }
            Self::Extent { offset, stored, file_size } => {
                write!(f, "{stored} stored bytes at offset {offset} reach beyond the file's {file_size} bytes")
            }
            Self::RawLength { stored, raw } => {
                write!(f, "the codec is raw, but stored_length is {stored} and raw_length is {raw}")
            }
            Self::Empty => write!(f, "the section has no bytes"),
            Self::Reserved { offset } => write!(f, "the reserved byte at {offset} of its table row is not zero"),
        }
    }
}

impl core::error::Error for OpenError {}
impl core::error::Error for SectionFault {}
