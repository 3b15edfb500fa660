//! Textbook curvatures, derivatives against differences, sound and even meshes, seams, noise, recipes.

mod geometry;
mod meshes;
mod noise;
mod recipes;
mod seams;
mod spread;

use glam::DVec2;

use super::*;

fn example(name: &str) -> ParametricSurface {
    ParametricSurface::examples().into_iter().find(|surface| surface.name() == name).unwrap()
}

/// Parameters all over the surface, off the poles and off anything special.
fn parameters() -> impl Iterator<Item = (f64, f64)> {
    (0..40).map(|i| ((f64::from(i) * 0.618_034 + 0.013).fract(), 0.02 + 0.96 * (f64::from(i) * 0.754_878).fract()))
}

#[track_caller]
fn assert_close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance, "{found}, not {expected} ± {tolerance:e}");
}

fn mesh_of(surface: &ParametricSurface, vertices: u32, pattern: Pattern) -> TessellatedSurface {
    let tessellation = Tessellation { vertices, pattern, seed: 5, uv_seam: false };
    surface.tessellate(&tessellation).unwrap_or_else(|error| panic!("{pattern:?}: {error}"))
}

/// Where the corners of a triangle lie, in space and on the surface.
fn corners_of(found: &TessellatedSurface, triangle: &[u32; 3]) -> [(DVec3, DVec2); 3] {
    triangle.map(|vertex| (found.mesh.positions()[vertex as usize], found.parameters[vertex as usize]))
}
