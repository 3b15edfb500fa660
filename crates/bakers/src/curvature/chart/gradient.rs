//! Derivatives of texture coordinates on the tangent plane.
//!
//! A polynomial without a constant, as its value at the vertex is known, of degree 2 or 1 in (x, y); least squares, each equation
//! divided by its distance, so that near vertices count most. Columns are brought to length 1 before the normal equations are
//! factored: then pivots tell how independent the columns are, whatever the shape of the triangles.

use glam::DVec2;

/// Terms of a polynomial: x, y, x², xy, y².
const TERMS: usize = 5;

/// What a vertex around says.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sample {
    /// Where it is on the tangent plane.
    pub(super) at: DVec2,
    /// How far away it is in space.
    pub(super) distance: f64,
    /// By how much its texture coordinates differ.
    pub(super) uv: DVec2,
}

/// Degree of the polynomial, by how many of its terms are used.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Degree {
    Linear = 2,
    Quadratic = 5,
}

/// ∂(u, v)/∂x and ∂(u, v)/∂y at the vertex; `None` where a pivot is below `least`, at most 1, so that samples do not determine them.
pub(super) fn gradient(samples: &[Sample], degree: Degree, least: f64) -> Option<[DVec2; 2]> {
    let terms = degree as usize;
    if samples.len() < terms {
        return None;
    }
    let radius = samples.iter().map(|sample| sample.distance).fold(0.0, f64::max);
    let (mut matrix, mut right) = normal_equations(samples, terms, radius);
    let lengths: [f64; TERMS] = core::array::from_fn(|term| if term < terms { matrix[term][term].sqrt() } else { 1.0 });
    for row in 0..terms {
        for column in 0..terms {
            matrix[row][column] /= lengths[row] * lengths[column];
        }
        right[row] /= lengths[row];
    }
    let solution = solve(matrix, right, terms, least)?;
    Some([0, 1].map(|term| solution[term] / (lengths[term] * radius)))
}

type Matrix = [[f64; TERMS]; TERMS];

fn normal_equations(samples: &[Sample], terms: usize, radius: f64) -> (Matrix, [DVec2; TERMS]) {
    let (mut matrix, mut right) = (Matrix::default(), [DVec2::ZERO; TERMS]);
    for sample in samples {
        let DVec2 { x, y } = sample.at / radius;
        let weight = radius / sample.distance;
        let equation = [x, y, x * x, x * y, y * y].map(|term| weight * term);
        for row in 0..terms {
            for column in 0..terms {
                matrix[row][column] += equation[row] * equation[column];
            }
            right[row] += sample.uv * (weight * equation[row]);
        }
    }
    (matrix, right)
}

/// Cholesky's factorisation of a matrix with ones on its diagonal, then both substitutions.
fn solve(mut matrix: Matrix, mut right: [DVec2; TERMS], terms: usize, least: f64) -> Option<[DVec2; TERMS]> {
    for pivot in 0..terms {
        let left: f64 = matrix[pivot][..pivot].iter().map(|entry| entry * entry).sum();
        let squared = matrix[pivot][pivot] - left;
        // Not a number where a column is all zero.
        if squared.is_nan() || squared < least {
            return None;
        }
        matrix[pivot][pivot] = squared.sqrt();
        for row in pivot + 1..terms {
            let dot: f64 = (0..pivot).map(|column| matrix[row][column] * matrix[pivot][column]).sum();
            matrix[row][pivot] = (matrix[row][pivot] - dot) / matrix[pivot][pivot];
        }
    }
    for row in 0..terms {
        for column in 0..row {
            right[row] -= right[column] * matrix[row][column];
        }
        right[row] /= matrix[row][row];
    }
    for row in (0..terms).rev() {
        for below in row + 1..terms {
            right[row] -= right[below] * matrix[below][row];
        }
        right[row] /= matrix[row][row];
    }
    Some(right)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn samples(points: &[[f64; 2]], uv: impl Fn(f64, f64) -> DVec2) -> Vec<Sample> {
        let sample = |&[x, y]: &[f64; 2]| Sample { at: DVec2::new(x, y), distance: x.hypot(y), uv: uv(x, y) };
        points.iter().map(sample).collect()
    }

    const AROUND: [[f64; 2]; 6] = [[1.0, 0.1], [0.4, 0.9], [-0.6, 0.8], [-1.1, 0.0], [-0.5, -0.7], [0.6, -0.9]];

    #[test]
    fn a_quadratic_is_found_exactly_at_any_scale() {
        let uv = |x: f64, y: f64| DVec2::new(2.0 * x - y + 0.3 * x * y - y * y, 0.5 * y + x * x);
        for scale in [1e-9, 1.0, 1e9] {
            let around = AROUND.map(|at| at.map(|coordinate| coordinate * scale));
            let found = gradient(&samples(&around, |x, y| uv(x / scale, y / scale)), Degree::Quadratic, 0.01).unwrap();
            assert!((found[0] * scale - DVec2::new(2.0, 0.0)).length() < 1e-12);
            assert!((found[1] * scale - DVec2::new(-1.0, 0.5)).length() < 1e-12);
        }
    }

    #[test]
    fn points_on_a_line_determine_nothing() {
        let line = [[1.0, 2.0], [2.0, 4.0], [-1.0, -2.0], [0.5, 1.0], [3.0, 6.0]];
        let linear = |x, y| DVec2::new(x, y);
        assert_eq!(gradient(&samples(&line, linear), Degree::Linear, 1e-9), None);
        assert_eq!(gradient(&samples(&line.map(|[x, _]| [x, 0.0]), linear), Degree::Quadratic, 1e-9), None);
        assert_eq!(gradient(&samples(&AROUND[..4], linear), Degree::Quadratic, 1e-9), None);
    }
}
