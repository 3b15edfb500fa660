//! Texture coordinates, and the seams that closed surfaces need for them.

use glam::DVec2;

use super::*;

const PATTERNS: [Pattern; 4] =
    [Pattern::Regular { aspect: 1.0 }, Pattern::Jittered, Pattern::Random, Pattern::LongThin { aspect: 5.0 }];

fn everything(uv_seam: bool) -> impl Iterator<Item = (ParametricSurface, TessellatedSurface)> {
    ParametricSurface::examples().into_iter().flat_map(move |surface| {
        let tessellation = |pattern| Tessellation { vertices: 600, pattern, seed: 9, uv_seam };
        PATTERNS.map(|pattern| (surface, surface.tessellate(&tessellation(pattern)).unwrap()))
    })
}

#[test]
fn only_open_surfaces_have_texture_coordinates_without_a_seam() {
    for (surface, found) in everything(false) {
        let expected = (!surface.is_closed_u()).then_some(&found.parameters[..]);
        assert_eq!(found.mesh.uvs(), expected, "{}", surface.name());
    }
}

#[test]
fn a_seam_changes_nothing_about_open_surfaces() {
    for ((surface, whole), (_, cut)) in everything(false).zip(everything(true)) {
        assert_eq!(whole == cut, !surface.is_closed_u(), "{}", surface.name());
    }
}

#[test]
fn a_cut_mesh_is_the_whole_one_with_vertices_repeated() {
    for ((surface, whole), (_, cut)) in everything(false).zip(everything(true)) {
        let (positions, cut_positions) = (whole.mesh.positions(), cut.mesh.positions());
        assert_eq!(positions, &cut_positions[..positions.len()], "{}", surface.name());
        assert_eq!(whole.parameters, cut.parameters[..positions.len()]);
        for (triangle, cut_triangle) in whole.mesh.triangles().iter().zip(cut.mesh.triangles()) {
            let place = |vertex: u32| cut_positions[vertex as usize];
            assert_eq!(triangle.map(place), cut_triangle.map(place));
        }
        assert_eq!(whole.mesh.triangles().len(), cut.mesh.triangles().len());
    }
}

#[test]
fn texture_coordinates_are_the_parameters_up_to_whole_turns() {
    for (surface, found) in everything(true) {
        for (uv, at) in found.mesh.uvs().unwrap().iter().zip(&found.parameters) {
            let turns = *uv - *at;
            let is_pole = surface.has_poles() && (at.y < 2e-6 || at.y > 1.0 - 2e-6);
            let whole = |turn: f64| turn == 0.0 || (turn - 1.0).abs() < 1e-15;
            assert!(whole(turns.y) && (is_pole || whole(turns.x)), "{}: {uv} for {at}", surface.name());
        }
    }
}

#[test]
fn no_triangle_is_torn_or_turned_over_in_texture_space() {
    for (surface, found) in everything(true) {
        let uvs = found.mesh.uvs().unwrap();
        let mut covered = 0.0;
        for triangle in found.mesh.triangles() {
            let [a, b, c] = triangle.map(|vertex| uvs[vertex as usize]);
            let twice_area = (b - a).perp_dot(c - a);
            assert!(twice_area >= 0.0, "{}: {a} {b} {c}", surface.name());
            assert!((a.max(b).max(c) - a.min(b).min(c)).max_element() <= 0.6, "{}: {a} {b} {c}", surface.name());
            covered += 0.5 * twice_area;
        }
        // The cut-out tile covers the texture once; but at each pole half of the triangles' corner is missing.
        assert!((0.9..1.0 + 1e-9).contains(&covered), "{} covers {covered}", surface.name());
    }
}

#[test]
fn a_torus_is_cut_along_both_of_its_circles() {
    let tessellation = Tessellation { vertices: 600, pattern: Pattern::Jittered, seed: 1, uv_seam: true };
    let found = example("torus").tessellate(&tessellation).unwrap();
    let uvs = found.mesh.uvs().unwrap();
    let beyond = |past: fn(&DVec2) -> bool| uvs.iter().filter(|uv| past(uv)).count();
    assert!(beyond(|uv| uv.x >= 1.0) > 0 && beyond(|uv| uv.y >= 1.0) > 0);
}
