//! The first directory of a TIFF: tags and their values.

use super::damaged;
use crate::{DecodeError, limits::reserved};

/// The entries of a directory and how to read them.
pub(crate) struct Directory<'a> {
    bytes: &'a [u8],
    pub(crate) little_endian: bool,
    /// Offsets and counts have 8 bytes, not 4.
    big: bool,
    entries: Vec<Entry>,
}

struct Entry {
    tag: u16,
    kind: u16,
    count: u64,
    /// Where the value lies, or the offset of the value.
    value_at: usize,
}

impl<'a> Directory<'a> {
    pub(crate) fn open(bytes: &'a [u8]) -> Result<Self, DecodeError> {
        let little_endian = bytes.first() == Some(&b'I');
        let mut this = Self { bytes, little_endian, big: false, entries: Vec::new() };
        this.big = this.uint(2, 2) == Some(43);
        this.entries = this.read_entries().ok_or_else(|| damaged("its first directory is not within the file"))?;
        Ok(this)
    }

    fn read_entries(&self) -> Option<Vec<Entry>> {
        let (offset_at, count_bytes, entry_bytes) = if self.big { (8, 8, 20) } else { (4, 2, 12) };
        let start = usize::try_from(self.uint(offset_at, self.word())?).ok()?;
        let count = usize::try_from(self.uint(start, count_bytes)?).ok()?;
        let first = start.checked_add(count_bytes)?;
        // A count that is too high ends at the end of the file, by `None`.
        let entry = |i: usize| {
            let at = first.checked_add(i.checked_mul(entry_bytes)?)?;
            self.bytes.get(at..at.checked_add(entry_bytes)?)?;
            Some(Entry {
                tag: self.uint(at, 2)? as u16,
                kind: self.uint(at + 2, 2)? as u16,
                count: self.uint(at + 4, self.word())?,
                value_at: at + 4 + self.word(),
            })
        };
        (0..count).map(entry).collect()
    }

    fn word(&self) -> usize {
        if self.big { 8 } else { 4 }
    }

    fn uint(&self, at: usize, len: usize) -> Option<u64> {
        Some(self.to_uint(self.bytes.get(at..at.checked_add(len)?)?))
    }

    fn to_uint(&self, bytes: &[u8]) -> u64 {
        let append = |value: u64, byte: &u8| value << 8 | u64::from(*byte);
        if self.little_endian { bytes.iter().rev().fold(0, append) } else { bytes.iter().fold(0, append) }
    }

    pub(crate) fn has(&self, tag: u16) -> bool {
        self.entries.iter().any(|entry| entry.tag == tag)
    }

    /// The unsigned integers of a tag, at least one; `None` if the tag is not there.
    pub(crate) fn values(&self, tag: u16) -> Result<Option<Vec<u64>>, DecodeError> {
        self.value_bytes(tag, |kind| match kind {
            1 => Some(1),
            3 => Some(2),
            4 | 13 => Some(4),
            16 | 18 => Some(8),
            _ => None,
        })?
        .map(|(bytes, size)| {
            let mut values = reserved(bytes.len() / size)?;
            values.extend(bytes.chunks_exact(size).map(|value| self.to_uint(value)));
            Ok(values)
        })
        .transpose()
    }

    /// The characters of a tag; `None` if the tag is not there.
    pub(crate) fn text(&self, tag: u16) -> Result<Option<&'a [u8]>, DecodeError> {
        Ok(self.value_bytes(tag, |kind| (kind == 2).then_some(1))?.map(|(bytes, _)| bytes))
    }

    /// All bytes of a tag's value, and the bytes of one element. `size_of` knows the types that will do.
    fn value_bytes(
        &self,
        tag: u16,
        size_of: fn(u16) -> Option<usize>,
    ) -> Result<Option<(&'a [u8], usize)>, DecodeError> {
        let Some(entry) = self.entries.iter().find(|entry| entry.tag == tag) else {
            return Ok(None);
        };
        let value = || {
            let size = size_of(entry.kind)?;
            let len = usize::try_from(entry.count).ok()?.checked_mul(size).filter(|&len| len > 0)?;
            let at = if len <= self.word() {
                entry.value_at
            } else {
                usize::try_from(self.uint(entry.value_at, self.word())?).ok()?
            };
            Some((self.bytes.get(at..at.checked_add(len)?)?, size))
        };
        value().map(Some).ok_or_else(|| damaged(format!("its tag {tag} cannot be read")))
    }
}
