//! The fundamental forms of a surface in texture coordinates.

use crate::{f32_at_least, f32_at_most};

/// The first and the second fundamental form at a vertex, in the chart of its texture coordinates (u, v).
///
/// Along (du, dv) the normal curvature is κ = (e du² + 2f du dv + g dv²) / (E du² + 2F du dv + G dv²).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceForms {
    /// E, F, G in length unit² per texture unit²: E > 0 and EG − F² > 0.
    pub first: [f32; 3],
    /// e, f, g in length unit per texture unit², positive where convex seen from the front.
    pub second: [f32; 3],
}

impl SurfaceForms {
    /// The nearest forms in f32. Where they would leave the first form not positive, which the given one is, E and G are
    /// rounded up and F towards zero.
    #[must_use]
    pub fn nearest(first: [f64; 3], second: [f64; 3]) -> Self {
        let forms = Self { first: first.map(|number| number as f32), second: second.map(|number| number as f32) };
        if forms.is_positive() {
            return forms;
        }
        let [e, f, g] = first;
        let towards_zero = f32_at_most(f.abs()).copysign(f as f32);
        Self { first: [f32_at_least(e), towards_zero, f32_at_least(g)], ..forms }
    }

    /// Whether every direction has a length: E > 0 and EG − F² > 0, to the bit.
    #[must_use]
    pub fn is_positive(&self) -> bool {
        let [e, f, g] = self.first.map(f64::from);
        e > 0.0 && e * g > f * f
    }
}
