//! Forms as a run time has them: known at the vertices of triangles, interpolated between.

use barchan_shade::FundamentalForms;
use glam::DVec2;

/// Forms at the corners of a grid of cells over u and v from 0 to 1, each cut into two triangles from its lower left to its
/// upper right.
pub struct TriangleForms {
    cells: u32,
    /// `(cells + 1)²`, row by row from v = 0.
    corners: Vec<FundamentalForms>,
}

impl TriangleForms {
    /// Over so many cells each way, at least 1.
    #[must_use]
    pub fn new(cells: u32, forms: impl Fn(DVec2) -> FundamentalForms) -> Self {
        let part = |index: u32| f64::from(index) / f64::from(cells);
        let row = |row: u32| (0..=cells).map(move |column| DVec2::new(part(column), part(row)));
        let corners = (0..=cells).flat_map(row).map(forms).collect();
        Self { cells, corners }
    }

    /// At (u, v); beyond the grid as its outermost triangles go on.
    #[must_use]
    pub fn at(&self, uv: DVec2) -> FundamentalForms {
        let cell = |part: f64| (part * f64::from(self.cells)).floor().clamp(0.0, f64::from(self.cells - 1));
        let (column, row) = (cell(uv.x), cell(uv.y));
        let (x, y) = (uv.x * f64::from(self.cells) - column, uv.y * f64::from(self.cells) - row);
        let corner = |right: u32, up: u32| {
            &self.corners[((row as u32 + up) * (self.cells + 1) + column as u32 + right) as usize]
        };
        let (third, weights) =
            if x >= y { (corner(1, 0), [1.0 - x, x - y, y]) } else { (corner(0, 1), [1.0 - y, y - x, x]) };
        FundamentalForms::interpolated([corner(0, 0), third, corner(1, 1)], weights)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_linear_is_kept_everywhere() {
        let linear = |uv: DVec2| FundamentalForms {
            first: [1.0 + uv.x, uv.y, 2.0 - uv.x + uv.y],
            second: [uv.x - uv.y, 3.0 * uv.y, 0.5],
        };
        let triangles = TriangleForms::new(3, linear);
        for uv in [(0.0, 0.0), (1.0, 1.0), (0.4, 0.3), (0.3, 0.4), (0.99, 0.01), (1.02, 0.5)] {
            let (found, expected) = (triangles.at(uv.into()), linear(uv.into()));
            let pairs = found.first.iter().zip(expected.first).chain(found.second.iter().zip(expected.second));
            pairs.for_each(|(found, expected)| assert!((found - expected).abs() < 1e-12, "{uv:?}"));
        }
    }
}
