//! Lengths and areas on a surface, tabulated over its parameters.

use super::super::{ParametricSurface, SurfaceJet};

/// Cells of the table along u and along v. They say where vertices go, so coarse cells cost evenness and nothing else.
const CELLS: usize = 256;

/// What a unit of u and of v is worth on the surface, by rows of equal v.
pub(super) struct Metric {
    /// Mean |∂u|, by row.
    length_u: Vec<f64>,
    /// Mean |∂v|, by row.
    length_v: Vec<f64>,
    /// Area along u, by row.
    area: Vec<Cumulative>,
    /// Mean length along v.
    pub(super) along_v: Cumulative,
}

impl Metric {
    pub(super) fn of(surface: &ParametricSurface) -> Self {
        let (mut length_u, mut length_v, mut area) = (vec![], vec![], vec![]);
        for v in middles() {
            let jets: Vec<SurfaceJet> = middles().map(|u| surface.jet(u, v)).collect();
            length_u.push(jets.iter().map(|jet| jet.du.length()).sum::<f64>() / CELLS as f64);
            length_v.push(jets.iter().map(|jet| jet.dv.length()).sum::<f64>() / CELLS as f64);
            area.push(Cumulative::of(jets.iter().map(SurfaceJet::area_density)));
        }
        let along_v = Cumulative::of(length_v.iter().copied());
        Self { length_u, length_v, area, along_v }
    }

    /// The area of the surface.
    pub(super) fn total_area(&self) -> f64 {
        self.area_along_v().total()
    }

    /// How wide the surface is across the direction of v, along u, at `v`.
    pub(super) fn width_at(&self, v: f64) -> f64 {
        let row = cell_of(v);
        self.area[row].total() / self.length_v[row]
    }

    /// The least mean length along u.
    pub(super) fn narrowest(&self) -> f64 {
        self.length_u.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// Area along u in the row at `v`.
    pub(super) fn area_along_row(&self, v: f64) -> &Cumulative {
        &self.area[cell_of(v)]
    }

    /// Area along v, row by row.
    pub(super) fn area_along_v(&self) -> Cumulative {
        Cumulative::of(self.area.iter().map(Cumulative::total))
    }

    /// The chart's coordinate along v, in units of the range of u: dv |∂v| / |∂u|.
    pub(super) fn conformal_v(&self) -> Cumulative {
        Cumulative::of(self.length_v.iter().zip(&self.length_u).map(|(v, u)| v / u))
    }
}

/// The middles of the cells.
fn middles() -> impl Iterator<Item = f64> {
    (0..CELLS).map(|cell| (cell as f64 + 0.5) / CELLS as f64)
}

/// The cell that a parameter from 0 to 1 lies in.
fn cell_of(parameter: f64) -> usize {
    ((parameter * CELLS as f64) as usize).min(CELLS - 1)
}

/// The integral over 0 … 1 of a positive function that is constant in each of a number of equal cells.
pub(super) struct Cumulative(Vec<f64>);

impl Cumulative {
    /// Of a function, by its values in the middles of the cells.
    pub(super) fn of_function(density: impl Fn(f64) -> f64) -> Self {
        Self::of(middles().map(density))
    }

    /// Of one value per cell.
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
