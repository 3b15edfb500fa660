//! A bicubic Bézier patch: `control[i][j]` belongs to the Bernstein polynomials i of u and j of v.

use glam::DVec3;

use super::SurfaceJet;

pub(super) fn jet(control: &[[DVec3; 4]; 4], u: f64, v: f64) -> SurfaceJet {
    let (along_u, along_v) = (bernstein(u), bernstein(v));
    let blended = |order_u: usize, order_v: usize| {
        let mut sum = DVec3::ZERO;
        for (row, weight_u) in control.iter().zip(along_u[order_u]) {
            for (&point, weight_v) in row.iter().zip(along_v[order_v]) {
                sum += point * (weight_u * weight_v);
            }
        }
        sum
    };
    SurfaceJet {
        position: blended(0, 0),
        du: blended(1, 0),
        dv: blended(0, 1),
        duu: blended(2, 0),
        duv: blended(1, 1),
        dvv: blended(0, 2),
    }
}

/// The four cubic Bernstein polynomials, their first and their second derivatives.
fn bernstein(t: f64) -> [[f64; 4]; 3] {
    let s = 1.0 - t;
    [
        [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t],
        [-3.0 * s * s, 3.0 * s * (s - 2.0 * t), 3.0 * t * (2.0 * s - t), 3.0 * t * t],
        [6.0 * s, 6.0 * (t - 2.0 * s), 6.0 * (s - 2.0 * t), 6.0 * t],
    ]
}
