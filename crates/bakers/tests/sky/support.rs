//! Fields, skylines and skies.

use std::f64::consts::TAU;

use barchan_bakers::Exec;
use barchan_bakers::horizon::{Azimuths, HorizonParams, Method};
use barchan_bakers::sky::{self, SkyAccumulator, SkyMap, SkyParams};
use barchan_field::{Edge, HeightField};

pub(crate) use crate::fields::{fill, grid};
pub(crate) use crate::random::noise;

pub(crate) const EDGES: [Edge; 2] = [Edge::Wrap, Edge::Clamp];

/// The horizons of the reference: what is tested here is the sky.
pub(crate) fn horizons(directions: u32, radius: f64) -> HorizonParams {
    HorizonParams { azimuths: Azimuths::full_circle(directions), radius, distance: false, method: Method::Exact }
}

pub(crate) fn bake(field: &HeightField, horizons: &HorizonParams) -> SkyMap {
    sky::bake(field, horizons, SkyParams::ALL, &Exec::new(1).unwrap()).unwrap()
}

/// The sky under a skyline that is written down: radians at each azimuth, the same for every texel.
pub(crate) fn under_skyline(field: &HeightField, directions: u32, skyline: impl Fn(f64) -> f64) -> SkyMap {
    let exec = Exec::new(1).unwrap();
    let mut sky = SkyAccumulator::new(field, &Azimuths::full_circle(directions), SkyParams::ALL).unwrap();
    for direction in 0..directions {
        let elevation = skyline(TAU * f64::from(direction) / f64::from(directions)) as f32;
        sky.add(direction, &vec![elevation; field.grid().texels()], &exec);
    }
    sky.finish(&exec).unwrap()
}

/// The sky of one texel as baked, with what the tables leave out.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sky {
    pub(crate) visibility: f64,
    pub(crate) bent_normal: [f64; 3],
    pub(crate) cone_axis: [f64; 3],
    pub(crate) half_angle: f64,
}

pub(crate) fn at(map: &SkyMap, (column, row): (u32, u32)) -> Sky {
    let texel = (row * map.grid.width + column) as usize;
    let bent = &map.bent_normal.as_ref().unwrap()[2 * texel..][..2];
    let (u, v) = (f64::from(bent[0]), f64::from(bent[1]));
    let cone: Vec<f64> =
        map.aperture_cone.as_ref().unwrap()[4 * texel..][..4].iter().map(|&value| f64::from(value)).collect();
    Sky {
        visibility: f64::from(map.visibility.as_ref().unwrap()[texel]),
        bent_normal: [u, v, (1.0 - u * u - v * v).max(0.0).sqrt()],
        cone_axis: [cone[0], cone[1], cone[2]],
        half_angle: cone[3].acos(),
    }
}

/// Between two unit vectors, in radians; exact also where they nearly agree.
pub(crate) fn angle(a: [f64; 3], b: [f64; 3]) -> f64 {
    let difference: f64 = (0..3).map(|axis| (a[axis] - b[axis]).powi(2)).sum();
    2.0 * (0.5 * difference.sqrt()).min(1.0).asin()
}

#[track_caller]
pub(crate) fn assert_near(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance, "{found} instead of {expected}, off by {:e}", found - expected);
}

#[track_caller]
pub(crate) fn assert_towards(found: [f64; 3], expected: [f64; 3], tolerance: f64) {
    let off = angle(found, expected);
    assert!(off <= tolerance, "{found:?} instead of {expected:?}, off by {off:e} radians");
}

/// Every value finite and in the range its documentation gives.
#[track_caller]
pub(crate) fn assert_in_range(map: &SkyMap) {
    let unit = |range: &[f32]| range.iter().map(|&x| f64::from(x) * f64::from(x)).sum::<f64>();
    assert!(map.visibility.as_ref().unwrap().iter().all(|visibility| (0.0..=1.0).contains(visibility)));
    for bent in map.bent_normal.as_ref().unwrap().chunks(2) {
        assert!(unit(bent) <= 1.0 + 1e-6, "{bent:?}");
    }
    for cone in map.aperture_cone.as_ref().unwrap().chunks(4) {
        assert!((unit(&cone[..3]) - 1.0).abs() < 1e-6 && cone[2] >= 0.0, "{cone:?}");
        assert!((0.0..=1.0).contains(&cone[3]), "{cone:?}");
    }
}
