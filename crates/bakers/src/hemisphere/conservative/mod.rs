//! Depths that no ray of a cell can meet the relief above, with a proof.
//!
//! # What is bounded
//!
//! A ray enters the top plane at a place x and stands at x + d·q at depth d, q being its way over the grid from depth 0 to depth 1. A table's
//! value holds for a set of rays: every x of a texel's footprint F, every q of a cell of directions Q. With the surface at depth D(p)
//! under a place p, a ray's first hit is h(x, q) = min { d : D(x + d·q) ≤ d }. It exists, as D is continuous and D ≤ 1. Two infima may be
//! taken in any order, so the least first hit of all rays is
//!
//! B = inf { d : some ray stands at depth d at a place with D ≤ d }.
//!
//! No ray has to be followed for it: places and depths are enough.
//!
//! # The bound
//!
//! Depth is cut into slabs \[dᵢ, eᵢ\], and each cell of the bilinear surface into 1, 2 × 2 or 4 × 4 parts, more in smaller maps. The
//! value is dᵢ of the first slab in which a part that is *reached* has a corner that is *high enough*:
//! - reached: it has a place in common with F + \[dᵢ, eᵢ\]·Q, everywhere that the rays stand in the slab ([`reach`]);
//! - high enough: its least corner depth is at most eᵢ ([`cells`]).
//!
//! *Proof.* Let a ray of the set hit first at h, in slab i, at the place p. Then p lies in F + \[dᵢ, eᵢ\]·Q, so the part that holds p is reached.
//! On a part of a bilinear cell the surface is bilinear, too: its depth is a mean of the depths at the part's four corners, so the least of
//! these is at most D(p) ≤ h ≤ eᵢ: the part is high enough. The first slab with such a part is therefore slab i or an earlier one, and its dᵢ
//! is at most h. ∎
//!
//! Depths and tangents of a slab and a cell of directions only appear as products, so F + \[dᵢ, eᵢ\]·Q is one sector of a ring, widened by the
//! footprint: cutting the cell of directions any finer gains nothing. What is given away is the depth of a slab, 1/255, what the sector moves
//! within it, and the rest of each part that the sector touches: on a fractal of 256² with footprints of 4 × 4 texels, whole cells start .006
//! shallower than 4 × 4 parts, and spikes of one texel up to .09.
//!
//! # Margins
//!
//! A shader works in f32, or less. The promise holds for
//! - a look-up that lands up to 2⁻¹⁰ of a table's texel, or about 2⁻¹⁰ of a cell of directions, beyond what it should: F and Q are widened by
//!   as much. This covers rounding of places, too: a ray a little off is a ray nearby;
//! - depths of surface and ray that are wrong by up to 2⁻²¹: values are 2⁻²⁰ less than they could be. Depths here are f32, wrong by
//!   2⁻²⁵, mixed in f64 at the corners of parts, and a part is high enough 2⁻²² early.
//!
//! Bytes hold the values without loss: see [`slabs`].
//!
//! # How it is fast
//!
//! Where parts high enough lie is one bit per part, and a row of target texels asks for the same parts around each of its texels: the
//! answer for 64 columns of parts is the bitwise or of a few shifted words ([`row_masks`]). Every column of parts is answered for, whatever
//! the size of the table; a texel takes the first slab of the columns that it covers. Where the sizes do not divide, these reach up to a
//! part beyond the footprint.
//!
//! The usual road is a march in slabs for each texel, with the least depths over boxes from windows of 2ᵏ × 2ᵏ texels. It gives
//! a looser bound, as boxes stand far around a slanting sector unless that is cut into many.

use std::ops::Range;

use barchan_asset::HemisphereDirections;

use self::cells::Cells;
use self::reach::Reach;
use self::rows::TargetRows;
use super::HemisphereParams;
use super::depths::Depths;
use crate::memory::MAX_TABLE_BYTES;
use crate::{BakeError, Exec};

mod cells;
mod reach;
mod row_masks;
mod rows;
mod sector;
mod slabs;

/// What the conservative mode keeps of a field: 4 bytes a part of a cell and 1 KiB a row of them.
pub(super) struct ConservativeBaker {
    cells: Cells,
    directions: HemisphereDirections,
    target: Target,
    /// How far a ray of tangent 1 moves from the top plane down to depth 1, in columns and in rows of parts.
    parts_per_tangent: (f64, f64),
}

/// The size of the table.
#[derive(Debug, Clone, Copy)]
struct Target {
    width: u32,
    height: u32,
}

impl ConservativeBaker {
    /// Prepares what all layers share. `params` have been accepted for the field.
    pub(super) fn new(depths: &Depths, params: &HemisphereParams, exec: &Exec) -> Result<Self, BakeError> {
        let cells = Cells::new(depths, exec)?;
        let bytes = row_masks::most_bytes(&cells).saturating_mul(exec.threads() as u64);
        if bytes > MAX_TABLE_BYTES {
            return Err(BakeError::TooLarge { what: "the masks of all threads", bytes, limit: MAX_TABLE_BYTES });
        }
        let spacing = depths.grid.spacing;
        let parts = f64::from(cells.columns().parts) * depths.relief.thickness;
        Ok(Self {
            cells,
            directions: params.directions,
            target: Target { width: params.width, height: params.height },
            parts_per_tangent: (parts / spacing.u(), parts / spacing.v()),
        })
    }
}

/// Fills some rows of the table in one layer: `values` are `rows.len()` rows of the target's width. It may be called for any rows of any
/// layer from several threads at once.
pub(super) fn bake_rows(baker: &ConservativeBaker, layer: u32, rows: Range<u32>, values: &mut [f32]) {
    let sector = sector::Sector::of_layer(&baker.directions, layer, baker.parts_per_tangent);
    let reach = Reach::new(&baker.cells, baker.target, sector);
    let mut rows = TargetRows::new(&baker.cells, baker.target, rows);
    for slab in 0..slabs::COUNT {
        if rows.are_done() {
            break;
        }
        rows.hit(slab, &reach);
    }
    rows.write(values);
}
