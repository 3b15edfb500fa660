//! A table of texels as numbers.

use crate::bytes::{array_at, u16_at};
use crate::half::f16_to_f32;
use crate::{Component, DescriptorError, TextureDescriptor, Transfer};

/// A descriptor and its decoded payload, checked once to belong together.
///
/// # Decoding
/// `t = scale · stored + bias` in f32, the product rounded before the sum is; `stored` is k / 255 rounded to f32, the
/// half, or the float. The value is [`crate::Transfer::value`] of t; of a channel that [`crate::Semantic::is_plain`] it
/// is `stored`. A shader may fuse product and sum or flush subnormals: the descriptor's worst-case error covers that.
///
/// # Mip levels
/// A table with several has one layer, and each `layer` below is a level: [`TextureDescriptor::pictures`].
///
/// # Trust
/// The payload's numbers are not looked at here. A hostile file can hold NaN or values outside the stated range:
/// `validate` tells.
#[derive(Debug, Clone, Copy)]
pub struct TableView<'a> {
    descriptor: TextureDescriptor,
    payload: &'a [u8],
    scale: f32,
    bias: f32,
}

impl<'a> TableView<'a> {
    /// `payload` is the decoded payload of the section that `descriptor` came from.
    ///
    /// # Errors
    /// A descriptor that [`TextureDescriptor::check`] refuses, or a payload of another length than it asks for.
    pub fn new(descriptor: TextureDescriptor, payload: &'a [u8]) -> Result<Self, DescriptorError> {
        descriptor.check()?;
        let (found, expected) = (payload.len() as u64, descriptor.payload_length());
        if found != expected {
            return Err(DescriptorError::PayloadLength { found, expected });
        }
        Ok(Self { descriptor, payload, scale: descriptor.scale as f32, bias: descriptor.bias as f32 })
    }

    /// What the table is.
    #[must_use]
    pub fn descriptor(&self) -> &TextureDescriptor {
        &self.descriptor
    }

    /// The decoded payload it was made of.
    #[must_use]
    pub fn payload(&self) -> &'a [u8] {
        self.payload
    }

    /// The stored bytes of a layer: rows tight, ready for upload.
    ///
    /// # Panics
    /// If there is no such layer.
    #[must_use]
    pub fn layer(&self, layer: u32) -> &'a [u8] {
        assert!(layer < self.descriptor.pictures(), "layer {layer} of {}", self.descriptor.pictures());
        let start = self.descriptor.picture_offset(layer) as usize;
        &self.payload[start..start + self.descriptor.picture_bytes(layer) as usize]
    }

    /// The bytes between a layer and the next, which are zero in a valid file; empty behind the last.
    #[must_use]
    pub fn layer_padding(&self, layer: u32) -> &'a [u8] {
        let start = self.descriptor.picture_offset(layer).saturating_add(self.descriptor.picture_bytes(layer));
        let end = self.descriptor.picture_offset(layer.saturating_add(1)).min(self.payload.len() as u64);
        self.payload.get(start as usize..end as usize).unwrap_or(&[])
    }

    /// The decoded value of one texel, in the descriptor's unit; of its first channel if there are several.
    ///
    /// # Panics
    /// If there is no such texel.
    #[must_use]
    pub fn value(&self, layer: u32, column: u32, row: u32) -> f32 {
        self.channel(layer, column, row, 0)
    }

    /// The decoded value of one channel of a texel.
    ///
    /// # Panics
    /// If there is no such texel or channel.
    #[must_use]
    pub fn channel(&self, layer: u32, column: u32, row: u32, channel: u32) -> f32 {
        self.transferred(self.before_transfer(layer, column, row, channel), channel as usize)
    }

    /// `scale · stored + bias` of one channel of a texel: with [`crate::Transfer::Sine`] the sine of the elevation.
    ///
    /// # Panics
    /// If there is no such texel or channel.
    #[must_use]
    pub fn before_transfer(&self, layer: u32, column: u32, row: u32, channel: u32) -> f32 {
        let (width, height) = self.descriptor.picture_extent(layer);
        let channels = self.descriptor.format.channels();
        assert!(column < width && row < height, "texel ({column}, {row}) of {width} × {height}");
        assert!(channel < channels, "channel {channel} of {channels}");
        let texel = row as usize * width as usize + column as usize;
        self.number(self.layer(layer), texel * channels as usize + channel as usize)
    }

    /// The decoded values of one row, left to right; the channels of a texel follow each other.
    ///
    /// # Panics
    /// If there is no such row.
    pub fn row(&self, layer: u32, row: u32) -> impl ExactSizeIterator<Item = f32> + use<'a> {
        let (texels, view) = (self.row_bytes(layer, row), *self);
        // In a long row there are fewer different bytes than there are bytes, and an arcsine is dear.
        let dear =
            self.descriptor.transfer == Transfer::Sine && self.descriptor.format.component() == Component::Unorm8;
        let value_of_byte = (dear && texels.len() > 256)
            .then(|| core::array::from_fn::<f32, 256, _>(|byte| self.transferred(self.number(&[byte as u8], 0), 0)));
        (0..self.row_numbers(layer)).map(move |index| match &value_of_byte {
            Some(values) => values[usize::from(texels[index])],
            None => view.transferred(view.number(texels, index), index),
        })
    }

    /// `scale · stored + bias` along one row, left to right; the channels of a texel follow each other.
    ///
    /// # Panics
    /// If there is no such row.
    pub fn row_before_transfer(&self, layer: u32, row: u32) -> impl ExactSizeIterator<Item = f32> + use<'a> {
        let (texels, view) = (self.row_bytes(layer, row), *self);
        (0..self.row_numbers(layer)).map(move |index| view.number(texels, index))
    }

    fn row_bytes(&self, layer: u32, row: u32) -> &'a [u8] {
        let (width, height) = self.descriptor.picture_extent(layer);
        assert!(row < height, "row {row} of {height}");
        let row_bytes = width as usize * self.descriptor.format.texel_bytes() as usize;
        &self.layer(layer)[row as usize * row_bytes..][..row_bytes]
    }

    /// Texels of a row times channels.
    fn row_numbers(&self, layer: u32) -> usize {
        self.descriptor.picture_extent(layer).0 as usize * self.descriptor.format.channels() as usize
    }

    /// `scale · stored + bias` of the `index`th number of `texels`.
    fn number(&self, texels: &[u8], index: usize) -> f32 {
        let stored = match self.descriptor.format.component() {
            Component::Unorm8 => f32::from(texels[index]) / 255.0,
            Component::Float16 => f16_to_f32(u16_at(texels, 2 * index)),
            Component::Float32 => return f32::from_le_bytes(array_at(texels, 4 * index)),
        };
        if self.is_plain(index) { stored } else { self.scale * stored + self.bias }
    }

    /// The value of the `index`th number of a layer, from what it is before the transfer.
    fn transferred(&self, t: f32, index: usize) -> f32 {
        if self.is_plain(index) { t } else { self.descriptor.transfer.value(t) }
    }

    /// Whether the `index`th number of a layer is stored as it is.
    fn is_plain(&self, index: usize) -> bool {
        // A number of channels is a power of two.
        self.descriptor.semantic.is_plain(index as u32 & (self.descriptor.format.channels() - 1))
    }
}
