//! Maximum mipmaps: blocks of cells that the ray passes above are skipped, cells are solved exactly.
//!
//! # Theory
//!
//! Level k of the table holds the greatest height over 2ᵏ × 2ᵏ cells, bilinear surface included. A ray that leaves a block
//! above it has not met it: on to the block behind. Otherwise it is followed down to that height and looks at a block of
//! half the size, down to the cell, whose four heights tell exactly. Nothing is stepped over, and the hit has no error.
//!
//! Art Tevs, Ivo Ihrke, Hans-Peter Seidel, *Maximum Mipmaps for Fast, Accurate, and Scalable Dynamic Height Field
//! Rendering*, 2008.
//!
//! # Departures
//!
//! - Level 0 is not read: a gather of the cell's heights costs as much and decides.
//! - The level to begin with is that whose blocks are about as long as the way that a ray is likely to have before it: a
//!   quarter of the whole from the top, 1/32 behind a start that was looked up. Tevs et al. begin with one block over
//!   everything.
//! - A level up is taken where a block of that level begins, as in the paper, but only if the ray left the last block so high
//!   above it that it would come through the larger one, too, if that were no higher.
//! - From the highest point of a block a ray has little of the block before it: levels whose blocks are much longer than
//!   that are left out on the way down.
//!
//! None of it changes a hit.

use barchan_asset::{MaximumMipView, Wrap};

use super::cell::{Block, Cell, Exit};
use super::matching::{MismatchedRelief, check_texels, check_top};
use super::start::{leave_relief_to, way_ahead};
use super::{Fetches, Found, Relief, ReliefRay, ReliefSearch, Start};

/// Beyond an edge that clamps a block has no end: farther than any ray goes.
const ENDLESS: i64 = 1 << 50;

/// From the highest point of a block a ray goes on at a level whose blocks are at most so many times as long as its way to the
/// block's end. 1 takes up to 6 % more fetches on spikes, no bound at all 6 %.
const LONGEST_BLOCK: f64 = 4.0;

/// Traversal of maximum mipmaps.
#[derive(Debug, Clone)]
pub struct MaximumMipTraversal<'a> {
    relief: Relief<'a>,
    levels: Vec<Level>,
    wrap: (Wrap, Wrap),
}

/// Depths of the highest points of blocks.
#[derive(Debug, Clone)]
struct Level {
    extent: (u32, u32),
    depths: Vec<f64>,
}

/// A block that a ray is in.
struct Place {
    block: Block,
    /// Column and row of the block's texel.
    texel: (u32, u32),
}

/// What a look at a block or a cell tells.
enum Look {
    Hit(f64),
    /// The ray may hit, at that depth or behind, from that cell on; the level to look at there.
    Closer(f64, Cell, usize),
    /// The ray leaves the block so far above all of it.
    Passed(Exit, f64),
}

impl<'a> MaximumMipTraversal<'a> {
    /// Of maximum mips and the heights they were baked of.
    ///
    /// # Errors
    /// A table with another size, spacing, edge or a lower top.
    pub fn new(relief: &Relief<'a>, mips: &MaximumMipView<'_>) -> Result<Self, MismatchedRelief> {
        check_texels(relief, mips.descriptor(), "maximum mip")?;
        check_top(relief, mips, "maximum mip")?;
        let level = |level| {
            let (width, height) = mips.extent(level);
            let depth = |column, row| relief.depth_of(mips.value(level, column, row).into());
            let depths = (0..height).flat_map(|row| (0..width).map(move |column| depth(column, row))).collect();
            Level { extent: (width, height), depths }
        };
        let levels = (0..mips.levels()).map(level).collect();
        Ok(Self { relief: *relief, levels, wrap: relief.surface().heights().wrap() })
    }

    /// The level to begin with.
    fn first_level(&self, ray: &ReliefRay, depth: f64) -> usize {
        self.level_as_long_as(way_ahead(ray, depth))
    }

    /// The coarsest level whose blocks are no longer than a way in texels.
    fn level_as_long_as(&self, way: f64) -> usize {
        let coarsest = self.levels.len().saturating_sub(1);
        (1..=coarsest).take_while(|&level| (1_u64 << level) as f64 <= way).last().unwrap_or(0)
    }

    /// The block of a level that a cell is in.
    fn place(&self, level: usize, cell: Cell) -> Place {
        let heights = self.relief.surface().heights();
        let extent = self.levels.get(level).map_or((1, 1), |level| level.extent);
        let (columns, column) = range(self.wrap.0, cell.column, heights.width(), (level, extent.0));
        let (rows, row) = range(self.wrap.1, cell.row, heights.height(), (level, extent.1));
        Place { block: Block { columns, rows }, texel: (column, row) }
    }

    /// Whether a ray passes above the block of a level above 0 that a cell is in. One fetch of a table.
    fn look_at(&self, ray: &ReliefRay, (level, cell): (usize, Cell), depth: f64) -> Look {
        let Place { block, texel: (column, row) } = self.place(level, cell);
        let Level { extent, depths } = &self.levels[level];
        let highest = depths[row as usize * extent.0 as usize + column as usize];
        let exit = block.exit(ray, depth);
        if highest > exit.depth && exit.depth < 1.0 {
            return Look::Passed(exit, highest - exit.depth);
        }
        let depth = depth.max(highest.min(exit.depth));
        let way_left = (exit.depth - depth) * ray.step.0.abs().max(ray.step.1.abs());
        let below = self.level_as_long_as(LONGEST_BLOCK * way_left).min(level - 1);
        Look::Closer(depth, block.cell_behind(ray, depth), below)
    }

    /// Whether a ray hits the surface in a cell. One fetch of a height.
    fn look_into(&self, ray: &ReliefRay, cell: Cell, depth: f64) -> Look {
        let exit = self.place(0, cell).block.exit(ray, depth);
        let corners = self.relief.corners(cell);
        match cell.first_hit(ray, corners, (depth, exit.depth)) {
            Some(hit) => Look::Hit(hit),
            // Nothing is deeper than 1, whatever rounding says.
            None if exit.depth >= 1.0 => Look::Hit(1.0),
            None => Look::Passed(exit, cell.gap(ray, corners, exit.depth)),
        }
    }

    /// Whether a level up pays for a ray that comes from one cell into the next with a gap above what it passed.
    fn goes_up(&self, ray: &ReliefRay, level: usize, (from, to): (Cell, Cell), gap: f64) -> bool {
        let above = level + 1;
        if above >= self.levels.len() || self.place(above, from).texel == self.place(above, to).texel {
            return false;
        }
        // What the ray sinks along one side of the larger block.
        gap * ray.step.0.abs().max(ray.step.1.abs()) > (1_u64 << above) as f64
    }
}

impl ReliefSearch for MaximumMipTraversal<'_> {
    fn name(&self) -> &'static str {
        "maximum mip"
    }

    fn find(&self, ray: &ReliefRay, start: Start) -> Found {
        let mut fetches = start.fetches;
        let mut depth = leave_relief_to(&self.relief, ray, start, &mut fetches);
        let (mut cell, mut level) = (Cell::behind(ray, depth), self.first_level(ray, depth));
        // It ends: a ray's way is bounded, and between two blocks left behind only levels are gone down.
        loop {
            let look =
                if level == 0 { self.look_into(ray, cell, depth) } else { self.look_at(ray, (level, cell), depth) };
            fetches += if level == 0 { Fetches::HEIGHT } else { Fetches::TABLE };
            match look {
                Look::Hit(depth) => return Found { depth, fetches },
                Look::Closer(from, within, below) => (depth, cell, level) = (from, within, below),
                Look::Passed(exit, gap) => {
                    level += usize::from(self.goes_up(ray, level, (cell, exit.next), gap));
                    (depth, cell) = (exit.depth, exit.next);
                }
            }
        }
    }
}

/// The range of cells along one axis that share a texel of a level, and which texel that is.
///
/// A tile that repeats is cut at its end; beyond an edge that clamps all cells are alike, and count to the last texel.
fn range(wrap: Wrap, cell: i64, size: u32, (level, extent): (usize, u32)) -> ((i64, i64), u32) {
    let (size, last) = (i64::from(size), i64::from(extent) - 1);
    let (tile, inside) = match wrap {
        Wrap::Repeat => (cell.div_euclid(size) * size, cell.rem_euclid(size)),
        Wrap::Clamp => (0, cell.clamp(0, size - 1)),
    };
    let texel = (inside >> level).min(last);
    let (low, high) = (texel << level, if texel == last { size } else { (texel + 1) << level });
    let ends = match wrap {
        Wrap::Repeat => (tile + low, tile + high),
        // A cell before the first is flat; the first is not.
        Wrap::Clamp if level == 0 && cell < 0 => (-ENDLESS, 0),
        Wrap::Clamp => {
            (if level > 0 && texel == 0 { -ENDLESS } else { low }, if texel == last { ENDLESS } else { high })
        }
    };
    (ends, texel as u32)
}
