//! What sheets are made of meshes, clean and otherwise.

use barchan_asset::VertexFlags;
use barchan_field::Mesh;
use core::f64::consts::{PI, TAU};
use glam::{DVec2, DVec3};

use super::Sheets;
use crate::Exec;

fn sheets(mesh: &Mesh) -> Sheets {
    Sheets::of(mesh, 30.0, &Exec::new(1).unwrap())
}

fn mesh(positions: &[DVec3], triangles: &[[u32; 3]]) -> Mesh {
    Mesh::new(positions.to_vec(), triangles.to_vec()).unwrap()
}

/// A grid of `columns` × `rows` quads, each cut in two; the vertex in column c and row r is number r (columns + 1) + c.
fn grid(columns: u32, rows: u32, at: impl Fn(f64, f64) -> DVec3) -> Mesh {
    let mut positions = Vec::new();
    let mut uvs = Vec::new();
    for row in 0..=rows {
        for column in 0..=columns {
            let uv = DVec2::new(f64::from(column) / f64::from(columns), f64::from(row) / f64::from(rows));
            uvs.push(uv);
            positions.push(at(uv.x, uv.y));
        }
    }
    let mut triangles = Vec::new();
    for row in 0..rows {
        for column in 0..columns {
            let a = row * (columns + 1) + column;
            let [b, c, d] = [a + 1, a + columns + 2, a + columns + 1];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    Mesh::new(positions, triangles).unwrap().with_uvs(uvs).unwrap()
}

/// A unit sphere with a seam of doubled vertices, and as many vertices at each pole as there are columns and one.
fn sphere(columns: u32, rows: u32) -> Mesh {
    grid(columns, rows, |u, v| {
        // The seam closes to the bit.
        let (azimuth, polar) = (if u == 1.0 { 0.0 } else { TAU * u }, PI * v);
        let [sine, cosine] = if v == 1.0 { [0.0, -1.0] } else { [libm::sin(polar), libm::cos(polar)] };
        DVec3::new(-sine * libm::cos(azimuth), sine * libm::sin(azimuth), cosine)
    })
}

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
}

#[test]
fn normals_of_a_sphere_point_outwards() {
    let found = sheets(&sphere(48, 24));
    for (position, normal) in found.positions.iter().zip(&found.normals) {
        assert!(position.dot(*normal) > 0.999, "{position} {normal}");
    }
}
