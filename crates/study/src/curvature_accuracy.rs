//! How far baked curvature is from the surface's own, on meshes of closed forms.
//!
//! # What is varied
//!
//! Surface, number of vertices, how they lie, noise on them, method. Every mesh is irregular: on regular ones errors cancel
//! that never do on a mesh somebody made.
//!
//! # What is counted
//!
//! - κ1 and κ2 of every vertex, borders and poles included, relative to the RMS over the mesh of the larger |κ|; wrong if off by
//!   more than 0.1;
//! - the first principal direction in degrees, where κ1 − κ2 is more than 0.1 of that unit: nearer to an umbilic it
//!   means little.
//!
//! The order of convergence is for the docs to find, from meshes of different numbers of vertices.

use barchan_bakers::Exec;
use barchan_bakers::curvature::{self, CurvatureMethod, CurvatureParams, MeshCurvature};
use barchan_field::surfaces::{ParametricSurface, Pattern, PrincipalCurvature, Tessellation, with_vertex_noise};
use barchan_field::{FieldError, Mesh};
use glam::DVec3;

use crate::runner::{Observer, Step};
use crate::{Norms, Quantity, Record, Scale, Setting, Stopwatch, StudyError};

/// From what part of the unit on a curvature is wrong, and up to which difference a direction means little.
const NOTEWORTHY: f64 = 0.1;

/// How vertices lie, in words; noise in mean edge lengths.
const MESHES: [(&str, Pattern, f64); 5] = [
    ("jittered", Pattern::Jittered, 0.0),
    ("random", Pattern::Random, 0.0),
    ("long-thin", Pattern::LongThin { aspect: 20.0 }, 0.0),
    ("jittered", Pattern::Jittered, 0.1),
    ("random", Pattern::Random, 0.1),
];

/// The study.
pub struct CurvatureAccuracy<'a> {
    /// The surfaces.
    pub surfaces: Vec<ParametricSurface>,
    /// Roughly how many vertices meshes have.
    pub vertices: &'static [u32],
    /// How bakes run.
    pub exec: &'a Exec<'a>,
}

/// The study at a scale.
#[must_use]
pub fn parts<'a>(scale: Scale, exec: &'a Exec<'a>) -> CurvatureAccuracy<'a> {
    let vertices: &[u32] = match scale {
        Scale::Full => &[1000, 4000, 16_000],
        Scale::Quick => &[400],
    };
    CurvatureAccuracy { surfaces: ParametricSurface::examples(), vertices, exec }
}

/// The records of all surfaces. A surface that cannot be cut so has none.
///
/// # Errors
/// A bake that is refused.
pub fn measure(study: &CurvatureAccuracy<'_>, observe: &mut Observer<'_>) -> Result<Vec<Record>, StudyError> {
    let mut records = Vec::new();
    for (done, surface) in study.surfaces.iter().enumerate() {
        observe(&Step { done, total: study.surfaces.len(), what: surface.name() });
        for &vertices in study.vertices {
            for (words, pattern, noise) in MESHES {
                let tessellation = Tessellation { vertices, pattern, seed: 1, uv_seam: false };
                let cut = match surface.tessellate(&tessellation) {
                    Err(FieldError::Tessellation { .. }) => continue,
                    cut => cut?,
                };
                let truth: Vec<_> = cut.parameters.iter().map(|at| surface.jet(at.x, at.y).curvature()).collect();
                let mesh = study.noisy(&cut.mesh, noise)?;
                let setting = Setting::default().with("pattern", words).with("noise", noise).with("vertices", vertices);
                for method in CurvatureMethod::ALL {
                    let setting = setting.clone().with("method", method.name());
                    records.extend(study.measure(surface, &mesh, &truth, method, &setting)?);
                }
            }
        }
    }
    Ok(records)
}

impl CurvatureAccuracy<'_> {
    fn noisy(&self, clean: &Mesh, noise: f64) -> Result<Mesh, StudyError> {
        if noise == 0.0 {
            return Ok(clean.clone());
        }
        let params = CurvatureParams { method: CurvatureMethod::Fast, ..CurvatureParams::default() };
        let edge = curvature::bake(clean, &params, self.exec)?.report.mean_edge;
        Ok(with_vertex_noise(clean, noise * edge, 1)?)
    }

    fn measure(
        &self,
        surface: &ParametricSurface,
        mesh: &Mesh,
        truth: &[PrincipalCurvature],
        method: CurvatureMethod,
        setting: &Setting,
    ) -> Result<[Record; 2], StudyError> {
        let watch = Stopwatch::start();
        let params = CurvatureParams { method, ..CurvatureParams::default() };
        let baked = curvature::bake(mesh, &params, self.exec)?;
        let bake_seconds = Some(watch.elapsed().core_seconds());
        let (errors, turns) = compare(&baked, truth);
        let wrong = errors.iter().filter(|error| error.abs() > NOTEWORTHY).count() as f64 / errors.len() as f64;
        let record = || Record::of_mesh("curvature", setting.clone(), surface.name(), mesh);
        let of_curvature = record().with_norms(Quantity::Curvature, &Norms::of(&errors));
        let of_direction = if turns.is_empty() {
            Record { quantity: Some(Quantity::DirectionDegrees), samples: Some(0), ..record() }
        } else {
            record().with_norms(Quantity::DirectionDegrees, &Norms::of(&turns))
        };
        Ok([Record { wrong_share: Some(wrong), bake_seconds, ..of_curvature }, of_direction])
    }
}

/// Errors of both curvatures of every vertex in units, and of first directions in degrees.
fn compare(baked: &MeshCurvature, truth: &[PrincipalCurvature]) -> (Vec<f64>, Vec<f64>) {
    let larger = |truth: &PrincipalCurvature| truth.principal[0].abs().max(truth.principal[1].abs());
    let squares: f64 = truth.iter().map(|truth| larger(truth) * larger(truth)).sum();
    let unit = (squares / truth.len() as f64).sqrt();
    let both = baked.vertices.iter().zip(truth);
    let errors =
        both.clone().flat_map(|(found, truth)| [0, 1].map(|k| (found.principal[k] - truth.principal[k]) / unit));
    let clear = both.filter(|(_, truth)| truth.principal[0] - truth.principal[1] > NOTEWORTHY * unit);
    let turns = clear.map(|(found, truth)| between_lines(found.directions[0], truth.directions[0]));
    (errors.collect(), turns.collect())
}

/// The angle between two lines, 0 to 90 degrees.
fn between_lines(a: DVec3, b: DVec3) -> f64 {
    libm::atan2(a.cross(b).length(), a.dot(b).abs()).to_degrees()
}

#[cfg(test)]
mod tests {
    use barchan_bakers::curvature::{MeshReport, VertexCurvature};

    use super::*;

    fn vertex(principal: [f64; 2], first: DVec3) -> VertexCurvature {
        VertexCurvature { principal, directions: [first, DVec3::Y], ..VertexCurvature::UNKNOWN }
    }

    #[test]
    fn errors_are_in_units_of_the_mesh_and_lines_have_no_sign() {
        let truth = [[3.0, 1.0], [1.0, -5.0]]
            .map(|principal| PrincipalCurvature { principal, directions: [DVec3::X, DVec3::Y] });
        let vertices = vec![vertex([3.0, 1.0], -DVec3::X), vertex([1.0, -4.0], DVec3::new(1.0, 1.0, 0.0))];
        let baked = MeshCurvature { vertices, report: MeshReport::default(), noise: 0.0 };
        let (errors, turns) = compare(&baked, &truth);
        // The unit is the root of (9 + 25) / 2.
        assert_eq!(errors[..3], [0.0; 3]);
        assert!((errors[3] - 1.0 / 17.0_f64.sqrt()).abs() < 1e-12);
        assert!(turns[0] == 0.0 && (turns[1] - 45.0).abs() < 1e-12);
    }

    #[test]
    fn umbilics_have_no_directions_to_err_in() {
        let truth = [PrincipalCurvature { principal: [1.0, 0.95], directions: [DVec3::X, DVec3::Y] }];
        let baked =
            MeshCurvature { vertices: vec![vertex([1.0, 0.95], DVec3::Y)], report: MeshReport::default(), noise: 0.0 };
        assert!(compare(&baked, &truth).1.is_empty());
    }

    #[test]
    fn every_surface_and_method_has_both_records() {
        let exec = Exec::new(1).unwrap();
        let study = CurvatureAccuracy { surfaces: ParametricSurface::examples(), vertices: &[200], exec: &exec };
        let records = measure(&study, &mut |_| ()).unwrap();
        for surface in &study.surfaces {
            for method in CurvatureMethod::ALL {
                let of = |quantity| {
                    let is = |record: &&Record| {
                        record.scene == surface.name()
                            && record.setting.get("method") == Some(method.name())
                            && record.quantity == Some(quantity)
                    };
                    records.iter().filter(is).count()
                };
                assert!(of(Quantity::Curvature) >= 4, "{}", surface.name());
                assert_eq!(of(Quantity::Curvature), of(Quantity::DirectionDegrees));
            }
        }
    }
}
