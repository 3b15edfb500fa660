//! What to bake beyond the flat horizon. Every field changes the bytes of the table.

use barchan_field::Grid;

use crate::BakeError;

/// The most points a texel may have in one direction, the flat horizon among them.
pub const MAX_POINTS: usize = 8;

/// The curvatures a scene lays the relief over, in the inverse of the field's length unit, positive where convex.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvatureRange {
    /// The most concave, or least convex.
    pub min: f64,
    /// The most convex.
    pub max: f64,
}

/// Which of several points of the relief counts that a flat surface shows at the same, highest slope, as flat tops of
/// one height and regular patterns do.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Tie {
    /// The nearest: the highest of them once the surface is convex, however slightly.
    Nearest,
    /// The farthest: the highest of them once it is concave; the rule of a horizon map for flat surfaces.
    Farthest,
}

/// How many points each texel has in each direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Points {
    /// So many, 1 to [`MAX_POINTS`]; 1 is the flat horizon alone.
    Count(u32),
    /// As few as keep the error of the angle at or below this, in degrees, for 99 of 100 texels and directions, at
    /// the worst curvature of the range for each. Positive.
    MaxErrorDegrees(f64),
}

/// Range and points of a curvature-swept horizon.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SweptParams {
    /// The curvatures that must come out right.
    pub range: CurvatureRange,
    /// How many points they may cost.
    pub points: Points,
}

impl CurvatureRange {
    /// The rule for the flat layer of this range: that of its more strongly curved side. A sweep may have it by a
    /// bend too small to matter, 1e-6 over the search radius.
    #[must_use]
    pub fn tie(&self) -> Tie {
        if self.max >= -self.min { Tie::Nearest } else { Tie::Farthest }
    }

    /// Refuses what is not a range, circles smaller than a texel, and a search that goes round the tightest hollow
    /// more than half.
    pub fn check(&self, grid: &Grid, radius: f64) -> Result<(), BakeError> {
        let Self { min, max } = *self;
        let refuse =
            |accepted| Err(BakeError::Parameter { name: "curvature", value: format!("{min} to {max}"), accepted });
        if !(min.is_finite() && max.is_finite() && min <= max) {
            return refuse("two finite numbers, the smaller first, are accepted");
        }
        let texel = grid.spacing.u().min(grid.spacing.v());
        if min.abs().max(max.abs()) * texel > 1.0 {
            return refuse("a radius of curvature of at least one texel is accepted");
        }
        if -min * radius >= std::f64::consts::PI {
            return refuse(
                "a concave radius of more than 1/π of the search radius is accepted: half round a hollow is behind",
            );
        }
        Ok(())
    }
}

impl SweptParams {
    /// Refuses parameters out of range, for a grid and the search radius of its horizon.
    pub fn check(&self, grid: &Grid, radius: f64) -> Result<(), BakeError> {
        self.range.check(grid, radius)?;
        let refuse = |name, value: String, accepted| Err(BakeError::Parameter { name, value, accepted });
        match self.points {
            Points::Count(count) if !(1..=MAX_POINTS as u32).contains(&count) => {
                refuse("points", count.to_string(), "1 to 8 points are accepted")
            }
            Points::MaxErrorDegrees(degrees) if !(degrees > 0.0 && degrees.is_finite()) => {
                refuse("max_error", degrees.to_string(), "a positive number of degrees is accepted")
            }
            _ => Ok(()),
        }
    }
}
