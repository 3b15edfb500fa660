//! What to bake. Every field changes the bytes of the table.

use crate::BakeError;

/// How curvature is found.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum CurvatureMethod {
    /// For previews: a cubic fit to the nearest neighbours.
    Fast,
    /// Degree and neighbourhood chosen by the data.
    #[default]
    Accurate,
}

impl CurvatureMethod {
    /// Every method, fastest first.
    pub const ALL: [Self; 2] = [Self::Fast, Self::Accurate];

    /// Its name in recipes, on the command line and in provenance.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Fast => "fast",
            Self::Accurate => "accurate",
        }
    }
}

/// Method and hard edges.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvatureParams {
    /// How exactly, at what speed.
    pub method: CurvatureMethod,
    /// Where the normals that a mesh states for the two sides of an edge differ by more, the surface is not smooth across it:
    /// each side sees its own. Degrees, 0 to 180; a mesh without normals has no hard edges.
    pub hard_edge_degrees: f64,
}

impl Default for CurvatureParams {
    fn default() -> Self {
        Self { method: CurvatureMethod::default(), hard_edge_degrees: 30.0 }
    }
}

impl CurvatureParams {
    /// Refuses what is out of range.
    ///
    /// # Errors
    /// The parameter, its value, and what would be accepted.
    pub fn check(&self) -> Result<(), BakeError> {
        if (0.0..=180.0).contains(&self.hard_edge_degrees) {
            return Ok(());
        }
        Err(BakeError::Parameter {
            name: "hard_edge_degrees",
            value: self.hard_edge_degrees.to_string(),
            accepted: "an angle from 0 to 180 is accepted",
        })
    }
}
