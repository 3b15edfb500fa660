//! Edges at which more than two triangles meet.
//!
//! Seen along the edge, triangles are hands of a clock. Each names the hand that is nearest to opposite it; the straightest such pair is
//! joined, then the next of which both are free. What is bent by more than a right angle, or finds its partner taken, ends at the edge:
//! so the stem of a T is a sheet of its own, and two sheets that cross stay two sheets.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::DVec3;

use super::surface::{Surface, previous};

/// Joins the sides of one edge in pairs that continue each other.
pub(super) fn join_straightest(surface: &mut Surface, sides: &[u32], positions: &[DVec3]) {
    let hands = hands(surface, sides, positions);
    let mut pairs: Vec<(f64, u32, u32)> = hands.iter().filter_map(|&hand| most_opposite(&hands, hand)).collect();
    pairs.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    for (bend, a, b) in pairs {
        if bend <= FRAC_PI_2 && surface.twin(a).is_none() && surface.twin(b).is_none() {
            surface.join(a, b);
        }
    }
}

/// The angle at which each side's triangle stands around the edge, ascending; none for triangles without an area.
fn hands(surface: &Surface, sides: &[u32], positions: &[DVec3]) -> Vec<(f64, u32)> {
    let [from, to] = [surface.from(sides[0]), surface.to(sides[0])];
    let [start, end] = [from.min(to), from.max(to)].map(|place| positions[place as usize]);
    let axis = (end - start).normalize_or_zero();
    let (right, up) = axis.any_orthonormal_pair();
    let mut hands: Vec<(f64, u32)> = sides
        .iter()
        .filter_map(|&side| {
            let third = positions[surface.from(previous(side)) as usize] - start;
            let (x, y) = (third.dot(right), third.dot(up));
            let stands = x.hypot(y) > 1e-9 * third.length();
            stands.then(|| (libm::atan2(y, x), side))
        })
        .collect();
    hands.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    hands
}

/// The hand nearest to opposite `hand`: by how much the two are bent, and both sides, the smaller first.
fn most_opposite(hands: &[(f64, u32)], (angle, side): (f64, u32)) -> Option<(f64, u32, u32)> {
    let opposite = if angle > 0.0 { angle - PI } else { angle + PI };
    let after = hands.partition_point(|hand| hand.0 < opposite);
    let count = hands.len();
    // The hands around the opposite; hands go round.
    [after + count - 1, after]
        .into_iter()
        .map(|index| hands[index % count])
        .filter(|other| other.1 != side)
        .map(|other| {
            let apart = (other.0 - opposite).abs();
            (apart.min(TAU - apart), side.min(other.1), side.max(other.1))
        })
        .min_by(|a, b| a.0.total_cmp(&b.0))
}
