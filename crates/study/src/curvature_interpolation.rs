//! What it costs to interpolate curvature between the corners of a triangle: as the paper does, κ1, κ2 and the principal
//! directions in texture coordinates, or as the fundamental forms.
//!
//! # What is compared
//!
//! - the six numbers of both forms, each by itself, and their quotient;
//! - κ1, κ2, V1 and V2 as they are, by Euler's formula solved for the angle on the surface;
//! - the same, directions turned round first that point away from those of the first corner;
//! - as they are, by Euler's formula as the paper prints it, with the angle in the texture.
//!
//! # What is looked at
//!
//! Meshes of closed forms, with what is exact at their vertices, so that nothing but interpolation is off; the signs of
//! directions are drawn at random, and at umbilics, as all points of a sphere are, their angles too: neither means
//! anything, and every baker has its own. And meshes as scanners see them, with what [`curvature::bake`] says of them: an
//! ellipsoid with noise on its vertices, and what else is given, longitude and latitude about its middle for texture coordinates,
//! as far as that is a chart: a vertex of a triangle that it shears or squeezes more than five to one is left out.
//!
//! Places are spread evenly over triangles, each with one direction, even over the triangle's plane. The truth on closed
//! forms is that of the surface at the interpolated (u, v); on a scan, where nobody knows, the mean of what the corners
//! say of the direction by themselves.
//!
//! Errors are relative to the RMS over the places of the larger |κ|; a place is wrong if it is off by more than 0.1.

use std::f64::consts::{FRAC_PI_2, TAU};

use barchan_bakers::Exec;
use barchan_bakers::curvature::{self, CurvatureParams};
use barchan_field::surfaces::{ParametricSurface, Pattern, TessellatedSurface, Tessellation, with_vertex_noise};
use barchan_field::{FieldError, Mesh};
use barchan_shade::{FundamentalForms, PrincipalUv, TangentFrame};
use glam::{DVec2, DVec3};

use crate::runner::{Observer, Step};
use crate::sample::unit;
use crate::timer::{Contestant, Pace, race};
use crate::{Item, Norms, Quantity, Record, Scale, Setting, StudyError};

/// From what part of the larger curvature on a place is wrong.
const WRONG: f64 = 0.1;

/// Noise of the ellipsoid, in mean edge lengths.
const SCAN_NOISE: f64 = 0.1;

/// 2 |det M| / ‖M‖² of a chart's map M of a triangle, 1 where it keeps angles: below, it is no chart.
const LEAST_EVENNESS: f64 = 0.4;

/// What is interpolated, and how κ comes of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interpolation {
    /// E, F, G, e, f, g; their quotient.
    Forms,
    /// κ1, κ2, V1, V2; Euler's formula, solved.
    Directions,
    /// The same, signs of directions made to agree first.
    AlignedDirections,
    /// κ1, κ2, V1, V2; Euler's formula as printed.
    DirectionsAsPrinted,
}

impl Interpolation {
    /// Each, in the order of the docs.
    pub const ALL: [Self; 4] = [Self::Forms, Self::AlignedDirections, Self::Directions, Self::DirectionsAsPrinted];

    /// Its name in records.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Forms => "forms",
            Self::Directions => "directions",
            Self::AlignedDirections => "aligned-directions",
            Self::DirectionsAsPrinted => "directions-as-printed",
        }
    }

    /// The normal curvature at a place.
    fn curvature(self, corners: [&Corner; 3], place: &Place) -> f64 {
        let principal = corners.map(|corner| &corner.principal);
        let DVec2 { x: du, y: dv } = place.direction;
        match self {
            Self::Forms => {
                FundamentalForms::interpolated(corners.map(|corner| &corner.forms), place.weights).along(du, dv)
            }
            Self::Directions => PrincipalUv::interpolated(principal, place.weights).euler_solved(place.direction),
            Self::AlignedDirections => {
                PrincipalUv::interpolated_aligned(principal, place.weights).euler_solved(place.direction)
            }
            Self::DirectionsAsPrinted => {
                PrincipalUv::interpolated(principal, place.weights).euler_as_printed(place.direction)
            }
        }
    }
}

/// What a run time has at a vertex.
#[derive(Debug, Clone, Copy)]
struct Corner {
    forms: FundamentalForms,
    principal: PrincipalUv,
}

/// A place in a triangle, and a direction in the texture.
#[derive(Debug, Clone, Copy)]
struct Place {
    triangle: [u32; 3],
    weights: [f64; 3],
    direction: DVec2,
}

/// A mesh, what is known at its vertices, and places on it.
pub struct Case {
    name: String,
    mesh: Mesh,
    corners: Vec<Corner>,
    places: Vec<Place>,
    /// Of each place: its normal curvature, and the larger principal one, without sign.
    truth: Vec<(f64, f64)>,
}

/// The cases: sphere, torus, a sheared patch, a noisy ellipsoid, and `scans` by their names.
///
/// # Errors
/// A mesh that cannot be made.
pub fn cases(scale: Scale, exec: &Exec<'_>, scans: &[(String, Mesh)]) -> Result<Vec<Case>, StudyError> {
    let (vertices, places) = match scale {
        Scale::Full => (4000, 40_000),
        Scale::Quick => (200, 400),
    };
    let wanted = |surface: &ParametricSurface| ["sphere", "torus", "bezier_patch"].contains(&surface.name());
    let closed_forms = ParametricSurface::examples().into_iter().filter(wanted);
    let closed_forms = closed_forms.map(|surface| closed_form(surface, vertices, places));
    let noisy = noisy_ellipsoid(vertices, exec).and_then(|mesh| scan("noisy ellipsoid", mesh, places, exec));
    let others = scans.iter().map(|(name, mesh)| scan(name, on_a_sphere(mesh)?, places, exec));
    closed_forms.chain([noisy]).chain(others).collect()
}

/// The records of all cases.
///
/// # Errors
/// None in practice.
pub fn measure(cases: &[Case], pace: &Pace, observe: &mut Observer<'_>) -> Result<Vec<Record>, StudyError> {
    let mut records = Vec::new();
    for (done, case) in cases.iter().enumerate() {
        observe(&Step { done, total: cases.len(), what: &case.name });
        let work = |interpolation: Interpolation| Contestant {
            name: interpolation.name().to_owned(),
            work: Box::new(move || Ok(case.found(interpolation))),
        };
        let mut contestants: Vec<Contestant<'_, Vec<f64>>> = Interpolation::ALL.map(work).into();
        let timings = race(&mut contestants, pace, &mut |_| ())?;
        let record = |(interpolation, timing)| {
            case.record(interpolation).with_timing(timing, Item::Pixel, case.places.len() as f64)
        };
        records.extend(Interpolation::ALL.into_iter().zip(&timings).map(record));
    }
    Ok(records)
}

impl Case {
    fn found(&self, interpolation: Interpolation) -> Vec<f64> {
        self.places.iter().map(|place| interpolation.curvature(self.corners_of(place), place)).collect()
    }

    fn corners_of(&self, place: &Place) -> [&Corner; 3] {
        place.triangle.map(|vertex| &self.corners[vertex as usize])
    }

    fn record(&self, interpolation: Interpolation) -> Record {
        let squares: f64 = self.truth.iter().map(|(_, larger)| larger * larger).sum();
        let unit = (squares / self.truth.len() as f64).sqrt();
        let found = self.found(interpolation);
        let errors: Vec<f64> =
            found.iter().zip(&self.truth).map(|(found, (curvature, _))| (found - curvature) / unit).collect();
        let wrong = errors.iter().filter(|error| error.abs() > WRONG).count();
        let setting = Setting::default().with("interpolation", interpolation.name());
        let record = Record::of_mesh("curvature_interpolation", setting, &self.name, &self.mesh);
        let record = record.with_norms(Quantity::Curvature, &Norms::of(&errors));
        Record { wrong_share: Some(wrong as f64 / errors.len() as f64), ..record }
    }
}

fn tessellated(surface: ParametricSurface, vertices: u32) -> Result<TessellatedSurface, FieldError> {
    surface.tessellate(&Tessellation { vertices, pattern: Pattern::Jittered, seed: 1, uv_seam: true })
}

fn closed_form(surface: ParametricSurface, vertices: u32, count: u64) -> Result<Case, StudyError> {
    let TessellatedSurface { mesh, parameters } = tessellated(surface, vertices)?;
    let corners = (0_u64..).zip(&parameters).map(|(index, at)| exact_corner(&surface, index, *at)).collect();
    let places = places(&mesh, mesh.triangles(), count);
    let uvs = mesh.uvs().unwrap_or_default();
    let truth = |place: &Place| {
        let [a, b, c] = place.triangle.map(|vertex| uvs[vertex as usize]);
        let at = a * place.weights[0] + b * place.weights[1] + c * place.weights[2];
        let jet = surface.jet(at.x, at.y);
        let forms = jet.forms();
        let forms = FundamentalForms { first: forms.first, second: forms.second };
        let [largest, smallest] = jet.curvature().principal;
        (forms.along(place.direction.x, place.direction.y), largest.abs().max(smallest.abs()))
    };
    let truth = places.iter().map(truth).collect();
    Ok(Case { name: surface.name().to_owned(), mesh, corners, places, truth })
}

/// What is exact at (u, v), with signs drawn at random, and at umbilics the angle.
fn exact_corner(surface: &ParametricSurface, index: u64, at: DVec2) -> Corner {
    /// Principal curvatures that agree to this part are one.
    const UMBILIC: f64 = 1e-9;
    let jet = surface.jet(at.x, at.y);
    let (forms, curvature) = (jet.forms(), jet.curvature());
    let frame = TangentFrame { along_u: jet.du, along_v: jet.dv, normal: jet.normal() };
    let [largest, smallest] = curvature.principal;
    let turned = if largest - smallest <= UMBILIC * largest.abs() { unit(3 * index) * TAU } else { 0.0 };
    let (sin, cos) = libm::sincos(turned);
    let [first, second] = curvature.directions;
    let signs = [1, 2].map(|draw| if unit(3 * index + draw) < 0.5 { -1.0 } else { 1.0 });
    let directions = [first * cos + second * sin, second * cos - first * sin];
    let image = |k: usize| frame.texture_step(directions[k]) * signs[k];
    Corner {
        forms: FundamentalForms { first: forms.first, second: forms.second },
        principal: PrincipalUv { curvatures: curvature.principal, directions: [image(0), image(1)] },
    }
}

fn noisy_ellipsoid(vertices: u32, exec: &Exec<'_>) -> Result<Mesh, StudyError> {
    let clean = tessellated(ParametricSurface::Ellipsoid { a: 1.0, b: 0.8, c: 0.6 }, vertices)?.mesh;
    let edge = curvature::bake(&clean, &CurvatureParams::default(), exec)?.report.mean_edge;
    Ok(with_vertex_noise(&clean, SCAN_NOISE * edge, 1)?)
}

/// The mesh with longitude and latitude about its middle, in radians, for texture coordinates.
fn on_a_sphere(mesh: &Mesh) -> Result<Mesh, StudyError> {
    let middle = mesh.positions().iter().sum::<DVec3>() / mesh.positions().len().max(1) as f64;
    let uv = |position: &DVec3| {
        let out = *position - middle;
        DVec2::new(libm::atan2(out.y, out.x), libm::atan2(out.z, libm::hypot(out.x, out.y)))
    };
    Ok(mesh.clone().with_uvs(mesh.positions().iter().map(uv).collect())?)
}

/// A mesh with texture coordinates, and what a bake says of it.
fn scan(name: &str, mesh: Mesh, count: u64, exec: &Exec<'_>) -> Result<Case, StudyError> {
    let baked = curvature::bake(&mesh, &CurvatureParams::default(), exec)?;
    let forms = curvature::forms(&mesh, &baked, exec).ok_or(StudyError::NoTextureCoordinates)?;
    let corner = |(forms, vertex): (&curvature::VertexForms, &curvature::VertexCurvature)| Corner {
        forms: FundamentalForms { first: forms.first, second: forms.second },
        principal: PrincipalUv { curvatures: vertex.principal, directions: forms.uv_directions },
    };
    let corners: Vec<Corner> = forms.iter().zip(&baked.vertices).map(corner).collect();
    let places = places(&mesh, &charted(&mesh), count);
    let truth = |place: &Place| {
        let mean = |of: &dyn Fn(&Corner) -> f64| -> f64 {
            place
                .triangle
                .iter()
                .zip(place.weights)
                .map(|(&vertex, weight)| weight * of(&corners[vertex as usize]))
                .sum()
        };
        let larger = |corner: &Corner| corner.principal.curvatures.map(f64::abs).into_iter().fold(0.0, f64::max);
        (mean(&|corner| corner.forms.along(place.direction.x, place.direction.y)), mean(&larger))
    };
    let truth = places.iter().map(truth).collect();
    Ok(Case { name: name.to_owned(), mesh, corners, places, truth })
}

/// Places in some triangles, with directions, the same in every run.
fn places(mesh: &Mesh, triangles: &[[u32; 3]], count: u64) -> Vec<Place> {
    let uvs = mesh.uvs().unwrap_or_default();
    let place = |index: u64| {
        let draw = |k: u64| unit(4 * index + k);
        let triangle = triangles[(draw(0) * triangles.len() as f64) as usize];
        // Folded at the diagonal of the square that the triangle is half of.
        let (a, b) = (draw(1), draw(2));
        let (a, b) = if a + b > 1.0 { (1.0 - a, 1.0 - b) } else { (a, b) };
        let corners = triangle.map(|vertex| (mesh.positions()[vertex as usize], uvs[vertex as usize]));
        Place { triangle, weights: [1.0 - a - b, a, b], direction: direction(corners, draw(3) * TAU) }
    };
    (0..count).map(place).collect()
}

/// Triangles none of whose corners belongs to one that texture coordinates distort too much.
fn charted(mesh: &Mesh) -> Vec<[u32; 3]> {
    let uvs = mesh.uvs().unwrap_or_default();
    let mut is_charted = vec![true; uvs.len()];
    for triangle in mesh.triangles() {
        let corners = triangle.map(|vertex| (mesh.positions()[vertex as usize], uvs[vertex as usize]));
        let (along, across) = (direction(corners, 0.0), direction(corners, FRAC_PI_2));
        let evenness = 2.0 * along.perp_dot(across).abs() / (along.length_squared() + across.length_squared());
        if evenness.is_nan() || evenness < LEAST_EVENNESS {
            triangle.iter().for_each(|&vertex| is_charted[vertex as usize] = false);
        }
    }
    let all = mesh.triangles().iter().copied();
    all.filter(|triangle| triangle.iter().all(|&vertex| is_charted[vertex as usize])).collect()
}

/// The direction in the texture of one in the plane of a triangle, at an angle to its first side.
fn direction([(a, uv_a), (b, uv_b), (c, uv_c)]: [(DVec3, DVec2); 3], angle: f64) -> DVec2 {
    let (side, other) = (b - a, c - a);
    let along = side.normalize_or_zero();
    let height = other - along * other.dot(along);
    let across = height.normalize_or_zero();
    let (sin, cos) = libm::sincos(angle);
    // The weights of the two sides in the direction, then the same of their images.
    let weight_of_other = sin / other.dot(across);
    let weight_of_side = (cos - weight_of_other * other.dot(along)) / side.length();
    (uv_b - uv_a) * weight_of_side + (uv_c - uv_a) * weight_of_other
}

#[cfg(test)]
mod tests {
    use super::*;

    fn case(name: &str) -> Case {
        let surface = ParametricSurface::examples().into_iter().find(|surface| surface.name() == name).unwrap();
        closed_form(surface, 400, 500).unwrap()
    }

    #[test]
    fn forms_are_exact_on_a_sphere_and_directions_are_not_even_when_aligned() {
        let sphere = case("sphere");
        let forms = sphere.record(Interpolation::Forms);
        assert!(forms.max.unwrap() < 1e-6, "{forms:?}");
        // All curvatures are one, so solving for the angle errs only where directions cancel; the printed form errs by the chart.
        assert!(sphere.record(Interpolation::DirectionsAsPrinted).wrong_share.unwrap() > 0.1);
    }

    #[test]
    fn forms_beat_directions_whose_signs_are_drawn() {
        let torus = case("torus");
        let wrong = |interpolation| torus.record(interpolation).wrong_share.unwrap();
        assert!(wrong(Interpolation::Forms) < 0.02, "{}", wrong(Interpolation::Forms));
        assert!(wrong(Interpolation::Directions) > 5.0 * wrong(Interpolation::Forms).max(0.01));
    }

    #[test]
    fn a_scan_is_looked_at_where_it_has_a_chart() {
        let exec = Exec::new(1).unwrap();
        let whole = ParametricSurface::Torus { major: 1.0, minor: 0.4 }
            .tessellate(&Tessellation { vertices: 400, pattern: Pattern::Jittered, seed: 1, uv_seam: false })
            .unwrap()
            .mesh;
        let mesh = on_a_sphere(&whole).unwrap();
        let charted = charted(&mesh);
        assert!(!charted.is_empty() && charted.len() < mesh.triangles().len());
        let uvs = mesh.uvs().unwrap();
        // None lies across the seam, where longitude jumps.
        let across = |triangle: &[u32; 3]| {
            let u = triangle.map(|vertex| uvs[vertex as usize].x);
            u.into_iter().fold(f64::MIN, f64::max) - u.into_iter().fold(f64::MAX, f64::min)
        };
        assert!(charted.iter().all(|triangle| across(triangle) < 1.0));
        let case = scan("torus", mesh, 200, &exec).unwrap();
        assert!(case.record(Interpolation::Forms).rms.unwrap() < 0.2);
    }

    #[test]
    fn a_direction_in_the_texture_is_the_image_of_one_in_the_triangle() {
        let positions = [DVec3::ZERO, DVec3::new(2.0, 0.0, 0.0), DVec3::new(1.0, 3.0, 0.0)];
        // A chart that is sheared and stretched.
        let image = |at: DVec3| DVec2::new(0.5 * at.x + 0.2 * at.y, -0.3 * at.y);
        let corners = positions.map(|at| (at, image(at)));
        for angle in [0.0, 0.7, 2.0, 4.0_f64] {
            let expected = image(DVec3::new(angle.cos(), angle.sin(), 0.0));
            assert!((direction(corners, angle) - expected).length() < 1e-12);
        }
    }
}
