//! A file that is opened, and whose descriptors are checked.

use std::fmt;

use barchan_asset::{
    Asset, CurvatureDescriptor, CurvatureError, DescriptorError, OpenError, Section, SectionKind, Semantic,
    TextureDescriptor,
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
}

impl<'a> Reader<'a> {
    /// Checks the structure of a file and the descriptor of every table. `bytes` is the whole file.
    ///
    /// It takes time in the number of tables, not in their size. Sections that this version does not know are passed over:
    /// [`Self::skipped`].
    ///
    /// # Errors
    /// A file that `formats/barchan-v1.md` tells a reader to refuse, or a table whose descriptor does not hold.
    pub fn open(bytes: &'a [u8]) -> Result<Self, ReadError> {
        let asset = Asset::open(bytes).map_err(ReadError::Open)?;
        let mut reader = Self { asset, textures: Vec::new(), curvature: None, skipped: Vec::new() };
        for section in asset.sections() {
            reader.take(section)?;
        }
        Ok(reader)
    }

    fn take(&mut self, section: Section<'a>) -> Result<(), ReadError> {
        let kind = section.kind();
        if !section.is_known() {
            self.skipped.push(kind);
        } else if Semantic::of_kind(kind).is_some() {
            let descriptor = section.texture().map_err(|fault| ReadError::Table { kind, fault })?;
            self.textures.push(TextureSection { descriptor, section });
        } else if kind == SectionKind::CURVATURE {
            self.curvature = Some((section.curvature().map_err(ReadError::Curvature)?, section));
        }
        Ok(())
    }

    /// Reads every byte and compares the checksums: for files that may have been damaged on their way.
    ///
    /// # Errors
    /// The first section whose bytes are not those that were written.
    pub fn check_bytes(&self) -> Result<(), ReadError> {
        match self.asset.sections().find(|section| !section.is_intact()) {
            Some(damaged) => Err(ReadError::Damaged { kind: damaged.kind() }),
            None => Ok(()),
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

    /// The kinds of sections that this version does not know, and passes over.
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
        }
    }
}

impl std::error::Error for ReadError {}
