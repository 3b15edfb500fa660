//! Depths of many texels to those of fewer, by the least: the shallowest is kept.
//!
//! Suzuki's eq 2, t′[x, y] = min of the 2 × 2 texels of t that it covers, repeated, for halved sides. For any other size, odd ones
//! included, target texel k of w covers the source texels floor(k·W/w) up to ceil((k+1)·W/w) − 1 of W: all that it touches, so that
//! two targets may share a source, and none beyond the tile's edge. For powers of two both are the same.

use std::ops::Range;

/// The source texels that target texel `index` of `target` covers along one axis of `source` texels.
pub(super) fn footprint(index: u32, target: u32, source: u32) -> Range<u32> {
    let (index, target, source) = (u64::from(index), u64::from(target), u64::from(source));
    let (start, end) = (index * source / target, ((index + 1) * source).div_ceil(target));
    start as u32..end as u32
}

/// Lowers a row of the table to the least of a row of the source that it covers.
pub(super) fn lower_row(table: &mut [f32], source: &[f32]) {
    let (target_width, source_width) = (table.len() as u32, source.len() as u32);
    for (column, depth) in table.iter_mut().enumerate() {
        let covered = footprint(column as u32, target_width, source_width);
        let covered = &source[covered.start as usize..covered.end as usize];
        *depth = covered.iter().fold(*depth, |least, &depth| least.min(depth));
    }
}
