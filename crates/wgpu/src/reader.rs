//! A file that is opened, and whose descriptors are checked.

use std::borrow::Cow;
use std::fmt;

use barchan_asset::{
    Asset, Codec, CurvatureDescriptor, CurvatureError, DescriptorError, Limits, OpenError, Section, SectionKind,
    Semantic, TextureDescriptor,
};

/// A table of texels in a file.
#[derive(Debug, Clone, Copy)]
pub struct TextureSection<'a> {
    /// What it is.
    pub descriptor: TextureDescriptor,
    /// Where it is.
    pub section: Section<'a>,
}

/// An opened file, whose tables are known but have not been looked at.
#[derive(Debug, Clone)]
pub struct Reader<'a> {
    asset: Asset<'a>,
    textures: Vec<TextureSection<'a>>,
    curvature: Option<(CurvatureDescriptor, Section<'a>)>,
    skipped: Vec<SectionKind>,
    limits: Limits,
}

/// Why a file was refused.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum ReadError {
    /// Its structure.
    Open(OpenError),
    /// The descriptor of a table of texels.
    Table {
        /// Which table.
        kind: SectionKind,
        /// What is wrong.
        fault: DescriptorError,
    },
    /// The descriptor of the curvature table.
    Curvature(CurvatureError),
    /// Stored bytes have another checksum than the file states.
    Damaged {
        /// Of which section.
        kind: SectionKind,
    },
    /// There is no such section.
    Missing {
        /// Which section.
        kind: SectionKind,
    },
    /// A codec that this build does not decode.
    Codec {
        /// Of which section.
        kind: SectionKind,
        /// The codec's number.
        found: u16,
    },
    /// A compressed section does not decode.
    Payload {
        /// Which section.
        kind: SectionKind,
        /// What the decoder says.
        reason: String,
    },
}

impl<'a> Reader<'a> {
    /// Checks the structure of a file and the descriptor of every table. `bytes` is the whole file.
    ///
    /// It takes time in the number of tables, not in their size. Sections that it does not know, and need not, are passed over:
    /// [`Self::skipped`].
    ///
    /// # Errors
    /// A file that `formats/barchan-v1.md` tells a reader to refuse, or a table whose descriptor does not hold.
    pub fn open(bytes: &'a [u8]) -> Result<Self, ReadError> {
        let asset = Asset::open(bytes).map_err(ReadError::Open)?;
        let mut reader =
            Self { asset, textures: Vec::new(), curvature: None, skipped: Vec::new(), limits: Limits::default() };
        for section in asset.sections() {
            reader.take(section)?;
        }
        Ok(reader)
    }

    fn take(&mut self, section: Section<'a>) -> Result<(), ReadError> {
        let kind = section.kind();
        if !section.is_known() || section.codec().is_none() {
            self.skipped.push(kind);
        } else if Semantic::of_kind(kind).is_some() {
            let descriptor = section.texture().map_err(|fault| ReadError::Table { kind, fault })?;
            self.textures.push(TextureSection { descriptor, section });
        } else if kind == SectionKind::CURVATURE {
            self.curvature = Some((section.curvature().map_err(ReadError::Curvature)?, section));
        }
        Ok(())
    }

    /// The same with other bounds on what decoding a compressed section may allocate than the default, 1 GiB.
    #[must_use]
    pub fn with_limits(mut self, limits: Limits) -> Self {
        self.limits = limits;
        self
    }

    /// Reads every byte and compares the checksums: for files that may have been damaged on their way. The feature
    /// `fast-checksum` makes it many times faster.
    ///
    /// # Errors
    /// The first section whose bytes are not those that were written.
    pub fn check_bytes(&self) -> Result<(), ReadError> {
        match self.asset.sections().find(|section| !section.is_intact()) {
            Some(damaged) => Err(ReadError::Damaged { kind: damaged.kind() }),
            None => Ok(()),
        }
    }

    /// The payload of a section: of one that is stored raw the file's own bytes, not copied; else decoded to memory within the
    /// limits. It is not checked against its checksum: [`Self::check_bytes`].
    ///
    /// # Errors
    /// A section that is not there, a codec that this build does not decode, or a frame that does not decode to the stated length.
    pub fn payload(&self, kind: SectionKind) -> Result<Cow<'a, [u8]>, ReadError> {
        let section = self.asset.section(kind).ok_or(ReadError::Missing { kind })?;
        match section.codec() {
            Some(Codec::Raw) => Ok(Cow::Borrowed(section.stored_payload())),
            #[cfg(feature = "zstd")]
            Some(Codec::Zstd) => {
                section.payload(&self.limits).map_err(|error| ReadError::Payload { kind, reason: error.to_string() })
            }
            _ => Err(ReadError::Codec { kind, found: section.codec_number() }),
        }
    }

    /// The file.
    #[must_use]
    pub fn asset(&self) -> Asset<'a> {
        self.asset
    }

    /// The tables of texels, in the order of the file.
    #[must_use]
    pub fn textures(&self) -> &[TextureSection<'a>] {
        &self.textures
    }

    /// A table of texels, if the file has it.
    #[must_use]
    pub fn texture(&self, table: Semantic) -> Option<TextureSection<'a>> {
        self.textures.iter().find(|texture| texture.descriptor.semantic == table).copied()
    }

    /// The curvature of a mesh, if the file has it.
    #[must_use]
    pub fn curvature(&self) -> Option<(&CurvatureDescriptor, Section<'a>)> {
        self.curvature.as_ref().map(|(descriptor, section)| (descriptor, *section))
    }

    /// The sections that are passed over: this reader does not know their kind, its version or its codec, and the file says that it
    /// need not.
    #[must_use]
    pub fn skipped(&self) -> &[SectionKind] {
        &self.skipped
    }
}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Open(error) => write!(f, "{error}"),
            Self::Table { kind, fault } => write!(f, "table {kind}: {fault}"),
            Self::Curvature(error) => write!(f, "table curvature: {error}"),
            Self::Damaged { kind } => {
                write!(f, "section {kind}: its bytes are damaged: their checksum is not the stated one")
            }
            Self::Missing { kind } => write!(f, "section {kind} is not in the file"),
            Self::Codec { kind, found } if *found == Codec::Zstd.number() => write!(
                f,
                "section {kind} is compressed, which this program does not read; bake with `compression: none`, or build the program \
                 with the feature `zstd` of barchan-wgpu"
            ),
            Self::Codec { kind, found } => {
                write!(f, "section {kind} is stored with codec {found}; 0 (raw) and 1 (zstd) are accepted")
            }
            Self::Payload { kind, reason } => write!(f, "section {kind}: {reason}"),
        }
    }
}

impl std::error::Error for ReadError {}
