//! One texel's own ray in f64, cell by cell.
//!
//! Inside a bilinear cell the surface along the ray is a parabola, looked at as the [reference](mod@super::reference) looks:
//! nothing is sampled. A bend λ takes λ s² off it.

use super::HorizonPoint;
use super::far::Scene;
use super::lines::{MARGIN, STRIDE};

/// The ray of the texel that a line has in a column. Slopes are scaled heights per column, distances columns.
pub(crate) struct OwnRay<'a> {
    scene: Scene<'a>,
    pub(crate) column: usize,
    line: usize,
    eye: f64,
    bend: f64,
    columns_per_row: f64,
    /// The last column that has another behind it; from there on a clamped field is level.
    pub(crate) last_column: usize,
}

impl<'a> OwnRay<'a> {
    #[inline]
    pub(crate) fn new(scene: Scene<'a>, column: usize, line: usize) -> Self {
        let eye = f64::from(scene.heights[column * STRIDE + MARGIN + line]);
        let columns_per_row = 1.0 / scene.lines.octant.tilt;
        let last_column = scene.heights.len() / STRIDE - 2;
        Self { scene, column, line, eye, bend: f64::from(scene.bend), columns_per_row, last_column }
    }

    /// How far a height stands above the texel.
    #[inline]
    pub(crate) fn rise_to(&self, height: f32) -> f64 {
        f64::from(height) - self.eye
    }

    /// The one or two pieces of the ray between a column and the next, cut at the radius.
    #[inline]
    pub(crate) fn cross_column(&self, column: usize, best: &mut HorizonPoint) {
        let tilt = self.scene.lines.octant.tilt;
        let ahead = column - self.column;
        let (start, end) = (ahead as f64, (ahead as f64 + 1.0).min(self.scene.lines.radius));
        let row = (tilt * start) as usize;
        let crossing = if tilt > 0.0 { (row + 1) as f64 * self.columns_per_row } else { f64::INFINITY };
        self.cross_cell((ahead, row), start, crossing.min(end), best);
        if crossing < end {
            self.cross_cell((ahead, row + 1), crossing.max(start), end, best);
        }
    }

    /// Raises `best` to the steepest point of the ray in a cell, as the reference does; slopes are heights per column.
    fn cross_cell(&self, (ahead, down): (usize, usize), start: f64, end: f64, best: &mut HorizonPoint) {
        if start >= end {
            return;
        }
        let height = |column: usize, row: usize| self.height(ahead + column, down + row);
        let [h00, h10, h01, h11] = [height(0, 0), height(1, 0), height(0, 1), height(1, 1)];
        // No point of a cell is higher than its highest corner: most cells are out of the race at once.
        let highest = h00.max(h10).max(h01.max(h11)) - self.eye;
        if highest < self.needed(best.slope, start, end) {
            return;
        }
        let tilt = self.scene.lines.octant.tilt;
        let (along_x, along_y) = (h10 - h00, h01 - h00);
        let twist = h11 - h10 - along_y;
        let (x, y) = (start - ahead as f64, start * tilt - down as f64);
        let rise = h00 - self.eye + along_x * x + along_y * y + twist * x * y - self.bend * start * start;
        let slope = along_x + along_y * tilt + twist * (x * tilt + y) - 2.0 * self.bend * start;
        let bend = twist * tilt - self.bend;
        let slope_from_texel = |s: f64| {
            let along = s - start;
            (rise + along * (slope + along * bend)) / s
        };
        if start == 0.0 {
            best.raise(slope, 0.0);
        } else if bend < 0.0 {
            let constant = rise - slope * start + bend * start * start;
            let peak = (constant / bend).sqrt();
            if peak > start && peak < end {
                best.raise(slope_from_texel(peak), peak);
            }
        }
        best.raise(slope_from_texel(end), end);
    }

    /// Raises `best` to the point at the search radius.
    pub(crate) fn consider_radius(&self, best: &mut HorizonPoint) {
        let (tilt, radius) = (self.scene.lines.octant.tilt, self.scene.lines.radius);
        let (ahead, across) = (radius as usize, radius * tilt);
        let down = across as usize;
        let (along, aside) = (radius - ahead as f64, across - down as f64);
        let between = |row: usize| {
            let (near, far) = (self.height(ahead, row), self.height(ahead + 1, row));
            near + (far - near) * along
        };
        let (upper, lower) = (between(down), between(down + 1));
        best.raise((upper + (lower - upper) * aside - self.eye) / radius - self.bend * radius, radius);
    }

    /// The height of a texel ahead of the ray's and some rows further.
    #[inline]
    fn height(&self, ahead: usize, down: usize) -> f64 {
        let lines = self.scene.lines;
        let column = self.column + ahead;
        let row = i64::from(lines.drop[self.column]) + down as i64 - i64::from(lines.drop[column]);
        // Where a clamped field is level for good, its last column stands for all beyond, and all its rows are the same.
        let place = if column > self.last_column + 1 {
            (self.last_column + 1) * STRIDE + MARGIN + self.line
        } else {
            ((column * STRIDE + MARGIN + self.line) as i64 + row) as usize
        };
        f64::from(self.scene.heights[place])
    }

    /// How high the ray must rise between two distances to be seen at a slope.
    #[inline]
    pub(crate) fn needed(&self, slope: f64, start: f64, end: f64) -> f64 {
        let level = (slope * start).min(slope * end);
        if self.bend == 0.0 { level } else { level + (self.bend * start * start).min(self.bend * end * end) }
    }

    /// The row crossings around some columns, where a wall along the ray is highest: at a slight tilt many columns away. A
    /// ceiling reaches two rows beyond the ray, so the third row from it may be meant.
    pub(crate) fn cross_rows_around(&self, first: usize, last: usize, best: &mut HorizonPoint) {
        let tilt = self.scene.lines.octant.tilt;
        if tilt == 0.0 {
            return;
        }
        let row = |column: usize| (tilt * (column - self.column) as f64) as usize;
        for row in [row(first), row(last) + 1, row(last) + 2, row(last) + 3] {
            let ahead = row as f64 * self.columns_per_row;
            let farthest = self.scene.lines.radius.min((self.last_column - self.column) as f64);
            if ahead >= 1.0 && ahead <= farthest {
                // A crossing on a column ends the piece of ray before it.
                self.cross_column(self.column + ahead.ceil() as usize - 1, best);
            }
        }
    }
}
