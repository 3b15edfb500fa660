//! The vertices around a vertex within its chart.
//!
//! Vertices at one place with the same texture coordinates and the same normal are one: the first speaks for all, so that a soup has
//! charts like any mesh. Others at that place are beyond a seam of the texture or a hard edge, and their triangles are not looked at.

use barchan_field::Mesh;
use glam::{DVec2, DVec3};

use super::super::VertexCurvature;
use super::super::sheets::places;
use crate::Exec;

/// A vertex with more triangles is the hub of a fan: those around it are no neighbours of each other.
const HUB: usize = 64;

/// Cosine of the angle to the tangent plane's normal: a triangle that stands steeper belongs to another sheet.
const STEEP: f64 = 0.2;

/// Triangles around the vertices of charts.
pub(super) struct Charts<'a> {
    mesh: &'a Mesh,
    uvs: &'a [DVec2],
    /// The vertex that speaks for each vertex.
    speakers: Vec<u32>,
    /// `corners[starts[s]..starts[s + 1]]` are the corners (3 × triangle + k) at speaker s.
    starts: Vec<u32>,
    corners: Vec<u32>,
}

impl<'a> Charts<'a> {
    pub(super) fn of(mesh: &'a Mesh, uvs: &'a [DVec2], curvature: &[VertexCurvature], exec: &Exec) -> Self {
        let speakers = speakers(mesh, uvs, curvature, exec);
        let speaker_at = |vertex: &u32| speakers[*vertex as usize] as usize;
        let mut starts = vec![0_u32; speakers.len() + 1];
        for vertex in mesh.triangles().iter().flatten() {
            starts[speaker_at(vertex) + 1] += 1;
        }
        for speaker in 0..speakers.len() {
            starts[speaker + 1] += starts[speaker];
        }
        let mut corners = vec![0; mesh.triangles().len() * 3];
        let mut slots = starts.clone();
        for (corner, vertex) in mesh.triangles().iter().flatten().enumerate() {
            let slot = &mut slots[speaker_at(vertex)];
            corners[*slot as usize] = corner as u32;
            *slot += 1;
        }
        Self { mesh, uvs, speakers, starts, corners }
    }

    /// The vertex whose triangles and forms are those of `vertex`.
    pub(super) fn speaker(&self, vertex: u32) -> u32 {
        self.speakers[vertex as usize]
    }

    pub(super) fn position(&self, vertex: u32) -> DVec3 {
        self.mesh.positions()[vertex as usize]
    }

    pub(super) fn uv(&self, vertex: u32) -> DVec2 {
        self.uvs[vertex as usize]
    }

    fn corners_at(&self, speaker: u32) -> &[u32] {
        &self.corners[self.starts[speaker as usize] as usize..self.starts[speaker as usize + 1] as usize]
    }

    /// The speakers after and before a corner in its triangle.
    fn others(&self, corner: u32) -> [u32; 2] {
        let triangle = self.mesh.triangles()[(corner / 3) as usize];
        [1, 2].map(|step| self.speaker(triangle[(corner as usize + step) % 3]))
    }

    /// The sum of the normals of a speaker's triangles, each as long as twice its area.
    pub(super) fn area_normal(&self, speaker: u32) -> DVec3 {
        let middle = self.position(speaker);
        let normal = |&corner: &u32| {
            let [next, previous] = self.others(corner).map(|other| self.position(other) - middle);
            next.cross(previous)
        };
        self.corners_at(speaker).iter().map(normal).sum()
    }

    /// The texture's hand around a speaker: 1 if most of the area around has texture coordinates that run counter-clockwise seen from the
    /// front, −1 if clockwise; `None` where no triangle has an area and texture coordinates that have one.
    ///
    /// Both meet where a texture is mirrored along a line: vertices on it go with the larger side, and on the front side of a tie.
    pub(super) fn hand(&self, speaker: u32, normal: DVec3) -> Option<f64> {
        let mut balance = None;
        for &corner in self.corners_at(speaker) {
            let area = self.handed_area(corner, normal);
            if area != 0.0 {
                balance = Some(balance.unwrap_or(0.0) + area);
            }
        }
        balance.map(|balance| if balance < 0.0 { -1.0 } else { 1.0 })
    }

    /// Twice the area of a triangle, negative where the texture is mirrored; zero if it, or its texture, has none, or if it stands so
    /// steep on the tangent plane that it must belong to another sheet.
    fn handed_area(&self, corner: u32, normal: DVec3) -> f64 {
        let middle = self.mesh.triangles()[(corner / 3) as usize][(corner % 3) as usize];
        let [next, previous] = self.others(corner).map(|other| self.position(other) - self.position(middle));
        let [uv_next, uv_previous] = self.others(corner).map(|other| self.uv(other) - self.uv(middle));
        let across = next.cross(previous);
        let area = across.length();
        let (facing, uv_facing) = (across.dot(normal), uv_next.perp_dot(uv_previous));
        if facing.abs() < STEEP * area || uv_facing == 0.0 { 0.0 } else { area * facing.signum() * uv_facing.signum() }
    }

    /// The speakers that share a triangle of that hand with any of `ring`, ascending, with the ring but without `speaker`.
    pub(super) fn widened(&self, speaker: u32, normal: DVec3, hand: f64, mut ring: Vec<u32>) -> Vec<u32> {
        for index in 0..ring.len() {
            let corners = self.corners_at(ring[index]);
            if corners.len() > HUB && ring[index] != speaker {
                continue;
            }
            let of_this_hand = corners.iter().filter(|&&corner| hand * self.handed_area(corner, normal) > 0.0);
            ring.extend(of_this_hand.flat_map(|&corner| self.others(corner)));
        }
        ring.sort_unstable();
        ring.dedup();
        ring.retain(|&other| other != speaker);
        ring
    }
}

fn speakers(mesh: &Mesh, uvs: &[DVec2], curvature: &[VertexCurvature], exec: &Exec) -> Vec<u32> {
    let places = places(mesh, exec);
    let mut speakers: Vec<u32> = (0..uvs.len() as u32).collect();
    let mut doubled = doubled(&places);
    let key = |vertex: u32| {
        let (uv, normal) = (uvs[vertex as usize], curvature[vertex as usize].normal);
        // Minus zero is zero.
        (places[vertex as usize], [uv.x, uv.y, normal.x, normal.y, normal.z].map(|number| (number + 0.0).to_bits()))
    };
    doubled.sort_unstable_by_key(|&vertex| (key(vertex), vertex));
    for same in doubled.chunk_by(|&a, &b| key(a) == key(b)) {
        for &vertex in same {
            speakers[vertex as usize] = same[0];
        }
    }
    speakers
}

/// Vertices whose place is also that of others.
fn doubled(places: &[Option<u32>]) -> Vec<u32> {
    let mut vertices_at = vec![0_u32; places.len()];
    for &place in places.iter().flatten() {
        vertices_at[place as usize] += 1;
    }
    let vertices = (0..places.len() as u32)
        .filter(|&vertex| places[vertex as usize].is_some_and(|place| vertices_at[place as usize] > 1));
    vertices.collect()
}
