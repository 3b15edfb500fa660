//! One row of the section table, and the checks that need no other row.

use crate::bytes::{CHUNK_ALIGN, align_up, array_at, first_nonzero, u16_at, u32_at, u64_at};
use crate::{Codec, SectionFault, SectionKind};

/// Bytes of a row.
pub(crate) const ENTRY_BYTES: usize = 64;
/// The longest descriptor the format allows.
pub(crate) const MAX_DESCRIPTOR_BYTES: u32 = 65_536;
/// The only flag: a reader that does not know this section must refuse the file.
pub(crate) const CRITICAL: u32 = 1;

pub(crate) const VERSION_AT: usize = 8;
const RESERVED_AT: usize = 44;

#[derive(Debug, Clone, Copy)]
pub(crate) struct Entry {
    pub(crate) kind: SectionKind,
    pub(crate) flags: u32,
    pub(crate) version: u16,
    pub(crate) codec: u16,
    pub(crate) descriptor_length: u32,
    pub(crate) offset: u64,
    pub(crate) stored_length: u64,
    pub(crate) raw_length: u64,
    pub(crate) crc32: u32,
    /// Offset, within the row, of the first reserved byte that is not zero.
    pub(crate) reserved_set: Option<usize>,
}

impl Entry {
    /// Reads the 64 bytes of `row`; judges nothing.
    pub(crate) fn read(row: &[u8]) -> Self {
        Self {
            kind: SectionKind(array_at(row, 0)),
            flags: u32_at(row, 4),
            version: u16_at(row, VERSION_AT),
            codec: u16_at(row, 10),
            descriptor_length: u32_at(row, 12),
            offset: u64_at(row, 16),
            stored_length: u64_at(row, 24),
            raw_length: u64_at(row, 32),
            crc32: u32_at(row, 40),
            reserved_set: first_nonzero(&row[RESERVED_AT..ENTRY_BYTES]).map(|at| RESERVED_AT + at),
        }
    }

    /// The 64 bytes of the row.
    #[cfg(feature = "write")]
    pub(crate) fn to_bytes(self) -> [u8; ENTRY_BYTES] {
        use crate::bytes::put;

        let mut row = [0; ENTRY_BYTES];
        put(&mut row, 0, &self.kind.0);
        put(&mut row, 4, &self.flags.to_le_bytes());
        put(&mut row, VERSION_AT, &self.version.to_le_bytes());
        put(&mut row, 10, &self.codec.to_le_bytes());
        put(&mut row, 12, &self.descriptor_length.to_le_bytes());
        put(&mut row, 16, &self.offset.to_le_bytes());
        put(&mut row, 24, &self.stored_length.to_le_bytes());
        put(&mut row, 32, &self.raw_length.to_le_bytes());
        put(&mut row, 40, &self.crc32.to_le_bytes());
        row
    }

    /// Whether a reader that does not know the section must refuse the file.
    pub(crate) fn is_critical(&self) -> bool {
        self.flags & CRITICAL != 0
    }

    /// Whether this version of the crate knows both the kind and its version.
    pub(crate) fn is_known(&self) -> bool {
        self.kind.versions().contains(&self.version)
    }

    /// Offset of the payload in the file, or `None` beyond u64.
    pub(crate) fn payload_offset(&self) -> Option<u64> {
        self.offset.checked_add(align_up(u64::from(self.descriptor_length), CHUNK_ALIGN)?)
    }

    /// Offset behind the payload, or `None` beyond u64.
    pub(crate) fn end(&self) -> Option<u64> {
        self.payload_offset()?.checked_add(self.stored_length)
    }

    /// All that is wrong with the row by itself. In a file of a `newer_minor`, reserved bits may have a meaning that a
    /// reader is free to ignore.
    pub(crate) fn fault(&self, newer_minor: bool) -> Option<SectionFault> {
        self.unreadable(newer_minor).or_else(|| self.refused()).or_else(|| self.bad_length())
    }

    fn unreadable(&self, newer_minor: bool) -> Option<SectionFault> {
        if !self.kind.is_well_formed() {
            return Some(SectionFault::Kind);
        }
        if newer_minor {
            return None;
        }
        if self.flags & !CRITICAL != 0 {
            return Some(SectionFault::Flags { found: self.flags });
        }
        self.reserved_set.map(|offset| SectionFault::Reserved { offset })
    }

    fn refused(&self) -> Option<SectionFault> {
        if !self.is_critical() {
            return None;
        }
        if self.kind.name().is_none() {
            return Some(SectionFault::UnknownCritical);
        }
        if !self.is_known() {
            return Some(SectionFault::Version { found: self.version, newest: *self.kind.versions().end() });
        }
        match Codec::from_number(self.codec) {
            Some(_) => None,
            None => Some(SectionFault::Codec { found: self.codec }),
        }
    }

    fn bad_length(&self) -> Option<SectionFault> {
        let (stored, raw) = (self.stored_length, self.raw_length);
        if self.descriptor_length > MAX_DESCRIPTOR_BYTES {
            return Some(SectionFault::DescriptorLength { found: self.descriptor_length });
        }
        match Codec::from_number(self.codec) {
            Some(Codec::Raw) if stored != raw => Some(SectionFault::RawLength { stored, raw }),
            Some(Codec::Raw) if raw == 0 && self.descriptor_length == 0 => Some(SectionFault::Empty),
            Some(Codec::Zstd) if stored == 0 || raw == 0 => Some(SectionFault::Empty),
            None if stored == 0 => Some(SectionFault::Empty),
            _ => None,
        }
    }
}
