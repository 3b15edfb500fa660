//! The truth: shadow rays traced over the surface that relief really makes, P(u, v) + h(u, v) N(u, v), in f64.
//!
//! # Theory
//!
//! Every point of space near the base surface has a foot (u, v) on it and a height w above it, so whether a ray is inside the
//! relief is a comparison of two heights: its *clearance* w − h(u, v), of the bilinear relief. A ray is followed
//!
//! - in leaps through space that is higher than all relief, by as much as it is higher, until it can never come back;
//! - in steps of at most half a texel of (u, v) elsewhere. A step is looked at as a whole: inside one texel the relief along a
//!   straight line is a parabola, so the clearance between two points is no lower than the lower of both by a quarter of the
//!   cell's twist times the step, plus what the step is not straight, which is measured at its middle and doubled. Across the
//!   border of texels the steepest slope of the cells beside it bounds it instead. A step that is not clear by that is halved.
//!
//! # Tolerance
//!
//! A shadow is where a ray is deeper in the relief than 1e-9 of the relief's range, and 1e-13 of its distance from the origin;
//! a ray that touches relief less deep may go either way. A ray that is still in the relief's reach after a million steps is lit. Relief of a flat base agrees with [`crate::TracedShadow`].
//!
//! # Limits
//!
//! Where relief stands above an edge, of a patch that has some, it ends in a wall straight up: light passes beside it. What
//! gets under a patch is in its shadow. Two sheets of one surface, as the sides of a torus's hole, must be farther
//! apart than twice the highest relief; relief of a hollow must stay below its centres of curvature.

use glam::{DVec2, DVec3};

use crate::{BaseSurface, Foot, Ray, Surface};

/// The part of the relief's range that a ray must be deep in relief to be blocked.
const RELIEF_TOLERANCE: f64 = 1e-9;

/// The part of a position's size that is taken for rounding.
const POSITION_TOLERANCE: f64 = 1e-13;

/// The longest step in texels.
const STEP_TEXELS: f64 = 0.5;

/// How often a step is halved at most.
const HALVINGS: u32 = 34;

/// Steps of a ray at most: more than any picture needs, and an end for a ray that runs level over an endless plane.
const STEPS: u32 = 1 << 20;

/// Nearer to a border of texels than this, in texels, is on it.
const BORDER_TEXELS: f64 = 1e-11;

/// Traces shadow rays over relief on a base surface.
pub struct DisplacedShadow<'a, B: ?Sized> {
    base: &'a B,
    relief: &'a Surface,
    reach: f64,
    lowest: f64,
    highest: f64,
}

/// A point of a ray.
#[derive(Debug, Clone, Copy)]
struct Sample {
    distance: f64,
    uv: DVec2,
    /// In texels.
    place: DVec2,
    /// Above the base surface, and that of the relief there.
    height: f64,
    relief: f64,
    beyond_edge: bool,
}

/// By how much the middle of a step differs from the mean of its ends.
#[derive(Debug, Clone, Copy)]
struct Sag {
    height: f64,
    place: DVec2,
}

impl Sample {
    fn clearance(&self) -> f64 {
        self.height - self.relief
    }
}

impl Sag {
    fn of(start: &Sample, middle: &Sample, end: &Sample) -> Self {
        Self {
            height: (middle.height - 0.5 * (start.height + end.height)).abs(),
            place: (middle.place - 0.5 * (start.place + end.place)).abs(),
        }
    }

    /// Of half the step.
    fn halved(self) -> Self {
        Self { height: 0.25 * self.height, place: 0.25 * self.place }
    }
}

impl<'a, B: BaseSurface + ?Sized> DisplacedShadow<'a, B> {
    /// Rays of at most the length `reach`, which may be infinite where rays leave the surface in the end.
    #[must_use]
    pub fn new(base: &'a B, relief: &'a Surface, reach: f64) -> Self {
        let (lowest, highest) = relief.heights().range();
        Self { base, relief, reach, lowest: f64::from(lowest), highest: f64::from(highest) }
    }

    /// Whether relief or the base surface itself comes between the relief at (u, v) and a light from `towards`, a unit vector.
    #[must_use]
    pub fn in_shadow(&self, uv: DVec2, towards: DVec3) -> bool {
        let foot = self.base.point(uv);
        let relief = self.relief_at(uv);
        let origin = foot.position + foot.frame.normal * relief;
        let ray = Ray { origin, direction: towards };
        let start = Sample { distance: 0.0, uv, place: self.place(uv), height: relief, relief, beyond_edge: false };
        let tolerance = RELIEF_TOLERANCE * (self.highest - self.lowest) + POSITION_TOLERANCE * origin.length();
        self.is_blocked(&ray, start, tolerance)
    }

    fn is_blocked(&self, ray: &Ray, start: Sample, tolerance: f64) -> bool {
        let thickness = self.highest.abs().max(self.lowest.abs());
        let mut here = start;
        for _ in 0..STEPS {
            if here.distance >= self.reach {
                return false;
            }
            let step = self.step(ray, &here);
            // Relief is nowhere nearer than this.
            let top = if here.beyond_edge { thickness } else { self.highest };
            let empty = here.height - top;
            if empty > 0.0 {
                let ahead = Ray { origin: ray.at(here.distance), direction: ray.direction };
                if self.base.escapes(&ahead, top) {
                    return false;
                }
                if empty > step {
                    here = self.sample(ray, here.distance + empty, None);
                    continue;
                }
            }
            let end = self.checked_step(ray, &here, step.min(self.reach - here.distance));
            let middle = self.sample(ray, 0.5 * (here.distance + end.distance), Some(here.uv));
            let sag = Sag::of(&here, &middle, &end).halved();
            if self.dips(ray, [&here, &middle], sag, (HALVINGS, tolerance))
                || self.dips(ray, [&middle, &end], sag, (HALVINGS, tolerance))
            {
                return true;
            }
            here = end;
        }
        false
    }

    /// How far the ray may go for its foot to move less than a step of texels, about.
    fn step(&self, ray: &Ray, here: &Sample) -> f64 {
        let frame = self.base.point(here.uv).frame;
        let speed = self.per_texel(frame.texture_step(ray.direction)).abs().max_element();
        // Straight up, nothing but height changes.
        let shell = (self.highest - self.lowest).max(1e-3 * frame.along_u.length());
        if speed > 0.0 { (0.8 * STEP_TEXELS / speed).min(shell) } else { shell }
    }

    /// The end of a step that was shortened until it is short in texels as well.
    fn checked_step(&self, ray: &Ray, here: &Sample, step: f64) -> Sample {
        let mut step = step;
        for _ in 0..HALVINGS {
            let end = self.sample(ray, here.distance + step, Some(here.uv));
            let moved = (end.place - here.place).abs().max_element();
            // Not comparable is as good as short: a chart without area must not hold the ray up.
            let short = moved <= STEP_TEXELS || moved.is_nan();
            if short || end.beyond_edge || here.beyond_edge {
                return end;
            }
            step *= 0.5;
        }
        self.sample(ray, here.distance + step, Some(here.uv))
    }

    fn sample(&self, ray: &Ray, distance: f64, near: Option<DVec2>) -> Sample {
        let Foot { uv, height, beyond_edge } = self.base.foot(ray.at(distance), near);
        Sample { distance, uv, place: self.place(uv), height, relief: self.relief_at(uv), beyond_edge }
    }

    /// Whether the ray is below the relief anywhere between two of its points.
    fn dips(&self, ray: &Ray, [a, b]: [&Sample; 2], sag: Sag, (halvings, tolerance): (u32, f64)) -> bool {
        let below = |sample: &Sample| !sample.beyond_edge && sample.clearance() < -tolerance;
        if below(a) || below(b) {
            return true;
        }
        if self.least_clearance([a, b], sag) >= -tolerance || halvings == 0 {
            return false;
        }
        let middle = self.sample(ray, 0.5 * (a.distance + b.distance), Some(a.uv));
        let rest = (halvings - 1, tolerance);
        self.dips(ray, [a, &middle], sag.halved(), rest) || self.dips(ray, [&middle, b], sag.halved(), rest)
    }

    /// A bound from below of the clearance between two points.
    fn least_clearance(&self, [a, b]: [&Sample; 2], sag: Sag) -> f64 {
        if a.beyond_edge || b.beyond_edge {
            return if a.beyond_edge && b.beyond_edge { f64::INFINITY } else { f64::NEG_INFINITY };
        }
        let (low, high) = (a.place.min(b.place), a.place.max(b.place));
        let first = (low + BORDER_TEXELS).floor();
        let last = ((high - BORDER_TEXELS).ceil() - 1.0).max(first);
        let (mut steepest, mut twist) = (DVec2::ZERO, 0.0_f64);
        for row in first.y as i64..=last.y as i64 {
            for column in first.x as i64..=last.x as i64 {
                let [h00, h10, h01, h11] = self.cell(column, row);
                let slopes =
                    DVec2::new((h10 - h00).abs().max((h11 - h01).abs()), (h01 - h00).abs().max((h11 - h10).abs()));
                (steepest, twist) = (steepest.max(slopes), h00 - h10 - h01 + h11);
            }
        }
        let moved = high - low;
        let not_straight = 2.0 * (sag.height + steepest.dot(sag.place));
        if first == last {
            a.clearance().min(b.clearance()) - 0.25 * (twist * moved.x * moved.y).abs() - not_straight
        } else {
            a.height.min(b.height) - a.relief.max(b.relief) - 0.5 * steepest.dot(moved) - not_straight
        }
    }

    /// The corners of the cell right of and below a texel.
    fn cell(&self, column: i64, row: i64) -> [f64; 4] {
        [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(i, j)| f64::from(self.relief.heights().texel(column + i, row + j)))
    }

    fn place(&self, uv: DVec2) -> DVec2 {
        self.relief.texel_of(uv).into()
    }

    fn relief_at(&self, uv: DVec2) -> f64 {
        let (x, y) = self.relief.texel_of(uv);
        self.relief.heights().sample(x, y)
    }

    /// Texels per unit of texture coordinates.
    fn per_texel(&self, step: DVec2) -> DVec2 {
        let heights = self.relief.heights();
        step * DVec2::new(f64::from(heights.width()), f64::from(heights.height()))
    }
}
