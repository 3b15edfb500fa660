//! Lengths and areas on a surface, tabulated over its parameters.

use super::super::ParametricSurface;

/// Cells of the table along u and along v: sixteen to each half-wave of the shortest waves a sheet may have would need eight times as
/// many, but then the cells only spread vertices; they do not place them off the surface.
const CELLS: usize = 256;

/// What a unit of u and of v is worth on the surface, by rows of equal v.
pub(super) struct Metric {
    /// Mean |∂u|, by row.
    pub(super) length_u: Vec<f64>,
    /// Mean |∂v|, by row.
    length_v: Vec<f64>,
    /// Mean |∂u × ∂v|, by row.
    area: Vec<f64>,
    /// Row by row, |∂u × ∂v| in the middle of each cell.
    density: Vec<f64>,
    /// Mean length along v.
    pub(super) along_v: Cumulative,
}

impl Metric {
    pub(super) fn of(surface: &ParametricSurface) -> Self {
        let middle = |cell: usize| (cell as f64 + 0.5) / CELLS as f64;
        let (mut length_u, mut length_v, mut area, mut density) = (vec![], vec![], vec![], vec![]);
        for row in 0..CELLS {
            let mut sums = [0.0; 3];
            for column in 0..CELLS {
                let jet = surface.jet(middle(column), middle(row));
                let values = [jet.du.length(), jet.dv.length(), jet.area_density()];
                for (sum, value) in sums.iter_mut().zip(values) {
                    *sum += value / CELLS as f64;
                }
                density.push(values[2]);
            }
            length_u.push(sums[0]);
            length_v.push(sums[1]);
            area.push(sums[2]);
        }
        let along_v = Cumulative::of(length_v.iter().copied());
        Self { length_u, length_v, area, density, along_v }
    }

    /// The area of the surface.
    pub(super) fn total_area(&self) -> f64 {
        self.area.iter().sum::<f64>() / CELLS as f64
    }

    /// How wide the surface is across the direction of v, along u, at `v`.
    pub(super) fn width_at(&self, v: f64) -> f64 {
        let row = cell_of(v);
        self.area[row] / self.length_v[row]
    }

    /// Area along u in the row at `v`.
    pub(super) fn area_along_row(&self, v: f64) -> Cumulative {
        let first = cell_of(v) * CELLS;
        Cumulative::of(self.density[first..first + CELLS].iter().copied())
    }

    /// Area along v, row by row.
    pub(super) fn area_along_v(&self) -> Cumulative {
        Cumulative::of(self.area.iter().copied())
    }

    /// The chart's coordinate along v, in units of the range of u: dv |∂v| / |∂u|.
    pub(super) fn conformal_v(&self) -> Cumulative {
        Cumulative::of(self.length_v.iter().zip(&self.length_u).map(|(v, u)| v / u))
    }

    /// Length along the border at `v`, or at `u` where `v` is none.
    pub(super) fn border(length: impl Fn(f64) -> f64) -> Cumulative {
        Cumulative::of((0..CELLS).map(|cell| length((cell as f64 + 0.5) / CELLS as f64)))
    }
}

/// The cell that a parameter from 0 to 1 lies in.
fn cell_of(parameter: f64) -> usize {
    ((parameter * CELLS as f64) as usize).min(CELLS - 1)
}

/// The integral over 0 … 1 of a positive function that is constant in each of a number of equal cells.
pub(super) struct Cumulative(Vec<f64>);

impl Cumulative {
    fn of(densities: impl Iterator<Item = f64>) -> Self {
        let mut sum = 0.0;
        let mut nodes = vec![0.0];
        nodes.extend(densities.map(|density| {
            sum += density / CELLS as f64;
            sum
        }));
        Self(nodes)
    }

    /// The integral from 0 to 1.
    pub(super) fn total(&self) -> f64 {
        self.0[CELLS]
    }

    /// The integral from 0 to `x`, 0 … 1.
    pub(super) fn at(&self, x: f64) -> f64 {
        let cell = cell_of(x);
        let (low, high) = (self.0[cell], self.0[cell + 1]);
        low + (high - low) * (x * CELLS as f64 - cell as f64)
    }

    /// Where the integral reaches a `fraction`, 0 … 1, of the total.
    pub(super) fn inverse(&self, fraction: f64) -> f64 {
        let target = fraction * self.total();
        let cell = self.0.partition_point(|&node| node <= target).clamp(1, CELLS) - 1;
        let (low, high) = (self.0[cell], self.0[cell + 1]);
        let within = ((target - low) / (high - low)).clamp(0.0, 1.0);
        (cell as f64 + within) / CELLS as f64
    }
}
