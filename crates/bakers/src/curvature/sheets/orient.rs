//! One front for every connected piece of surface.
//!
//! From the first triangle of a piece the front is carried over every joined edge, hard ones too. A piece then faces the way that the
//! greater part of its area faced in the file; the first triangle decides where they are equal. Edges whose two triangles still disagree
//! are those across which no front can be carried, as somewhere on a Möbius strip: there the surface ends.

use glam::DVec3;

use super::PIECE;
use super::surface::{NONE, Surface};
use crate::Exec;

/// What was done.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Turned {
    pub(super) triangles: u64,
    pub(super) unorientable_edges: u64,
}

/// Turns triangles over until neighbours agree.
pub(super) fn orient(surface: &mut Surface, positions: &[DVec3], exec: &Exec) -> Turned {
    if all_agree(surface, exec) {
        return Turned::default();
    }
    let turned = choose_fronts(surface, positions);
    let triangles = turned.iter().filter(|&&turned| turned).count() as u64;
    surface.turn(turned);
    let mut unorientable_edges = 0;
    for side in surface.sides() {
        let Some(twin) = surface.twin(side).filter(|&twin| side < twin) else { continue };
        if !surface.agree(side, twin) {
            surface.cut(side, twin);
            unorientable_edges += 1;
        }
    }
    Turned { triangles, unorientable_edges }
}

fn all_agree(surface: &Surface, exec: &Exec) -> bool {
    let pieces = surface.sides().step_by(PIECE);
    let mut agree = vec![true; pieces.len()];
    exec.for_each_quietly(agree.iter_mut().zip(pieces).collect(), |_, (agree, first)| {
        let mut sides = first..surface.sides().end.min(first + PIECE as u32);
        *agree = sides.all(|side| surface.twin(side).is_none_or(|twin| surface.agree(side, twin)));
    });
    agree.into_iter().all(|agree| agree)
}

/// Which triangles to turn over.
fn choose_fronts(surface: &Surface, positions: &[DVec3]) -> Vec<bool> {
    let count = surface.sides().len() / 3;
    let mut turned = vec![false; count];
    let mut seen = vec![false; count];
    let mut piece = Vec::new();
    for first in 0..count {
        if seen[first] || surface.corners[first * 3] == NONE {
            continue;
        }
        seen[first] = true;
        piece.clear();
        piece.push(first as u32);
        spread(surface, &mut piece, &mut seen, &mut turned);
        // In the order of the file, so that the sums do not depend on the way.
        piece.sort_unstable();
        let mut balance = 0.0;
        for &triangle in &piece {
            let area = double_area(surface, positions, triangle);
            balance += if turned[triangle as usize] { -area } else { area };
        }
        if balance < 0.0 {
            for &triangle in &piece {
                turned[triangle as usize] ^= true;
            }
        }
    }
    turned
}

/// Carries the front of the only triangle of `piece` as far as edges are joined.
fn spread(surface: &Surface, piece: &mut Vec<u32>, seen: &mut [bool], turned: &mut [bool]) {
    let mut done = 0;
    while let Some(&triangle) = piece.get(done) {
        done += 1;
        for side in triangle * 3..triangle * 3 + 3 {
            let Some(twin) = surface.twin(side) else { continue };
            let neighbour = (twin / 3) as usize;
            if !seen[neighbour] {
                seen[neighbour] = true;
                turned[neighbour] = turned[triangle as usize] ^ !surface.agree(side, twin);
                piece.push(twin / 3);
            }
        }
    }
}

/// Twice the area of a triangle.
pub(super) fn double_area(surface: &Surface, positions: &[DVec3], triangle: u32) -> f64 {
    let [a, b, c] = [0, 1, 2].map(|corner| positions[surface.from(triangle * 3 + corner) as usize]);
    (b - a).cross(c - a).length()
}
