//! Tables of height fields that are in memory as a whole: facts, values, and an encoding to a descriptor and a payload.

use std::vec::Vec;

use super::encode::{EncodeError, Encoding};
use super::encoder::TableEncoder;
use super::facts::{CurvatureSweep, TableFacts, TableGrid};
use super::loss::EncodingLoss;
use super::numbers::check_values;
use crate::{Azimuths, DescriptorError, SectionKind, TableView, TextureDescriptor};

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
    /// The azimuth of each layer.
    pub azimuths: Azimuths,
    /// How far the horizon was searched, in the length unit.
    pub radius: f64,
    /// Radians within ±[`crate::MAX_ELEVATION`]: azimuth by azimuth, each row by row from the top of the picture.
    pub values: &'a [f32],
}

/// Horizon distances to be written.
#[derive(Debug, Clone, Copy)]
pub struct DistanceTable<'a> {
    /// Where the texels lie.
    pub grid: TableGrid,
    /// The azimuth of each layer.
    pub azimuths: Azimuths,
    /// How far the horizon was searched, in the length unit.
    pub radius: f64,
    /// Lengths in [0, radius] (cut to [`crate::f32_at_most`] of the radius), in the order of [`HorizonTable::values`].
    pub values: &'a [f32],
}

/// Elevations, as seen on the flat base, of points that become the horizon on a curved one.
#[derive(Debug, Clone, Copy)]
pub struct SweptHorizonTable<'a> {
    /// Where the texels lie.
    pub grid: TableGrid,
    /// The azimuths of the layers of each candidate.
    pub azimuths: Azimuths,
    /// How far the horizon was searched, in the length unit.
    pub radius: f64,
    /// How many points, for which curvatures.
    pub sweep: CurvatureSweep,
    /// Radians within ±[`crate::MAX_ELEVATION`]: candidate by candidate, each in the order of [`HorizonTable::values`].
    pub values: &'a [f32],
}

/// Distances of the points of a [`SweptHorizonTable`].
#[derive(Debug, Clone, Copy)]
pub struct SweptDistanceTable<'a> {
    /// Where the texels lie.
    pub grid: TableGrid,
    /// The azimuths of the layers of each candidate.
    pub azimuths: Azimuths,
    /// How far the horizon was searched, in the length unit.
    pub radius: f64,
    /// How many points, for which curvatures.
    pub sweep: CurvatureSweep,
    /// Lengths in [0, radius], in the order of [`SweptHorizonTable::values`].
    pub values: &'a [f32],
}

/// Visible shares of the sky to be written.
#[derive(Debug, Clone, Copy)]
pub struct SkyVisibilityTable<'a> {
    /// Where the texels lie.
    pub grid: TableGrid,
    /// How far the horizon was searched, in the length unit.
    pub radius: f64,
    /// Cosine-weighted shares in [0, 1], row by row from the top of the picture.
    pub values: &'a [f32],
}

/// Mean directions of the visible sky to be written.
#[derive(Debug, Clone, Copy)]
pub struct BentNormalTable<'a> {
    /// Where the texels lie.
    pub grid: TableGrid,
    /// How far the horizon was searched, in the length unit.
    pub radius: f64,
    /// Components along u and v of a unit vector with height ≥ 0, interleaved, row by row from the top of the picture.
    pub values: &'a [f32],
}

/// Cones of directions towards the visible sky to be written.
#[derive(Debug, Clone, Copy)]
pub struct ApertureConeTable<'a> {
    /// Where the texels lie.
    pub grid: TableGrid,
    /// How far the horizon was searched, in the length unit.
    pub radius: f64,
    /// Components along u, v and height of the unit axis and the cosine of the half-angle, interleaved, row by row from
    /// the top of the picture.
    pub values: &'a [f32],
}

/// Gives a table its facts and its encoding.
macro_rules! table {
    ($name:ident, $facts:ident($($fact:ident),+)) => {
        impl $name<'_> {
            /// All but the values.
            #[must_use]
            pub fn facts(&self) -> TableFacts {
                TableFacts::$facts($(self.$fact),+)
            }

            /// The table in its stored form, with the tightest bounds there are.
            ///
            /// # Errors
            /// A wrong number of values, a value outside [`TableFacts::legal`], or facts outside the format.
            pub fn encode(&self, encoding: Encoding) -> Result<TextureTable, EncodeError> {
                encode(&self.facts(), self.values, encoding)
            }
        }
    };
}

pub(super) use table;

table!(HeightTable, height(grid));
table!(HorizonTable, horizon(grid, azimuths, radius));
table!(DistanceTable, distance(grid, azimuths, radius));
table!(SweptHorizonTable, swept_horizon(grid, azimuths, radius, sweep));
table!(SweptDistanceTable, swept_distance(grid, azimuths, radius, sweep));
table!(SkyVisibilityTable, sky_visibility(grid, radius));
table!(BentNormalTable, bent_normal(grid, radius));
table!(ApertureConeTable, aperture_cone(grid, radius));

/// A table in its stored form, ready for [`crate::AssetWriter::add_table`].
#[derive(Debug, Clone, PartialEq)]
pub struct TextureTable {
    descriptor: TextureDescriptor,
    payload: Vec<u8>,
    loss: Option<EncodingLoss>,
}

impl TextureTable {
    /// Puts a descriptor and a payload of the caller's making together.
    ///
    /// # Errors
    /// Whatever [`TableView::new`] refuses.
    pub fn new(descriptor: TextureDescriptor, payload: Vec<u8>) -> Result<Self, DescriptorError> {
        TableView::new(descriptor, &payload)?;
        Ok(Self { descriptor, payload, loss: None })
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

    /// What the encoding cost, if it was encoded here.
    #[must_use]
    pub fn loss(&self) -> Option<EncodingLoss> {
        self.loss
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

pub(super) fn encode(facts: &TableFacts, values: &[f32], encoding: Encoding) -> Result<TextureTable, EncodeError> {
    // Facts first: a wrong extent must be refused before anything is made of it.
    facts.descriptor(encoding).check()?;
    let layer_values = facts.layer_values();
    let (found, expected) = (values.len() as u64, layer_values.saturating_mul(u64::from(facts.layers())));
    if found != expected {
        return Err(EncodeError::Count { found, expected });
    }
    let (min, max) = extent(facts, values)?;
    encode_pictures(TableEncoder::new(facts, encoding, min..=max)?, values.chunks_exact(layer_values as usize))
}

/// The table of these layers, or levels.
pub(super) fn encode_pictures<'a>(
    mut encoder: TableEncoder,
    pictures: impl Iterator<Item = &'a [f32]>,
) -> Result<TextureTable, EncodeError> {
    let mut payload = Vec::with_capacity(encoder.descriptor().payload_length() as usize);
    for (k, picture) in (0..).zip(pictures) {
        payload.resize(encoder.descriptor().picture_offset(k) as usize, 0);
        let measure = encoder.picture(picture, &mut payload)?;
        encoder.record(k, measure)?;
    }
    let (descriptor, loss) = encoder.finish()?;
    Ok(TextureTable { loss: Some(loss), ..TextureTable::new(descriptor, payload)? })
}

/// The least and the greatest value, all of them legal.
pub(super) fn extent(facts: &TableFacts, values: &[f32]) -> Result<(f32, f32), EncodeError> {
    check_values(values, &facts.legal())?;
    let ends = |(min, max): (f32, f32), &value: &f32| (min.min(value), max.max(value));
    Ok(values.iter().fold((f32::INFINITY, f32::NEG_INFINITY), ends))
}
