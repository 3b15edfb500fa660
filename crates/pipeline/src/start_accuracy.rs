//! How near to the surface a hemisphere table lets rays start, measured on a sample of rays while its layers pass.

use barchan_bakers::hemisphere::HemisphereParams;
use barchan_bakers::hemisphere::reference::FirstHits;
use barchan_field::HeightField;
use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::accuracy::scramble;

/// The reference crosses about this many cells at most, all rays together.
const CELL_BUDGET: f64 = 4e6;

/// Where a start is beyond the first hit by no more of the relief's thickness, that may be the rounding of both.
const ROUNDING: f64 = 1.0 / (1 << 20) as f64;

/// Depths at which rays start, by the stored table, against those of their first hits, by the f64 reference. The rays are a fixed
/// pseudo-random sample: all cells of directions alike, any direction of a cell, entering anywhere. Depths are 0 at the top and 1 at
/// the bottom of the relief.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct StartAccuracy {
    /// Rays followed.
    pub samples: u64,
    /// The mean depth of a start.
    pub mean_start: f64,
    /// The mean depth of a first hit.
    pub mean_hit: f64,
    /// The share of the rays that start beyond their first hit, 0 to 1; of a conservative table 0.
    pub beyond_share: f64,
    /// How far beyond at most, as a depth.
    pub beyond_max: f64,
}

/// The sample: rays, and the starts that are read as their layers pass.
pub(crate) struct StartSample {
    /// By layer.
    rays: Vec<SampledRay>,
    /// Texels of the heights along u and v.
    from: (u32, u32),
    /// Texels of the table along u and v.
    to: (u32, u32),
}

/// A ray and its start.
#[derive(Debug, Clone, Copy)]
struct SampledRay {
    layer: u32,
    /// Where it enters: texels of the heights from the centre of texel (0, 0), rows downwards.
    entry: (f64, f64),
    /// The unit vector towards the eye or the light.
    towards: DVec3,
    start: f64,
}

impl StartSample {
    pub(crate) fn new(surface: &HeightField, params: &HemisphereParams) -> Self {
        let grid = surface.grid();
        let mut rays: Vec<_> = (0..ray_count(surface, params)).map(|index| ray(surface, params, index)).collect();
        rays.sort_by_key(|ray| ray.layer);
        Self { rays, from: (grid.width, grid.height), to: (params.width, params.height) }
    }

    /// Reads the starts of a layer: what a reader will decode at a column and a row.
    pub(crate) fn take(&mut self, layer: u32, stored: impl Fn(u32, u32) -> f32) {
        let first = self.rays.partition_point(|ray| ray.layer < layer);
        // A place that rounding puts on the far border is in the last texel.
        let texel =
            |place: f64, from: u32, to: u32| (((place + 0.5) / f64::from(from) * f64::from(to)) as u32).min(to - 1);
        for ray in self.rays[first..].iter_mut().take_while(|ray| ray.layer == layer) {
            let (x, y) = ray.entry;
            ray.start = stored(texel(x, self.from.0, self.to.0), texel(y, self.from.1, self.to.1)).into();
        }
    }

    /// Follows the rays.
    pub(crate) fn measure(&self, surface: &HeightField) -> StartAccuracy {
        let count = self.rays.len() as f64;
        let first_hits = FirstHits::of(surface);
        let (mut starts, mut hits, mut beyond, mut beyond_max) = (0.0, 0.0, 0_u64, 0.0_f64);
        for &SampledRay { entry: (x, y), towards, start, .. } in &self.rays {
            let hit = first_hits.find(x, y, towards);
            starts += start;
            hits += hit;
            if start > hit + ROUNDING {
                beyond += 1;
                beyond_max = beyond_max.max(start - hit);
            }
        }
        StartAccuracy {
            samples: self.rays.len() as u64,
            mean_start: starts / count,
            mean_hit: hits / count,
            beyond_share: beyond as f64 / count,
            beyond_max,
        }
    }
}

fn ray_count(surface: &HeightField, params: &HemisphereParams) -> u64 {
    let (lowest, highest) = surface.range();
    let spacing = surface.grid().spacing;
    let reach = (f64::from(highest) - f64::from(lowest)) * params.directions.tangent_of_edge(params.directions.rings);
    let cells = 1.0 + reach / spacing.u() + reach / spacing.v();
    (CELL_BUDGET / cells).clamp(64.0, 4096.0) as u64
}

/// A ray of the sample, by its number.
fn ray(surface: &HeightField, params: &HemisphereParams, index: u64) -> SampledRay {
    let random = |what: u64| (scramble(5 * index + what) >> 11) as f64 / (1_u64 << 53) as f64;
    let (grid, directions) = (surface.grid(), &params.directions);
    let layer = (scramble(5 * index) % u64::from(directions.layers())) as u32;
    let (ring, azimuth) = directions.ring_and_azimuth(layer);
    let (inner, outer) = (directions.tangent_of_edge(ring), directions.tangent_of_edge(ring + 1));
    let tangent = inner + random(1) * (outer - inner);
    let azimuth = directions.azimuths.radians(azimuth) + (random(2) - 0.5) * directions.azimuths.step_radians();
    let height = 1.0 / libm::sqrt(1.0 + tangent * tangent);
    let horizontal = tangent * height;
    SampledRay {
        layer,
        entry: (random(3) * f64::from(grid.width) - 0.5, random(4) * f64::from(grid.height) - 0.5),
        towards: DVec3::new(horizontal * libm::cos(azimuth), horizontal * libm::sin(azimuth), height),
        start: 0.0,
    }
}
