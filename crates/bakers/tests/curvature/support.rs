//! A mesh whose curvature is known, and how far off the baker is.

use std::fmt;

use barchan_asset::VertexFlags;
use barchan_bakers::Exec;
use barchan_bakers::curvature::{CurvatureMethod, CurvatureParams, MeshCurvature, bake};
use barchan_field::Mesh;
use barchan_field::surfaces::{ParametricSurface, Pattern, PrincipalCurvature, Tessellation};

pub(crate) fn example(name: &str) -> ParametricSurface {
    ParametricSurface::examples().into_iter().find(|surface| surface.name() == name).expect("an example")
}

pub(crate) fn bake_with(mesh: &Mesh, method: CurvatureMethod, threads: usize) -> MeshCurvature {
    let params = CurvatureParams { method, ..CurvatureParams::default() };
    bake(mesh, &params, &Exec::new(threads).unwrap()).unwrap()
}

pub(crate) fn baked(mesh: &Mesh) -> MeshCurvature {
    bake_with(mesh, CurvatureMethod::Accurate, 1)
}

/// A mesh, and the exact curvature at each of its vertices.
#[derive(Clone)]
pub(crate) struct Case {
    pub mesh: Mesh,
    pub truth: Vec<PrincipalCurvature>,
}

/// Errors of curvature, relative to the root mean square of max|κ| over the mesh.
#[derive(Clone, Copy)]
pub(crate) struct Errors {
    pub rms: f64,
    pub max: f64,
    /// Of principal directions, where κ1 − κ2 is more than a tenth of max|κ|. Degrees.
    pub directions_rms: f64,
}

impl fmt::Debug for Errors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "rms {:.2e}, at most {:.2e}, directions {:.4}°", self.rms, self.max, self.directions_rms)
    }
}

impl Case {
    pub fn of(surface: &ParametricSurface, pattern: Pattern, vertices: u32) -> Self {
        let made = surface.tessellate(&Tessellation { vertices, pattern, seed: 3, uv_seam: false }).unwrap();
        let truth = made.parameters.iter().map(|at| surface.jet(at.x, at.y).curvature()).collect();
        Self { mesh: made.mesh, truth }
    }

    pub fn example(name: &str, pattern: Pattern, vertices: u32) -> Self {
        Self::of(&example(name), pattern, vertices)
    }

    pub fn errors(&self, found: &MeshCurvature) -> Errors {
        self.errors_at(found, |_| true)
    }

    /// The errors of a bake of the case itself.
    pub fn clean(&self) -> Errors {
        self.errors(&baked(&self.mesh))
    }

    pub fn errors_at(&self, found: &MeshCurvature, counts: impl Fn(usize) -> bool) -> Errors {
        assert_finite(found);
        assert_eq!(found.vertices.len(), self.truth.len());
        let largest = |truth: &PrincipalCurvature| truth.principal[0].abs().max(truth.principal[1].abs());
        let scale = root_mean_square(self.truth.iter().map(largest));
        let counted = || self.truth.iter().zip(&found.vertices).enumerate().filter(|(vertex, _)| counts(*vertex));
        let errors: Vec<f64> = counted()
            .flat_map(|(_, (truth, found))| [0, 1].map(|k| (found.principal[k] - truth.principal[k]) / scale))
            .collect();
        let turns = counted()
            .filter(|(_, (truth, _))| truth.principal[0] - truth.principal[1] > 0.1 * largest(truth))
            .map(|(_, (truth, found))| {
                let [a, b] = [truth.directions[0], found.directions[0]];
                a.cross(b).length().atan2(a.dot(b).abs()).to_degrees()
            });
        Errors {
            rms: root_mean_square(errors.iter().copied()),
            max: errors.iter().fold(0.0, |most, error| most.max(error.abs())),
            directions_rms: root_mean_square(turns),
        }
    }

    /// The same case with its vertices taken from elsewhere in it: vertex i is what `origin[i]` was.
    pub fn remade(&self, origin: &[u32], triangles: Vec<[u32; 3]>) -> Self {
        let positions = origin.iter().map(|&old| self.mesh.positions()[old as usize]).collect();
        let truth = origin.iter().map(|&old| self.truth[old as usize]).collect();
        Self { mesh: Mesh::new(positions, triangles).unwrap(), truth }
    }

    pub fn with_triangles(&self, triangles: Vec<[u32; 3]>) -> Self {
        let mesh = Mesh::new(self.mesh.positions().to_vec(), triangles).unwrap();
        Self { mesh, truth: self.truth.clone() }
    }
}

pub(crate) fn root_mean_square(values: impl Iterator<Item = f64>) -> f64 {
    let (mut sum, mut count) = (0.0, 0.0);
    for value in values {
        sum += value * value;
        count += 1.0;
    }
    if count > 0.0 { f64::sqrt(sum / count) } else { 0.0 }
}

/// Finite, ordered, and in orthonormal frames.
pub(crate) fn assert_finite(found: &MeshCurvature) {
    for (vertex, curvature) in found.vertices.iter().enumerate() {
        let [first, second] = curvature.principal;
        assert!(first.is_finite() && second.is_finite() && first >= second, "vertex {vertex}: {curvature:?}");
        let [x, y, z] = [curvature.directions[0], curvature.directions[1], curvature.normal];
        let lengths = [x, y, z].map(|axis| axis.length() - 1.0);
        let angles = [x.dot(y), y.dot(z), z.dot(x)];
        let off = lengths.into_iter().chain(angles).fold(0.0_f64, |most, error| most.max(error.abs()));
        assert!(off < 1e-9, "vertex {vertex}: {curvature:?}");
    }
}

/// The bits of all curvatures, to be compared.
pub(crate) fn bits(found: &MeshCurvature) -> Vec<[u64; 2]> {
    found.vertices.iter().map(|vertex| vertex.principal.map(f64::to_bits)).collect()
}

/// The largest difference of curvature, over the largest curvature.
pub(crate) fn difference(a: &MeshCurvature, b: &MeshCurvature) -> f64 {
    assert_eq!(a.vertices.len(), b.vertices.len());
    let pairs = || a.vertices.iter().flat_map(|v| v.principal).zip(b.vertices.iter().flat_map(|v| v.principal));
    let largest = pairs().fold(0.0_f64, |most, (a, _)| most.max(a.abs()));
    pairs().fold(0.0_f64, |most, (a, b)| most.max((a - b).abs())) / largest
}

pub(crate) fn count(found: &MeshCurvature, flag: VertexFlags) -> usize {
    found.vertices.iter().filter(|vertex| vertex.flags.contains(flag)).count()
}

/// Numbers from 0 to 1, the same every time.
pub(crate) fn random(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f64 / (1 << 24) as f64
    }
}
