//! Vertices moved at random.

use super::*;
use crate::Mesh;

fn sheet() -> Mesh {
    let tessellation = Tessellation { vertices: 20_000, pattern: Pattern::Random, seed: 1, uv_seam: false };
    example("saddle").tessellate(&tessellation).unwrap().mesh
}

#[test]
fn errors_have_the_deviation_asked_for_along_every_axis() {
    let (mesh, sigma) = (sheet(), 0.25);
    let noisy = with_vertex_noise(&mesh, sigma, 3).unwrap();
    let errors: Vec<DVec3> = noisy.positions().iter().zip(mesh.positions()).map(|(a, b)| *a - *b).collect();
    let mean = |value: &dyn Fn(&DVec3) -> f64| errors.iter().map(value).sum::<f64>() / errors.len() as f64;
    for axis in 0..3 {
        assert_close(mean(&|e| e[axis]), 0.0, 0.01);
        assert_close(mean(&|e| e[axis].powi(2)).sqrt(), sigma, 0.01);
        // The fourth moment of a bell is three times the square of the second.
        assert_close(mean(&|e| e[axis].powi(4)) / sigma.powi(4), 3.0, 0.3);
        assert_close(mean(&|e| e[axis] * e[(axis + 1) % 3]), 0.0, 0.003);
    }
}

#[test]
fn everything_but_positions_stays() {
    let normals = vec![DVec3::Z; sheet().positions().len()];
    let mesh = sheet().with_normals(normals).unwrap();
    let noisy = with_vertex_noise(&mesh, 0.1, 3).unwrap();
    assert_eq!(noisy.triangles(), mesh.triangles());
    assert_eq!((noisy.uvs(), noisy.normals()), (mesh.uvs(), mesh.normals()));
    assert!(mesh.uvs().is_some());
}

#[test]
fn no_noise_is_the_mesh_and_each_seed_another() {
    let mesh = sheet();
    assert_eq!(with_vertex_noise(&mesh, 0.0, 1).unwrap(), mesh);
    let of_seed = |seed| with_vertex_noise(&mesh, 0.1, seed).unwrap();
    assert_eq!(of_seed(1), of_seed(1));
    assert_ne!(of_seed(1), of_seed(2));
}

#[test]
fn noise_without_measure_is_refused() {
    for sigma in [-0.1, f64::NAN, f64::INFINITY] {
        let error = with_vertex_noise(&sheet(), sigma, 1).unwrap_err().to_string();
        assert!(error.starts_with("vertex noise: sigma is"), "{error}");
    }
}
