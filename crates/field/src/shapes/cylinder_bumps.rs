//! Rows of half-cylinders, the bumps of figure 4 of Onoue, Max and Nishita (*Bumpmap Shadows on Curved Surfaces*).
//!
//! The profile is half an ellipse, vertical where it meets the ground: unbounded slopes at known places, which is what
//! makes it a good test. It is half a circle, as in the paper, when `height` is `½ · coverage · extent / rows`.

use serde::{Deserialize, Serialize};

use super::check::Check;
use super::{Axis, Surface};
use crate::FieldError;

/// Parallel half-cylinders on ground of height 0.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CylinderBumps {
    /// Height of the ridge line; a negative one is a gutter.
    pub height: f64,
    /// Cylinders across the tile, 1 … 65536.
    pub rows: u32,
    /// The part of each row's width that the cylinder covers, above 0 and at most 1. Default 1: they touch.
    #[serde(default = "all")]
    pub coverage: f64,
    /// The axis along which rows are counted; the cylinders lie at a right angle to it. Default `u`.
    #[serde(default)]
    pub across: Axis,
}

fn all() -> f64 {
    1.0
}

impl CylinderBumps {
    pub(super) const NAME: &'static str = "cylinder_bumps";

    pub(super) fn validate(&self) -> Result<(), FieldError> {
        let check = Check(Self::NAME);
        check.height("height", self.height)?;
        check.count("rows", self.rows)?;
        check.within("coverage", self.coverage, 1e-6..=1.0, "a part from 1e-6 to 1")
    }

    pub(super) fn surface(self) -> Surface {
        let rows = f64::from(self.rows);
        Box::new(move |u, v| {
            let turns = self.across.of(u, v) * rows;
            // −1 … 1 across the cylinder, 0 on its ridge.
            let across = (turns - turns.floor() - 0.5) * 2.0 / self.coverage;
            self.height * libm::sqrt((1.0 - across * across).max(0.0))
        })
    }
}
