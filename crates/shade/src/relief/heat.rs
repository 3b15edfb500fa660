//! A heat map: how much every pixel cost, in false colour, as figure 9 of Takeshi Suzuki, *An Accelerated Relief Mapping Using Depth
//! Maps*.

use crate::Picture;
use crate::picture::BACKGROUND;

/// The digits, three columns and five rows of dots, the upper left one in the highest bit.
const DIGITS: [u16; 10] = [
    0b111_101_101_101_111,
    0b010_110_010_010_111,
    0b111_001_111_100_111,
    0b111_001_111_001_111,
    0b101_101_111_001_001,
    0b111_100_111_001_111,
    0b111_100_111_101_111,
    0b111_001_010_010_010,
    0b111_101_111_101_111,
    0b111_101_111_001_111,
];

/// Pixels of a dot of a digit.
const DOT: u32 = 2;
/// Pixels around what is in the legend.
const MARGIN: u32 = 6;
/// Pixels of the legend's bar from its upper to its lower edge.
const BAR: u32 = 10;
/// Pixels of the whole legend: margin, bar, margin, digits, margin.
const LEGEND: u32 = 3 * MARGIN + BAR + 5 * DOT;

/// Counts as colours, and below them a bar from 0 at the left to `greatest` at the right, with these two numbers.
///
/// `colour` takes 0 to 1; what is more than `greatest` has the colour of 1. Pixels without a count are background.
///
/// # Panics
/// If `counts` are not so many rows of `width`.
#[must_use]
pub fn heat_map(counts: &[Option<u32>], width: u32, greatest: u32, colour: impl Fn(f64) -> [u8; 3]) -> Picture {
    assert!(width > 0 && counts.len().is_multiple_of(width as usize), "whole rows of counts");
    let share = |count: u32| (f64::from(count) / f64::from(greatest.max(1))).min(1.0);
    let mut rgb: Vec<u8> =
        counts.iter().flat_map(|count| count.map_or(BACKGROUND, |count| colour(share(count)))).collect();
    let height = (counts.len() / width as usize) as u32;
    let greatest = greatest.to_string();
    let right_label = width.saturating_sub(MARGIN + label_width(&greatest));
    for row in 0..LEGEND {
        for column in 0..width {
            let is_dark = label_dot("0", column, row, MARGIN) || label_dot(&greatest, column, row, right_label);
            rgb.extend(match bar_place(column, row, width) {
                Some(place) => colour(place),
                None if is_dark => [235; 3],
                None => BACKGROUND,
            });
        }
    }
    Picture { width, height: height + LEGEND, rgb }
}

/// How far along the bar a pixel of the legend is.
fn bar_place(column: u32, row: u32, width: u32) -> Option<f64> {
    let (first, last) = (MARGIN, width.checked_sub(MARGIN + 1)?);
    let inside = (MARGIN..MARGIN + BAR).contains(&row) && (first..=last).contains(&column);
    inside.then(|| f64::from(column - first) / f64::from((last - first).max(1)))
}

fn label_width(label: &str) -> u32 {
    (4 * label.len() as u32).saturating_sub(1) * DOT
}

/// Whether a pixel of the legend is a dot of a number that begins at the column `left`.
fn label_dot(number: &str, column: u32, row: u32, left: u32) -> bool {
    let (Some(column), Some(row)) = (column.checked_sub(left), row.checked_sub(2 * MARGIN + BAR)) else { return false };
    let (column, row) = (column / DOT, row / DOT);
    let digit = number.as_bytes().get(column as usize / 4).map(|byte| usize::from(byte.wrapping_sub(b'0')));
    let dots = digit.and_then(|digit| DIGITS.get(digit)).copied().unwrap_or(0);
    row < 5 && column % 4 < 3 && dots >> (14 - (3 * row + column % 4)) & 1 == 1
}
