//! Relief: where rays meet it, from every start by every search, what it costs, and its shadows.
//!
//! # How far apart
//!
//! Depths are parts of the relief's thickness. Searches that end in an exact cell (cone steps, maximum mips) agree to 1e-5, the rounding
//! of 32-bit floats. Of those that step until they are inside, rounding decides wherever a step ends on the surface itself, as it does
//! along the normal and on the top plane: linear search and parallax occlusion then go on, now and then to another point of a
//! grazing ray, and relaxed cones end up to two of their least steps, of 1/1024, behind. A sampler's weights have 8 bits, so that through it a place
//! is known to 1/512 of a texel, and a depth to what the relief rises on that; exact cells are loaded and do not see it.

mod depth_map;
mod hostile;
mod places;
mod scene;
mod searches;
mod shadow;

use barchan_shade::{Found, Relief, TracedRelief};
use barchan_view::{Probe, ProbePass};
use barchan_wgpu::{ReliefSearch, Sampling, Technique};
use glam::DVec3;

use crate::compare::agree;
use crate::support::{Loaded, numbers, places};
use scene::ReliefTwin;

/// Every search; halvings leave little of a step.
const SEARCHES: [ReliefSearch; 5] = [
    ReliefSearch::Linear { steps: 40, bisections: 10 },
    ReliefSearch::ParallaxOcclusion { steps: 40 },
    ReliefSearch::ConeSteps,
    ReliefSearch::RelaxedConeSteps { bisections: 14 },
    ReliefSearch::MaximumMip,
];

/// What a search may be off.
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
        match search {
            ReliefSearch::ConeSteps | ReliefSearch::MaximumMip => {
                Self { depth: 1e-5, depth_share: 0.001, fetch_share: 0.02 }
            }
            ReliefSearch::RelaxedConeSteps { .. } => Self { depth: 2e-3, depth_share: 0.02, fetch_share: 0.05 },
            _ => Self { depth: 1e-4, depth_share: 0.01, fetch_share: 0.05 },
        }
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

fn eye(probe: &Probe) -> DVec3 {
    DVec3::from_array(probe.eye.map(f64::from))
}

/// A search of a file, by the GPU and by its twin.
struct Case<'a> {
    name: String,
    search: ReliefSearch,
    limits: Limits,
    pass: ProbePass<'a>,
    twin: ReliefTwin<'a>,
}

impl<'a> Case<'a> {
    fn new(name: &str, loaded: &'a Loaded, search: ReliefSearch, sampling: Sampling) -> Self {
        Self {
            name: format!("relief.{name}.{}", word(search)),
            search,
            limits: Limits::of(search),
            pass: loaded.pass(&[Technique::Relief(search)], sampling),
            twin: ReliefTwin::new(loaded),
        }
    }

    fn within(self, limits: Limits) -> Self {
        Self { limits, ..self }
    }

    /// Compares depths, starts and fetches of an eye's rays; returns the depths that the GPU found.
    #[track_caller]
    fn assert_agrees(&self, probe: &Probe) -> Vec<f64> {
        let found = self.pass.draw(probe).unwrap();
        let expected = self.twin.find(self.search, &places(probe), eye(probe));
        let compare = |what: &str, which: usize, of: fn(f64, Found) -> f64, given_up: f64, tolerance, share| {
            let expected: Vec<f64> =
                expected.iter().map(|ray| ray.map_or(given_up, |(start, f)| of(start, f))).collect();
            let [x, y, z] = probe.eye;
            let name = format!("{}.{what}.{x:.2}.{y:.2}.{z:.2}", self.name);
            agree(&name, probe.size, &numbers(&found, which), &expected, tolerance, share);
        };
        let Limits { depth, depth_share, fetch_share } = self.limits;
        // A ray along the normal steps onto the surface itself.
        let is_decided_by_rounding = !is_exact(self.search) && probe.eye[2] == 1.0;
        let fetch_share = if is_decided_by_rounding { 1.0 } else { fetch_share };
        compare("start", 3, |start, _| start, 0.0, 1e-6, 0.0);
        compare("depth", 0, |_, found| found.depth, -1.0, depth, depth_share);
        compare("heights", 1, |_, found| f64::from(found.fetches.heights), 0.0, 0.0, fetch_share);
        compare("tables", 2, |_, found| f64::from(found.fetches.tables), 0.0, 0.0, fetch_share);
        numbers(&found, 0)
    }

    /// The same, and no ray is found behind its first hit, but for one in a thousand: nothing was stepped over.
    #[track_caller]
    fn assert_is_exact(&self, probe: &Probe) {
        let (depths, relief) = (self.assert_agrees(probe), self.twin.relief());
        assert_never_tunnels(&self.name, &relief, probe, &depths);
    }
}

#[track_caller]
fn assert_never_tunnels(name: &str, relief: &Relief<'_>, probe: &Probe, depths: &[f64]) {
    let (traced, places) = (TracedRelief::new(relief), places(probe));
    let is_behind = |(&(x, y), &depth): (&(f64, f64), &f64)| {
        relief.ray(x, y, eye(probe)).is_some_and(|ray| depth > traced.first_hit(&ray, 0.0) + 1e-5)
    };
    let behind = places.iter().zip(depths).filter(|&ray| is_behind(ray)).count();
    assert!(behind * 1000 <= depths.len(), "{name}: {behind} of {} rays tunnel", depths.len());
}
