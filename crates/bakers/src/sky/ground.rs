//! The ground a texel stands on: the slopes of the surface, by central differences.

use std::ops::Range;

use barchan_field::HeightField;

/// Texels that a kernel works on at once: what it keeps of them stays in the nearest cache.
pub(crate) const BLOCK: usize = 256;

/// Beyond it a slope counts as this: its square still fits f32, and its plane is a wall to the last bit.
const STEEPEST: f32 = 1e18;

/// The slopes of a field, in the precision and order of operations that the whole bake shares.
#[derive(Clone, Copy)]
pub(crate) struct Ground<'a> {
    field: &'a HeightField,
    texels_per_u: f32,
    texels_per_v: f32,
}

/// ∂h/∂u and ∂h/∂v of consecutive texels of a row.
pub(crate) struct Slopes {
    pub(crate) u: [f32; BLOCK],
    pub(crate) v: [f32; BLOCK],
}

impl Slopes {
    pub(crate) const LEVEL: Self = Self { u: [0.0; BLOCK], v: [0.0; BLOCK] };
}

impl<'a> Ground<'a> {
    pub(crate) fn new(field: &'a HeightField) -> Self {
        let spacing = field.grid().spacing;
        Self { field, texels_per_u: (1.0 / spacing.u()) as f32, texels_per_v: (1.0 / spacing.v()) as f32 }
    }

    pub(crate) fn width(&self) -> usize {
        self.field.grid().width as usize
    }

    /// The slopes of at most [`BLOCK`] texels of a row; `slopes` beyond them is left as it is.
    #[inline(always)]
    pub(crate) fn slopes(&self, row: usize, columns: Range<usize>, slopes: &mut Slopes) {
        let len = columns.len();
        let mut neighbours = [0.0; BLOCK + 2];
        self.copy_with_neighbours(row, columns.clone(), &mut neighbours);
        let (west, east) = (&neighbours[..len], &neighbours[2..][..len]);
        central_differences(east, west, self.texels_per_u, &mut slopes.u[..len]);
        // v points up the picture, towards the row before.
        let (north, south) = (self.row(row as i64 - 1), self.row(row as i64 + 1));
        central_differences(&north[columns.clone()], &south[columns], self.texels_per_v, &mut slopes.v[..len]);
    }

    /// The heights of a row's texels, with the one before the first and the one after the last.
    #[inline(always)]
    fn copy_with_neighbours(&self, row: usize, columns: Range<usize>, to: &mut [f32; BLOCK + 2]) {
        let len = columns.len();
        to[0] = self.field.texel(columns.start as i64 - 1, row as i64);
        to[len + 1] = self.field.texel(columns.end as i64, row as i64);
        to[1..=len].copy_from_slice(&self.row(row as i64)[columns]);
    }

    #[inline(always)]
    fn row(&self, row: i64) -> &'a [f32] {
        let grid = self.field.grid();
        &self.field.samples()[grid.edge.resolve(row, grid.height) * self.width()..][..self.width()]
    }
}

/// Halved before they are subtracted, so that the ends of f32 do not overflow.
#[inline(always)]
fn central_differences(ahead: &[f32], behind: &[f32], texels_per_length: f32, slopes: &mut [f32]) {
    for ((slope, ahead), behind) in slopes.iter_mut().zip(ahead).zip(behind) {
        let raw = (0.5 * ahead - 0.5 * behind) * texels_per_length;
        let bounded = if raw < STEEPEST { raw } else { STEEPEST };
        *slope = if bounded > -STEEPEST { bounded } else { -STEEPEST };
    }
}

/// The unit normal of a surface with these slopes, in (u, v, height).
pub(crate) fn normal(slope_u: f64, slope_v: f64) -> [f64; 3] {
    let up = 1.0 / (1.0 + slope_u * slope_u + slope_v * slope_v).sqrt();
    [-slope_u * up, -slope_v * up, up]
}

#[cfg(test)]
mod tests {
    use barchan_field::{Edge, Grid, LengthUnit, Spacing};

    use super::*;

    fn slopes_of((width, height): (u32, u32), edge: Edge, samples: Vec<f32>) -> Slopes {
        let spacing = Spacing::new(0.5, 2.0).unwrap();
        let grid = Grid { width, height, spacing, unit: LengthUnit::SceneUnit, edge };
        let field = HeightField::new(grid, samples).unwrap();
        let mut slopes = Slopes::LEVEL;
        Ground::new(&field).slopes(0, 0..width as usize, &mut slopes);
        slopes
    }

    #[test]
    fn differences_count_lengths_and_v_points_up() {
        let slopes = slopes_of((3, 2), Edge::Clamp, vec![0.0, 1.0, 4.0, 8.0, 8.0, 8.0]);
        assert_eq!(slopes.u[..3], [1.0, 4.0, 3.0]);
        assert_eq!(slopes.v[..3], [-2.0, -1.75, -1.0]);
    }

    #[test]
    fn a_wrapped_row_goes_on_at_its_other_end() {
        let slopes = slopes_of((4, 1), Edge::Wrap, vec![0.0, 1.0, 4.0, 9.0]);
        assert_eq!(slopes.u[..4], [-8.0, 4.0, 8.0, -4.0]);
        assert_eq!(slopes.v[..4], [0.0; 4]);
    }

    #[test]
    fn the_ends_of_f32_stay_finite() {
        let slopes = slopes_of((3, 1), Edge::Clamp, vec![f32::MIN, 0.0, f32::MAX]);
        assert_eq!(slopes.u[..3], [STEEPEST; 3]);
        let [u, v, up] = normal(f64::from(STEEPEST), f64::from(-STEEPEST));
        assert!((u * u + v * v + up * up - 1.0).abs() < 1e-15 && up > 0.0);
    }
}
