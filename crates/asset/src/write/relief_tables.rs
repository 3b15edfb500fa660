//! Tables for relief search that are in memory as a whole.

use std::vec::Vec;

use super::encode::{EncodeError, Encoding};
use super::encoder::TableEncoder;
use super::facts::{TableFacts, TableGrid};
use super::tables::{TextureTable, encode, encode_pictures, extent, table};
use crate::{DepthMode, HemisphereDirections, ReliefRange};

/// Depths of first hits to be written.
#[derive(Debug, Clone, Copy)]
pub struct HemisphereTable<'a> {
    /// Where the texels lie.
    pub grid: TableGrid,
    /// The cell of each layer.
    pub directions: HemisphereDirections,
    /// What a depth says about the rays of its cell.
    pub mode: DepthMode,
    /// What depths measure.
    pub relief: ReliefRange,
    /// Depths in [0, 1]: layer by layer, each row by row from the top of the picture. Conservative ones are rounded down.
    pub values: &'a [f32],
}

/// Cones that the relief stays out of, to be written.
#[derive(Debug, Clone, Copy)]
pub struct ConeMapTable<'a> {
    /// Where the texels lie.
    pub grid: TableGrid,
    /// What depths measure.
    pub relief: ReliefRange,
    /// A depth in [0, 1] and a ratio, horizontal length over height, 0 or more: interleaved, row by row from the top of
    /// the picture. Both are rounded down.
    pub values: &'a [f32],
}

/// Cones in which a ray pierces the relief once at most, to be written.
#[derive(Debug, Clone, Copy)]
pub struct RelaxedConeMapTable<'a> {
    /// Where the texels lie.
    pub grid: TableGrid,
    /// What depths measure.
    pub relief: ReliefRange,
    /// As those of [`ConeMapTable::values`].
    pub values: &'a [f32],
}

/// Greatest heights to be written.
#[derive(Debug, Clone, Copy)]
pub struct MaximumMipTable<'a> {
    /// Where the texels of level 0 lie.
    pub grid: TableGrid,
    /// Finite heights in the length unit of every level, each row by row from the top of the picture: half the columns and
    /// half the rows of the level before, rounded down, at least 1, until there is one texel. They are rounded up.
    pub levels: &'a [&'a [f32]],
}

table!(HemisphereTable, hemisphere(grid, directions, mode, relief));

/// Gives a cone map its facts and its encoding.
macro_rules! cone_map {
    ($name:ident, $facts:ident) => {
        impl $name<'_> {
            /// All but the values.
            #[must_use]
            pub fn facts(&self) -> TableFacts {
                TableFacts::$facts(self.grid, self.relief)
            }

            /// The table in its stored form, with the tightest bounds of ratios there are.
            ///
            /// # Errors
            /// A wrong number of values, a depth outside [0, 1], a ratio that is negative or not finite, or facts outside
            /// the format.
            pub fn encode(&self, encoding: Encoding) -> Result<TextureTable, EncodeError> {
                encode_cones(&self.facts(), self.values, encoding)
            }
        }
    };
}

cone_map!(ConeMapTable, cone_map);
cone_map!(RelaxedConeMapTable, relaxed_cone_map);

fn encode_cones(facts: &TableFacts, values: &[f32], encoding: Encoding) -> Result<TextureTable, EncodeError> {
    facts.descriptor(encoding).check()?;
    count(values.len(), facts.layer_values())?;
    let ratios: Vec<f32> = values.iter().skip(1).step_by(2).copied().collect();
    let (min, max) = extent(facts, &ratios).map_err(|error| error.at_index(|texel| 2 * texel + 1))?;
    encode_pictures(TableEncoder::new(facts, encoding, min..=max)?, core::iter::once(values))
}

impl MaximumMipTable<'_> {
    /// All but the values.
    #[must_use]
    pub fn facts(&self) -> TableFacts {
        TableFacts::maximum_mip(self.grid)
    }

    /// The table in its stored form, with the tightest bounds there are.
    ///
    /// # Errors
    /// A wrong number of levels or of values, a height that is not finite, or facts outside the format.
    pub fn encode(&self, encoding: Encoding) -> Result<TextureTable, EncodeError> {
        let facts = self.facts();
        let descriptor = facts.descriptor(encoding);
        descriptor.check()?;
        let (found, expected) = (self.levels.len(), descriptor.mips);
        if found != expected as usize {
            return Err(EncodeError::Levels { found, expected });
        }
        let (mut min, mut max) = (f32::INFINITY, f32::NEG_INFINITY);
        for (level, values) in (0..).zip(self.levels) {
            let (width, height) = descriptor.picture_extent(level);
            count(values.len(), u64::from(width) * u64::from(height))?;
            let (least, greatest) = extent(&facts, values)?;
            (min, max) = (min.min(least), max.max(greatest));
        }
        encode_pictures(TableEncoder::new(&facts, encoding, min..=max)?, self.levels.iter().copied())
    }
}

fn count(found: usize, expected: u64) -> Result<(), EncodeError> {
    let found = found as u64;
    if found == expected { Ok(()) } else { Err(EncodeError::Count { found, expected }) }
}
