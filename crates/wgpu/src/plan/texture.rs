//! A table of texels as a texture.

use barchan_asset::{Azimuths, Codec, Component, Filter, Format, SectionKind, Semantic, TextureDescriptor};

use super::{DeviceLimits, PlanError};
use crate::{TablePart, TextureSection};

/// What kind of texture a table becomes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Shape {
    /// One picture, or the mip levels of one.
    D2,
    /// A layer of a 2-D texture for each layer.
    D2Array,
    /// A slice of a volume for each layer: where there are more layers than a 2-D texture may have.
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
    /// Whether the device can filter it, and its values may be filtered.
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
        let payload_offset = match section.codec() {
            Some(Codec::Raw) => Some(section.payload_offset()),
            Some(Codec::Zstd) if cfg!(feature = "zstd") => None,
            _ => return Err(codec_error(section.kind(), section.codec_number())),
        };
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

    /// Bytes that are uploaded.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.copies.iter().map(|copy| copy.bytes).sum()
    }
}

pub(super) fn codec_error(kind: SectionKind, found: u16) -> PlanError {
    PlanError::Codec { kind, found }
}

/// The layers and levels of a table that are loaded.
struct ChosenLayers {
    /// How many candidates or rings there are of each azimuth.
    groups: u32,
    azimuths: (u32, u32),
    all_azimuths: u32,
    first_level: u32,
}

impl ChosenLayers {
    fn new(stored: &TextureDescriptor, part: &TablePart) -> Result<Self, PlanError> {
        let table = stored.semantic;
        let within = |field, found: u32, most: u32| match (1..=most).contains(&found) {
            true => Ok(found),
            false => Err(PlanError::Part { table, field, found, most }),
        };
        let all_azimuths = stored.azimuths().map_or(stored.layers, |azimuths| azimuths.count());
        let azimuths = match part.azimuths.filter(|_| table.is_directional()) {
            None => (0, all_azimuths),
            Some((first, count)) => {
                let is_circle = stored.azimuths().is_some_and(|azimuths| azimuths.is_full_circle());
                within("first azimuth + 1", first.saturating_add(1), all_azimuths)?;
                let most = if is_circle { all_azimuths } else { all_azimuths - first };
                (first, within("azimuths", count, most)?)
            }
        };
        let groups = match (stored.candidates, stored.rings) {
            (0, 0) => 1,
            (0, rings) => within("rings", part.rings.unwrap_or(rings), rings)?,
            (candidates, _) => within("candidates", part.candidates.unwrap_or(candidates), candidates)?,
        };
        let first_level = if stored.mips > 1 { part.first_level } else { 0 };
        within("levels left out + 1", first_level.saturating_add(1), stored.mips)?;
        Ok(Self { groups, azimuths, all_azimuths, first_level })
    }

    fn count(&self) -> u32 {
        self.groups * self.azimuths.1
    }

    /// The layers of the table, in the order of the texture's.
    fn layers(&self) -> impl Iterator<Item = u32> + '_ {
        let (first, count) = self.azimuths;
        (0..self.groups).flat_map(move |group| {
            (0..count).map(move |azimuth| group * self.all_azimuths + (first + azimuth) % self.all_azimuths)
        })
    }

    /// The descriptor of what is left.
    fn descriptor(&self, stored: &TextureDescriptor) -> TextureDescriptor {
        let mut left = *stored;
        if self.azimuths.1 != self.all_azimuths
            && let Some(azimuths) = stored.azimuths()
        {
            (left.first_azimuth, left.azimuth_step) = arc(&azimuths, self.azimuths);
        }
        if stored.candidates > 0 {
            left.candidates = self.groups;
        }
        if stored.rings > 0 {
            left.rings = self.groups;
        }
        left.layers = self.count();
        left
    }
}

/// The first azimuth and the step of a part of the azimuths.
fn arc(azimuths: &Azimuths, (first, count): (u32, u32)) -> (f64, f64) {
    let step = if count > 1 { azimuths.step_radians() } else { 0.0 };
    (azimuths.radians(first), step)
}

fn shape(table: Semantic, extent: (u32, u32, u32), limits: &DeviceLimits) -> Result<Shape, PlanError> {
    let (width, height, layers) = extent;
    let side = width.max(height);
    if side <= limits.max_2d && layers <= limits.max_layers {
        return Ok(if table.is_directional() { Shape::D2Array } else { Shape::D2 });
    }
    if table.is_directional() && side.max(layers) <= limits.max_3d {
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
