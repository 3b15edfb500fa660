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
        let most = found.vertices.iter().fold(0.0_f64, |most, v| most.max(v.principal[0].abs().max(v.principal[1].abs())));
        println!("SPIKE {height} {most} clamped {} tip {:?}", count(&found, VertexFlags::CLAMPED), found.vertices[112].principal);
        // The shortest edge is 1: a circle of that diameter.
        assert!(most <= 2.0, "{height}: {most}");
    }
}

#[test]
fn a_sheet_folded_flat_is_clamped() {
    // Two halves of a sheet that meet at 1°.
    let positions = (0..7).flat_map(|row: u32| {
        (0..7_u32).map(move |column| {
            let across = f64::from(column) - 3.0;
            DVec3::new(across.abs(), f64::from(row), 0.01 * across)
        })
    });
    let triangles = (0..36).flat_map(|cell: u32| {
        let a = cell / 6 * 7 + cell % 6;
        [[a, a + 1, a + 8], [a, a + 8, a + 7]]
    });
    let found = baked(&Mesh::new(positions.collect(), triangles.collect()).unwrap());
    assert_finite(&found);
    println!("FOLD {:?}", found.vertices[21..28].iter().map(|v| (v.principal, v.flags.0)).collect::<Vec<_>>());
}
