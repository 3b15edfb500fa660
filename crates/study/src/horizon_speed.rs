//! How fast horizon maps are baked: method × field × size × azimuths × threads; and what else is baked like them.
//!
//! # What is counted
//!
//! One item is one texel in one direction. Its time is processor time, summed over threads, so that a rate is a rate *per
//! core*; the wall clock's stands beside it and says what more threads gain. The least a baker can do is to read a height
//! (4 bytes) and to write an elevation (4 more) and, where asked for, a distance (4 more): that traffic over the time
//! taken, as a part of the measured [`Bandwidth`], says how far from the memory's bound the bake is.
//!
//! # What is compared
//!
//! Cases of one [`Heat`] take turns, so they may be compared: each heat varies one thing and holds everything else. Most
//! run the azimuths of one [`quarter`] turn, a fourth of the work: by symmetry each quarter has the same mix of tilts.
//!
//! One heat, of the default method, varies the work: a map, one sweep of bent relief, points for a range of curvatures
//! (5 sweeps and the choice of 2 points, counted as one item), and the sky gathered from a map baked before.
//!
//! [`Bandwidth`]: crate::bandwidth::Bandwidth

use std::any::Any;

use barchan_bakers::Exec;
use barchan_bakers::horizon::{
    self, Azimuths, BentLayer, HorizonLayer, HorizonParams, Method, bake_bent, bake_direction,
};
use barchan_bakers::sky::{SkyAccumulator, SkyParams};
use barchan_bakers::swept::{CurvatureRange, Points, SweptBaker, SweptParams};

use crate::bandwidth::Bandwidth;
use crate::runner::Observer;
use crate::timer::{Contestant, Pace, Timing, race};
use crate::{Item, Record, Scale, Scene, Setting, StudyError, scenes};

/// The terrain that everything but the field is varied on.
pub const TERRAIN: &str = "fractal_terrain";

/// Terrain, and the fields on which a baker may get stuck.
const FIELDS: [&str; 6] = [TERRAIN, "dunes", "white_noise", "steep_noise", "spike", "constant"];

/// The range of curvatures that points are baked for, per length unit, and how many points.
const SWEPT: SweptParams = SweptParams { range: CurvatureRange { min: 0.0, max: 0.015 }, points: Points::Count(2) };

/// How far curved bases are searched: within half round the tightest, as relief on them is.
const SWEPT_RADIUS: f64 = 200.0;

/// What is baked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Work {
    /// A horizon map.
    Map,
    /// The points of one bend.
    Bent,
    /// The points kept for a range of curvatures.
    Swept,
    /// The sky, its horizons baked before.
    Sky,
}

impl Work {
    const ALL: [Self; 4] = [Self::Map, Self::Bent, Self::Swept, Self::Sky];

    fn name(self) -> &'static str {
        match self {
            Self::Map => "map",
            Self::Bent => "bent",
            Self::Swept => "swept",
            Self::Sky => "sky",
        }
    }
}

/// One bake to be timed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Case {
    /// A name that [`scenes::by_name`] knows.
    pub scene: &'static str,
    /// Texels along a side.
    pub size: u32,
    /// What.
    pub work: Work,
    /// How exactly.
    pub method: Method,
    /// Which azimuths.
    pub azimuths: Azimuths,
    /// Whether distances are kept.
    pub distance: bool,
    /// Worker threads.
    pub threads: usize,
}

/// Cases that take turns.
#[derive(Debug, Clone, PartialEq)]
pub struct Heat {
    /// What is varied: `field`, `size`, `directions`, `distance`, `threads` or `work`.
    pub varied: &'static str,
    /// How long.
    pub pace: Pace,
    /// The cases.
    pub cases: Vec<Case>,
}

/// A quarter of `directions` azimuths, which must be a multiple of 8: the first after 0° to 90°.
#[must_use]
pub fn quarter(directions: u32) -> Azimuths {
    Azimuths::Arc { first_degrees: 360.0 / f64::from(directions), last_degrees: 90.0, count: directions / 4 }
}

/// Every heat, method by method. `threads` is the most to use.
#[must_use]
pub fn heats(scale: Scale, threads: usize) -> Vec<Heat> {
    Method::ALL.into_iter().flat_map(|method| Sizes::of(method, scale).heats(method, scale, threads)).collect()
}

/// What a method is tried at: an exact one at less, in the time there is.
struct Sizes {
    usual: u32,
    varied: &'static [u32],
    directions_at: u32,
    threads_at: (u32, Azimuths),
}

impl Sizes {
    fn of(method: Method, scale: Scale) -> Self {
        let full = Azimuths::full_circle;
        match (scale, method) {
            (Scale::Full, Method::Exact) => {
                Self { usual: 512, varied: &[256, 512, 1024], directions_at: 256, threads_at: (1024, quarter(32)) }
            }
            (Scale::Full, _) => {
                Self { usual: 2048, varied: &[512, 1024, 2048, 4096], directions_at: 512, threads_at: (2048, full(32)) }
            }
            (Scale::Quick, _) => {
                Self { usual: 64, varied: &[32, 64, 128], directions_at: 32, threads_at: (64, full(32)) }
            }
        }
    }

    fn heats(&self, method: Method, scale: Scale, threads: usize) -> Vec<Heat> {
        let pace = match scale {
            Scale::Full => Pace { seconds: 6.0, max_rounds: 7 },
            Scale::Quick => Pace { seconds: 0.2, max_rounds: 3 },
        };
        let heat = |varied, cases| Heat { varied, pace, cases };
        let usual = Case {
            scene: TERRAIN,
            size: self.usual,
            work: Work::Map,
            method,
            azimuths: quarter(32),
            distance: false,
            threads: 1,
        };
        let (size, azimuths) = self.threads_at;
        let mut heats = vec![
            heat("field", FIELDS.map(|scene| Case { scene, ..usual }).to_vec()),
            heat("size", self.varied.iter().map(|&size| Case { size, ..usual }).collect()),
            heat(
                "directions",
                [8, 16, 32, 64]
                    .map(|count| Case { size: self.directions_at, azimuths: Azimuths::full_circle(count), ..usual })
                    .to_vec(),
            ),
            heat("distance", [false, true].map(|distance| Case { distance, ..usual }).to_vec()),
            heat("threads", thread_counts(threads).map(|threads| Case { size, azimuths, threads, ..usual }).collect()),
        ];
        if method == Method::default() {
            let usual = Case { size: self.directions_at, azimuths: Azimuths::full_circle(16), distance: true, ..usual };
            heats.push(heat("work", Work::ALL.map(|work| Case { work, ..usual }).to_vec()));
        }
        heats
    }
}

/// 1, 2, 4 … and the most.
fn thread_counts(most: usize) -> impl Iterator<Item = usize> {
    let most = most.max(1);
    std::iter::successors(Some(1), |count| Some(2 * count)).take_while(move |&count| count < most).chain([most])
}

impl Case {
    /// Texels × directions of one bake.
    #[must_use]
    pub fn items(&self) -> f64 {
        f64::from(self.size) * f64::from(self.size) * f64::from(self.azimuths.count())
    }

    /// The least traffic per texel and direction: a height read, an elevation written, a distance written if asked for;
    /// both of each point; of the sky an elevation read.
    #[must_use]
    pub fn bytes_moved(&self) -> f64 {
        match self.work {
            Work::Map if !self.distance => 8.0,
            Work::Map | Work::Bent => 12.0,
            Work::Swept => 20.0,
            Work::Sky => 4.0,
        }
    }

    /// What was set, as records say it.
    #[must_use]
    pub fn setting(&self) -> Setting {
        let circle = match self.azimuths {
            Azimuths::FullCircle { .. } => "circle",
            Azimuths::Arc { .. } => "quarter",
        };
        Setting::default()
            .with("work", self.work.name())
            .with("method", self.method.name())
            .with("directions", self.azimuths.count())
            .with("of", circle)
            .with("distance", self.distance)
            .with("threads", self.threads)
    }

    fn contestant<'a>(
        &'a self,
        scene: &'a Scene,
        exec: &'a Exec<'a>,
    ) -> Result<Contestant<'a, Box<dyn Any>>, StudyError> {
        let field = &scene.field;
        let radius = match self.work {
            Work::Map | Work::Sky => HorizonParams::default_radius(field.grid()),
            Work::Bent | Work::Swept => SWEPT_RADIUS,
        };
        let params = HorizonParams { azimuths: self.azimuths, radius, distance: self.distance, method: self.method };
        let work: Box<dyn FnMut() -> Result<Box<dyn Any>, StudyError> + 'a> = match self.work {
            Work::Map => {
                // One layer for all directions, as a bake that streams has it.
                let mut layer = HorizonLayer::new(field, &params)?;
                Box::new(move || {
                    for direction in 0..params.directions() {
                        bake_direction(field, &params, direction, exec, &mut layer)?;
                    }
                    Ok(Box::new(()))
                })
            }
            Work::Bent => Box::new(move || {
                let mut layer = BentLayer::new(field)?;
                for direction in 0..params.directions() {
                    bake_bent(field, &params, direction, 0.5 * SWEPT.range.max, exec, &mut layer)?;
                }
                Ok(Box::new(layer))
            }),
            Work::Swept => Box::new(move || {
                let mut baker = SweptBaker::new(field, &params, &SWEPT, exec)?;
                let mut layers = (0..baker.points()).map(|_| BentLayer::new(field)).collect::<Result<Vec<_>, _>>()?;
                for direction in 0..params.directions() {
                    baker.bake_direction(direction, exec, &mut layers)?;
                }
                Ok(Box::new(layers))
            }),
            Work::Sky => {
                let map = horizon::bake(field, &params, exec)?;
                Box::new(move || {
                    let mut sky = SkyAccumulator::new(field, &params.azimuths, SkyParams::ALL)?;
                    for direction in 0..params.directions() {
                        sky.add(direction, map.elevation_layer(direction), exec);
                    }
                    Ok(Box::new(sky.finish(exec)?))
                })
            }
        };
        Ok(Contestant { name: format!("{} {}² {}", self.scene, self.size, self.setting()), work })
    }

    /// `bandwidths` in ascending order of threads.
    fn record(&self, varied: &str, scene: &Scene, timing: &Timing, bandwidths: &[Bandwidth]) -> Record {
        let setting = self.setting().with("varied", varied);
        let mut record = Record::new("horizon", setting, scene).with_timing(timing, Item::TexelDirection, self.items());
        let enough = bandwidths.iter().find(|bandwidth| bandwidth.threads >= self.threads).or(bandwidths.last());
        // With several threads the wall's time counts: it is what they share the memory for.
        let ns = if self.threads == 1 { record.core_ns() } else { record.wall_ns };
        record.bandwidth_share = enough.zip(ns).map(|(bandwidth, ns)| self.bytes_moved() / ns / bandwidth.best());
        record.bake_seconds = record.core_ns().map(|ns| 1e-9 * ns * self.items());
        record
    }
}

/// Times every case of a heat. Bandwidths in ascending order of threads.
///
/// # Errors
/// A scene that cannot be made, or a bake that is refused.
pub fn measure(heat: &Heat, bandwidths: &[Bandwidth], observe: &mut Observer<'_>) -> Result<Vec<Record>, StudyError> {
    let scenes = heat.cases.iter().map(|case| scenes::by_name(case.scene, case.size));
    let scenes = scenes.collect::<Result<Vec<_>, _>>()?;
    let pools = heat.cases.iter().map(|case| Exec::new(case.threads)).collect::<Result<Vec<_>, _>>()?;
    let cases = heat.cases.iter().zip(&scenes);
    let contestants = cases.clone().zip(&pools).map(|((case, scene), pool)| case.contestant(scene, pool));
    let mut contestants = contestants.collect::<Result<Vec<_>, _>>()?;
    let timings = race(&mut contestants, &heat.pace, observe)?;
    Ok(cases.zip(&timings).map(|((case, scene), timing)| case.record(heat.varied, scene, timing, bandwidths)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    const TINY: Case = Case {
        scene: TERRAIN,
        size: 8,
        work: Work::Map,
        method: Method::Sweep,
        azimuths: Azimuths::FullCircle { count: 8 },
        distance: true,
        threads: 1,
    };

    #[test]
    fn a_quarter_turn_has_the_azimuths_of_the_circle() {
        let (quarter, circle) = (quarter(32), Azimuths::full_circle(32));
        assert_eq!(quarter.count(), 8);
        for k in 0..8 {
            assert!((quarter.degrees(k) - circle.degrees(k + 1)).abs() < 1e-12);
        }
    }

    #[test]
    fn threads_are_doubled_up_to_the_most() {
        let counts = [0, 1, 2, 3, 8].map(|most| thread_counts(most).collect::<Vec<_>>());
        assert_eq!(counts, [vec![1], vec![1], vec![1, 2], vec![1, 2, 3], vec![1, 2, 4, 8]]);
    }

    #[test]
    fn a_heat_varies_what_it_says_and_nothing_else() {
        for heat in heats(Scale::Full, 2) {
            let settings: Vec<_> = heat.cases.iter().map(|case| case.setting().without(heat.varied)).collect();
            assert!(settings.windows(2).all(|pair| pair[0] == pair[1]), "{}: {settings:?}", heat.varied);
            assert!(heat.cases.len() > 1, "{}", heat.varied);
        }
    }

    #[test]
    fn all_kinds_of_work_are_timed_once_by_the_default_method() {
        let heats = heats(Scale::Quick, 1);
        let work: Vec<&Heat> = heats.iter().filter(|heat| heat.varied == "work").collect();
        assert_eq!(work.len(), 1);
        let pace = Pace { seconds: 0.0, max_rounds: 1 };
        let bandwidths = [Bandwidth { threads: 1, copy: 10.0, triad: 1.0 }];
        let records = measure(&Heat { pace, ..work[0].clone() }, &bandwidths, &mut |_| ()).unwrap();
        let words: Vec<_> = records.iter().filter_map(|record| record.setting.get("work")).collect();
        assert_eq!(words, ["map", "bent", "swept", "sky"]);
        assert!(records.iter().all(|record| record.core_ns() > Some(0.0)));
    }

    #[test]
    fn the_share_of_the_bandwidth_is_the_least_traffic_over_the_time() {
        let bandwidths = [1, 2].map(|threads| Bandwidth { threads, copy: 10.0 * threads as f64, triad: 1.0 });
        let heat = Heat { varied: "distance", pace: Pace { seconds: 0.0, max_rounds: 1 }, cases: vec![TINY] };
        let record = measure(&heat, &bandwidths, &mut |_| ()).unwrap().remove(0);
        let expected = 12.0 / record.core_ns().unwrap() / 10.0;
        assert!((record.bandwidth_share.unwrap() - expected).abs() < 1e-12);
        assert_eq!(record.setting.get("varied"), Some("distance"));
    }
}
