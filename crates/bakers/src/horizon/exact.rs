//! The horizon to the last digit: what the sweep found, proved or corrected in f64.
//!
//! The sweep's point is a true one, so its slope is a bound from below. Every stretch of a line has a bound from above: its
//! ceiling, the highest texel that a ray of the line's texels may come near, over the distance to it. A pyramid of
//! ceilings, each level four times as coarse, lets a ray pass over all that cannot be higher in strides that grow with the
//! distance, and look, in f64 and as the [reference](mod@super::reference) looks, at the few blocks that can.

use super::direction::Octant;
use super::far::Scene;
use super::lines::{LINES, MARGIN, STRIDE};
use super::sheared::{ResultTile, TILE};
use super::sweep::near_end;
use super::{HorizonPoint, Method};

/// Nodes under a node.
const BRANCHES: usize = 4;

/// Highest heights of each line, column by column, then four columns by four.
#[derive(Default)]
pub(crate) struct Ceilings {
    /// `[level][node][line]`.
    levels: Vec<Vec<[f32; LINES]>>,
}

impl Ceilings {
    /// Takes the ceilings of the first `columns` columns but the last, each with the one behind it.
    fn take(&mut self, scene: &Scene<'_>, columns: usize) {
        self.levels.truncate(1);
        if self.levels.is_empty() {
            self.levels.push(Vec::new());
        }
        self.levels[0].clear();
        self.levels[0].extend((0..columns - 1).map(|column| ceiling(scene, column)));
        while let Some(level) = self.levels.last().filter(|level| level.len() > BRANCHES) {
            let coarser = level.chunks(BRANCHES).map(|nodes| nodes.iter().copied().reduce(higher).expect("a chunk"));
            let coarser = coarser.collect();
            self.levels.push(coarser);
        }
    }
}

/// The highest of all texels that rays within half a texel of a line touch between a column and the next.
fn ceiling(scene: &Scene<'_>, column: usize) -> [f32; LINES] {
    /// Far more than offsets are rounded by.
    const ROUNDING: f64 = 1e-6;
    let lines = scene.lines;
    let middle = -f64::from(lines.offset[column]);
    let first = (middle - 0.5 - ROUNDING).floor() as isize;
    let last = (middle + 0.5 + lines.octant.tilt + ROUNDING).floor() as isize + 1;
    let drop = (lines.drop[column + 1] - lines.drop[column]) as isize;
    let mut highest = [f32::NEG_INFINITY; LINES];
    for (column, up) in [(column, 0), (column + 1, drop)] {
        for row in first - up..=last - up {
            let start = (column * STRIDE + MARGIN).wrapping_add_signed(row);
            let heights: &[f32; LINES] = scene.heights[start..][..LINES].try_into().expect("a row for every line");
            highest = higher(highest, *heights);
        }
    }
    highest
}

#[inline]
fn higher(a: [f32; LINES], b: [f32; LINES]) -> [f32; LINES] {
    std::array::from_fn(|line| if b[line] > a[line] { b[line] } else { a[line] })
}

/// Buffers of one thread, kept from block to block.
pub(crate) struct Proof {
    ceilings: Ceilings,
    elevation_radians: Box<ResultTile>,
    distance: Box<ResultTile>,
}

impl Proof {
    pub(crate) fn new() -> Self {
        let zeros = || Box::new([[0.0; LINES]; TILE]);
        Self { ceilings: Ceilings::default(), elevation_radians: zeros(), distance: zeros() }
    }

    /// Gets ready for a block of lines.
    pub(crate) fn take(&mut self, scene: &Scene<'_>, columns_in_sight: usize) {
        self.ceilings.take(scene, columns_in_sight);
    }

    /// The elevations and distances of some columns, given those that the sweep found; the lines are those owned.
    pub(crate) fn prove(
        &mut self,
        scene: Scene<'_>,
        units: ExactUnits,
        columns: std::ops::Range<usize>,
        lines: std::ops::Range<usize>,
        seen_at: &[[f32; LINES]],
    ) -> (&ResultTile, &ResultTile) {
        let last_column = scene.heights.len() / STRIDE - 2;
        let columns_per_row = 1.0 / scene.lines.octant.tilt;
        for (step, column) in columns.enumerate() {
            for line in lines.clone() {
                let ray = ExactRay { scene, ceilings: &self.ceilings, column, line, columns_per_row, last_column };
                let point = ray.horizon((f64::from(seen_at[step][line]) / units.length) as usize);
                let point = HorizonPoint { slope: point.slope * units.slope, distance: point.distance * units.length };
                self.elevation_radians[step][line] = point.elevation_radians();
                self.distance[step][line] = (point.distance as f32).min(units.farthest);
            }
        }
        (&self.elevation_radians, &self.distance)
    }
}

/// From scaled heights per column to slopes, and from columns to lengths.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ExactUnits {
    pub(crate) slope: f64,
    pub(crate) length: f64,
    /// The largest distance that is not beyond the radius.
    pub(crate) farthest: f32,
}

/// A texel's own ray in f64.
struct ExactRay<'a> {
    scene: Scene<'a>,
    ceilings: &'a Ceilings,
    column: usize,
    line: usize,
    columns_per_row: f64,
    /// The last column that has another behind it; from there on a clamped field is level.
    last_column: usize,
}

impl ExactRay<'_> {
    /// The horizon, in scaled heights per column and in columns, given how many columns away the sweep saw it.
    fn horizon(&self, seen_at: usize) -> HorizonPoint {
        let eye = f64::from(self.scene.heights[self.column * STRIDE + MARGIN + self.line]);
        let radius = self.scene.lines.radius;
        let mut best = HorizonPoint::NONE;
        self.cross_column(self.column, eye, &mut best);
        if radius > 1.0 {
            self.consider_radius(eye, &mut best);
        }
        let last = ((self.column as f64 + radius) as usize).min(self.last_column);
        let seen = (self.column + seen_at).min(last);
        // A point on a column belongs to the piece of ray that ends there.
        if seen > self.column {
            self.cross_column(seen - 1, eye, &mut best);
        }
        self.cross_column(seen, eye, &mut best);
        self.climb(near_end(self.column, Method::Exact), last, seen, eye, &mut best);
        best
    }

    /// Passes over what is too low, looks at what may be higher, from `first` on: in all nearer columns the sweep has seen
    /// the highest point to the rounding of f32.
    #[inline]
    fn climb(&self, first: usize, last: usize, done: usize, eye: f64, best: &mut HorizonPoint) {
        let levels = &self.ceilings.levels;
        let mut column = first;
        let (mut level, mut size) = (0, 1);
        while column <= last {
            while level + 1 < levels.len() && column.is_multiple_of(size * BRANCHES) {
                (level, size) = (level + 1, size * BRANCHES);
            }
            loop {
                let ceiling = levels[level].get(column / size).map_or(f32::NEG_INFINITY, |nodes| nodes[self.line]);
                if !self.may_be_higher(f64::from(ceiling) - eye, column, size, best.slope) {
                    break;
                }
                if level == 0 {
                    if column != done {
                        self.cross_column(column, eye, best);
                    }
                    break;
                }
                (level, size) = (level - 1, size / BRANCHES);
            }
            column += size;
        }
    }

    #[inline]
    fn may_be_higher(&self, rise: f64, column: usize, columns: usize, slope: f64) -> bool {
        let near = column as f64 - self.column as f64;
        let far = near + columns as f64;
        rise > (slope * near).min(slope * far)
    }

    /// The one or two pieces of the ray between a column and the next, cut at the radius.
    #[inline]
    fn cross_column(&self, column: usize, eye: f64, best: &mut HorizonPoint) {
        let Octant { tilt, .. } = self.scene.lines.octant;
        let ahead = column - self.column;
        let (start, end) = (ahead as f64, (ahead as f64 + 1.0).min(self.scene.lines.radius));
        let row = (tilt * start) as usize;
        let crossing = if tilt > 0.0 { (row + 1) as f64 * self.columns_per_row } else { f64::INFINITY };
        self.cross_cell((ahead, row), start, crossing.min(end), eye, best);
        if crossing < end {
            self.cross_cell((ahead, row + 1), crossing.max(start), end, eye, best);
        }
    }

    /// Raises `best` to the steepest point of the ray in a cell, as the reference does; slopes are heights per column.
    fn cross_cell(&self, (ahead, down): (usize, usize), start: f64, end: f64, eye: f64, best: &mut HorizonPoint) {
        if start >= end {
            return;
        }
        let height = |column: usize, row: usize| self.height(ahead + column, down + row);
        let [h00, h10, h01, h11] = [height(0, 0), height(1, 0), height(0, 1), height(1, 1)];
        // No point of a cell is higher than its highest corner: most cells are out of the race at once.
        let highest = h00.max(h10).max(h01.max(h11)) - eye;
        if highest < (best.slope * start).min(best.slope * end) {
            return;
        }
        let tilt = self.scene.lines.octant.tilt;
        let (along_x, along_y) = (h10 - h00, h01 - h00);
        let twist = h11 - h10 - along_y;
        let (x, y) = (start - ahead as f64, start * tilt - down as f64);
        let rise = h00 - eye + along_x * x + along_y * y + twist * x * y;
        let slope = along_x + along_y * tilt + twist * (x * tilt + y);
        let bend = twist * tilt;
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

    fn consider_radius(&self, eye: f64, best: &mut HorizonPoint) {
        let (tilt, radius) = (self.scene.lines.octant.tilt, self.scene.lines.radius);
        let (ahead, across) = (radius as usize, radius * tilt);
        let down = across as usize;
        let (along, aside) = (radius - ahead as f64, across - down as f64);
        let between = |row: usize| {
            let (near, far) = (self.height(ahead, row), self.height(ahead + 1, row));
            near + (far - near) * along
        };
        let (upper, lower) = (between(down), between(down + 1));
        best.raise((upper + (lower - upper) * aside - eye) / radius, radius);
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
}
