//! What to bake. Every field changes the bytes of the table.

use barchan_field::{Edge, Grid, HeightField};

use crate::BakeError;

/// The most azimuths a map may have: as many as a file can hold.
pub const MAX_DIRECTIONS: u32 = barchan_asset::MAX_LAYERS;

/// The farthest a ray may go, in texels of the finer axis: enough to cross a 16k tile eight times.
pub const MAX_RADIUS_TEXELS: f64 = (1 << 17) as f64;

/// Azimuths and search radius of a horizon map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HorizonParams {
    /// Azimuths, evenly spaced, the first along +u, counter-clockwise: 1 to [`MAX_DIRECTIONS`].
    pub directions: u32,
    /// How far a ray looks, in the field's length unit, measured along the base plane. Positive.
    pub radius: f64,
    /// Whether the distance to the horizon point is kept. Only curved surfaces and soft shadows ask for it.
    pub distance: bool,
}

impl HorizonParams {
    /// The radius taken when none is asked for: the diagonal of a clamped field, from which everything is seen; one
    /// longer side of a tile that wraps, after which it repeats.
    #[must_use]
    pub fn default_radius(grid: &Grid) -> f64 {
        match grid.edge {
            Edge::Clamp => grid.diagonal(),
            Edge::Wrap => grid.extent_u().max(grid.extent_v()),
        }
    }

    /// Refuses parameters out of range and a field without relief to look at.
    pub fn check(&self, field: &HeightField) -> Result<(), BakeError> {
        let grid = field.grid();
        if grid.texels() < 2 {
            return Err(BakeError::Field {
                width: grid.width,
                height: grid.height,
                needed: "a horizon needs at least 2 texels",
            });
        }
        if !(1..=MAX_DIRECTIONS).contains(&self.directions) {
            return Err(BakeError::Parameter {
                name: "directions",
                value: self.directions.to_string(),
                accepted: "1 to 2048 azimuths are accepted",
            });
        }
        self.check_radius(grid)
    }

    fn check_radius(&self, grid: &Grid) -> Result<(), BakeError> {
        let texel = grid.spacing.u().min(grid.spacing.v());
        if self.radius > 0.0 && self.radius / texel <= MAX_RADIUS_TEXELS {
            return Ok(());
        }
        Err(BakeError::Parameter {
            name: "radius",
            value: self.radius.to_string(),
            accepted: "a positive length of at most 131072 texels is accepted",
        })
    }
}
