//! The typed table a horizon bake returns, before any encoding.

use barchan_asset::{MAX_ELEVATION, f32_at_most};
use barchan_field::{Grid, HeightField};

use super::HorizonParams;
use crate::BakeError;
use crate::memory::{self, MAX_TABLE_BYTES};

/// Where the horizon of a texel lies in one direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HorizonPoint {
    /// Rise over run from the texel to the horizon point: the tangent of its elevation, signed.
    pub slope: f64,
    /// Distance to the horizon point along the base plane, in the field's length unit. 0 where the slope is the limit
    /// at the texel itself: the surface falls away below its own tangent.
    pub distance: f64,
}

impl HorizonPoint {
    /// Lower and nearer than any point.
    pub(crate) const NONE: Self = Self { slope: f64::NEG_INFINITY, distance: 0.0 };

    /// The elevation above the base plane in radians, within ±[`MAX_ELEVATION`].
    #[must_use]
    pub fn elevation_radians(&self) -> f32 {
        // f32 keeps any slope's angle to 3e-8 rad, and a slope beyond f32 is a wall in either precision.
        libm::atanf(self.slope as f32).clamp(-MAX_ELEVATION, MAX_ELEVATION)
    }

    /// Takes the point if it is higher, or as high and farther: a level field's horizon is at the search radius.
    #[inline]
    pub(crate) fn raise(&mut self, slope: f64, distance: f64) {
        if slope > self.slope || (slope == self.slope && distance > self.distance) {
            *self = Self { slope, distance };
        }
    }
}

/// Horizon elevations, and distances where asked for, of every texel in one direction.
#[derive(Debug, Clone, PartialEq)]
pub struct HorizonLayer {
    /// `[row][column]`, elevation above the base plane in radians, within ±[`MAX_ELEVATION`].
    pub elevation_radians: Vec<f32>,
    /// `[row][column]`, distance along the base plane in the length unit, 0 to the radius.
    pub distance: Option<Vec<f32>>,
}

impl HorizonLayer {
    /// Room for a layer of a field.
    pub fn new(field: &HeightField, params: &HorizonParams) -> Result<Self, BakeError> {
        params.check(field)?;
        let texels = field.grid().texels();
        let distance = params.distance.then(|| zeros(texels)).transpose()?;
        Ok(Self { elevation_radians: zeros(texels)?, distance })
    }

    pub(crate) fn as_mut(&mut self) -> LayerMut<'_> {
        LayerMut { values: &mut self.elevation_radians, distance: self.distance.as_deref_mut() }
    }
}

/// Points that a bent relief shows highest, one per texel, in one direction: see [`super::bake_bent`].
#[derive(Debug, Clone, PartialEq)]
pub struct BentLayer {
    /// `[row][column]`, the slope of the point in the relief as it is: rise over run, within the finite f32.
    pub slope: Vec<f32>,
    /// `[row][column]`, distance along the base plane in the length unit, 0 to the radius.
    pub distance: Vec<f32>,
}

impl BentLayer {
    /// Room for a layer of a field.
    pub fn new(field: &HeightField) -> Result<Self, BakeError> {
        let texels = field.grid().texels();
        Ok(Self { slope: zeros(texels)?, distance: zeros(texels)? })
    }

    pub(crate) fn as_mut(&mut self) -> LayerMut<'_> {
        LayerMut { values: &mut self.slope, distance: Some(&mut self.distance) }
    }
}

/// Horizon elevations, and distances where asked for, of every texel in every direction.
#[derive(Debug, Clone, PartialEq)]
pub struct HorizonMap {
    /// The grid of the field it was baked from.
    pub grid: Grid,
    /// What was baked.
    pub params: HorizonParams,
    /// `[direction][row][column]`, elevation above the base plane in radians, within ±[`MAX_ELEVATION`].
    pub elevation_radians: Vec<f32>,
    /// `[direction][row][column]`, distance along the base plane in the length unit, 0 to the radius.
    pub distance: Option<Vec<f32>>,
}

impl HorizonMap {
    /// Checks, allocates, and lets `bake` fill all layers.
    pub(crate) fn fill(
        field: &HeightField,
        params: &HorizonParams,
        bake: impl FnOnce(Vec<LayerMut<'_>>),
    ) -> Result<Self, BakeError> {
        params.check(field)?;
        let texels = field.grid().texels();
        let values = bounded_values(texels, params)?;
        let mut elevation_radians = zeros(values)?;
        let mut distance = params.distance.then(|| zeros(values)).transpose()?;
        bake(split_layers(&mut elevation_radians, distance.as_deref_mut(), texels));
        Ok(Self { grid: *field.grid(), params: *params, elevation_radians, distance })
    }

    /// The elevations of one direction, row by row, in radians.
    #[must_use]
    pub fn elevation_layer(&self, direction: u32) -> &[f32] {
        let texels = self.grid.texels();
        &self.elevation_radians[direction as usize * texels..][..texels]
    }
}

fn bounded_values(texels: usize, params: &HorizonParams) -> Result<usize, BakeError> {
    let values = texels as u64 * u64::from(params.directions());
    let bytes = values * if params.distance { 8 } else { 4 };
    if bytes > MAX_TABLE_BYTES {
        return Err(BakeError::TooLarge { what: "the horizon map", bytes, limit: MAX_TABLE_BYTES });
    }
    Ok(values as usize)
}

fn zeros(values: usize) -> Result<Vec<f32>, BakeError> {
    memory::zeros("the horizon map", values as u64)
}

/// One direction's share of the output.
pub(crate) struct LayerMut<'a> {
    /// Elevations in radians, or slopes.
    pub(crate) values: &'a mut [f32],
    pub(crate) distance: Option<&'a mut [f32]>,
}

impl<'a> LayerMut<'a> {
    /// Bands of `rows` rows each, which different threads may fill.
    pub(crate) fn bands(self, width: usize, rows: usize) -> Vec<LayerMut<'a>> {
        let mut distances = self.distance.map(|all| all.chunks_mut(width * rows));
        self.values
            .chunks_mut(width * rows)
            .map(|values| LayerMut { values, distance: distances.as_mut().and_then(Iterator::next) })
            .collect()
    }

    /// Stores a point found in f64.
    pub(crate) fn set(&mut self, index: usize, point: HorizonPoint, radius: f64) {
        self.values[index] = point.elevation_radians();
        if let Some(distance) = &mut self.distance {
            distance[index] = (point.distance as f32).min(f32_at_most(radius));
        }
    }
}

fn split_layers<'a>(elevation: &'a mut [f32], distance: Option<&'a mut [f32]>, texels: usize) -> Vec<LayerMut<'a>> {
    let mut distances = distance.map(|all| all.chunks_exact_mut(texels));
    elevation
        .chunks_exact_mut(texels)
        .map(|values| LayerMut { values, distance: distances.as_mut().and_then(Iterator::next) })
        .collect()
}
