//! Heights for texels that have none.

use barchan_field::Edge;

use crate::{DecodeError, Fill, heights::Heights, heights::texel};

/// Replaces every missing height by the rule; without a rule, or with nothing to go by, a missing height is an error.
pub(crate) fn fill(map: &mut Heights, width: u32, edge: Edge, rule: Option<Fill>) -> Result<(), DecodeError> {
    let Some((first, value)) = map.first_missing else {
        return Ok(());
    };
    let total = map.heights.len() as u64;
    if map.missing == total {
        return Err(DecodeError::AllInvalid { value, total });
    }
    match rule {
        None => {
            let (column, row) = texel(first, width);
            return Err(DecodeError::NoHeight { column, row, value, count: map.missing, total });
        }
        Some(Fill::Value(height)) => constant(&mut map.heights, height as f32),
        Some(Fill::Lowest) => {
            let lowest = map.heights.iter().fold(f32::INFINITY, |low, &h| low.min(h));
            constant(&mut map.heights, lowest);
        }
        Some(Fill::Nearest) => nearest(&mut map.heights, width as usize, edge),
    }
    Ok(())
}

fn constant(heights: &mut [f32], height: f32) {
    heights.iter_mut().filter(|h| h.is_nan()).for_each(|h| *h = height);
}

/// Breadth first from all known heights at once, so in time proportional to the texels. The front stays sorted by the row
/// order of where its heights came from; hence of several nearest texels the first in row order wins.
fn nearest(heights: &mut [f32], width: usize, edge: Edge) {
    let known = |i: &usize| !heights[*i].is_nan();
    let borders = |i: &usize| neighbours(*i, heights.len(), width, edge).iter().any(|&n| heights[n].is_nan());
    let mut front: Vec<usize> = (0..heights.len()).filter(known).filter(borders).collect();
    while !front.is_empty() {
        let mut next = Vec::new();
        for &i in &front {
            for n in neighbours(i, heights.len(), width, edge) {
                if heights[n].is_nan() {
                    heights[n] = heights[i];
                    next.push(n);
                }
            }
        }
        front = next;
    }
}

/// Above, left, right and below; beyond a clamped edge, the texel itself.
fn neighbours(i: usize, texels: usize, width: usize, edge: Edge) -> [usize; 4] {
    let (column, row) = ((i % width) as i64, (i / width) as i64);
    let at = |c: i64, r: i64| edge.resolve(r, (texels / width) as u32) * width + edge.resolve(c, width as u32);
    [at(column, row - 1), at(column - 1, row), at(column + 1, row), at(column, row + 1)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The definition: try every known texel.
    fn nearest_by_search(heights: &[f32], width: usize, edge: Edge) -> Vec<f32> {
        let steps = |a: usize, b: usize, size: usize| {
            let d = a.abs_diff(b);
            if edge == Edge::Wrap { d.min(size - d) } else { d }
        };
        let distance = |i: usize, j: usize| {
            steps(i % width, j % width, width) + steps(i / width, j / width, heights.len() / width)
        };
        let known: Vec<usize> = (0..heights.len()).filter(|&i| !heights[i].is_nan()).collect();
        // `min_by_key` keeps the first of equals.
        (0..heights.len()).map(|i| heights[*known.iter().min_by_key(|&&k| distance(i, k)).unwrap()]).collect()
    }

    #[test]
    fn nearest_is_what_a_search_finds() {
        let mut state = 1_u32;
        for round in 0..400 {
            let (width, height) = (1 + round % 9, 1 + round / 9 % 7);
            let heights: Vec<f32> = (0..width * height)
                .map(|i| {
                    state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                    if i != 0 && state >> 29 != 0 { f32::NAN } else { i as f32 }
                })
                .collect();
            for edge in [Edge::Wrap, Edge::Clamp] {
                let mut filled = heights.clone();
                nearest(&mut filled, width, edge);
                assert_eq!(filled, nearest_by_search(&heights, width, edge), "{width} × {height}, {edge:?}");
            }
        }
    }
}
