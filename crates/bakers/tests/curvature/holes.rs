//! Holes: part of the surface is not there.

use barchan_asset::VertexFlags;
use barchan_field::surfaces::Pattern;

use crate::support::{Case, baked};

/// The case without the triangles that touch a vertex near one of three others; and the distance of every vertex to the nearest hole's
/// middle, in mean edges.
fn pierced(case: &Case) -> (Case, Vec<f64>) {
    let positions = case.mesh.positions();
    let edge = baked(&case.mesh).report.mean_edge;
    let middles = [100, 900, 1700].map(|vertex: usize| positions[vertex]);
    let distances: Vec<f64> = positions
        .iter()
        .map(|position| middles.iter().map(|middle| middle.distance(*position)).fold(f64::INFINITY, f64::min) / edge)
        .collect();
    let kept = case.mesh.triangles().iter().filter(|corners| corners.iter().all(|&c| distances[c as usize] > 2.0));
    (case.with_triangles(kept.copied().collect()), distances)
}

#[test]
fn far_from_a_hole_nothing_changes() {
    for name in ["ellipsoid", "torus", "helicoid", "bezier_patch"] {
        let case = Case::example(name, Pattern::Random, 2000);
        let (pierced, distances) = pierced(&case);
        let (whole, found) = (baked(&case.mesh), baked(&pierced.mesh));
        for (vertex, distance) in distances.iter().enumerate().filter(|(_, distance)| **distance > 14.0) {
            let [a, b] = [found.vertices[vertex].principal, whole.vertices[vertex].principal];
            assert!((a[0] - b[0]).abs() + (a[1] - b[1]).abs() < 1e-9, "{name} at {distance}: {a:?}, {b:?}");
        }
    }
}

#[test]
fn at_the_rim_of_a_hole_the_surface_is_followed_from_one_side() {
    for name in ["ellipsoid", "torus", "helicoid", "bezier_patch"] {
        let case = Case::example(name, Pattern::Random, 2000);
        let (pierced, distances) = pierced(&case);
        let found = baked(&pierced.mesh);
        let flags = |vertex: usize| found.vertices[vertex].flags;
        let rim = |vertex: usize| distances[vertex] < 6.0 && flags(vertex).contains(VertexFlags::BOUNDARY);
        let errors = pierced.errors_at(&found, rim);
        let inside = pierced.errors_at(&found, |vertex| !flags(vertex).is_unknown() && !rim(vertex));
        let clean = case.clean();
        println!(
            "HOLE {name} rim {errors:?} inside {:.2e} clean {:.2e} ratio {:.2}",
            inside.rms,
            clean.rms,
            inside.rms / clean.rms
        );
        assert!(errors.rms > 0.0 && errors.rms <= 5e-3, "{name}: {errors:?}");
        assert!(inside.rms <= 1.5 * clean.rms, "{name}: {inside:?}, clean {clean:?}");
    }
}
