//! Vertices to points.

use super::*;

#[test]
fn the_seam_and_the_poles_of_a_sphere_are_welded() {
    let (columns, rows) = (12, 7);
    let found = sheets(&sphere(columns, rows));
    let points = columns * (rows - 1) + 2;
    assert_eq!(found.report.points, u64::from(points));
    // One triangle of each quad at a pole has two corners there.
    assert_eq!(found.report.collapsed_triangles, u64::from(2 * columns));
    // V − E + F = 2 and every edge has two triangles: neighbours are 2 E = 6 V − 12.
    assert_eq!(found.neighbours.len() as u32, 6 * points - 12);
    assert!(found.flags.iter().all(|&flags| flags == VertexFlags::NONE));
    assert_eq!(found.report.flipped_triangles, 0);
    assert!(found.point_of_vertex.iter().all(Option::is_some));
}

#[test]
fn normals_of_a_sphere_point_outwards() {
    let found = sheets(&sphere(48, 24));
    for (position, normal) in found.positions.iter().zip(&found.normals) {
        assert!(position.dot(*normal) > 0.999, "{position} {normal}");
        assert!((normal.length() - 1.0).abs() < 1e-12);
    }
}

#[test]
fn neighbours_run_counter_clockwise_and_are_mutual() {
    let found = sheets(&sphere(12, 7));
    for point in 0..found.positions.len() {
        let around = &found.neighbours[found.starts[point] as usize..found.starts[point + 1] as usize];
        assert_eq!(around.iter().min(), around.first());
        for (&a, &b) in around.iter().zip(around.iter().cycle().skip(1)) {
            let [middle, a_at, b_at] = [point, a as usize, b as usize].map(|point| found.positions[point]);
            assert!((a_at - middle).cross(b_at - middle).dot(middle) > 0.0);
            let back = &found.neighbours[found.starts[a as usize] as usize..found.starts[a as usize + 1] as usize];
            assert!(back.contains(&(point as u32)));
        }
    }
}

#[test]
fn a_boundary_is_walked_from_end_to_end() {
    let found = sheets(&grid(2, 2, |u, v| DVec3::new(u, v, 0.0)));
    assert_eq!(found.count(VertexFlags::BOUNDARY), 8);
    let at = |x: f64, y: f64| DVec3::new(x, y, 0.0);
    // The middle of the lower side.
    assert_eq!(found.seen_from(1), [at(1.0, 0.0), at(1.0, 0.5), at(0.5, 0.5), at(0.0, 0.0)]);
    assert_eq!(found.seen_from(4).len(), 6);
}

#[test]
fn a_soup_is_the_surface_it_was_cut_from() {
    let sphere = sphere(12, 7);
    let (whole, cut) = (sheets(&sphere), sheets(&soup(&sphere)));
    assert_eq!(cut.report, crate::curvature::MeshReport { mean_edge: cut.report.mean_edge, ..whole.report });
    assert!((cut.report.mean_edge / whole.report.mean_edge - 1.0).abs() < 1e-12);
    // Vertex by vertex the neighbours are at the same positions, from the same or another one on.
    for (corner, &vertex) in sphere.triangles().iter().flatten().enumerate() {
        let mut expected = whole.seen_from(vertex);
        let found = cut.seen_from(corner as u32);
        let start = expected.iter().position(|&at| at == found[0]).unwrap();
        expected.rotate_left(start);
        assert_eq!(found, expected);
    }
}

#[test]
fn the_mean_edge_is_that_of_edges_between_points() {
    // Two triangles on a square: four sides of 2, one diagonal; a collapsed triangle and an unused vertex have no say.
    let found = sheets(&mesh(
        &[[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 2.0, 0.0], [90.0, 0.0, 0.0]],
        &[[0, 1, 2], [0, 2, 3], [0, 0, 3]],
    ));
    assert!((found.report.mean_edge - (8.0 + 8.0_f64.sqrt()) / 5.0).abs() < 1e-15);
    assert_eq!(found.report.collapsed_triangles, 1);
}

#[test]
fn a_cube_has_eight_corners_or_twenty_four() {
    let smooth = sheets(&cube());
    assert_eq!((smooth.report.points, smooth.report.hard_edges), (8, 0));
    assert_eq!(smooth.count(VertexFlags::BOUNDARY), 0);
    for (position, normal) in smooth.positions.iter().zip(&smooth.normals) {
        // By angle, however the faces are cut.
        let outwards = (*position - DVec3::splat(0.5)).normalize();
        assert!(normal.distance(outwards) < 1e-7, "{position} {normal}");
    }

    let hard = sheets(&hard_cube());
    assert_eq!((hard.report.points, hard.report.hard_edges), (24, 12));
    assert_eq!(hard.count(VertexFlags::BOUNDARY), 24);
    assert_eq!(hard.count(VertexFlags::NON_MANIFOLD), 0);
    for vertex in 0..24 {
        assert_eq!(hard.normal_of(vertex), cube_normals()[vertex as usize / 4]);
    }
}

#[test]
fn an_edge_is_hard_beyond_the_angle_only() {
    for (degrees, edges) in [(0.0, 12), (89.9, 12), (90.1, 0), (180.0, 0)] {
        let found = Sheets::of(&hard_cube(), degrees, &Exec::new(1).unwrap());
        assert_eq!(found.report.hard_edges, edges, "{degrees}");
    }
}

#[test]
fn normals_of_no_length_state_nothing() {
    let silent = cube().with_normals(vec![DVec3::ZERO; 24]).unwrap();
    assert_eq!(sheets(&silent).report.points, 8);
}

#[test]
fn the_length_of_normals_means_nothing() {
    for length in [1e-200, 1e200] {
        let normals = hard_cube().normals().unwrap().iter().map(|&normal| normal * length).collect();
        assert_eq!(sheets(&cube().with_normals(normals).unwrap()).report.hard_edges, 12);
    }
}

#[test]
fn sides_of_a_thin_shell_stay_apart() {
    // A thousandth of an edge apart, facing away from each other.
    let [front, back] = [0.0, 1e-4].map(|height| grid(10, 10, move |u, v| DVec3::new(u, v, height)));
    let positions = [front.positions(), back.positions()].concat();
    let turned = back.triangles().iter().map(|&[a, b, c]| [a + 121, c + 121, b + 121]);
    let triangles = front.triangles().iter().copied().chain(turned).collect();
    let found = sheets(&Mesh::new(positions, triangles).unwrap());
    assert_eq!(found.report.points, 242);
    assert_eq!(found.normal_of(60), DVec3::Z);
    assert_eq!(found.normal_of(181), -DVec3::Z);
}

#[test]
fn the_tolerance_is_relative_to_the_mean_edge_wherever_the_mesh_is() {
    // Two right triangles with legs of 1, `gap` mean edges apart along the diagonal.
    let mean = (2.0 + 2.0_f64.sqrt()) / 3.0;
    let apart = |gap: f64, scale: f64, offset: f64| {
        let gap = gap * mean * 0.5_f64.sqrt();
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0 + gap, gap], [1.0 + gap, 1.0 + gap], [gap, 1.0 + gap]];
        let positions = corners.map(|[x, y]| [x, y, 0.0].map(|coordinate| coordinate * scale + offset));
        sheets(&mesh(&positions, &[[0, 1, 2], [3, 4, 5]])).report.points
    };
    for (scale, offset) in [(1.0, 0.0), (1e6, 0.0), (1e-6, 0.0), (1.0, 1e7), (1e-25, 0.0), (1e25, 1e25)] {
        assert_eq!(apart(0.9e-5, scale, offset), 4, "{scale} {offset}");
        assert_eq!(apart(1.1e-5, scale, offset), 6, "{scale} {offset}");
    }
}

#[test]
fn a_row_of_ever_so_close_vertices_does_not_shrink_to_a_point() {
    // Spikes of length 1 whose feet are 0.4 tolerances apart: every third foot is a centre, which the next two join.
    for feet in [9_u32, 300] {
        let step = 0.4e-5 * 2.0 / 3.0;
        let mut positions = vec![[0.0, 1.0, 0.0]];
        positions.extend((0..=feet).map(|foot| [f64::from(foot) * step, 0.0, 0.0]));
        let triangles: Vec<[u32; 3]> = (1..=feet).map(|foot| [0, foot, foot + 1]).collect();
        let found = sheets(&mesh(&positions, &triangles));
        assert_eq!(found.report.points, u64::from(1 + feet / 3 + 1), "{feet}");
        let centre = found.point_of_vertex[4];
        assert_eq!([5, 6].map(|vertex: usize| found.point_of_vertex[vertex]), [centre; 2]);
        assert_ne!(found.point_of_vertex[7], centre);
    }
}

#[test]
fn welding_is_the_rule_applied_to_one_vertex_after_the_other() {
    for count in [20_usize, 400] {
        // Feet of unit spikes, at random in a cube of six tolerances.
        let mut random = random(count as u64);
        let mut draw = || random(1 << 20) as f64 / f64::from(1 << 20) * 6e-5;
        let feet: Vec<DVec3> = (0..count).map(|_| DVec3::new(draw(), draw(), draw())).collect();
        let tips = [DVec3::X, DVec3::new(0.5, 0.75_f64.sqrt(), 0.0)];
        let positions: Vec<DVec3> = feet.iter().copied().chain(tips).collect();
        let triangles = (0..count as u32).map(|foot| [foot, count as u32, count as u32 + 1]).collect();
        let found = sheets(&Mesh::new(positions, triangles).unwrap());

        let mut order: Vec<usize> = (0..count).collect();
        order.sort_by(|&a, &b| feet[a].to_array().partial_cmp(&feet[b].to_array()).unwrap());
        let sides: f64 =
            feet.iter().map(|&foot| 1.0 + tips.map(|tip| foot.distance(tip)).into_iter().sum::<f64>()).sum();
        let tolerance = 1e-5 * sides / (3 * count) as f64;
        let mut centres: Vec<usize> = Vec::new();
        for foot in order {
            let centre = centres.iter().copied().find(|&centre| feet[centre].distance(feet[foot]) <= tolerance);
            let expected = feet[centre.unwrap_or(foot)];
            if centre.is_none() {
                centres.push(foot);
            }
            assert_eq!(found.positions[found.point_of_vertex[foot].unwrap() as usize], expected, "{count} {foot}");
        }
        assert!(centres.len() > 10 && centres.len() < count);
    }
}

#[test]
fn one_far_vertex_makes_all_others_one_place_and_no_delay() {
    let small = grid(200, 200, |u, v| DVec3::new(u, v, 0.0));
    let mut positions = small.positions().to_vec();
    positions.push(DVec3::splat(1e15));
    let mut triangles = small.triangles().to_vec();
    triangles.push([0, 200, positions.len() as u32 - 1]);
    let found = sheets(&Mesh::new(positions, triangles).unwrap());
    assert_eq!(found.report.collapsed_triangles, 80_001);
    assert_eq!(found.report.points, 0);
}

#[test]
fn who_has_no_triangle_has_no_point() {
    // Vertex 3 is isolated, at the place of vertex 0; 4 and 5 have but a collapsed triangle; 6 has one too, at the place of vertex 1.
    let found = sheets(&mesh(
        &[
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0],
            [5.0, 0.0, 0.0],
            [6.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
        ],
        &[[4, 5, 4], [0, 1, 2], [6, 6, 1]],
    ));
    assert_eq!(found.point_of_vertex, [Some(0), Some(1), Some(2), None, None, None, Some(1)]);
    assert_eq!((found.report.points, found.report.collapsed_triangles), (3, 2));
}

#[test]
fn the_least_meshes() {
    let empty = sheets(&mesh(&[], &[]));
    assert_eq!((empty.report.points, empty.starts, empty.report.mean_edge), (0, vec![0], 0.0));

    let triangle = sheets(&mesh(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], &[[0, 1, 2]]));
    assert_eq!(triangle.neighbours, [1, 2, 2, 0, 0, 1]);
    assert_eq!(triangle.normals, [DVec3::Z; 3]);
    assert_eq!(triangle.count(VertexFlags::BOUNDARY), 3);

    let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let tetrahedron = sheets(&mesh(&corners, &[[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]));
    assert_eq!(tetrahedron.starts, [0, 3, 6, 9, 12]);
    assert_eq!(tetrahedron.count(VertexFlags::BOUNDARY), 0);
    assert!((tetrahedron.normals[0] + DVec3::ONE / 3.0_f64.sqrt()).length() < 1e-12);
}

#[test]
fn neither_the_order_of_triangles_nor_the_threads_matter() {
    let sphere = sphere(160, 80);
    let mut triangles = sphere.triangles().to_vec();
    let mut random = random(7);
    for last in (1..triangles.len()).rev() {
        triangles.swap(last, random(last + 1));
        triangles[last].rotate_left(random(3));
    }
    let expected = sheets(&sphere);
    let shuffled = with_triangles(&sphere, triangles);
    assert_same(&sheets(&shuffled), &expected);
    assert_same(&Sheets::of(&shuffled, 30.0, &Exec::new(3).unwrap()), &expected);
}

#[test]
fn far_away_and_at_any_scale_the_surface_is_the_same() {
    let sphere = sphere(24, 12);
    let expected = sheets(&sphere);
    for (scale, offset) in [(1e6, 0.0), (1e-6, 0.0), (1.0, 1e7), (1e-100, 0.0)] {
        let moved = sphere.positions().iter().map(|&at| at * scale + DVec3::splat(offset)).collect();
        let found = sheets(&Mesh::new(moved, sphere.triangles().to_vec()).unwrap());
        assert_eq!((&found.starts, &found.neighbours), (&expected.starts, &expected.neighbours), "{scale} {offset}");
        for (a, b) in found.normals.iter().zip(&expected.normals) {
            assert!(a.distance(*b) < 1e-6, "{scale} {offset}: {a} {b}");
        }
    }
}

#[test]
fn more_triangles_than_have_numbers_are_refused() {
    assert!(super::super::check_size(700_000_000).is_ok());
    let message = super::super::check_size(800_000_000).unwrap_err().to_string();
    assert!(message.contains("triangles needs 9600000000 bytes"), "{message}");
}
