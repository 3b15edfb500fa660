//! Vertices at one place.
//!
//! Vertices no farther apart than the tolerance are one place. Nearness is not transitive, so the rule is: in the order of their
//! coordinates (x, then y, then z) a vertex joins the first centre within the tolerance, or becomes a centre. So a place is no wider than
//! two tolerances, a row of ever so close vertices does not shrink to a point, and neither the order of vertices nor that of
//! triangles matters. Where duplicates are equal, or all within the tolerance of each other, that is what anyone would expect.
//!
//! Vertices are sorted along x and split wherever a gap is wider than the tolerance; what stays together is sorted along y, then z. On a
//! surface next to nothing stays together that is not one place.

use core::sync::atomic::{AtomicBool, Ordering};
use std::collections::HashMap;

use barchan_field::Mesh;
use glam::DVec3;

use super::PIECE;
use super::surface::NONE;
use crate::Exec;

/// Of the mean length of a triangle's side.
const TOLERANCE: f64 = 1e-5;

/// Groups up to this size are compared pair by pair.
const FEW: usize = 32;

/// Where the vertices are.
#[derive(Debug)]
pub(super) struct Places {
    /// The place of each vertex, numbered by the first vertex there; [`NONE`] for a vertex without triangles.
    pub(super) of_vertex: Vec<u32>,
    /// Position of each place: that of its centre.
    pub(super) positions: Vec<DVec3>,
}

/// Welds the vertices that triangles use.
pub(super) fn weld(mesh: &Mesh, exec: &Exec) -> Places {
    let (used, mean_side) = survey(mesh, exec);
    let mut members: Vec<u64> = (0..used.len() as u64).filter(|&vertex| used[vertex as usize]).collect();
    let mut welder = Welder::new(mesh.positions(), &members, TOLERANCE * mean_side);
    welder.split(&mut members, 0, &|members| exec.sort_distinct(members));
    number(mesh.positions(), &used, &welder.centres)
}

/// Which vertices have triangles, and the mean length of those sides of triangles that have one.
fn survey(mesh: &Mesh, exec: &Exec) -> (Vec<bool>, f64) {
    let positions = mesh.positions();
    let used: Vec<AtomicBool> = positions.iter().map(|_| AtomicBool::new(false)).collect();
    let pieces = mesh.triangles().chunks(PIECE);
    let mut sums = vec![(0.0, 0_u64); pieces.len()];
    exec.for_each_quietly(sums.iter_mut().zip(pieces).collect(), |_, ((sum, count), triangles)| {
        for triangle in triangles {
            let [a, b, c] = triangle.map(|vertex| positions[vertex as usize]);
            for length in [a.distance(b), b.distance(c), c.distance(a)] {
                *sum += length;
                *count += u64::from(length > 0.0);
            }
            for &vertex in triangle {
                used[vertex as usize].store(true, Ordering::Relaxed);
            }
        }
    });
    let (sum, count) = sums.into_iter().fold((0.0, 0), |all, piece| (all.0 + piece.0, all.1 + piece.1));
    (used.into_iter().map(AtomicBool::into_inner).collect(), sum / count.max(1) as f64)
}

fn number(positions: &[DVec3], used: &[bool], centres: &[u32]) -> Places {
    let mut of_vertex = vec![NONE; positions.len()];
    let mut places = Vec::with_capacity(positions.len());
    for vertex in (0..positions.len()).filter(|&vertex| used[vertex]) {
        let centre = centres[vertex] as usize;
        if of_vertex[centre] == NONE {
            of_vertex[centre] = places.len() as u32;
            places.push(positions[centre]);
        }
        of_vertex[vertex] = of_vertex[centre];
    }
    Places { of_vertex, positions: places }
}

struct Welder<'a> {
    positions: &'a [DVec3],
    tolerance: f64,
    /// Coordinates in 2⁻³² of the extent of the mesh, so that they can be sorted as integers.
    origin: DVec3,
    ticks: DVec3,
    /// No vertices within the tolerance are more ticks apart.
    reach: [u64; 3],
    /// The vertex that each vertex is welded to.
    centres: Vec<u32>,
}

impl<'a> Welder<'a> {
    fn new(positions: &'a [DVec3], members: &[u64], tolerance: f64) -> Self {
        let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for &vertex in members {
            low = low.min(positions[vertex as usize]);
            high = high.max(positions[vertex as usize]);
        }
        let ticks = (high - low).to_array().map(|extent| f64::from(u32::MAX) / extent);
        let ticks = DVec3::from_array(ticks.map(|ticks| if ticks.is_finite() { ticks } else { 0.0 }));
        let reach = (ticks * tolerance).to_array().map(|reach| reach.ceil() as u64 + 2);
        let centres = (0..positions.len() as u32).collect();
        Self { positions, tolerance, origin: low, ticks, reach, centres }
    }

    /// Sorts vertices (the low halves) along an axis, and goes on with those that no gap divides.
    fn split(&mut self, members: &mut [u64], axis: usize, sort: &dyn Fn(&mut [u64])) {
        let (origin, ticks, reach) = (self.origin[axis], self.ticks[axis], self.reach[axis]);
        for member in members.iter_mut() {
            let vertex = *member as u32;
            let along = (self.positions[vertex as usize][axis] - origin) * ticks;
            *member = u64::from(along as u32) << 32 | u64::from(vertex);
        }
        sort(members);
        for group in members.chunk_by_mut(|a, b| (b >> 32) - (a >> 32) <= reach) {
            match group.len() {
                1 => {}
                2..=FEW => self.unite(group),
                _ if axis == 2 => self.unite_many(group),
                _ => self.split(group, axis + 1, &|members| members.sort_unstable()),
            }
        }
    }

    fn in_order(&self, group: &[u64]) -> Vec<u32> {
        let mut vertices: Vec<u32> = group.iter().map(|&member| member as u32).collect();
        vertices.sort_unstable_by(|&a, &b| {
            let [a_at, b_at] = [a, b].map(|vertex| self.positions[vertex as usize]);
            let by = |axis: usize| a_at[axis].total_cmp(&b_at[axis]);
            by(0).then(by(1)).then(by(2)).then(a.cmp(&b))
        });
        vertices
    }

    fn near(&self, a: u32, b: u32) -> bool {
        self.positions[a as usize].distance(self.positions[b as usize]) <= self.tolerance
    }

    fn unite(&mut self, group: &[u64]) {
        let mut centres: Vec<u32> = Vec::with_capacity(group.len());
        for vertex in self.in_order(group) {
            match centres.iter().find(|&&centre| self.near(centre, vertex)) {
                Some(&centre) => self.centres[vertex as usize] = centre,
                None => centres.push(vertex),
            }
        }
    }

    /// The same rule with centres in cells of the tolerance: a cell holds few, however many vertices there are.
    fn unite_many(&mut self, group: &[u64]) {
        let mut cells: HashMap<[u64; 3], Vec<(u32, u32)>> = HashMap::new();
        for (rank, vertex) in self.in_order(group).into_iter().enumerate() {
            let cell = self.cell(vertex);
            let around = (0..27).filter_map(|n| {
                let offset = DVec3::new(f64::from(n % 3 - 1), f64::from(n / 3 % 3 - 1), f64::from(n / 9 - 1));
                cells.get(&key(cell + offset))
            });
            let first = around.flatten().filter(|&&(_, centre)| self.near(centre, vertex)).min().copied();
            match first {
                Some((_, centre)) => self.centres[vertex as usize] = centre,
                None => cells.entry(key(cell)).or_default().push((rank as u32, vertex)),
            }
        }
    }

    fn cell(&self, vertex: u32) -> DVec3 {
        let offset = self.positions[vertex as usize] - self.origin;
        if self.tolerance > 0.0 { (offset / self.tolerance).floor() } else { offset }
    }
}

/// Whole numbers as f64, which unlike integers do not end.
fn key(cell: DVec3) -> [u64; 3] {
    // Minus zero is zero.
    cell.to_array().map(|index| (index + 0.0).to_bits())
}
