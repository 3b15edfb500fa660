//! A vertex with a hundred thousand triangles.

use core::f64::consts::TAU;
use std::time::Instant;

use barchan_bakers::curvature::CurvatureMethod;
use barchan_field::Mesh;
use glam::DVec3;

use crate::support::{assert_finite, bake_with, baked, root_mean_square};

const MANY: u32 = 100_000;

fn on_circle(polar: f64, step: u32, steps: u32) -> DVec3 {
    let angle = TAU * f64::from(step) / f64::from(steps);
    DVec3::new(libm::sin(polar) * libm::cos(angle), libm::sin(polar) * libm::sin(angle), libm::cos(polar))
}

#[test]
fn a_fan_does_not_hang() {
    let mut positions = vec![DVec3::Z];
    positions.extend((0..MANY).map(|step| on_circle(0.5, step, MANY)));
    let triangles: Vec<[u32; 3]> = (0..MANY).map(|step| [0, 1 + step, 1 + (step + 1) % MANY]).collect();
    let fan = Mesh::new(positions, triangles).unwrap();
    for method in CurvatureMethod::ALL {
        let start = Instant::now();
        let found = bake_with(&fan, method, 1);
        assert_finite(&found);
        let hub = found.vertices[0];
        assert!(hub.principal.iter().all(|curvature| (curvature - 1.0).abs() < 1e-4), "{hub:?}");
        for rim in &found.vertices[1..] {
            // The neighbours of a rim point lie on one line: they tell a curvature of the right size, and no more.
            assert!(rim.principal.iter().all(|curvature| (curvature - 1.0).abs() < 0.7), "{rim:?}");
        }
        // Far above what it takes: what walks around the hub once per triangle takes hours.
        assert!(start.elapsed().as_secs() < 60, "{method:?} took {:?}", start.elapsed());
    }
}

/// The northern half of a ball of radius 1. The pole has a hundred thousand neighbours; all else is rings of 96.
fn ball_with_hub() -> (Mesh, usize) {
    const AROUND: u32 = 96;
    const RINGS: u32 = 24;
    let mut positions = vec![DVec3::Z];
    positions.extend((0..MANY).map(|step| on_circle(0.06, step, MANY)));
    let ordinary = positions.len();
    let polar = |ring: u32| 0.06 + 0.0625 * f64::from(ring + 1);
    positions.extend((0..RINGS).flat_map(|ring| (0..AROUND).map(move |step| on_circle(polar(ring), step, AROUND))));
    let mut triangles: Vec<[u32; 3]> = (0..MANY).map(|step| [0, 1 + step, 1 + (step + 1) % MANY]).collect();
    let at = |ring: u32, step: u32| ordinary as u32 + ring * AROUND + step % AROUND;
    // From the hub's rim to the first ordinary ring.
    for step in 0..MANY {
        let [near, next] = [step, step + 1].map(|step| (2 * step * AROUND / MANY).div_ceil(2) % AROUND);
        triangles.push([1 + step, at(0, near), 1 + (step + 1) % MANY]);
        if near != next {
            triangles.push([at(0, near), at(0, next), 1 + (step + 1) % MANY]);
        }
    }
    for ring in 0..RINGS - 1 {
        for step in 0..AROUND {
            let [a, b] = [at(ring, step), at(ring, step + 1)];
            let [c, d] = [at(ring + 1, step), at(ring + 1, step + 1)];
            triangles.extend([[a, c, d], [a, d, b]]);
        }
    }
    (Mesh::new(positions, triangles).unwrap(), ordinary)
}

#[test]
fn a_hub_in_an_ordinary_mesh_disturbs_nobody() {
    let (mesh, ordinary) = ball_with_hub();
    let found = baked(&mesh);
    assert_finite(&found);
    let off = |range: core::ops::Range<usize>| {
        root_mean_square(found.vertices[range].iter().flat_map(|vertex| vertex.principal.map(|k| k - 1.0)))
    };
    assert!(off(0..1) < 1e-6);
    // Along the rim the neighbours lie on a line: a hundred thousand points that say little.
    let rim = off(1..ordinary);
    assert!(rim < 0.7, "{rim}");
    assert!(off(ordinary..found.vertices.len()) < 5e-3);
}
