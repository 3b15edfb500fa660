//! What a bake would refuse of a plan before it has looked at a height or a vertex.

use std::path::Path;

use barchan_field::Grid;

use crate::directions::{refused_swept, sky_params};
use crate::error::refused;
use crate::{PipelineError, Plan, Recipe, Table, mesh_input, relief, search_params, source};

/// Refuses what [`crate::bake()`] would, with its words and in its order, as far as no input need be read for it. Gives the grid of
/// the heights where the recipe alone says it.
pub(crate) fn check(plan: &Plan, folder: &Path) -> Result<Option<Grid>, PipelineError> {
    plan.check()?;
    let recipe = &plan.recipe;
    let source = recipe.source.as_ref();
    let grid = source.map(|source| source::foresee(recipe, source, folder)).transpose()?.flatten();
    if let Some(mesh) = &recipe.mesh {
        mesh_input::foresee(mesh, folder)?;
    }
    if plan.looks_at_mesh() {
        recipe.curvature.params().check().map_err(|error| refused(Table::Curvature.name(), error))?;
    }
    if source.is_some() {
        check_relief(plan, grid.as_ref())?;
    }
    Ok(grid)
}

fn check_relief(plan: &Plan, known: Option<&Grid>) -> Result<(), PipelineError> {
    let grid = known.copied().unwrap_or_else(|| stand_in(&plan.recipe));
    search_params::check(plan, &grid, known.is_some())?;
    if !plan.needs_horizon() {
        return Ok(());
    }
    let mut horizon = relief::horizon_params(plan, &grid);
    // How far a bake would search depends on how wide the map is.
    if known.is_none() && plan.recipe.horizon.radius.is_none() {
        horizon.radius = grid.spacing.u().min(grid.spacing.v());
    }
    horizon.check_over(&grid).map_err(|error| refused(Table::Horizon.name(), error))?;
    // The curvatures of a mesh are cut to what can be swept.
    let range = plan.curvature().or(plan.sweeps_over_mesh().then_some((0.0, 0.0)));
    if let Some(swept) = plan.swept_params(range)? {
        swept.check(&grid, horizon.radius).map_err(refused_swept)?;
    }
    sky_params(plan).check(&horizon.azimuths).map_err(|error| refused(Table::Horizon.name(), error))
}

/// The least that has a horizon, in place of a height map that nobody has read: what is refused of it is refused of any.
fn stand_in(recipe: &Recipe) -> Grid {
    Grid { width: 2, height: 1, spacing: recipe.spacing, unit: recipe.height_unit(), edge: recipe.edge }
}
