//! A table of texels as a texture.

use barchan_asset::{Component, Filter, Format, Semantic, TextureDescriptor, Wrap};

use super::layers::ChosenLayers;
use super::{DeviceLimits, PlanError, payload_offset, slice};
use crate::{TablePart, TextureSection};

/// What kind of texture a table becomes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Shape {
    /// A 2-D texture: one picture, or the mip levels of one.
    D2,
    /// A layer of a 2-D array texture for each layer.
    D2Array,
    /// A slice of a volume for each layer: where there are more layers than a 2-D array texture may have.
    D3,
}

/// Bytes that go to one place of a texture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TextureCopy {
    /// Where they begin in the decoded payload.
    pub offset: u64,
    /// How many there are.
    pub bytes: u64,
    /// Bytes from a row to the next: rows are tight.
    pub bytes_per_row: u32,
    /// Texels along u and v.
    pub extent: (u32, u32),
    /// The layer or slice they go to, and how many of them follow each other without a gap.
    pub first_layer: u32,
    /// How many layers.
    pub layers: u32,
    /// The mip level they go to.
    pub level: u32,
}

impl TextureCopy {
    /// Its bytes of a decoded payload; none if it is too short, which is another file's.
    #[must_use]
    pub fn of<'a>(&self, payload: &'a [u8]) -> Option<&'a [u8]> {
        slice(payload, self.offset, self.bytes)
    }
}

/// What becomes of a table of texels.
#[derive(Debug, Clone, PartialEq)]
pub struct TexturePlan {
    /// Which table.
    pub table: Semantic,
    /// The descriptor of what is loaded: that of the file, with the azimuths, candidates, rings and levels that were selected.
    pub descriptor: TextureDescriptor,
    /// The format of its texels.
    pub format: Format,
    /// What kind of texture it is.
    pub shape: Shape,
    /// Texels along u and v of the finest level.
    pub extent: (u32, u32),
    /// Layers, or slices of a volume.
    pub layers: u32,
    /// Mip levels.
    pub levels: u32,
    /// The level of the table that is the texture's finest.
    pub first_level: u32,
    /// Whether the plan's sampler may filter it: the device can, the values may be, and the edges are the sampler's.
    pub is_filterable: bool,
    /// Where the decoded payload begins in the file; nothing for a section that has to be decoded first.
    pub payload_offset: Option<u64>,
    /// Which bytes go where.
    pub copies: Vec<TextureCopy>,
}

impl TexturePlan {
    pub(super) fn new(
        texture: &TextureSection<'_>,
        part: &TablePart,
        limits: &DeviceLimits,
    ) -> Result<Self, PlanError> {
        let (stored, section) = (texture.descriptor, texture.section);
        let payload_offset = payload_offset(&section)?;
        let chosen = ChosenLayers::new(&stored, part)?;
        let first_level = chosen.first_level;
        let levels = stored.mips - first_level;
        let extent = if stored.mips > 1 { stored.picture_extent(first_level) } else { (stored.width, stored.height) };
        let layers = chosen.count();
        let shape = shape(stored.semantic, (extent.0, extent.1, layers), limits)?;
        let can_filter = stored.format.component() != Component::Float32 || limits.filters_float32;
        Ok(Self {
            table: stored.semantic,
            descriptor: chosen.descriptor(&stored),
            format: stored.format,
            shape,
            extent,
            layers,
            levels,
            first_level,
            is_filterable: can_filter && stored.filter == Filter::Linear,
            payload_offset,
            copies: copies(&stored, &chosen),
        })
    }

    /// What lies beyond its edges along u and v.
    pub(super) fn edges(&self) -> (Wrap, Wrap) {
        (self.descriptor.wrap_u, self.descriptor.wrap_v)
    }

    /// Bytes that are uploaded.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.copies.iter().map(|copy| copy.bytes).sum()
    }
}

fn shape(table: Semantic, extent: (u32, u32, u32), limits: &DeviceLimits) -> Result<Shape, PlanError> {
    let (width, height, layers) = extent;
    let side = width.max(height);
    let is_taken_for_cubes = limits.guesses_cubes && width == height && layers.is_multiple_of(6);
    if side <= limits.max_2d && layers <= limits.max_layers && !is_taken_for_cubes {
        return Ok(if layers > 1 { Shape::D2Array } else { Shape::D2 });
    }
    if layers > 1 && side.max(layers) <= limits.max_3d {
        return Ok(Shape::D3);
    }
    Err(PlanError::TooLarge { table, extent, limits: *limits })
}

/// Layers that follow each other in file and texture are one copy where nothing lies between them.
fn copies(stored: &TextureDescriptor, chosen: &ChosenLayers) -> Vec<TextureCopy> {
    let copy = |picture: u32, first_layer: u32, level: u32| {
        let extent = stored.picture_extent(picture);
        TextureCopy {
            offset: stored.picture_offset(picture),
            bytes: stored.picture_bytes(picture),
            bytes_per_row: extent.0 * stored.format.texel_bytes(),
            extent,
            first_layer,
            layers: 1,
            level,
        }
    };
    if stored.mips > 1 {
        return (chosen.first_level..stored.mips).map(|level| copy(level, 0, level - chosen.first_level)).collect();
    }
    let mut copies: Vec<TextureCopy> = Vec::new();
    for (layer, source) in chosen.layers().enumerate() {
        let next = copy(source, layer as u32, 0);
        match copies.last_mut() {
            Some(last) if last.offset + last.bytes == next.offset => {
                last.bytes += next.bytes;
                last.layers += 1;
            }
            _ => copies.push(next),
        }
    }
    copies
}
