//! Wind-rippled dunes, the relief of figures 8 and 9 of Onoue, Max and Nishita (*Bumpmap Shadows on Curved Surfaces*).
//!
//! A dune is a gentle windward ramp up to a brink, and behind the brink a slip face at the angle of repose, on which sand
//! slides instead of being blown (Bagnold, *The Physics of Blown Sand and Desert Dunes*, 1941). Here each dune is its crest
//! line: the ramp is a smooth step of the distance along the wind, the slip face falls off with the distance from the
//! *nearest* point of the crest, so that its steepness does not depend on how the crest winds, and ends in a short apron.
//! Crests are highest where they lie farthest upwind and low where they reach downwind, half a lobe apart from one
//! ridge to the next: the barchanoid ridges between transverse dunes and barchans. Where dunes overlap the higher one
//! shows, which leaves the crease that real slip faces have at their foot. Ripples ride on all but the slip faces.
//!
//! Departure: nothing blows. There is no conservation of sand and no airflow; this is what such a field looks like.

use std::f64::consts::PI;

use serde::{Deserialize, Serialize};

use super::Surface;
use super::check::Check;
use super::crests::Crests;
use super::noise::{GradientNoise, eased, fade, stream};
use super::wind_ripples::WindRipples;
use crate::{FieldError, Grid};

/// Wind-rippled dunes. The wind blows along +u.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Dunes {
    /// From the ground, at height 0, to the highest crests, a length. At most `0.45 · tan(slip_degrees)` of the distance
    /// between dunes (`extent_u / dunes_across`), beyond which slip faces would bury the next dune.
    pub dune_height: f64,
    /// Ridges across the tile's width, one behind the other, 1 … 1024.
    pub dunes_across: u32,
    /// Height of the wind ripples from trough to crest, a length; 0 leaves them out.
    pub ripple_height: f64,
    /// Wind ripples across the tile's width, 1 … 65536.
    pub ripples_across: u32,
    /// 0: straight transverse ridges; 1: ridges that all but fall apart into crescents. Default 0.6.
    #[serde(default = "winding")]
    pub sinuosity: f64,
    /// Steepness of the slip faces in degrees, 10 … 45. Default 32, the angle of repose of dry sand.
    #[serde(default = "repose")]
    pub slip_degrees: f64,
    /// Any number; another seed is another desert. Default 0.
    #[serde(default)]
    pub seed: u64,
}

fn winding() -> f64 {
    0.6
}

fn repose() -> f64 {
    32.0
}

impl Dunes {
    pub(super) const NAME: &'static str = "dunes";

    pub(super) fn validate(&self) -> Result<(), FieldError> {
        let check = Check(Self::NAME);
        check.rise("dune_height", self.dune_height)?;
        check.within("dunes_across", f64::from(self.dunes_across), 1.0..=1024.0, "a count from 1 to 1024")?;
        check.rise("ripple_height", self.ripple_height)?;
        check.count("ripples_across", self.ripples_across)?;
        check.within("sinuosity", self.sinuosity, 0.0..=1.0, "a number from 0 to 1")?;
        check.within("slip_degrees", self.slip_degrees, 10.0..=45.0, "an angle from 10 to 45 degrees")
    }

    pub(super) fn validate_over(&self, grid: &Grid) -> Result<(), FieldError> {
        let most = LONGEST_SLIP * self.slip() * grid.extent_u() / f64::from(self.dunes_across);
        let accepted =
            "at most 0.45 · tan(slip_degrees) of the distance between dunes (the extent along u / dunes_across)";
        Check(Self::NAME).within("dune_height", self.dune_height, 0.0..=most, accepted)
    }

    /// The slope of slip faces.
    fn slip(&self) -> f64 {
        libm::tan(self.slip_degrees * (PI / 180.0))
    }

    pub(super) fn surface(self, grid: &Grid) -> Surface {
        let (field, ripples) = (DuneField::new(&self, grid), WindRipples::new(&self, grid));
        let dunes = f64::from(self.dunes_across);
        Box::new(move |u, v| {
            let dune = field.at(u * dunes, v);
            let ripple = self.ripple_height * dune.swept;
            self.dune_height * dune.lift + if ripple > 0.0 { ripple * ripples.at(u, v, dune.lift) } else { 0.0 }
        })
    }
}

// Lengths below are in distances between dunes, or relative to the height of the highest crests.

/// From crest to foot along the slip face, at most.
const LONGEST_SLIP: f64 = 0.45;
/// From foot to crest along the windward ramp.
const RAMP: f64 = 0.95;
/// Standard deviation of the swell halfway up the ramp, relative to the ramp.
const SWELL: f64 = 0.1;
/// Onset of the slip face behind the brink, relative to the rise.
const BRINK: f64 = 0.1;
/// Height of a slip face above the ground, relative to its crest, below which it runs out into an apron.
const APRON: f64 = 0.12;
/// Height of a slip face above the ground, relative to the rise, over which ripples fade in.
const SWEPT: f64 = 0.05;

/// The dunes beneath the ripples.
struct DuneField {
    crests: Crests,
    dunes: i64,
    /// Height of the highest crests.
    rise: f64,
    /// The slope of slip faces.
    slip: f64,
    swell: GradientNoise,
}

/// A point of the dunes' surface.
struct Dune {
    /// Height relative to the highest crests.
    lift: f64,
    /// 1 where wind sweeps the sand into ripples, 0 on slip faces.
    swept: f64,
}

impl DuneField {
    fn new(dunes: &Dunes, grid: &Grid) -> Self {
        let across = dunes.dunes_across.max(1);
        let n = f64::from(across);
        let spacing = grid.extent_u() / n;
        let aspect = grid.extent_v() / spacing;
        Self {
            crests: Crests::new(dunes, aspect),
            dunes: i64::from(across),
            rise: dunes.dune_height / spacing,
            slip: dunes.slip(),
            swell: GradientNoise::new(2.0 * n, 2.0 * aspect, 0.5, stream(dunes.seed, 1)),
        }
    }

    fn at(&self, x: f64, v: f64) -> Dune {
        if self.rise == 0.0 {
            return Dune { lift: 0.0, swept: 1.0 };
        }
        // Crests stray by about half a distance, so only these can reach x, from ahead by a ramp, from behind by a slip.
        let first = libm::floor(x) as i64 - 2;
        let (mut ground, mut lee, mut past) = (0.0f64, 0.0, 0.0);
        for j in first..first + 4 {
            let ridge = j.rem_euclid(self.dunes);
            let crest = self.crests.at(ridge, v);
            let ahead = j as f64 + crest.x - x;
            if ahead > 0.0 {
                ground = ground.max(crest.height * self.ramp(ahead, x, v));
            } else if ahead > -2.0 {
                let (height, behind) = self.slip_face(ridge, x - j as f64, v);
                if height > lee {
                    (lee, past) = (height, behind);
                }
            }
        }
        let covered = fade((lee - ground) / SWEPT) * fade(past / BRINK);
        Dune { lift: lee.max(ground), swept: 1.0 - covered }
    }

    /// The windward side, relative to the crest that lies `ahead`.
    fn ramp(&self, ahead: f64, x: f64, v: f64) -> f64 {
        let t = 1.0 - (ahead / RAMP).min(1.0);
        let ramp = t * t * (3.0 - 2.0 * t);
        let swell = 4.0 * SWELL * ramp * (1.0 - ramp);
        if swell > 0.0 { ramp * (1.0 + swell * self.swell.at(x / self.dunes as f64, v)) } else { ramp }
    }

    /// The lee side and the distance from the brink, both relative to the rise.
    fn slip_face(&self, ridge: i64, x: f64, v: f64) -> (f64, f64) {
        let (crest, distance) = self.crests.nearest(ridge, x, v);
        let behind = distance / self.rise;
        let (slope_line, apron) = (crest.height - self.slip * eased(behind, BRINK), APRON * crest.height);
        let height = if slope_line < apron {
            let above = (slope_line + apron).max(0.0);
            above * above / (4.0 * apron)
        } else {
            slope_line
        };
        (height, behind)
    }
}
