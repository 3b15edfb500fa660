//! Random numbers that are the same everywhere: a counter, hashed.

use std::f64::consts::TAU;

use crate::shapes::noise::hash;

/// A stream of numbers, one per seed.
#[derive(Debug, Clone)]
pub(super) struct Random {
    seed: u64,
    drawn: i64,
}

impl Random {
    pub(super) fn new(seed: u64) -> Self {
        Self { seed, drawn: 0 }
    }

    /// Evenly from 0 to 1, both excluded.
    pub(super) fn unit(&mut self) -> f64 {
        self.drawn += 1;
        ((hash(self.seed, self.drawn, 0) >> 12) as f64 + 0.5) * (1.0 / (1_u64 << 52) as f64)
    }

    /// With a bell-shaped distribution of mean 0 and standard deviation 1 (Box and Muller, 1958).
    pub(super) fn normal(&mut self) -> f64 {
        let radius = (-2.0 * libm::log(self.unit())).sqrt();
        radius * libm::cos(TAU * self.unit())
    }
}
