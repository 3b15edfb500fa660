//! Where the texels of a table lie in its payload.

use super::{MAX_EXTENT, TextureDescriptor};
use crate::bytes::{CHUNK_ALIGN, align_up};

/// Mip levels of the largest table.
const MAX_MIPS: u32 = MAX_EXTENT.ilog2() + 1;

impl TextureDescriptor {
    /// Numbers in one layer: texels times channels.
    #[must_use]
    pub fn layer_values(&self) -> u64 {
        u64::from(self.width) * u64::from(self.height) * u64::from(self.format.channels())
    }

    /// Bytes of one row of texels.
    #[must_use]
    pub fn row_bytes(&self) -> u64 {
        u64::from(self.width) * u64::from(self.format.texel_bytes())
    }

    /// Bytes of one layer: its rows, tight.
    #[must_use]
    pub fn layer_bytes(&self) -> u64 {
        self.row_bytes() * u64::from(self.height)
    }

    /// Bytes from the start of one layer to the start of the next: a multiple of 256.
    #[must_use]
    pub fn layer_stride(&self) -> u64 {
        // At most 2³⁶ for a checked descriptor, so aligning cannot overflow; one that was not checked saturates.
        align_up(self.layer_bytes(), CHUNK_ALIGN).unwrap_or(u64::MAX)
    }

    /// Offset of a layer in the decoded payload.
    #[must_use]
    pub fn layer_offset(&self, layer: u32) -> u64 {
        self.layer_stride().saturating_mul(u64::from(layer))
    }

    /// Pictures in the payload: the layers, or the mip levels of a table that has several.
    #[must_use]
    pub fn pictures(&self) -> u32 {
        if self.mips > 1 { self.mips } else { self.layers }
    }

    /// Texels of a picture along u and v: of every layer the same, of each mip level half as many, at least one.
    #[must_use]
    pub fn picture_extent(&self, picture: u32) -> (u32, u32) {
        let level = if self.mips > 1 { picture } else { 0 };
        let halved = |texels: u32| texels.checked_shr(level).unwrap_or(0).max(1);
        if level == 0 { (self.width, self.height) } else { (halved(self.width), halved(self.height)) }
    }

    /// Bytes of a picture: its rows, tight.
    #[must_use]
    pub fn picture_bytes(&self, picture: u32) -> u64 {
        let (width, height) = self.picture_extent(picture);
        u64::from(width) * u64::from(height) * u64::from(self.format.texel_bytes())
    }

    /// Offset of a picture in the decoded payload: a multiple of 256.
    #[must_use]
    pub fn picture_offset(&self, picture: u32) -> u64 {
        if self.mips <= 1 {
            return self.layer_offset(picture);
        }
        // A checked descriptor has 17 levels at most.
        let stride = |level| align_up(self.picture_bytes(level), CHUNK_ALIGN).unwrap_or(u64::MAX);
        (0..picture.min(MAX_MIPS)).map(stride).fold(0, u64::saturating_add)
    }

    /// Bytes of the decoded payload: all pictures, padded between but not behind the last.
    #[must_use]
    pub fn payload_length(&self) -> u64 {
        let last = self.pictures().saturating_sub(1);
        self.picture_offset(last).saturating_add(self.picture_bytes(last))
    }

    /// Mip levels from width × height down to one texel.
    pub(super) fn levels_to_one_texel(&self) -> u32 {
        self.width.max(self.height).max(1).ilog2() + 1
    }
}
