//! Relief: where rays meet it, from every start by every search, what it costs, and its shadows.
//!
//! # How far apart
//!
//! Depths are parts of the relief's thickness. The searches that end in an exact cell (cone steps, maximum mips) agree to 1e-5: rounding
//! of 32-bit floats. Those that halve their last step agree to 1e-4, which is what their halvings leave here: where a step ends on the
//! surface itself rounding decides whether it is inside, and the halvings then come from the other side. By a sampler whose weights
//! have 8 bits a place is known to 1/512 of a texel, and a depth to what the relief rises on that: the cells of exact searches are
//! loaded, so that only the others see it. A share of the rays may be further off: they graze an edge, and see another point behind it.

mod scene;
mod searches;

use barchan_shade::{Relief, TracedRelief};
use barchan_view::Probe;
use barchan_wgpu::{ReliefSearch, Sampling, Technique};
use glam::DVec3;

use crate::compare::agree;
use crate::support::{Loaded, numbers, places};
use scene::ReliefTwin;

/// Every search; the halvings leave 2⁻¹² of a step or less.
const SEARCHES: [ReliefSearch; 5] = [
    ReliefSearch::Linear { steps: 40, bisections: 10 },
    ReliefSearch::ParallaxOcclusion { steps: 40 },
    ReliefSearch::ConeSteps,
    ReliefSearch::RelaxedConeSteps { bisections: 14 },
    ReliefSearch::MaximumMip,
];

/// What one search may be off.
#[derive(Debug, Clone, Copy)]
struct Limits {
    /// Depths, but for a share of the rays.
    depth: f64,
    depth_share: f64,
    /// The share of the rays that may read more or less than the twin does.
    fetch_share: f64,
}

impl Limits {
    fn of(search: ReliefSearch) -> Self {
        let depth = if is_exact(search) { 1e-5 } else { 1e-4 };
        Self { depth, depth_share: 0.003, fetch_share: 0.01 }
    }
}

/// Whether a search ends in an exact cell, and steps over nothing.
fn is_exact(search: ReliefSearch) -> bool {
    matches!(search, ReliefSearch::ConeSteps | ReliefSearch::MaximumMip)
}

/// A word for a search in the names of pictures.
fn word(search: ReliefSearch) -> &'static str {
    match search {
        ReliefSearch::Linear { .. } => "linear",
        ReliefSearch::ParallaxOcclusion { .. } => "parallax",
        ReliefSearch::ConeSteps => "cones",
        ReliefSearch::RelaxedConeSteps { .. } => "relaxed",
        ReliefSearch::MaximumMip => "mips",
    }
}

/// Towards an eye or a light at a polar angle and an azimuth in degrees, of exactly the direction that the GPU is given.
fn towards(polar: f64, azimuth: f64) -> DVec3 {
    let ((sin, cos), (y, x)) = (polar.to_radians().sin_cos(), azimuth.to_radians().sin_cos());
    DVec3::new(sin * x, sin * y, cos).as_vec3().as_dvec3()
}

/// Places in and around a tile, from 3/8 of it before to as much behind, on texels and between them.
fn around((width, height): (u32, u32), towards: DVec3) -> Probe {
    let size = (37, 29);
    let along = |texels: u32, pixels: u32| (texels as f32 * 1.75 / pixels as f32 * 64.0).ceil() / 64.0;
    let before = |texels: u32| (texels as f32 * -0.375 * 64.0).round() / 64.0;
    Probe {
        size,
        place: [before(width), before(height)],
        step: [along(width, size.0), along(height, size.1)],
        eye: towards.as_vec3().to_array(),
        ..Probe::default()
    }
}

/// Draws one eye's rays and compares depths, starts and fetches with the twin's; returns the depths found.
#[track_caller]
fn assert_finds(
    name: &str,
    loaded: &Loaded,
    (search, sampling): (ReliefSearch, Sampling),
    probe: &Probe,
    limits: Limits,
) -> Vec<f64> {
    let pass = loaded.pass(&[Technique::Relief(search)], sampling);
    let found = pass.draw(probe).unwrap();
    let twin = ReliefTwin::new(loaded);
    let expected = twin.find(search, &places(probe), eye(probe));
    let number = |of: &dyn Fn(f64, barchan_shade::Found) -> f64, missing: f64| -> Vec<f64> {
        expected.iter().map(|ray| ray.map_or(missing, |(start, found)| of(start, found))).collect()
    };
    let name = |what: &str| format!("relief.{name}.{}.{what}", word(search));
    let depths = numbers(&found, 0);
    agree(&name("depth"), probe.size, &depths, &number(&|_, e| e.depth, -1.0), limits.depth, limits.depth_share);
    for (what, of) in [
        (1, (&|_, e: barchan_shade::Found| f64::from(e.fetches.heights)) as &dyn Fn(f64, barchan_shade::Found) -> f64),
        (2, &|_, e| f64::from(e.fetches.tables)),
    ] {
        agree(&name("fetches"), probe.size, &numbers(&found, what), &number(of, 0.0), 0.0, limits.fetch_share);
    }
    agree(&name("start"), probe.size, &numbers(&found, 3), &number(&|start, _| start, 0.0), 1e-6, 0.0);
    depths
}

fn eye(probe: &Probe) -> DVec3 {
    DVec3::from_array(probe.eye.map(f64::from))
}

/// Fails where more than one in a thousand rays is found behind its first hit: where relief was stepped over.
#[track_caller]
fn assert_never_tunnels(name: &str, relief: &Relief<'_>, probe: &Probe, depths: &[f64]) {
    let (traced, places) = (TracedRelief::new(relief), places(probe));
    let is_behind = |(&(x, y), &depth): (&(f64, f64), &f64)| {
        relief.ray(x, y, eye(probe)).is_some_and(|ray| depth > traced.first_hit(&ray, 0.0) + 1e-5)
    };
    let behind = places.iter().zip(depths).filter(|&ray| is_behind(ray)).count();
    assert!(behind * 1000 <= depths.len(), "{name}: {behind} of {} rays tunnel", depths.len());
}
