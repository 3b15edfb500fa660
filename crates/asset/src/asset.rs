//! The file: header, section table, and the structure they promise.

use crate::bytes::{SECTION_ALIGN, align_up, array_at, first_nonzero, u16_at, u32_at, u64_at};
use crate::entry::{ENTRY_BYTES, Entry};
use crate::{OpenError, Section, SectionFault, SectionKind, crc};

/// The major version this crate reads and writes. A file with another one is refused.
pub const MAJOR: u16 = 1;
/// The minor version this crate writes. A file with a newer one is read.
pub const MINOR: u16 = 0;
/// The most sections a file may have.
pub const MAX_SECTIONS: u32 = 1024;

pub(crate) const MAGIC: [u8; 12] = *b"\x89BARCHAN\r\n\x1A\n";
pub(crate) const HEADER_BYTES: usize = 128;

pub(crate) const MAJOR_AT: usize = 12;
pub(crate) const MINOR_AT: usize = 14;
pub(crate) const FILE_SIZE_AT: usize = 16;
pub(crate) const SECTION_COUNT_AT: usize = 24;
pub(crate) const HEADER_CRC_AT: usize = 28;
pub(crate) const REQUIRED_AT: usize = 32;
pub(crate) const OPTIONAL_AT: usize = 40;
pub(crate) const IDENTITY_AT: usize = 48;
pub(crate) const RESERVED_AT: usize = 80;

/// An opened file: its structure and header checksum are right; payloads have not been looked at.
#[derive(Debug, Clone, Copy)]
pub struct Asset<'a> {
    bytes: &'a [u8],
    section_count: u32,
}

impl<'a> Asset<'a> {
    /// Checks header, section table and the layout of all sections. `bytes` is the whole file, no more and no less.
    ///
    /// Takes time in the number of sections, not in the length of the file; allocates nothing.
    ///
    /// # Errors
    /// Whatever `formats/barchan-v1.md` tells a reader to refuse.
    pub fn open(bytes: &'a [u8]) -> Result<Self, OpenError> {
        let section_count = check_header(bytes)?;
        let asset = Self { bytes, section_count };
        asset.check_table()?;
        Ok(asset)
    }

    /// The sections in the order of the table, known or not.
    pub fn sections(&self) -> impl ExactSizeIterator<Item = Section<'a>> + use<'a> {
        let bytes = self.bytes;
        (0..self.section_count).map(move |index| Section::new(bytes, entry(bytes, index)))
    }

    /// The section of that kind, if there is one.
    #[must_use]
    pub fn section(&self, kind: SectionKind) -> Option<Section<'a>> {
        self.sections().find(|section| section.kind() == kind)
    }

    /// Major and minor version of the file. The major is always [`MAJOR`].
    #[must_use]
    pub fn version(&self) -> (u16, u16) {
        (u16_at(self.bytes, MAJOR_AT), u16_at(self.bytes, MINOR_AT))
    }

    /// BLAKE3 of the uncompressed content, as the file states it; the same for any codec.
    #[must_use]
    pub fn identity(&self) -> [u8; 32] {
        array_at(self.bytes, IDENTITY_AT)
    }

    /// Bits of features that a reader may ignore.
    #[must_use]
    pub fn optional_features(&self) -> u64 {
        u64_at(self.bytes, OPTIONAL_AT)
    }

    /// Length of the file in bytes.
    #[must_use]
    pub fn file_size(&self) -> u64 {
        self.bytes.len() as u64
    }

    /// The whole file.
    #[must_use]
    pub fn bytes(&self) -> &'a [u8] {
        self.bytes
    }

    /// Every row is sound, and each section starts where the one before it lets it start.
    fn check_table(&self) -> Result<(), OpenError> {
        let newer_minor = is_newer_minor(self.bytes);
        let mut end = table_end(self.section_count);
        for index in 0..self.section_count {
            let entry = entry(self.bytes, index);
            let refuse = |fault| Err(OpenError::Section { index, kind: entry.kind, fault });
            if let Some(fault) = entry.fault(newer_minor) {
                return refuse(fault);
            }
            if (0..index).any(|before| kind(self.bytes, before) == entry.kind) {
                return refuse(SectionFault::Duplicate);
            }
            end = match place(&entry, end, self.file_size()) {
                Ok(end) => end,
                Err(fault) => return refuse(fault),
            };
        }
        if end != self.file_size() {
            return Err(OpenError::End { sections_end: end, file_size: self.file_size() });
        }
        Ok(())
    }
}

/// The end of a section that follows one ending at `previous_end`.
fn place(entry: &Entry, previous_end: u64, file_size: u64) -> Result<u64, SectionFault> {
    let beyond = SectionFault::Extent { offset: entry.offset, stored: entry.stored_length, file_size };
    let expected = align_up(previous_end, SECTION_ALIGN).ok_or(beyond)?;
    if entry.offset != expected {
        return Err(SectionFault::Offset { found: entry.offset, expected });
    }
    entry.end().filter(|&end| end <= file_size).ok_or(beyond)
}

/// Checks all of the header and returns the section count, whose rows are inside the file.
fn check_header(bytes: &[u8]) -> Result<u32, OpenError> {
    let actual = bytes.len() as u64;
    if let Some(start) = bytes.get(..MAGIC.len())
        && start != MAGIC
    {
        return Err(OpenError::Magic { found: array_at(bytes, 0) });
    }
    if bytes.len() < HEADER_BYTES {
        return Err(OpenError::TooShort { length: actual });
    }
    let major = u16_at(bytes, MAJOR_AT);
    if major != MAJOR {
        return Err(OpenError::Major { found: major });
    }
    let stated = u64_at(bytes, FILE_SIZE_AT);
    if stated != actual {
        return Err(OpenError::FileSize { stated, actual });
    }
    let section_count = u32_at(bytes, SECTION_COUNT_AT);
    if section_count == 0 || section_count > MAX_SECTIONS || table_end(section_count) > actual {
        return Err(OpenError::SectionCount { found: section_count });
    }
    check_header_crc(&bytes[..table_end(section_count) as usize])?;
    check_features(bytes)?;
    Ok(section_count)
}

fn check_header_crc(header: &[u8]) -> Result<(), OpenError> {
    let (stated, computed) = (u32_at(header, HEADER_CRC_AT), crc::of_header(header, HEADER_CRC_AT));
    if stated != computed {
        return Err(OpenError::HeaderCrc { stated, computed });
    }
    Ok(())
}

fn check_features(bytes: &[u8]) -> Result<(), OpenError> {
    let unknown = u64_at(bytes, REQUIRED_AT);
    if unknown != 0 {
        return Err(OpenError::RequiredFeatures { unknown });
    }
    match first_nonzero(&bytes[RESERVED_AT..HEADER_BYTES]) {
        Some(at) if !is_newer_minor(bytes) => Err(OpenError::ReservedHeader { offset: (RESERVED_AT + at) as u64 }),
        _ => Ok(()),
    }
}

fn is_newer_minor(bytes: &[u8]) -> bool {
    u16_at(bytes, MINOR_AT) > MINOR
}

/// Offset behind the section table; `section_count` fits u32, so this fits u64 with room to spare.
pub(crate) fn table_end(section_count: u32) -> u64 {
    HEADER_BYTES as u64 + u64::from(section_count) * ENTRY_BYTES as u64
}

fn row(bytes: &[u8], index: u32) -> &[u8] {
    let at = HEADER_BYTES + index as usize * ENTRY_BYTES;
    &bytes[at..at + ENTRY_BYTES]
}

fn entry(bytes: &[u8], index: u32) -> Entry {
    Entry::read(row(bytes, index))
}

fn kind(bytes: &[u8], index: u32) -> SectionKind {
    SectionKind(array_at(row(bytes, index), 0))
}
