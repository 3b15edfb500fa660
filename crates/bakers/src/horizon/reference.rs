//! The obvious twin: one ray per texel and direction, walked cell by cell in f64 to the search radius.
//!
//! Inside one bilinear cell the surface along the ray is a parabola h(s) = A + B s + C s², so the slope seen from the
//! texel, (h(s) − h₀)/s = (A − h₀)/s + B + C s, has its maximum at an end of the cell or, where C < 0 and A < h₀, at
//! s = √((A − h₀)/C). Nothing is sampled: the supremum is exact up to f64 rounding.

use barchan_field::HeightField;

use super::direction::RayStep;
use super::{HorizonMap, HorizonParams, HorizonPoint};
use crate::{BakeError, Exec};

/// Bakes by brute force: the definition that [`super::bake`] is held against. O(radius) per texel and direction.
pub fn bake(field: &HeightField, params: &HorizonParams, exec: &Exec) -> Result<HorizonMap, BakeError> {
    HorizonMap::fill(field, params, |layers| {
        exec.for_each(layers, |direction, mut layer| {
            let width = field.grid().width as usize;
            for index in 0..field.grid().texels() {
                let (column, row) = ((index % width) as u32, (index / width) as u32);
                layer.set(index, horizon(field, params, direction as u32, column, row), params.radius);
            }
        });
    })
}

/// The horizon of one texel in one direction. `params` must have been accepted for this field.
#[must_use]
pub fn horizon(field: &HeightField, params: &HorizonParams, direction: u32, column: u32, row: u32) -> HorizonPoint {
    let step = RayStep::new(params.azimuths.vector(direction), field.grid().spacing);
    let origin = (i64::from(column), i64::from(row));
    let origin_height = f64::from(field.texel(origin.0, origin.1));
    let mut best = HorizonPoint::NONE;
    let mut start = 0.0;
    let mut crossings = Crossings::new(step);
    while start < params.radius {
        let cell = crossings.cell();
        let end = crossings.next_distance().min(params.radius);
        let parabola = CellParabola::new(field, origin, cell, step, start);
        parabola.consider(origin_height, start, end, &mut best);
        start = end;
    }
    best
}

/// The distances at which a ray from a texel centre crosses from one bilinear cell to the next.
struct Crossings {
    step: RayStep,
    columns_crossed: f64,
    rows_crossed: f64,
}

impl Crossings {
    fn new(step: RayStep) -> Self {
        Self { step, columns_crossed: 0.0, rows_crossed: 0.0 }
    }

    /// The cell the ray is in, as its least column and row from the texel's own. Counted, not found from a place on the
    /// ray, which near a border may round into the cell beyond.
    fn cell(&self) -> (i64, i64) {
        let least = |crossed: f64, speed: f64| if speed < 0.0 { -1 - crossed as i64 } else { crossed as i64 };
        (least(self.columns_crossed, self.step.columns), least(self.rows_crossed, self.step.rows))
    }

    fn next_distance(&mut self) -> f64 {
        // A component of 0 never crosses: 1/0 is infinite, as it should be.
        let to_column = (self.columns_crossed + 1.0) / self.step.columns.abs();
        let to_row = (self.rows_crossed + 1.0) / self.step.rows.abs();
        let next = to_column.min(to_row);
        if to_column <= next {
            self.columns_crossed += 1.0;
        }
        if to_row <= next {
            self.rows_crossed += 1.0;
        }
        next
    }
}

/// The surface along the part of a ray that lies in one cell: h(s) = start_height + slope (s − start) + bend (s − start)².
struct CellParabola {
    start_height: f64,
    slope: f64,
    bend: f64,
}

impl CellParabola {
    fn new(field: &HeightField, origin: (i64, i64), cell: (i64, i64), step: RayStep, start: f64) -> Self {
        let corner = |i: i64, j: i64| f64::from(field.texel(origin.0 + cell.0 + i, origin.1 + cell.1 + j));
        let (h00, h10, h01, h11) = (corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1));
        let (along_x, along_y, twist) = (h10 - h00, h01 - h00, h00 - h10 - h01 + h11);
        let (x, y) = (start * step.columns - cell.0 as f64, start * step.rows - cell.1 as f64);
        Self {
            start_height: h00 + along_x * x + along_y * y + twist * x * y,
            slope: along_x * step.columns + along_y * step.rows + twist * (x * step.rows + y * step.columns),
            bend: twist * step.columns * step.rows,
        }
    }

    fn consider(&self, origin_height: f64, start: f64, end: f64, best: &mut HorizonPoint) {
        if start == 0.0 {
            // The ray starts on the surface: the slope's limit at the texel itself is the surface's own slope.
            best.raise(self.slope, 0.0);
        } else {
            let constant = self.start_height - origin_height - self.slope * start + self.bend * start * start;
            if self.bend < 0.0 && constant < 0.0 {
                let peak = (constant / self.bend).sqrt();
                if peak > start && peak < end {
                    best.raise(self.slope_from(origin_height, start, peak), peak);
                }
            }
        }
        best.raise(self.slope_from(origin_height, start, end), end);
    }

    fn slope_from(&self, origin_height: f64, start: f64, s: f64) -> f64 {
        let along = s - start;
        (self.start_height - origin_height + along * (self.slope + along * self.bend)) / s
    }
}
