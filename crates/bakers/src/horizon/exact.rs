//! The horizon to the last digit: what the sweep found, proved or corrected in f64.
//!
//! The sweep's point is a true one, so its slope is a bound from below. Every stretch of a line has a bound from above: its
//! ceiling, the highest texel that a ray of the line's texels may come near, over the distance to it. A pyramid of
//! ceilings, each level four times as coarse, lets a ray pass over all that cannot be higher in strides that grow with the
//! distance, and look, in f64 and as the [reference](mod@super::reference) looks, at the few blocks that can.

use super::far::Scene;
use super::lines::{LINES, MARGIN, STRIDE};
use super::own_ray::OwnRay;
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
        for (step, column) in columns.enumerate() {
            for line in lines.clone() {
                let ray = OwnRay::new(scene, column, line);
                let seen_at = (f64::from(seen_at[step][line]) / units.length) as usize;
                let point = horizon(&ray, &self.ceilings, line, seen_at, scene.lines.radius);
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

/// The horizon, in scaled heights per column and in columns, given how many columns away the sweep saw it.
fn horizon(ray: &OwnRay<'_>, ceilings: &Ceilings, line: usize, seen_at: usize, radius: f64) -> HorizonPoint {
    let mut best = HorizonPoint::NONE;
    ray.cross_column(ray.column, &mut best);
    if radius > 1.0 {
        ray.consider_radius(&mut best);
    }
    let last = ((ray.column as f64 + radius) as usize).min(ray.last_column);
    let seen = (ray.column + seen_at).min(last);
    // A point on a column belongs to the piece of ray that ends there.
    if seen > ray.column {
        ray.cross_column(seen - 1, &mut best);
    }
    ray.cross_column(seen, &mut best);
    climb(ray, ceilings, line, last, &mut best);
    best
}

/// Passes over what is too low and looks at what may be higher, behind the columns in which the sweep has seen the highest
/// point to the rounding of f32.
#[inline]
fn climb(ray: &OwnRay<'_>, ceilings: &Ceilings, line: usize, last: usize, best: &mut HorizonPoint) {
    let levels = &ceilings.levels;
    let mut column = near_end(ray.column, Method::Exact);
    let (mut level, mut size) = (0, 1);
    while column <= last {
        while level + 1 < levels.len() && column.is_multiple_of(size * BRANCHES) {
            (level, size) = (level + 1, size * BRANCHES);
        }
        loop {
            let ceiling = levels[level].get(column / size).map_or(f32::NEG_INFINITY, |nodes| nodes[line]);
            let near = (column - ray.column) as f64;
            if ray.rise_to(ceiling) <= ray.needed(best.slope, near, near + size as f64) {
                break;
            }
            if level == 0 {
                ray.cross_column(column, best);
                break;
            }
            (level, size) = (level - 1, size / BRANCHES);
        }
        column += size;
    }
}
