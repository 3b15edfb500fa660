//! Which sides lie on one edge.
//!
//! Sides are put into buckets by the smaller of their two places and sorted there by the larger. Nearly all edges have two sides and are
//! joined on the spot; the others are left to [`branch`](super::branch).

use super::surface::{NONE, previous};

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
pub(super) fn find(corners: &[u32], places: usize) -> Edges {
    let (starts, mut entries) = buckets(corners, places);
    let mut edges = Edges { twins: vec![NONE; corners.len()], crowded: Vec::new(), suspects: Vec::new() };
    for range in starts.windows(2) {
        let bucket = &mut entries[range[0] as usize..range[1] as usize];
        bucket.sort_unstable();
        for edge in bucket.chunk_by(|a, b| a >> 32 == b >> 32) {
            edges.add(edge, corners);
        }
    }
    edges
}

impl Edges {
    fn add(&mut self, edge: &[u64], corners: &[u32]) {
        match edge {
            [] | [_] => {}
            &[a, b] => {
                let (a, b) = (a as u32, b as u32);
                self.twins[a as usize] = b;
                self.twins[b as usize] = a;
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
}

/// Sides by their smaller place: where buckets start, and (larger place, side) of each.
fn buckets(corners: &[u32], places: usize) -> (Vec<u32>, Vec<u64>) {
    let mut ends = vec![0_u32; places + 1];
    for_each_side(corners, |low, _, _| ends[low as usize] += 1);
    let mut end = 0;
    for bucket in &mut ends {
        // Where it starts; filling moves it to where it ends.
        (*bucket, end) = (end, end + *bucket);
    }
    let mut entries = vec![0_u64; end as usize];
    for_each_side(corners, |low, high, side| {
        let slot = &mut ends[low as usize];
        entries[*slot as usize] = u64::from(high) << 32 | u64::from(side);
        *slot += 1;
    });
    ends.rotate_right(1);
    ends[0] = 0;
    (ends, entries)
}

fn for_each_side(corners: &[u32], mut work: impl FnMut(u32, u32, u32)) {
    for (triangle, &[a, b, c]) in corners.as_chunks::<3>().0.iter().enumerate() {
        if a == NONE {
            continue;
        }
        let side = triangle as u32 * 3;
        work(a.min(b), a.max(b), side);
        work(b.min(c), b.max(c), side + 1);
        work(c.min(a), c.max(a), side + 2);
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
        let edges = find(&[0, 1, 2, 2, 1, 3], 4);
        assert_eq!(edges.twins, [NONE, 3, NONE, 1, NONE, NONE]);
    }
}
