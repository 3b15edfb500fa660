//! Where the mesh is not one surface.

use core::f64::consts::TAU;
use std::collections::HashMap;

use barchan_asset::VertexFlags;
use barchan_bakers::curvature::CurvatureMethod;
use barchan_field::Mesh;
use barchan_field::surfaces::{ParametricSurface, Pattern};
use glam::DVec3;

use crate::support::{Case, assert_finite, bake_with, baked, count};

/// What the issue allows.
const MOST: f64 = 0.03;

#[test]
fn caps_that_close_t_junctions() {
    for name in ["sphere", "ellipsoid", "torus"] {
        let case = Case::example(name, Pattern::Jittered, 4000);
        let mut positions = case.mesh.positions().to_vec();
        let mut truth = case.truth.clone();
        let mut triangles = Vec::new();
        for (index, &[a, b, c]) in case.mesh.triangles().iter().enumerate() {
            if index % 100 != 0 {
                triangles.push([a, b, c]);
                continue;
            }
            // One side of the edge a b is cut, the other is not: a cap without area is between them.
            let middle = positions.len() as u32;
            positions.push(0.5 * (positions[a as usize] + positions[b as usize]));
            truth.push(truth[a as usize]);
            triangles.extend([[a, middle, c], [middle, b, c], [a, b, middle]]);
        }
        let added = case.truth.len();
        let capped = Case { mesh: Mesh::new(positions, triangles).unwrap(), truth };
        let found = baked(&capped.mesh);
        let errors = capped.errors_at(&found, |vertex| vertex < added);
        println!(
            "CAPS {name} {errors:?} of {} at caps {:?}",
            capped.truth.len() - added,
            capped.errors_at(&found, |v| v >= added)
        );
        assert!(errors.rms <= MOST, "{name}: {errors:?}");
    }
}

/// Two cases as one mesh, the second moved so that its vertex `there` lies where vertex `here` of the first is.
fn touching(first: &Case, here: usize, second: &Case, there: usize) -> Case {
    let shift = first.mesh.positions()[here] - second.mesh.positions()[there];
    let count = first.truth.len() as u32;
    // The shared place is one vertex.
    let renamed = |vertex: u32| if vertex as usize == there { here as u32 } else { vertex + count };
    let moved = second.mesh.positions().iter().map(|&position| position + shift);
    let positions = first.mesh.positions().iter().copied().chain(moved).collect();
    let triangles = second.mesh.triangles().iter().map(|corners| corners.map(renamed));
    let triangles = first.mesh.triangles().iter().copied().chain(triangles).collect();
    let truth = first.truth.iter().chain(&second.truth).copied().collect();
    Case { mesh: Mesh::new(positions, triangles).unwrap(), truth }
}

#[test]
fn sheets_that_touch_in_a_vertex_see_their_own() {
    let first = Case::of(&ParametricSurface::Torus { major: 1.0, minor: 0.4 }, Pattern::Random, 2000);
    let second = Case::of(&ParametricSurface::Sphere { radius: 0.5 }, Pattern::Random, 1000);
    let clean = first.clean().rms;
    let case = touching(&first, 700, &second, 300);
    let found = baked(&case.mesh);
    let lost = first.truth.len() + 300;
    let errors = case.errors_at(&found, |vertex| vertex != lost && vertex != 700);
    println!("BOWTIE {errors:?} clean {clean:.2e} touch {:?}", found.vertices[700]);
    assert!(errors.rms <= 1.5 * clean, "{errors:?}");
    assert!(found.vertices[700].flags.contains(VertexFlags::NON_MANIFOLD));
    // The larger sheet speaks for the shared vertex; either may be.
    let [kappa, _] = found.vertices[700].principal;
    let either = [first.truth[700].principal[0], second.truth[300].principal[0]];
    assert!(either.iter().any(|truth| (truth - kappa).abs() < MOST * truth.abs()), "{kappa}: {either:?}");
}

#[test]
fn fins_disturb_nobody() {
    let case = Case::example("torus", Pattern::Jittered, 2000);
    let mut positions = case.mesh.positions().to_vec();
    let mut triangles = case.mesh.triangles().to_vec();
    for &[a, b, c] in case.mesh.triangles().iter().step_by(50) {
        let [p, q, r] = [a, b, c].map(|vertex| positions[vertex as usize]);
        let tip = positions.len() as u32;
        // Smaller than the surface around: else the fin would speak for the vertices at its foot.
        positions.push(0.5 * (p + q) + 0.5 * (q - p).cross(r - p).normalize() * (q - p).length());
        triangles.push([a, b, tip]);
    }
    let known = case.truth.len();
    let mut truth = case.truth.clone();
    truth.resize(positions.len(), truth[0]);
    let finned = Case { mesh: Mesh::new(positions, triangles).unwrap(), truth };
    let found = baked(&finned.mesh);
    let (errors, clean) = (finned.errors_at(&found, |vertex| vertex < known), case.clean());
    println!("FINS {errors:?} clean {clean:?} edges {}", found.report.non_manifold_edges);
    assert!(found.report.non_manifold_edges >= 70);
    assert!(errors.rms <= 1.5 * clean.rms, "{errors:?}, clean {clean:?}");
}

#[test]
fn sheets_that_cross_see_their_own() {
    // Two troughs that cross along the bottom of both.
    const SIDE: u32 = 21;
    let mut places = HashMap::new();
    let mut positions = Vec::new();
    let mut triangles = Vec::new();
    for upright in [false, true] {
        let mut at = |column: u32, row: u32| {
            let (across, along) = (f64::from(column) - 10.0, f64::from(row));
            let rise = 0.02 * across * across;
            let point = if upright { DVec3::new(rise, along, across) } else { DVec3::new(across, along, rise) };
            *places.entry(point.to_array().map(f64::to_bits)).or_insert_with(|| {
                positions.push(point);
                positions.len() as u32 - 1
            })
        };
        for row in 0..SIDE - 1 {
            for column in 0..SIDE - 1 {
                let [a, b, c, d] = [at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)];
                triangles.extend([[a, b, c], [a, c, d]]);
            }
        }
    }
    let found = baked(&Mesh::new(positions.clone(), triangles).unwrap());
    assert_finite(&found);
    assert_eq!(found.report.non_manifold_edges, u64::from(SIDE) - 1);
    let mut crossed = 0;
    for (position, vertex) in positions.iter().zip(&found.vertices) {
        let inside = (5.0..=15.0).contains(&position.y) && position.x.abs().max(position.z.abs()) < 5.0;
        if inside {
            // κ of a parabola of second derivative .04.
            let across = if position.x.abs() > position.z.abs() { position.x } else { position.z };
            let expected = 0.04 / (1.0 + 0.0016 * across * across).powf(1.5);
            let largest = vertex.principal[0].abs().max(vertex.principal[1].abs());
            assert!((largest - expected).abs() <= MOST * expected, "{position}: {vertex:?}, not {expected}");
            crossed += usize::from(vertex.flags.contains(VertexFlags::NON_MANIFOLD));
        }
    }
    assert!(crossed > 5);
}

#[test]
fn a_moebius_strip_is_cut_somewhere() {
    const AROUND: u32 = 80;
    const ACROSS: u32 = 7;
    let mut positions = Vec::new();
    for step in 0..AROUND {
        let angle = TAU * f64::from(step) / f64::from(AROUND);
        for row in 0..ACROSS {
            let (offset, half) = (0.08 * (f64::from(row) - 3.0), 0.5 * angle);
            let radius = 1.0 + offset * libm::cos(half);
            positions.push(DVec3::new(radius * libm::cos(angle), radius * libm::sin(angle), offset * libm::sin(half)));
        }
    }
    // After one turn the strip is upside down.
    let at = |step: u32, row: u32| if step < AROUND { step * ACROSS + row } else { ACROSS - 1 - row };
    let triangles = (0..AROUND).flat_map(|step| {
        (0..ACROSS - 1).flat_map(move |row| {
            let [a, b, c, d] = [at(step, row), at(step + 1, row), at(step + 1, row + 1), at(step, row + 1)];
            [[a, b, c], [a, c, d]]
        })
    });
    let strip = Mesh::new(positions, triangles.collect()).unwrap();
    for method in CurvatureMethod::ALL {
        let found = bake_with(&strip, method, 1);
        assert_finite(&found);
        assert_eq!(found.report.unorientable_edges, u64::from(ACROSS) - 1);
        assert_eq!(count(&found, VertexFlags::DEGENERATE), 0);
        // Gaussian curvature has no side: along the middle of this strip it is −1/4.
        for step in 5..AROUND - 5 {
            let [first, second] = found.vertices[(step * ACROSS + 3) as usize].principal;
            assert!((first * second + 0.25).abs() < 0.02, "{method:?} at {step}: {first}, {second}");
        }
    }
}
