//! Bodies of very few triangles.

use barchan_asset::VertexFlags;
use barchan_bakers::curvature::CurvatureMethod;
use barchan_field::Mesh;
use glam::DVec3;

use crate::support::{assert_finite, bake_with, baked, count};

fn mesh(positions: &[[f64; 3]], triangles: &[[u32; 3]]) -> Mesh {
    Mesh::new(positions.iter().map(|&position| position.into()).collect(), triangles.to_vec()).unwrap()
}

fn tetrahedron() -> Mesh {
    mesh(
        &[[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]],
        &[[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]],
    )
}

fn octahedron() -> Mesh {
    let positions = [DVec3::X, -DVec3::X, DVec3::Y, -DVec3::Y, DVec3::Z, -DVec3::Z];
    let triangles = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
    Mesh::new(positions.to_vec(), triangles.to_vec()).unwrap()
}

/// Corner i is at the signs of the bits of i.
fn cube() -> Mesh {
    let positions = (0..8).map(|corner: u32| {
        let side = |bit: u32| if corner >> bit & 1 == 1 { 1.0 } else { -1.0 };
        DVec3::new(side(0), side(1), side(2))
    });
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = faces.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]);
    Mesh::new(positions.collect(), triangles.collect()).unwrap()
}

fn icosahedron() -> Mesh {
    let golden = 0.5 * (1.0 + 5.0_f64.sqrt());
    let corners = |cycle: fn(f64, f64) -> DVec3| {
        [(1.0, golden), (-1.0, golden), (1.0, -golden), (-1.0, -golden)].map(|(a, b)| cycle(a, b))
    };
    let positions: Vec<DVec3> = [
        corners(|a, b| DVec3::new(0.0, a, b)),
        corners(|a, b| DVec3::new(a, b, 0.0)),
        corners(|a, b| DVec3::new(b, 0.0, a)),
    ]
    .concat();
    // Its triangles are those of three corners one edge, 2, apart.
    let mut triangles = Vec::new();
    let near = |a: u32, b: u32| (positions[a as usize].distance(positions[b as usize]) - 2.0).abs() < 1e-9;
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                if near(a, b) && near(b, c) && near(c, a) {
                    let [x, y, z] = [a, b, c].map(|corner| positions[corner as usize]);
                    let outwards = (y - x).cross(z - x).dot(x) > 0.0;
                    triangles.push(if outwards { [a, b, c] } else { [a, c, b] });
                }
            }
        }
    }
    assert_eq!(triangles.len(), 20);
    Mesh::new(positions, triangles).unwrap()
}

#[test]
fn a_solid_in_a_sphere_is_round() {
    for (name, solid) in
        [("tetrahedron", tetrahedron()), ("octahedron", octahedron()), ("cube", cube()), ("icosahedron", icosahedron())]
    {
        let expected = 1.0 / solid.positions()[0].length();
        for method in CurvatureMethod::ALL {
            let found = bake_with(&solid, method, 1);
            assert_finite(&found);
            println!(
                "SOLID {name} {method:?} {expected} {:?}",
                found.vertices.iter().map(|v| (v.principal, v.flags.0)).collect::<Vec<_>>()
            );
            for vertex in &found.vertices {
                for curvature in vertex.principal {
                    assert!((0.5..1.5).contains(&(curvature / expected)), "{name}, {method:?}: {vertex:?}");
                }
                assert_eq!(vertex.flags, VertexFlags::NONE, "{name}, {method:?}");
            }
        }
    }
}

#[test]
fn a_single_triangle_is_flat() {
    let triangle = mesh(&[[1.0, 2.0, 3.0], [2.0, 2.5, 3.5], [1.0, 4.0, 3.0]], &[[0, 1, 2]]);
    for method in CurvatureMethod::ALL {
        let found = bake_with(&triangle, method, 1);
        assert_finite(&found);
        for vertex in &found.vertices {
            assert!(vertex.principal[0].abs().max(vertex.principal[1].abs()) < 1e-12, "{vertex:?}");
            assert_eq!(vertex.flags, VertexFlags::BOUNDARY);
        }
    }
}

#[test]
fn a_flat_sheet_of_few_vertices_is_flat() {
    for columns in 1..6_u32 {
        let positions = (0..=columns).flat_map(|x| [0.0, 1.0].map(|y| [f64::from(x), y, 0.0])).collect::<Vec<_>>();
        let quad = |x: u32| [[2 * x, 2 * x + 2, 2 * x + 1], [2 * x + 1, 2 * x + 2, 2 * x + 3]];
        let found = baked(&mesh(&positions, &(0..columns).flat_map(quad).collect::<Vec<_>>()));
        assert_finite(&found);
        for vertex in &found.vertices {
            assert!(vertex.principal[0].abs().max(vertex.principal[1].abs()) < 1e-9, "{columns}: {vertex:?}");
        }
    }
}

#[test]
fn a_triangle_on_a_line_is_degenerate() {
    let line = mesh(&[[0.0; 3], [1.0; 3], [3.0; 3]], &[[0, 1, 2]]);
    for method in CurvatureMethod::ALL {
        let found = bake_with(&line, method, 1);
        assert_finite(&found);
        assert_eq!(count(&found, VertexFlags::DEGENERATE), 3, "{found:?}");
        assert!(found.vertices.iter().all(|vertex| vertex.principal == [0.0; 2] && vertex.flags.is_unknown()));
    }
}

#[test]
fn a_mesh_of_nothing_is_nothing() {
    assert!(baked(&mesh(&[], &[])).vertices.is_empty());
    let lonely = baked(&mesh(&[[1.0; 3]], &[]));
    assert_eq!(count(&lonely, VertexFlags::ISOLATED), 1);
}
