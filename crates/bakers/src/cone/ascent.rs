//! The cells that may stand steeply above a place, found from the highest points of ever smaller squares.

use barchan_field::{Edge, Grid};

use super::ground::Ground;
use crate::maximum_mip::{MaximumMip, children};

/// What looks for the steepest ascent from a place.
pub(super) trait Source {
    /// The place: first and last column and row, in texels from the centre of texel (0, 0).
    fn place(&self) -> [[i64; 2]; 2];
    /// Its lowest height.
    fn height(&self) -> f64;
    /// Only an ascent steeper than this matters.
    fn slope(&self) -> f64;
    /// Is nothing in a square of what is looked for? Its points are at most so far along u and v, in lengths, and so high.
    fn rules_out(&self, _level: usize, _index: [u32; 2], _farthest: [f64; 2], _highest: f64) -> bool {
        false
    }
    /// A cell that may hold such an ascent, by its column and row, which on repeated tiles may be beyond the edge.
    fn look_into(&mut self, cell: [i64; 2]);
}

/// Searches the whole relief for steep ascents.
pub(super) struct Ascent<'a> {
    mip: &'a MaximumMip,
    grid: Grid,
    /// Cells along u and v that there are.
    cells: [u32; 2],
    /// Cells farther than this from the place along u or v need no look: those of a nearer repetition are as high.
    reach: [f64; 2],
}

/// A square of a level, in one of the repetitions of the tile.
#[derive(Debug, Clone, Copy)]
pub(super) struct Square {
    level: usize,
    index: [u32; 2],
    /// The first cell of its repetition.
    tile: [i64; 2],
    /// The square of its greatest possible slope.
    squared_slope: f64,
}

impl<'a> Ascent<'a> {
    /// Looks `reach` extents of the tile far, where it repeats.
    pub(super) fn new(mip: &'a MaximumMip, ground: &Ground, reach: f64) -> Self {
        let grid = ground.grid;
        let reach = [grid.width, grid.height].map(|extent| match grid.edge {
            Edge::Wrap => reach * f64::from(extent),
            Edge::Clamp => f64::INFINITY,
        });
        Self { mip, grid, cells: ground.cells(), reach }
    }

    /// Shows the source every cell that may hold an ascent steeper than its slope, the most promising squares first.
    /// `squares` is room for those yet to be looked at.
    pub(super) fn search(&self, source: &mut impl Source, squares: &mut Vec<Square>) {
        squares.clear();
        self.push_tiles(source, squares);
        while let Some(square) = squares.pop() {
            let slope = source.slope();
            if square.squared_slope <= slope * slope {
                continue;
            }
            if square.level > 0 {
                self.push_children(source, square, squares);
            } else if (0..2).all(|axis| square.index[axis] < self.cells[axis]) {
                source.look_into([0, 1].map(|axis| square.tile[axis] + i64::from(square.index[axis])));
            }
        }
    }

    fn push_tiles(&self, source: &impl Source, squares: &mut Vec<Square>) {
        let repetitions = if self.grid.edge == Edge::Wrap { -1..=1 } else { 0..=0 };
        let (width, height) = (i64::from(self.grid.width), i64::from(self.grid.height));
        for (j, i) in repetitions.clone().flat_map(|j| repetitions.clone().map(move |i| (j, i))) {
            self.push(source, self.mip.levels.len() - 1, [0, 0], [i * width, j * height], squares);
        }
        sort(squares);
    }

    fn push_children(&self, source: &impl Source, parent: Square, squares: &mut Vec<Square>) {
        let level = parent.level - 1;
        let finer = &self.mip.levels[level];
        let (columns, rows) = (children(parent.index[0], finer.width), children(parent.index[1], finer.height));
        let before = squares.len();
        for (row, column) in rows.flat_map(|row| columns.clone().map(move |column| (row, column))) {
            self.push(source, level, [column, row], parent.tile, squares);
        }
        sort(&mut squares[before..]);
    }

    fn push(&self, source: &impl Source, level: usize, index: [u32; 2], tile: [i64; 2], squares: &mut Vec<Square>) {
        let highest = f64::from(self.mip.levels[level].value(index[0], index[1]));
        let rise = highest - source.height();
        let [along_u, along_v] =
            [0, 1].map(|axis| self.span(level, axis, index[axis], source.place()[axis], tile[axis]));
        if rise <= 0.0 || along_u.nearest > self.reach[0] || along_v.nearest > self.reach[1] {
            return;
        }
        let lengths = |u: f64, v: f64| [u * self.grid.spacing.u(), v * self.grid.spacing.v()];
        let [u, v] = lengths(along_u.nearest, along_v.nearest);
        let (squared_slope, slope) = (rise * rise / (u * u + v * v), source.slope());
        let farthest = lengths(along_u.farthest, along_v.farthest);
        if squared_slope > slope * slope && !source.rules_out(level, index, farthest, highest) {
            squares.push(Square { level, index, tile, squared_slope });
        }
    }

    /// Cells between the place and the points of a square, along one axis.
    fn span(&self, level: usize, axis: usize, index: u32, place: [i64; 2], tile: i64) -> Span {
        let finest = [self.mip.levels[0].width, self.mip.levels[0].height][axis];
        let extent = [self.mip.levels[level].width, self.mip.levels[level].height][axis];
        let first = tile + (i64::from(index) << level);
        let end = if index + 1 == extent { tile + i64::from(finest) } else { first + (1 << level) };
        Span {
            nearest: (first - place[1]).max(place[0] - end).max(0) as f64,
            farthest: (end - place[0]).max(place[1] - first) as f64,
        }
    }
}

/// From a place to a square along one axis, in cells.
struct Span {
    nearest: f64,
    farthest: f64,
}

/// The steepest last, which is looked at first. The sort is stable, so there is only one order.
fn sort(squares: &mut [Square]) {
    squares.sort_by(|a, b| a.squared_slope.total_cmp(&b.squared_slope));
}
