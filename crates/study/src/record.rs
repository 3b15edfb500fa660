//! The record: what every technique is measured by.

use barchan_field::Mesh;
use barchan_metrics::{ErrorStats, Percentiles};
use serde::{Deserialize, Serialize};

use crate::timer::{Spread, Timing};
use crate::{Scene, Setting};

/// One technique at one setting on one scene. What was not measured is `None`.
///
/// The order of the fields is the order of the columns in CSV; it only ever grows at the end.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Record {
    /// What was measured: `horizon`, `traced`, `memory`, …
    pub technique: String,
    /// How it was set.
    pub setting: Setting,
    /// On what.
    pub scene: String,
    /// Texels along u, or vertices of a mesh.
    pub width: u32,
    /// Texels along v, or triangles of a mesh.
    pub height: u32,
    /// What the error columns are errors of.
    pub quantity: Option<Quantity>,
    /// How many errors they summarise.
    pub samples: Option<u64>,
    /// The part of them that is wrong, 0 … 1, as [`Quantity`] defines it.
    pub wrong_share: Option<f64>,
    /// Root mean square error, in the quantity's unit, as are the next three.
    pub rms: Option<f64>,
    /// Mean signed error, found minus true.
    pub mean: Option<f64>,
    /// 99 % of the errors are no larger.
    pub p99: Option<f64>,
    /// The largest error.
    pub max: Option<f64>,
    /// What the time columns are times of.
    pub per: Option<Item>,
    /// Rounds timed.
    pub rounds: Option<u64>,
    /// Median processor time per item over all threads, in nanoseconds, as are the next five.
    pub cpu_ns: Option<f64>,
    /// The shortest.
    pub cpu_ns_min: Option<f64>,
    /// Median absolute deviation from the median.
    pub cpu_ns_spread: Option<f64>,
    /// Median time per item on the wall clock.
    pub wall_ns: Option<f64>,
    /// The shortest.
    pub wall_ns_min: Option<f64>,
    /// Median absolute deviation from the median.
    pub wall_ns_spread: Option<f64>,
    /// Texture samples that a shader would take per item.
    pub fetches: Option<u32>,
    /// Bytes of the table as stored.
    pub bytes: Option<u64>,
    /// Processor time of the bake, in seconds; the wall's where the system does not say.
    pub bake_seconds: Option<f64>,
    /// The least memory traffic the work needs, as a part of what the machine's memory was measured to carry, 0 … 1.
    pub bandwidth_share: Option<f64>,
    /// Mean fetches of the height map per item: of a texel, or of the four of a bilinear cell.
    pub height_fetches: Option<f64>,
    /// Mean fetches of other tables per item.
    pub table_fetches: Option<f64>,
    /// Median time per item by the GPU's own clock, in nanoseconds, as are the next two; nothing where it has none.
    pub gpu_ns: Option<f64>,
    /// The shortest.
    pub gpu_ns_min: Option<f64>,
    /// Median absolute deviation from the median.
    pub gpu_ns_spread: Option<f64>,
    /// The GPU, as it calls itself. A file may have the records of several:
    /// [`RecordFile::with_other_devices`](crate::RecordFile::with_other_devices).
    pub device: Option<String>,
    /// Whether it is software, and its time therefore the processor's.
    pub is_software: Option<bool>,
    /// The driver and the machine of the GPU, where the file's machine is only that of its last measurement.
    pub host: Option<String>,
}

/// What an error is an error of, its unit, and when it is wrong.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// Elevation of the horizon, degrees.
    ElevationDegrees,
    /// Distance to the horizon as a part of the true one; wrong where the point found is not as high as the horizon: see
    /// [`horizon_accuracy`](crate::horizon_accuracy).
    DistanceShare,
    /// Elevation of the horizon over a curved base, degrees; the wrong share is of a ball that is lit from one side: see
    /// [`curved_effect`](crate::curved_effect).
    CurvedElevationDegrees,
    /// Shadow at texel centres: wrong where it is not that of a traced ray. `max` is the wrong share under the worst light.
    ShadowAtCentres,
    /// Shadow anywhere between texel centres, likewise.
    ShadowBetweenCentres,
    /// The part of places that the sun reaches, 0 … 1: `mean`.
    LitShare,
    /// Curvature, relative to the RMS of the larger principal one, without sign, over the mesh or its places. Wrong as the study
    /// says.
    Curvature,
    /// A principal direction, degrees.
    DirectionDegrees,
    /// Depth of a ray's hit, as a part of the relief's thickness. Wrong where the true hit is passed by more than
    /// [`relief_rays::TOLERANCE`](crate::relief_rays::TOLERANCE).
    HitDepth,
    /// Depth at which a search starts, likewise; `mean` is of the depths themselves. Wrong where it is behind the true hit.
    StartDepth,
    /// Light of an even sky that relief keeps away, 0 … 1.
    Occlusion,
    /// Shadow on relief: wrong where it is not that of a traced ray.
    ReliefShadow,
}

/// What a time is divided by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Item {
    /// One texel in one direction.
    TexelDirection,
    /// One place under one light.
    ShadowTest,
    /// One place of a surface in a picture.
    Pixel,
    /// One vertex of a mesh.
    Vertex,
    /// One byte read or written.
    Byte,
    /// One file opened.
    File,
    /// One ray into a relief; of a bake, one texel of the height map in one direction.
    Ray,
}

/// Norms of errors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Norms {
    /// Count, RMS, mean, maximum.
    pub stats: ErrorStats,
    /// 99 % are no larger.
    pub p99: f64,
}

impl Norms {
    /// The norms of errors, found minus true.
    #[must_use]
    pub fn of(errors: &[f64]) -> Self {
        let stats = ErrorStats::of(errors.iter().copied());
        Self { stats, p99: Percentiles::of(errors.iter().copied()).p99 }
    }
}

impl Record {
    /// A record of a scene with nothing measured yet.
    #[must_use]
    pub fn new(technique: &str, setting: Setting, scene: &Scene) -> Self {
        let grid = scene.field.grid();
        Self {
            technique: technique.to_owned(),
            setting,
            scene: scene.name.clone(),
            width: grid.width,
            height: grid.height,
            ..Self::default()
        }
    }

    /// A record of a mesh with nothing measured yet.
    #[must_use]
    pub fn of_mesh(technique: &str, setting: Setting, name: &str, mesh: &Mesh) -> Self {
        Self {
            technique: technique.to_owned(),
            setting,
            scene: name.to_owned(),
            width: mesh.positions().len() as u32,
            height: mesh.triangles().len() as u32,
            ..Self::default()
        }
    }

    /// The record with errors.
    #[must_use]
    pub fn with_norms(mut self, quantity: Quantity, norms: &Norms) -> Self {
        self.quantity = Some(quantity);
        self.samples = Some(norms.stats.count());
        self.rms = Some(norms.stats.rms());
        self.mean = Some(norms.stats.mean());
        self.p99 = Some(norms.p99);
        self.max = Some(norms.stats.max());
        self
    }

    /// The record with the times of work on so many items.
    #[must_use]
    pub fn with_timing(mut self, timing: &Timing, per: Item, items: f64) -> Self {
        let per_item = |seconds: f64| Some(1e9 * seconds / items);
        // One round says nothing of how much to believe it.
        let spread = |deviation: f64| if timing.rounds > 1 { per_item(deviation) } else { None };
        self.per = Some(per);
        self.rounds = Some(timing.rounds as u64);
        if let Some(cpu) = timing.cpu {
            self.cpu_ns = per_item(cpu.median);
            self.cpu_ns_min = per_item(cpu.minimum);
            self.cpu_ns_spread = spread(cpu.deviation);
        }
        self.wall_ns = per_item(timing.wall.median);
        self.wall_ns_min = per_item(timing.wall.minimum);
        self.wall_ns_spread = spread(timing.wall.deviation);
        self
    }

    /// The record with the times of work on so many items by the GPU's own clock, if it has one.
    #[must_use]
    pub fn with_gpu_time(mut self, seconds: Option<Spread>, items: f64) -> Self {
        let per_item = |seconds: f64| 1e9 * seconds / items;
        self.gpu_ns = seconds.map(|spread| per_item(spread.median));
        self.gpu_ns_min = seconds.map(|spread| per_item(spread.minimum));
        self.gpu_ns_spread = seconds.map(|spread| per_item(spread.deviation));
        self
    }

    /// The time of one item on one core: processor time where the system says it, else the wall's.
    #[must_use]
    pub fn core_ns(&self) -> Option<f64> {
        self.cpu_ns.or(self.wall_ns)
    }

    /// The record with measured numbers to five digits: more would be noise, and would change in every line of a diff.
    #[must_use]
    pub fn rounded(mut self) -> Self {
        let numbers = [
            &mut self.wrong_share,
            &mut self.rms,
            &mut self.mean,
            &mut self.p99,
            &mut self.max,
            &mut self.cpu_ns,
            &mut self.cpu_ns_min,
            &mut self.cpu_ns_spread,
            &mut self.wall_ns,
            &mut self.wall_ns_min,
            &mut self.wall_ns_spread,
            &mut self.bake_seconds,
            &mut self.bandwidth_share,
            &mut self.height_fetches,
            &mut self.table_fetches,
            &mut self.gpu_ns,
            &mut self.gpu_ns_min,
            &mut self.gpu_ns_spread,
        ];
        for number in numbers.into_iter().flatten() {
            *number = five_digits(*number);
        }
        self
    }
}

fn five_digits(number: f64) -> f64 {
    // What a person would write down is what is kept, so that writing and reading it is exact.
    format!("{number:.4e}").parse().unwrap_or(number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_divided_by_the_items() {
        let wall = Spread { median: 3.0, minimum: 2.0, deviation: 0.5 };
        let timing = Timing { rounds: 4, wall, cpu: None };
        let record = Record::default().with_timing(&timing, Item::Byte, 1e9);
        assert_eq!((record.wall_ns, record.wall_ns_min, record.wall_ns_spread), (Some(3.0), Some(2.0), Some(0.5)));
        assert_eq!((record.cpu_ns, record.core_ns(), record.rounds), (None, Some(3.0), Some(4)));
        let once = Record::default().with_timing(&Timing { rounds: 1, ..timing }, Item::Byte, 1e9);
        assert_eq!((once.wall_ns, once.wall_ns_spread), (Some(3.0), None));
    }

    #[test]
    fn norms_are_those_of_the_errors() {
        let record = Record::default().with_norms(Quantity::ElevationDegrees, &Norms::of(&[3.0, -4.0, 0.0, 0.0]));
        assert_eq!((record.samples, record.rms, record.mean), (Some(4), Some(2.5), Some(-0.25)));
        assert_eq!((record.p99, record.max), (Some(4.0), Some(4.0)));
    }

    #[test]
    fn five_digits_are_kept() {
        assert_eq!([1.0 / 3.0, -12_345.678, 0.0, 1e-9].map(five_digits), [0.33333, -12_346.0, 0.0, 1e-9]);
        assert!(five_digits(f64::NAN).is_nan());
    }
}
