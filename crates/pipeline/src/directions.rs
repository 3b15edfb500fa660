//! What is made direction by direction: one layer is baked, handed to every table that wants it, and forgotten.

use std::io::{Read, Seek, Write};

use barchan_asset::{ApertureConeTable, BentNormalTable, CurvatureSweep, SkyVisibilityTable};
use barchan_bakers::horizon::{self, BentLayer, HorizonLayer, HorizonParams};
use barchan_bakers::sky::{SkyAccumulator, SkyParams};
use barchan_bakers::swept::{SweptBaker, SweptParams};
use barchan_bakers::{BakeError, Exec};
use barchan_field::HeightField;

use crate::accuracy::{AccuracySample, HorizonAccuracy};
use crate::clock::Clock;
use crate::error::refused;
use crate::layout::{TableLayout, table_grid};
use crate::sink::{OpenTable, Sink};
use crate::{PipelineError, Plan, Table, bounds};

/// What is to be baked, and how it runs.
#[derive(Clone, Copy)]
pub(crate) struct Task<'a> {
    pub(crate) plan: &'a Plan,
    pub(crate) field: &'a HeightField,
    pub(crate) params: &'a HorizonParams,
    /// The range of curvatures, if anybody named one.
    pub(crate) curvature: Option<(f64, f64)>,
    pub(crate) exec: &'a Exec<'a>,
}

/// What is known once all directions are in the file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct DirectionsDone {
    /// `None` if no horizon table was stored.
    pub(crate) accuracy: Option<HorizonAccuracy>,
    /// Points per texel and direction; `None` where nothing was swept.
    pub(crate) points: Option<u32>,
}

/// Bakes and writes every table but the heights.
pub(crate) fn bake<W: Read + Write + Seek>(
    task: Task<'_>,
    sink: &mut Sink<'_, W>,
) -> Result<DirectionsDone, PipelineError> {
    let mut baker = Baker::new(task, &mut sink.clock)?;
    let mut sky = open_sky(task)?;
    let mut tables = DirectionTables::open(task, &baker, sink)?;
    let directions = task.params.directions();
    sink.clock.announce("horizon", 0, directions as usize);
    for direction in 0..directions {
        let layers = baker.bake(direction, &mut sink.clock)?;
        tables.write(direction, layers, sink)?;
        if let Some(sky) = &mut sky {
            sink.clock.time("sky", || sky.add(direction, &layers.flat.elevation_radians, task.exec));
        }
        sink.clock.announce("horizon", direction as usize + 1, directions as usize);
    }
    let points = baker.points();
    // The layers are not needed any more, and the sky asks for memory.
    drop(baker);
    let sample = tables.close(sink)?;
    if let Some(sky) = sky {
        write_sky(task, sky, sink)?;
    }
    let accuracy = sample.map(|sample| sink.clock.stage("measure", || sample.measure(task.field, task.params)));
    Ok(DirectionsDone { accuracy, points })
}

/// The horizon of one direction, and the further points where curvature is swept.
struct Layers {
    flat: HorizonLayer,
    /// Elevations and distances of each point but the flat one.
    further: Vec<HorizonLayer>,
}

/// Bakes one direction after the other into the same memory.
struct Baker<'a> {
    task: Task<'a>,
    layers: Layers,
    swept: Option<Swept<'a>>,
}

/// What a bake over a range of curvatures keeps.
struct Swept<'a> {
    baker: SweptBaker<'a>,
    points: Vec<BentLayer>,
}

impl<'a> Baker<'a> {
    fn new(task: Task<'a>, clock: &mut Clock<'_>) -> Result<Self, PipelineError> {
        let Task { plan, field, params, .. } = task;
        let flat = HorizonLayer::new(field, params).map_err(|error| refused("horizon", error))?;
        let swept = match plan.swept_params(task.curvature)? {
            Some(swept) => Some(clock.stage("points", || Swept::new(task, &swept)).map_err(refused_swept)?),
            None => None,
        };
        let further = swept.as_ref().map_or(0, |swept| swept.points.len() - 1);
        let with_distance = HorizonParams { distance: true, ..*params };
        let further = (0..further).map(|_| HorizonLayer::new(field, &with_distance));
        let further = further.collect::<Result<_, _>>().map_err(refused_swept)?;
        Ok(Self { task, layers: Layers { flat, further }, swept })
    }

    fn points(&self) -> Option<u32> {
        self.swept.as_ref().map(|swept| swept.points.len() as u32)
    }

    fn bake(&mut self, direction: u32, clock: &mut Clock<'_>) -> Result<&mut Layers, PipelineError> {
        let Self { task: Task { field, params, exec, .. }, layers, swept } = self;
        let bake = || match swept {
            Some(Swept { baker, points }) => {
                baker.bake_direction(direction, exec, points)?;
                layers.take(points);
                Ok(())
            }
            None => horizon::bake_direction(field, params, direction, exec, &mut layers.flat),
        };
        clock.time("horizon", bake).map_err(|error| refused("horizon", error))?;
        Ok(layers)
    }
}

impl<'a> Swept<'a> {
    fn new(task: Task<'a>, params: &SweptParams) -> Result<Self, BakeError> {
        let baker = SweptBaker::new(task.field, task.params, params, task.exec)?;
        let points = (0..baker.points()).map(|_| BentLayer::new(task.field)).collect::<Result<_, _>>()?;
        Ok(Self { baker, points })
    }
}

/// A refusal of the swept baker, in the words of a recipe, which says in which unit an error is.
pub(crate) fn refused_swept(error: BakeError) -> PipelineError {
    let error = match error {
        BakeError::Parameter { name: "max_error", value, accepted } => {
            BakeError::Parameter { name: "max_error_degrees", value, accepted }
        }
        error => error,
    };
    refused("curved", error)
}

impl Layers {
    /// Takes what was found over the range of curvatures, the flat horizon first: slopes become elevations.
    fn take(&mut self, points: &mut [BentLayer]) {
        for (layer, point) in std::iter::once(&mut self.flat).chain(&mut self.further).zip(points) {
            for (elevation, &slope) in layer.elevation_radians.iter_mut().zip(&point.slope) {
                *elevation = libm::atanf(slope);
            }
            // Both are overwritten by the next direction, so neither need be copied.
            if let Some(distance) = &mut layer.distance {
                std::mem::swap(distance, &mut point.distance);
            }
        }
    }
}

/// The directional tables of a file.
struct DirectionTables {
    directions: u32,
    horizon: Option<OpenTable>,
    distance: Option<OpenTable>,
    swept_horizon: Option<OpenTable>,
    swept_distance: Option<OpenTable>,
    sample: Option<AccuracySample>,
}

impl DirectionTables {
    fn open<W: Read + Write + Seek>(
        task: Task<'_>,
        baker: &Baker<'_>,
        sink: &mut Sink<'_, W>,
    ) -> Result<Self, PipelineError> {
        let Task { plan, field, params, .. } = task;
        let (layout, radius) = (TableLayout::new(field.grid(), params), params.radius);
        let steepest = sink.clock.time("bounds", || bounds::steepest_slope(field));
        let (sweep, bend) = sweep_of(task, baker).unzip();
        let mut open = |table: Table| -> Result<Option<OpenTable>, PipelineError> {
            if !plan.bakes(table) || (table.is_swept() && sweep.is_none()) {
                return Ok(None);
            }
            let bounds = match table {
                Table::Horizon => bounds::of_elevations(field, steepest, radius, 0.0),
                Table::SweptHorizon => bounds::of_elevations(field, steepest, radius, bend.unwrap_or(0.0)),
                _ => bounds::of_distances(radius),
            };
            sink.open(table, &layout.facts(table, sweep), plan.encoding(table), bounds).map(Some)
        };
        Ok(Self {
            directions: params.directions(),
            horizon: open(Table::Horizon)?,
            distance: open(Table::Distance)?,
            swept_horizon: open(Table::SweptHorizon)?,
            swept_distance: open(Table::SweptDistance)?,
            sample: plan.bakes(Table::Horizon).then(|| AccuracySample::new(field, params)),
        })
    }

    fn write<W: Read + Write + Seek>(
        &mut self,
        direction: u32,
        layers: &mut Layers,
        sink: &mut Sink<'_, W>,
    ) -> Result<(), PipelineError> {
        write_layer(&mut self.horizon, direction, Some(&mut layers.flat.elevation_radians), sink)?;
        write_layer(&mut self.distance, direction, layers.flat.distance.as_deref_mut(), sink)?;
        for (candidate, layer) in (0..).zip(&mut layers.further) {
            let index = candidate * self.directions + direction;
            write_layer(&mut self.swept_horizon, index, Some(&mut layer.elevation_radians), sink)?;
            write_layer(&mut self.swept_distance, index, layer.distance.as_deref_mut(), sink)?;
        }
        if let (Some(sample), Some(horizon)) = (&mut self.sample, &self.horizon) {
            let stored = horizon.last_layer();
            sample.take(direction, &layers.flat.elevation_radians, |column, row| stored.value(0, column, row));
        }
        Ok(())
    }

    fn close<W: Read + Write + Seek>(self, sink: &mut Sink<'_, W>) -> Result<Option<AccuracySample>, PipelineError> {
        let tables = [self.horizon, self.distance, self.swept_horizon, self.swept_distance];
        for table in tables.into_iter().flatten() {
            sink.close(table)?;
        }
        Ok(self.sample)
    }
}

/// What the swept tables say of themselves, and the greatest bend to the convex side; `None` where one point is enough.
fn sweep_of(task: Task<'_>, baker: &Baker<'_>) -> Option<(CurvatureSweep, f64)> {
    let (swept, (curvature_min, curvature_max)) = baker.swept.as_ref().zip(task.curvature)?;
    let candidates = swept.points.len() as u32 - 1;
    let bend = swept.baker.nodes().bends().iter().copied().fold(0.0, f64::max);
    (candidates > 0).then_some((CurvatureSweep { candidates, curvature_min, curvature_max }, bend))
}

fn write_layer<W: Read + Write + Seek>(
    table: &mut Option<OpenTable>,
    layer: u32,
    values: Option<&mut [f32]>,
    sink: &mut Sink<'_, W>,
) -> Result<(), PipelineError> {
    let (Some(table), Some(values)) = (table, values) else { return Ok(()) };
    sink.clock.time("encode", || bounds::cut(values, table.bounds()));
    sink.layer(table, layer, values)
}

/// The tables of the sky that a plan asks for, in the baker's words.
pub(crate) fn sky_params(plan: &Plan) -> SkyParams {
    SkyParams {
        visibility: plan.bakes(Table::SkyVisibility),
        bent_normal: plan.bakes(Table::BentNormal),
        aperture_cone: plan.bakes(Table::ApertureCone),
    }
}

fn open_sky(task: Task<'_>) -> Result<Option<SkyAccumulator<'_>>, PipelineError> {
    let asked = sky_params(task.plan);
    if asked == SkyParams::default() {
        return Ok(None);
    }
    let sky = SkyAccumulator::new(task.field, &task.params.azimuths, asked);
    sky.map(Some).map_err(|error| refused("horizon", error))
}

fn write_sky<W: Read + Write + Seek>(
    task: Task<'_>,
    sky: SkyAccumulator<'_>,
    sink: &mut Sink<'_, W>,
) -> Result<(), PipelineError> {
    let map = sink.clock.time("sky", || sky.finish(task.exec)).map_err(|error| refused("sky", error))?;
    let (grid, radius) = (table_grid(task.field.grid()), task.params.radius);
    let encoding = task.plan.recipe.sky.encoding.into();
    if let Some(values) = &map.visibility {
        sink.whole(Table::SkyVisibility, || SkyVisibilityTable { grid, radius, values }.encode(encoding))?;
    }
    if let Some(values) = &map.bent_normal {
        sink.whole(Table::BentNormal, || BentNormalTable { grid, radius, values }.encode(encoding))?;
    }
    if let Some(values) = &map.aperture_cone {
        sink.whole(Table::ApertureCone, || ApertureConeTable { grid, radius, values }.encode(encoding))?;
    }
    Ok(())
}
