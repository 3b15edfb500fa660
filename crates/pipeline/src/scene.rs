//! What a recipe says of the scene, by which tables are chosen.

use serde::{Deserialize, Serialize};

use crate::pair;

/// What a scene does with the tables. What it does not need is left out.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Scene {
    /// The relief lies on curved surfaces, whose horizons are corrected with the distance.
    pub curved_surfaces: bool,
    /// The least and the greatest curvature of those surfaces, in 1 / length unit, positive where convex: horizons are
    /// to be right over all of that range. Says that there are curved surfaces.
    #[serde(deserialize_with = "pair::optional")]
    pub curvature: Option<(f64, f64)>,
    /// Penumbrae are sized by the distance.
    pub soft_shadows: bool,
    /// Light of the sky is dimmed and turned by what hides the sky.
    pub ambient_light: bool,
    /// Lights of some extent, or blurred reflections, are cut by the cone of the visible sky.
    pub area_lights: bool,
    /// Eye or light rays are followed to where they hit the relief.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub relief_mapping: Option<ReliefMapping>,
}

impl Scene {
    /// Whether there are curved surfaces, said in either way.
    #[must_use]
    pub fn is_curved(&self) -> bool {
        self.curved_surfaces || self.curvature.is_some()
    }
}

/// How rays are followed to where they hit the relief, and from where they come.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct ReliefMapping {
    /// No eye and no light stands lower above the relief's plane, in degrees, more than 0 and less than 90. Lower rays are searched
    /// from the top.
    pub least_elevation_degrees: f64,
    /// The first and the last azimuth in degrees, counter-clockwise from +u, where eyes and lights never stand elsewhere; `None`
    /// goes all the way round.
    #[serde(deserialize_with = "pair::optional")]
    pub arc: Option<(f64, f64)>,
    /// What finds the hit.
    pub search: ReliefSearch,
}

impl ReliefMapping {
    /// Where nobody says how low eyes and lights stand, in degrees.
    pub const DEFAULT_LEAST_ELEVATION_DEGREES: f64 = 10.0;
}

impl Default for ReliefMapping {
    fn default() -> Self {
        Self {
            least_elevation_degrees: Self::DEFAULT_LEAST_ELEVATION_DEGREES,
            arc: None,
            search: ReliefSearch::default(),
        }
    }
}

/// What finds the hit of a ray from a start on; each has the table that it needs.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ReliefSearch {
    /// Squares of the map, large where the ray is above all of their relief: exact, and baked in no time.
    #[default]
    MaximumMip,
    /// Steps as long as a cone above the surface allows, and the exact hit at their end.
    ConeSteps,
    /// Longer steps, which may pass the surface once, and a bisection.
    RelaxedConeSteps,
    /// Steps of one length and a bisection.
    Linear,
}
