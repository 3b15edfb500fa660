//! What to bake. Every field changes the bytes of the table.

use barchan_field::{Edge, Grid, HeightField};

use super::Azimuths;
use crate::BakeError;

/// The most azimuths a map may have: as many as a file can hold.
pub const MAX_DIRECTIONS: u32 = barchan_asset::MAX_LAYERS;

/// The farthest a ray may go, in texels of the finer axis: enough to cross a 16k tile eight times.
pub const MAX_RADIUS_TEXELS: f64 = (1 << 17) as f64;

/// How a horizon map is baked: each method is a trade of exactness for speed, which `cargo xtask bench` measures.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum Method {
    /// For previews: the fastest.
    Sweep,
    /// The default: what the eye cannot tell from exact.
    #[default]
    Accurate,
    /// Equal to the [`reference`](mod@super::reference) but for the rounding of f32.
    Exact,
}

impl Method {
    /// Every method, fastest first.
    pub const ALL: [Self; 3] = [Self::Sweep, Self::Accurate, Self::Exact];

    /// Its name in recipes, on the command line and in provenance.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Sweep => "sweep",
            Self::Accurate => "accurate",
            Self::Exact => "exact",
        }
    }
}

/// Azimuths, search radius and method of a horizon map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HorizonParams {
    /// The azimuths: 1 to [`MAX_DIRECTIONS`].
    pub azimuths: Azimuths,
    /// How far a ray looks, in the field's length unit, measured along the base plane. Positive.
    pub radius: f64,
    /// Whether the distance to the horizon point is kept. Only curved surfaces and soft shadows ask for it.
    pub distance: bool,
    /// How exactly, at what speed.
    pub method: Method,
}

impl HorizonParams {
    /// How many azimuths.
    #[must_use]
    pub fn directions(&self) -> u32 {
        self.azimuths.count()
    }

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
        self.check_over(field.grid())
    }

    /// [`Self::check`] without heights: their grid is enough.
    ///
    /// # Errors
    /// The parameter, its value, and what would be accepted.
    pub fn check_over(&self, grid: &Grid) -> Result<(), BakeError> {
        if grid.texels() < 2 {
            return Err(BakeError::Field {
                width: grid.width,
                height: grid.height,
                needed: "a horizon needs at least 2 texels",
            });
        }
        self.azimuths.check()?;
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
