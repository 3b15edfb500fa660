//! Vertices that lie off the surface.

use barchan_field::Mesh;
use barchan_field::surfaces::{ParametricSurface, Pattern, with_vertex_noise};

use crate::support::{Case, baked};

#[test]
fn a_tenth_of_an_edge() {
    for surface in ParametricSurface::examples() {
        let clean = Case::of(&surface, Pattern::Random, 4000);
        let edge = baked(&clean.mesh).report.mean_edge;
        let mesh = with_vertex_noise(&clean.mesh, 0.1 * edge, 5).unwrap();
        let noisy = Case { mesh, truth: clean.truth };
        let found = baked(&noisy.mesh);
        let errors = noisy.errors(&found);
        assert!((0.09..0.11).contains(&(found.noise / edge)), "{}: {}", surface.name(), found.noise / edge);
        // Two waves on 63 vertices leave no room to average; an edge of the surface has half as many neighbours.
        let (most, tail) = match surface.name() {
            "wavy_sheet" => (0.15, 12.0),
            _ => (0.1, 12.0),
        };
        assert!(errors.rms <= most, "{}: {errors:?}", surface.name());
        assert!(errors.max <= tail * errors.rms, "{}: {errors:?}", surface.name());
    }
}

#[test]
fn noise_is_told_at_any_scale() {
    let clean = Case::example("ellipsoid", Pattern::Random, 1000);
    let mesh = with_vertex_noise(&clean.mesh, 0.005, 5).unwrap();
    let found = baked(&mesh);
    assert!(found.noise > 0.0);
    for scale in [2.0_f64.powi(40), 2.0_f64.powi(-40)] {
        let positions = mesh.positions().iter().map(|&position| position * scale).collect();
        let scaled = baked(&Mesh::new(positions, mesh.triangles().to_vec()).unwrap());
        for (scaled, found) in scaled.vertices.iter().zip(&found.vertices) {
            for (scaled, found) in scaled.principal.into_iter().zip(found.principal) {
                assert!((scaled * scale - found).abs() < 1e-9, "{scale:e}: {} instead of {found}", scaled * scale);
            }
        }
    }
}
