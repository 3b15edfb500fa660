//! The tables of relief: heights, and what is found around every texel.

use std::io::{Read, Seek, Write};

use barchan_asset::HeightTable;
use barchan_bakers::Exec;
use barchan_bakers::horizon::HorizonParams;
use barchan_field::HeightField;

use crate::directions::{self, Task};
use crate::layout::table_grid;
use crate::provenance::{HorizonProvenance, SweptProvenance};
use crate::sink::Sink;
use crate::swept_range::MeshRange;
use crate::{PipelineError, Plan, Table};

/// What is known once the tables of relief are in the file.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct ReliefDone {
    /// `None` where no horizon was looked for.
    pub(crate) horizon: Option<HorizonProvenance>,
    /// `None` where nothing was swept.
    pub(crate) swept: Option<SweptProvenance>,
}

/// Bakes and writes every table that comes from heights. `on_mesh` is the range of curvatures of a mesh that they lie on.
pub(crate) fn bake<W: Read + Write + Seek>(
    plan: &Plan,
    field: &HeightField,
    on_mesh: Option<(f64, f64)>,
    exec: &Exec<'_>,
    sink: &mut Sink<'_, W>,
) -> Result<ReliefDone, PipelineError> {
    if plan.bakes(Table::Height) {
        let table = HeightTable { grid: table_grid(field.grid()), values: field.samples() };
        sink.whole(Table::Height, || table.encode(plan.recipe.height.encoding.into()))?;
    }
    if !plan.needs_horizon() {
        return Ok(ReliefDone::default());
    }
    let params = horizon_params(plan, field);
    let on_mesh = on_mesh.map(|range| MeshRange::new(range, field.grid(), params.radius));
    let curvature = plan.curvature().or(on_mesh.as_ref().map(|range| range.swept));
    let done = directions::bake(Task { plan, field, params: &params, curvature, exec }, sink)?;
    let horizon = HorizonProvenance::new(&plan.recipe.horizon, &params, done.accuracy);
    Ok(ReliefDone { horizon: Some(horizon), swept: done.points.map(|points| SweptProvenance::new(points, on_mesh)) })
}

fn horizon_params(plan: &Plan, field: &HeightField) -> HorizonParams {
    let horizon = &plan.recipe.horizon;
    HorizonParams {
        azimuths: horizon.azimuths(),
        radius: horizon.radius.unwrap_or_else(|| HorizonParams::default_radius(field.grid())),
        distance: plan.bakes(Table::Distance),
        method: horizon.method.into(),
    }
}
