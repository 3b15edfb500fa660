//! What a depth of 0..1 means, and what a stored depth promises.

use crate::terms::numbered;

/// What a depth measures: a place at depth D, 0..1, is at height `top` − D · `thickness`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReliefRange {
    /// The greatest height of the relief, in the asset's unit of length: depth 0.
    pub top: f64,
    /// From the greatest height down to the least, depth 1, in the asset's unit of length: finite and at least 0.
    pub thickness: f64,
}

impl ReliefRange {
    /// The depth of a height, 0 at the top and 1 at the bottom. On relief without thickness it is 0 everywhere.
    #[must_use]
    pub fn depth(&self, height: f64) -> f64 {
        if self.thickness > 0.0 { (self.top - height) / self.thickness } else { 0.0 }
    }

    /// The height at a depth, in the asset's unit of length.
    #[must_use]
    pub fn height(&self, depth: f64) -> f64 {
        self.top - depth * self.thickness
    }
}

/// What a depth in a hemisphere table says about the rays of its cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum DepthMode {
    /// The depth of the first hit of one ray, the one towards the edge of the ring that is nearer the normal and along
    /// the azimuth; over the texel's area the least of several such rays. Other rays of the cell may hit earlier.
    Nearest,
    /// At most the depth of the first hit of any ray of the cell that enters anywhere in the texel.
    Conservative,
}

numbered!(DepthMode: Nearest = 1 "nearest", Conservative = 2 "conservative");
