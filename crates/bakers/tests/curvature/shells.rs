//! Two sides that nearly touch are two sides.

use barchan_field::Mesh;
use barchan_field::surfaces::{ParametricSurface, Pattern};
use glam::DVec3;

use crate::support::{Case, assert_finite, baked};

/// A hollow ball of radius 1 whose wall is `thickness` thick: outside first, then inside, which faces inwards.
fn shell(thickness: f64) -> Case {
    let outside = Case::of(&ParametricSurface::Sphere { radius: 1.0 }, Pattern::Random, 2000);
    let count = outside.mesh.positions().len() as u32;
    let inside = outside.mesh.positions().iter().map(|&position| position * (1.0 - thickness));
    let positions = outside.mesh.positions().iter().copied().chain(inside).collect();
    let turned = outside.mesh.triangles().iter().map(|&[a, b, c]| [a + count, c + count, b + count]);
    let triangles = outside.mesh.triangles().iter().copied().chain(turned).collect();
    let mut truth = outside.truth.clone();
    for mut curvature in outside.truth {
        curvature.principal = [-1.0 / (1.0 - thickness); 2];
        truth.push(curvature);
    }
    Case { mesh: Mesh::new(positions, triangles).unwrap(), truth }
}

#[test]
fn a_thousandth_of_an_edge_apart() {
    let thickness = 1e-3 * baked(&shell(0.1).mesh).report.mean_edge;
    let case = shell(thickness);
    let found = baked(&case.mesh);
    let errors = case.errors(&found);
    println!("SHELL {errors:?}");
    assert!(errors.rms <= 1e-6, "{errors:?}");
}

#[test]
fn a_thin_plate_with_a_rim_keeps_its_sides_flat() {
    // 24 × 24 cells above, as many below, sewn together along the rim.
    const SIDE: u32 = 25;
    let at = |column: u32, row: u32| row * SIDE + column;
    let mut positions = Vec::new();
    for z in [0.5e-3, -0.5e-3] {
        for row in 0..SIDE {
            positions.extend((0..SIDE).map(|column| DVec3::new(f64::from(column), f64::from(row), z)));
        }
    }
    let mut triangles = Vec::new();
    let below = SIDE * SIDE;
    for row in 0..SIDE - 1 {
        for column in 0..SIDE - 1 {
            let [a, b, c, d] = [at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)];
            triangles.extend([
                [a, b, c],
                [a, c, d],
                [a + below, c + below, b + below],
                [a + below, d + below, c + below],
            ]);
        }
    }
    let last = SIDE - 1;
    let rim = (0..last).flat_map(|k| [[at(k, 0), at(k + 1, 0)], [at(last, k), at(last, k + 1)]]);
    let rim = rim.chain((0..last).flat_map(|k| [[at(k + 1, last), at(k, last)], [at(0, k + 1), at(0, k)]]));
    for [a, b] in rim {
        triangles.extend([[b, a, a + below], [b, a + below, b + below]]);
    }
    let found = baked(&Mesh::new(positions, triangles).unwrap());
    assert_finite(&found);
    for row in 9..SIDE - 9 {
        for vertex in [at(12, row), at(12, row) + below] {
            let curvature = found.vertices[vertex as usize];
            assert!(curvature.principal[0].abs().max(curvature.principal[1].abs()) < 1e-9, "{curvature:?}");
            assert!(curvature.normal.z * (if vertex < below { 1.0 } else { -1.0 }) > 0.999_999);
        }
    }
}
