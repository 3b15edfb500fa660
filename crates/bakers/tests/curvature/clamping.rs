//! What no edge can resolve is cut, and said to be.

use barchan_asset::VertexFlags;
use barchan_field::Mesh;
use glam::DVec3;

use crate::support::{assert_finite, baked, count};

/// A flat sheet of unit cells with one vertex drawn out.
fn spike(height: f64) -> Mesh {
    const SIDE: u32 = 15;
    let middle = SIDE / 2;
    let positions = (0..SIDE * SIDE).map(|vertex| {
        let (column, row) = (vertex % SIDE, vertex / SIDE);
        let up = if (column, row) == (middle, middle) { height } else { 0.0 };
        DVec3::new(f64::from(column), f64::from(row), up)
    });
    let corner = |cell: u32| cell / (SIDE - 1) * SIDE + cell % (SIDE - 1);
    let triangles = (0..(SIDE - 1) * (SIDE - 1)).map(corner).flat_map(|a| {
        let [b, c, d] = [a + 1, a + 1 + SIDE, a + SIDE];
        [[a, b, c], [a, c, d]]
    });
    Mesh::new(positions.collect(), triangles.collect()).unwrap()
}

#[test]
fn a_spike_is_no_sharper_than_its_edges() {
    for height in [1.0, 10.0, 1e3, 1e6, 1e9] {
        let mesh = spike(height);
        let found = baked(&mesh);
        assert_finite(&found);
        let most =
            found.vertices.iter().fold(0.0_f64, |most, v| most.max(v.principal[0].abs().max(v.principal[1].abs())));
        println!(
            "SPIKE {height} {most} clamped {} tip {:?}",
            count(&found, VertexFlags::CLAMPED),
            found.vertices[112].principal
        );
        // The shortest edge is 1: a circle of that diameter.
        assert!(most <= 2.0, "{height}: {most}");
    }
}

#[test]
fn the_tip_of_a_spike_says_that_it_was_cut() {
    let found = baked(&spike(1e3));
    let tip = found.vertices[112];
    assert!(tip.flags.contains(VertexFlags::CLAMPED), "{tip:?}");
    // All edges there are a thousand long.
    assert!(tip.principal.iter().all(|curvature| (curvature - 2e-3).abs() < 1e-6), "{tip:?}");
    assert!(count(&found, VertexFlags::CLAMPED) < 20);
}
