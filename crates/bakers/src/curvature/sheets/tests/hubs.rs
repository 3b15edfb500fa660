//! A hundred thousand triangles at one vertex, or at one edge: work that grew with their square would not end within a test.

use super::*;

const MANY: u32 = 100_000;

fn on_circle(step: u32, of: u32) -> DVec3 {
    let angle = TAU * f64::from(step) / f64::from(of);
    DVec3::new(libm::cos(angle), libm::sin(angle), 0.0)
}

#[test]
fn a_fan() {
    let mut positions = vec![DVec3::ZERO];
    positions.extend((0..MANY).map(|step| on_circle(step, MANY)));
    let triangles = (0..MANY).map(|step| [0, 1 + step, 1 + (step + 1) % MANY]).collect();
    let fan = Mesh::new(positions, triangles).unwrap();
    for mesh in [fan.clone(), soup(&fan)] {
        let found = sheets(&mesh);
        assert_eq!(found.report.points, u64::from(MANY) + 1);
        assert_eq!(found.seen_from(0).len() as u32, MANY);
        assert_eq!(found.flags_of(0), VertexFlags::NONE);
        assert!(found.normal_of(0).distance(DVec3::Z) < 1e-12);
    }
}

#[test]
fn wings() {
    // The same circle, every other triangle left out: as many points at the hub as wings.
    let mut positions = vec![DVec3::ZERO];
    positions.extend((0..2 * MANY).map(|step| on_circle(step, 2 * MANY)));
    let triangles = (0..MANY).map(|wing| [0, 1 + 2 * wing, 2 + 2 * wing]).collect();
    let found = sheets(&Mesh::new(positions, triangles).unwrap());
    assert_eq!(found.report.points, u64::from(3 * MANY));
    assert_eq!(found.count(VertexFlags::NON_MANIFOLD) as u32, MANY);
}

#[test]
fn leaves() {
    // All on one edge, an even number of them evenly around: each goes on opposite.
    let mut positions = vec![DVec3::ZERO, DVec3::Z];
    positions.extend((0..MANY).map(|step| on_circle(step, MANY)));
    let triangles = (0..MANY).map(|leaf| [0, 2 + leaf, 1]).collect();
    let found = sheets(&Mesh::new(positions, triangles).unwrap());
    assert_eq!(found.report.non_manifold_edges, 1);
    assert_eq!(found.report.points, u64::from(2 * MANY));
}
