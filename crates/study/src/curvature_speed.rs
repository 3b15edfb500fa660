//! How fast curvature is baked: both methods on a large torus, on one thread and on all, and on a fan of many triangles
//! round one vertex, which the slow would hang on.

use barchan_bakers::Exec;
use barchan_bakers::curvature::{self, CurvatureMethod, CurvatureParams};
use barchan_field::Mesh;
use barchan_field::surfaces::{ParametricSurface, Pattern, Tessellation};
use glam::DVec3;

use crate::runner::Observer;
use crate::timer::{Contestant, Pace, race};
use crate::{Item, Record, Scale, Setting, StudyError};

/// The fan's name in records.
pub const FAN: &str = "fan";

/// A mesh, and the threads it is baked on.
pub struct Heat {
    name: &'static str,
    mesh: Mesh,
    threads: Vec<usize>,
    pace: Pace,
}

/// The heats: the torus on one thread and on `cores`, the fan on one.
///
/// # Errors
/// None in practice.
pub fn heats(scale: Scale, cores: usize) -> Result<Vec<Heat>, StudyError> {
    let (vertices, triangles, seconds) = match scale {
        Scale::Full => (1_000_000, 100_000, 20.0),
        Scale::Quick => (2000, 1000, 0.01),
    };
    let tessellation = Tessellation { vertices, pattern: Pattern::Jittered, seed: 1, uv_seam: false };
    let torus = ParametricSurface::Torus { major: 1.0, minor: 0.4 }.tessellate(&tessellation)?.mesh;
    let mut threads = vec![1, cores];
    threads.dedup();
    let pace = Pace { seconds, max_rounds: 5 };
    Ok(vec![
        Heat { name: "torus", mesh: torus, threads, pace },
        Heat { name: FAN, mesh: fan(triangles)?, threads: vec![1], pace },
    ])
}

/// Triangles round the top of a flat bowl turned over.
fn fan(triangles: u32) -> Result<Mesh, StudyError> {
    let rim = (0..triangles).map(|index| {
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * f64::from(index) / f64::from(triangles));
        DVec3::new(cos, sin, -0.1)
    });
    let positions = std::iter::once(DVec3::ZERO).chain(rim).collect();
    let corners = (0..triangles).map(|index| [0, 1 + index, 1 + (index + 1) % triangles]).collect();
    Ok(Mesh::new(positions, corners)?)
}

/// The records of a heat.
///
/// # Errors
/// A bake that is refused.
pub fn measure(heat: &Heat, observe: &mut Observer<'_>) -> Result<Vec<Record>, StudyError> {
    let settings: Vec<(CurvatureMethod, usize)> = CurvatureMethod::ALL
        .into_iter()
        .flat_map(|method| heat.threads.iter().map(move |&threads| (method, threads)))
        .collect();
    let execs = settings.iter().map(|&(_, threads)| Exec::new(threads)).collect::<Result<Vec<_>, _>>()?;
    let work = |(&(method, threads), exec): (&(CurvatureMethod, usize), _)| {
        let params = CurvatureParams { method, ..CurvatureParams::default() };
        Contestant {
            name: format!("{}, {}, {threads} threads", heat.name, method.name()),
            work: Box::new(move || Ok(curvature::bake(&heat.mesh, &params, exec)?)),
        }
    };
    let mut contestants: Vec<_> = settings.iter().zip(&execs).map(work).collect();
    let timings = race(&mut contestants, &heat.pace, observe)?;
    let record = |(&(method, threads), timing): (&(CurvatureMethod, usize), _)| {
        let setting = Setting::default().with("method", method.name()).with("threads", threads);
        let record = Record::of_mesh("curvature", setting, heat.name, &heat.mesh);
        record.with_timing(timing, Item::Vertex, heat.mesh.positions().len() as f64)
    };
    Ok(settings.iter().zip(&timings).map(record).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_methods_are_timed_on_the_torus_and_on_the_fan() {
        let heats = heats(Scale::Quick, 2).unwrap();
        let records: Vec<Record> = heats.iter().flat_map(|heat| measure(heat, &mut |_| ()).unwrap()).collect();
        let of = |name: &str| records.iter().filter(|record| record.scene == name).count();
        assert_eq!((of("torus"), of(FAN)), (4, 2));
        assert!(records.iter().all(|record| record.wall_ns > Some(0.0)));
    }

    #[test]
    fn the_fan_has_one_vertex_in_all_triangles() {
        let mesh = fan(5).unwrap();
        assert_eq!((mesh.positions().len(), mesh.triangles().len()), (6, 5));
        assert!(mesh.triangles().iter().all(|corners| corners[0] == 0));
    }
}
