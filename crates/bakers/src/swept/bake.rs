//! Field to stored points, one direction at a time: every bend is swept, then each texel chooses.

use barchan_field::HeightField;

use super::accuracy::SelectionErrors;
use super::layers::{CandidateLayer, PointLayerMut, measure_band, select_band};
use super::nodes::Nodes;
use super::params::{Points, SweptParams, Tie};
use crate::horizon::{BentLayer, HorizonParams, bake_bent};
use crate::{BakeError, Exec};

/// Texels of a band that one thread chooses for: some milliseconds.
const BAND_TEXELS: usize = 1 << 14;

/// Directions that are looked at to decide how many points are kept.
const SAMPLED_DIRECTIONS: u32 = 4;

/// About how many texels of each are looked at.
const SAMPLED_TEXELS: usize = 1 << 17;

/// The slope by which the nearest of equal points stands above one at the search radius: 0.006°, some hundred times
/// what f32 rounds off a slope of 1.
const TIE_SLOPE: f64 = 1e-4;

/// A baker of curvature-swept horizons of one field. It keeps what one direction needs, 8 bytes per texel and bend.
///
/// # The first layer
///
/// It is the flat horizon, with ties as [`CurvatureRange::tie`](super::CurvatureRange::tie) has them. Where that is
/// [`Tie::Farthest`] it is the horizon map itself. Where it is [`Tie::Nearest`] the relief is bent by
/// [`SweptBaker::flat_bend`], too little to lose 0.006° and enough to prefer the nearest of equal points: a file with
/// swept layers stores *this* layer as its horizon and distance, in the place of the map's.
pub struct SweptBaker<'a> {
    field: &'a HeightField,
    horizon: HorizonParams,
    nodes: Nodes,
    points: usize,
    flat_bend: f64,
    /// One layer per bend, of the direction baked last.
    candidates: Vec<BentLayer>,
}

impl<'a> SweptBaker<'a> {
    /// Checks the parameters and decides how many points are kept; for an error asked for, by baking a few directions.
    pub fn new(
        field: &'a HeightField,
        horizon: &HorizonParams,
        params: &SweptParams,
        exec: &Exec,
    ) -> Result<Self, BakeError> {
        horizon.check(field)?;
        params.check(field.grid(), horizon.radius)?;
        let nodes = match params.points {
            // The flat horizon alone is always kept: no bend could be chosen.
            Points::Count(1) => Nodes::new(&params.range, horizon.radius, 1),
            _ => Nodes::recommended(&params.range, horizon.radius),
        };
        let flat_bend = match params.range.tie() {
            Tie::Nearest => tie_bend(field, horizon.radius),
            Tie::Farthest => 0.0,
        };
        let candidates = nodes.bends().iter().map(|_| BentLayer::new(field)).collect::<Result<_, _>>()?;
        let mut baker = Self { field, horizon: *horizon, nodes, points: 1, flat_bend, candidates };
        baker.points = match params.points {
            Points::Count(count) => count as usize,
            Points::MaxErrorDegrees(degrees) => baker.selection_errors(exec)?.points_for(degrees),
        };
        Ok(baker)
    }

    /// How many points each texel has in each direction: the layers of [`SweptBaker::bake_direction`].
    #[must_use]
    pub fn points(&self) -> usize {
        self.points
    }

    /// The bends that are swept.
    #[must_use]
    pub fn nodes(&self) -> &Nodes {
        &self.nodes
    }

    /// The bend that stands for the flat horizon: 0, or so little that it only decides between equal points.
    #[must_use]
    pub fn flat_bend(&self) -> f64 {
        self.flat_bend
    }

    /// What each number of points would lose of what the bends find, over a few directions and rows: the same for any
    /// number of threads.
    pub fn selection_errors(&mut self, exec: &Exec) -> Result<SelectionErrors, BakeError> {
        let mut errors = SelectionErrors::default();
        for direction in sampled_directions(self.horizon.directions()) {
            self.sweep(direction, exec)?;
            self.measure(&mut errors);
        }
        Ok(errors)
    }

    /// Fills one layer per point, the flat horizon first, for one direction: the same bytes for any number of threads.
    ///
    /// # Panics
    /// If there are not as many layers as [`SweptBaker::points`], or they were made for another field.
    pub fn bake_direction(&mut self, direction: u32, exec: &Exec, layers: &mut [BentLayer]) -> Result<(), BakeError> {
        assert_eq!(layers.len(), self.points, "one layer per point");
        self.sweep(direction, exec)?;
        exec.for_each_quietly(self.bands(layers), |_, mut band| {
            select_band(&self.nodes, band.heights, &band.candidates, &mut band.points);
        });
        Ok(())
    }

    /// What every bend of [`SweptBaker::nodes`] found in the direction baked last, the flat one first.
    #[must_use]
    pub fn candidates(&self) -> &[BentLayer] {
        &self.candidates
    }

    fn sweep(&mut self, direction: u32, exec: &Exec) -> Result<(), BakeError> {
        for (index, (&bend, layer)) in self.nodes.bends().iter().zip(&mut self.candidates).enumerate() {
            let bend = if index == 0 { self.flat_bend } else { bend };
            bake_bent(self.field, &self.horizon, direction, bend, exec, layer)?;
        }
        Ok(())
    }

    fn measure(&self, errors: &mut SelectionErrors) {
        let (width, rows) = (self.field.grid().width as usize, self.field.grid().height as usize);
        // An odd step meets every row of a pattern that repeats after a power of two.
        let step = (width * rows).div_ceil(SAMPLED_TEXELS) | 1;
        for row in (0..rows).step_by(step) {
            let texels = row * width..(row + 1) * width;
            let candidates: Vec<_> = self.candidates.iter().map(|layer| view(layer, texels.clone())).collect();
            measure_band(&self.nodes, &self.field.samples()[texels], &candidates, errors);
        }
    }

    fn bands<'b>(&'b self, layers: &'b mut [BentLayer]) -> Vec<Band<'b>> {
        let heights = self.field.samples();
        let mut places: Vec<_> = layers
            .iter_mut()
            .map(|layer| layer.slope.chunks_mut(BAND_TEXELS).zip(layer.distance.chunks_mut(BAND_TEXELS)))
            .collect();
        let band = |(index, heights): (usize, &'b [f32])| {
            let start = index * BAND_TEXELS;
            let texels = start..start + heights.len();
            let point = |(slope, distance)| PointLayerMut { slope, distance };
            Band {
                heights,
                candidates: self.candidates.iter().map(|layer| view(layer, texels.clone())).collect(),
                points: places.iter_mut().filter_map(Iterator::next).map(point).collect(),
            }
        };
        heights.chunks(BAND_TEXELS).enumerate().map(band).collect()
    }
}

/// Texels that one thread chooses for.
struct Band<'a> {
    heights: &'a [f32],
    candidates: Vec<CandidateLayer<'a>>,
    points: Vec<PointLayerMut<'a>>,
}

fn view(layer: &BentLayer, texels: std::ops::Range<usize>) -> CandidateLayer<'_> {
    CandidateLayer { slope: &layer.slope[texels.clone()], distance: &layer.distance[texels] }
}

/// A few azimuths spread over all: of 16, the 1st, 6th, 11th and 16th, so along axes, diagonals and neither.
fn sampled_directions(directions: u32) -> Vec<u32> {
    let mut sampled: Vec<u32> = (0..SAMPLED_DIRECTIONS).map(|index| 5 * index * directions / 16).collect();
    sampled.dedup();
    sampled
}

/// A bend that costs at most [`TIE_SLOPE`] within the radius, and less where all slopes are small: f32 rounds less of
/// them.
fn tie_bend(field: &HeightField, radius: f64) -> f64 {
    let (lowest, highest) = field.range();
    let spacing = field.grid().spacing;
    let steepest = (f64::from(highest) - f64::from(lowest)) / spacing.u().min(spacing.v());
    TIE_SLOPE * steepest.clamp(1e-6, 1.0) / radius
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_few_directions_stand_for_all() {
        assert_eq!(sampled_directions(16), [0, 5, 10, 15]);
        assert_eq!(sampled_directions(32), [0, 10, 20, 30]);
        assert_eq!([1, 2, 3].map(sampled_directions), [vec![0], vec![0, 1], vec![0, 1, 2]]);
        assert!(sampled_directions(2048).iter().all(|&direction| direction < 2048));
    }
}
