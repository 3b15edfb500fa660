//! All ways to find a ray's first hit with a relief, on reliefs that differ in what makes a search fail.
//!
//! # What is compared
//!
//! Every [`Search`] from the top plane, from the paper's depths and from conservative ones; all tables as a file stores them
//! in the compact encoding, on heights as stored. The truth is the exact hit with the bilinear surface
//! ([`TracedRelief`](barchan_shade::TracedRelief)). Rays enter anywhere in the tile from all azimuths, at one elevation each.
//!
//! # What is counted
//!
//! The error of the hit's depth, as a part of the relief's thickness; the share of rays that pass their true hit by more than
//! [`TOLERANCE`](crate::relief_rays::TOLERANCE), which are features missed; fetches of heights and of other tables; and the
//! time of start and search, the ray given. Beside it, what goes wrong with starts at any angle that maps have: behind the
//! hit, out of the relief again, and led back to a wrong hit.
//!
//! # What it weighs
//!
//! Bytes of the tables that a method reads beside the heights, and the processor time of their bakes. Hemispheres have the
//! paper's 32 × 16 directions and 64 × 64 depths.

use barchan_bakers::Exec;
use barchan_shade::{DepthMapStart, LinearSearch, Relief};

use crate::hemisphere_spec::{HemisphereSpec, Layers, StoredHemisphere};
use crate::relief_method::{Feed, Method, Search};
use crate::relief_rays::{Sight, anywhere, anywhere_within};
use crate::relief_seeker::{Seeker, timed, timings};
use crate::relief_tables::{BISECTIONS, StoredSearch};
use crate::runner::{Observer, Step};
use crate::timer::Pace;
use crate::{Record, Scale, Scene, Setting, StudyError, reliefs, start_faults, tables};

/// Elevations of the eye above the plane, degrees.
const ELEVATIONS: [f64; 4] = [80.0, 45.0, 20.0, 15.0];

/// The angle from the normal that hemispheres are baked to, degrees.
pub(crate) const MAX_POLAR: f64 = 80.0;

/// The elevation at which numbers of steps are compared, degrees.
const SWEPT_ELEVATION: f64 = 20.0;

/// The numbers of steps that are compared.
const SWEPT_STEPS: [u32; 7] = [8, 12, 16, 32, 64, 128, 256];

/// The study.
pub struct Searches<'a> {
    /// Rays per relief and elevation.
    pub rays: u64,
    /// Of them, those that are timed.
    pub timed_rays: usize,
    /// Texels along each side of a hemisphere.
    pub size: u32,
    /// How bakes run.
    pub exec: &'a Exec<'a>,
    /// How long all methods are timed at one elevation.
    pub pace: Pace,
}

/// The tables of a relief.
struct Stored {
    /// In the order of [`Search::ALL`].
    searches: Vec<StoredSearch>,
    nearest: StoredHemisphere,
    conservative: StoredHemisphere,
}

/// A relief, and for each method in turn what finds hits with it, its bytes and the seconds of its bakes.
struct Bench<'a> {
    scene: &'a Scene,
    seekers: Vec<Seeker<'a>>,
    weights: Vec<(u64, f64)>,
}

/// The study and its reliefs.
///
/// # Errors
/// A relief that cannot be made.
pub fn parts<'a>(scale: Scale, exec: &'a Exec<'a>) -> Result<(Searches<'a>, Vec<Scene>), StudyError> {
    let (texels, size, rays, timed_rays, seconds) = match scale {
        Scale::Full => (256, 64, 20_000, 4000, 0.5),
        Scale::Quick => (32, 8, 100, 20, 0.0),
    };
    let scenes = reliefs::FIVE.map(|name| reliefs::by_name(name, texels)).into_iter().collect::<Result<_, _>>()?;
    Ok((Searches { rays, timed_rays, size, exec, pace: Pace { seconds, max_rounds: 7 } }, scenes))
}

/// The records of all reliefs.
///
/// # Errors
/// A bake that is refused.
pub fn measure(study: &Searches<'_>, scenes: &[Scene], observe: &mut Observer<'_>) -> Result<Vec<Record>, StudyError> {
    let mut records = Vec::new();
    for (done, scene) in scenes.iter().enumerate() {
        observe(&Step { done, total: scenes.len(), what: &scene.name });
        let surface = tables::surface(&scene.field)?;
        let relief = Relief::new(&surface);
        let stored = study.bake(scene)?;
        let bench = stored.bench(scene, &relief)?;
        let width = scene.field.grid().width;
        for elevation in ELEVATIONS {
            let sights = anywhere(&relief, width, 90.0 - elevation, study.rays);
            records.extend(study.compare(&bench, elevation, &sights)?);
        }
        records.extend(stored.sweep(scene, &relief, &anywhere(&relief, width, 90.0 - SWEPT_ELEVATION, study.rays))?);
        let sights = anywhere_within(&relief, width, MAX_POLAR, study.rays);
        let linear = Method::all().zip(&bench.seekers).filter(|(method, _)| method.search == Search::Linear);
        for (method, seeker) in linear {
            records.extend(start_faults::of(method.feed, seeker, (&relief, scene), &sights));
        }
    }
    Ok(records)
}

impl Searches<'_> {
    fn bake(&self, scene: &Scene) -> Result<Stored, StudyError> {
        let hemisphere = |spec: HemisphereSpec| {
            HemisphereSpec { size: self.size, ..spec }.bake(&scene.field, Layers::All, self.exec)
        };
        let searches = Search::ALL.map(|search| StoredSearch::bake(search, &scene.field, self.exec));
        Ok(Stored {
            searches: searches.into_iter().collect::<Result<_, _>>()?,
            nearest: hemisphere(HemisphereSpec::paper(MAX_POLAR))?,
            conservative: hemisphere(HemisphereSpec::conservative(MAX_POLAR))?,
        })
    }

    /// All methods under the same rays.
    fn compare(&self, bench: &Bench<'_>, elevation: f64, sights: &[Sight]) -> Result<Vec<Record>, StudyError> {
        let each = Method::all().zip(&bench.seekers).zip(&bench.weights);
        let records = each.map(|((method, seeker), &(bytes, seconds))| {
            let record = Record::new("relief_search", setting(method, elevation), bench.scene);
            seeker.judge(Record { bytes: Some(bytes), bake_seconds: Some(seconds), ..record }, sights)
        });
        let records = records.collect();
        let some = &sights[..sights.len().min(self.timed_rays)];
        Ok(timed(records, &timings(&bench.seekers, some, &self.pace)?, some.len()))
    }
}

impl Stored {
    fn bench<'a>(&'a self, scene: &'a Scene, relief: &Relief<'a>) -> Result<Bench<'a>, StudyError> {
        let mut bench = Bench { scene, seekers: Vec::new(), weights: Vec::new() };
        for (search, feed) in self.searches.iter().flat_map(|search| Feed::ALL.map(|feed| (search, feed))) {
            let (bytes, seconds) = search.weight();
            let more = self.hemisphere(feed).map_or((0, 0.0), |stored| (stored.bytes(), stored.seconds));
            bench.seekers.push(Seeker { search: search.of(relief)?, start: self.start(relief, feed)? });
            bench.weights.push((bytes + more.0, seconds + more.1));
        }
        Ok(bench)
    }

    fn hemisphere(&self, feed: Feed) -> Option<&StoredHemisphere> {
        match feed {
            Feed::Top => None,
            Feed::Nearest => Some(&self.nearest),
            Feed::Conservative => Some(&self.conservative),
        }
    }

    fn start(&self, relief: &Relief<'_>, feed: Feed) -> Result<Option<DepthMapStart<'_>>, StudyError> {
        self.hemisphere(feed).map(|stored| stored.start(relief)).transpose()
    }

    /// Linear searches of several numbers of steps, and beside them what has no steps to choose.
    fn sweep(&self, scene: &Scene, relief: &Relief<'_>, sights: &[Sight]) -> Result<Vec<Record>, StudyError> {
        let mut records = Vec::new();
        for feed in Feed::ALL {
            for steps in SWEPT_STEPS {
                let search = Box::new(LinearSearch::new(relief, steps, BISECTIONS));
                let seeker = Seeker { search, start: self.start(relief, feed)? };
                let setting = setting(Method { search: Search::Linear, feed }, SWEPT_ELEVATION).with("steps", steps);
                records.push(seeker.judge(Record::new("relief_sweep", setting, scene), sights));
            }
        }
        for search in self.searches.iter().filter(|search| matches!(search.search, Search::Cones | Search::MaximumMip))
        {
            let seeker = Seeker { search: search.of(relief)?, start: self.start(relief, Feed::Conservative)? };
            let method = Method { search: search.search, feed: Feed::Conservative };
            records.push(seeker.judge(Record::new("relief_sweep", setting(method, SWEPT_ELEVATION), scene), sights));
        }
        Ok(records)
    }
}

fn setting(method: Method, elevation: f64) -> Setting {
    let setting = Setting::default().with("search", method.search.name()).with("start", method.feed.name());
    setting.with("elevation", elevation)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of one relief.
    fn records(name: &str) -> Vec<Record> {
        let exec = Exec::new(1).unwrap();
        let (study, mut scenes) = parts(Scale::Quick, &exec).unwrap();
        scenes.retain(|scene| scene.name == name);
        measure(&study, &scenes, &mut |_| ()).unwrap()
    }

    fn of<'a>(records: &'a [Record], technique: &'a str, words: &'a str) -> impl Iterator<Item = &'a Record> {
        let is = move |record: &&Record| record.technique == technique && record.setting.to_string().starts_with(words);
        records.iter().filter(is)
    }

    #[test]
    fn what_knows_free_space_misses_nothing_and_what_steps_loses_features_seen_from_the_side() {
        let records = records("white_noise");
        for search in ["cone_steps", "maximum_mip"] {
            for start in ["top", "conservative"] {
                let words = format!("search={search} start={start}");
                assert_eq!(of(&records, "relief_search", &words).count(), ELEVATIONS.len());
                assert!(of(&records, "relief_search", &words).all(|record| record.max < Some(1e-5)), "{words}");
            }
        }
        let mut lost = of(&records, "relief_search", "search=linear start=top elevation=15");
        assert!(lost.any(|record| record.wrong_share > Some(0.0)));
    }

    #[test]
    fn a_search_that_starts_lower_looks_at_less_and_weighs_more_and_only_starts_of_other_rays_fail() {
        let records = records("fractal");
        let fetches =
            |words| of(&records, "relief_search", words).filter_map(|record| record.height_fetches).sum::<f64>();
        assert!(fetches("search=linear start=conservative") < fetches("search=linear start=top"));
        let weigh = |words| of(&records, "relief_search", words).filter_map(|record| record.bytes);
        assert!(weigh("search=linear start=top").all(|bytes| bytes == 0));
        assert!(weigh("search=linear start=conservative").all(|bytes| bytes >= 8 * 8 * 512));
        let behind = |words| of(&records, "start_faults", words).filter_map(|record| record.wrong_share).sum::<f64>();
        assert_eq!((behind("start=top"), behind("start=conservative")), (0.0, 0.0));
        assert!(behind("start=nearest") > 0.0);
    }

    #[test]
    fn more_steps_are_more_fetches_and_exact_searches_stand_beside_them() {
        let records = records("fractal");
        let linear: Vec<f64> = of(&records, "relief_sweep", "search=linear start=top")
            .filter_map(|record| record.height_fetches)
            .collect();
        assert_eq!(linear.len(), SWEPT_STEPS.len());
        assert!(linear.windows(2).all(|pair| pair[0] < pair[1]));
        assert_eq!(of(&records, "relief_sweep", "search=cone_steps start=conservative").count(), 1);
    }
}
