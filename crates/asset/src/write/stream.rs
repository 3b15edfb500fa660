//! A file written as its tables come, without holding them in memory.
//!
//! A raw table has its place in the file from the moment it is opened, and its layers go there in any order, so that a
//! baker may fill several tables in turn. A table that is to be compressed has no length before its last layer: it is
//! kept in memory, compressed and placed when it is closed. So sections stand in the file in the order in which raw
//! tables were opened and everything else was completed.

use std::io::{Read, Seek, Write};
use std::vec;
use std::vec::Vec;

use super::curvature::EncodedCurvature;
use super::error::WriteError;
use super::layout::{Finished, Layout};
use super::tables::TextureTable;
use crate::asset::HEADER_BYTES;
use crate::bytes::SECTION_ALIGN;
use crate::entry::{CRITICAL, ENTRY_BYTES, Entry, MAX_DESCRIPTOR_BYTES};
use crate::{Asset, CURVATURE_VERSION, Codec, Limits, SectionKind, TextureDescriptor};

/// Effort of zstd: the decoder's speed does not depend on it.
const ZSTD_LEVEL: i32 = 9;
/// Sections whose table ends before the first page does.
const USUAL_ROOM: u32 = (SECTION_ALIGN as u32 - HEADER_BYTES as u32) / ENTRY_BYTES as u32;

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

/// A table whose layers are still coming.
#[derive(Debug)]
struct OpenTable {
    descriptor: TextureDescriptor,
    written: Vec<bool>,
    place: Place,
}

/// Where the layers of an open table go.
#[derive(Debug)]
enum Place {
    /// Into the payload of this row.
    File(usize),
    /// Into memory, to be compressed.
    Memory(Vec<u8>),
}

/// Writes a file section by section, layer by layer. The same sections give the same bytes as an
/// [`crate::AssetWriter`], which is one of these over memory.
///
/// A raw table has its place from the moment it is opened, and needs no memory of its size. A table that is to be
/// compressed is kept in memory until it is closed. Sections stand in the file in the order in which raw tables were
/// opened and everything else was completed.
///
/// `out` must be empty; it is written from its start, and read back once at the end. An error leaves a file without
/// its magic, which no reader opens.
#[derive(Debug)]
pub struct AssetStream<W> {
    layout: Layout<W>,
    kinds: Vec<SectionKind>,
    open: Vec<OpenTable>,
}

impl<W: Read + Write + Seek> AssetStream<W> {
    /// A file of at most 62 sections, whose table fits the first page.
    #[must_use]
    pub fn new(out: W) -> Self {
        Self::with_room(out, USUAL_ROOM)
    }

    /// A file of about `sections` sections, at most [`crate::MAX_SECTIONS`]: of as many as leave its table on the same page.
    #[must_use]
    pub fn with_room(out: W, sections: u32) -> Self {
        Self { layout: Layout::new(out, sections), kinds: Vec::new(), open: Vec::new() }
    }

    /// Opens a table. Of the descriptor, which [`crate::TableEncoder::descriptor`] knows from the start, extent, format
    /// and section version count; the rest may change until it is closed.
    ///
    /// # Errors
    /// A descriptor outside the format, a kind that is already there, too many sections, a table that is to be
    /// compressed and does not fit into memory, or a failure of the file.
    pub fn open_table(&mut self, descriptor: &TextureDescriptor, codec: Codec) -> Result<(), WriteError> {
        let (kind, raw_length) = (descriptor.semantic.kind(), descriptor.payload_length());
        descriptor.check().map_err(|error| WriteError::Descriptor { kind, error })?;
        self.add_kind(kind)?;
        let place = match codec {
            Codec::Raw => {
                let entry = table_entry(descriptor, Codec::Raw, raw_length);
                Place::File(self.layout.place(entry)?)
            }
            Codec::Zstd => Place::Memory(zeroed(kind, raw_length)?),
        };
        let written = vec![false; descriptor.pictures() as usize];
        self.open.push(OpenTable { descriptor: *descriptor, written, place });
        Ok(())
    }

    /// Writes a layer of an open table, or a level of one with several: tight rows, as an encoder makes them. In any order;
    /// the last of two counts.
    ///
    /// # Errors
    /// A table that is not open, a layer it does not have or of another length, or a failure of the file.
    pub fn layer(&mut self, kind: SectionKind, layer: u32, bytes: &[u8]) -> Result<(), WriteError> {
        let index = self.find_open(kind)?;
        let OpenTable { descriptor, written, place } = &mut self.open[index];
        let (found, expected, layers) = (bytes.len() as u64, descriptor.picture_bytes(layer), descriptor.pictures());
        if layer >= layers || found != expected {
            return Err(WriteError::Layer { kind, layer, found, layers, expected });
        }
        let at = descriptor.picture_offset(layer);
        let padding = if layer + 1 < layers { descriptor.picture_offset(layer + 1) - at - expected } else { 0 };
        match place {
            Place::File(row) => self.layout.payload(*row, at, bytes, padding)?,
            Place::Memory(payload) => payload[at as usize..][..bytes.len()].copy_from_slice(bytes),
        }
        written[layer as usize] = true;
        Ok(())
    }

    /// Closes a table with its finished descriptor. [`Codec::Zstd`] is used only where it makes the section smaller.
    ///
    /// # Errors
    /// A table that is not open or lacks a layer, a descriptor outside the format or of other bytes, or a failure of the
    /// compressor or the file.
    pub fn close_table(&mut self, descriptor: &TextureDescriptor) -> Result<(), WriteError> {
        let kind = descriptor.semantic.kind();
        let index = self.find_open(kind)?;
        descriptor.check().map_err(|error| WriteError::Descriptor { kind, error })?;
        let table = &self.open[index];
        if !same_bytes(&table.descriptor, descriptor) {
            return Err(WriteError::Changed { kind });
        }
        if let Some(layer) = table.written.iter().position(|written| !written) {
            return Err(WriteError::MissingLayer { kind, layer: layer as u32 });
        }
        match self.open.swap_remove(index).place {
            Place::File(row) => self.layout.descriptor(row, &descriptor.to_bytes()),
            Place::Memory(payload) => self.compressed_table(descriptor, &payload),
        }
    }

    fn compressed_table(&mut self, descriptor: &TextureDescriptor, payload: &[u8]) -> Result<(), WriteError> {
        let entry = table_entry(descriptor, Codec::Zstd, payload.len() as u64);
        self.whole(entry, &descriptor.to_bytes(), payload, Codec::Zstd)
    }

    /// Adds a whole table, as a critical section if [`SectionKind::is_critical`], in the oldest version that can say
    /// what it is. [`Codec::Zstd`] is used only where it makes the section smaller.
    ///
    /// # Errors
    /// A kind that is already there, too many sections, or a failure of the compressor or the file.
    pub fn add_table(&mut self, table: &TextureTable, codec: Codec) -> Result<&mut Self, WriteError> {
        self.add_kind(table.kind())?;
        let entry = table_entry(table.descriptor(), codec, table.payload().len() as u64);
        self.whole(entry, &table.descriptor().to_bytes(), table.payload(), codec)?;
        Ok(self)
    }

    /// Adds the curvature of a mesh, as a critical section. [`Codec::Zstd`] is used only where it makes the section smaller.
    ///
    /// # Errors
    /// A curvature that is already there, too many sections, or a failure of the compressor or the file.
    pub fn add_curvature(&mut self, table: &EncodedCurvature, codec: Codec) -> Result<&mut Self, WriteError> {
        let (kind, mut descriptor) = (SectionKind::CURVATURE, Vec::new());
        table.descriptor().write(&mut descriptor);
        let (critical, version, payload) = (kind.is_critical(), CURVATURE_VERSION, table.payload());
        self.raw_section(&RawSection { kind, critical, version, descriptor: &descriptor, payload }, codec)
    }

    /// Adds the provenance, a JSON text, as a raw ancillary section.
    ///
    /// # Errors
    /// A provenance that is already there, an empty text, too many sections, or a failure of the file.
    pub fn provenance(&mut self, json: &str) -> Result<&mut Self, WriteError> {
        let kind = SectionKind::PROVENANCE;
        let section = RawSection { kind, critical: false, version: 1, descriptor: &[], payload: json.as_bytes() };
        self.raw_section(&section, Codec::Raw)
    }

    /// Adds a section of any kind as it is. Nothing but the container's own rules is checked.
    ///
    /// # Errors
    /// A malformed kind or one that is already there, a descriptor that is too long, a section without bytes, too many
    /// sections, or a failure of the compressor or the file.
    pub fn raw_section(&mut self, section: &RawSection<'_>, codec: Codec) -> Result<&mut Self, WriteError> {
        let RawSection { kind, critical, version, descriptor, payload } = *section;
        check_bytes(kind, descriptor, payload)?;
        self.add_kind(kind)?;
        let flags = if critical { CRITICAL } else { 0 };
        let lengths = (descriptor.len() as u32, payload.len() as u64);
        self.whole(entry(kind, flags, version, lengths), descriptor, payload, codec)?;
        Ok(self)
    }

    /// Adds every ancillary section of `asset` that this version does not know, bytes as they are, so that rewriting a
    /// file loses nothing. A kind that was already added is left out: what was added replaces it.
    ///
    /// # Errors
    /// A section that is damaged, in an unknown codec, or larger than `limits` once decoded; too many sections, or a
    /// failure of the file.
    pub fn copy_unknown(&mut self, asset: &Asset<'_>, limits: &Limits) -> Result<&mut Self, WriteError> {
        for section in asset.sections().filter(|section| !section.is_known()) {
            let kind = section.kind();
            if self.kinds.contains(&kind) {
                continue;
            }
            if !section.is_intact() {
                return Err(WriteError::Damaged { kind });
            }
            section.payload(limits).map_err(|error| WriteError::Copy { kind, error })?;
            self.add_kind(kind)?;
            let descriptor = section.descriptor_bytes();
            let lengths = (descriptor.len() as u32, section.raw_length());
            let entry = Entry { codec: section.codec_number(), ..entry(kind, 0, section.version(), lengths) };
            self.stored(entry, descriptor, section.stored_payload())?;
        }
        Ok(self)
    }

    /// Completes checksums, identity, section table and header.
    ///
    /// # Errors
    /// A table that is still open, no section, fewer than room was made for, or a failure of the file.
    pub fn finish(self) -> Result<Finished<W>, WriteError> {
        match self.open.first() {
            Some(table) => Err(WriteError::NotClosed { kind: table.descriptor.semantic.kind() }),
            None => self.layout.finish(),
        }
    }

    /// Places a section and writes all of it, compressed where that makes it smaller.
    fn whole(&mut self, entry: Entry, descriptor: &[u8], payload: &[u8], codec: Codec) -> Result<(), WriteError> {
        if codec == Codec::Zstd {
            let compressed = zstd::bulk::compress(payload, ZSTD_LEVEL);
            let frame = compressed.map_err(|error| WriteError::Zstd { kind: entry.kind, error })?;
            if frame.len() < payload.len() {
                return self.stored(Entry { codec: Codec::Zstd.number(), ..entry }, descriptor, &frame);
            }
        }
        self.stored(Entry { codec: Codec::Raw.number(), ..entry }, descriptor, payload)
    }

    /// Places a section whose payload is in its codec already, and writes all of it.
    fn stored(&mut self, entry: Entry, descriptor: &[u8], stored: &[u8]) -> Result<(), WriteError> {
        let row = self.layout.place(Entry { stored_length: stored.len() as u64, ..entry })?;
        self.layout.descriptor(row, descriptor)?;
        self.layout.payload(row, 0, stored, 0)
    }

    /// Takes note of a kind that is new and still has room.
    fn add_kind(&mut self, kind: SectionKind) -> Result<(), WriteError> {
        if self.kinds.contains(&kind) {
            return Err(WriteError::Duplicate { kind });
        }
        // Too few sections may still become enough.
        match self.layout.check_count(self.kinds.len() + 1) {
            Err(WriteError::SectionCount { found, min, max }) if found > max as usize => {
                return Err(WriteError::SectionCount { found, min, max });
            }
            _ => self.kinds.push(kind),
        }
        Ok(())
    }

    fn find_open(&self, kind: SectionKind) -> Result<usize, WriteError> {
        let index = self.open.iter().position(|table| table.descriptor.semantic.kind() == kind);
        index.ok_or(WriteError::NotOpen { kind })
    }
}

/// A row of those lengths, stored as it is, that does not know its place yet.
fn entry(kind: SectionKind, flags: u32, version: u16, (descriptor_length, raw_length): (u32, u64)) -> Entry {
    Entry {
        kind,
        flags,
        version,
        codec: Codec::Raw.number(),
        descriptor_length,
        offset: 0,
        stored_length: raw_length,
        raw_length,
        crc32: 0,
        reserved_set: None,
    }
}

fn table_entry(descriptor: &TextureDescriptor, codec: Codec, raw_length: u64) -> Entry {
    let kind = descriptor.semantic.kind();
    let flags = if kind.is_critical() { CRITICAL } else { 0 };
    let lengths = (descriptor.to_bytes().len() as u32, raw_length);
    Entry { codec: codec.number(), ..entry(kind, flags, descriptor.section_version(), lengths) }
}

fn check_bytes(kind: SectionKind, descriptor: &[u8], payload: &[u8]) -> Result<(), WriteError> {
    if !kind.is_well_formed() {
        return Err(WriteError::Kind { kind });
    }
    if descriptor.len() > MAX_DESCRIPTOR_BYTES as usize {
        return Err(WriteError::DescriptorLength { kind, length: descriptor.len() });
    }
    if descriptor.is_empty() && payload.is_empty() {
        return Err(WriteError::Empty { kind });
    }
    Ok(())
}

/// Whether a section with one descriptor has the bytes of one with the other.
fn same_bytes(a: &TextureDescriptor, b: &TextureDescriptor) -> bool {
    let shape = |d: &TextureDescriptor| (d.format, d.width, d.height, d.layers, d.section_version());
    shape(a) == shape(b)
}

fn zeroed(kind: SectionKind, bytes: u64) -> Result<Vec<u8>, WriteError> {
    let none = WriteError::OutOfMemory { kind, bytes };
    let Ok(length) = usize::try_from(bytes) else { return Err(none) };
    let mut out = Vec::new();
    if out.try_reserve_exact(length).is_err() {
        return Err(none);
    }
    out.resize(length, 0);
    Ok(out)
}
