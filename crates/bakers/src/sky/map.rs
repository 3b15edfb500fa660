//! The typed tables a sky bake returns, before any encoding.

use barchan_field::Grid;

use super::SkyParams;
use super::accumulator::{Planes, zeros};
use super::ground::{BLOCK, Ground, Slopes, normal};
use crate::horizon::Azimuths;
use crate::{BakeError, Exec};

/// A component smaller than this is rounding of the sums and taken for 0: level ground has its bent normal straight up.
const LEAST_COMPONENT: f64 = 1e-6;

/// Rows turned into tables as one piece of work.
const BAND_ROWS: usize = 16;

/// The sky of every texel: the tables asked for, each row by row from the top of the picture.
#[derive(Debug, Clone, PartialEq)]
pub struct SkyMap {
    /// The grid of the field it was baked from.
    pub grid: Grid,
    /// The azimuths it was summed over.
    pub azimuths: Azimuths,
    /// What was asked for.
    pub params: SkyParams,
    /// One number a texel, 0 (nothing of the sky is seen) to 1 (all that a level texel in the open sees).
    pub visibility: Option<Vec<f32>>,
    /// Two numbers a texel: u and v of a unit vector whose height √(1 − u² − v²) is not negative.
    pub bent_normal: Option<Vec<f32>>,
    /// Four numbers a texel: u, v and height ≥ 0 of the unit axis, and the cosine of the half-angle, 0 (a hemisphere)
    /// to 1 (nothing).
    pub aperture_cone: Option<Vec<f32>>,
}

impl SkyMap {
    pub(super) fn of_sums(
        ground: Ground,
        grid: Grid,
        azimuths: Azimuths,
        params: SkyParams,
        sums: &[f32],
        exec: &Exec,
    ) -> Result<Self, BakeError> {
        let table = |asked: bool, values| asked.then(|| zeros(grid.texels(), values)).transpose();
        let mut map = Self {
            grid,
            azimuths,
            params,
            visibility: table(params.visibility, 1)?,
            bent_normal: table(params.bent_normal, 2)?,
            aperture_cone: table(params.aperture_cone, 4)?,
        };
        if params.planes() > 0 {
            let finisher = Finisher { ground, params, weight: 1.0 / f64::from(azimuths.count()) };
            let bands = map.split_bands(sums);
            exec.for_each_quietly(bands, |band, (sums, tables)| finisher.finish_band(band * BAND_ROWS, sums, tables));
        }
        Ok(map)
    }

    fn split_bands<'a>(&'a mut self, sums: &'a [f32]) -> Vec<(&'a [f32], Tables<'a>)> {
        let texels = BAND_ROWS * self.grid.width as usize;
        let mut visibility = self.visibility.as_mut().map(|all| all.chunks_mut(texels));
        let mut bent_normal = self.bent_normal.as_mut().map(|all| all.chunks_mut(2 * texels));
        let mut aperture_cone = self.aperture_cone.as_mut().map(|all| all.chunks_mut(4 * texels));
        sums.chunks(texels * self.params.planes())
            .map(|sums| {
                let tables = Tables {
                    visibility: visibility.as_mut().and_then(Iterator::next),
                    bent_normal: bent_normal.as_mut().and_then(Iterator::next),
                    aperture_cone: aperture_cone.as_mut().and_then(Iterator::next),
                };
                (sums, tables)
            })
            .collect()
    }
}

/// A band of rows of each table asked for.
struct Tables<'a> {
    visibility: Option<&'a mut [f32]>,
    bent_normal: Option<&'a mut [f32]>,
    aperture_cone: Option<&'a mut [f32]>,
}

/// Turns sums into tables, texel by texel in f64.
struct Finisher<'a> {
    ground: Ground<'a>,
    params: SkyParams,
    /// Of each direction: one over their number.
    weight: f64,
}

impl Finisher<'_> {
    fn finish_band(&self, first_row: usize, sums: &[f32], mut tables: Tables) {
        let width = self.ground.width();
        let mut slopes = Slopes::LEVEL;
        for (row, sums) in sums.chunks_exact(width * self.params.planes()).enumerate() {
            for (block, sums) in sums.chunks(BLOCK * self.params.planes()).enumerate() {
                let (start, len) = (block * BLOCK, sums.len() / self.params.planes());
                self.ground.slopes(first_row + row, start..start + len, &mut slopes);
                let planes = Planes::new(self.params, sums.chunks_exact(len));
                for i in 0..len {
                    let normal = normal(f64::from(slopes.u[i]), f64::from(slopes.v[i]));
                    self.finish_texel(&planes, i, normal, row * width + start + i, &mut tables);
                }
            }
        }
    }

    fn finish_texel(&self, sums: &Planes<&[f32]>, index: usize, normal: [f64; 3], texel: usize, tables: &mut Tables) {
        let sum = |plane: &[f32]| f64::from(plane[index]);
        if let (Some(plane), Some(table)) = (sums.visibility, &mut tables.visibility) {
            table[texel] = (normal[2] * self.weight * sum(plane)).clamp(0.0, 1.0) as f32;
        }
        if let (Some(planes), Some(table)) = (sums.bent_normal, &mut tables.bent_normal) {
            let [u, v, _] = direction(planes.map(sum)).unwrap_or(normal);
            table[2 * texel..][..2].copy_from_slice(&[u as f32, v as f32]);
        }
        if let (Some([u, v, up, sine]), Some(table)) = (sums.cone, &mut tables.aperture_cone) {
            let (axis, cos_half_angle) = match direction([u, v, up].map(sum)) {
                Some(axis) => (axis, (self.weight * sum(sine)).clamp(0.0, 1.0)),
                None => (normal, 1.0),
            };
            let [u, v, up] = axis;
            table[4 * texel..][..4].copy_from_slice(&[u, v, up, cos_half_angle].map(|value| value as f32));
        }
    }
}

/// The unit vector along a sum of directions of the sky, none of which points down; none where there was no sky.
fn direction([u, v, up]: [f64; 3]) -> Option<[f64; 3]> {
    // Rounding may have left less than nothing of a sky that is a sliver above the horizontal.
    let up = up.max(0.0);
    let length = (u * u + v * v + up * up).sqrt();
    let level = |component: f64| if component.abs() < LEAST_COMPONENT { 0.0 } else { component };
    (length > 0.0).then(|| [level(u / length), level(v / length), up / length])
}
