//! How much sky a texel sees, and where: what the horizons give for free.
//!
//! # What is baked
//!
//! A texel's **sky** is the set of directions ω that lie above the horizon of their azimuth, above the horizontal,
//! and above the texel's own tangent plane. With n the surface normal, three tables say what is left of it:
//!
//! > visibility      A = (1/π) ∫ n·ω dω over the sky
//! > bent normal     b = the direction of ∫ ω (n·ω) dω
//! > aperture cone   the direction of ∫ ω dω, and the cap of the sky's solid angle Ω: cos ½-angle = 1 − Ω/2π
//!
//! A is the sky-view factor of Jeff Dozier, James Frew, *Rapid calculation of terrain parameters for radiation
//! modeling from digital elevation data*, 1990, eq 7b, which others call ambient visibility; ambient occlusion is 1 −
//! A. The bent normal is that of Hayden Landis, *Production-ready global illumination*, 2002, weighted by the cosine:
//! under light that varies linearly with direction, L = l₀ + l·ω, the irradiance is then exactly π A l₀ + l·∫ ω (n·ω)
//! dω, so that A and b are all it asks for. The cone is that of Christopher Oat, Pedro V. Sander, *Ambient aperture
//! lighting*, 2007, and carries no cosine, which is applied at run time to the light that comes through.
//!
//! # One slice
//!
//! At azimuth φ the sky is the arc from θ₀ to the zenith. The tangent plane has slope t = ∇h·φ̂ there, so n·ω =
//! N (sin θ − t cos θ), N = 1/√(1 + |∇h|²), and θ₀ = max(horizon, atan t, 0). With s = sin θ₀, c = cos θ₀ and
//! g = π/2 − θ₀ − s c, the elevation integrates in closed form:
//!
//! > visibility      ∫ n·ω cos θ dθ = ½ N (c² − t g)
//! > bent normal     ∫ ω (n·ω) cos θ dθ = ⅓ N (c³ − t (1 − s)² (2 + s)) along φ̂, ⅓ N (1 − s³ − t c³) upwards
//! > cone            ∫ ω cos θ dθ = ½ g along φ̂, ½ c² upwards; solid angle ∫ cos θ dθ = 1 − s
//!
//! The first is Dozier and Frew's integrand, with their slope and aspect written as a gradient. Over azimuth the
//! slices are summed with equal weights, which for a periodic function converges faster than any power where the
//! skyline is smooth. `cargo run --release -p barchan-bakers --example sky` prints what is left.
//!
//! Tried and not taken, on 64² fields against 768 azimuths, measured once and printed by no command:
//!
//! - Horizons joined by straight lines and integrated eight times as finely. The previous direction and the first
//!   must be held beside the current one, and what is gained where the skyline is ragged is little beside what is
//!   lost where it is smooth. RMS of visibility at 16 azimuths: fractal .00136 → .00134, white noise .0134 → .0131,
//!   spike .0043 → .0035; but dunes .0003 → .0005, pyramid .0005 → .0010, Gaussian .0001 → .0011, step wall .0006 →
//!   .0026, ripples .00001 → .0016.
//! - A second pass at the end that replaces the tangent plane's share of each sum, known from the normal alone, by
//!   its closed form. Visibility gains nothing; the half-angle a third to a half of its error on ripples, bumps,
//!   pyramids and walls, and nothing on rough relief.
//!
//! # Departures
//!
//! - Horizons are signed but the sky ends at the horizontal: of any bounded surface that goes on for ever the horizon
//!   is at or above it, and one below is only the search radius ending. So an open slope of angle S has A = (1 + cos
//!   S)/2.
//! - The tables come from what the accumulator is handed: the horizons' azimuths are the only sampling there is.
//! - A is also n·∫ ω dω / π, which would spare its sum when the cone is asked for. Not taken: a table's bytes shall not
//!   depend on which others were asked for.
//!
//! # Conventions
//!
//! The normal is that of the central differences of the heights, (−∂h/∂u, −∂h/∂v, 1) normalised: the mean of the
//! bilinear surface's two one-sided slopes, in lengths, continued beyond the edge by the field's policy. Vectors are
//! unit vectors in (u, v, height), v up the picture. Where nothing is seen, A is 0 and both directions are the
//! normal, the cone's half-angle 0. A slope component beyond 10¹⁸ counts as 10¹⁸.

mod accumulator;
mod ground;
mod map;
mod params;
pub mod reference;
mod slice;

use barchan_field::HeightField;

pub use accumulator::SkyAccumulator;
pub use map::SkyMap;
pub use params::{MIN_SKY_DIRECTIONS, SkyParams};

use crate::horizon::{self, HorizonParams};
use crate::{BakeError, Exec};

/// Names the algorithm in provenance. It changes when a bake's bytes do.
pub const ALGORITHM: &str = "sky-slices-1";

/// Bakes the horizons and the sky they leave: for tests, tools and maps of a size that fits in memory. A pipeline
/// that has the horizons one direction at a time feeds a [`SkyAccumulator`] itself and never holds them all.
///
/// # Errors
///
/// What [`horizon::bake`] and [`SkyAccumulator::new`] refuse.
pub fn bake(
    field: &HeightField,
    horizons: &HorizonParams,
    params: SkyParams,
    exec: &Exec,
) -> Result<SkyMap, BakeError> {
    let mut sky = SkyAccumulator::new(field, &horizons.azimuths, params)?;
    let map = horizon::bake(field, &HorizonParams { distance: false, ..*horizons }, exec)?;
    for direction in 0..horizons.directions() {
        sky.add(direction, map.elevation_layer(direction), exec);
    }
    sky.finish(exec)
}
