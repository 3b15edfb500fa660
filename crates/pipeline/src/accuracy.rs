//! How far a baked horizon is from the truth, measured on a sample of its texels.

use barchan_asset::HorizonView;
use barchan_bakers::horizon::{HorizonMap, reference};
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

impl HorizonAccuracy {
    /// Compares a map, and its stored form, with the reference.
    pub(crate) fn measure(field: &HeightField, map: &HorizonMap, stored: &HorizonView<'_>) -> Self {
        let texels = field.grid().texels() as u64;
        let samples = sample_count(field, map.params.radius).min(texels * u64::from(map.params.directions()));
        let (mut sweep, mut decoded) = (ErrorStats::default(), ErrorStats::default());
        for sample in 0..samples {
            let direction = (scramble(2 * sample) % u64::from(map.params.directions())) as u32;
            let texel = scramble(2 * sample + 1) % texels;
            let width = u64::from(field.grid().width);
            let (column, row) = ((texel % width) as u32, (texel / width) as u32);
            let truth = libm::atan(reference::horizon(field, &map.params, direction, column, row).slope);
            let degrees_off = |elevation: f32| (f64::from(elevation) - truth).to_degrees();
            sweep.add(degrees_off(map.elevation_layer(direction)[texel as usize]));
            decoded.add(degrees_off(stored.elevation_radians(direction, column, row)));
        }
        Self {
            samples,
            sweep_rms_degrees: sweep.rms(),
            sweep_max_degrees: sweep.max(),
            stored_rms_degrees: decoded.rms(),
            stored_max_degrees: decoded.max(),
        }
    }
}

fn sample_count(field: &HeightField, radius: f64) -> u64 {
    let spacing = field.grid().spacing;
    let cells = radius / spacing.u() + radius / spacing.v();
    (CELL_BUDGET / cells).clamp(64.0, 4096.0) as u64
}

/// A bijection that spreads consecutive numbers: Steele, Lea, Flood, *Fast splittable pseudorandom number generators*,
/// 2014.
fn scramble(index: u64) -> u64 {
    let mut z = index.wrapping_add(1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}
