//! Very small, very large, very far away.

use barchan_field::Mesh;
use barchan_field::surfaces::Pattern;
use glam::DVec3;

use crate::support::{Case, baked};

fn moved(case: &Case, place: impl Fn(DVec3) -> DVec3) -> Mesh {
    let positions = case.mesh.positions().iter().map(|&position| place(position)).collect();
    Mesh::new(positions, case.mesh.triangles().to_vec()).unwrap()
}

#[test]
fn curvature_is_the_inverse_of_scale() {
    // At a border a jet of degree eight looks outwards, and rounding is a million times as loud.
    for (name, most) in [("sphere", 1e-9), ("torus", 1e-9), ("helicoid", 1e-4), ("bezier_patch", 1e-5)] {
        let case = Case::example(name, Pattern::Random, 1000);
        let clean = baked(&case.mesh);
        let largest = clean.vertices.iter().fold(0.0_f64, |most, vertex| most.max(vertex.principal[0].abs()));
        for scale in [1e-6, 1e6, 1e-12, 1e12] {
            let found = baked(&moved(&case, |position| position * scale));
            for (found, clean) in found.vertices.iter().zip(&clean.vertices) {
                for (found, clean) in found.principal.iter().zip(clean.principal) {
                    let error = (found * scale - clean).abs() / largest;
                    assert!(error <= most, "{name} times {scale}: {} for {clean}", found * scale);
                }
                assert_eq!(found.flags, clean.flags);
            }
        }
    }
}

#[test]
fn far_from_the_origin_the_digits_that_are_left_are_used() {
    for name in ["sphere", "torus", "helicoid", "bezier_patch"] {
        let case = Case::example(name, Pattern::Random, 2000);
        let clean = case.clean().rms;
        // An edge of 0.05 has 25 million steps of 2e-9 there.
        let found = case.errors(&baked(&moved(&case, |position| position + DVec3::new(1e7, -1e7, 1e7)))).rms;
        println!("OFFSET {name} {clean:.2e} {found:.2e} ratio {:.2}", found / clean);
        assert!(found <= (1.5 * clean).max(1e-6), "{name}: {found}, clean {clean}");
    }
}
