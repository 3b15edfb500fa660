//! The content identity: what a file says, whatever codec it says it in.

use crate::{Asset, Limits, PayloadError, SectionKind};

/// BLAKE3 over, for each section in table order: kind (4 bytes), section version (u16), descriptor length (u32),
/// descriptor, raw length (u64), decoded payload. Numbers are little-endian, nothing is padded.
#[derive(Default)]
pub(crate) struct IdentityHasher(blake3::Hasher);

impl IdentityHasher {
    /// Adds one section.
    pub(crate) fn section(&mut self, kind: SectionKind, version: u16, descriptor: &[u8], payload: &[u8]) {
        self.begin(kind, version, descriptor, payload.len() as u64);
        self.payload(payload);
    }

    /// Adds a section up to its decoded payload, which has `raw_length` bytes.
    pub(crate) fn begin(&mut self, kind: SectionKind, version: u16, descriptor: &[u8], raw_length: u64) {
        self.0.update(&kind.0);
        self.0.update(&version.to_le_bytes());
        self.0.update(&(descriptor.len() as u32).to_le_bytes());
        self.0.update(descriptor);
        self.0.update(&raw_length.to_le_bytes());
    }

    /// Adds a piece of the decoded payload.
    pub(crate) fn payload(&mut self, piece: &[u8]) {
        self.0.update(piece);
    }

    /// The identity of the sections so far.
    pub(crate) fn finish(&self) -> [u8; 32] {
        *self.0.finalize().as_bytes()
    }
}

/// The identity that a file's content has, to be compared with the one it states ([`Asset::identity`]).
///
/// # Errors
/// The first section whose payload cannot be decoded within `limits`.
pub fn content_identity(asset: &Asset<'_>, limits: &Limits) -> Result<[u8; 32], PayloadError> {
    let mut hasher = IdentityHasher::default();
    for section in asset.sections() {
        hasher.section(section.kind(), section.version(), section.descriptor_bytes(), &section.payload(limits)?);
    }
    Ok(hasher.finish())
}
