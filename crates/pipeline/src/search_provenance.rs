//! What an asset says of how its tables for relief search were baked, and of how good they are.

use barchan_bakers::cone::ConeKind;
use barchan_bakers::hemisphere::HemisphereParams;
use barchan_bakers::maximum_mip;
use serde::{Deserialize, Serialize};

use crate::start_accuracy::StartAccuracy;
use crate::{HemisphereMode, HemisphereSpacing, Plan, Recipe, Table};

/// The bakers of tables for relief search that ran.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ReliefSearchProvenance {
    /// The baker of hemisphere depths.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hemisphere: Option<HemisphereProvenance>,
    /// The baker of cone maps; changes when the same input gives other bytes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cone_map: Option<String>,
    /// The baker of relaxed cone maps; changes when the same input gives other bytes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub relaxed_cone_map: Option<String>,
    /// The baker of maximum mips; changes when the same input gives other bytes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub maximum_mip: Option<String>,
}

impl ReliefSearchProvenance {
    pub(crate) fn new(hemisphere: Option<HemisphereProvenance>, plan: &Plan) -> Self {
        let ran = |table, algorithm: &str| plan.bakes(table).then(|| algorithm.to_owned());
        Self {
            hemisphere,
            cone_map: ran(Table::ConeMap, ConeKind::Strict.algorithm()),
            relaxed_cone_map: ran(Table::RelaxedConeMap, ConeKind::Relaxed.algorithm()),
            maximum_mip: ran(Table::MaximumMip, maximum_mip::ALGORITHM),
        }
    }
}

/// What baked the hemisphere depths, with what, and how near to the surface they are.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct HemisphereProvenance {
    /// Changes when the same input gives other bytes.
    pub algorithm: String,
    /// What a depth says of the rays of its cell.
    pub mode: HemisphereMode,
    /// Rings around the normal.
    pub rings: u32,
    /// Azimuths of each ring.
    pub azimuths: u32,
    /// How the polar angle is cut into rings.
    pub spacing: HemisphereSpacing,
    /// Where the last ring ends, in degrees from the normal.
    pub max_polar_degrees: f64,
    /// The first and the last azimuth in degrees; `None` all the way round.
    pub arc: Option<(f64, f64)>,
    /// Texels along u and v.
    pub size: (u32, u32),
    /// Measured on rays.
    pub accuracy: StartAccuracy,
}

impl HemisphereProvenance {
    pub(crate) fn new(plan: &Plan, params: &HemisphereParams, accuracy: StartAccuracy) -> Self {
        let (Recipe { hemisphere, .. }, mapping) = (&plan.recipe, plan.relief_mapping());
        Self {
            algorithm: params.algorithm().to_owned(),
            mode: hemisphere.mode,
            rings: hemisphere.rings,
            azimuths: hemisphere.azimuths,
            spacing: hemisphere.spacing,
            max_polar_degrees: 90.0 - mapping.least_elevation_degrees,
            arc: mapping.arc,
            size: (params.width, params.height),
            accuracy,
        }
    }
}
