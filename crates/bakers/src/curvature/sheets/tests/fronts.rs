//! Which way surfaces face.

use super::*;

fn flipped(mesh: &Mesh, flip: impl Fn(usize) -> bool) -> Mesh {
    let triangles = mesh.triangles().iter().enumerate();
    with_triangles(mesh, triangles.map(|(index, &[a, b, c])| if flip(index) { [a, c, b] } else { [a, b, c] }).collect())
}

#[test]
fn triangles_that_face_the_wrong_way_are_turned() {
    let sphere = sphere(24, 12);
    let expected = sheets(&sphere);
    let mut random = random(3);
    let wrong: Vec<bool> = sphere.triangles().iter().map(|_| random(3) == 0).collect();
    let found = sheets(&flipped(&sphere, |triangle| wrong[triangle]));
    // Those collapsed at the poles are not counted.
    let collapsed = |triangle: &&[u32; 3]| {
        let at = triangle.map(|vertex| sphere.positions()[vertex as usize]);
        at[0] == at[1] || at[1] == at[2] || at[2] == at[0]
    };
    let count =
        sphere.triangles().iter().zip(&wrong).filter(|(triangle, wrong)| **wrong && !collapsed(triangle)).count();
    assert_eq!(found.report.flipped_triangles, count as u64);
    assert_eq!(found.report.unorientable_edges, 0);
    assert_same(&found, &expected);
}

#[test]
fn every_piece_faces_as_most_of_its_area_did() {
    // Two plates. On the first, one large triangle of two faces down; on the second, three small ones of four.
    let corners = [[0.0; 3], [9.0, 0.0, 0.0], [9.0, 9.0, 0.0], [-1.0, 1.0, 0.0]];
    let first = mesh(&corners, &[[0, 2, 1], [0, 2, 3]]);
    let found = sheets(&first);
    assert_eq!(found.report.flipped_triangles, 1);
    assert_eq!(found.normals, [-DVec3::Z; 4]);

    let small = grid(2, 1, |u, v| DVec3::new(u, v, 0.0));
    let found = sheets(&flipped(&small, |triangle| triangle < 3));
    assert_eq!(found.report.flipped_triangles, 1);
    assert_eq!(found.normals, [-DVec3::Z; 6]);

    // Side by side each decides for itself.
    let moved = small.positions().iter().map(|&at| at + DVec3::X * 20.0);
    let positions = first.positions().iter().copied().chain(moved).collect();
    let other = small.triangles().iter().map(|triangle| triangle.map(|vertex| vertex + 4));
    let both = Mesh::new(positions, first.triangles().iter().copied().chain(other).collect()).unwrap();
    let found = sheets(&both);
    assert_eq!((found.normal_of(0), found.normal_of(4)), (-DVec3::Z, DVec3::Z));
}

#[test]
fn a_surface_inside_out_stays_so() {
    let sphere = sphere(12, 7);
    let found = sheets(&flipped(&sphere, |_| true));
    assert_eq!(found.report.flipped_triangles, 0);
    for (position, normal) in found.positions.iter().zip(&found.normals) {
        assert!(position.dot(*normal) < -0.9);
    }
}

#[test]
fn the_front_is_carried_across_hard_edges() {
    let normals = hard_cube().normals().unwrap().to_vec();
    // A face that was turned with its normals, and one that was turned without.
    let cube = flipped(&cube(), |triangle| triangle < 4);
    let mut half = normals.clone();
    half[..4].iter_mut().for_each(|normal| *normal = -*normal);
    let found = sheets(&cube.with_normals(half).unwrap());
    assert_eq!((found.report.flipped_triangles, found.report.hard_edges, found.report.points), (4, 12, 24));
    for vertex in 0..24 {
        assert_eq!(found.normal_of(vertex), normals[vertex as usize]);
    }
}

#[test]
fn flipped_triangles_are_no_reason_for_a_hard_edge() {
    // A soup of a smooth sphere whose triangles state their own normals, a third of them facing inwards.
    let sphere = sphere(48, 24);
    let mut random = random(5);
    let wrong: Vec<bool> = sphere.triangles().iter().map(|_| random(3) == 0).collect();
    let soup = soup(&flipped(&sphere, |triangle| wrong[triangle]));
    let normals = soup.triangles().iter().flat_map(|triangle| {
        let [a, b, c] = triangle.map(|vertex| soup.positions()[vertex as usize]);
        [(b - a).cross(c - a); 3]
    });
    let normals = normals.collect();
    let found = sheets(&soup.with_normals(normals).unwrap());
    assert_eq!((found.report.hard_edges, found.report.points), (0, sheets(&sphere).report.points));
}

#[test]
fn a_moebius_strip_is_cut_once() {
    let quads = 20;
    let vertex = |quad: u32, side: u32| if quad < quads { 2 * quad + side } else { 1 - side };
    let positions: Vec<DVec3> = (0..quads)
        .flat_map(|quad| [-0.3, 0.3].map(|across| (TAU * f64::from(quad) / f64::from(quads), across)))
        .map(|(angle, across)| {
            let radius = 1.0 + across * libm::cos(angle / 2.0);
            DVec3::new(radius * libm::cos(angle), radius * libm::sin(angle), across * libm::sin(angle / 2.0))
        })
        .collect();
    let triangles = (0..quads).flat_map(|quad| {
        let [a, b, c, d] = [vertex(quad, 0), vertex(quad + 1, 0), vertex(quad + 1, 1), vertex(quad, 1)];
        [[a, b, c], [a, c, d]]
    });
    let found = sheets(&Mesh::new(positions, triangles.collect()).unwrap());
    assert_eq!(found.report.unorientable_edges, 1);
    // The two ends of the cut are two points each, and it is no fault of the mesh that they are.
    assert_eq!(found.report.points, u64::from(2 * quads + 2));
    assert_eq!(found.count(VertexFlags::BOUNDARY) as u32, 2 * quads + 2);
    assert_eq!(found.count(VertexFlags::NON_MANIFOLD), 0);
    assert!(found.normals.iter().all(|normal| (normal.length() - 1.0).abs() < 1e-12));
}
