//! Sums over the hemisphere: what part of the light from above is cut off.
//!
//! # Theory
//!
//! The occlusion of a point with the normal N is A = (1/π) ∫ V(ω) max(0, N·ω) dω, V being 1 where something stands in the direction
//! ω: eq 3 of Takeshi Suzuki, *An Accelerated Relief Mapping Using Depth Maps*. The hemisphere is cut into cells; of each, V of one
//! direction stands for all, and its weight is N·Ω with
//!
//! > Ω = ∫ ω dω = (R cos φ, R sin φ, Z), R = 2 sin(Δφ/2) ∫ sin²θ dθ, Z = Δφ ∫ sinθ cosθ dθ,
//!
//! over the cell: for a level normal the exact weight of its ring, ½ Δφ (sin²θ₁ − sin²θ₀), for a tilted one the exact weight of every
//! cell that lies in front of it. What is summed is divided by the sum of weights, so that all occluded is 1 for any normal.
//!
//! # Departures
//!
//! - The print has neither the solid angle sinθ ΔθΔφ nor max(0, N·ω) nor the division.
//! - Cells that N's horizon cuts weigh what their front outweighs their back.
//! - What a tilted normal looks at below the top plane is no part of the sum: an inclined plane has no occlusion.
//! - A grid of directions ends before 90°. What stands in a direction of a height field stands in every lower one of that azimuth
//!   too, so the outermost ring's answer is taken for all below it, which is never too dark. At 80° that band weighs cos² 80° = 3 % for
//!   a level normal.
//! - Of an arc of azimuths, only the arc counts.

use std::f64::consts::{FRAC_PI_2, TAU};

use barchan_asset::HemisphereDirections;
use glam::DVec3;

/// A part of the hemisphere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HemisphereCell {
    /// The direction that stands for it: a unit vector from the surface.
    pub towards: DVec3,
    /// Ω: its directions, integrated over its solid angle.
    pub integral: DVec3,
}

/// The hemisphere in cells, ring by ring from the normal, azimuth by azimuth.
#[derive(Debug, Clone, PartialEq)]
pub struct HemisphereQuadrature {
    cells: Vec<HemisphereCell>,
}

/// A ring of cells: where it begins and ends, and the direction that stands for it; polar angles.
#[derive(Debug, Clone, Copy)]
struct Ring {
    inner: f64,
    outer: f64,
    middle: f64,
}

impl HemisphereQuadrature {
    /// The cells of a grid of directions, of at least one ring, each under the direction in its middle.
    #[must_use]
    pub fn of_cells(directions: &HemisphereDirections) -> Self {
        let edges = edges(directions);
        let last = edges.len().saturating_sub(2);
        let rings = edges.windows(2).enumerate().map(|(ring, edge)| Ring {
            inner: edge[0],
            outer: if ring == last { FRAC_PI_2 } else { edge[1] },
            middle: 0.5 * (edge[0] + edge[1]),
        });
        Self::new(rings, directions)
    }

    /// The rays of a grid of directions, of at least one ring, each at the inner edge of its cell, as nearest hemisphere tables hold them; a ray stands for
    /// what is nearer to it than to the next.
    #[must_use]
    pub fn of_rays(directions: &HemisphereDirections) -> Self {
        let edges = edges(directions);
        let last = edges.len().saturating_sub(2);
        let between = |ring: usize| 0.5 * (edges[ring] + edges[ring + 1]);
        let rings = (0..=last).map(|ring| Ring {
            inner: if ring == 0 { 0.0 } else { between(ring - 1) },
            outer: if ring == last { FRAC_PI_2 } else { between(ring) },
            // Within its ring for any rounding.
            middle: edges[ring] + 1e-6 * (edges[ring + 1] - edges[ring]),
        });
        Self::new(rings, directions)
    }

    /// Cells of the same weight for a level normal: `rings` of them, each under the direction that has half its weight above it. Both
    /// counts at least 1.
    #[must_use]
    pub fn even(rings: u32, azimuths: u32) -> Self {
        let polar = |place: f64| libm::asin((place / f64::from(rings.max(1))).sqrt());
        let ring = |ring: u32| {
            let inner = f64::from(ring);
            Ring { inner: polar(inner), outer: polar(inner + 1.0), middle: polar(inner + 0.5) }
        };
        let step = TAU / f64::from(azimuths.max(1));
        let azimuths: Vec<f64> = (0..azimuths.max(1)).map(|k| f64::from(k) * step).collect();
        Self::of_rings((0..rings.max(1)).map(ring), &azimuths, step)
    }

    fn new(rings: impl Iterator<Item = Ring>, directions: &HemisphereDirections) -> Self {
        let azimuths: Vec<f64> = (0..directions.azimuths.count()).map(|k| directions.azimuths.radians(k)).collect();
        Self::of_rings(rings, &azimuths, directions.azimuths.step_radians())
    }

    fn of_rings(rings: impl Iterator<Item = Ring>, azimuths: &[f64], step: f64) -> Self {
        let cells = rings.flat_map(|ring| azimuths.iter().map(move |&azimuth| ring.cell(azimuth, step)));
        Self { cells: cells.collect() }
    }

    /// The cells.
    #[must_use]
    pub fn cells(&self) -> &[HemisphereCell] {
        &self.cells
    }

    /// The occlusion of a point with a unit normal, 0 to 1, of what `occluded` says of the cells in front of it, by their number. 0
    /// where no cell is.
    pub fn occlusion(&self, normal: DVec3, mut occluded: impl FnMut(usize, &HemisphereCell) -> bool) -> f64 {
        let (mut cut_off, mut all) = (0.0, 0.0);
        for (index, cell) in self.cells.iter().enumerate() {
            let weight = normal.dot(cell.integral);
            if weight > 0.0 {
                all += weight;
                cut_off += if occluded(index, cell) { weight } else { 0.0 };
            }
        }
        if all > 0.0 { cut_off / all } else { 0.0 }
    }
}

impl Ring {
    fn cell(self, azimuth: f64, step: f64) -> HemisphereCell {
        let (sin_azimuth, cos_azimuth) = libm::sincos(azimuth);
        let (sin, cos) = libm::sincos(self.middle);
        // Twice ∫ sin²θ dθ and ∫ sinθ cosθ dθ from the normal.
        let twice_level = |polar: f64| {
            let (sin, cos) = libm::sincos(polar);
            polar - sin * cos
        };
        let twice_height = |polar: f64| {
            let sin = libm::sin(polar);
            sin * sin
        };
        let level = libm::sin(0.5 * step) * (twice_level(self.outer) - twice_level(self.inner));
        let height = 0.5 * step * (twice_height(self.outer) - twice_height(self.inner));
        HemisphereCell {
            towards: DVec3::new(sin * cos_azimuth, sin * sin_azimuth, cos),
            integral: DVec3::new(level * cos_azimuth, level * sin_azimuth, height),
        }
    }
}

/// The polar angles of all edges of rings.
fn edges(directions: &HemisphereDirections) -> Vec<f64> {
    (0..=directions.rings).map(|ring| libm::atan(directions.tangent_of_edge(ring))).collect()
}
