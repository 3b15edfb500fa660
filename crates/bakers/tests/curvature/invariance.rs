//! What must not matter.

use barchan_bakers::curvature::CurvatureMethod;
use barchan_field::Mesh;
use barchan_field::surfaces::Pattern;
use glam::DVec3;

use crate::support::{Case, bake_with, baked, bits, difference, random};

fn cases() -> impl Iterator<Item = (&'static str, Case)> {
    ["ellipsoid", "torus", "helicoid", "bezier_patch"]
        .into_iter()
        .map(|name| (name, Case::example(name, Pattern::Random, 2000)))
}

/// At a border a jet of degree eight looks outwards, and rounding is a million times as loud.
fn rounding(name: &str) -> f64 {
    if name == "ellipsoid" || name == "torus" { 1e-9 } else { 1e-5 }
}

#[test]
fn threads_change_no_bit() {
    // More than one block of points.
    let case = Case::example("bezier_patch", Pattern::Random, 6000);
    for method in CurvatureMethod::ALL {
        let one = bake_with(&case.mesh, method, 1);
        for threads in [2, 3, 7] {
            assert_eq!(one, bake_with(&case.mesh, method, threads), "{method:?} on {threads} threads");
        }
    }
}

#[test]
fn a_quarter_turn_changes_nothing() {
    let turns: [fn(DVec3) -> DVec3; 3] =
        [|p| DVec3::new(-p.y, p.x, p.z), |p| DVec3::new(p.z, p.y, -p.x), |p| DVec3::new(p.x, -p.z, p.y)];
    for (name, case) in cases() {
        let clean = baked(&case.mesh);
        for turn in turns {
            let positions = case.mesh.positions().iter().map(|&position| turn(position)).collect();
            let turned = baked(&Mesh::new(positions, case.mesh.triangles().to_vec()).unwrap());
            let different = difference(&clean, &turned);
            println!("TURN {name} {different:.2e}");
            assert!(different <= rounding(name), "{name}: {different}");
        }
    }
}

#[test]
fn the_order_of_triangles_and_of_their_corners_changes_nothing() {
    for (name, case) in cases() {
        let mut random = random(5);
        let mut triangles: Vec<[u32; 3]> =
            case.mesh.triangles().iter().map(|&[a, b, c]| if random() < 0.5 { [b, c, a] } else { [c, a, b] }).collect();
        for last in (1..triangles.len()).rev() {
            triangles.swap(last, (random() * last as f64) as usize);
        }
        let (clean, found) = (baked(&case.mesh), baked(&case.with_triangles(triangles).mesh));
        println!("ORDERT {name} {:.2e}", difference(&clean, &found));
        assert_eq!(bits(&clean), bits(&found), "{name}");
    }
}

#[test]
fn the_order_of_vertices_changes_nothing() {
    for (name, case) in cases() {
        let count = case.mesh.positions().len() as u32;
        // Vertex i of the one is vertex `step` · i of the other.
        let step = (700..).find(|step| (1..=*step).all(|d| d == 1 || step % d != 0 || count % d != 0)).unwrap();
        let origin: Vec<u32> = (0..count).map(|vertex| vertex * step % count).collect();
        let mut place = vec![0; origin.len()];
        for (new, &old) in origin.iter().enumerate() {
            place[old as usize] = new as u32;
        }
        let triangles = case.mesh.triangles().iter().map(|corners| corners.map(|old| place[old as usize])).collect();
        let (clean, mut found) = (baked(&case.mesh), baked(&case.remade(&origin, triangles).mesh));
        found.vertices = place.iter().map(|&new| found.vertices[new as usize]).collect();
        let different = difference(&clean, &found);
        println!("ORDERV {name} {different:.2e}");
        assert!(different <= rounding(name), "{name}: {different}");
    }
}

#[test]
fn seen_from_the_back_convex_is_concave() {
    for (name, case) in cases() {
        let clean = baked(&case.mesh);
        let triangles = case.mesh.triangles().iter().map(|&[a, b, c]| [a, c, b]).collect();
        let mut back = baked(&case.with_triangles(triangles).mesh);
        for (back, front) in back.vertices.iter_mut().zip(&clean.vertices) {
            assert!(back.normal.dot(front.normal) < -1.0 + 1e-6);
            let [first, second] = back.principal;
            back.principal = [-second, -first];
        }
        let different = difference(&clean, &back);
        println!("BACK {name} {different:.2e}");
        assert!(different <= rounding(name), "{name}: {different}");
    }
}

#[test]
fn in_a_mirror_everything_is_as_convex_as_before() {
    for (name, case) in cases() {
        let positions = case.mesh.positions().iter().map(|p| DVec3::new(-p.x, p.y, p.z)).collect();
        let triangles = case.mesh.triangles().iter().map(|&[a, b, c]| [a, c, b]).collect();
        let mirrored = baked(&Mesh::new(positions, triangles).unwrap());
        let different = difference(&baked(&case.mesh), &mirrored);
        println!("MIRROR {name} {different:.2e}");
        assert!(different <= rounding(name), "{name}: {different}");
    }
}
