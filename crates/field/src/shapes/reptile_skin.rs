//! Reptile skin, the bumps of figure 6 of Onoue, Max and Nishita (*Bumpmap Shadows on Curved Surfaces*).
//!
//! Worley (*A Cellular Texture Basis Function*, 1996) cuts the plane into the cells of scattered points. Here the points
//! are a jittered hexagonal lattice that closes over the torus, and the cells are those of a power diagram
//! (Aurenhammer, *Power Diagrams: Properties, Algorithms and Applications*, 1987), so that large scales sit between small ones.
//!
//! Departure: height follows the exact distance to the cell's border instead of F2 − F1, which is not a length, and the
//! distances to the border's sides are joined by a soft minimum, which rounds the polygon's corners. A soft minimum is
//! never above the minimum, so the border itself always lies in the groove, at height 0, whichever scale it is seen
//! from: the surface is continuous, although each scale has a height, a tilt and a dome of its own.

use serde::{Deserialize, Serialize};

use super::Surface;
use super::check::{Check, half};
use super::noise::{GradientNoise, eased, fade, hash, signed, stream};
use crate::{FieldError, Grid};

/// Rounded polygonal scales with grooves between them.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ReptileSkin {
    /// From the bottom of the grooves, at height 0, to the tops of the larger scales, a length. Never negative; no scale is
    /// higher by more than a half.
    pub scale_height: f64,
    /// Scales across the tile's width, 1 … 65536. Along v they are as large, to the nearest even number of rows; on a
    /// tile too low for two rows they are squeezed.
    pub scales_across: u32,
    /// 0: regular hexagons of one size; 1: so irregular that some scales are swallowed. Default ½.
    #[serde(default = "half")]
    pub irregularity: f64,
    /// Any number; another seed is another skin. Default 0.
    #[serde(default)]
    pub seed: u64,
}

impl ReptileSkin {
    pub(super) const NAME: &'static str = "reptile_skin";

    pub(super) fn validate(&self) -> Result<(), FieldError> {
        let check = Check(Self::NAME);
        check.rise("scale_height", self.scale_height)?;
        check.count("scales_across", self.scales_across)?;
        check.within("irregularity", self.irregularity, 0.0..=1.0, "a number from 0 to 1")
    }

    pub(super) fn surface(self, grid: &Grid) -> Surface {
        let skin = Skin::new(&self, grid);
        Box::new(move |u, v| skin.height(u, v))
    }
}

// Lengths below are in pitches: the width of a regular scale.

/// How far a site strays at irregularity 1, and how far its power weight does.
const JITTER: f64 = 0.26;
/// Half the width of a groove's floor.
const GROOVE: f64 = 0.012;
/// The width over which the floor curves into the flank.
const FILLET: f64 = 0.02;
/// How far in from the groove a scale has risen to about 1 − 1/e.
const RIM: f64 = 0.12;
/// The soft minimum's sharpness: corners are rounded over about one over this.
const ROUNDING: f64 = 20.0;
/// How much a scale falls off from its middle, per squared pitch.
const DOME: f64 = 0.9;
/// Rise per pitch towards the scale's free edge, along +u and +v.
const TILT: [f64; 2] = [0.25, 0.12];
/// Growth rings along a scale's rim: their height relative to the scale, and their radians per pitch.
const RINGS: (f64, f64) = (0.02, 90.0);
/// Leathery grain: its standard deviation relative to the scale, and grains per pitch.
const GRAIN: (f64, f64) = (0.006, 11.0);

/// The scales of one tile.
struct Skin {
    height: f64,
    columns: i64,
    /// Even, because every other row is shifted by half a pitch.
    rows: i64,
    /// Distance between rows: √3/2 where the extents allow it.
    row_pitch: f64,
    irregularity: f64,
    seed: u64,
    grain: GradientNoise,
}

/// One scale.
#[derive(Clone, Copy)]
struct Scale {
    x: f64,
    y: f64,
    /// Added to the squared radius that the scale claims.
    weight: f64,
    /// Relative to the highest.
    height: f64,
}

impl Scale {
    fn squared_distance(&self, x: f64, y: f64) -> f64 {
        (x - self.x) * (x - self.x) + (y - self.y) * (y - self.y)
    }

    fn power(&self, x: f64, y: f64) -> f64 {
        self.squared_distance(x, y) - self.weight
    }
}

impl Skin {
    fn new(skin: &ReptileSkin, grid: &Grid) -> Self {
        let across = skin.scales_across.max(1);
        let columns = f64::from(across);
        let pitch = grid.extent_u() / columns;
        let pairs = libm::round(grid.extent_v() / (pitch * libm::sqrt(3.0))).clamp(1.0, 1e9);
        let grains = columns * GRAIN.1;
        Self {
            height: skin.scale_height,
            columns: i64::from(across),
            rows: 2 * pairs as i64,
            row_pitch: (grid.extent_v() / (2.0 * pairs * pitch)).clamp(0.5, 2.0),
            irregularity: skin.irregularity,
            seed: stream(skin.seed, 0),
            grain: GradientNoise::new(grains, grains * grid.extent_v() / grid.extent_u(), 0.4, stream(skin.seed, 1)),
        }
    }

    fn height(&self, u: f64, v: f64) -> f64 {
        let (x, y) = (u * self.columns as f64, v * self.rows as f64 * self.row_pitch);
        let near = self.neighbourhood(x, y);
        let own =
            (1..near.len()).fold(0, |best, k| if near[k].power(x, y) < near[best].power(x, y) { k } else { best });
        let inset = rounded_inset(&near, own, x, y);
        let scale = &near[own];
        let dome = 1.0 - DOME * scale.squared_distance(x, y);
        let tilt = 1.0 + TILT[0] * (x - scale.x) + TILT[1] * (y - scale.y);
        let grain = 1.0 + GRAIN.0 * self.grain.at(u, v);
        self.height * scale.height * rim(inset) * dome.max(0.0) * tilt.max(0.0) * grain
    }

    /// The scales around a point: all that can own it, and all that can border on those.
    fn neighbourhood(&self, x: f64, y: f64) -> [Scale; 25] {
        let row = libm::floor(y / self.row_pitch + 0.5) as i64;
        std::array::from_fn(|k| {
            let j = row - 2 + k as i64 / 5;
            let shift = 0.5 * (j & 1) as f64;
            let i = libm::floor(x - shift + 0.5) as i64 - 2 + k as i64 % 5;
            self.scale(i, j, shift)
        })
    }

    fn scale(&self, i: i64, j: i64, shift: f64) -> Scale {
        let h = hash(self.seed, i.rem_euclid(self.columns), j.rem_euclid(self.rows));
        let stray = |index: u32| self.irregularity * signed(h, index);
        Scale {
            x: i as f64 + shift + JITTER * stray(0),
            y: (j as f64 + JITTER * stray(1)) * self.row_pitch,
            weight: JITTER * stray(2),
            height: 0.9 + 0.06 * stray(3) + 0.15 * stray(2),
        }
    }
}

/// Distance from `(x, y)` to the border of the scale that owns it, with its corners rounded; never above the true
/// distance, so at most 0 on the border.
fn rounded_inset(near: &[Scale; 25], own: usize, x: f64, y: f64) -> f64 {
    let (p, own_power) = (near[own], near[own].power(x, y));
    let mut sum = 0.0;
    for (_, q) in near.iter().enumerate().filter(|&(k, _)| k != own) {
        let apart = libm::sqrt(p.squared_distance(q.x, q.y));
        sum += libm::exp(-ROUNDING * (q.power(x, y) - own_power) / (2.0 * apart));
    }
    -libm::log(sum) / ROUNDING
}

/// A scale's flank and rim by distance from its border: 0 in the groove, towards 1 inside, with faint growth rings.
fn rim(inset: f64) -> f64 {
    let t = (inset - GROOVE).max(0.0);
    let rise = eased(t, FILLET) / RIM;
    let rings = libm::cos(RINGS.1 * inset) * libm::exp(-9.0 * inset) * fade((inset - 0.03) / 0.06);
    (1.0 - libm::exp(-rise * (1.0 + 0.5 * rise))) * (1.0 + RINGS.0 * rings)
}
