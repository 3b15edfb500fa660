//! Fields, parameters, and what every bend finds of them.

use barchan_bakers::horizon::{Azimuths, HorizonParams, Method};
use barchan_bakers::swept::reference::BentReference;
use barchan_bakers::swept::{HorizonCandidate, Nodes, Tie};
use barchan_field::shapes::FractalTerrain;
use barchan_field::{Edge, Grid, HeightField, LengthUnit, Shape, Spacing};
use barchan_shade::StoredPoint;

pub(crate) fn grid((width, height): (u32, u32), edge: Edge) -> Grid {
    Grid { width, height, spacing: Spacing::UNIT, unit: LengthUnit::SceneUnit, edge }
}

pub(crate) fn field(size: (u32, u32), edge: Edge, height: impl Fn(u32, u32) -> f32) -> HeightField {
    let height = &height;
    let samples = (0..size.1).flat_map(|row| (0..size.0).map(move |column| height(column, row))).collect();
    HeightField::new(grid(size, edge), samples).unwrap()
}

/// Relief of many scales, its lowest texel on the base surface.
pub(crate) fn terrain() -> HeightField {
    let shape = FractalTerrain { height: 9.0, hurst: 0.8, features_across: 2, octaves: 5, seed: 5 };
    let relief = Shape::FractalTerrain(shape).rasterize(grid((48, 48), Edge::Wrap)).unwrap();
    let lowest = relief.range().0;
    field((48, 48), Edge::Wrap, |column, row| relief.texel(i64::from(column), i64::from(row)) - lowest)
}

/// A few texels that have nothing in common.
pub(crate) fn texels() -> impl Iterator<Item = (u32, u32)> {
    (0..48).step_by(7).flat_map(|row| (0..48).step_by(5).map(move |column| (column, row)))
}

pub(crate) fn params(directions: u32, radius: f64) -> HorizonParams {
    HorizonParams { azimuths: Azimuths::full_circle(directions), radius, distance: true, method: Method::default() }
}

/// What every bend finds for one texel, as f32 tables hold it.
pub(crate) fn candidates(bends: &[BentReference], (column, row): (u32, u32)) -> Vec<HorizonCandidate> {
    let candidate = |bent: &BentReference| {
        let point = bent.point(column, row);
        HorizonCandidate { slope: point.slope as f32, distance: point.distance as f32 }
    };
    bends.iter().map(candidate).collect()
}

pub(crate) fn bends<'a>(
    field: &'a HeightField,
    params: &HorizonParams,
    direction: u32,
    nodes: &Nodes,
) -> Vec<BentReference<'a>> {
    nodes.bends().iter().map(|&bend| BentReference::new(field, params, direction, bend, Tie::Nearest)).collect()
}

pub(crate) fn stored(points: &[HorizonCandidate]) -> Vec<StoredPoint> {
    let stored =
        |point: &HorizonCandidate| StoredPoint { slope: f64::from(point.slope), distance: f64::from(point.distance) };
    points.iter().map(stored).collect()
}

#[track_caller]
pub(crate) fn assert_near(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance, "{found} instead of {expected}, off by {:e}", found - expected);
}
