//! The crest lines of dunes, seen from above.
//!
//! Lengths are in distances between dunes: ridge `j` of a field of `n` lies around x = j + ½, and the tile is `n` wide.
//! Positions along a crest are fractions `v` of the tile.

use std::f64::consts::TAU;

use super::dunes::Dunes;
use super::noise::{CircleNoise, hash, signed, stream};

/// Length of a lobe along the crest.
const LOBE: f64 = 1.45;
/// How far lobes, wandering and small bends take the crest at sinuosity 1.
const STRAY: [f64; 3] = [0.26, 0.2, 0.012];
/// The lobes' second harmonic: it widens the bays and sharpens the points that reach downwind.
const POINTED: f64 = 0.12;
/// How much the points and the wandering lower the crest at sinuosity 1. Together below 1.
const LOWER: [f64; 2] = [0.75, 0.22];

/// All crest lines of a tile.
pub(super) struct Crests {
    dunes: i64,
    /// Extent of the tile along v.
    aspect: f64,
    /// Whole lobes around the tile along v.
    lobes: f64,
    sinuosity: f64,
    seed: u64,
}

/// A point of a crest line.
pub(super) struct Crest {
    /// From the border of the ridge's own strip.
    pub(super) x: f64,
    /// Relative to the highest.
    pub(super) height: f64,
    /// dx/dy, lengths along both.
    lean: f64,
}

impl Crests {
    pub(super) fn new(dunes: &Dunes, aspect: f64) -> Self {
        let lobes = libm::round(aspect / LOBE).max(1.0);
        // On a tile too low for a lobe the crests lean no more than elsewhere.
        let squeeze = (aspect / lobes).min(1.0);
        let sinuosity = dunes.sinuosity * squeeze * squeeze;
        Self { dunes: i64::from(dunes.dunes_across.max(1)), aspect, lobes, sinuosity, seed: stream(dunes.seed, 0) }
    }

    /// The crest of a ridge at `v`.
    pub(super) fn at(&self, ridge: i64, v: f64) -> Crest {
        let h = hash(self.seed, ridge, 0);
        // Half a lobe from each ridge to the next, as nearly as the ridges close around the torus.
        let stagger = (ridge * (self.dunes / 2)).rem_euclid(self.dunes) as f64 / self.dunes as f64;
        let angle = TAU * (self.lobes * v + stagger + 0.15 * signed(h, 0));
        let (sin, cos) = (libm::sin(angle), libm::cos(angle));
        let lobe = -cos + POINTED * (2.0 * cos * cos - 1.0);
        let lobe_slope = TAU * self.lobes * (sin - 4.0 * POINTED * sin * cos);
        let (wander, wander_slope) = self.noise(ridge, 1, 1.3).at(v);
        let (bend, bend_slope) = self.noise(ridge, 2, 4.0).at(v);
        let [a, b, c] = STRAY.map(|stray| stray * self.sinuosity);
        let lower = 0.5 * (LOWER[0] * (1.0 - cos) + LOWER[1] * (1.0 + wander));
        Crest {
            x: 0.5 + 0.04 * signed(h, 1) + a * lobe + b * wander + c * bend,
            height: 1.0 - self.sinuosity * lower,
            lean: (a * lobe_slope + b * wander_slope + c * bend_slope) / self.aspect,
        }
    }

    /// Noise along a ridge with about `knots` knots per distance between dunes.
    fn noise(&self, ridge: i64, index: i64, knots: f64) -> CircleNoise {
        CircleNoise::new(libm::floor(knots * self.aspect) + 1.0, hash(self.seed, ridge, index))
    }

    /// The crest point nearest to `(x, v)` and the distance to it.
    ///
    /// Three damped Gauss–Newton steps: enough where the crest bends less sharply than it is far away. Where it bends
    /// more there are several near points, and stopping early blends them instead of jumping from one to another. The
    /// distance is to the point found, so it is never less than the true one: far from the crest, where the steps may
    /// land anywhere, no slip face appears from nowhere.
    pub(super) fn nearest(&self, ridge: i64, x: f64, v: f64) -> (Crest, f64) {
        let mut t = v;
        for _ in 0..3 {
            let crest = self.at(ridge, t);
            let along = (x - crest.x) * crest.lean + (v - t) * self.aspect;
            t += 0.8 * along / (1.0 + crest.lean * crest.lean) / self.aspect;
        }
        let crest = self.at(ridge, t);
        let distance = libm::hypot(x - crest.x, (v - t) * self.aspect);
        (crest, distance)
    }
}
