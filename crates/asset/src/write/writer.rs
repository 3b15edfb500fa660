//! Sections to the bytes of a file. The same calls give the same bytes.

use std::vec;
use std::vec::Vec;

use super::encode::EncodeError;
use super::identity::IdentityHasher;
use super::tables::TextureTable;
use crate::asset::{
    FILE_SIZE_AT, HEADER_BYTES, HEADER_CRC_AT, IDENTITY_AT, MAGIC, MAJOR_AT, MINOR_AT, SECTION_COUNT_AT, table_end,
};
use crate::bytes::{CHUNK_ALIGN, SECTION_ALIGN, align_up, put};
use crate::entry::{CRITICAL, ENTRY_BYTES, Entry, MAX_DESCRIPTOR_BYTES};
use crate::{Asset, Codec, Limits, MAJOR, MAX_SECTIONS, MINOR, PayloadError, SectionKind, crc};

/// Effort of zstd: the decoder's speed does not depend on it.
const ZSTD_LEVEL: i32 = 9;

/// Why a file could not be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum WriteError {
    /// Values that the encoding cannot hold.
    #[error(transparent)]
    Encode(#[from] EncodeError),
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
    /// A file without sections, or with too many.
    #[error("there are {found} sections; 1 to {MAX_SECTIONS} are accepted")]
    SectionCount {
        /// How many there are.
        found: usize,
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
}

/// A section of any kind, its payload not yet compressed.
#[derive(Debug, Clone, Copy)]
pub struct RawSection<'a> {
    /// What it holds.
    pub kind: SectionKind,
    /// Whether a reader that does not know the kind must refuse the file.
    pub critical: bool,
    /// The version of its layout.
    pub version: u16,
    /// Its descriptor, at most 64 KiB; may be empty.
    pub descriptor: &'a [u8],
    /// Its payload; may be empty if the descriptor is not.
    pub payload: &'a [u8],
}

/// A section as it goes into the file.
struct Pending {
    entry: Entry,
    descriptor: Vec<u8>,
    stored: Vec<u8>,
}

/// Gathers sections and lays them out. Sections stand in the file in the order in which they were added.
#[derive(Default)]
pub struct AssetWriter {
    sections: Vec<Pending>,
    identity: IdentityHasher,
}

impl AssetWriter {
    /// A file without sections.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a table, as a critical section if [`SectionKind::is_critical`], in the oldest version that can say what it is. [`Codec::Zstd`] is used only where it makes the section smaller.
    ///
    /// # Errors
    /// A kind that is already there, or a failure of the compressor.
    pub fn add_table(&mut self, table: TextureTable, codec: Codec) -> Result<&mut Self, WriteError> {
        let kind = table.kind();
        let flags = if kind.is_critical() { CRITICAL } else { 0 };
        let entry = blank_entry(kind, flags, table.descriptor().section_version());
        let (descriptor, payload) = table.into_parts();
        self.add(entry, descriptor.to_bytes().to_vec(), payload, codec)
    }

    /// Adds the provenance, a JSON text, as a raw ancillary section.
    ///
    /// # Errors
    /// A provenance that is already there, or an empty text.
    pub fn provenance(&mut self, json: &str) -> Result<&mut Self, WriteError> {
        let entry = blank_entry(SectionKind::PROVENANCE, 0, 1);
        self.add(entry, Vec::new(), json.as_bytes().to_vec(), Codec::Raw)
    }

    /// Adds a section of any kind as it is. Nothing but the container's own rules is checked.
    ///
    /// # Errors
    /// A malformed kind or one that is already there, a descriptor that is too long, a section without bytes, or a
    /// failure of the compressor.
    pub fn raw_section(&mut self, section: &RawSection<'_>, codec: Codec) -> Result<&mut Self, WriteError> {
        let entry = blank_entry(section.kind, if section.critical { CRITICAL } else { 0 }, section.version);
        self.add(entry, section.descriptor.to_vec(), section.payload.to_vec(), codec)
    }

    /// Adds every ancillary section of `asset` that this version does not know, bytes as they are, so that rewriting a
    /// file loses nothing. A kind that was already added is left out: what was added replaces it.
    ///
    /// # Errors
    /// A section that is damaged, in an unknown codec, or larger than `limits` once decoded.
    pub fn copy_unknown(&mut self, asset: &Asset<'_>, limits: &Limits) -> Result<&mut Self, WriteError> {
        for section in asset.sections().filter(|section| !section.is_known()) {
            let kind = section.kind();
            if self.has(kind) {
                continue;
            }
            if !section.is_intact() {
                return Err(WriteError::Damaged { kind });
            }
            let payload = section.payload(limits).map_err(|error| WriteError::Copy { kind, error })?;
            let mut entry = blank_entry(kind, 0, section.version());
            entry.codec = section.codec_number();
            entry.raw_length = section.raw_length();
            self.identity.section(kind, entry.version, section.descriptor_bytes(), &payload);
            self.push(entry, section.descriptor_bytes().to_vec(), section.stored_payload().to_vec());
        }
        Ok(self)
    }

    /// The bytes of the file.
    ///
    /// # Errors
    /// No section, or more than [`MAX_SECTIONS`].
    pub fn finish(self) -> Result<Vec<u8>, WriteError> {
        let found = self.sections.len();
        let count = u32::try_from(found).unwrap_or(u32::MAX);
        if count == 0 || count > MAX_SECTIONS {
            return Err(WriteError::SectionCount { found });
        }
        let mut file = vec![0; table_end(count) as usize];
        for (index, section) in self.sections.into_iter().enumerate() {
            let row = lay_out(section, &mut file);
            put(&mut file, HEADER_BYTES + index * ENTRY_BYTES, &row);
        }
        let file_size = file.len() as u64;
        put(&mut file, 0, &MAGIC);
        put(&mut file, MAJOR_AT, &MAJOR.to_le_bytes());
        put(&mut file, MINOR_AT, &MINOR.to_le_bytes());
        put(&mut file, FILE_SIZE_AT, &file_size.to_le_bytes());
        put(&mut file, SECTION_COUNT_AT, &count.to_le_bytes());
        put(&mut file, IDENTITY_AT, &self.identity.finish());
        let crc = crc::of_header(&file[..table_end(count) as usize], HEADER_CRC_AT);
        put(&mut file, HEADER_CRC_AT, &crc.to_le_bytes());
        Ok(file)
    }

    fn has(&self, kind: SectionKind) -> bool {
        self.sections.iter().any(|section| section.entry.kind == kind)
    }

    fn add(
        &mut self,
        mut entry: Entry,
        descriptor: Vec<u8>,
        payload: Vec<u8>,
        codec: Codec,
    ) -> Result<&mut Self, WriteError> {
        let kind = entry.kind;
        if !kind.is_well_formed() {
            return Err(WriteError::Kind { kind });
        }
        if self.has(kind) {
            return Err(WriteError::Duplicate { kind });
        }
        if descriptor.len() > MAX_DESCRIPTOR_BYTES as usize {
            return Err(WriteError::DescriptorLength { kind, length: descriptor.len() });
        }
        if descriptor.is_empty() && payload.is_empty() {
            return Err(WriteError::Empty { kind });
        }
        self.identity.section(kind, entry.version, &descriptor, &payload);
        entry.raw_length = payload.len() as u64;
        let (codec, stored) = compress(payload, codec).map_err(|error| WriteError::Zstd { kind, error })?;
        entry.codec = codec.number();
        self.push(entry, descriptor, stored);
        Ok(self)
    }

    fn push(&mut self, mut entry: Entry, descriptor: Vec<u8>, stored: Vec<u8>) {
        entry.descriptor_length = descriptor.len() as u32;
        entry.stored_length = stored.len() as u64;
        self.sections.push(Pending { entry, descriptor, stored });
    }
}

/// A row that knows neither its bytes nor its place yet.
fn blank_entry(kind: SectionKind, flags: u32, version: u16) -> Entry {
    Entry {
        kind,
        flags,
        version,
        codec: 0,
        descriptor_length: 0,
        offset: 0,
        stored_length: 0,
        raw_length: 0,
        crc32: 0,
        reserved_set: None,
    }
}

/// `payload` in `codec`, or as it is where that is not smaller.
fn compress(payload: Vec<u8>, codec: Codec) -> std::io::Result<(Codec, Vec<u8>)> {
    if codec == Codec::Zstd {
        let frame = zstd::bulk::compress(&payload, ZSTD_LEVEL)?;
        if frame.len() < payload.len() {
            return Ok((Codec::Zstd, frame));
        }
    }
    Ok((Codec::Raw, payload))
}

/// Appends the bytes of `section` to `file` and returns its row of the table.
fn lay_out(section: Pending, file: &mut Vec<u8>) -> [u8; ENTRY_BYTES] {
    let Pending { mut entry, descriptor, stored } = section;
    pad(file, SECTION_ALIGN);
    let start = file.len();
    file.extend_from_slice(&descriptor);
    pad(file, CHUNK_ALIGN);
    file.extend_from_slice(&stored);
    entry.offset = start as u64;
    entry.crc32 = crc::update(0, &file[start..]);
    entry.to_bytes()
}

/// Appends zeros up to a multiple of `align`.
fn pad(file: &mut Vec<u8>, align: u64) {
    let length = align_up(file.len() as u64, align).map_or(usize::MAX, |length| length as usize);
    file.resize(length, 0);
}
