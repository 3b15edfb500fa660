//! Curvature at one vertex, slowly and obviously: the twin that the baker is measured against.
//!
//! # Theory
//!
//! In a frame whose z axis is near the normal, the surface is a height z(x, y). A polynomial of degree d that follows the nearest
//! vertices best, in the sense of weighted least squares, has second derivatives right to order d − 1 in their distance: Frédéric Cazals, Marc
//! Pouget, *Estimating differential quantities using polynomial fitting of osculating jets*, 2005. Mean and Gaussian curvature of such a
//! height are closed formulas: do Carmo, *Differential Geometry of Curves and Surfaces*, §3.3.
//!
//! # Departures
//!
//! The equations are solved by Householder's reflections (Golub and Van Loan, *Matrix Computations*, §5.3), which lose no digits to the squaring of
//! the matrix; Cazals and Pouget take singular values.
//!
//! # What it leaves out
//!
//! All that makes the baker robust. Near is what is near in space, whatever lies between; vertices at the very same place count once; the surface is
//! one sheet, oriented, and nothing is said of noise.

use barchan_asset::VertexFlags;
use barchan_field::Mesh;
use glam::DVec3;

use super::VertexCurvature;

/// Of the longest column of the equations: a diagonal below it is rounding.
const LEAST_DIAGONAL: f64 = 1e-12;

/// The curvature at a vertex from a polynomial of `degree`, at least 2, that follows the `neighbours` nearest vertices: κ in 1 / length unit,
/// as in [`VertexCurvature`], without remarks. `None` where no triangle with an area uses the vertex's place, or where the vertices
/// do not determine the polynomial.
///
/// # Panics
/// If the mesh has no such vertex.
#[must_use]
pub fn curvature_at(mesh: &Mesh, vertex: usize, degree: usize, neighbours: usize) -> Option<VertexCurvature> {
    let origin = mesh.positions()[vertex];
    let normal = normal_at(mesh, origin)?;
    let (x, y) = normal.any_orthonormal_pair();
    let offsets = nearest_offsets(mesh, origin, neighbours);
    let radius = offsets.last()?.length();
    let mut equations = Vec::with_capacity(offsets.len() + 1);
    let mut heights = Vec::with_capacity(offsets.len() + 1);
    for offset in core::iter::once(DVec3::ZERO).chain(offsets) {
        let near = offset / radius;
        let weight = libm::exp(-near.length_squared());
        let (along, up, height) = (near.dot(x), near.dot(y), near.dot(normal));
        equations.push(monomials(degree, along, up).map(|monomial| weight * monomial).collect());
        heights.push(weight * height);
    }
    let polynomial = least_squares(equations, heights)?;
    let [_, p, q, r, s, t] = *polynomial.first_chunk()?;
    let height = Height { slope: [p, q], second: [2.0 * r / radius, s / radius, 2.0 * t / radius] };
    Some(height.curvature([x, y, normal]))
}

/// 1, x, y, x², xy, y², … up to a degree.
pub(super) fn monomials(degree: usize, x: f64, y: f64) -> impl Iterator<Item = f64> {
    let power = |base: f64, exponent: usize| (0..exponent).map(|_| base).product::<f64>();
    (0..=degree).flat_map(move |sum| (0..=sum).map(move |b| power(x, sum - b) * power(y, b)))
}

/// The unknowns that leave the least sum of squares in `equations` · unknowns = `right`; `None` if the equations do not determine them. Rows are
/// of one length and no fewer than their columns.
pub(super) fn least_squares(mut equations: Vec<Vec<f64>>, mut right: Vec<f64>) -> Option<Vec<f64>> {
    let (rows, columns) = (equations.len(), equations.first()?.len());
    if rows < columns {
        return None;
    }
    let largest = equations.iter().flatten().fold(0.0_f64, |most, value| most.max(value.abs()));
    for column in 0..columns {
        let below: f64 = (column..rows).map(|row| equations[row][column] * equations[row][column]).sum();
        if below.sqrt() <= LEAST_DIAGONAL * largest {
            return None;
        }
        // The mirror that takes what is left of the column to its first place.
        let mut mirror: Vec<f64> = equations[column..].iter().map(|equation| equation[column]).collect();
        mirror[0] += below.sqrt().copysign(mirror[0]);
        let length_squared: f64 = mirror.iter().map(|value| value * value).sum();
        for other in column..columns {
            let across: f64 = mirror.iter().zip(&equations[column..]).map(|(m, equation)| m * equation[other]).sum();
            for (m, equation) in mirror.iter().zip(&mut equations[column..]) {
                equation[other] -= 2.0 * m * across / length_squared;
            }
        }
        let across: f64 = mirror.iter().zip(&right[column..]).map(|(m, value)| m * value).sum();
        for (m, value) in mirror.iter().zip(&mut right[column..]) {
            *value -= 2.0 * m * across / length_squared;
        }
    }
    let mut unknowns = vec![0.0; columns];
    for row in (0..columns).rev() {
        let known: f64 = (row + 1..columns).map(|column| equations[row][column] * unknowns[column]).sum();
        unknowns[row] = (right[row] - known) / equations[row][row];
    }
    Some(unknowns)
}

/// Derivatives of a height z(x, y) at a point.
struct Height {
    /// zx, zy.
    slope: [f64; 2],
    /// zxx, zxy, zyy.
    second: [f64; 3],
}

impl Height {
    fn curvature(&self, [x, y, z]: [DVec3; 3]) -> VertexCurvature {
        let ([p, q], [r, s, t]) = (self.slope, self.second);
        let area_squared = 1.0 + p * p + q * q;
        let area = area_squared.sqrt();
        // Positive where convex: the sign of the books, turned.
        let mean = -((1.0 + q * q) * r - 2.0 * p * q * s + (1.0 + p * p) * t) / (2.0 * area * area_squared);
        let gauss = (r * t - s * s) / (area_squared * area_squared);
        let spread = (mean * mean - gauss).max(0.0).sqrt();
        let normal = (z - x * p - y * q) / area;
        let first = self.direction_of(mean + spread);
        let [a, b] = first;
        let first = (x * a + y * b + z * (p * a + q * b)).normalize();
        let directions = [first, normal.cross(first)];
        VertexCurvature { principal: [mean + spread, mean - spread], directions, normal, flags: VertexFlags::NONE }
    }

    /// (dx, dy) along which the normal curvature is `curvature`: in the kernel of II − κ I.
    fn direction_of(&self, curvature: f64) -> [f64; 2] {
        let ([p, q], [r, s, t]) = (self.slope, self.second);
        let area = (1.0 + p * p + q * q).sqrt();
        let rows = [
            [-r / area - curvature * (1.0 + p * p), -s / area - curvature * p * q],
            [-s / area - curvature * p * q, -t / area - curvature * (1.0 + q * q)],
        ];
        let length = |[a, b]: [f64; 2]| a * a + b * b;
        let [a, b] = if length(rows[0]) >= length(rows[1]) { rows[0] } else { rows[1] };
        if length([a, b]) > 0.0 { [-b, a] } else { [1.0, 0.0] }
    }
}

/// The sum of the triangles' areas at a place, as a direction.
fn normal_at(mesh: &Mesh, place: DVec3) -> Option<DVec3> {
    let corners = mesh.triangles().iter().map(|triangle| triangle.map(|vertex| mesh.positions()[vertex as usize]));
    let around = corners.filter(|corners| corners.contains(&place));
    around.map(|[a, b, c]| (b - a).cross(c - a)).sum::<DVec3>().try_normalize()
}

/// The nearest other places, nearest first, as offsets.
fn nearest_offsets(mesh: &Mesh, origin: DVec3, count: usize) -> Vec<DVec3> {
    let mut offsets: Vec<DVec3> = mesh.positions().iter().map(|&position| position - origin).collect();
    let key = |offset: &DVec3| (offset.length_squared(), offset.to_array());
    offsets.sort_by(|a, b| {
        let ((a, [ax, ay, az]), (b, [bx, by, bz])) = (key(a), key(b));
        a.total_cmp(&b).then(ax.total_cmp(&bx)).then(ay.total_cmp(&by)).then(az.total_cmp(&bz))
    });
    offsets.dedup();
    offsets.retain(|offset| *offset != DVec3::ZERO);
    offsets.truncate(count);
    offsets
}
