//! Tables of each kind: facts about the grid, values, and an encoding to a descriptor and a payload.

use core::f64::consts::TAU;
use core::ops::RangeInclusive;
use std::vec::Vec;

use super::encode::{EncodeError, Encoding, encode};
use crate::{
    DescriptorError, Filter, LengthUnit, MAX_ELEVATION, MipReducer, SectionKind, Semantic, TableView,
    TextureDescriptor, Unit, Wrap, f32_at_most,
};

/// Where the texels of a table lie.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TableGrid {
    /// Texels along u.
    pub width: u32,
    /// Texels along v.
    pub height: u32,
    /// Length per texel along u.
    pub spacing_u: f64,
    /// Length per texel along v.
    pub spacing_v: f64,
    /// The unit of lengths.
    pub length_unit: LengthUnit,
    /// What lies beyond the first and the last column.
    pub wrap_u: Wrap,
    /// What lies beyond the first and the last row.
    pub wrap_v: Wrap,
}

/// Heights to be written.
#[derive(Debug, Clone, Copy)]
pub struct HeightTable<'a> {
    /// Where the texels lie.
    pub grid: TableGrid,
    /// Finite heights in the length unit, row by row from the top of the picture.
    pub values: &'a [f32],
}

/// Horizon elevations to be written.
#[derive(Debug, Clone, Copy)]
pub struct HorizonTable<'a> {
    /// Where the texels lie.
    pub grid: TableGrid,
    /// How many azimuths, evenly spread over the full circle from +u, counter-clockwise as seen.
    pub directions: u32,
    /// How far the horizon was searched, in the length unit.
    pub radius: f64,
    /// Radians within ±[`MAX_ELEVATION`]: direction by direction, each row by row from the top of the picture.
    pub values: &'a [f32],
}

/// Horizon distances to be written.
#[derive(Debug, Clone, Copy)]
pub struct DistanceTable<'a> {
    /// Where the texels lie.
    pub grid: TableGrid,
    /// How many azimuths, evenly spread over the full circle from +u, counter-clockwise as seen.
    pub directions: u32,
    /// How far the horizon was searched, in the length unit.
    pub radius: f64,
    /// Lengths in [0, radius] (cut to [`f32_at_most`] of the radius), in the order of [`HorizonTable::values`].
    pub values: &'a [f32],
}

impl HeightTable<'_> {
    /// The table in its stored form.
    ///
    /// # Errors
    /// A wrong number of values, a value that is not finite, or facts outside the format.
    pub fn encode(&self, encoding: Encoding) -> Result<TextureTable, EncodeError> {
        let facts = Facts { grid: self.grid, semantic: Semantic::Height, layers: 1, radius: 0.0 };
        facts.encode(self.values, encoding, f32::MIN..=f32::MAX)
    }
}

impl HorizonTable<'_> {
    /// The table in its stored form.
    ///
    /// # Errors
    /// A wrong number of values, a value beyond ±[`MAX_ELEVATION`], or facts outside the format.
    pub fn encode(&self, encoding: Encoding) -> Result<TextureTable, EncodeError> {
        let semantic = Semantic::HorizonElevation;
        let facts = Facts { grid: self.grid, semantic, layers: self.directions, radius: self.radius };
        facts.encode(self.values, encoding, -MAX_ELEVATION..=MAX_ELEVATION)
    }
}

impl DistanceTable<'_> {
    /// The table in its stored form.
    ///
    /// # Errors
    /// A wrong number of values, a value outside [0, radius], or facts outside the format.
    pub fn encode(&self, encoding: Encoding) -> Result<TextureTable, EncodeError> {
        let semantic = Semantic::HorizonDistance;
        let facts = Facts { grid: self.grid, semantic, layers: self.directions, radius: self.radius };
        facts.encode(self.values, encoding, 0.0..=f32_at_most(self.radius))
    }
}

/// A table in its stored form, ready for [`crate::AssetWriter::add_table`].
#[derive(Debug, Clone, PartialEq)]
pub struct TextureTable {
    descriptor: TextureDescriptor,
    payload: Vec<u8>,
}

impl TextureTable {
    /// Puts a descriptor and a payload of the caller's making together.
    ///
    /// # Errors
    /// Whatever [`TableView::new`] refuses.
    pub fn new(descriptor: TextureDescriptor, payload: Vec<u8>) -> Result<Self, DescriptorError> {
        TableView::new(descriptor, &payload)?;
        Ok(Self { descriptor, payload })
    }

    /// The kind of section the table goes into.
    #[must_use]
    pub fn kind(&self) -> SectionKind {
        self.descriptor.semantic.kind()
    }

    /// What the table is.
    #[must_use]
    pub fn descriptor(&self) -> &TextureDescriptor {
        &self.descriptor
    }

    /// The decoded payload of the section.
    #[must_use]
    pub fn payload(&self) -> &[u8] {
        &self.payload
    }

    /// The descriptor and the payload, without a copy.
    #[must_use]
    pub fn into_parts(self) -> (TextureDescriptor, Vec<u8>) {
        (self.descriptor, self.payload)
    }

    /// The values as a reader will decode them.
    ///
    /// # Errors
    /// None in practice: the parts were checked when they were put together.
    pub fn view(&self) -> Result<TableView<'_>, DescriptorError> {
        TableView::new(self.descriptor, &self.payload)
    }
}

/// What is common to the tables of all kinds.
struct Facts {
    grid: TableGrid,
    semantic: Semantic,
    layers: u32,
    radius: f64,
}

impl Facts {
    fn encode(
        &self,
        values: &[f32],
        encoding: Encoding,
        legal: RangeInclusive<f32>,
    ) -> Result<TextureTable, EncodeError> {
        let mut descriptor = self.descriptor(encoding);
        // Facts first: a wrong extent must be refused before anything is allocated for it.
        descriptor.check()?;
        let layer_texels = u64::from(self.grid.width) * u64::from(self.grid.height);
        let encoded = encode(values, self.layers, layer_texels, encoding, legal)?;
        descriptor.scale = f64::from(encoded.scale);
        descriptor.bias = f64::from(encoded.bias);
        (descriptor.range_min, descriptor.range_max) = (f64::from(encoded.range.0), f64::from(encoded.range.1));
        descriptor.worst_case_error = encoded.worst_case_error;
        Ok(TextureTable::new(descriptor, encoded.bytes)?)
    }

    /// The descriptor of a table of zeros.
    fn descriptor(&self, encoding: Encoding) -> TextureDescriptor {
        let grid = self.grid;
        let directional = self.semantic.is_directional();
        TextureDescriptor {
            format: encoding.format(),
            width: grid.width,
            height: grid.height,
            layers: self.layers,
            mips: 1,
            semantic: self.semantic,
            unit: match self.semantic {
                Semantic::HorizonElevation => Unit::Radian,
                _ => Unit::Length(grid.length_unit),
            },
            length_unit: grid.length_unit,
            wrap_u: grid.wrap_u,
            wrap_v: grid.wrap_v,
            filter: Filter::Linear,
            mip_reducer: MipReducer::Mean,
            scale: 1.0,
            bias: 0.0,
            range_min: 0.0,
            range_max: 0.0,
            worst_case_error: 0.0,
            spacing_u: grid.spacing_u,
            spacing_v: grid.spacing_v,
            first_azimuth: 0.0,
            azimuth_step: if directional { TAU / f64::from(self.layers) } else { 0.0 },
            search_radius: self.radius,
        }
    }
}
