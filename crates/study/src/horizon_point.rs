//! The point that a map names as a texel's horizon, looked up on the surface.

use barchan_field::HeightField;

/// Where the slope's limit at the texel itself is taken, in texels: the surface bends too little to matter so near.
const LIMIT_TEXELS: f64 = 1e-6;

/// A texel and the way it looks.
#[derive(Debug, Clone, Copy)]
pub(crate) struct View<'a> {
    pub(crate) field: &'a HeightField,
    /// Cosine and sine of the azimuth.
    pub(crate) towards: (f64, f64),
    pub(crate) column: u32,
    pub(crate) row: u32,
}

impl View<'_> {
    /// The elevation, in degrees, at which the texel sees the surface at a distance; at 0, the limit.
    pub(crate) fn elevation_degrees(&self, distance: f64) -> f64 {
        let spacing = self.field.grid().spacing;
        let distance = distance.max(LIMIT_TEXELS * spacing.u().min(spacing.v()));
        let (x, y) = (f64::from(self.column), f64::from(self.row));
        // v points up the picture, rows are counted downwards.
        let (along_x, along_y) = (self.towards.0 / spacing.u(), -self.towards.1 / spacing.v());
        let rise = self.field.surface(x + distance * along_x, y + distance * along_y) - self.field.surface(x, y);
        libm::atan(rise / distance).to_degrees()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenes;

    #[test]
    fn a_plane_is_seen_under_its_own_slope_at_any_distance() {
        let field = scenes::by_name("plane", 64).unwrap().field;
        // Slopes ¼ along u and −⅛ along v; the map is clamped, so looking from the middle stays on it.
        for (towards, slope) in [((1.0, 0.0), 0.25), ((0.0, 1.0), -0.125), ((-1.0, 0.0), -0.25)] {
            let view = View { field: &field, towards, column: 32, row: 32 };
            for distance in [0.0, 1.0, 50.0] {
                assert!((view.elevation_degrees(distance) - libm::atan(slope).to_degrees()).abs() < 1e-3);
            }
        }
    }
}
