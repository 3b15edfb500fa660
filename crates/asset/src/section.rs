//! One section of an opened file.

use crate::entry::Entry;
use crate::{CurvatureDescriptor, CurvatureError, DescriptorError, SectionKind, Semantic, TextureDescriptor, crc};

/// How a payload is stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Codec {
    /// As it is.
    Raw,
    /// One zstd frame.
    Zstd,
}

impl Codec {
    /// The number in the file.
    #[must_use]
    pub fn number(self) -> u16 {
        match self {
            Self::Raw => 0,
            Self::Zstd => 1,
        }
    }

    /// The codec with that number, if this version knows it.
    #[must_use]
    pub fn from_number(number: u16) -> Option<Self> {
        match number {
            0 => Some(Self::Raw),
            1 => Some(Self::Zstd),
            _ => None,
        }
    }

    /// `raw` or `zstd`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Raw => "raw",
            Self::Zstd => "zstd",
        }
    }
}

/// One section of an opened file: its place is inside the file; its bytes have not been looked at.
#[derive(Debug, Clone, Copy)]
pub struct Section<'a> {
    file: &'a [u8],
    entry: Entry,
}

impl<'a> Section<'a> {
    /// `entry` has been placed inside `file`.
    pub(crate) fn new(file: &'a [u8], entry: Entry) -> Self {
        Self { file, entry }
    }

    /// What the section holds.
    #[must_use]
    pub fn kind(&self) -> SectionKind {
        self.entry.kind
    }

    /// The version of the section's own layout.
    #[must_use]
    pub fn version(&self) -> u16 {
        self.entry.version
    }

    /// Whether a reader that does not know the section must refuse the file.
    #[must_use]
    pub fn is_critical(&self) -> bool {
        self.entry.is_critical()
    }

    /// Whether this crate knows the kind and the version. Sections it does not know are to be skipped.
    #[must_use]
    pub fn is_known(&self) -> bool {
        self.entry.is_known()
    }

    /// How the payload is stored; `None` for a codec this version does not know.
    #[must_use]
    pub fn codec(&self) -> Option<Codec> {
        Codec::from_number(self.entry.codec)
    }

    /// The codec's number in the file.
    #[must_use]
    pub fn codec_number(&self) -> u16 {
        self.entry.codec
    }

    /// Where the section starts in the file, in bytes: a multiple of 4096.
    #[must_use]
    pub fn offset(&self) -> u64 {
        self.entry.offset
    }

    /// Where the payload starts in the file, in bytes: a multiple of 256.
    #[must_use]
    pub fn payload_offset(&self) -> u64 {
        self.end() - self.entry.stored_length
    }

    /// Offset behind the last byte of the section.
    pub(crate) fn end(&self) -> u64 {
        // `Asset::open` found the end inside the file.
        self.entry.end().unwrap_or(self.file.len() as u64)
    }

    /// Bytes of the payload in the file.
    #[must_use]
    pub fn stored_length(&self) -> u64 {
        self.entry.stored_length
    }

    /// Bytes of the decoded payload.
    #[must_use]
    pub fn raw_length(&self) -> u64 {
        self.entry.raw_length
    }

    /// CRC-32 of all stored bytes of the section, as the file states it.
    #[must_use]
    pub fn crc32(&self) -> u32 {
        self.entry.crc32
    }

    /// Whether the stored bytes have the stated CRC-32. Reads the whole section.
    #[must_use]
    pub fn is_intact(&self) -> bool {
        crc::update(0, self.stored_bytes()) == self.entry.crc32
    }

    /// Descriptor, padding and stored payload.
    pub(crate) fn stored_bytes(&self) -> &'a [u8] {
        &self.file[self.entry.offset as usize..self.end() as usize]
    }

    /// The bytes between descriptor and payload, which must be zero.
    #[cfg(feature = "write")]
    pub(crate) fn descriptor_padding(&self) -> &'a [u8] {
        let start = self.entry.offset as usize + self.entry.descriptor_length as usize;
        &self.file[start..self.payload_offset() as usize]
    }

    /// The descriptor; empty if the kind has none.
    #[must_use]
    pub fn descriptor_bytes(&self) -> &'a [u8] {
        &self.stored_bytes()[..self.entry.descriptor_length as usize]
    }

    /// The payload as stored, in [`Self::codec`].
    #[must_use]
    pub fn stored_payload(&self) -> &'a [u8] {
        &self.file[self.payload_offset() as usize..self.end() as usize]
    }

    /// The payload, if it is stored raw.
    #[must_use]
    pub fn raw_payload(&self) -> Option<&'a [u8]> {
        (self.codec() == Some(Codec::Raw)).then(|| self.stored_payload())
    }

    /// The descriptor of a table of texels, checked, and in agreement with the section's kind and raw length.
    ///
    /// # Errors
    /// A kind that is not a table, a version this crate does not read, or whatever [`TextureDescriptor::parse`] refuses.
    pub fn texture(&self) -> Result<TextureDescriptor, DescriptorError> {
        let kind = self.kind();
        let expected = Semantic::of_kind(kind).ok_or(DescriptorError::NotATexture { kind })?;
        if !self.is_known() {
            return Err(DescriptorError::Version { found: self.version(), newest: *kind.versions().end() });
        }
        let descriptor = TextureDescriptor::parse(self.descriptor_bytes(), self.version())?;
        descriptor.expect(expected)?;
        let (found, expected) = (self.raw_length(), descriptor.payload_length());
        if found != expected {
            return Err(DescriptorError::PayloadLength { found, expected });
        }
        Ok(descriptor)
    }

    /// The descriptor of a curvature table, checked, and in agreement with the section's raw length.
    ///
    /// # Errors
    /// Another kind, a version this crate does not read, or whatever [`CurvatureDescriptor::parse`] refuses.
    pub fn curvature(&self) -> Result<CurvatureDescriptor, CurvatureError> {
        let kind = self.kind();
        if kind != SectionKind::CURVATURE {
            return Err(CurvatureError::NotCurvature { kind });
        }
        if !self.is_known() {
            return Err(CurvatureError::Version { found: self.version() });
        }
        let descriptor = CurvatureDescriptor::parse(self.descriptor_bytes())?;
        let (found, expected) = (self.raw_length(), descriptor.payload_length());
        if found != expected {
            return Err(CurvatureError::PayloadLength { found, expected });
        }
        Ok(descriptor)
    }
}
