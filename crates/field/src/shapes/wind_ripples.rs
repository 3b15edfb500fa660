//! Wind ripples: asymmetric, sinuous, and forking.
//!
//! The phase is that of a plane wave times a complex noise, 1 + σ(n₁ + i n₂). Where the noise has a zero, the phase winds
//! once around it: a crest ends, and its neighbours close up, which is the tuning fork of real ripples (phase
//! singularities after Nye and Berry, *Dislocations in Wave Trains*, 1974; as a texture: Tricard et al., *Procedural
//! Phasor Noise*, 2019). The ripple fades where the modulus does, so the surface is continuous there. Zeros come in
//! pairs, so that the whole tiles without any bookkeeping.

use std::f64::consts::TAU;

use super::dunes::Dunes;
use super::noise::{GradientNoise, fade, stream};
use crate::Grid;

/// σ: larger means more forks.
const DISORDER: f64 = 0.75;
/// The modulus below which ripples fade.
const FADE: f64 = 0.35;
/// How far crests swerve, in wavelengths.
const SWERVE: f64 = 0.3;
/// How far ripples on a crest lag behind those on the ground, in wavelengths.
const LAG: f64 = 1.0;
/// How much steeper the lee side of a ripple is; 0 is symmetric, 1 vertical.
const SKEW: f64 = 0.6;

/// The ripples of one tile, of height 1.
pub(super) struct WindRipples {
    waves: f64,
    real: GradientNoise,
    imaginary: GradientNoise,
    swerve: GradientNoise,
    strength: GradientNoise,
}

impl WindRipples {
    pub(super) fn new(dunes: &Dunes, grid: &Grid) -> Self {
        let waves = f64::from(dunes.ripples_across);
        let waves_v = waves * grid.extent_v() / grid.extent_u();
        // Features so many wavelengths long along u and along v.
        let noise = |along_u: f64, along_v: f64, index: i64| {
            GradientNoise::new(waves / along_u, waves_v / along_v, 0.12, stream(dunes.seed, index))
        };
        Self {
            waves,
            real: noise(4.5, 11.0, 2),
            imaginary: noise(4.5, 11.0, 3),
            swerve: noise(7.0, 4.0, 4),
            strength: noise(9.0, 9.0, 5),
        }
    }

    /// Height above the sand between the ripples, 0 … 1, on a dune that rises to `lift` of the highest crest.
    pub(super) fn at(&self, u: f64, v: f64, lift: f64) -> f64 {
        let re = 1.0 + DISORDER * self.real.at(u, v);
        let im = DISORDER * self.imaginary.at(u, v);
        let turns = self.waves * u + SWERVE * self.swerve.at(u, v) + LAG * lift;
        let phase = TAU * turns + libm::atan2(im, re);
        let crest = 0.5 + 0.5 * libm::cos(phase - SKEW * libm::cos(phase));
        let strength = (0.8 + 0.2 * self.strength.at(u, v)).clamp(0.0, 1.0);
        // Crests are sharper than troughs.
        strength * fade(libm::hypot(re, im) / FADE) * crest * (0.5 + 0.5 * crest)
    }
}
