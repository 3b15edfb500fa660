//! Where the rays of one cell of directions stand: a sector of a ring, as convex pieces.
//!
//! From depth 0 down to d a ray of tangent t and azimuth φ moves d·t·(−u cos φ, v sin φ) in columns and rows, u and v being the texels that a
//! ray of tangent 1 moves down to depth 1: away from where it comes from, and rows are counted downwards. A slab of depths and a cell of
//! directions are therefore the radii d₀t₀ … d₁t₁ of a sector of a ring, stretched by (−u, v). Stretching keeps straight lines straight
//! and what is inside, inside.

use std::f64::consts::PI;
use std::ops::Range;

use barchan_asset::HemisphereDirections;

/// By how much a cell of directions is widened on each side, as a part of itself.
const MARGIN: f64 = 1.0 / (1 << 10) as f64;

/// The widest piece, in radians: the outer side of the quadrilateral around it bulges by 1/4096 of its radius.
const WIDEST_PIECE: f64 = 1.0 / 24.0;

/// The sector of a cell of directions.
pub(super) struct Sector {
    tangents: Range<f64>,
    /// Where each piece ends and the next begins, on the stretched circle of radius 1: columns and rows.
    borders: Vec<(f64, f64)>,
    /// The radius of the corners around an arc of radius 1.
    bulge: f64,
}

/// The corners of a convex quadrilateral in columns and rows, in order.
pub(super) type Quadrilateral = [(f64, f64); 4];

impl Sector {
    pub(super) fn of_layer(directions: &HemisphereDirections, layer: u32, (u, v): (f64, f64)) -> Self {
        let (ring, azimuth) = directions.ring_and_azimuth(layer);
        let step = directions.azimuths.step_radians();
        let half = ((0.5 + MARGIN) * step).min(PI);
        let first = directions.azimuths.radians(azimuth) - half;
        let pieces = (2.0 * half / WIDEST_PIECE).ceil().max(1.0);
        let piece = 2.0 * half / pieces;
        let border = |index: u32| {
            let angle = first + f64::from(index) * piece;
            (-u * libm::cos(angle), v * libm::sin(angle))
        };
        Self {
            tangents: tangents(directions, ring),
            borders: (0..=pieces as u32).map(border).collect(),
            bulge: 1.0 / libm::cos(0.5 * piece),
        }
    }

    /// Convex pieces that together hold every way that a ray has gone at some depth of a slab.
    pub(super) fn pieces(&self, depths: Range<f64>) -> impl Iterator<Item = Quadrilateral> {
        let inner = depths.start * self.tangents.start;
        let outer = depths.end * self.tangents.end * self.bulge;
        let at = |(x, y): (f64, f64), radius: f64| (radius * x, radius * y);
        self.borders
            .windows(2)
            .map(move |border| [at(border[0], inner), at(border[0], outer), at(border[1], outer), at(border[1], inner)])
    }
}

/// The tangents of a ring with its margin. Tangents rise faster and faster, so that a neighbouring ring's width says what a part of a
/// cell comes to beyond the outer edge; the last ring has no neighbour but itself.
fn tangents(directions: &HemisphereDirections, ring: u32) -> Range<f64> {
    let edge = |ring: u32| directions.tangent_of_edge(ring);
    let (inner, outer) = (edge(ring), edge(ring + 1));
    let beyond = if ring + 1 < directions.rings { edge(ring + 2) - outer } else { 2.0 * (outer - inner) };
    (inner - MARGIN * (outer - inner)).max(0.0)..outer + MARGIN * beyond
}
