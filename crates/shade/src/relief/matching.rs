//! Whether a table belongs to a relief.

use barchan_asset::{MaximumMipView, ReliefRange, TextureDescriptor};

use super::Relief;

/// How far the lengths of two tables of one map may differ, relatively: rounding of the spacing of a smaller one.
const LENGTH_TOLERANCE: f64 = 1e-9;

/// A table for relief search that was baked of another height map than the relief it is to search.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error(
    "the {table} table has {difference} than the heights; a table baked of these heights, as they are stored, is accepted"
)]
pub struct MismatchedRelief {
    /// Which table.
    pub table: &'static str,
    /// In what it differs.
    pub difference: &'static str,
}

/// Where texels are one to one with the heights.
pub(crate) fn check_texels(
    relief: &Relief<'_>,
    descriptor: &TextureDescriptor,
    table: &'static str,
) -> Result<(), MismatchedRelief> {
    let heights = relief.surface().heights();
    let same = (descriptor.width, descriptor.height) == (heights.width(), heights.height());
    check(same, table, "another size")?;
    check_tile(relief, descriptor, table)
}

/// Where a tile of any number of texels covers that of the heights.
pub(crate) fn check_tile(
    relief: &Relief<'_>,
    descriptor: &TextureDescriptor,
    table: &'static str,
) -> Result<(), MismatchedRelief> {
    let (along_u, along_v) = relief.surface().extent();
    let near = |found: f64, expected: f64| (found - expected).abs() <= LENGTH_TOLERANCE * expected;
    let same = near(f64::from(descriptor.width) * descriptor.spacing_u, along_u)
        && near(f64::from(descriptor.height) * descriptor.spacing_v, along_v);
    check(same, table, "another spacing")?;
    check((descriptor.wrap_u, descriptor.wrap_v) == relief.surface().heights().wrap(), table, "another edge")
}

pub(crate) fn check_range(
    relief: &Relief<'_>,
    found: ReliefRange,
    table: &'static str,
) -> Result<(), MismatchedRelief> {
    check((found.top, found.thickness) == relief.range(), table, "another range of depths")
}

/// The coarsest level must cover the highest sample.
pub(crate) fn check_top(
    relief: &Relief<'_>,
    mip: &MaximumMipView<'_>,
    table: &'static str,
) -> Result<(), MismatchedRelief> {
    let top = mip.value(mip.levels().saturating_sub(1), 0, 0);
    check(f64::from(top) >= relief.range().0, table, "another range of heights")
}

fn check(same: bool, table: &'static str, difference: &'static str) -> Result<(), MismatchedRelief> {
    if same { Ok(()) } else { Err(MismatchedRelief { table, difference }) }
}
