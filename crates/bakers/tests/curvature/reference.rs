//! The baker beside its slow twin.

use barchan_bakers::curvature::reference::curvature_at;
use barchan_field::Mesh;
use barchan_field::surfaces::{ParametricSurface, Pattern};
use glam::DVec3;

use crate::support::{Case, baked, random, root_mean_square};

/// Errors of every 40th vertex, by the twin.
fn slowly(case: &Case, degree: usize, neighbours: usize) -> f64 {
    let asked = (0..case.truth.len()).step_by(case.truth.len() / 100);
    let scale = root_mean_square(case.truth.iter().map(|truth| truth.principal[0].abs().max(truth.principal[1].abs())));
    root_mean_square(asked.flat_map(|vertex| {
        let found = curvature_at(&case.mesh, vertex, degree, neighbours).expect("a surface");
        [0, 1].map(|k| (found.principal[k] - case.truth[vertex].principal[k]) / scale)
    }))
}

#[test]
fn the_twin_converges_as_its_theory_says() {
    for name in ["ellipsoid", "torus"] {
        for (degree, neighbours) in [(2, 12), (3, 20), (4, 30)] {
            let [coarse, fine] = [1000, 4000]
                .map(|vertices| slowly(&Case::example(name, Pattern::Jittered, vertices), degree, neighbours));
            let order = (coarse / fine).log2();
            println!("TWIN {name} {degree} {coarse:.2e} {fine:.2e} {order:.2}");
            // At least d − 1; even degrees gain one where neighbours lie evenly.
            assert!(order > degree as f64 - 1.3, "{name}, degree {degree}: {coarse}, {fine}");
        }
    }
}

#[test]
fn the_baker_agrees_with_its_twin_as_well_as_either_with_the_truth() {
    for surface in ParametricSurface::examples() {
        let case = Case::of(&surface, Pattern::Jittered, 4000);
        let scale =
            root_mean_square(case.truth.iter().map(|truth| truth.principal[0].abs().max(truth.principal[1].abs())));
        let found = baked(&case.mesh);
        let asked = (7..case.truth.len()).step_by(case.truth.len() / 60);
        let apart = root_mean_square(asked.filter(|&vertex| found.vertices[vertex].flags.0 == 0).flat_map(|vertex| {
            let slow = curvature_at(&case.mesh, vertex, 6, 44).expect("a surface");
            let fast = &found.vertices[vertex];
            assert!(slow.normal.dot(fast.normal) > 1.0 - 1e-5, "{}: {slow:?}, {fast:?}", surface.name());
            [0, 1].map(|k| (slow.principal[k] - fast.principal[k]) / scale)
        }));
        println!("APART {} {apart:.2e}", surface.name());
        assert!(apart <= 1e-3, "{}: {apart}", surface.name());
    }
}

#[test]
fn a_paraboloid_is_a_polynomial() {
    let mut random = random(1);
    let mut positions = vec![DVec3::ZERO];
    let height = |x: f64, y: f64| -0.5 * x * x + 0.3 * x * y + 0.25 * y * y;
    for _ in 0..30 {
        let (x, y) = (2.0 * random() - 1.0, 2.0 * random() - 1.0);
        positions.push(DVec3::new(x, y, height(x, y)));
    }
    // Only the normal matters, and that not exactly.
    positions.extend([DVec3::new(0.1, 0.0, height(0.1, 0.0)), DVec3::new(0.0, 0.1, height(0.0, 0.1))]);
    positions.extend([DVec3::new(-0.1, 0.0, height(-0.1, 0.0)), DVec3::new(0.0, -0.1, height(0.0, -0.1))]);
    let mesh = Mesh::new(positions, vec![[0, 31, 32], [0, 32, 33], [0, 33, 34], [0, 34, 31]]).unwrap();
    let found = curvature_at(&mesh, 0, 2, 34).unwrap();
    // Eigenvalues of minus the Hessian, (1, −.3; −.3, −.5).
    let spread = (0.75_f64 * 0.75 + 0.09).sqrt();
    println!("PARAB {:?} {:?}", found.principal, [0.25 + spread, 0.25 - spread]);
    for (found, expected) in found.principal.iter().zip([0.25 + spread, 0.25 - spread]) {
        assert!((found - expected).abs() < 1e-9, "{found}, not {expected}");
    }
}

#[test]
fn too_few_vertices_say_nothing() {
    let case = Case::example("sphere", Pattern::Jittered, 16);
    assert!(curvature_at(&case.mesh, 0, 4, 30).is_none());
}
