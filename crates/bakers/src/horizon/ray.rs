//! A texel's own ray, in columns: the same path over the grid for every texel of a direction.

use super::HorizonPoint;
use super::direction::Octant;
use super::relief::Relief;

/// Columns ahead of a texel in which every point of its own ray is looked at.
pub(crate) const NEAR_COLUMNS: usize = 4;

/// Columns and rows beyond the field that the near part of a ray may touch.
pub(crate) const MARGIN: usize = NEAR_COLUMNS + 2;

/// How far a ray has moved across rows at each column: whole rows, and the rest in [0, 1).
pub(crate) struct Drift {
    pub(crate) rows: Vec<u32>,
    pub(crate) fraction: Vec<f64>,
}

impl Drift {
    fn new(tilt: f64, columns: usize) -> Self {
        let at = |column: usize| tilt * column as f64;
        Self {
            rows: (0..columns).map(|column| at(column) as u32).collect(),
            fraction: (0..columns).map(|column| at(column) - f64::from(at(column) as u32)).collect(),
        }
    }
}

/// The ray of one direction. Positions on it, and the radius, count columns from the texel.
pub(crate) struct Ray {
    tilt: f64,
    columns_per_row: f64,
    length_per_column: f64,
    radius: f64,
    pub(crate) drift: Drift,
    near: Vec<Segment>,
}

/// The part of a ray inside one bilinear cell.
struct Segment {
    /// The cell's nearest corner, in texels from the ray's own.
    column: usize,
    row: usize,
    /// Where in the cell it begins, from the nearest corner.
    entry: (f64, f64),
    /// Where on the ray it begins and ends, in columns from the texel.
    start: f64,
    end: f64,
}

impl Ray {
    pub(crate) fn new(relief: &Relief, radius: f64) -> Self {
        let Octant { tilt, length_per_major, majors, .. } = relief.octant;
        let radius = radius / length_per_major;
        let mut ray = Self {
            tilt,
            columns_per_row: 1.0 / tilt,
            length_per_column: length_per_major,
            radius,
            drift: Drift::new(tilt, majors + radius as usize + MARGIN),
            near: Vec::new(),
        };
        ray.near = (0..NEAR_COLUMNS).flat_map(|column| ray.segments(column)).flatten().collect();
        ray
    }

    /// Columns of texel centres within the radius.
    pub(crate) fn columns(&self) -> usize {
        self.radius as usize
    }

    /// The one or two cells a ray crosses between a column and the next, cut at the radius.
    fn segments(&self, column: usize) -> [Option<Segment>; 2] {
        let start = column as f64;
        let end = (start + 1.0).min(self.radius);
        let row = self.drift.rows[column];
        let segment = |row: u32, start: f64, end: f64| {
            (start < end).then(|| Segment {
                column,
                row: row as usize,
                entry: (start - column as f64, start * self.tilt - f64::from(row)),
                start,
                end,
            })
        };
        let crossing = self.row_crossing(row + 1);
        [segment(row, start, crossing.min(end)), segment(row + 1, crossing.max(start), end)]
    }

    /// Where the ray crosses a row of texel centres; a ray along the axis never does.
    #[inline]
    fn row_crossing(&self, row: u32) -> f64 {
        if self.tilt > 0.0 { f64::from(row) * self.columns_per_row } else { f64::INFINITY }
    }

    /// The steepest point found on a texel's own ray, as a true slope and length; `far` names columns to look around.
    #[inline]
    pub(crate) fn horizon(
        &self,
        relief: &Relief,
        texel: (usize, usize),
        eye: f64,
        far: [Option<usize>; 3],
    ) -> HorizonPoint {
        let mut best = HorizonPoint::NONE;
        let (place, stride) = (relief.place(texel.0, texel.1), relief.place(0, 1));
        for segment in &self.near {
            let corner = place + relief.place(segment.column, segment.row);
            let heights = [0, 1, stride, stride + 1].map(|offset| relief.near(corner + offset));
            segment.consider(self.tilt, heights, eye, &mut best);
        }
        for (index, column) in far.iter().enumerate() {
            if let Some(column) = column
                && !far[..index].contains(&Some(*column))
            {
                self.consider_around(relief, texel, eye, *column, &mut best);
            }
        }
        if self.radius > NEAR_COLUMNS as f64 {
            self.consider_radius(relief, texel, eye, &mut best);
        }
        HorizonPoint { slope: best.slope / self.length_per_column, distance: best.distance * self.length_per_column }
    }

    /// The cells on both sides of a column, and the row crossings before and after it: at a slight tilt those lie many
    /// columns away, and a wall along the ray is highest there.
    #[inline]
    fn consider_around(
        &self,
        relief: &Relief,
        texel: (usize, usize),
        eye: f64,
        column: usize,
        best: &mut HorizonPoint,
    ) {
        for segment in [column - 1, column].into_iter().flat_map(|column| self.segments(column)).flatten() {
            let height = |ahead, down| relief.height(texel.0 + segment.column + ahead, texel.1 + segment.row + down);
            segment.consider(self.tilt, [height(0, 0), height(1, 0), height(0, 1), height(1, 1)], eye, best);
        }
        let row = self.drift.rows[column];
        for row in [row, row + 1] {
            let crossing = self.row_crossing(row);
            if crossing > NEAR_COLUMNS as f64 && crossing < self.radius {
                let before = crossing as usize;
                let height = |ahead: usize| relief.height(texel.0 + before + ahead, texel.1 + row as usize);
                let at_row = mix(height(0), height(1), crossing - before as f64);
                best.raise((at_row - eye) / crossing, crossing);
            }
        }
    }

    /// The last point of a ray that goes on beyond its near part. Nearer, its height less the eye's would be rounding.
    #[inline]
    fn consider_radius(&self, relief: &Relief, texel: (usize, usize), eye: f64, best: &mut HorizonPoint) {
        let column = self.radius as usize;
        let across = self.radius * self.tilt;
        let row = across as usize;
        let height = |ahead: usize, down: usize| relief.height(texel.0 + column + ahead, texel.1 + row + down);
        let along = self.radius - column as f64;
        let (nearer, farther) = (mix(height(0, 0), height(1, 0), along), mix(height(0, 1), height(1, 1), along));
        best.raise((mix(nearer, farther, across - row as f64) - eye) / self.radius, self.radius);
    }
}

impl Segment {
    /// Raises `best` to the steepest point of the segment, as the reference does; slopes are heights per column. The
    /// heights are those of the cell's corners: nearest, next column, next row, both.
    #[inline]
    fn consider(&self, tilt: f64, [h00, h10, h01, h11]: [f64; 4], eye: f64, best: &mut HorizonPoint) {
        // No point of a cell is higher than its highest corner: most cells are out of the race at once.
        let highest = h00.max(h10).max(h01.max(h11)) - eye;
        if highest < best.slope * if highest > 0.0 { self.start } else { self.end } {
            return;
        }
        let (along_x, along_y) = (h10 - h00, h01 - h00);
        let twist = h11 - h10 - along_y;
        let (x, y) = self.entry;
        let rise = h00 - eye + along_x * x + along_y * y + twist * x * y;
        let slope = along_x + along_y * tilt + twist * (x * tilt + y);
        let bend = twist * tilt;
        let slope_from_texel = |s: f64| {
            let along = s - self.start;
            (rise + along * (slope + along * bend)) / s
        };
        if self.start == 0.0 {
            best.raise(slope, 0.0);
        } else if bend < 0.0 {
            let constant = rise - slope * self.start + bend * self.start * self.start;
            let peak = (constant / bend).sqrt();
            if peak > self.start && peak < self.end {
                best.raise(slope_from_texel(peak), peak);
            }
        }
        best.raise(slope_from_texel(self.end), self.end);
    }
}

#[inline]
fn mix(a: f64, b: f64, t: f64) -> f64 {
    a + (b - a) * t
}
