//! Tessellations: manifolds of the right kind, on the surface, Delaunay, and the same everywhere.

use std::collections::{HashMap, HashSet};

use glam::DVec2;

use super::*;
use crate::Mesh;

const PATTERNS: [Pattern; 4] =
    [Pattern::Regular { aspect: 1.0 }, Pattern::Jittered, Pattern::Random, Pattern::LongThin { aspect: 10.0 }];

/// Every example in every pattern, with about `vertices` vertices.
fn everything(vertices: u32) -> impl Iterator<Item = (ParametricSurface, Pattern, TessellatedSurface)> {
    let examples = ParametricSurface::examples().into_iter();
    examples.flat_map(move |surface| PATTERNS.map(|pattern| (surface, pattern, mesh_of(&surface, vertices, pattern))))
}

/// How often each edge is run along in each direction.
fn directed_edges(mesh: &Mesh) -> HashMap<[u32; 2], u32> {
    let mut uses = HashMap::new();
    for &[a, b, c] in mesh.triangles() {
        for edge in [[a, b], [b, c], [c, a]] {
            *uses.entry(edge).or_default() += 1;
        }
    }
    uses
}

/// The borders of a mesh as closed walks: their number.
fn border_loops(edges: &HashMap<[u32; 2], u32>) -> usize {
    let open = edges.keys().filter(|[a, b]| !edges.contains_key(&[*b, *a]));
    let mut next: HashMap<u32, u32> = HashMap::new();
    for &[a, b] in open {
        assert_eq!(next.insert(a, b), None, "two borders touch at vertex {a}");
    }
    let mut loops = 0;
    while let Some(&start) = next.keys().next() {
        let mut at = start;
        while let Some(following) = next.remove(&at) {
            at = following;
        }
        assert_eq!(at, start, "a border does not close");
        loops += 1;
    }
    loops
}

#[test]
fn meshes_are_oriented_manifolds_with_borders_only_where_the_surface_has_them() {
    for (surface, pattern, found) in everything(700) {
        let (name, mesh) = (surface.name(), &found.mesh);
        let edges = directed_edges(mesh);
        assert!(edges.values().all(|&uses| uses == 1), "{name} {pattern:?}: an edge is run along twice");
        let undirected: HashSet<_> = edges.keys().map(|&[a, b]| [a.min(b), a.max(b)]).collect();
        let characteristic = mesh.positions().len() as i64 - undirected.len() as i64 + mesh.triangles().len() as i64;
        let expected = match name {
            "sphere" | "ellipsoid" => (2, 0),
            "torus" => (0, 0),
            "cylinder" | "cone" => (0, 2),
            _ => (1, 1),
        };
        assert_eq!((characteristic, border_loops(&edges)), expected, "{name} {pattern:?}");
    }
}

#[test]
fn every_vertex_is_the_surface_at_its_parameters() {
    for (surface, pattern, found) in everything(500) {
        assert_eq!(found.mesh.positions().len(), found.parameters.len());
        for (&position, at) in found.mesh.positions().iter().zip(&found.parameters) {
            assert!(at.cmpge(DVec2::ZERO).all() && at.cmple(DVec2::ONE).all(), "{at}");
            assert_eq!(position, surface.jet(at.x, at.y).position);
            let curvature = surface.jet(at.x, at.y).curvature().principal;
            assert!(curvature.iter().all(|value| value.is_finite()), "{} {pattern:?} at {at}", surface.name());
        }
    }
}

#[test]
fn there_are_nearly_as_many_vertices_as_were_asked_for() {
    for (surface, pattern, found) in everything(4000) {
        let ratio = found.parameters.len() as f64 / 4000.0;
        assert!((0.95..=1.05).contains(&ratio), "{} {pattern:?}: {ratio}", surface.name());
    }
}

/// Triangles whose front looks away from the fronts of the surface at their corners.
fn folded(surface: &ParametricSurface, found: &TessellatedSurface) -> usize {
    let is_folded = |triangle: &&[u32; 3]| {
        let corners = corners_of(found, triangle);
        let [a, b, c] = corners.map(|(position, _)| position);
        let fronts = corners.map(|(_, at)| surface.jet(at.x, at.y).normal());
        (b - a).cross(c - a).dot(fronts[0] + fronts[1] + fronts[2]) <= 0.0
    };
    found.mesh.triangles().iter().filter(is_folded).count()
}

#[test]
fn triangles_look_the_way_the_surface_looks() {
    for (surface, pattern, found) in everything(4000) {
        let allowed = match pattern {
            Pattern::Regular { .. } | Pattern::Jittered => 0,
            Pattern::Random | Pattern::LongThin { .. } => found.mesh.triangles().len() / 500,
        };
        let folded = folded(&surface, &found);
        assert!(folded <= allowed, "{} {pattern:?}: {folded} triangles are folded over", surface.name());
    }
}

#[test]
fn delaunay_triangles_of_a_sphere_are_its_convex_hull() {
    let found = mesh_of(&example("sphere"), 200, Pattern::Random);
    for triangle in found.mesh.triangles() {
        let [a, b, c] = corners_of(&found, triangle).map(|(position, _)| position);
        let outwards = (b - a).cross(c - a).normalize();
        let highest = found.mesh.positions().iter().map(|p| (*p - a).dot(outwards)).fold(0.0, f64::max);
        assert!(highest < 1e-12, "a vertex lies {highest} above a triangle");
    }
}

#[test]
fn delaunay_triangles_of_a_cylinder_have_no_vertex_in_their_circle() {
    // A cylinder unrolls without distortion, so its chart is exact.
    let found = mesh_of(&ParametricSurface::Cylinder { radius: 1.0, height: 2.0 }, 300, Pattern::Jittered);
    let turn = std::f64::consts::TAU;
    let flat = |at: DVec2| DVec2::new(at.x * turn, at.y * 2.0);
    for triangle in found.mesh.triangles() {
        let [a, b, c] = corners_of(&found, triangle).map(|(_, at)| flat(at));
        let near_a = |p: DVec2| p - DVec2::X * turn * ((p.x - a.x) / turn).round();
        let (b, c) = (near_a(b) - a, near_a(c) - a);
        let (bb, cc) = (b.length_squared(), c.length_squared());
        let centre = DVec2::new(c.y * bb - b.y * cc, b.x * cc - c.x * bb) / (2.0 * b.perp_dot(c));
        let inside = |at: &&DVec2| (near_a(flat(**at)) - a - centre).length() < centre.length() - 1e-9;
        // `near_a` unrolls around one corner; what lies half a turn away is far outside of any circle.
        assert_eq!(found.parameters.iter().find(inside), None);
    }
}

#[test]
fn seeds_matter_where_there_is_chance() {
    let torus = example("torus");
    for pattern in PATTERNS {
        let of_seed = |seed| torus.tessellate(&Tessellation { vertices: 500, pattern, seed, uv_seam: false }).unwrap();
        assert_eq!(of_seed(1) == of_seed(2), matches!(pattern, Pattern::Regular { .. }), "{pattern:?}");
        assert_eq!(of_seed(1), of_seed(1));
    }
}

fn digest(meshes: &[Mesh]) -> u64 {
    let words = meshes.iter().flat_map(|mesh| {
        let positions = mesh.positions().iter().flat_map(|p| p.to_array().map(f64::to_bits));
        positions.chain(mesh.triangles().iter().flatten().map(|&corner| u64::from(corner)))
    });
    let bytes = words.flat_map(u64::to_le_bytes);
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

#[test]
fn meshes_have_the_same_bits_everywhere() {
    let pinned: [(&str, u64); 10] = [
        ("sphere", 0x79e0_eaca_dfad_3459),
        ("ellipsoid", 0x4707_3876_04cd_38af),
        ("torus", 0xa999_ba87_836b_3939),
        ("cylinder", 0x76a7_604c_cb6d_963e),
        ("cone", 0x5961_bde8_24d1_8e26),
        ("saddle", 0x771f_2adb_d5d2_2b83),
        ("monkey_saddle", 0x7eb6_51a2_ee67_90e1),
        ("helicoid", 0xd019_e9e8_bb14_4626),
        ("wavy_sheet", 0x00e8_52d7_fe21_cb61),
        ("bezier_patch", 0x6357_ac50_387e_64d2),
    ];
    let in_every_pattern = |surface| PATTERNS.map(|pattern| mesh_of(surface, 500, pattern).mesh);
    let examples = ParametricSurface::examples();
    let found: Vec<_> = examples.iter().map(|surface| (surface.name(), digest(&in_every_pattern(surface)))).collect();
    assert_eq!(found, pinned, "the bits have changed; {found:#x?}");
}

#[test]
fn scale_does_not_matter() {
    // By powers of two, so that not even rounding differs.
    for scale in [-28, 29].map(|power| 2.0_f64.powi(power)) {
        let scaled = ParametricSurface::Torus { major: scale, minor: 0.4 * scale };
        for pattern in PATTERNS {
            let [scaled, unit] = [mesh_of(&scaled, 500, pattern), mesh_of(&example("torus"), 500, pattern)];
            let grown: Vec<DVec3> = unit.mesh.positions().iter().map(|p| *p * scale).collect();
            assert_eq!(scaled.mesh.positions(), grown, "{scale} {pattern:?}");
            assert_eq!(scaled.mesh.triangles(), unit.mesh.triangles(), "{scale} {pattern:?}");
        }
    }
}

#[test]
fn as_few_vertices_as_are_accepted_make_a_mesh_or_are_refused_in_words() {
    for surface in ParametricSurface::examples() {
        for pattern in PATTERNS {
            for seed in 0..4 {
                let found = surface.tessellate(&Tessellation { vertices: 16, pattern, seed, uv_seam: true });
                if let Err(error) = found {
                    let message = error.to_string();
                    assert!(message.contains(surface.name()) && message.contains("16 vertices"), "{message}");
                }
            }
        }
    }
}

#[test]
fn long_or_thin_surfaces_are_meshed_or_refused() {
    let extremes = [
        ParametricSurface::Cylinder { radius: 1e-9, height: 1e9 },
        ParametricSurface::Cylinder { radius: 1e9, height: 1e-9 },
        ParametricSurface::Ellipsoid { a: 1e9, b: 1e-9, c: 1.0 },
        ParametricSurface::Helicoid { inner_radius: 0.0, outer_radius: 1e9, pitch: 1e-9, turns: 100.0 },
        ParametricSurface::Torus { major: 1e9, minor: 1e-9 },
        ParametricSurface::Saddle { valley_radius: 1e-9, ridge_radius: 1e-9, size: 1e9 },
    ];
    for surface in extremes {
        for pattern in PATTERNS {
            let tessellation = Tessellation { vertices: 500, pattern, seed: 0, uv_seam: false };
            if let Err(error) = surface.tessellate(&tessellation) {
                assert!(matches!(error, FieldError::Tessellation { .. }), "{error}");
            }
        }
    }
}
