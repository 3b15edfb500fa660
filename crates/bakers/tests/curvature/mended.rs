//! The same surface, badly written: what a mesh is mended to must have the curvature of the mesh it was made from.

use std::collections::HashMap;

use barchan_asset::VertexFlags;
use barchan_bakers::curvature::CurvatureMethod;
use barchan_field::Mesh;
use barchan_field::surfaces::{Pattern, Tessellation};
use glam::DVec3;

use crate::support::{Case, assert_finite, bake_with, baked, bits, count, difference, example, random};

/// Closed, open, and bent both ways.
fn cases() -> impl Iterator<Item = (&'static str, Case)> {
    ["ellipsoid", "torus", "helicoid", "bezier_patch"]
        .into_iter()
        .map(|name| (name, Case::example(name, Pattern::Random, 2000)))
}

#[track_caller]
fn assert_as_good(name: &str, clean_case: &Case, other: &Case) {
    let (clean, found) = (clean_case.clean().rms, other.clean().rms);
    println!(
        "MENDED {} {name} {clean:.2e} {found:.2e} ratio {:.3}",
        std::panic::Location::caller().line(),
        found / clean
    );
    assert!(found <= 1.5 * clean, "{name}: {found}, clean {clean}");
    let [clean, found] =
        [clean_case, other].map(|case| case.errors(&bake_with(&case.mesh, CurvatureMethod::Fast, 1)).rms);
    assert!(found <= 1.5 * clean, "{name}, fast: {found}, clean {clean}");
}

fn soup(case: &Case) -> Case {
    let origin: Vec<u32> = case.mesh.triangles().iter().flatten().copied().collect();
    let triangles = (0..origin.len() as u32 / 3).map(|first| [0, 1, 2].map(|corner| 3 * first + corner)).collect();
    case.remade(&origin, triangles)
}

#[test]
fn a_soup_has_the_curvature_of_its_surface() {
    for (name, case) in cases() {
        let soup = soup(&case);
        assert_as_good(name, &case, &soup);
        let found = baked(&soup.mesh);
        let mut whole = baked(&case.mesh);
        let corners = case.mesh.triangles().iter().flatten();
        whole.vertices = corners.map(|&vertex| whole.vertices[vertex as usize]).collect();
        // Rounding: numbers of points differ, and with them the order of sums.
        assert!(difference(&whole, &found) < 1e-5, "{name}: {}", difference(&whole, &found));
    }
}

#[test]
fn vertices_at_one_place_agree_to_the_bit() {
    for name in ["sphere", "ellipsoid", "torus", "cylinder", "cone"] {
        let tessellation = Tessellation { vertices: 2000, pattern: Pattern::Random, seed: 5, uv_seam: true };
        let made = example(name).tessellate(&tessellation).unwrap();
        let found = baked(&made.mesh);
        assert_finite(&found);
        let mut places = HashMap::new();
        let mut repeated = 0;
        for (position, vertex) in made.mesh.positions().iter().zip(&found.vertices) {
            let place = position.to_array().map(|coordinate| (coordinate + 0.0).to_bits());
            let first = *places.entry(place).or_insert(vertex);
            repeated += usize::from(!core::ptr::eq(first, vertex));
            assert_eq!(first, vertex, "{name}");
            assert!(name == "cylinder" || name == "cone" || !vertex.flags.contains(VertexFlags::BOUNDARY), "{name}");
        }
        assert!(repeated > 10, "{name} has no seam");
    }
}

#[test]
fn a_seam_of_texture_coordinates_costs_nothing() {
    let surface = example("torus");
    let made = |uv_seam| {
        let tessellation = Tessellation { vertices: 2000, pattern: Pattern::Random, seed: 5, uv_seam };
        let made = surface.tessellate(&tessellation).unwrap();
        let truth = made.parameters.iter().map(|at| surface.jet(at.x, at.y).curvature()).collect();
        Case { mesh: made.mesh, truth }
    };
    assert_as_good("torus", &made(false), &made(true));
}

#[test]
fn duplicate_vertices_and_triangles_say_nothing_new() {
    for (name, case) in cases() {
        let count = case.mesh.positions().len() as u32;
        let origin: Vec<u32> = (0..count).chain(0..count).collect();
        let mut random = random(7);
        let mut triangles = Vec::new();
        for &[a, b, c] in case.mesh.triangles() {
            // Each corner is one of the two vertices at its place.
            triangles.push([a, b, c].map(|vertex| if random() < 0.5 { vertex } else { vertex + count }));
            if random() < 0.2 {
                triangles.push([b, c, a + count]);
            }
            if random() < 0.1 {
                triangles.push([c, b, a]);
            }
        }
        // Vertices that are drawn into no triangle are isolated: they are not asked.
        let doubled = case.remade(&origin, triangles);
        let (clean, found) = (baked(&case.mesh), baked(&doubled.mesh));
        assert!(found.report.duplicate_triangles > 500);
        let known = doubled.errors_at(&found, |vertex| !found.vertices[vertex].flags.contains(VertexFlags::ISOLATED));
        println!("DUP {name} {:.2e} {:.2e}", case.errors(&clean).rms, known.rms);
        assert!(known.rms <= 1.5 * case.errors(&clean).rms, "{name}: {known:?}");
    }
}

#[test]
fn triangles_that_face_the_wrong_way_are_turned() {
    for (name, case) in cases() {
        let mut random = random(11);
        let mut turned = 0;
        let triangles = case.mesh.triangles().iter().map(|&[a, b, c]| {
            let turn = random() < 0.3;
            turned += u64::from(turn);
            if turn { [a, c, b] } else { [a, b, c] }
        });
        let flipped = case.with_triangles(triangles.collect());
        let (clean, found) = (baked(&case.mesh), baked(&flipped.mesh));
        assert_eq!(found.report.flipped_triangles, turned);
        let different = difference(&clean, &found);
        println!("FLIP {name} {different:.2e} same bits {}", bits(&clean) == bits(&found));
        assert!(different <= 1e-9, "{name}: {different}");
    }
}

#[test]
fn an_isolated_vertex_is_zero_and_says_so() {
    let case = Case::example("torus", Pattern::Random, 1000);
    let mut positions = case.mesh.positions().to_vec();
    positions.splice(500..500, [DVec3::new(0.1, 0.2, 0.3); 3]);
    let moved = |vertex: u32| if vertex < 500 { vertex } else { vertex + 3 };
    let mut triangles: Vec<[u32; 3]> = case.mesh.triangles().iter().map(|corners| corners.map(moved)).collect();
    // One of them has a triangle, but one without corners.
    triangles.push([502, 502, 502]);
    let found = baked(&Mesh::new(positions, triangles).unwrap());
    assert_eq!(count(&found, VertexFlags::ISOLATED), 3);
    for vertex in &found.vertices[500..503] {
        assert_eq!(vertex.principal, [0.0; 2]);
        assert!(vertex.flags.is_unknown());
    }
    let others = found.vertices.iter().enumerate().filter(|(vertex, _)| !(500..503).contains(vertex));
    for ((_, found), clean) in others.zip(&baked(&case.mesh).vertices) {
        assert!((found.principal[0] - clean.principal[0]).abs() < 1e-9);
    }
}
