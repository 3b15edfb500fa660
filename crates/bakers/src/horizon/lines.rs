//! The lines a direction is swept along, and the heights beside them.
//!
//! A direction is cut into parallel lines one texel apart; line `i` leaves column 0 at row `i` and drops by the octant's
//! tilt per column. In every column each texel belongs to the line that passes nearest to its centre, at most half a
//! texel off, so the ray of a texel runs at a fixed small offset beside its line. Sheared along the lines, what a ray
//! meets in a column lies within two rows of where it started: neighbouring texels are neighbours in memory at any
//! distance along the ray, which is what lets sixteen of them be swept at once.

use barchan_field::{Edge, HeightField};

use super::HorizonParams;
use super::direction::{Octant, RayStep};

/// Rows kept on both sides of a block's own.
pub(crate) const MARGIN: usize = 4;

/// Lines swept together.
pub(crate) const LINES: usize = 64;

/// Heights of a block in one column.
pub(crate) const STRIDE: usize = LINES + 2 * MARGIN;

/// The lines of one direction. "Column" and "row" count along the ray's longer and shorter component, whatever those are
/// in the picture.
pub(crate) struct Lines {
    pub(crate) octant: Octant,
    pub(crate) edge: Edge,
    /// The search radius in columns.
    pub(crate) radius: f64,
    /// How many whole rows line 0 has dropped at each column, rounded to the nearest.
    pub(crate) drop: Vec<i32>,
    /// The texel's row less the line's at each column: within ±½.
    pub(crate) offset: Vec<f32>,
}

impl Lines {
    pub(crate) fn new(field: &HeightField, params: &HorizonParams, direction: u32) -> Self {
        let octant = Octant::new(RayStep::new(params.azimuths.vector(direction), field.grid().spacing), field.grid());
        let radius = params.radius / octant.length_per_major;
        let columns = octant.majors + radius as usize + 2 * LINES;
        let nearest = |column: usize| (octant.tilt * column as f64 + 0.5).floor();
        let offset = |column: usize| (nearest(column) - octant.tilt * column as f64) as f32;
        Self {
            octant,
            edge: field.grid().edge,
            radius,
            drop: (0..columns).map(|column| nearest(column) as i32).collect(),
            offset: (0..columns).map(offset).collect(),
        }
    }

    /// The first line of every block. A line that leaves a wrapped tile comes in again at the other side; in a clamped
    /// field lines also enter through column 0's neighbours, from above the first row.
    pub(crate) fn blocks(&self) -> Vec<i64> {
        let first = match self.edge {
            Edge::Wrap => 0,
            Edge::Clamp => -i64::from(self.drop[self.octant.majors - 1]),
        };
        (first..self.octant.minors as i64).step_by(LINES).collect()
    }

    /// Columns that any texel of a block can see, up to where a clamped field is level for good, and a few more.
    pub(crate) fn columns_in_sight(&self, first_line: i64) -> usize {
        const MORE: usize = 16;
        let Octant { majors, minors, tilt, .. } = self.octant;
        let reach = majors + self.radius as usize;
        let in_sight = match self.edge {
            Edge::Wrap => reach,
            Edge::Clamp => {
                let rows_left = (minors as i64 - first_line + MARGIN as i64).max(0) as f64;
                let level_from = if tilt > 0.0 { (rows_left / tilt).ceil() } else { 0.0 };
                reach.min((level_from as usize).max(majors))
            }
        };
        in_sight + MORE
    }

    /// The columns in which any line of a block has a texel in the field.
    pub(crate) fn columns_with_texels(&self, first_line: i64) -> std::ops::Range<usize> {
        let majors = self.octant.majors;
        if self.edge == Edge::Wrap {
            return 0..majors;
        }
        let drops = &self.drop[..majors];
        let start = drops.partition_point(|&drop| first_line + i64::from(drop) + LINES as i64 <= 0);
        let end = drops.partition_point(|&drop| first_line + i64::from(drop) < self.octant.minors as i64);
        start..end.max(start)
    }

    /// The block's lines whose texels it owns: the last block of a field has fewer than [`LINES`].
    pub(crate) fn owned(&self, first_line: i64) -> usize {
        (self.octant.minors as i64 - first_line).clamp(0, LINES as i64) as usize
    }
}

/// The floor of a number in [−1, 1), which offsets and their differences are: `f32::floor` is a call on most machines.
#[inline]
pub(crate) fn floor_within_one(value: f32) -> f32 {
    if value < 0.0 { -1.0 } else { 0.0 }
}
