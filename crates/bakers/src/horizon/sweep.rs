//! The fast baker: whole strips at a time, amortised constant work per texel and direction at any radius.
//!
//! A direction is cut into strips one texel wide between parallel lines, so that the ray of each texel runs inside one
//! strip. Along both border lines the surface is taken once per column of texel centres (per row, for steep azimuths),
//! and a running upper hull of those heights answers: in which column ahead does this texel see its horizon? That is
//! all the hulls are asked. The slope is then taken from the texel's *own* ray: exactly over the [`NEAR_COLUMNS`]
//! nearest columns, where neighbouring lines see different things, and around both answers, and at the radius.
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
    let step = RayStep::new(direction, params.directions, field.grid().spacing);
    let relief = Relief::new(field, Octant::new(step, field.grid()), MARGIN);
    let ray = Ray::new(&relief, params.radius);
    let borders = [BorderLine::new(&ray), BorderLine::new(&ray)];
    let mut sweep = StripSweep { relief: &relief, ray: &ray, borders };
    let drift = i64::from(ray.drift.rows[relief.octant.majors - 1]);
    for strip in -drift - 1..relief.octant.minors as i64 {
        sweep.sweep(strip, layer);
    }
}

/// One strip at a time, with buffers that outlive it.
///
/// Strip `i` lies between the lines that leave column 0 at rows `i` and `i + 1`.
struct StripSweep<'a> {
    relief: &'a Relief,
    ray: &'a Ray,
    borders: [BorderLine; 2],
}

impl StripSweep<'_> {
    fn sweep(&mut self, strip: i64, layer: &mut LayerMut) {
        let columns = self.columns_in_sight(strip);
        for (border, line) in self.borders.iter_mut().zip([strip, strip + 1]) {
            border.follow(self.relief, self.ray, line, columns);
        }
        let mut window_start = columns;
        for column in (0..self.relief.octant.majors).rev() {
            while window_start > column + NEAR_COLUMNS + 1 {
                window_start -= 1;
                for border in &mut self.borders {
                    border.hull.slide_to(&border.heights, window_start);
                }
            }
            if let Some(row) = self.texel_row(strip, column) {
                self.bake_texel((column, row), layer);
            }
        }
    }

    /// The row of the one texel that a strip has in a column, if it lies in the field.
    #[inline]
    fn texel_row(&self, strip: i64, column: usize) -> Option<usize> {
        let drift = &self.ray.drift;
        let row = strip + i64::from(drift.rows[column]) + i64::from(drift.fraction[column] > 0.0);
        usize::try_from(row).ok().filter(|&row| row < self.relief.octant.minors)
    }

    #[inline]
    fn bake_texel(&mut self, texel: (usize, usize), layer: &mut LayerMut) {
        let (column, row) = texel;
        let eye = self.relief.near(self.relief.place(column, row));
        let far = self
            .borders
            .each_ref()
            .map(|border| border.hull.tangent(&border.heights, column, eye).map(|position| position - column));
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
                reach.min(last_row_at.max(majors - 1) + 1)
            }
        }
    }
}

/// One border of a strip: the surface where the line crosses each column, and what can be seen of it.
struct BorderLine {
    heights: Vec<f64>,
    hull: SlidingHull,
}

impl BorderLine {
    fn new(ray: &Ray) -> Self {
        Self { heights: Vec::new(), hull: SlidingHull::new(ray.columns().saturating_sub(NEAR_COLUMNS)) }
    }

    /// Takes the heights along the line that leaves column 0 at row `line`.
    fn follow(&mut self, relief: &Relief, ray: &Ray, line: i64, columns: usize) {
        let start = relief.first_row(line);
        self.heights.clear();
        self.heights.extend((0..columns).map(|column| {
            let (upper, lower) = relief.row_pair(column, start + i64::from(ray.drift.rows[column]));
            upper + (lower - upper) * ray.drift.fraction[column]
        }));
        self.hull.restart(columns);
    }
}
