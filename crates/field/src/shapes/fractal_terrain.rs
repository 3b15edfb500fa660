//! Fractal relief: fractional Brownian motion by octaves of gradient noise.
//!
//! Mandelbrot and Van Ness (*Fractional Brownian Motions, Fractional Noises and Applications*, 1968): the mean squared
//! difference of two heights grows as distance^2H. Here each octave is finer than the last by √5 and lower by √5^H, so
//! the law holds between the finest and the coarsest feature. Departure: the octaves are finite in number and the tile
//! repeats, so the law ends at both scales. Each octave is turned by atan ½ against the last (2 + i has no power on the
//! real axis), so that no direction of the lattice adds up.

use serde::{Deserialize, Serialize};

use super::Surface;
use super::check::Check;
use super::noise::{GradientNoise, stream};
use crate::{FieldError, Grid};

/// Periodic fractal relief around height 0.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FractalTerrain {
    /// Six standard deviations of the height, over many seeds: about the difference between the deepest valley and the
    /// highest summit. Not a bound. Never negative.
    pub height: f64,
    /// Hurst exponent H, above 0 and at most 1: 0.5 is rugged, 0.8 eroded, 1 rolling.
    pub hurst: f64,
    /// Coarsest features across the tile's width, 1 … 1024. Their size is the same along v.
    pub features_across: u32,
    /// Octaves, 1 … 16, each finer than the last by √5. More than the texels resolve alias into roughness. Default 8.
    #[serde(default = "eight")]
    pub octaves: u32,
    /// Any number; another seed is another terrain. Default 0.
    #[serde(default)]
    pub seed: u64,
}

fn eight() -> u32 {
    8
}

/// The factor between octaves.
const LACUNARITY: f64 = 2.236_067_977_499_79;
/// atan ½, the angle between octaves, in radians.
const TURN: f64 = 0.463_647_609_000_806_1;

impl FractalTerrain {
    pub(super) const NAME: &'static str = "fractal_terrain";

    pub(super) fn validate(&self) -> Result<(), FieldError> {
        let check = Check(Self::NAME);
        check.rise("height", self.height)?;
        check.within("hurst", self.hurst, 1e-3..=1.0, "a Hurst exponent above 0 (at least 0.001) and at most 1")?;
        check.within("features_across", f64::from(self.features_across), 1.0..=1024.0, "a count from 1 to 1024")?;
        check.within("octaves", f64::from(self.octaves), 1.0..=16.0, "a count from 1 to 16")
    }

    pub(super) fn surface(self, grid: &Grid) -> Surface {
        let octaves = self.octaves(grid);
        Box::new(move |u, v| octaves.iter().map(|(gain, noise)| gain * noise.at(u, v)).sum())
    }

    /// Gain and noise of each octave, coarsest first; the gains' squares sum to the variance.
    fn octaves(&self, grid: &Grid) -> Vec<(f64, GradientNoise)> {
        let ratio = libm::pow(LACUNARITY, -self.hurst);
        let mut octaves = Vec::new();
        let (mut cells, mut gain, mut power) = (f64::from(self.features_across), 1.0, 0.0);
        for k in 0..self.octaves {
            let cells_v = cells * grid.extent_v() / grid.extent_u();
            let noise = GradientNoise::new(cells, cells_v, f64::from(k) * TURN, stream(self.seed, i64::from(k)));
            octaves.push((gain, noise));
            power += gain * gain;
            gain *= ratio;
            cells *= LACUNARITY;
        }
        let scale = self.height / 6.0 / libm::sqrt(power);
        octaves.iter_mut().for_each(|(gain, _)| *gain *= scale);
        octaves
    }
}
