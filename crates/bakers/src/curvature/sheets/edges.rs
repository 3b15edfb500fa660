//! Which sides lie on one edge.
//!
//! Sides are put into buckets by the smaller of their two places and sorted there by the larger. Nearly all edges have two sides and are
//! joined on the spot; the others are left to [`branch`](super::branch).

use core::sync::atomic::{AtomicU32, Ordering};

use super::surface::{NONE, previous};
use crate::Exec;

/// Edges of a triangle list.
#[derive(Debug)]
pub(super) struct Edges {
    /// The other side of every edge that has two, else [`NONE`].
    pub(super) twins: Vec<u32>,
    /// The sides of every edge that has more than two.
    pub(super) crowded: Vec<Vec<u32>>,
    /// Triangles that lie together with others on two corners and the third: some may be duplicates.
    pub(super) suspects: Vec<u32>,
}

/// Finds the edges of triangles between `places` places; `corners` are three places per triangle, or thrice [`NONE`].
pub(super) fn find(corners: &[u32], places: usize, exec: &Exec) -> Edges {
    let twins: Vec<AtomicU32> = corners.iter().map(|_| AtomicU32::new(NONE)).collect();
    let per_part = places.div_ceil(exec.threads()).max(1);
    let mut parts: Vec<Part> =
        (0..places).step_by(per_part).map(|first| Part::new(first, per_part.min(places - first))).collect();
    exec.for_each_quietly(parts.iter_mut().collect(), |_, part| part.find(corners, &twins));
    let mut edges = Edges {
        twins: twins.into_iter().map(AtomicU32::into_inner).collect(),
        crowded: Vec::new(),
        suspects: Vec::new(),
    };
    for part in parts {
        edges.crowded.extend(part.crowded);
        edges.suspects.extend(part.suspects);
    }
    edges
}

/// The edges whose smaller place is among some. Every side has one twin at most, so parts do not write to the same ones.
#[derive(Debug, Default)]
struct Part {
    first: usize,
    places: usize,
    crowded: Vec<Vec<u32>>,
    suspects: Vec<u32>,
}

impl Part {
    fn new(first: usize, places: usize) -> Self {
        Self { first, places, crowded: Vec::new(), suspects: Vec::new() }
    }

    fn find(&mut self, corners: &[u32], twins: &[AtomicU32]) {
        let (starts, mut entries) = self.buckets(corners);
        for range in starts.windows(2) {
            let bucket = &mut entries[range[0] as usize..range[1] as usize];
            bucket.sort_unstable();
            for edge in bucket.chunk_by(|a, b| a >> 32 == b >> 32) {
                self.add(edge, corners, twins);
            }
        }
    }

    fn add(&mut self, edge: &[u64], corners: &[u32], twins: &[AtomicU32]) {
        match edge {
            [] | [_] => {}
            &[a, b] => {
                let (a, b) = (a as u32, b as u32);
                twins[a as usize].store(b, Ordering::Relaxed);
                twins[b as usize].store(a, Ordering::Relaxed);
                if corners[previous(a) as usize] == corners[previous(b) as usize] {
                    self.suspects.extend([a / 3, b / 3]);
                }
            }
            many => {
                let sides: Vec<u32> = many.iter().map(|&entry| entry as u32).collect();
                self.suspects.extend(sides.iter().map(|side| side / 3));
                self.crowded.push(sides);
            }
        }
    }

    /// Sides by their smaller place: where buckets start, and (larger place, side) of each.
    fn buckets(&self, corners: &[u32]) -> (Vec<u32>, Vec<u64>) {
        let mut ends = vec![0_u32; self.places + 1];
        self.for_each_side(corners, |bucket, _, _| ends[bucket] += 1);
        let mut end = 0;
        for bucket in &mut ends {
            // Where it starts; filling moves it to where it ends.
            (*bucket, end) = (end, end + *bucket);
        }
        let mut entries = vec![0_u64; end as usize];
        self.for_each_side(corners, |bucket, larger, side| {
            let slot = &mut ends[bucket];
            entries[*slot as usize] = u64::from(larger) << 32 | u64::from(side);
            *slot += 1;
        });
        ends.rotate_right(1);
        ends[0] = 0;
        (ends, entries)
    }

    fn for_each_side(&self, corners: &[u32], mut work: impl FnMut(usize, u32, u32)) {
        let mut side_between = |a: u32, b: u32, side: u32| {
            let bucket = (a.min(b) as usize).wrapping_sub(self.first);
            if bucket < self.places {
                work(bucket, a.max(b), side);
            }
        };
        for (triangle, &[a, b, c]) in corners.as_chunks::<3>().0.iter().enumerate() {
            // Of a triangle that was left out, all are beyond every bucket.
            let side = triangle as u32 * 3;
            side_between(a, b, side);
            side_between(b, c, side + 1);
            side_between(c, a, side + 2);
        }
    }
}

/// Leaves out all but the first of `suspects` with the same three corners: (left out, kept) triangles.
pub(super) fn drop_duplicates(corners: &mut [u32], mut suspects: Vec<u32>) -> Vec<(u32, u32)> {
    suspects.sort_unstable();
    suspects.dedup();
    let mut by_corners: Vec<([u32; 3], u32)> = suspects
        .into_iter()
        .map(|triangle| {
            let mut places = [0, 1, 2].map(|corner| corners[(triangle * 3 + corner) as usize]);
            places.sort_unstable();
            (places, triangle)
        })
        .collect();
    by_corners.sort_unstable();
    let mut dropped = Vec::new();
    for same in by_corners.chunk_by(|a, b| a.0 == b.0) {
        for &(_, triangle) in &same[1..] {
            corners[triangle as usize * 3..][..3].fill(NONE);
            dropped.push((triangle, same[0].1));
        }
    }
    dropped
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_triangles_share_one_edge() {
        let edges = find(&[0, 1, 2, 2, 1, 3], 4, &Exec::new(2).unwrap());
        assert_eq!(edges.twins, [NONE, 3, NONE, 1, NONE, NONE]);
    }
}
