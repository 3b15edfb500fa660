//! Tables by which rays find where they hit the relief: depths to start at, cones to step by, heights to pass over.
//!
//! They are baked from the heights *as stored*: what a reader decodes from the height table is the surface that rays are followed
//! to, and only for that surface a bound is a bound. Where no height table goes into the file, heights are taken as the recipe would
//! store them.

use std::io::{Read, Seek, Write};

use barchan_asset::{ConeMapTable, HemisphereTable, MaximumMipTable, RelaxedConeMapTable, TextureTable};
use barchan_bakers::cone::{self, ConeKind};
use barchan_bakers::hemisphere::HemisphereBaker;
use barchan_bakers::{Exec, maximum_mip};
use barchan_field::HeightField;

use crate::error::refused;
use crate::layout::table_grid;
use crate::search_params::{hemisphere_params, refused_hemisphere};
use crate::search_provenance::{HemisphereProvenance, ReliefSearchProvenance};
use crate::sink::Sink;
use crate::start_accuracy::StartSample;
use crate::{PipelineError, Plan, Run, Table};

/// The heights that a reader will decode.
pub(crate) fn as_stored(field: &HeightField, heights: &TextureTable) -> Result<HeightField, PipelineError> {
    let grid = *field.grid();
    let view = heights.view().expect("a table that was just encoded");
    let samples = (0..grid.height).flat_map(|row| view.row(0, row)).collect();
    HeightField::new(grid, samples).map_err(PipelineError::Shape)
}

/// Bakes and writes every table for relief search. `surface` holds the heights as stored.
pub(crate) fn bake<W: Read + Write + Seek>(
    plan: &Plan,
    surface: &HeightField,
    run: &Run<'_>,
    exec: &Exec<'_>,
    sink: &mut Sink<'_, W>,
) -> Result<ReliefSearchProvenance, PipelineError> {
    let hemisphere = match plan.bakes(Table::Hemisphere) {
        true => Some(bake_hemisphere(plan, surface, exec, sink)?),
        false => None,
    };
    for (table, kind) in [(Table::ConeMap, ConeKind::Strict), (Table::RelaxedConeMap, ConeKind::Relaxed)] {
        if plan.bakes(table) {
            bake_cones(plan, surface, (table, kind), run, sink)?;
        }
    }
    if plan.bakes(Table::MaximumMip) {
        bake_maximum_mip(plan, surface, exec, sink)?;
    }
    Ok(ReliefSearchProvenance::new(hemisphere, plan))
}

/// One direction after the other: in memory are the field and one layer.
fn bake_hemisphere<W: Read + Write + Seek>(
    plan: &Plan,
    surface: &HeightField,
    exec: &Exec<'_>,
    sink: &mut Sink<'_, W>,
) -> Result<HemisphereProvenance, PipelineError> {
    let params = hemisphere_params(plan, surface.grid())?;
    let (table, stage) = (Table::Hemisphere, Table::Hemisphere.name());
    let layers = params.directions.layers();
    sink.clock.announce(stage, 0, layers as usize);
    let baker = sink.clock.time(stage, || HemisphereBaker::new(surface, params, exec)).map_err(refused_hemisphere)?;
    let grid = table_grid(surface.grid()).with_texels(params.width, params.height);
    let facts =
        HemisphereTable { grid, directions: params.directions, mode: params.mode, relief: baker.relief(), values: &[] }
            .facts();
    let mut open = sink.open(table, &facts, plan.encoding(table), 0.0..=1.0)?;
    let mut sample = StartSample::new(surface, &params);
    let mut depths = vec![0.0; params.width as usize * params.height as usize];
    for layer in 0..layers {
        sink.clock.time(stage, || baker.bake_layer(layer, exec, &mut depths));
        sink.layer(&mut open, layer, &depths)?;
        let stored = open.last_layer();
        sample.take(layer, |column, row| stored.value(0, column, row));
        sink.clock.announce(stage, layer as usize + 1, layers as usize);
    }
    sink.close(open)?;
    drop(baker);
    let accuracy = sink.clock.stage("starts", || sample.measure(surface));
    Ok(HemisphereProvenance::new(plan, &params, accuracy))
}

fn bake_cones<W: Read + Write + Seek>(
    plan: &Plan,
    surface: &HeightField,
    (table, kind): (Table, ConeKind),
    run: &Run<'_>,
    sink: &mut Sink<'_, W>,
) -> Result<(), PipelineError> {
    let progress = |done, total| (run.progress)(table.name(), done, total);
    let exec = Exec::new(run.threads).map_err(|error| refused("-j", error))?.with_progress(&progress);
    sink.clock.announce(table.name(), 0, 1);
    let cones = sink.clock.time(table.name(), || cone::bake(surface, kind, &exec));
    let cones = cones.map_err(|error| refused(table.name(), error))?;
    let (grid, relief, values) = (table_grid(surface.grid()), cones.relief, &cones.values);
    sink.whole(table, || match kind {
        ConeKind::Strict => ConeMapTable { grid, relief, values }.encode(plan.encoding(table)),
        ConeKind::Relaxed => RelaxedConeMapTable { grid, relief, values }.encode(plan.encoding(table)),
    })
}

fn bake_maximum_mip<W: Read + Write + Seek>(
    plan: &Plan,
    surface: &HeightField,
    exec: &Exec<'_>,
    sink: &mut Sink<'_, W>,
) -> Result<(), PipelineError> {
    let table = Table::MaximumMip;
    let mip = sink.clock.stage(table.name(), || maximum_mip::bake(surface, exec));
    let mip = mip.map_err(|error| refused(table.name(), error))?;
    let levels: Vec<&[f32]> = mip.levels.iter().map(|level| level.values.as_slice()).collect();
    let grid = table_grid(surface.grid());
    sink.whole(table, || MaximumMipTable { grid, levels: &levels }.encode(plan.encoding(table)))
}
