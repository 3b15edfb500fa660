//! The sphere that follows a point's neighbours best.

use super::neighbourhood::Neighbour;

/// The frame's plane, from the triangles at the point, is believed as much as half the neighbours: seen from a border, a slope and a
/// curvature look nearly alike.
const BELIEF: f64 = 0.5;
/// A pivot below this part of its diagonal says that the neighbours lie on a line.
const LEAST_PIVOT: f64 = 1e-9;

/// A sphere through the origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sphere {
    /// Slopes there over the frame's plane.
    pub(super) slope: [f64; 2],
    /// Positive where convex.
    pub(super) curvature: f64,
}

impl Sphere {
    /// On a sphere with the slopes p, q and curvature κ, z = p x + q y − ½ κ √(1 + p² + q²) (x² + y² + z²): least squares of z.
    pub(super) fn along(neighbours: &[Neighbour]) -> Self {
        let (mut matrix, mut right) = ([[0.0; 3]; 3], [0.0; 3]);
        for near in neighbours {
            let row = [near.x, near.y, -0.5 * (near.x * near.x + near.y * near.y + near.z * near.z)];
            for i in 0..3 {
                for j in 0..=i {
                    matrix[i][j] += row[i] * row[j];
                }
                right[i] += row[i] * near.z;
            }
        }
        for (row, column) in [(0, 0), (1, 0), (1, 1)] {
            matrix[row][column] *= 1.0 + BELIEF;
        }
        if let Some([p, q, bend]) = solve(&matrix, right) {
            return Self { slope: [p, q], curvature: bend / (1.0 + p * p + q * q).sqrt() };
        }
        let level = if matrix[2][2] > 0.0 { right[2] / matrix[2][2] } else { 0.0 };
        Self { slope: [0.0; 2], curvature: level }
    }
}

/// Cholesky's method, on a lower triangle; `None` where the equations do not determine the unknowns.
fn solve(matrix: &[[f64; 3]; 3], right: [f64; 3]) -> Option<[f64; 3]> {
    let (mut factor, mut unknowns) = ([[0.0; 3]; 3], [0.0; 3]);
    for row in 0..3 {
        for column in 0..row {
            let known: f64 = (0..column).map(|k| factor[row][k] * factor[column][k]).sum();
            factor[row][column] = (matrix[row][column] - known) / factor[column][column];
        }
        let pivot = matrix[row][row] - (0..row).map(|k| factor[row][k] * factor[row][k]).sum::<f64>();
        if pivot.is_nan() || pivot <= LEAST_PIVOT * matrix[row][row] {
            return None;
        }
        factor[row][row] = pivot.sqrt();
        let known: f64 = (0..row).map(|k| factor[row][k] * unknowns[k]).sum();
        unknowns[row] = (right[row] - known) / factor[row][row];
    }
    for row in (0..3).rev() {
        let known: f64 = (row + 1..3).map(|k| factor[k][row] * unknowns[k]).sum();
        unknowns[row] = (unknowns[row] - known) / factor[row][row];
    }
    Some(unknowns)
}
