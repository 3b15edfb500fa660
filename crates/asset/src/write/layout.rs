//! Where sections lie in a file, and what is only known when all of them are there. The one way to lay out a file.
//!
//! A section is placed when its length is known, and filled in any order. Checksums and the identity run over a
//! descriptor before its payload, though the descriptor is known last: so everything is read back once, in bounded
//! pieces, before the header is written. A file that was not finished has no magic.

use std::io::{Read, Seek, SeekFrom, Write};
use std::vec;
use std::vec::Vec;

use super::error::WriteError;
use super::identity::IdentityHasher;
use crate::asset::{
    FILE_SIZE_AT, HEADER_BYTES, HEADER_CRC_AT, IDENTITY_AT, MAGIC, MAJOR_AT, MINOR_AT, SECTION_COUNT_AT, table_end,
};
use crate::bytes::{SECTION_ALIGN, align_up, put};
use crate::entry::{ENTRY_BYTES, Entry};
use crate::{Codec, MAJOR, MAX_SECTIONS, MINOR, SectionKind, crc};

/// What is read back at once.
const CHUNK_BYTES: usize = 1 << 20;

/// A finished file.
#[derive(Debug)]
pub struct Finished<W> {
    /// What was written to, flushed.
    pub out: W,
    /// Length of the file.
    pub bytes: u64,
    /// BLAKE3 of the uncompressed content.
    pub identity: [u8; 32],
    /// The length of each section's payload in the file, in the order of the file.
    pub stored_lengths: Vec<(SectionKind, u64)>,
}

/// A file under construction.
#[derive(Debug)]
pub(super) struct Layout<W> {
    out: W,
    rows: Vec<Entry>,
    /// Where the first section starts.
    start: u64,
    /// Where the last section ends.
    end: u64,
    /// Something could not be written: what is there is not what was asked for.
    failed: bool,
}

impl<W: Read + Write + Seek> Layout<W> {
    /// A file with room in its table for as many sections as fit the page that `sections` rows end in.
    pub(super) fn new(out: W, sections: u32) -> Self {
        let start = first_offset(sections.clamp(1, MAX_SECTIONS));
        Self { out, rows: Vec::new(), start, end: start, failed: false }
    }

    /// Refuses a number of sections that would move the first one.
    pub(super) fn check_count(&self, found: usize) -> Result<(), WriteError> {
        let fitting = |start: u64| start.saturating_sub(HEADER_BYTES as u64) as u32 / ENTRY_BYTES as u32;
        let (min, max) = (fitting(self.start - SECTION_ALIGN) + 1, fitting(self.start).min(MAX_SECTIONS));
        let fits = u32::try_from(found).is_ok_and(|count| (min..=max).contains(&count));
        if fits { Ok(()) } else { Err(WriteError::SectionCount { found, min, max }) }
    }

    /// Gives a section whose lengths are known its place behind all others, and returns its row.
    pub(super) fn place(&mut self, mut entry: Entry) -> Result<usize, WriteError> {
        let unplaceable = || io_error("written", u64::MAX, std::io::ErrorKind::FileTooLarge.into());
        if !self.rows.is_empty() {
            entry.offset = align_up(self.end, SECTION_ALIGN).ok_or_else(unplaceable)?;
            self.zeros(self.end, entry.offset)?;
        } else {
            entry.offset = self.start;
        }
        self.end = entry.end().ok_or_else(unplaceable)?;
        self.rows.push(entry);
        Ok(self.rows.len() - 1)
    }

    /// Writes the descriptor of a placed section, and the padding behind it.
    pub(super) fn descriptor(&mut self, row: usize, descriptor: &[u8]) -> Result<(), WriteError> {
        let entry = self.rows[row];
        self.put(entry.offset, descriptor)?;
        self.zeros(entry.offset + descriptor.len() as u64, payload_offset(&entry))
    }

    /// Writes a part of the payload of a placed section, and zeros behind it.
    pub(super) fn payload(&mut self, row: usize, at: u64, bytes: &[u8], zeros: u64) -> Result<(), WriteError> {
        let offset = payload_offset(&self.rows[row]) + at;
        let end = offset + bytes.len() as u64;
        self.put(offset, bytes)?;
        self.zeros(end, end + zeros)
    }

    fn put(&mut self, offset: u64, bytes: &[u8]) -> Result<(), WriteError> {
        let written = self.out.seek(SeekFrom::Start(offset)).and_then(|_| self.out.write_all(bytes));
        self.failed |= written.is_err();
        written.map_err(|error| io_error("written", offset, error))
    }

    fn zeros(&mut self, from: u64, to: u64) -> Result<(), WriteError> {
        const ZEROS: [u8; SECTION_ALIGN as usize] = [0; SECTION_ALIGN as usize];
        // Padding is shorter than an alignment, so one piece is enough.
        let length = to.saturating_sub(from).min(SECTION_ALIGN) as usize;
        if length == 0 { Ok(()) } else { self.put(from, &ZEROS[..length]) }
    }

    /// Reads everything back for checksums and identity, and writes the header.
    pub(super) fn finish(mut self) -> Result<Finished<W>, WriteError> {
        if self.failed {
            return Err(WriteError::Failed);
        }
        self.check_count(self.rows.len())?;
        let mut identity = IdentityHasher::default();
        let mut buffer = vec![0; CHUNK_BYTES];
        for row in 0..self.rows.len() {
            let entry = self.rows[row];
            self.rows[row].crc32 = self.read_section(&entry, &mut identity, &mut buffer)?;
        }
        let identity = identity.finish();
        self.header(&identity)?;
        self.out.flush().map_err(|error| io_error("flushed", self.end, error))?;
        let stored_lengths = self.rows.iter().map(|entry| (entry.kind, entry.stored_length)).collect();
        Ok(Finished { out: self.out, bytes: self.end, identity, stored_lengths })
    }

    /// Adds a section to the identity and returns its CRC-32.
    fn read_section(
        &mut self,
        entry: &Entry,
        identity: &mut IdentityHasher,
        buffer: &mut [u8],
    ) -> Result<u32, WriteError> {
        let mut descriptor = vec![0; entry.descriptor_length as usize];
        self.read(entry.offset, &mut descriptor)?;
        identity.begin(entry.kind, entry.version, &descriptor, entry.raw_length);
        let raw = entry.codec == Codec::Raw.number();
        let (mut at, payload_at) = (entry.offset, payload_offset(entry));
        let (end, mut crc) = (payload_at + entry.stored_length, 0);
        while at < end {
            // No piece lies in both the descriptor's part and the payload.
            let piece_end = if at < payload_at { payload_at } else { end };
            let piece = &mut buffer[..(piece_end - at).min(CHUNK_BYTES as u64) as usize];
            self.read(at, piece)?;
            crc = crc::update(crc, piece);
            if raw && at >= payload_at {
                identity.payload(piece);
            }
            at += piece.len() as u64;
        }
        if !raw {
            self.decode_payload(entry, identity, buffer)?;
        }
        Ok(crc)
    }

    /// Adds the decoded payload of a zstd section to the identity.
    fn decode_payload(
        &mut self,
        entry: &Entry,
        identity: &mut IdentityHasher,
        buffer: &mut [u8],
    ) -> Result<(), WriteError> {
        let offset = payload_offset(entry);
        self.out.seek(SeekFrom::Start(offset)).map_err(|error| io_error("read back", offset, error))?;
        let failed = |error| WriteError::Zstd { kind: entry.kind, error };
        let mut decoder = zstd::Decoder::new((&mut self.out).take(entry.stored_length)).map_err(failed)?;
        loop {
            match decoder.read(buffer).map_err(failed)? {
                0 => return Ok(()),
                length => identity.payload(&buffer[..length]),
            }
        }
    }

    fn read(&mut self, offset: u64, buffer: &mut [u8]) -> Result<(), WriteError> {
        let read = self.out.seek(SeekFrom::Start(offset)).and_then(|_| self.out.read_exact(buffer));
        read.map_err(|error| io_error("read back", offset, error))
    }

    /// Header, section table and zeros up to the first section.
    fn header(&mut self, identity: &[u8; 32]) -> Result<(), WriteError> {
        let count = self.rows.len() as u32;
        let mut bytes = vec![0; self.start as usize];
        for (index, entry) in self.rows.iter().enumerate() {
            put(&mut bytes, HEADER_BYTES + index * ENTRY_BYTES, &entry.to_bytes());
        }
        put(&mut bytes, 0, &MAGIC);
        put(&mut bytes, MAJOR_AT, &MAJOR.to_le_bytes());
        put(&mut bytes, MINOR_AT, &MINOR.to_le_bytes());
        put(&mut bytes, FILE_SIZE_AT, &self.end.to_le_bytes());
        put(&mut bytes, SECTION_COUNT_AT, &count.to_le_bytes());
        put(&mut bytes, IDENTITY_AT, identity);
        let crc = crc::of_header(&bytes[..table_end(count) as usize], HEADER_CRC_AT);
        put(&mut bytes, HEADER_CRC_AT, &crc.to_le_bytes());
        self.put(0, &bytes)
    }
}

/// Where the first of so many sections starts.
fn first_offset(sections: u32) -> u64 {
    table_end(sections).next_multiple_of(SECTION_ALIGN)
}

/// Where the payload of a placed section starts: its end fits u64, so this does.
fn payload_offset(entry: &Entry) -> u64 {
    entry.payload_offset().unwrap_or(u64::MAX)
}

fn io_error(action: &'static str, offset: u64, error: std::io::Error) -> WriteError {
    WriteError::Io { action, offset, error }
}
