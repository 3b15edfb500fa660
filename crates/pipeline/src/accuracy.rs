//! How far a baked horizon is from the truth, measured on a sample of its texels while its directions pass.

use barchan_bakers::horizon::{HorizonParams, reference};
use barchan_field::HeightField;
use barchan_metrics::ErrorStats;
use serde::{Deserialize, Serialize};

/// The reference walks this many cells at most, whatever the radius.
const CELL_BUDGET: f64 = 4e6;

/// Angle errors against the f64 reference, in degrees, over a fixed pseudo-random sample of texels and azimuths.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct HorizonAccuracy {
    /// Texels and azimuths looked at.
    pub samples: u64,
    /// RMS error of the sweep, before encoding.
    pub sweep_rms_degrees: f64,
    /// Its largest error.
    pub sweep_max_degrees: f64,
    /// RMS error of what a reader decodes.
    pub stored_rms_degrees: f64,
    /// Its largest error.
    pub stored_max_degrees: f64,
}

/// The sample: which values are kept as they pass, and what they were before and after encoding.
pub(crate) struct AccuracySample {
    /// By direction, then in the order they were drawn.
    places: Vec<SampledPlace>,
    width: u32,
}

/// A value of the table.
#[derive(Debug, Clone, Copy)]
struct SampledPlace {
    direction: u32,
    texel: usize,
    baked_radians: f32,
    stored_radians: f32,
}

impl AccuracySample {
    /// Draws the sample of a map: all of a map that is smaller.
    pub(crate) fn new(field: &HeightField, params: &HorizonParams) -> Self {
        let (texels, directions) = (field.grid().texels() as u64, u64::from(params.directions()));
        let (count, all) = (sample_count(field, params.radius), texels * directions);
        let place = |(direction, texel): (u64, u64)| SampledPlace {
            direction: direction as u32,
            texel: texel as usize,
            baked_radians: 0.0,
            stored_radians: 0.0,
        };
        let mut places: Vec<_> = match all <= count {
            true => (0..all).map(|index| place((index / texels, index % texels))).collect(),
            false => (0..count)
                .map(|sample| place((scramble(2 * sample) % directions, scramble(2 * sample + 1) % texels)))
                .collect(),
        };
        places.sort_by_key(|place| place.direction);
        Self { places, width: field.grid().width }
    }

    /// Keeps what is wanted of a direction: elevations as baked, and what a reader will decode at a column and a row.
    pub(crate) fn take(&mut self, direction: u32, elevations: &[f32], stored: impl Fn(u32, u32) -> f32) {
        let start = self.places.partition_point(|place| place.direction < direction);
        for place in self.places[start..].iter_mut().take_while(|place| place.direction == direction) {
            let (column, row) = column_and_row(place.texel, self.width);
            place.baked_radians = elevations[place.texel];
            place.stored_radians = stored(column, row);
        }
    }

    /// Compares what was kept with the reference.
    pub(crate) fn measure(&self, field: &HeightField, params: &HorizonParams) -> HorizonAccuracy {
        let (mut sweep, mut stored) = (ErrorStats::default(), ErrorStats::default());
        for place in &self.places {
            let (column, row) = column_and_row(place.texel, self.width);
            let truth = libm::atan(reference::horizon(field, params, place.direction, column, row).slope);
            let degrees_off = |elevation: f32| (f64::from(elevation) - truth).to_degrees();
            sweep.add(degrees_off(place.baked_radians));
            stored.add(degrees_off(place.stored_radians));
        }
        HorizonAccuracy {
            samples: self.places.len() as u64,
            sweep_rms_degrees: sweep.rms(),
            sweep_max_degrees: sweep.max(),
            stored_rms_degrees: stored.rms(),
            stored_max_degrees: stored.max(),
        }
    }
}

fn column_and_row(texel: usize, width: u32) -> (u32, u32) {
    ((texel % width as usize) as u32, (texel / width as usize) as u32)
}

fn sample_count(field: &HeightField, radius: f64) -> u64 {
    let spacing = field.grid().spacing;
    let cells = radius / spacing.u() + radius / spacing.v();
    (CELL_BUDGET / cells).clamp(64.0, 4096.0) as u64
}

/// A bijection that spreads consecutive numbers: Steele, Lea, Flood, *Fast splittable pseudorandom number generators*,
/// 2014.
pub(crate) fn scramble(index: u64) -> u64 {
    let mut z = index.wrapping_add(1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}
