//! Meshes as a scanner sees them.

use glam::DVec3;

use super::random::Random;
use crate::{FieldError, Mesh};

/// `mesh` with every vertex moved at random: each coordinate by a bell-shaped error of standard deviation `sigma`, in the mesh's
/// length unit. Texture coordinates and normals stay. Vertices at one place, as along a seam, move apart.
///
/// # Errors
/// A `sigma` that is negative or not finite, or a vertex that is moved beyond ±1e30.
pub fn with_vertex_noise(mesh: &Mesh, sigma: f64, seed: u64) -> Result<Mesh, FieldError> {
    if !(0.0..=1e30).contains(&sigma) {
        let accepted = "a finite length of 0 or more";
        return Err(FieldError::Parameter { shape: "vertex noise", name: "sigma", value: sigma, accepted });
    }
    let mut random = Random::new(seed);
    let mut moved = |position: &DVec3| {
        let error = [random.normal(), random.normal(), random.normal()];
        *position + DVec3::from_array(error) * sigma
    };
    let mut noisy = Mesh::new(mesh.positions().iter().map(&mut moved).collect(), mesh.triangles().to_vec())?;
    if let Some(uvs) = mesh.uvs() {
        noisy = noisy.with_uvs(uvs.to_vec())?;
    }
    if let Some(normals) = mesh.normals() {
        noisy = noisy.with_normals(normals.to_vec())?;
    }
    Ok(noisy)
}
