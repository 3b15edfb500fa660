//! Curvature in texture coordinates.
//!
//! # Theory
//!
//! Around a vertex, (u, v) is a function of the tangent plane's coordinates (x, y) along the principal directions. Its derivatives there
//! are the images V1, V2 of the unit principal directions; the inverse of that matrix holds Pu and Pv. With them E = Pu·Pu, F = Pu·Pv,
//! G = Pv·Pv, and, as the second form is diagonal along principal directions, e = κ1 (Pu·t1)² + κ2 (Pu·t2)² and so on.
//!
//! The derivatives are those of quadratic polynomials fitted to the texture coordinates of the vertices around, so that their error falls
//! with the square of the edges' length; the mean over triangles, as tangents are commonly made, is off by a multiple of their length. The
//! surface is unrolled onto the tangent plane first, as its curvature is known and texture coordinates mostly follow lengths on the
//! surface: on a randomly tessellated cylinder the largest error of the first form fell to a twentieth.
//!
//! # Conventions
//!
//! κ is positive where convex, and so are e and g. What Pu × Pv is measured against is the surface's own normal, so that mirrored texture
//! coordinates do not turn the curvature's sign. A vertex on a seam of the texture has the forms of its own side of the seam. Where texture
//! coordinates have no area, the forms are those of the mean curvature H in a frame of unit length: E = G = 1, e = g = H.

mod around;
mod gradient;

use barchan_asset::VertexFlags;
use barchan_field::Mesh;
use glam::{DVec2, DVec3};

use self::around::Charts;
use self::gradient::{Degree, Sample, gradient};
use super::{MeshCurvature, VertexCurvature};
use crate::Exec;

/// Vertices that one piece of work takes.
const PIECE: usize = 1 << 12;

/// Of the square of its larger stretch: a chart of less area has none.
const LEAST_AREA: f64 = 1e-7;

/// The least pivot of a quadratic that is taken, ring by ring: 1 is the best placed, 0 does not determine a derivative. Vertices on one
/// side are never well placed, but the wider the ring the more of them speak.
const WELL_PLACED: [f64; 3] = [0.05, 0.01, 0.002];

/// So many vertices that a wider ring would say nothing new.
const CROWD: usize = 256;

/// The least pivot of a linear function.
const NOT_ON_A_LINE: f64 = 1e-9;

/// The fundamental forms of the surface at one vertex, in the chart of its texture coordinates.
///
/// Along (du, dv) the normal curvature is κ = (e du² + 2f du dv + g dv²) / (E du² + 2F du dv + G dv²).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VertexForms {
    /// E, F, G: length² per unit of texture coordinate squared.
    pub first: [f64; 3],
    /// e, f, g: length per unit of texture coordinate squared, positive where convex.
    pub second: [f64; 3],
    /// The (u, v) images of the unit principal directions: V1, V2, per length.
    pub uv_directions: [DVec2; 2],
    /// [`VertexFlags::MIRRORED_UV`], [`VertexFlags::DEGENERATE_UV`].
    pub flags: VertexFlags,
}

/// The forms of every vertex; `None` for a mesh without texture coordinates. Vertices at one place of the surface with the same texture
/// coordinates have the same bits.
///
/// # Panics
/// If `curvature` has another number of vertices than `mesh`.
#[must_use]
pub fn forms(mesh: &Mesh, curvature: &MeshCurvature, exec: &Exec) -> Option<Vec<VertexForms>> {
    let uvs = mesh.uvs()?;
    assert_eq!(curvature.vertices.len(), uvs.len(), "the curvature is that of another mesh");
    let charts = Charts::of(mesh, uvs, &curvature.vertices, exec);
    let mut forms: Vec<VertexForms> = curvature.vertices.iter().map(VertexForms::of_mean_curvature).collect();
    exec.for_each_quietly(forms.chunks_mut(PIECE).collect(), |piece, forms| {
        for (index, form) in forms.iter_mut().enumerate() {
            let vertex = (piece * PIECE + index) as u32;
            if charts.speaker(vertex) == vertex {
                *form = at_vertex(&charts, vertex, &curvature.vertices[vertex as usize]).unwrap_or(*form);
            }
        }
    });
    for vertex in 0..forms.len() {
        forms[vertex] = forms[charts.speaker(vertex as u32) as usize];
    }
    Some(forms)
}

/// `None` where texture coordinates have no area.
fn at_vertex(charts: &Charts, vertex: u32, curvature: &VertexCurvature) -> Option<VertexForms> {
    let curvature = if curvature.flags.is_unknown() { flat(charts, vertex)? } else { *curvature };
    let uv_directions = uv_directions(charts, vertex, &curvature)?;
    VertexForms::new(&curvature, uv_directions)
}

/// A vertex of which no curvature is known still has a chart if its triangles have an area.
fn flat(charts: &Charts, vertex: u32) -> Option<VertexCurvature> {
    let normal = charts.area_normal(vertex).try_normalize()?;
    let (x, y) = normal.any_orthonormal_pair();
    Some(VertexCurvature { normal, directions: [x, y], ..VertexCurvature::UNKNOWN })
}

/// V1 and V2: quadratic on the vertices around, on wider rings where these are too few or badly placed; linear as a last resort.
fn uv_directions(charts: &Charts, vertex: u32, curvature: &VertexCurvature) -> Option<[DVec2; 2]> {
    let sample = |&other: &u32| {
        let offset = charts.position(other) - charts.position(vertex);
        let (at, distance) = (unrolled(curvature, offset), offset.length());
        Sample { at, distance, uv: charts.uv(other) - charts.uv(vertex) }
    };
    let hand = charts.hand(vertex, curvature.normal)?;
    let mut around = vec![vertex];
    let mut nearest = Vec::new();
    for (ring, least) in WELL_PLACED.into_iter().enumerate() {
        around = charts.widened(vertex, curvature.normal, hand, around);
        let samples: Vec<Sample> = around.iter().map(sample).collect();
        let quadratic = gradient(&samples, Degree::Quadratic, least);
        if quadratic.is_some() {
            return quadratic;
        }
        let enough = samples.len() > CROWD;
        if ring == 0 {
            nearest = samples;
        }
        if enough {
            break;
        }
    }
    gradient(&nearest, Degree::Linear, NOT_ON_A_LINE)
}

/// Where a point is on the tangent plane when the surface is unrolled onto it: in the direction in which it is seen, as far away as it is
/// along the surface.
fn unrolled(curvature: &VertexCurvature, offset: DVec3) -> DVec2 {
    let [x, y] = curvature.directions.map(|direction| offset.dot(direction));
    let Some(direction) = DVec2::new(x, y).try_normalize() else { return DVec2::ZERO };
    let bend = DVec2::from_array(curvature.principal).dot(direction * direction);
    let chord_squared = offset.length_squared();
    // Arc over chord of a circle, but no chord is longer than its diameter.
    let arc = 1.0 + (bend * bend * chord_squared).min(4.0) / 24.0;
    direction * (chord_squared.sqrt() * arc)
}

impl VertexForms {
    /// From the images of the principal directions; `None` if they span no area.
    fn new(curvature: &VertexCurvature, uv_directions: [DVec2; 2]) -> Option<Self> {
        let [along_first, along_second] = uv_directions;
        let area = along_first.perp_dot(along_second);
        let stretch = along_first.length_squared().max(along_second.length_squared());
        if area.is_nan() || area.abs() <= LEAST_AREA * stretch {
            return None;
        }
        // Components of Pu and Pv along the principal directions: the inverse of the matrix with columns V1 and V2.
        let pu = DVec2::new(along_second.y, -along_first.y) / area;
        let pv = DVec2::new(-along_second.x, along_first.x) / area;
        let bend = DVec2::from_array(curvature.principal);
        let [first, second] = curvature.directions;
        let mirrored = area * first.cross(second).dot(curvature.normal) < 0.0;
        let first = [pu.dot(pu), pu.dot(pv), pv.dot(pv)];
        let second = [bend.dot(pu * pu), bend.dot(pu * pv), bend.dot(pv * pv)];
        let flags = if mirrored { VertexFlags::MIRRORED_UV } else { VertexFlags::NONE };
        // Texture coordinates of 1e±200 are finite; what follows of them may not be.
        let finite = first.into_iter().chain(second).all(f64::is_finite);
        finite.then_some(Self { first, second, uv_directions, flags })
    }

    fn of_mean_curvature(curvature: &VertexCurvature) -> Self {
        let mean = 0.5 * (curvature.principal[0] + curvature.principal[1]);
        Self {
            first: [1.0, 0.0, 1.0],
            second: [mean, 0.0, mean],
            uv_directions: [DVec2::X, DVec2::Y],
            flags: VertexFlags::DEGENERATE_UV,
        }
    }
}
