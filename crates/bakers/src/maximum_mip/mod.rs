//! The highest point of every square of the relief, from single cells up to the whole.
//!
//! # What is baked
//!
//! The surface between four texel centres is bilinear, so that it is nowhere above the highest of the four: a ray that
//! stays above that height need not look into the cell. Level 0 holds this height for the cell to the right of and
//! below each texel; level k the highest of 2 × 2 values of level k − 1, and the last level is one value. Art Tevs, Ivo
//! Ihrke, Hans-Peter Seidel, *Maximum Mipmaps for Fast, Accurate, and Scalable Dynamic Height Field Rendering*, 2008.
//!
//! # Conventions
//!
//! There are as many cells as texels: the last column and row are the cells that the edge policy makes. With clamped
//! edges these are level across the edge; the cells before the first column and row, just as level, are not stored.
//!
//! Level k has ⌊n / 2ᵏ⌋ columns where level 0 has n, but at least one, as the mip chains of graphics interfaces do, and
//! rows alike. Cell c of level 0 is in column min(c >> k, columns − 1): the last column takes what an odd number leaves
//! over, so that at the coarser levels it may stand for nearly twice as many cells as another.
//!
//! Heights are samples of the field, in its unit of length; nothing is rounded.

mod map;
pub mod reference;

use barchan_field::{Grid, HeightField};

pub use map::{MaximumMip, MipLevel};

use crate::memory::zeros;
use crate::{BakeError, Exec};

/// Names the algorithm in provenance. It changes when a bake's bytes do.
pub const ALGORITHM: &str = "maximum-mip-1";

/// Rows filled as one piece of work.
const BAND_ROWS: usize = 64;

/// Bakes all levels.
///
/// # Errors
///
/// [`BakeError::Memory`] where the levels do not fit.
pub fn bake(field: &HeightField, exec: &Exec) -> Result<MaximumMip, BakeError> {
    Ok(MaximumMip { grid: *field.grid(), levels: pyramid(cells(field, exec)?, exec)? })
}

/// All levels over the finest, which may hold any kind of value.
pub(crate) fn pyramid(finest: MipLevel, exec: &Exec) -> Result<Vec<MipLevel>, BakeError> {
    let mut levels = vec![finest];
    loop {
        let finer = levels.last().expect("level 0 at least");
        if finer.width == 1 && finer.height == 1 {
            return Ok(levels);
        }
        let coarser = halve(finer, exec)?;
        levels.push(coarser);
    }
}

/// Level 0.
fn cells(field: &HeightField, exec: &Exec) -> Result<MipLevel, BakeError> {
    let Grid { width, height, .. } = *field.grid();
    fill(width, height, exec, |row, values| {
        let highest_of_two = |column| field.texel(column, row).max(field.texel(column, row + 1));
        let mut left = highest_of_two(0);
        for (column, value) in values.iter_mut().enumerate() {
            let right = highest_of_two(column as i64 + 1);
            *value = left.max(right);
            left = right;
        }
    })
}

/// The level after `finer`.
fn halve(finer: &MipLevel, exec: &Exec) -> Result<MipLevel, BakeError> {
    let [width, height] = [finer.width, finer.height].map(|extent| (extent / 2).max(1));
    fill(width, height, exec, |row, values| {
        let rows = children(row as u32, finer.height);
        for (column, value) in values.iter_mut().enumerate() {
            let columns = children(column as u32, finer.width);
            let highest_of_row = |row| columns.clone().map(|column| finer.value(column, row)).fold(f32::MIN, f32::max);
            *value = rows.clone().map(highest_of_row).fold(f32::MIN, f32::max);
        }
    })
}

/// The columns, or rows, of a level of `extent` that the one at `index` of the next level stands for: two, the last one
/// three where the extent is odd, and one where there is but one.
pub(crate) fn children(index: u32, extent: u32) -> std::ops::Range<u32> {
    let last = index + 1 == (extent / 2).max(1);
    2 * index..if last { extent } else { 2 * index + 2 }
}

/// A level whose rows are written by `write_row(row, values)`.
pub(crate) fn fill(
    width: u32,
    height: u32,
    exec: &Exec,
    write_row: impl Fn(i64, &mut [f32]) + Sync,
) -> Result<MipLevel, BakeError> {
    let columns = width as usize;
    let mut values = zeros("the maximum mip", u64::from(width) * u64::from(height))?;
    let bands = values.chunks_mut(BAND_ROWS * columns).collect();
    exec.for_each_quietly(bands, |band, values: &mut [f32]| {
        for (row, values) in values.chunks_mut(columns).enumerate() {
            write_row((band * BAND_ROWS + row) as i64, values);
        }
    });
    Ok(MipLevel { width, height, values })
}
