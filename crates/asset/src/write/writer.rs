//! A file in memory.

use std::io::Cursor;
use std::vec::Vec;

use super::curvature::EncodedCurvature;
use super::error::WriteError;
use super::stream::{AssetStream, RawSection};
use super::tables::TextureTable;
use crate::{Asset, Codec, Limits};

/// Gathers sections into the bytes of a file. They stand in it in the order in which they were added; the same calls give
/// the same bytes.
#[derive(Debug)]
pub struct AssetWriter {
    stream: AssetStream<Cursor<Vec<u8>>>,
}

impl Default for AssetWriter {
    fn default() -> Self {
        Self::new()
    }
}

impl AssetWriter {
    /// A file without sections, of which it can take 62.
    #[must_use]
    pub fn new() -> Self {
        Self { stream: AssetStream::new(Cursor::default()) }
    }

    /// A file of about `sections` sections: [`AssetStream::with_room`].
    #[must_use]
    pub fn with_room(sections: u32) -> Self {
        Self { stream: AssetStream::with_room(Cursor::default(), sections) }
    }

    /// Adds a table: [`AssetStream::add_table`].
    ///
    /// # Errors
    /// A kind that is already there, too many sections, or a failure of the compressor.
    #[allow(clippy::needless_pass_by_value, reason = "the table is freed as soon as the file has it")]
    pub fn add_table(&mut self, table: TextureTable, codec: Codec) -> Result<&mut Self, WriteError> {
        self.stream.add_table(&table, codec)?;
        Ok(self)
    }

    /// Adds the curvature of a mesh: [`AssetStream::add_curvature`].
    ///
    /// # Errors
    /// A curvature that is already there, too many sections, or a failure of the compressor.
    #[allow(clippy::needless_pass_by_value, reason = "the table is freed as soon as the file has it")]
    pub fn add_curvature(&mut self, table: EncodedCurvature, codec: Codec) -> Result<&mut Self, WriteError> {
        self.stream.add_curvature(&table, codec)?;
        Ok(self)
    }

    /// Adds the provenance, a JSON text, as a raw ancillary section.
    ///
    /// # Errors
    /// A provenance that is already there, an empty text, or too many sections.
    pub fn provenance(&mut self, json: &str) -> Result<&mut Self, WriteError> {
        self.stream.provenance(json)?;
        Ok(self)
    }

    /// Adds a section of any kind as it is: [`AssetStream::raw_section`].
    ///
    /// # Errors
    /// A malformed kind or one that is already there, a descriptor that is too long, a section without bytes, too many
    /// sections, or a failure of the compressor.
    pub fn raw_section(&mut self, section: &RawSection<'_>, codec: Codec) -> Result<&mut Self, WriteError> {
        self.stream.raw_section(section, codec)?;
        Ok(self)
    }

    /// Adds what this version does not know of another file: [`AssetStream::copy_unknown`].
    ///
    /// # Errors
    /// A section that is damaged, in an unknown codec, or larger than `limits` once decoded; or too many sections.
    pub fn copy_unknown(&mut self, asset: &Asset<'_>, limits: &Limits) -> Result<&mut Self, WriteError> {
        self.stream.copy_unknown(asset, limits)?;
        Ok(self)
    }

    /// The bytes of the file.
    ///
    /// # Errors
    /// No section, or fewer than room was made for.
    pub fn finish(self) -> Result<Vec<u8>, WriteError> {
        Ok(self.stream.finish()?.out.into_inner())
    }
}
