//! The typed table a bake of a cone map returns, before any encoding.

use barchan_asset::ReliefRange;
use barchan_field::Grid;

/// What a cone promises.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ConeKind {
    /// Nothing of the relief is inside the cone: a step to its side never crosses the surface.
    Strict,
    /// Of the rays that come from the top above the texel, none leaves the relief inside the cone: a step to its side
    /// may end in the relief, from where a bisection leads back.
    Relaxed,
}

impl ConeKind {
    /// Names the algorithm in provenance. It changes when a bake's bytes do.
    #[must_use]
    pub fn algorithm(self) -> &'static str {
        match self {
            Self::Strict => "cone-map-1",
            Self::Relaxed => "relaxed-cone-map-1",
        }
    }
}

/// The depth of every texel and the cone above it.
#[derive(Debug, Clone, PartialEq)]
pub struct ConeMap {
    /// The grid of the field it was baked from.
    pub grid: Grid,
    /// What depths are measured in.
    pub relief: ReliefRange,
    /// Two numbers a texel, row by row from the top of the picture: the depth, 0..1, and the ratio of the cone, its
    /// horizontal length to its length in height, at least 0 and finite.
    pub values: Vec<f32>,
}

impl ConeMap {
    /// The depth of a texel, 0..1, rounded down.
    #[must_use]
    pub fn depth(&self, column: u32, row: u32) -> f32 {
        self.values[2 * self.texel(column, row)]
    }

    /// The ratio of the cone of a texel: the tangent of its half-angle, a pure number, rounded down.
    #[must_use]
    pub fn ratio(&self, column: u32, row: u32) -> f32 {
        self.values[2 * self.texel(column, row) + 1]
    }

    fn texel(&self, column: u32, row: u32) -> usize {
        row as usize * self.grid.width as usize + column as usize
    }
}
