//! The fast baker: whole strips at a time, amortised constant work per texel and direction at any radius.
//!
//! A direction is cut into strips one texel wide between parallel lines, so that the ray of each texel runs inside one
//! strip. Three profiles of a strip are taken, one height per column of texel centres (per row, for steep azimuths): the
//! surface along either border line, and the ceiling, the highest texel that a ray of the strip comes near. A running
//! upper hull of each answers: in which column ahead does this texel see its horizon? That is all the hulls are asked.
//! The slope is then taken from the texel's *own* ray: exactly over the [`NEAR_COLUMNS`] nearest columns, where
//! neighbouring lines see different things, and around the three answers, and at the radius. The border lines follow
//! smooth relief; the ceiling finds what can fall between them, such as the fringe of a single high texel.
//!
//! So every value is the slope of a true point of the surface on the texel's own ray: the sweep can miss the highest
//! one but never invents one, and is never above the reference by more than rounding.

use barchan_field::{Edge, HeightField};

use super::HorizonParams;
use super::direction::{Octant, RayStep};
use super::hull::SlidingHull;
use super::map::LayerMut;
use super::ray::{MARGIN, NEAR_COLUMNS, Ray};
use super::relief::Relief;

/// Bakes one direction of a map.
pub(crate) fn bake_layer(field: &HeightField, params: &HorizonParams, direction: u32, layer: &mut LayerMut) {
    let step = RayStep::new(params.azimuths.vector(direction), field.grid().spacing);
    let relief = Relief::new(field, Octant::new(step, field.grid()), MARGIN);
    let ray = Ray::new(&relief, params.radius);
    let profiles = [Profile::new(&ray), Profile::new(&ray), Profile::new(&ray)];
    // Along an axis every ray runs on its strip's first line, and no other profile could tell it more.
    let in_use = if relief.octant.tilt == 0.0 { 1 } else { profiles.len() };
    let mut sweep = StripSweep { relief: &relief, ray: &ray, profiles, in_use };
    let drift = i64::from(ray.drift.rows[relief.octant.majors - 1]);
    let first_strip = match relief.edge {
        // A strip that leaves the tile comes in again at the other side.
        Edge::Wrap => 0,
        Edge::Clamp => -drift - 1,
    };
    for strip in first_strip..relief.octant.minors as i64 {
        sweep.sweep(strip, layer);
    }
}

/// One strip at a time, with buffers that outlive it.
///
/// Strip `i` lies between the lines that leave column 0 at rows `i` and `i + 1`.
struct StripSweep<'a> {
    relief: &'a Relief,
    ray: &'a Ray,
    profiles: [Profile; 3],
    /// How many of the profiles are followed; the hulls of the others stay empty.
    in_use: usize,
}

impl StripSweep<'_> {
    fn sweep(&mut self, strip: i64, layer: &mut LayerMut) {
        let columns = self.columns_in_sight(strip);
        let [border, other_border, ceiling] = &mut self.profiles;
        border.follow_line(self.relief, self.ray, strip, columns);
        if self.in_use > 1 {
            other_border.follow_line(self.relief, self.ray, strip + 1, columns);
            ceiling.follow_ceiling(self.relief, self.ray, strip, columns);
        }
        let mut window_start = columns;
        for column in (self.first_column(strip)..self.relief.octant.majors).rev() {
            while window_start > column + NEAR_COLUMNS {
                window_start -= 1;
                for profile in &mut self.profiles[..self.in_use] {
                    profile.hull.slide_to(&profile.heights, window_start);
                }
            }
            if let Some(row) = self.texel_row(strip, column) {
                self.bake_texel((column, row), layer);
            }
        }
    }

    /// A column before which the strip has no texel in the field.
    fn first_column(&self, strip: i64) -> usize {
        self.ray.drift.rows.partition_point(|&rows| strip + i64::from(rows) + 1 < 0)
    }

    /// The row of the one texel that a strip has in a column, if it lies in the field.
    #[inline]
    fn texel_row(&self, strip: i64, column: usize) -> Option<usize> {
        let drift = &self.ray.drift;
        let row = strip + i64::from(drift.rows[column]) + i64::from(drift.fraction[column] > 0.0);
        usize::try_from(self.relief.first_row(row)).ok().filter(|&row| row < self.relief.octant.minors)
    }

    #[inline]
    fn bake_texel(&mut self, texel: (usize, usize), layer: &mut LayerMut) {
        let (column, row) = texel;
        let eye = self.relief.near(self.relief.place(column, row));
        let far = self
            .profiles
            .each_ref()
            .map(|profile| profile.hull.tangent(&profile.heights, column, eye).map(|position| position - column));
        let point = self.ray.horizon(self.relief, texel, eye, far);
        layer.set(self.relief.octant.index(column, row), point);
    }

    /// How many columns any texel of a strip can see, up to where a clamped field is level for good.
    fn columns_in_sight(&self, strip: i64) -> usize {
        let Octant { majors, minors, tilt, .. } = self.relief.octant;
        let reach = majors + self.ray.columns();
        match self.relief.edge {
            Edge::Wrap => reach,
            Edge::Clamp => {
                let rows_left = (minors as i64 - 1 - strip).max(0) as f64;
                let last_row_at = if tilt > 0.0 { (rows_left / tilt).ceil() as usize } else { 0 };
                reach.min(last_row_at.max(majors - 1).saturating_add(1))
            }
        }
    }
}

/// Heights along a strip, one per column, and what can be seen of them.
struct Profile {
    heights: Vec<f64>,
    hull: SlidingHull,
}

impl Profile {
    fn new(ray: &Ray) -> Self {
        Self { heights: Vec::new(), hull: SlidingHull::new((ray.columns() + 1).saturating_sub(NEAR_COLUMNS)) }
    }

    /// Takes the surface along the line that leaves column 0 at row `line`.
    fn follow_line(&mut self, relief: &Relief, ray: &Ray, line: i64, columns: usize) {
        let start = relief.first_row(line);
        self.heights.clear();
        self.heights.extend((0..columns).map(|column| {
            let (upper, lower) = relief.row_pair(column, start + i64::from(ray.drift.rows[column]));
            upper + (lower - upper) * ray.drift.fraction[column]
        }));
        self.hull.restart(columns);
    }

    /// Takes the highest texel of each column that any ray of the strip comes within a cell of.
    fn follow_ceiling(&mut self, relief: &Relief, ray: &Ray, strip: i64, columns: usize) {
        let start = relief.first_row(strip);
        self.heights.clear();
        self.heights.extend((0..columns).map(|column| {
            let first = ray.drift.rows[column.saturating_sub(1)];
            let last = ray.drift.rows[column + 1] + 2;
            (first..=last)
                .map(|row| relief.height(column, (start + i64::from(row)).max(0) as usize))
                .fold(f64::NEG_INFINITY, f64::max)
        }));
        self.hull.restart(columns);
    }
}
