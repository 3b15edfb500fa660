//! Textbook curvatures, derivatives against differences, sound and even meshes, seams, noise, recipes.

mod geometry;
mod meshes;
mod noise;
mod recipes;

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
