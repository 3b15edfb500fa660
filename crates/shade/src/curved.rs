//! The horizon of relief on a curved base surface, from points stored for the flat one.
//!
//! # Theory
//!
//! Along one azimuth the base surface is taken as a circle of curvature κ through the texel: κ > 0 is convex, with
//! its centre below, κ < 0 concave. The texel stands at height h above it, and a stored point (δ, d) is the top of
//! relief at arc length d, at height h + dδ. In the tangent frame of the texel, with γ = κd and sinc x = sin x / x,
//! it is seen at the slope
//!
//! > δ′ = [δ cos γ − (1 + κh) · ½κd · sinc²(γ/2)] / [(1 + κh + κdδ) · sinc γ],
//!
//! written so that nothing is divided by κ or by d: the flat surface is not a special case. This is the full form
//! before eq 2 of Koiichi Onoue, Nelson Max, Tomoyuki Nishita, *Bumpmap Shadows on Curved Surfaces*; eq 2 is its
//! small-angle form, and eq 3 the horizon of the smooth surface itself, below which no horizon on a convex surface
//! can lie.
//!
//! # Departures
//!
//! - The printed full form leaves the point's own height out of the denominator: [`Correction::FullAsPrinted`]. At κ
//!   = 0.015, d = 16, h = 4, δ = 1 the slope is 0.656, the printed form gives 0.805 and eq 2 gives 0.82.
//! - Eq 3 is printed with the wrong sign, and cancels: [`geometric_horizon_as_printed`].
//! - The paper stores one point, the horizon of the flat surface. On the curved one another may stand higher, on
//!   relief of many scales so often that correcting the one is worse than not correcting it. [`curved_horizon`] takes
//!   several and returns the highest; with one it is the paper's method, made exact.
//! - Concave surfaces, which the paper leaves out: eq 3 does not apply, and how far the relief was searched bounds
//!   the answer.
//!
//! # Conventions
//!
//! Lengths h and d in one unit, κ in its inverse, slopes as tangents. Inputs are finite; they may be as coarse as the
//! f32 or f16 of a table, all computing is in f64, and no result is infinite or NaN: [`NO_HORIZON`] and [`CLOSED`]
//! stand for the two ends. Points jump between neighbouring texels: evaluate each tap with its own points and
//! interpolate the results.

use std::f64::consts::{FRAC_PI_2, PI};

/// A slope below every other: what cannot be a horizon, and darkens nothing. Finite, as WGSL does not promise
/// infinities.
pub const NO_HORIZON: f64 = f32::MIN as f64;

/// A slope above every other: relief closes over the texel, and all light is shut out.
pub const CLOSED: f64 = f32::MAX as f64;

/// A stored point of the relief along one azimuth, as a texel of a flat base surface sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StoredPoint {
    /// Rise over run from the texel to the point: δ, the tangent of its elevation, signed.
    pub slope: f64,
    /// Distance to the point along the base surface: d, not negative. 0 is the limit at the texel itself.
    pub distance: f64,
}

/// How the slope of one stored point is carried over to a curved surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Correction {
    /// Not at all: the map as baked for a flat surface.
    Flat,
    /// Eq 2 of the paper, δ(1 − κh) − ½κd: small angles, small slopes. It turns the relief over once κh > 1.
    Paper,
    /// The full form as printed, whose denominator lacks the point's own height: far too high for steep points.
    FullAsPrinted,
    /// The exact form.
    Exact,
}

impl Correction {
    /// Every correction, plainest first.
    pub const ALL: [Self; 4] = [Self::Flat, Self::Paper, Self::FullAsPrinted, Self::Exact];

    /// Its name in studies.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Flat => "flat",
            Self::Paper => "paper",
            Self::FullAsPrinted => "full-as-printed",
            Self::Exact => "exact",
        }
    }

    /// The slope of a stored point seen from `height` above a base surface of the given `curvature`: δ′, within
    /// [`NO_HORIZON`] … [`CLOSED`]. What the base surface itself hides is not known here: [`curved_horizon`].
    #[must_use]
    pub fn slope(self, point: StoredPoint, curvature: f64, height: f64) -> f64 {
        let StoredPoint { slope, distance } = point;
        match self {
            Self::Flat => slope,
            Self::Paper => slope * (1.0 - curvature * height) - 0.5 * curvature * distance,
            Self::FullAsPrinted => full_form(point, curvature, height, 1.0 + curvature * height),
            Self::Exact => {
                let widening = 1.0 + curvature * height + curvature * distance * slope;
                full_form(point, curvature, height, widening)
            }
        }
    }
}

/// The full form over `widening` · sinc γ. `widening` is by how much the arc under a point is longer at some height
/// than at the base surface: at the point's own height in the exact form, at the texel's in print.
fn full_form(point: StoredPoint, curvature: f64, height: f64, widening: f64) -> f64 {
    let StoredPoint { slope, distance } = point;
    let angle = curvature * distance;
    let stretch = 1.0 + curvature * height;
    if !may_be_seen(angle, stretch) {
        return NO_HORIZON;
    }
    if widening <= 0.0 {
        return beyond_the_centre(curvature);
    }
    // One sine and cosine serve: cos γ = 1 − 2 sin²(γ/2), sinc γ = sinc(γ/2) cos(γ/2).
    let (sin_half, cos_half) = libm::sincos(0.5 * angle);
    let half_sinc = sinc(0.5 * angle, sin_half);
    let rise = slope * (1.0 - 2.0 * sin_half * sin_half) - stretch * 0.5 * angle * half_sinc * half_sinc;
    (rise / (widening * half_sinc * cos_half)).clamp(NO_HORIZON, CLOSED)
}

/// Whether a point at the angle γ = κd round the surface's centre may be a horizon, from a texel where the arc is
/// `stretch` = 1 + κh times as long as at the base surface.
///
/// - Convex, γ ≥ π/2: it stands lower than −(1 + κh)/(1 + κh′), h′ its own height, which is below [`geometric_horizon`]
///   unless relief is higher than (√2 − 1)/κ.
/// - Concave, γ ≤ −π: it is behind; up to there the far wall rises towards the zenith.
/// - `stretch` ≤ 0: the texel is at the centre or beyond it, where heights over the base surface have lost their
///   meaning.
fn may_be_seen(angle: f64, stretch: f64) -> bool {
    angle < FRAC_PI_2 && angle > -PI && stretch > 0.0
}

/// The slope of relief that reaches the surface's centre: on a convex surface a shaft that deep is out of sight; on a
/// concave one the relief passes overhead on its way.
fn beyond_the_centre(curvature: f64) -> f64 {
    if curvature > 0.0 { NO_HORIZON } else { CLOSED }
}

/// sin x / x, to rounding, for any x whose sine is given.
fn sinc(x: f64, sin: f64) -> f64 {
    // Where the next term of the series, x⁴/120, is below rounding.
    if x.abs() < 1e-4 { 1.0 - x * x / 6.0 } else { sin / x }
}

/// The horizon of the smooth base surface from `height` above it: −√(κh(2 + κh)), eq 3 with its sign mended. Heights
/// below the base surface count as on it. A surface that is not convex has no such horizon: [`NO_HORIZON`]. The seam
/// is real: however slightly convex, a surface goes on to its own horizon, which tends to 0; at κ = 0 the map knows
/// no more than its search radius.
#[must_use]
pub fn geometric_horizon(curvature: f64, height: f64) -> f64 {
    if curvature <= 0.0 {
        return NO_HORIZON;
    }
    let raised = (curvature * height).max(0.0);
    -(raised * (2.0 + raised)).sqrt()
}

/// Eq 3 as printed, for studies: √(1 − cos²β′)/cos β′ with cos β′ = 1/(κh + 1), *above* the tangent plane, and 0
/// where κh is too small for the difference.
#[must_use]
pub fn geometric_horizon_as_printed(curvature: f64, height: f64) -> f64 {
    if curvature <= 0.0 {
        return NO_HORIZON;
    }
    let cos = 1.0 / ((curvature * height).max(0.0) + 1.0);
    (1.0 - cos * cos).max(0.0).sqrt() / cos
}

/// The slope of the horizon on a curved surface: the highest of the stored points, each carried over exactly, and not
/// below the surface itself. With one point it is the paper's method, made exact; more points only raise it, towards
/// the truth.
///
/// [`NO_HORIZON`] where no point may be seen and the surface is not convex.
#[must_use]
pub fn curved_horizon(points: &[StoredPoint], curvature: f64, height: f64) -> f64 {
    let exact = points.iter().map(|&point| Correction::Exact.slope(point, curvature, height));
    exact.fold(geometric_horizon(curvature, height), f64::max)
}

/// The paper's run time: eq 2 of the one flat horizon, and not below eq 3, with its sign mended.
#[must_use]
pub fn paper_horizon(flat: StoredPoint, curvature: f64, height: f64) -> f64 {
    Correction::Paper.slope(flat, curvature, height).max(geometric_horizon(curvature, height))
}
