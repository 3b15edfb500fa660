//! The sums over azimuth, one direction at a time.

use barchan_field::{Grid, HeightField};
use fearless_simd::{Level, Simd, dispatch};

use super::ground::{BLOCK, Ground, Slopes};
use super::params::check_azimuths;
use super::slice::{Azimuth, Slices};
use super::{SkyMap, SkyParams};
use crate::horizon::Azimuths;
use crate::{BakeError, Exec};

/// Rows that one piece of work takes: enough that handing it out costs nothing.
const BAND_ROWS: usize = 16;

/// Takes the horizons of a field one direction at a time and keeps only sums: of a map of any number of directions no
/// more than one need be in memory, besides the 4, 12 and 16 bytes a texel of the tables asked for ([`SkyParams`]).
///
/// ```
/// use barchan_bakers::{Exec, horizon::Azimuths, sky::{SkyAccumulator, SkyParams}};
/// use barchan_field::{Edge, Grid, HeightField, LengthUnit, Spacing};
///
/// let grid = Grid { width: 2, height: 1, spacing: Spacing::UNIT, unit: LengthUnit::Metre, edge: Edge::Clamp };
/// let field = HeightField::new(grid, vec![0.0; 2]).unwrap();
/// let exec = Exec::new(1).unwrap();
/// let params = SkyParams { visibility: true, ..SkyParams::default() };
/// let mut sky = SkyAccumulator::new(&field, &Azimuths::full_circle(8), params).unwrap();
/// for direction in 0..8 {
///     // The left texel sees all of the sky; around the right one all is 30° high.
///     sky.add(direction, &[0.0, 30_f32.to_radians()], &exec);
/// }
/// let visibility = sky.finish(&exec).unwrap().visibility.unwrap();
/// assert_eq!(visibility[0], 1.0);
/// assert!((visibility[1] - 0.75).abs() < 1e-6);
/// ```
pub struct SkyAccumulator<'a> {
    ground: Ground<'a>,
    grid: Grid,
    azimuths: Azimuths,
    params: SkyParams,
    next_direction: u32,
    level: Level,
    /// `[row][block][plane][column]`, the planes of [`Planes`]: a band of rows is one piece of memory, and what a
    /// kernel writes is one stream. With whole rows as planes, a width of 1024 puts them 4096 bytes apart, which
    /// halves the speed.
    sums: Vec<f32>,
}

impl<'a> SkyAccumulator<'a> {
    /// An empty sky over a field. Its heights are read again with every direction, for the normals, and never copied.
    ///
    /// # Errors
    ///
    /// [`BakeError::Parameter`] where the azimuths are an arc or fewer than
    /// [`MIN_SKY_DIRECTIONS`](super::MIN_SKY_DIRECTIONS); [`BakeError::Memory`] where the system refuses the sums.
    pub fn new(field: &'a HeightField, azimuths: &Azimuths, params: SkyParams) -> Result<Self, BakeError> {
        check_azimuths(azimuths)?;
        let grid = *field.grid();
        let sums = zeros(grid.texels(), params.planes())?;
        Ok(Self {
            ground: Ground::new(field),
            grid,
            azimuths: *azimuths,
            params,
            next_direction: 0,
            level: Level::new(),
            sums,
        })
    }

    /// Adds the slices of one direction: horizon elevations in radians above the horizontal, row by row from the top of
    /// the picture. What lies below the horizontal, or is not a number, counts as level.
    ///
    /// The sums do not depend on the threads of `exec`: a texel's are its own, and directions come in order.
    ///
    /// # Panics
    ///
    /// Where a direction is left out, repeated or out of order, or the elevations are not one to a texel.
    pub fn add(&mut self, direction: u32, elevation_radians: &[f32], exec: &Exec) {
        assert!(direction < self.azimuths.count(), "there are {} directions, not {direction}", self.azimuths.count());
        assert_eq!(direction, self.next_direction, "directions are added once each, in order");
        assert_eq!(elevation_radians.len(), self.grid.texels(), "one elevation to a texel");
        self.next_direction += 1;
        if self.sums.is_empty() {
            return;
        }
        let (cos, sin) = self.azimuths.vector(direction);
        let step =
            Step { ground: self.ground, params: self.params, azimuth: Azimuth { cos: cos as f32, sin: sin as f32 } };
        let (width, level) = (step.ground.width(), self.level);
        let sums = self.sums.chunks_mut(BAND_ROWS * width * self.params.planes());
        let bands: Vec<_> = sums.zip(elevation_radians.chunks(BAND_ROWS * width)).collect();
        exec.for_each_quietly(bands, |band, (sums, elevations)| {
            dispatch!(level, simd => step.add_band(simd, band * BAND_ROWS, sums, elevations));
        });
    }

    /// The tables, once every direction has been added.
    ///
    /// # Errors
    ///
    /// [`BakeError::Memory`] where the system refuses them: they and the sums are held together for a moment.
    ///
    /// # Panics
    ///
    /// Where a direction is missing.
    pub fn finish(self, exec: &Exec) -> Result<SkyMap, BakeError> {
        assert_eq!(self.next_direction, self.azimuths.count(), "a direction is missing");
        SkyMap::of_sums(self.ground, self.grid, self.azimuths, self.params, &self.sums, exec)
    }
}

/// Memory that the system refuses is an error of the bake, not the end of the program.
pub(super) fn zeros(texels: usize, values_per_texel: usize) -> Result<Vec<f32>, BakeError> {
    let refused = || BakeError::Memory { what: "the sky", bytes: 4 * texels as u64 * values_per_texel as u64 };
    let values = texels.checked_mul(values_per_texel).ok_or_else(refused)?;
    let mut zeros = Vec::new();
    zeros.try_reserve_exact(values).map_err(|_| refused())?;
    zeros.resize(values, 0.0);
    Ok(zeros)
}

/// The sums of a block, by table.
pub(super) struct Planes<T> {
    pub(super) visibility: Option<T>,
    /// Along u, along v, upwards.
    pub(super) bent_normal: Option<[T; 3]>,
    /// Along u, along v, upwards; and of the sine.
    pub(super) cone: Option<[T; 4]>,
}

impl<T> Planes<T> {
    /// Tells the planes of a block apart, which come one after the other.
    #[inline(always)]
    pub(super) fn new(params: SkyParams, mut planes: impl Iterator<Item = T>) -> Self {
        let mut next = || planes.next().expect("as many planes as were asked for");
        Self {
            visibility: params.visibility.then(&mut next),
            bent_normal: params.bent_normal.then(|| [next(), next(), next()]),
            cone: params.aperture_cone.then(|| [next(), next(), next(), next()]),
        }
    }
}

/// What adding one direction needs to know.
#[derive(Clone, Copy)]
struct Step<'a> {
    ground: Ground<'a>,
    params: SkyParams,
    azimuth: Azimuth,
}

impl Step<'_> {
    #[inline(always)]
    fn add_band<S: Simd>(&self, simd: S, first_row: usize, sums: &mut [f32], elevation_radians: &[f32]) {
        simd.vectorize(
            #[inline(always)]
            || {
                let (mut slopes, mut slices) = (Slopes::LEVEL, Slices::EMPTY);
                let width = self.ground.width();
                let rows =
                    sums.chunks_exact_mut(width * self.params.planes()).zip(elevation_radians.chunks_exact(width));
                for (row, (sums, elevations)) in rows.enumerate() {
                    let blocks = sums.chunks_mut(BLOCK * self.params.planes()).zip(elevations.chunks(BLOCK));
                    for (block, (sums, elevations)) in blocks.enumerate() {
                        let (start, len) = (block * BLOCK, elevations.len());
                        self.ground.slopes(first_row + row, start..start + len, &mut slopes);
                        slices.cut(elevations, &slopes, self.azimuth);
                        self.add_block(&slices, Planes::new(self.params, sums.chunks_exact_mut(len)));
                    }
                }
            },
        );
    }

    #[inline(always)]
    fn add_block(&self, slices: &Slices, sums: Planes<&mut [f32]>) {
        if let Some(sum) = sums.visibility {
            slices.add_visibility(sum);
        }
        if let Some(sums) = sums.bent_normal {
            slices.add_bent_normal(self.azimuth, sums);
        }
        if let Some(sums) = sums.cone {
            slices.add_cone(self.azimuth, sums);
        }
    }
}

#[cfg(test)]
mod tests {
    use barchan_field::{Edge, LengthUnit, Spacing};

    use super::*;

    /// Enough columns for a whole block and a part of one.
    const WIDTH: u32 = BLOCK as u32 + 37;

    fn sums_at(level: Level) -> Vec<u32> {
        let grid =
            Grid { width: WIDTH, height: 5, spacing: Spacing::UNIT, unit: LengthUnit::SceneUnit, edge: Edge::Wrap };
        let noise = |seed: usize| (0..grid.texels()).map(move |i| ((i * 7919 + seed * 104_729) % 1009) as f32 / 700.0);
        let field = HeightField::new(grid, noise(1).collect()).unwrap();
        let mut sky = SkyAccumulator::new(&field, &Azimuths::full_circle(5), SkyParams::ALL).unwrap();
        sky.level = level;
        let exec = Exec::new(1).unwrap();
        for direction in 0..5 {
            let elevations: Vec<f32> = noise(direction as usize).map(|noise| 1.4 * noise - 0.6).collect();
            sky.add(direction, &elevations, &exec);
        }
        sky.sums.iter().map(|sum| sum.to_bits()).collect()
    }

    #[test]
    fn every_simd_level_adds_the_same_bits() {
        assert!(sums_at(Level::new()) == sums_at(Level::baseline()));
    }
}
