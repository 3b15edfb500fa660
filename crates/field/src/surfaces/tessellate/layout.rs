//! How many lines of equal v a tiling has, and how many points on each.

use super::super::ParametricSurface;
use super::metric::Metric;
use super::{Pattern, Tessellation};

/// What a surface does at the ends of its parameters; where nothing is said, it has a border.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ends {
    pub(super) closed_u: bool,
    pub(super) closed_v: bool,
    /// Both ends of v are points.
    pub(super) poles: bool,
}

impl Ends {
    pub(super) fn of(surface: &ParametricSurface) -> Self {
        Self { closed_u: surface.is_closed_u(), closed_v: surface.is_closed_v(), poles: surface.has_poles() }
    }

    /// Has the surface borders at v = 0 and 1?
    pub(super) fn open_v(self) -> bool {
        !self.closed_v && !self.poles
    }
}

/// The lines of a tiling.
pub(super) struct Layout {
    /// Steps along v; line j lies at j steps.
    pub(super) steps_v: u32,
    /// Steps along u on line j, for j from 0 to `steps_v`.
    pub(super) steps_u: Vec<u32>,
    /// Length of a step along u on the surface.
    pub(super) spacing_u: f64,
    /// Extent along v over extent along u of a step.
    pub(super) stretch: f64,
    /// What the surface does at its ends.
    pub(super) ends: Ends,
}

impl Layout {
    /// About as many points as the tessellation asks for, spread evenly by area, or with equally many on each line if it is regular.
    /// None if the surface is so long or so thin that this cannot be met within a factor of two.
    pub(super) fn fit(metric: &Metric, ends: Ends, tessellation: &Tessellation) -> Option<Self> {
        let wanted = f64::from(tessellation.vertices);
        let mut spacing = (metric.total_area() / wanted).sqrt();
        let mut best: Option<Self> = None;
        // Borders, poles and rounding add points or take some away: a few corrections settle that.
        for _ in 0..8 {
            let layout = Self::with_spacing(metric, ends, tessellation, spacing);
            let found = layout.count() as f64;
            let miss = |layout: &Self| (layout.count() as f64 - wanted).abs();
            if best.as_ref().is_none_or(|best| miss(&layout) < miss(best)) {
                best = Some(layout);
            }
            spacing *= (found / wanted).sqrt();
        }
        best.filter(|layout| (0.5..=2.0).contains(&(layout.count() as f64 / wanted)))
    }

    fn with_spacing(metric: &Metric, ends: Ends, tessellation: &Tessellation, spacing: f64) -> Self {
        let even = matches!(tessellation.pattern, Pattern::Regular { .. });
        let (stretch, most) = (tessellation.pattern.aspect(), tessellation.vertices);
        let (spacing_u, spacing_v) = (spacing / stretch.sqrt(), spacing * stretch.sqrt());
        let steps = |length: f64, least: u32| (libm::round(length.min(1e9)) as u32).clamp(least, most);
        let length_v = metric.along_v.total();
        let steps_v = steps(length_v / spacing_v, if ends.closed_v { 3 } else { 2 });
        let least_u = if ends.closed_u { 3 } else { 2 };
        let steps_u = (0..=steps_v).map(|line| {
            let v = metric.along_v.inverse(f64::from(line) / f64::from(steps_v));
            let width = if even { metric.total_area() / length_v } else { metric.width_at(v) };
            steps(width / spacing_u, least_u)
        });
        let steps_u = steps_u.collect();
        Self { steps_v, steps_u, spacing_u, stretch, ends }
    }

    /// The lines that points lie on: poles are not among them, and the last of a closed surface is its first.
    pub(super) fn lines(&self) -> std::ops::Range<u32> {
        let first = u32::from(self.ends.poles);
        first..self.steps_v + u32::from(self.ends.open_v())
    }

    /// Points on `line`, those on borders included.
    pub(super) fn points_on(&self, line: u32) -> u32 {
        self.steps_u[line as usize] + u32::from(!self.ends.closed_u)
    }

    /// Points in all.
    fn count(&self) -> u64 {
        let poles = if self.ends.poles { 2 } else { 0 };
        self.lines().map(|line| u64::from(self.points_on(line))).sum::<u64>() + poles
    }
}
