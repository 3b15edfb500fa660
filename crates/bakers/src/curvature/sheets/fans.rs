//! Triangles around a place.
//!
//! Around a place, a *fan* of triangles is joined side to side, counter-clockwise seen from the front: closed, or open at the boundary.
//! Each fan is a point of the surface.

use glam::DVec3;

use super::PIECE;
use super::normal::Normal;
use super::surface::{NONE, Surface, next, previous};
use crate::Exec;

/// The corners of one fan, in order.
#[derive(Debug, Default)]
pub(super) struct Fan {
    /// Sides that run outwards from the middle.
    pub(super) sides: Vec<u32>,
    /// Whether it ends at the boundary, with one neighbour more than it has triangles.
    pub(super) open: bool,
}

impl Fan {
    /// The fan that a corner belongs to.
    pub(super) fn around(&mut self, surface: &Surface, corner: u32) {
        self.open = !self.advance(surface, corner);
        if self.open {
            let mut start = corner;
            while let Some(twin) = surface.smooth_twin(start) {
                start = next(twin);
            }
            self.advance(surface, start);
        } else {
            self.start_at_smallest(surface);
        }
    }

    /// Goes counter-clockwise from a corner; whether it comes back.
    fn advance(&mut self, surface: &Surface, start: u32) -> bool {
        self.sides.clear();
        let mut side = start;
        loop {
            self.sides.push(side);
            match surface.smooth_twin(previous(side)) {
                Some(twin) if twin == start => return true,
                Some(twin) => side = twin,
                None => return false,
            }
        }
    }

    /// A circle has no first neighbour: the one whose place has the smallest number.
    fn start_at_smallest(&mut self, surface: &Surface) {
        let smallest = (0..self.sides.len()).min_by_key(|&index| surface.to(self.sides[index]));
        self.sides.rotate_left(smallest.unwrap_or(0));
    }

    /// Corners at the far ends of the edges of this fan, one per neighbour.
    fn far_corners(&self) -> impl Iterator<Item = u32> {
        let last = self.sides.last().filter(|_| self.open).map(|&side| previous(side));
        self.sides.iter().map(|&side| next(side)).chain(last)
    }
}

/// What is known of points from their fans.
#[derive(Debug, Default)]
pub(super) struct Points {
    /// As in [`Sheets`](super::Sheets); of a part, where neighbours end.
    pub(super) starts: Vec<u32>,
    pub(super) neighbours: Vec<u32>,
    pub(super) normals: Vec<DVec3>,
    pub(super) open: Vec<bool>,
    /// Triangles in all fans together.
    pub(super) triangles: usize,
    /// The sum of the lengths of `neighbours`.
    pub(super) length: f64,
}

/// Where fans begin, and which points their corners are.
pub(super) struct Layout<'a> {
    pub(super) surface: &'a Surface,
    /// Position of each place.
    pub(super) positions: &'a [DVec3],
    /// A corner of each point.
    pub(super) corners: &'a [u32],
    /// The point at each corner; empty where the points are the places.
    pub(super) points: &'a [u32],
}

/// Walks around every point.
pub(super) fn walk(layout: &Layout, exec: &Exec) -> Points {
    let mut parts: Vec<Points> = layout.corners.chunks(PIECE).map(|_| Points::default()).collect();
    let pieces = parts.iter_mut().zip(layout.corners.chunks(PIECE)).collect();
    exec.for_each_quietly(pieces, |_, (part, corners)| part.walk(layout, corners));
    Points::joined(&parts, exec)
}

impl Points {
    fn walk(&mut self, layout: &Layout, corners: &[u32]) {
        let mut fan = Fan::default();
        self.neighbours.reserve(corners.len() * 6);
        for &corner in corners {
            fan.around(layout.surface, corner);
            self.open.push(fan.open);
            self.triangles += fan.sides.len();
            self.add_neighbours(layout, &fan);
            self.starts.push(self.neighbours.len() as u32);
        }
    }

    fn add_neighbours(&mut self, layout: &Layout, fan: &Fan) {
        let at = |corner: u32| layout.positions[layout.surface.from(corner) as usize];
        let mut normal = Normal::around(at(fan.sides[0]));
        for corner in fan.far_corners() {
            self.neighbours.push(match layout.points {
                [] => layout.surface.from(corner),
                points => points[corner as usize],
            });
            self.length += normal.go_on_to(at(corner));
        }
        self.normals.push(if fan.open { normal.of_open_fan() } else { normal.of_closed_fan() });
    }

    /// All parts, one after the other.
    fn joined(parts: &[Self], exec: &Exec) -> Self {
        let sum = |count: fn(&Self) -> usize| parts.iter().map(count).sum();
        let points: usize = sum(|part| part.open.len());
        let mut all = Self {
            starts: vec![0; points + 1],
            neighbours: vec![0; sum(|part| part.neighbours.len())],
            normals: vec![DVec3::ZERO; points],
            open: vec![false; points],
            triangles: sum(|part| part.triangles),
            length: parts.iter().map(|part| part.length).sum(),
        };
        let (mut ends, mut neighbours) = (&mut all.starts[1..], all.neighbours.as_mut_slice());
        let (mut normals, mut open) = (all.normals.as_mut_slice(), all.open.as_mut_slice());
        let mut pieces = Vec::with_capacity(parts.len());
        let mut before = 0;
        for part in parts {
            let (points, edges) = (part.open.len(), part.neighbours.len());
            let split = (split_off(&mut ends, points), split_off(&mut neighbours, edges));
            pieces.push((part, before, split, split_off(&mut normals, points), split_off(&mut open, points)));
            before += edges as u32;
        }
        exec.for_each_quietly(pieces, |_, (part, before, (ends, neighbours), normals, open)| {
            for (end, own) in ends.iter_mut().zip(&part.starts) {
                *end = before + own;
            }
            neighbours.copy_from_slice(&part.neighbours);
            normals.copy_from_slice(&part.normals);
            open.copy_from_slice(&part.open);
        });
        all
    }
}

/// The first `count` items of a slice, which keeps the rest.
fn split_off<'a, T>(slice: &mut &'a mut [T], count: usize) -> &'a mut [T] {
    let (first, rest) = core::mem::take(slice).split_at_mut(count);
    *slice = rest;
    first
}

/// A corner of every place; [`NONE`] for a place without triangles.
pub(super) fn corner_of_each_place(surface: &Surface, places: usize) -> Vec<u32> {
    let mut corners = vec![NONE; places];
    for (corner, &place) in surface.corners.iter().enumerate() {
        if place != NONE {
            corners[place as usize] = corner as u32;
        }
    }
    corners
}
