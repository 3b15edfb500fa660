//! The tables of relief: heights, and what is found around every texel.

use std::io::{Read, Seek, Write};

use barchan_asset::HeightTable;
use barchan_bakers::Exec;
use barchan_bakers::horizon::HorizonParams;
use barchan_field::{Grid, HeightField};

use crate::directions::{self, Task};
use crate::layout::table_grid;
use crate::provenance::{HorizonProvenance, SweptProvenance};
use crate::search_provenance::ReliefSearchProvenance;
use crate::sink::Sink;
use crate::swept_range::MeshRange;
use crate::{PipelineError, Plan, Run, Table, relief_search, search_params};

/// What is known once the tables of relief are in the file.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct ReliefDone {
    /// `None` where no horizon was looked for.
    pub(crate) horizon: Option<HorizonProvenance>,
    /// `None` where nothing was swept.
    pub(crate) swept: Option<SweptProvenance>,
    /// `None` where nothing was baked for relief search.
    pub(crate) search: Option<ReliefSearchProvenance>,
}

/// Bakes and writes every table that comes from heights. `on_mesh` is the range of curvatures of a mesh that they lie on.
pub(crate) fn bake<W: Read + Write + Seek>(
    plan: &Plan,
    field: &HeightField,
    on_mesh: Option<(f64, f64)>,
    (run, exec): (&Run<'_>, &Exec<'_>),
    sink: &mut Sink<'_, W>,
) -> Result<ReliefDone, PipelineError> {
    // What takes long comes in between.
    search_params::check(plan, field.grid(), true)?;
    let stored = store_heights(plan, field, sink)?;
    let mut done = ReliefDone::default();
    if plan.needs_horizon() {
        let params = horizon_params(plan, field.grid());
        let on_mesh = on_mesh.map(|range| MeshRange::new(range, field.grid(), params.radius));
        let curvature = plan.curvature().or(on_mesh.as_ref().map(|range| range.swept));
        let directions = directions::bake(Task { plan, field, params: &params, curvature, exec }, sink)?;
        done.horizon = Some(HorizonProvenance::new(&plan.recipe.horizon, &params, directions.accuracy));
        done.swept = directions.points.map(|points| SweptProvenance::new(points, on_mesh));
    }
    if let Some(surface) = stored {
        done.search = Some(relief_search::bake(plan, &surface, run, exec, sink)?);
    }
    Ok(done)
}

/// Writes the heights, if they are wanted, and returns them as a reader will decode them, if rays are to be followed to them.
fn store_heights<W: Read + Write + Seek>(
    plan: &Plan,
    field: &HeightField,
    sink: &mut Sink<'_, W>,
) -> Result<Option<HeightField>, PipelineError> {
    let (is_baked, is_searched) = (plan.bakes(Table::Height), plan.serves_relief_search());
    if !is_baked && !is_searched {
        return Ok(None);
    }
    let table = HeightTable { grid: table_grid(field.grid()), values: field.samples() };
    let encoded = sink.encode(Table::Height, || table.encode(plan.encoding(Table::Height)))?;
    if is_baked {
        sink.encoded(Table::Height, &encoded)?;
    }
    is_searched.then(|| relief_search::as_stored(field, &encoded)).transpose()
}

/// The horizon that a plan asks for over a grid, in the baker's words.
pub(crate) fn horizon_params(plan: &Plan, grid: &Grid) -> HorizonParams {
    let horizon = &plan.recipe.horizon;
    HorizonParams {
        azimuths: horizon.azimuths(),
        radius: horizon.radius.unwrap_or_else(|| HorizonParams::default_radius(grid)),
        distance: plan.bakes(Table::Distance),
        method: horizon.method.into(),
    }
}
