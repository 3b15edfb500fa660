//! Where more than one sheet meets: bow-ties, fins, crossings, duplicates, caps.

use super::*;

/// Quads from the z axis, cut in two, outwards along each direction. Vertices 0 and 1 are on the axis, then two per quad.
fn book(directions: &[DVec3]) -> Mesh {
    let mut positions = vec![DVec3::ZERO, DVec3::Z];
    let mut triangles = Vec::new();
    for &direction in directions {
        let outer = positions.len() as u32;
        positions.extend([direction, direction + DVec3::Z]);
        triangles.extend([[0, outer, outer + 1], [0, outer + 1, 1]]);
    }
    Mesh::new(positions, triangles).unwrap()
}

#[test]
fn wings_of_a_bow_tie_are_two_points_and_the_larger_speaks() {
    let corners = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 3.0], [0.0, 3.0, 3.0]];
    let bow_tie = mesh(&corners, &[[0, 1, 2], [0, 3, 4]]);
    let found = sheets(&bow_tie);
    assert_eq!(found.report.points, 6);
    assert_eq!(found.count(VertexFlags::NON_MANIFOLD), 2);
    assert_eq!(found.flags_of(0), VertexFlags::BOUNDARY | VertexFlags::NON_MANIFOLD);
    assert_eq!(found.seen_from(0), [corners[3], corners[4]].map(DVec3::from_array));
    assert!(found.normal_of(0).distance(-DVec3::X) < 1e-12);
    // The other vertices see a wing each.
    assert_eq!(found.seen_from(1).len(), 2);
    assert_eq!(found.flags_of(1), VertexFlags::BOUNDARY);

    // Vertices of their own speak for their own wing.
    let found = sheets(&soup(&bow_tie));
    assert_eq!(found.report.points, 6);
    assert!(found.normal_of(0).distance(DVec3::Z) < 1e-12);
    assert!(found.normal_of(3).distance(-DVec3::X) < 1e-12);
}

#[test]
fn the_stem_of_a_t_is_a_sheet_of_its_own() {
    let fin = book(&[DVec3::X, DVec3::Y * 0.5, -DVec3::X]);
    for mesh in [fin.clone(), soup(&fin)] {
        let found = sheets(&mesh);
        assert_eq!(found.report.non_manifold_edges, 1);
        // Eight places; the stem has the two on the axis for itself.
        assert_eq!(found.report.points, 10);
        assert_eq!(found.count(VertexFlags::NON_MANIFOLD), 4);
    }
    let found = sheets(&fin);
    // One of the two quads was turned over to face as the other.
    assert_eq!(found.report.flipped_triangles, 2);
    // On the axis the bar speaks, which goes on left and right.
    let bar = found.seen_from(0);
    assert!(bar.iter().all(|at| at.y == 0.0) && bar.iter().any(|at| at.x < 0.0) && bar.iter().any(|at| at.x > 0.0));
    assert_eq!(found.normal_of(0).abs(), DVec3::Y);
}

#[test]
fn sheets_that_cross_stay_two_sheets() {
    let tilted = DVec3::new(0.5, 0.9, 0.0);
    let found = sheets(&book(&[DVec3::X, tilted, -DVec3::X, -tilted]));
    assert_eq!((found.report.non_manifold_edges, found.report.points), (1, 12));
    for vertex in [2, 3, 6, 7] {
        assert_eq!(found.normal_of(vertex).abs(), DVec3::Y);
    }
    let across = found.seen_from(4).into_iter().chain(found.seen_from(8));
    assert!(across.into_iter().all(|at| at.x * tilted.y == at.y * tilted.x));
}

#[test]
fn leaves_on_one_side_are_not_joined() {
    // Three within 80°: none goes on beyond the edge.
    let leaf = |degrees: f64| DVec3::new(libm::cos(degrees.to_radians()), libm::sin(degrees.to_radians()), 0.0);
    let found = sheets(&book(&[leaf(0.0), leaf(40.0), leaf(80.0)]));
    assert_eq!(found.report.points, 12);
}

#[test]
fn duplicates_are_dropped_whichever_way_they_face() {
    let sphere = sphere(12, 7);
    let expected = sheets(&sphere);
    let mut triangles = sphere.triangles().to_vec();
    triangles.extend(sphere.triangles()[30..60].iter().map(|&[a, b, c]| [c, b, a]));
    triangles.extend(sphere.triangles()[50..60].iter().map(|&[a, b, c]| [b, c, a]));
    let found = sheets(&with_triangles(&sphere, triangles));
    assert_eq!(found.report.duplicate_triangles, 40);
    assert_eq!((found.report.non_manifold_edges, found.report.flipped_triangles), (0, 0));
    assert_same(&found, &expected);

    // Alone, two of a kind have no edge with more than two triangles.
    let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let pair = sheets(&mesh(&corners, &[[0, 1, 2], [2, 1, 0]]));
    assert_eq!((pair.report.duplicate_triangles, pair.report.points), (1, 3));
    assert_eq!(pair.normals, [DVec3::Z; 3]);
}

#[test]
fn vertices_of_a_duplicate_are_where_the_kept_triangle_is() {
    // Every face of the cube twice, its edges hard.
    let cube = hard_cube();
    let positions = [cube.positions(), cube.positions()].concat();
    let normals = [cube.normals().unwrap(), cube.normals().unwrap()].concat();
    let copies = cube.triangles().iter().map(|corners| corners.map(|corner| corner + 24));
    let triangles = cube.triangles().iter().copied().chain(copies).collect();
    let found = sheets(&Mesh::new(positions, triangles).unwrap().with_normals(normals).unwrap());
    assert_eq!((found.report.duplicate_triangles, found.report.points), (12, 24));
    let (once, again) = found.point_of_vertex.split_at(24);
    assert_eq!(once, again);
}

#[test]
fn a_cap_without_area_joins_its_neighbours_and_says_nothing() {
    // The foot of the upper triangles has a vertex in the middle, that of the lower one does not; the cap 0 2 1 closes the T-junction.
    for tilt in [0.0, 0.7] {
        let turn = |at: [f64; 3]| (glam::DMat3::from_rotation_y(tilt) * DVec3::from_array(at)).to_array();
        let corners = [[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.3, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0]].map(turn);
        let found = sheets(&mesh(&corners, &[[0, 2, 3], [2, 1, 3], [0, 1, 2], [1, 0, 4]]));
        assert_eq!((found.report.points, found.report.collapsed_triangles), (5, 0));
        assert_eq!(found.seen_from(2).len(), 3);
        assert_eq!(found.flags_of(2), VertexFlags::NONE);
        for vertex in 0..5 {
            let expected = DVec3::from_array(turn([0.0, 0.0, 1.0]));
            assert!(found.normal_of(vertex).distance(expected) < 1e-12, "{tilt} {vertex}");
        }
    }
}

#[test]
fn where_no_triangle_has_an_area_there_is_no_normal() {
    let at = |t: f64| [1.0 + t * 0.1, 2.0 + t * 0.7, 3.0 + t * 0.3];
    let found = sheets(&mesh(&[at(0.0), at(1.0), at(2.5), at(3.0)], &[[0, 1, 2], [1, 3, 2]]));
    assert_eq!((found.report.points, found.report.collapsed_triangles), (4, 0));
    assert_eq!(found.normals, [DVec3::ZERO; 4]);
}

#[test]
fn a_slit_between_two_points_parts_nothing() {
    // One edge amid a plane is hard: its ends are still one point each, at the rim of the slit.
    let plane = grid(5, 3, |u, v| DVec3::new(5.0 * u, 3.0 * v, 0.0));
    let whole = sheets(&plane);
    assert_eq!(whole.count(VertexFlags::BOUNDARY), 16);
    // Quads above the edge from vertex 8 to 9 get vertices of their own there, with normals that differ.
    let mut positions = plane.positions().to_vec();
    positions.extend([positions[8], positions[9]]);
    let mut normals = vec![DVec3::Z; 24];
    normals.extend([DVec3::X; 2]);
    let triangles = plane.triangles().iter().map(|&triangle| {
        let above = triangle == [8, 9, 15];
        triangle.map(|vertex| if above && (vertex == 8 || vertex == 9) { vertex + 16 } else { vertex })
    });
    let slit = Mesh::new(positions, triangles.collect()).unwrap().with_normals(normals).unwrap();
    let found = sheets(&slit);
    assert!(found.report.hard_edges >= 1);
    assert_eq!(found.count(VertexFlags::NON_MANIFOLD), 0);
}
