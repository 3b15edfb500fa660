//! Blocks of lines handed to threads, and what they find written where it belongs.

use std::ops::Range;
use std::sync::Mutex;

use barchan_asset::f32_at_most;
use barchan_field::HeightField;

use super::bands::{BAND_ROWS, Bands};
use super::exact::{ExactUnits, Proof};
use super::far::Scene;
use super::lines::{LINES, Lines};
use super::map::LayerMut;
use super::sheared::{HeightScale, Sheared};
use super::sweep::{Job, Units, Workspace};
use super::{BentLayer, HorizonLayer, HorizonMap, HorizonParams, Method};
use crate::{BakeError, Exec};

/// How much higher than what was found a ceiling may stand without being looked at, as a slope: half a degree on level
/// ground. Ceilings stand about so much too high themselves.
const CEILING_TOLERANCE: f64 = 0.05;

/// Bakes all directions at once: the same bytes for any number of threads.
pub fn bake(field: &HeightField, params: &HorizonParams, exec: &Exec) -> Result<HorizonMap, BakeError> {
    HorizonMap::fill(field, params, |layers| fill(field, params, Output::Elevation, exec, layers.into_iter().zip(0..)))
}

/// Bakes one direction into `layer`, which is filled whole: for maps too large to hold in all directions.
///
/// # Panics
/// If the layer was made for another field, or lacks the distances that `params` ask for.
pub fn bake_direction(
    field: &HeightField,
    params: &HorizonParams,
    direction: u32,
    exec: &Exec,
    layer: &mut HorizonLayer,
) -> Result<(), BakeError> {
    params.check(field)?;
    assert_eq!(layer.elevation_radians.len(), field.grid().texels(), "a layer of this field");
    assert_eq!(layer.distance.is_some(), params.distance, "distances if they are asked for");
    fill(field, params, Output::Elevation, exec, std::iter::once((layer.as_mut(), direction)));
    Ok(())
}

/// Bakes, for one direction, the points that are highest once the relief is bent: of height h(s) − λ s² at distance s,
/// λ = `bend` in 1/length unit, positive for convex ground. They are what a curved surface may show above its horizon; their
/// slopes are those of the relief as it is.
///
/// # Panics
/// If the layer was made for another field.
pub fn bake_bent(
    field: &HeightField,
    params: &HorizonParams,
    direction: u32,
    bend: f64,
    exec: &Exec,
    layer: &mut BentLayer,
) -> Result<(), BakeError> {
    let params = HorizonParams { distance: true, ..*params };
    params.check(field)?;
    if !bend.is_finite() {
        let accepted = "a finite number is accepted";
        return Err(BakeError::Parameter { name: "bend", value: bend.to_string(), accepted });
    }
    assert_eq!(layer.slope.len(), field.grid().texels(), "a layer of this field");
    fill(field, &params, Output::Slope { bend }, exec, std::iter::once((layer.as_mut(), direction)));
    Ok(())
}

/// What is wanted of the points found.
#[derive(Debug, Clone, Copy)]
enum Output {
    /// Their elevation above the base plane.
    Elevation,
    /// The slope of the points that are highest when the relief is bent.
    Slope { bend: f64 },
}

/// Bakes some directions, a block of lines at a time.
fn fill<'a>(
    field: &HeightField,
    params: &HorizonParams,
    output: Output,
    exec: &Exec,
    layers: impl Iterator<Item = (LayerMut<'a>, u32)>,
) {
    let scale = HeightScale::of(field);
    let directions: Vec<Direction> =
        layers.map(|(layer, index)| Direction::new(field, params, output, index, scale, layer)).collect();
    let blocks = directions
        .iter()
        .flat_map(|direction| direction.lines.blocks().into_iter().map(move |first_line| (direction, first_line)));
    exec.for_each_with(blocks.collect(), Buffers::new, |buffers, (direction, first_line)| {
        direction.bake_block(field, params, scale, first_line, buffers);
    });
}

/// What a thread keeps from block to block.
struct Buffers {
    sheared: Sheared,
    workspace: Workspace,
    proof: Proof,
}

impl Buffers {
    fn new() -> Self {
        Self { sheared: Sheared::default(), workspace: Workspace::new(), proof: Proof::new() }
    }
}

/// One direction being baked.
struct Direction<'a> {
    lines: Lines,
    units: Units,
    exact_units: ExactUnits,
    bend: f32,
    width: usize,
    bands: Vec<Mutex<LayerMut<'a>>>,
}

impl<'a> Direction<'a> {
    fn new(
        field: &HeightField,
        params: &HorizonParams,
        output: Output,
        index: u32,
        scale: HeightScale,
        layer: LayerMut<'a>,
    ) -> Self {
        let lines = Lines::new(field, params, index);
        let width = field.grid().width as usize;
        let length = lines.octant.length_per_major;
        let exact_units = ExactUnits {
            slope: 1.0 / (f64::from(scale.factor) * length),
            length,
            farthest: f32_at_most(params.radius),
        };
        let units = Units {
            slope: (exact_units.slope as f32).min(f32::MAX),
            length: length as f32,
            farthest: exact_units.farthest,
            angles: matches!(output, Output::Elevation),
        };
        let bend = match output {
            Output::Elevation => 0.0,
            Output::Slope { bend } => (bend * length * length * f64::from(scale.factor)) as f32,
        };
        let bands = layer.bands(width, BAND_ROWS).into_iter().map(Mutex::new).collect();
        Self { lines, units, exact_units, bend, width, bands }
    }

    fn bake_block(
        &self,
        field: &HeightField,
        params: &HorizonParams,
        scale: HeightScale,
        first_line: i64,
        buffers: &mut Buffers,
    ) {
        let lines = &self.lines;
        let columns = lines.columns_with_texels(first_line);
        let columns_in_sight = lines.columns_in_sight(first_line);
        buffers.sheared.take(field, lines, first_line, columns_in_sight, scale.factor);
        let tolerance = (CEILING_TOLERANCE / self.exact_units.slope) as f32;
        let scene = Scene { lines, heights: &buffers.sheared.heights, datum: scale.datum, bend: self.bend, tolerance };
        let bands = Bands { bands: &self.bands, width: self.width };
        let proves = params.method == Method::Exact && self.units.angles;
        if proves {
            buffers.proof.take(&scene, columns_in_sight);
        }
        let proof = &mut buffers.proof;
        let mut write = |columns: Range<usize>, values: &[[f32; LINES]], distances: &[[f32; LINES]]| {
            if proves {
                let owned = 0..lines.owned(first_line);
                let (values, distances) = proof.prove(scene, self.exact_units, columns.clone(), owned, distances);
                bands.write(lines, first_line, columns, values, distances);
            } else {
                bands.write(lines, first_line, columns, values, distances);
            }
        };
        let job = Job { scene, columns, columns_in_sight, units: self.units };
        // A proof starts from where the sweep saw the horizon.
        job.sweep(params.method, params.distance || proves, &mut buffers.workspace, &mut write);
    }
}
