//! What to bake. Every field changes the bytes of the table.

use std::f64::consts::{FRAC_PI_2, TAU};

use barchan_asset::{Azimuths, DepthMode, HemisphereDirections, MAX_LAYERS};
use barchan_field::{Grid, HeightField};

use crate::BakeError;

/// Directions, size and promise of a table of hemisphere depths.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HemisphereParams {
    /// The cells of directions: at most [`MAX_LAYERS`], none of them at the horizontal.
    pub directions: HemisphereDirections,
    /// Texels of the table along u: 1 to those of the field.
    pub width: u32,
    /// Texels of the table along v: 1 to those of the field.
    pub height: u32,
    /// What a stored depth promises.
    pub mode: DepthMode,
}

impl HemisphereParams {
    /// Refuses directions that no table can hold and a target that the field cannot fill.
    pub fn check(&self, field: &HeightField) -> Result<(), BakeError> {
        self.check_over(Some(field.grid()))
    }

    /// [`Self::check`] without heights: over their grid, or as far as it goes where that is not known.
    ///
    /// # Errors
    /// The parameter, its value, and what would be accepted.
    pub fn check_over(&self, grid: Option<&Grid>) -> Result<(), BakeError> {
        check_directions(&self.directions)?;
        self.check_size(grid)
    }

    /// Names the algorithm in provenance. It changes when a bake's bytes do.
    #[must_use]
    pub fn algorithm(&self) -> &'static str {
        match self.mode {
            DepthMode::Nearest => "hemisphere-nearest-1",
            _ => "hemisphere-conservative-1",
        }
    }

    /// Values of one layer.
    pub(crate) fn texels(&self) -> usize {
        self.width as usize * self.height as usize
    }

    fn check_size(&self, grid: Option<&Grid>) -> Result<(), BakeError> {
        let Self { width, height, .. } = *self;
        let refuse = |value, accepted| Err(BakeError::Parameter { name: "size", value, accepted });
        if width == 0 || height == 0 {
            return refuse(format!("{width} × {height}"), "at least 1 texel along each side is accepted");
        }
        match grid {
            Some(grid) if width > grid.width || height > grid.height => refuse(
                format!("{width} × {height} for a height map of {} × {}", grid.width, grid.height),
                "no more texels along a side than the height map has are accepted",
            ),
            _ => Ok(()),
        }
    }
}

fn check_directions(directions: &HemisphereDirections) -> Result<(), BakeError> {
    let refuse = |name, value: String, accepted| Err(BakeError::Parameter { name, value, accepted });
    let HemisphereDirections { rings, azimuths, max_polar_radians, .. } = *directions;
    if rings == 0 {
        return refuse("rings", rings.to_string(), "1 or more are accepted");
    }
    check_azimuths(&azimuths)?;
    let layers = u64::from(rings) * u64::from(azimuths.count());
    if layers > u64::from(MAX_LAYERS) {
        let value = format!("{rings} × {}", azimuths.count());
        return refuse("rings × azimuths", value, "at most 2048 directions are accepted");
    }
    if !(max_polar_radians > 0.0 && max_polar_radians < FRAC_PI_2) {
        let value = format!("{}°", max_polar_radians.to_degrees());
        return refuse("max_polar", value, "more than 0° and less than 90° from the normal are accepted");
    }
    Ok(())
}

fn check_azimuths(azimuths: &Azimuths) -> Result<(), BakeError> {
    let refuse = |name, value: String, accepted| Err(BakeError::Parameter { name, value, accepted });
    let (first, step, count) = (azimuths.first_radians(), azimuths.step_radians(), azimuths.count());
    if count == 0 {
        return refuse(
            "azimuths",
            count.to_string(),
            "1 or more around the circle, or 2 or more in an arc, are accepted",
        );
    }
    if azimuths.is_full_circle() {
        return Ok(());
    }
    if count == 1 {
        return refuse("azimuths", count.to_string(), "2 or more are accepted in an arc, which bakes both its ends");
    }
    let last = azimuths.radians(count - 1);
    if first.abs() <= TAU && step > 0.0 && last - first < TAU {
        return Ok(());
    }
    let value = format!("{} to {}", first.to_degrees(), last.to_degrees());
    refuse("arc", value, "degrees from within ±360 to a larger number, less than 360 beyond, are accepted")
}
