//! Fields, and both bakers' maps of them.

use barchan_bakers::Exec;
use barchan_bakers::horizon::{self, Azimuths, HorizonMap, HorizonParams, Method, reference};
use barchan_field::{Edge, Grid, HeightField, LengthUnit, Spacing};

pub(crate) fn grid((width, height): (u32, u32), (spacing_u, spacing_v): (f64, f64), edge: Edge) -> Grid {
    let spacing = Spacing::new(spacing_u, spacing_v).unwrap();
    Grid { width, height, spacing, unit: LengthUnit::SceneUnit, edge }
}

/// A field of square texels of length 1; `height` is asked for each column and row.
pub(crate) fn field(size: (u32, u32), edge: Edge, height: impl Fn(u32, u32) -> f32) -> HeightField {
    fill(grid(size, (1.0, 1.0), edge), height)
}

pub(crate) fn fill(grid: Grid, height: impl Fn(u32, u32) -> f32) -> HeightField {
    let height = &height;
    let samples = (0..grid.height).flat_map(|row| (0..grid.width).map(move |column| height(column, row))).collect();
    HeightField::new(grid, samples).unwrap()
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

/// Reproducible noise in [0, 1) for a texel.
pub(crate) fn noise(seed: u32, column: u32, row: u32) -> f32 {
    let mut hash = seed.wrapping_mul(0x9E37_79B9) ^ column.wrapping_mul(0x85EB_CA6B) ^ row.wrapping_mul(0xC2B2_AE35);
    for _ in 0..2 {
        hash = (hash ^ (hash >> 15)).wrapping_mul(0x2C1B_3C6D);
        hash = (hash ^ (hash >> 12)).wrapping_mul(0x297A_2D39);
    }
    (hash >> 8) as f32 / (1 << 24) as f32
}
