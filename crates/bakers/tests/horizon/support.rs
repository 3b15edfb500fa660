//! Fields, and both bakers' maps of them.

use barchan_bakers::Exec;
use barchan_bakers::horizon::{self, Azimuths, HorizonMap, HorizonParams, Method, reference};
use barchan_field::{Edge, HeightField};

pub(crate) use crate::fields::{fill, grid};
pub(crate) use crate::random::noise;

/// A field of square texels of length 1; `height` is asked for each column and row.
pub(crate) fn field(size: (u32, u32), edge: Edge, height: impl Fn(u32, u32) -> f32) -> HeightField {
    fill(grid(size, (1.0, 1.0), edge), height)
}

/// What the exact method is asked for; others are said where they are meant.
pub(crate) fn params(directions: u32, radius: f64) -> HorizonParams {
    HorizonParams { azimuths: Azimuths::full_circle(directions), radius, distance: true, method: Method::Exact }
}

pub(crate) fn bake(field: &HeightField, params: &HorizonParams) -> HorizonMap {
    horizon::bake(field, params, &Exec::new(1).unwrap()).unwrap()
}

/// The maps of the exact method and of the reference, for what both must get right.
pub(crate) fn both(field: &HeightField, params: &HorizonParams) -> [HorizonMap; 2] {
    [bake(field, params), reference::bake(field, params, &Exec::new(1).unwrap()).unwrap()]
}

/// Elevation in radians, and distance, as stored.
pub(crate) fn at(map: &HorizonMap, direction: u32, column: u32, row: u32) -> (f64, f64) {
    let texel = (row * map.grid.width + column) as usize;
    let index = direction as usize * map.grid.texels() + texel;
    let distance = map.distance.as_ref().expect("the distance was asked for")[index];
    (f64::from(map.elevation_radians[index]), f64::from(distance))
}

#[track_caller]
pub(crate) fn assert_near(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance, "{found} instead of {expected}, off by {:e}", found - expected);
}
