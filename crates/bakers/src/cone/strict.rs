//! The steepest ascent from anywhere in a cell to anywhere on the relief, to within a tolerance.

use super::ascent::{Ascent, Source, Square};
use super::bounds::{Bounds, Steepest};
use super::ground::Ground;
use super::patch::Patch;
use crate::maximum_mip::MaximumMip;
use crate::memory::zeros;
use crate::{BakeError, Exec};

/// How often the patches of a pair may be halved, both together. Square cells need ten, those of eight
/// times the length three more for each of the two.
const HALVINGS: u32 = 16;

/// For every texel, a slope that no ascent exceeds whose lower end is within a texel of its centre along u and v; none
/// is below `least`.
pub(super) fn slopes(ground: &Ground, mip: &MaximumMip, least: f64, exec: &Exec) -> Result<Vec<f64>, BakeError> {
    let [columns, rows] = ground.cells();
    let mut of_cells: Vec<f64> = zeros("the slopes of a cone map", u64::from(columns) * u64::from(rows))?;
    let ascent = Ascent::new(mip, ground, 0.5);
    let bands = of_cells.chunks_mut(columns as usize).enumerate().collect();
    exec.for_each_with(bands, Vec::new, |squares: &mut Vec<Square>, (row, slopes): (usize, &mut [f64])| {
        for (column, slope) in slopes.iter_mut().enumerate() {
            let mut foot = Foot::new(ground, [column as i64, row as i64], least);
            ascent.search(&mut foot, squares);
            *slope = foot.steepest.0;
        }
    });
    let mut of_texels = zeros("the slopes of a cone map", ground.grid.texels() as u64)?;
    let width = ground.grid.width as usize;
    for (texel, slope) in of_texels.iter_mut().enumerate() {
        let (column, row) = ((texel % width) as i64, (texel / width) as i64);
        *slope = [(-1, -1), (0, -1), (-1, 0), (0, 0)].into_iter().fold(least, |steepest, (i, j)| {
            // Beyond a clamped edge the relief is that of the edge, and farther from everything else.
            let edge = ground.grid.edge;
            let cell = edge.resolve(row + j, rows) * columns as usize + edge.resolve(column + i, columns);
            steepest.max(of_cells[cell])
        });
    }
    Ok(of_texels)
}

/// A cell as the foot of ascents.
struct Foot<'a> {
    ground: &'a Ground<'a>,
    cell: [i64; 2],
    /// In lengths from the centre of the cell's own texel.
    patch: Patch,
    lowest: f64,
    steepest: Steepest,
}

impl<'a> Foot<'a> {
    fn new(ground: &'a Ground, cell: [i64; 2], least: f64) -> Self {
        let patch = ground.cell(cell, cell);
        Self { ground, cell, patch, lowest: patch.lowest(), steepest: Steepest(near(ground, cell).max(least)) }
    }

    /// Takes in all ascents between two patches.
    fn raise(&mut self, from: &Patch, to: &Patch, halvings: u32) {
        if self.steepest.settle(Bounds::between(from, to), halvings == 0) {
            return;
        }
        if longest(from) >= longest(to) {
            from.halves().iter().for_each(|from| self.raise(from, to, halvings - 1));
        } else {
            to.halves().iter().for_each(|to| self.raise(from, to, halvings - 1));
        }
    }
}

impl Source for Foot<'_> {
    fn place(&self) -> [[i64; 2]; 2] {
        self.cell.map(|index| [index, index + 1])
    }

    fn height(&self) -> f64 {
        self.lowest
    }

    fn slope(&self) -> f64 {
        self.steepest.0
    }

    fn look_into(&mut self, cell: [i64; 2]) {
        let away = [cell[0] - self.cell[0], cell[1] - self.cell[1]];
        if away.iter().any(|cells| cells.abs() > 1) {
            let to = self.ground.cell(cell, self.cell);
            facing(self.patch, away).for_each(|side| self.raise(&side, &to, HALVINGS));
        }
    }
}

/// No ascent from a cell into itself or one of the eight around it is steeper.
fn near(ground: &Ground, [column, row]: [i64; 2]) -> f64 {
    let around = (-1..=1).flat_map(|j| (-1..=1).map(move |i| [i, j]));
    around
        .fold(0.0, |steepest, [i, j]| steepest.max(ground.cell([column + i, row + j], [column, row]).steepest([i, j])))
}

/// The sides of a cell that look towards one so many columns and rows away.
fn facing(cell: Patch, [columns, rows]: [i64; 2]) -> impl Iterator<Item = Patch> {
    let [[h00, h10], [h01, h11]] = cell.heights;
    let along_v = (columns != 0).then(|| {
        let (u, heights) = if columns > 0 { (cell.u[1], [h10, h11]) } else { (cell.u[0], [h00, h01]) };
        Patch { u: [u; 2], heights: heights.map(|height| [height; 2]), ..cell }
    });
    let along_u = (rows != 0).then(|| {
        let (v, heights) = if rows > 0 { (cell.v[1], [h01, h11]) } else { (cell.v[0], [h00, h10]) };
        Patch { v: [v; 2], heights: [heights; 2], ..cell }
    });
    along_v.into_iter().chain(along_u)
}

fn longest(patch: &Patch) -> f64 {
    let [along_u, along_v] = patch.sides();
    along_u.max(along_v)
}
