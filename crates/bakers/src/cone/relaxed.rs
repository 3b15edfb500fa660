//! The steepest ascent from a texel to where a ray from above it leaves the relief, to within a tolerance.

use barchan_asset::f32_at_least;

use super::ascent::{Ascent, Source, Square};
use super::bounds::{Bounds, Steepest, direction};
use super::ground::Ground;
use super::patch::Patch;
use crate::maximum_mip::{self, MaximumMip, MipLevel};
use crate::memory::zeros;
use crate::{BakeError, Exec};

/// How often a cell may be halved.
const HALVINGS: u32 = 12;

/// For every texel, a slope that no ascent exceeds from its centre to a place where a ray from the point above it at
/// height `top` leaves the relief; none is below `least`.
pub(super) fn slopes(
    ground: &Ground,
    mip: &MaximumMip,
    top: f64,
    least: f64,
    exec: &Exec,
) -> Result<Vec<f64>, BakeError> {
    let mut slopes: Vec<f64> = zeros("the slopes of a cone map", ground.grid.texels() as u64)?;
    let steepness = maximum_mip::pyramid(steepness(ground, exec)?, exec)?;
    let ascent = Ascent::new(mip, ground, 1.0);
    let bands = slopes.chunks_mut(ground.grid.width as usize).enumerate().collect();
    exec.for_each_with(bands, Vec::new, |squares: &mut Vec<Square>, (row, slopes): (usize, &mut [f64])| {
        for (column, slope) in slopes.iter_mut().enumerate() {
            let texel = [column as i64, row as i64];
            let height = ground.height(texel[0], texel[1]);
            let mut foot = Foot { ground, steepness: &steepness, texel, height, top, steepest: Steepest(least) };
            ascent.search(&mut foot, squares);
            *slope = foot.steepest.0;
        }
    });
    Ok(slopes)
}

/// The steepest gradient of every cell, rounded up; 0 of those beyond clamped edges, which are not looked at.
fn steepness(ground: &Ground, exec: &Exec) -> Result<MipLevel, BakeError> {
    let cells = ground.cells().map(i64::from);
    maximum_mip::fill(ground.grid.width, ground.grid.height, exec, |row, values| {
        for (column, value) in values.iter_mut().enumerate() {
            let cell = [column as i64, row];
            let there = cell[0] < cells[0] && cell[1] < cells[1];
            *value = if there { f32_at_least(ground.cell(cell, cell).steepest([0, 0])) } else { 0.0 };
        }
    })
}

/// A texel as the foot of ascents and of the axis that rays start from.
struct Foot<'a> {
    ground: &'a Ground<'a>,
    /// The steepest gradient of every square.
    steepness: &'a [MipLevel],
    texel: [i64; 2],
    height: f64,
    top: f64,
    steepest: Steepest,
}

impl Source for Foot<'_> {
    fn place(&self) -> [[i64; 2]; 2] {
        self.texel.map(|index| [index; 2])
    }

    fn height(&self) -> f64 {
        self.height
    }

    fn slope(&self) -> f64 {
        self.steepest.0
    }

    /// (u, v) · ∇D > D asks for a gradient of at least the depth over the distance.
    fn rules_out(&self, level: usize, index: [u32; 2], [u, v]: [f64; 2], highest: f64) -> bool {
        let steepest = f64::from(self.steepness[level].value(index[0], index[1]));
        steepest * (u * u + v * v).sqrt() <= self.top - highest
    }

    fn look_into(&mut self, cell: [i64; 2]) {
        let cell = self.ground.cell(cell, self.texel);
        let exits = Exits::new(&cell, self.top);
        self.raise(&cell, &exits, HALVINGS);
    }
}

impl Foot<'_> {
    /// Takes in the ascents to all exits through a patch.
    fn raise(&mut self, patch: &Patch, exits: &Exits, halvings: u32) {
        if !self.steepest.settle(self.bounds(patch, exits), halvings == 0) {
            patch.halves().iter().for_each(|half| self.raise(half, exits, halvings - 1));
        }
    }

    /// As [`Bounds::between`], where only the ascents to exits are there.
    fn bounds(&self, patch: &Patch, exits: &Exits) -> Bounds {
        let (foot, ahead) = ([0.0, 0.0, self.height], direction([0.0, 0.0], patch.centre()));
        let corners = patch.corners().map(|corner| (corner, exits.are_at(corner[0], corner[1])));
        // The product u v is greatest, and least, at corners: where none is an exit, no point is.
        if !corners.iter().any(|&(_, exit)| exit) {
            return Bounds::NONE;
        }
        let mut bounds = Bounds::NONE;
        for (corner, exit) in corners {
            bounds.add(foot, corner, ahead, exit);
        }
        if bounds.at_most == f64::INFINITY {
            // A patch that the texel is a corner of: no ascent inside it is steeper than the surface itself.
            bounds.at_most = patch.steepest([0, 0]);
        }
        bounds
    }
}

/// Where the rays that start at depth 0 above the common origin of places leave the relief through a cell.
///
/// In depths below the top the cell is D = a + b u + c v + t u v. A ray leaves the relief where D grows faster along it
/// than its own depth does: where (u, v) · ∇D > D, that is t u v > a. Along a level top at depth 0 no ray leaves; it leaves
/// at the far brink.
struct Exits {
    twist: f64,
    /// The depth of the cell's surface continued to the origin.
    depth_at_origin: f64,
}

impl Exits {
    fn new(cell: &Patch, top: f64) -> Self {
        let [[h00, h10], [h01, h11]] = cell.heights;
        let [side_u, side_v] = cell.sides();
        let (u, v) = (-cell.u[0] / side_u, -cell.v[0] / side_v);
        let twist = (h11 - h10) - (h01 - h00);
        let height_at_origin = h00 + (h10 - h00) * u + (h01 - h00) * v + twist * u * v;
        Self { twist: -twist / (side_u * side_v), depth_at_origin: top - height_at_origin }
    }

    fn are_at(&self, u: f64, v: f64) -> bool {
        self.twist * u * v > self.depth_at_origin
    }
}
