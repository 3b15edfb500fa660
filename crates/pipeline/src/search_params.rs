//! The hemisphere table that a plan asks for, in the baker's words.

use barchan_asset::{Azimuths, HemisphereDirections};
use barchan_bakers::BakeError;
use barchan_bakers::hemisphere::HemisphereParams;
use barchan_field::Grid;

use crate::error::refused;
use crate::{PipelineError, Plan, ReliefMapping, Table};

/// Refuses what no hemisphere table can be, before anything is baked: over a grid, or as far as it goes where there is only a
/// stand-in for it.
pub(crate) fn check(plan: &Plan, grid: &Grid, is_known: bool) -> Result<(), PipelineError> {
    if !plan.bakes(Table::Hemisphere) {
        return Ok(());
    }
    let params = hemisphere_params(plan, grid)?;
    params.check_over(is_known.then_some(grid)).map_err(refused_hemisphere)
}

/// Rings and azimuths are as many as the recipe says, and cover what the scene says that eyes and lights can stand in: those that
/// stay above 20° need no rings below.
pub(crate) fn hemisphere_params(plan: &Plan, grid: &Grid) -> Result<HemisphereParams, PipelineError> {
    let hemisphere = &plan.recipe.hemisphere;
    let ReliefMapping { least_elevation_degrees, arc, .. } = plan.relief_mapping();
    if !(least_elevation_degrees > 0.0 && least_elevation_degrees < 90.0) {
        let (name, value) = ("least_elevation_degrees", least_elevation_degrees.to_string());
        let accepted = "more than 0 and less than 90 degrees are accepted";
        return Err(refused(SCENE, BakeError::Parameter { name, value, accepted }));
    }
    let azimuths = match arc {
        None => Azimuths::full_circle(hemisphere.azimuths),
        Some((first, last)) => Azimuths::arc(first.to_radians(), last.to_radians(), hemisphere.azimuths),
    };
    let directions = HemisphereDirections {
        rings: hemisphere.rings,
        azimuths,
        spacing: hemisphere.spacing.into(),
        max_polar_radians: (90.0 - least_elevation_degrees).to_radians(),
    };
    let (width, height) = hemisphere.size_for(grid.width, grid.height);
    Ok(HemisphereParams { directions, width, height, mode: hemisphere.mode.into() })
}

/// Where the scene says which directions there are.
const SCENE: &str = "scene.relief_mapping";

/// A refusal of the baker, under the field of the recipe that it is about.
pub(crate) fn refused_hemisphere(error: BakeError) -> PipelineError {
    match error {
        BakeError::Parameter { name: "arc", .. } => refused(SCENE, error),
        error => refused(Table::Hemisphere.name(), error),
    }
}
