//! A grid of directions over the hemisphere: rings around the normal, cut into azimuths.

use crate::Azimuths;
use crate::angle::tangent;
use crate::terms::numbered;

/// How the polar angle is cut into rings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum RingSpacing {
    /// Edge k is at the polar angle k / rings · greatest.
    EqualAngles,
    /// Edge k is where the tangent of the polar angle is (k / rings)² · tangent of the greatest: rings that sweep a
    /// relief more evenly, found without an arctangent.
    SquaredTangents,
}

numbered!(RingSpacing: EqualAngles = 1 "equal_angles", SquaredTangents = 2 "squared_tangents");

/// The cells of a hemisphere table: ring k of azimuth j is layer k · azimuths + j.
///
/// A direction points from the surface to the eye or the light. Its polar angle is counted from the normal; its azimuth
/// counter-clockwise from +u, so that a quarter turn is up the picture. Ring k holds the polar angles from edge k up to,
/// but without, edge k + 1; azimuth j those within half a step of `azimuths.radians(j)`.
///
/// Any values can be written here; what a table cannot hold is refused when a descriptor is made of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HemisphereDirections {
    /// The number of rings, at least 1.
    pub rings: u32,
    /// The middles of the azimuth cells: a full circle, or an arc of two or more.
    pub azimuths: Azimuths,
    /// How the polar angle is cut.
    pub spacing: RingSpacing,
    /// Where the last ring ends, in radians from the normal: more than 0, less than π/2.
    pub max_polar_radians: f64,
}

impl HemisphereDirections {
    /// The number of cells, which is the number of layers of a table.
    #[must_use]
    pub fn layers(&self) -> u32 {
        self.rings.saturating_mul(self.azimuths.count())
    }

    /// The layer of ring `ring` and azimuth `azimuth`.
    #[must_use]
    pub fn layer(&self, ring: u32, azimuth: u32) -> u32 {
        ring * self.azimuths.count() + azimuth
    }

    /// The ring and the azimuth of a layer.
    #[must_use]
    pub fn ring_and_azimuth(&self, layer: u32) -> (u32, u32) {
        let azimuths = self.azimuths.count().max(1);
        (layer / azimuths, layer % azimuths)
    }

    /// The tangent of the polar angle at which ring `ring` begins; at `rings`, where the last one ends. It rises from 0.
    ///
    /// The same bits on every machine. Who asks for many rays keeps the edges in a list.
    #[must_use]
    pub fn tangent_of_edge(&self, ring: u32) -> f64 {
        let part = f64::from(ring) / f64::from(self.rings);
        match self.spacing {
            RingSpacing::EqualAngles => tangent(part * self.max_polar_radians),
            RingSpacing::SquaredTangents => part * part * tangent(self.max_polar_radians),
        }
    }

    /// The ring of a direction whose polar angle has that tangent, the horizontal part over the part along the normal:
    /// the last ring whose edge is not beyond it. None at or beyond the end of the last ring, and for what is negative or
    /// not a number.
    #[must_use]
    pub fn ring_of_tangent(&self, tangent: f64) -> Option<u32> {
        if !(tangent >= 0.0 && tangent < self.tangent_of_edge(self.rings)) {
            return None;
        }
        // Edge `low` is not beyond the tangent, edge `high` is.
        let (mut low, mut high) = (0, self.rings);
        while high - low > 1 {
            let middle = low + (high - low) / 2;
            if self.tangent_of_edge(middle) <= tangent {
                low = middle;
            } else {
                high = middle;
            }
        }
        Some(low)
    }

    /// The azimuth whose cell holds an azimuth, any finite number of radians: the nearest one. None further than half a
    /// step beyond the ends of an arc, and for what is not a number.
    #[must_use]
    pub fn azimuth_cell(&self, azimuth_radians: f64) -> Option<u32> {
        self.azimuths.nearest(azimuth_radians)
    }
}
