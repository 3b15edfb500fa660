//! Sinusoids: the relief for which slopes, curvature and horizon have textbook forms.

use std::f64::consts::TAU;

use serde::{Deserialize, Serialize};

use super::Surface;
use super::check::Check;
use crate::FieldError;

/// Whole waves across the tile. More than half as many waves as texels alias.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ripples {
    /// Half the height from trough to crest.
    pub amplitude: f64,
    /// Waves along u: the wave vector's component, of either sign. −65536 … 65536.
    pub waves_u: i32,
    /// Waves along v, upwards. −65536 … 65536, and not 0 together with `waves_u`.
    pub waves_v: i32,
    /// Shift in turns, −1 … 1; 0.25 puts a crest on the tile's lower left corner. Default 0.
    #[serde(default)]
    pub phase: f64,
    /// How the waves along u and v join. Default `oblique`.
    #[serde(default)]
    pub pattern: RipplePattern,
}

/// How the waves along the two axes join.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum RipplePattern {
    /// One train of straight crests: `a · sin 2π(waves_u u + waves_v v + phase)`.
    #[default]
    Oblique,
    /// The mean of a train along u and one along v: `½a · (sin 2π(waves_u u + phase) + sin 2π(waves_v v + phase))`.
    EggBox,
}

impl Ripples {
    pub(super) const NAME: &'static str = "ripples";

    pub(super) fn validate(&self) -> Result<(), FieldError> {
        let check = Check(Self::NAME);
        check.height("amplitude", self.amplitude)?;
        for (name, waves) in [("waves_u", self.waves_u), ("waves_v", self.waves_v)] {
            check.within(name, f64::from(waves), -65536.0..=65536.0, "a whole number from -65536 to 65536")?;
        }
        if self.waves_u == 0 && self.waves_v == 0 {
            return Err(check.refusal("waves_u", 0.0, "a wave along u or along v"));
        }
        check.within("phase", self.phase, -1.0..=1.0, "a shift from -1 to 1 turns")
    }

    pub(super) fn surface(self) -> Surface {
        let (m, n) = (f64::from(self.waves_u), f64::from(self.waves_v));
        let wave = move |turns: f64| libm::sin(TAU * (turns + self.phase));
        match self.pattern {
            RipplePattern::Oblique => Box::new(move |u, v| self.amplitude * wave(m * u + n * v)),
            RipplePattern::EggBox => Box::new(move |u, v| 0.5 * self.amplitude * (wave(m * u) + wave(n * v))),
        }
    }
}
