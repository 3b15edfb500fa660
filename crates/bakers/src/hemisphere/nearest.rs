//! The paper's mode: the ray of every source texel is followed to its first hit, and a texel of the table has the least of its own.
//!
//! Sixteen neighbours along a row go together. Inside a cell the surface's depth below the ray is a parabola, as in the
//! [reference](mod@super::reference), and its first root is the hit; a lane that has hit waits for the others.

use std::ops::Range;

use fearless_simd::{Level, Simd, dispatch, f32x16, mask32x16, prelude::*};

use super::HemisphereParams;
use super::depths::Depths;
use super::path::{Cell, Path};
use super::ray::DepthRay;
use super::reduce::{footprint, lower_row};
use super::windows::{LANES, Windows};
use crate::BakeError;

/// What the nearest mode keeps of a field.
pub(super) struct NearestBaker {
    params: HemisphereParams,
    depths: Depths,
    windows: Windows,
}

impl NearestBaker {
    pub(super) fn new(depths: Depths, params: &HemisphereParams) -> Result<Self, BakeError> {
        let windows = Windows::new(&depths)?;
        Ok(Self { params: *params, depths, windows })
    }

    /// The depth of the first hit of every ray that enters at a texel of a row.
    fn source_row(&self, path: &Path, row: usize, hits: &mut [f32]) {
        if path.is_vertical {
            hits.copy_from_slice(&self.depths.values[row * hits.len()..][..hits.len()]);
        } else {
            dispatch!(Level::new(), simd => self.march_row(simd, path, row, hits));
        }
    }

    #[inline(always)]
    fn march_row<S: Simd>(&self, simd: S, path: &Path, row: usize, hits: &mut [f32]) {
        for (block, hits) in hits.chunks_mut(LANES).enumerate() {
            let found = self.march(simd, path, (block * LANES, row), hits.len());
            hits.copy_from_slice(&found[..hits.len()]);
        }
    }

    /// Follows the rays of `count` texels, the first of which is given.
    #[inline(always)]
    fn march<S: Simd>(&self, simd: S, path: &Path, texel: (usize, usize), count: usize) -> [f32; LANES] {
        let windows = &self.windows;
        let mut waiting = mask32x16::from_bitmask(simd, (1 << count) - 1);
        let mut depths = f32x16::splat(simd, path.deepest);
        let mut index = 0;
        while let Some(step) = path.steps.get(index) {
            let least = windows.load(simd, windows.place(texel, step.window));
            let near = waiting & least.simd_le(f32x16::splat(simd, step.end));
            if near.all_false() {
                index = step.next;
                continue;
            }
            if let Some(cell) = &step.cell {
                let corners = windows.corners(simd, windows.place(texel, cell.corner));
                let (hits, found) = cell.first_hit(simd, corners);
                let hits = hits & waiting;
                depths = hits.select(found, depths);
                waiting &= !hits;
                if waiting.all_false() {
                    break;
                }
            }
            index += 1;
        }
        depths.into()
    }
}

/// Fills some rows of the table in one layer: `values` are `rows.len()` rows of the target's width.
pub(super) fn bake_rows(baker: &NearestBaker, layer: u32, rows: Range<u32>, values: &mut [f32]) {
    let NearestBaker { params, depths, windows } = baker;
    let ray = DepthRay::of_layer(&params.directions, layer, depths.relief, depths.grid.spacing);
    let path = Path::new(ray, windows);
    let mut hits = vec![0.0; depths.grid.width as usize];
    values.fill(1.0);
    for (row, values) in rows.zip(values.chunks_exact_mut(params.width as usize)) {
        for source_row in footprint(row, params.height, depths.grid.height) {
            baker.source_row(&path, source_row as usize, &mut hits);
            lower_row(values, &hits);
        }
    }
}

impl Cell {
    /// Which of sixteen rays meet the surface on their way through the cell, and at what depth.
    #[inline(always)]
    fn first_hit<S: Simd>(&self, simd: S, [[d00, d10], [d01, d11]]: [[f32x16<S>; 2]; 2]) -> (mask32x16<S>, f32x16<S>) {
        let (right, down) = (d10 - d00, d01 - d00);
        let twist = (d11 - d01) - right;
        let below_ray = |(x, y): (f32, f32), depth: f32| d00 + right * x + (down + twist * x) * y - depth;
        // g(s) = constant + linear s + square s², s from 0 to 1.
        let constant = below_ray(self.enters, self.start);
        let end = below_ray(self.leaves, self.start + self.depth);
        let square = twist * self.bend;
        let linear = end - constant - square;
        let zero = f32x16::splat(simd, 0.0);
        let discriminant = linear * linear - square * constant * 4.0;
        // It dips below 0 and comes back: the least of a parabola that opens upwards lies within.
        let dips = discriminant.simd_ge(zero) & linear.simd_lt(zero) & (square * -2.0).simd_lt(linear);
        let hits = constant.simd_le(zero) | end.simd_le(zero) | dips;
        let root = constant * 2.0 / (discriminant.max(zero).sqrt() - linear);
        let part = constant.simd_gt(zero).select(root.min(f32x16::splat(simd, 1.0)), zero);
        (hits, part * self.depth + self.start)
    }
}
