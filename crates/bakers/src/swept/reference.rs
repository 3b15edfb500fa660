//! The obvious twins, one ray per texel, walked cell by cell in f64.
//!
//! [`BentReference`] finds the candidate of one bend: δ(s) − λs is A/s + B + (C − λ)s in a bilinear cell, whose
//! maximum is at an end or, where A and C − λ are negative, at √(A/(C − λ)). Nothing is sampled.
//!
//! [`CurvedReference`] is the truth that swept tables are held against: every distance, by the exact formula. It is
//! not a parabola any more, so each cell is sampled at 8 distances and its end, and the best sample is refined by
//! golden sections to either side. A second maximum between two samples 1/8 of a cell apart would be missed.

use std::f64::consts::PI;

use barchan_field::HeightField;

use super::params::Tie;
use super::ray::{Cell, Parabola, RayCells};
use crate::horizon::{HorizonParams, HorizonPoint};

/// Distances per cell at which the curved horizon is looked for, besides the refinement.
const SAMPLES_PER_CELL: u32 = 8;

/// Golden sections around the best sample: 0.618 to this power of 1/8 of a cell is left of the place, and its square
/// of the value.
const SECTIONS: u32 = 20;

/// The horizon of relief bent down by λs², for one direction: the twin of the fast sweep.
pub struct BentReference<'a> {
    field: &'a HeightField,
    ray: RayCells,
    bend: f64,
    tie: Tie,
}

impl<'a> BentReference<'a> {
    /// `params` must have been accepted for the field; the bend λ is in the inverse of its length unit.
    #[must_use]
    pub fn new(field: &'a HeightField, params: &HorizonParams, direction: u32, bend: f64, tie: Tie) -> Self {
        let ray = RayCells::new(params.azimuths.vector(direction), field.grid().spacing, params.radius);
        Self { field, ray, bend, tie }
    }

    /// The point that maximises δ(s) − λs, with its *flat* slope δ.
    #[must_use]
    pub fn point(&self, column: u32, row: u32) -> HorizonPoint {
        let texel = (i64::from(column), i64::from(row));
        let mut best = Highest::none(self.tie);
        for cell in &self.ray.cells {
            let surface = self.ray.parabola(self.field, texel, cell);
            let bent = Parabola { bend: surface.bend - self.bend, ..surface };
            if cell.start == 0.0 {
                best.raise(bent.slope, surface.slope, 0.0);
            } else if bent.level < 0.0 && bent.bend < 0.0 {
                let peak = (bent.level / bent.bend).sqrt();
                if peak > cell.start && peak < cell.end {
                    best.raise(bent.seen_at(peak), surface.seen_at(peak), peak);
                }
            }
            best.raise(bent.seen_at(cell.end), surface.seen_at(cell.end), cell.end);
        }
        best.point
    }
}

/// The highest point so far, by a measure other than its slope. Points come nearest first.
struct Highest {
    measure: f64,
    point: HorizonPoint,
    tie: Tie,
}

impl Highest {
    fn none(tie: Tie) -> Self {
        let point = HorizonPoint { slope: f64::NEG_INFINITY, distance: 0.0 };
        Self { measure: f64::NEG_INFINITY, point, tie }
    }

    fn raise(&mut self, measure: f64, slope: f64, distance: f64) {
        /// What rounding may put between equals: a farther point must be higher by more than that to displace a
        /// nearer one.
        const ROUNDING: f64 = 1e-12;
        let higher = match self.tie {
            Tie::Nearest => measure > self.measure + ROUNDING * (1.0 + measure.abs()),
            Tie::Farthest => measure >= self.measure,
        };
        if higher {
            *self = Self { measure, point: HorizonPoint { slope, distance }, ..*self };
        }
    }
}

/// The horizon of relief on a base surface of one curvature, for one direction, by brute force.
pub struct CurvedReference<'a> {
    field: &'a HeightField,
    ray: RayCells,
    curvature: f64,
    /// [`SAMPLES_PER_CELL`] of each cell in turn, its end the last.
    samples: Vec<Turn>,
}

impl<'a> CurvedReference<'a> {
    /// `params` must have been accepted for the field; the curvature is in the inverse of its length unit. Looks no
    /// farther than half round the circle, beyond which everything is behind.
    #[must_use]
    pub fn new(field: &'a HeightField, params: &HorizonParams, direction: u32, curvature: f64) -> Self {
        let radius = params.radius.min(PI / curvature.abs());
        let ray = RayCells::new(params.azimuths.vector(direction), field.grid().spacing, radius);
        let samples = |(start, end): (f64, f64)| {
            (1..=SAMPLES_PER_CELL).map(move |sample| {
                let along = f64::from(sample) / f64::from(SAMPLES_PER_CELL);
                Turn::new(curvature, start * (1.0 - along) + end * along)
            })
        };
        let samples = ray.cells.iter().flat_map(|cell| samples((cell.start, cell.end))).collect();
        Self { field, ray, curvature, samples }
    }

    /// The highest point as the texel sees it on the curved surface, with its *curved* slope; −∞ where the texel is
    /// at the centre of a concave surface or beyond.
    ///
    /// On a convex surface this includes what the smooth surface hides, if heights are at or above it and the search
    /// reaches the point of touch.
    #[must_use]
    pub fn horizon(&self, column: u32, row: u32) -> HorizonPoint {
        let texel = (i64::from(column), i64::from(row));
        let stretch = 1.0 + self.curvature * f64::from(self.field.texel(texel.0, texel.1));
        let mut best = HorizonPoint { slope: f64::NEG_INFINITY, distance: 0.0 };
        if stretch <= 0.0 {
            return best;
        }
        let mut best_cell = 0;
        for (index, turns) in self.samples.chunks_exact(SAMPLES_PER_CELL as usize).enumerate() {
            let surface = self.ray.parabola(self.field, texel, &self.ray.cells[index]);
            if index == 0 {
                best.raise(surface.slope / stretch, 0.0);
            }
            let before = best;
            for turn in turns {
                best.raise(turn.slope(surface.seen_at(turn.distance), stretch), turn.distance);
            }
            best_cell = if best == before { best_cell } else { index };
        }
        // The best sample may be the border to the next cell.
        for cell in self.ray.cells.iter().skip(best_cell).take(2) {
            self.refine(texel, stretch, cell, &mut best);
        }
        best
    }

    /// Looks closer on both sides of the best sample, as far as they are in a cell.
    fn refine(&self, texel: (i64, i64), stretch: f64, cell: &Cell, best: &mut HorizonPoint) {
        let surface = self.ray.parabola(self.field, texel, cell);
        let slope = |s: f64| Turn::new(self.curvature, s).slope(surface.seen_at(s), stretch);
        let gap = (cell.end - cell.start) / f64::from(SAMPLES_PER_CELL);
        let middle = best.distance;
        for (low, high) in [(middle - gap, middle), (middle, middle + gap)] {
            let (low, high) = (low.max(cell.start), high.min(cell.end));
            if low < high {
                let peak = golden_sections(low, high, slope);
                best.raise(slope(peak), peak);
            }
        }
    }
}

/// Where a function of one maximum has it, within an interval.
fn golden_sections(mut low: f64, mut high: f64, value: impl Fn(f64) -> f64) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_894_8;
    for _ in 0..SECTIONS {
        let (left, right) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
        if value(left) > value(right) { high = right } else { low = left }
    }
    0.5 * (low + high)
}

/// What is needed of an angle γ = κs round the circle, the same for every texel.
///
/// The exact form, [δ cos γ − (1 + κh) ½κs sinc²(γ/2)] / [(1 + κh + κsδ) sinc γ], of Onoue, Max, Nishita, *Bumpmap
/// Shadows on Curved Surfaces*, before eq 2, with the point's own height put into the denominator, where print omits
/// it.
struct Turn {
    distance: f64,
    angle: f64,
    cos: f64,
    sinc: f64,
    sink: f64,
}

impl Turn {
    fn new(curvature: f64, distance: f64) -> Self {
        let angle = curvature * distance;
        let half_sinc = sinc(0.5 * angle);
        let sink = 0.5 * angle * half_sinc * half_sinc;
        Self { distance, angle, cos: libm::cos(angle), sinc: sinc(angle), sink }
    }

    /// The curved slope of a point of flat slope δ; `stretch` is 1 + κh, positive.
    fn slope(&self, flat: f64, stretch: f64) -> f64 {
        let widening = stretch + self.angle * flat;
        if widening <= 0.0 {
            // A shaft deeper than a ball's centre is out of sight; relief across a hollow's centre closes it.
            return if self.angle > 0.0 { f64::NEG_INFINITY } else { f64::INFINITY };
        }
        (flat * self.cos - stretch * self.sink) / (widening * self.sinc)
    }
}

fn sinc(x: f64) -> f64 {
    if x.abs() < 1e-4 { 1.0 - x * x / 6.0 } else { libm::sin(x) / x }
}
