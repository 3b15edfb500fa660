//! What is made direction by direction: one layer is baked, handed to every table that wants it, and forgotten.

use std::io::{Read, Seek, Write};

use barchan_asset::{ApertureConeTable, BentNormalTable, CurvatureSweep, SkyVisibilityTable};
use barchan_bakers::horizon::{self, BentLayer, HorizonLayer, HorizonParams};
use barchan_bakers::sky::{SkyAccumulator, SkyParams};
use barchan_bakers::swept::SweptBaker;
use barchan_bakers::{BakeError, Exec};
use barchan_field::HeightField;

use crate::accuracy::{AccuracySample, HorizonAccuracy};
use crate::clock::Clock;
use crate::error::refused;
use crate::layout::{TableLayout, table_grid};
use crate::sink::{OpenTable, Sink};
use crate::{PipelineError, Plan, Table, bounds};

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
    plan: &Plan,
    field: &HeightField,
    params: &HorizonParams,
    exec: &Exec<'_>,
    clock: &mut Clock<'_>,
    sink: &mut Sink<W>,
) -> Result<DirectionsDone, PipelineError> {
    let mut baker = Baker::new(plan, field, params, exec, clock)?;
    let mut tables = DirectionTables::open(plan, field, params, &baker, clock, sink)?;
    let mut sky = open_sky(plan, field, params)?;
    let directions = params.directions();
    clock.announce("horizon", 0, directions as usize);
    for direction in 0..directions {
        let layers = baker.bake(direction, exec, clock)?;
        tables.write(direction, directions, layers, clock, sink)?;
        if let Some(sky) = &mut sky {
            clock.time("sky", || sky.add(direction, &layers.flat.elevation_radians, exec));
        }
        clock.announce("horizon", direction as usize + 1, directions as usize);
    }
    let points = baker.points();
    // The layers are not needed any more, and the sky asks for memory.
    drop(baker);
    let sample = tables.close(clock, sink)?;
    if let Some(sky) = sky {
        write_sky(plan, field, params.radius, sky, exec, clock, sink)?;
    }
    let accuracy = sample.map(|sample| clock.stage("measure", || sample.measure(field, params)));
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
    field: &'a HeightField,
    params: HorizonParams,
    layers: Layers,
    swept: Option<Swept<'a>>,
}

/// What a bake over a range of curvatures keeps.
struct Swept<'a> {
    baker: SweptBaker<'a>,
    points: Vec<BentLayer>,
}

impl<'a> Baker<'a> {
    fn new(
        plan: &Plan,
        field: &'a HeightField,
        params: &HorizonParams,
        exec: &Exec<'_>,
        clock: &mut Clock<'_>,
    ) -> Result<Self, PipelineError> {
        let swept = match plan.swept_params()? {
            Some(swept) => {
                let baker = clock.stage("points", || SweptBaker::new(field, params, &swept, exec));
                let baker = baker.map_err(|error| refused("curved", as_recipes_spell_it(error)))?;
                let layers = (0..baker.points()).map(|_| BentLayer::new(field));
                let points = layers.collect::<Result<_, _>>().map_err(|error| refused("curved", error))?;
                Some(Swept { baker, points })
            }
            None => None,
        };
        let layer =
            |params: &HorizonParams| HorizonLayer::new(field, params).map_err(|error| refused("horizon", error));
        let flat = layer(params)?;
        let further = swept.as_ref().map_or(0, |swept| swept.points.len() - 1);
        let with_distance = HorizonParams { distance: true, ..*params };
        let further = (0..further).map(|_| layer(&with_distance)).collect::<Result<_, _>>()?;
        Ok(Self { field, params: *params, layers: Layers { flat, further }, swept })
    }

    fn points(&self) -> Option<u32> {
        self.swept.as_ref().map(|swept| swept.points.len() as u32)
    }

    fn bake(&mut self, direction: u32, exec: &Exec<'_>, clock: &mut Clock<'_>) -> Result<&mut Layers, PipelineError> {
        let Self { field, params, layers, swept } = self;
        let bake = || match swept {
            Some(swept) => {
                swept.baker.bake_direction(direction, exec, &mut swept.points)?;
                Ok(())
            }
            None => horizon::bake_direction(field, params, direction, exec, &mut layers.flat),
        };
        clock.time("horizon", bake).map_err(|error| refused("horizon", error))?;
        if let Some(swept) = swept {
            clock.time("horizon", || layers.take(&mut swept.points));
        }
        Ok(layers)
    }
}

/// A recipe says in which unit the error is.
fn as_recipes_spell_it(error: BakeError) -> BakeError {
    match error {
        BakeError::Parameter { name: "max_error", value, accepted } => {
            BakeError::Parameter { name: "max_error_degrees", value, accepted }
        }
        error => error,
    }
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
    horizon: Option<OpenTable>,
    distance: Option<OpenTable>,
    swept_horizon: Option<OpenTable>,
    swept_distance: Option<OpenTable>,
    sample: Option<AccuracySample>,
}

impl DirectionTables {
    fn open<W: Read + Write + Seek>(
        plan: &Plan,
        field: &HeightField,
        params: &HorizonParams,
        baker: &Baker<'_>,
        clock: &mut Clock<'_>,
        sink: &mut Sink<W>,
    ) -> Result<Self, PipelineError> {
        let (layout, radius) = (TableLayout::new(field.grid(), params), params.radius);
        let elevations = clock.time("bounds", || bounds::of_elevations(field, radius));
        let swept = baker.swept.as_ref().filter(|swept| swept.points.len() > 1).zip(plan.curvature());
        let sweep = swept.map(|(swept, (curvature_min, curvature_max))| CurvatureSweep {
            candidates: swept.points.len() as u32 - 1,
            curvature_min,
            curvature_max,
        });
        let bend = swept.map_or(0.0, |(swept, _)| swept.baker.nodes().bends().iter().copied().fold(0.0, f64::max));
        let mut open = |table: Table| -> Result<Option<OpenTable>, PipelineError> {
            if !plan.bakes(table) || (table.is_swept() && sweep.is_none()) {
                return Ok(None);
            }
            let bounds = match table {
                Table::Horizon => elevations.clone(),
                Table::SweptHorizon => clock.time("bounds", || bounds::of_bent_elevations(field, radius, bend)),
                _ => bounds::of_distances(radius),
            };
            sink.open(table, &layout.facts(table, sweep), plan.encoding(table), bounds).map(Some)
        };
        Ok(Self {
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
        directions: u32,
        layers: &mut Layers,
        clock: &mut Clock<'_>,
        sink: &mut Sink<W>,
    ) -> Result<(), PipelineError> {
        write_layer(&mut self.horizon, direction, Some(&mut layers.flat.elevation_radians), clock, sink)?;
        write_layer(&mut self.distance, direction, layers.flat.distance.as_deref_mut(), clock, sink)?;
        for (candidate, layer) in (0..).zip(&mut layers.further) {
            let index = candidate * directions + direction;
            write_layer(&mut self.swept_horizon, index, Some(&mut layer.elevation_radians), clock, sink)?;
            write_layer(&mut self.swept_distance, index, layer.distance.as_deref_mut(), clock, sink)?;
        }
        if let (Some(sample), Some(horizon)) = (&mut self.sample, &self.horizon) {
            let stored = horizon.last_layer();
            sample.take(direction, &layers.flat.elevation_radians, |column, row| stored.value(0, column, row));
        }
        Ok(())
    }

    fn close<W: Read + Write + Seek>(
        self,
        clock: &mut Clock<'_>,
        sink: &mut Sink<W>,
    ) -> Result<Option<AccuracySample>, PipelineError> {
        let tables = [self.horizon, self.distance, self.swept_horizon, self.swept_distance];
        for table in tables.into_iter().flatten() {
            sink.close(table, clock)?;
        }
        Ok(self.sample)
    }
}

fn write_layer<W: Read + Write + Seek>(
    table: &mut Option<OpenTable>,
    layer: u32,
    values: Option<&mut [f32]>,
    clock: &mut Clock<'_>,
    sink: &mut Sink<W>,
) -> Result<(), PipelineError> {
    let (Some(table), Some(values)) = (table, values) else { return Ok(()) };
    clock.time("encode", || bounds::cut(values, table.bounds()));
    sink.layer(table, layer, values, clock)
}

fn open_sky<'a>(
    plan: &Plan,
    field: &'a HeightField,
    params: &HorizonParams,
) -> Result<Option<SkyAccumulator<'a>>, PipelineError> {
    let asked = SkyParams {
        visibility: plan.bakes(Table::SkyVisibility),
        bent_normal: plan.bakes(Table::BentNormal),
        aperture_cone: plan.bakes(Table::ApertureCone),
    };
    if asked == SkyParams::default() {
        return Ok(None);
    }
    SkyAccumulator::new(field, &params.azimuths, asked).map(Some).map_err(|error| refused("horizon", error))
}

fn write_sky<W: Read + Write + Seek>(
    plan: &Plan,
    field: &HeightField,
    radius: f64,
    sky: SkyAccumulator<'_>,
    exec: &Exec<'_>,
    clock: &mut Clock<'_>,
    sink: &mut Sink<W>,
) -> Result<(), PipelineError> {
    let map = clock.time("sky", || sky.finish(exec)).map_err(|error| refused("sky", error))?;
    let grid = table_grid(field.grid());
    let encoding = plan.recipe.sky.encoding.into();
    if let Some(values) = &map.visibility {
        let table = SkyVisibilityTable { grid, radius, values };
        sink.whole(Table::SkyVisibility, clock, || table.encode(encoding))?;
    }
    if let Some(values) = &map.bent_normal {
        let table = BentNormalTable { grid, radius, values };
        sink.whole(Table::BentNormal, clock, || table.encode(encoding))?;
    }
    if let Some(values) = &map.aperture_cone {
        let table = ApertureConeTable { grid, radius, values };
        sink.whole(Table::ApertureCone, clock, || table.encode(encoding))?;
    }
    Ok(())
}
