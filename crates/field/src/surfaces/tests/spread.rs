//! Tessellations: evenly spread by area, and as long and thin as was asked for.

use super::*;

/// Mean and relative deviation.
fn spread(values: &[f64]) -> (f64, f64) {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let variance = values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / values.len() as f64;
    (mean, variance.sqrt() / mean)
}

fn lengths_of_edges(found: &TessellatedSurface) -> Vec<f64> {
    let sides = |triangle: &[u32; 3]| {
        let [a, b, c] = corners_of(found, triangle).map(|(position, _)| position);
        [(b - a).length(), (c - b).length(), (a - c).length()]
    };
    found.mesh.triangles().iter().flat_map(sides).collect()
}

#[test]
fn jittered_meshes_are_even_on_the_surface() {
    for surface in ParametricSurface::examples() {
        let found = mesh_of(&surface, 4000, Pattern::Jittered);
        let (_, deviation) = spread(&lengths_of_edges(&found));
        assert!(deviation < 0.32, "{}: edges vary by {deviation}", surface.name());
    }
}

#[test]
fn random_meshes_have_as_many_vertices_here_as_there() {
    // The half of each surface with v below the median of area must hold half of the vertices.
    for (name, median) in [("sphere", 0.5), ("torus", 0.5), ("cylinder", 0.5), ("saddle", 0.5)] {
        let found = mesh_of(&example(name), 10_000, Pattern::Random);
        let below = found.parameters.iter().filter(|at| at.y < median).count();
        assert!((4700..=5300).contains(&below), "{name}: {below}");
    }
    // A quarter of a sphere's area lies within 60° of a pole, and a torus has more outside than inside: (π + 2 m/M) / 2π.
    let sphere = mesh_of(&example("sphere"), 10_000, Pattern::Random);
    let polar = sphere.parameters.iter().filter(|at| at.y > 2.0 / 3.0).count();
    assert!((2350..=2650).contains(&polar), "{polar}");
    let torus = mesh_of(&example("torus"), 10_000, Pattern::Random);
    let outside = torus.mesh.positions().iter().filter(|p| p.truncate().length() > 1.0).count() as f64 / 10_000.0;
    assert_close(outside, 0.5 + 0.4 / std::f64::consts::PI, 0.015);
}

#[test]
fn steep_ground_has_its_share_of_vertices() {
    // z = 2 x² along x, nearly level along y: the area up to x grows as (asinh 4x + 4x √(1 + 16x²)) / 8.
    let valley = ParametricSurface::Saddle { valley_radius: 0.25, ridge_radius: 1e6, size: 2.0 };
    let length = |x: f64| ((4.0 * x).asinh() + 4.0 * x * (1.0 + 16.0 * x * x).sqrt()) / 8.0;
    for pattern in [Pattern::Random, Pattern::Jittered] {
        let found = mesh_of(&valley, 20_000, pattern);
        let gentle = found.mesh.positions().iter().filter(|p| p.x.abs() < 0.5).count() as f64;
        assert_close(gentle / found.parameters.len() as f64, length(0.5) / length(1.0), 0.02);
    }
}

/// Longest side over the height above it.
fn aspects(found: &TessellatedSurface) -> Vec<f64> {
    let aspect = |triangle: &[u32; 3]| {
        let [a, b, c] = corners_of(found, triangle).map(|(position, _)| position);
        let longest = (b - a).length_squared().max((c - b).length_squared()).max((a - c).length_squared());
        longest / (b - a).cross(c - a).length()
    };
    let mut aspects: Vec<f64> = found.mesh.triangles().iter().map(aspect).collect();
    aspects.sort_by(f64::total_cmp);
    aspects
}

#[test]
fn triangles_are_as_long_as_was_asked_for() {
    for surface in ParametricSurface::examples() {
        let median = |vertices, pattern| {
            let aspects = aspects(&mesh_of(&surface, vertices, pattern));
            aspects[aspects.len() / 2]
        };
        // Where long sides reach around a bend, triangles gain width: enough vertices keep that small.
        let long = median(16_000, Pattern::LongThin { aspect: 20.0 });
        assert!((15.0..30.0).contains(&long), "{}: {long}", surface.name());
        let regular = median(4000, Pattern::Regular { aspect: 20.0 });
        assert!((15.0..30.0).contains(&regular), "{}: {regular}", surface.name());
        assert!(median(4000, Pattern::Jittered) < 2.5, "{}", surface.name());
    }
}
