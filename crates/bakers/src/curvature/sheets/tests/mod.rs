//! What sheets are made of meshes, clean and otherwise.

mod branches;
mod fronts;
mod hubs;
mod welding;

use core::f64::consts::{PI, TAU};

use barchan_asset::VertexFlags;
use barchan_field::Mesh;
use glam::DVec3;

use super::Sheets;
use crate::Exec;

fn sheets(mesh: &Mesh) -> Sheets {
    Sheets::of(mesh, 30.0, &Exec::new(1).unwrap())
}

fn mesh(positions: &[[f64; 3]], triangles: &[[u32; 3]]) -> Mesh {
    Mesh::new(positions.iter().map(|&at| DVec3::from_array(at)).collect(), triangles.to_vec()).unwrap()
}

/// The same vertices with other triangles.
fn with_triangles(mesh: &Mesh, triangles: Vec<[u32; 3]>) -> Mesh {
    Mesh::new(mesh.positions().to_vec(), triangles).unwrap()
}

/// Every triangle with vertices of its own.
fn soup(mesh: &Mesh) -> Mesh {
    let positions = mesh.triangles().iter().flatten().map(|&vertex| mesh.positions()[vertex as usize]).collect();
    let triangles = (0..mesh.triangles().len() as u32).map(|triangle| [0, 1, 2].map(|corner| triangle * 3 + corner));
    Mesh::new(positions, triangles.collect()).unwrap()
}

/// A grid of `columns` × `rows` quads, each cut in two; the vertex in column c and row r is number r (columns + 1) + c.
fn grid(columns: u32, rows: u32, at: impl Fn(f64, f64) -> DVec3) -> Mesh {
    let mut positions = Vec::new();
    let mut triangles = Vec::new();
    for row in 0..=rows {
        for column in 0..=columns {
            positions.push(at(f64::from(column) / f64::from(columns), f64::from(row) / f64::from(rows)));
        }
    }
    for row in 0..rows {
        for column in 0..columns {
            let a = row * (columns + 1) + column;
            let [b, c, d] = [a + 1, a + columns + 2, a + columns + 1];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    Mesh::new(positions, triangles).unwrap()
}

/// A unit sphere with a seam of doubled vertices, and as many vertices at each pole as there are columns and one.
fn sphere(columns: u32, rows: u32) -> Mesh {
    grid(columns, rows, |u, v| {
        // Seam and poles close to the bit.
        let (azimuth, polar) = (if u == 1.0 { 0.0 } else { TAU * u }, PI * v);
        let [sine, cosine] = if v == 1.0 { [0.0, -1.0] } else { [libm::sin(polar), libm::cos(polar)] };
        DVec3::new(-sine * libm::cos(azimuth), sine * libm::sin(azimuth), cosine)
    })
}

/// The cube from 0 to 1, faces outwards, every face with four vertices of its own.
fn cube() -> Mesh {
    let mut positions = Vec::new();
    let mut triangles = Vec::new();
    for normal in cube_normals() {
        let across = DVec3::new(normal.y, normal.z, normal.x);
        let up = normal.cross(across);
        let first = positions.len() as u32;
        for [x, y] in [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]] {
            positions.push(DVec3::splat(0.5) + normal * 0.5 + across * x + up * y);
        }
        triangles.extend([[0, 1, 2], [0, 2, 3]].map(|corners: [u32; 3]| corners.map(|corner| first + corner)));
    }
    Mesh::new(positions, triangles).unwrap()
}

fn cube_normals() -> [DVec3; 6] {
    [DVec3::X, DVec3::Y, DVec3::Z, -DVec3::X, -DVec3::Y, -DVec3::Z]
}

/// The cube with the normals of its faces.
fn hard_cube() -> Mesh {
    cube().with_normals(cube_normals().into_iter().flat_map(|normal| [normal; 4]).collect()).unwrap()
}

impl Sheets {
    /// Positions of the neighbours of the point that speaks for a vertex.
    fn seen_from(&self, vertex: u32) -> Vec<DVec3> {
        let point = self.point_of_vertex[vertex as usize].unwrap() as usize;
        let range = self.starts[point] as usize..self.starts[point + 1] as usize;
        self.neighbours[range].iter().map(|&neighbour| self.positions[neighbour as usize]).collect()
    }

    fn flags_of(&self, vertex: u32) -> VertexFlags {
        self.flags[self.point_of_vertex[vertex as usize].unwrap() as usize]
    }

    fn normal_of(&self, vertex: u32) -> DVec3 {
        self.normals[self.point_of_vertex[vertex as usize].unwrap() as usize]
    }

    fn count(&self, flag: VertexFlags) -> usize {
        self.flags.iter().filter(|flags| flags.contains(flag)).count()
    }
}

/// The same points with the same neighbours in the same order, to the bit.
fn assert_same(a: &Sheets, b: &Sheets) {
    assert_eq!(a.positions, b.positions);
    assert_eq!((&a.starts, &a.neighbours), (&b.starts, &b.neighbours));
    assert_eq!(a.normals, b.normals);
    assert_eq!(a.flags, b.flags);
    assert_eq!(a.report.mean_edge.to_bits(), b.report.mean_edge.to_bits());
}

/// Numbers from 0 to `below`, the same every time.
fn random(seed: u64) -> impl FnMut(usize) -> usize {
    let mut state = seed;
    move |below| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % below
    }
}
