//! The claims of Takeshi Suzuki, *An Accelerated Relief Mapping Using Depth Maps*, section 5, as ratios on its scenes rebuilt.
//!
//! # What is compared
//!
//! Linear search and bisection from the top plane, the paper's baseline, against the same from its depths: one ray of 32 × 16
//! directions, reduced by minima from a height map of 512 × 512. Conservative depths stand beside them. The paper says neither
//! its number of steps nor how deep its relief is, and prints its height maps as pictures: ours are 64 steps and 8 halvings,
//! and [`reliefs::PAPER`].
//!
//! # At equal step and at equal error
//!
//! The paper compares searches of the same step. A start that is wrong, or nearer to the hit, changes the error too, so each is
//! also given the largest step, by a ladder of a tenth, at which its RMS error of depth against the exact trace is no more than
//! 2 % above the baseline's. Where no number of steps up to 512 reaches that, there is no such record.
//!
//! # The scenes
//!
//! - `sphere`: a sphere tiled with the first relief, 64² depths; every direction occurs.
//! - `plane`: a plane with each of two reliefs, 32² depths, the eye going from left to right.
//! - `sizes`: the plane with the first relief, depths of 512² down to 32².

use barchan_bakers::Exec;
use barchan_shade::{DepthMapStart, LinearSearch, Relief};

use crate::hemisphere_spec::{HemisphereSpec, Layers, StoredHemisphere};
use crate::relief_method::Feed;
use crate::relief_rays::{Sight, plane, sphere, towards};
use crate::relief_seeker::{Seeker, timed, timings};
use crate::relief_tables::{BISECTIONS, STEPS};
use crate::runner::{Observer, Step};
use crate::timer::Pace;
use crate::{Record, Scale, Scene, Setting, StudyError, reliefs, tables};

/// Where the eye stands on its way from left to right, degrees from the normal, to either side.
const ANGLES: [f64; 6] = [0.0, 15.0, 30.0, 45.0, 60.0, 75.0];

/// The way's azimuths, degrees: no axis of the grid, and no directions of the maps.
const AZIMUTHS: [f64; 2] = [10.0, 190.0];

/// Where rings end, degrees from the normal. The paper's end at 90°, where a ray never comes down.
const MAX_POLAR: f64 = 89.0;

/// By how much an error may be larger to be called equal.
const EQUAL: f64 = 1.02;

/// The fewest and the most steps that are tried for an equal error.
const LADDER: (u32, u32) = (4, 512);

/// The study.
pub struct Paper<'a> {
    /// Texels along each side of height maps.
    pub texels: u32,
    /// Texels along the sides of depth maps, the largest first.
    pub sizes: &'static [u32],
    /// Texels along the side of the sphere's depth maps, and of the plane's.
    pub sphere_and_plane: (u32, u32),
    /// Pixels along the side of pictures of the sphere, and of the plane.
    pub pixels: (u32, u32),
    /// How bakes run.
    pub exec: &'a Exec<'a>,
    /// How long the methods of one picture are timed.
    pub pace: Pace,
}

/// A part of the paper's evaluation: its name, the relief, texels along the sides of depth maps.
type Part<'a> = (&'static str, &'a Scene, u32);

/// Some rays of a scene, and what they are called.
struct View {
    setting: Setting,
    sights: Vec<Sight>,
}

/// Depth maps of a relief: the paper's and conservative ones.
struct Hemispheres {
    nearest: StoredHemisphere,
    conservative: StoredHemisphere,
}

/// The study.
#[must_use]
pub fn study<'a>(scale: Scale, exec: &'a Exec<'a>) -> Paper<'a> {
    let (texels, sizes, sphere_and_plane, pixels, seconds): (_, &[u32], _, _, _) = match scale {
        Scale::Full => (512, &[512, 256, 128, 64, 32], (64, 32), (160, 64), 0.4),
        Scale::Quick => (32, &[16, 8], (4, 8), (12, 6), 0.0),
    };
    Paper { texels, sizes, sphere_and_plane, pixels, exec, pace: Pace { seconds, max_rounds: 7 } }
}

/// The records of all scenes.
///
/// # Errors
/// A bake that is refused.
pub fn measure(study: &Paper<'_>, observe: &mut Observer<'_>) -> Result<Vec<Record>, StudyError> {
    let [first, second] = reliefs::PAPER.map(|name| reliefs::by_name(name, study.texels));
    let (first, second) = (first?, second?);
    let (sphere, plane) = study.sphere_and_plane;
    let mut parts: Vec<Part<'_>> =
        vec![("sphere", &first, sphere), ("plane", &first, plane), ("plane", &second, plane)];
    parts.extend(study.sizes.iter().map(|&size| ("sizes", &first, size)));
    let mut records = Vec::new();
    for (done, part) in parts.iter().enumerate() {
        observe(&Step { done, total: parts.len(), what: &format!("{}, {}, {}²", part.0, part.1.name, part.2) });
        records.extend(study.part(part)?);
    }
    Ok(records)
}

impl Paper<'_> {
    fn part(&self, &(name, scene, size): &Part<'_>) -> Result<Vec<Record>, StudyError> {
        let layers = if name == "sphere" { Layers::All } else { Layers::AtAnglesAnd(&ANGLES, &AZIMUTHS) };
        let stored = |spec: HemisphereSpec| HemisphereSpec { size, ..spec }.bake(&scene.field, layers, self.exec);
        let hemispheres = Hemispheres {
            nearest: stored(HemisphereSpec::paper(MAX_POLAR))?,
            conservative: stored(HemisphereSpec::conservative(MAX_POLAR))?,
        };
        let surface = tables::surface(&scene.field)?;
        let relief = Relief::new(&surface);
        let setting = Setting::default().with("part", name).with("size", size);
        let mut records = Vec::new();
        for view in self.views(&relief, &setting) {
            records.extend(self.compare(scene, &relief, &hemispheres, &view)?);
        }
        Ok(records)
    }

    fn views(&self, relief: &Relief<'_>, setting: &Setting) -> Vec<View> {
        if setting.get("part") == Some("sphere") {
            return vec![View { setting: setting.clone(), sights: sphere(relief, self.texels, self.pixels.0) }];
        }
        let view = |angle: f64| {
            let from = |azimuth: f64| {
                let direction = towards(angle.to_radians(), azimuth.to_radians());
                plane(relief, self.texels, direction, self.pixels.1)
            };
            let sights = AZIMUTHS.into_iter().flat_map(from).collect();
            View { setting: setting.clone().with("angle", angle), sights }
        };
        ANGLES.map(view).into()
    }

    /// The baseline, and what starts lower at an equal step and at an equal error.
    fn compare(
        &self,
        scene: &Scene,
        relief: &Relief<'_>,
        hemispheres: &Hemispheres,
        view: &View,
    ) -> Result<Vec<Record>, StudyError> {
        let judged = |seeker: &Seeker<'_>, feed: Feed, at: &str, steps: u32| {
            let setting = view.setting.clone().with("start", feed.name()).with("at", at).with("steps", steps);
            seeker.judge(Record::new("hemisphere_paper", setting, scene), &view.sights)
        };
        let mut seekers = vec![linear(relief, STEPS, None)];
        let mut records = vec![judged(&seekers[0], Feed::Top, "baseline", STEPS)];
        let target = seekers[0].rms(&view.sights);
        for (feed, stored) in [(Feed::Nearest, &hemispheres.nearest), (Feed::Conservative, &hemispheres.conservative)] {
            let start = stored.start(relief)?;
            let equal =
                ladder().find(|&steps| linear(relief, steps, Some(start.clone())).rms(&view.sights) <= EQUAL * target);
            for (at, steps) in [("equal_step", Some(STEPS)), ("equal_error", equal)] {
                let Some(steps) = steps else { continue };
                let seeker = linear(relief, steps, Some(start.clone()));
                records.push(Record { bytes: Some(stored.bytes()), ..judged(&seeker, feed, at, steps) });
                seekers.push(seeker);
            }
        }
        Ok(timed(records, &timings(&seekers, &view.sights, &self.pace)?, view.sights.len()))
    }
}

fn linear<'a>(relief: &Relief<'a>, steps: u32, start: Option<DepthMapStart<'a>>) -> Seeker<'a> {
    Seeker { search: Box::new(LinearSearch::new(relief, steps, BISECTIONS)), start }
}

/// Numbers of steps, each about a tenth larger than the last.
fn ladder() -> impl Iterator<Item = u32> {
    let next = |steps: &u32| Some(steps + (steps / 10).max(1)).filter(|steps| *steps <= LADDER.1);
    std::iter::successors(Some(LADDER.0), next)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn starts_lower_down_save_height_tests_and_an_equal_error_is_no_larger() {
        let exec = Exec::new(1).unwrap();
        let records = measure(&study(Scale::Quick, &exec), &mut |_| ()).unwrap();
        let sum = |at: &str, start: &str| {
            let of = records
                .iter()
                .filter(|record| (record.setting.get("at"), record.setting.get("start")) == (Some(at), Some(start)));
            of.filter_map(|record| record.height_fetches).sum::<f64>()
        };
        let baseline = sum("baseline", "top");
        assert!(sum("equal_step", "nearest") < baseline && sum("equal_step", "conservative") < baseline);
        let mut baseline = None;
        for record in &records {
            match record.setting.get("at") {
                Some("baseline") => baseline = record.rms,
                Some("equal_error") => assert!(record.rms <= baseline.map(|rms| EQUAL * rms), "{}", record.setting),
                _ => {}
            }
        }
        // A sphere, two planes and two sizes, from six angles each but the sphere.
        let views = records.iter().filter(|record| record.setting.get("at") == Some("baseline")).count();
        assert_eq!(views, 1 + 6 * (2 + 2));
    }

    #[test]
    fn the_ladder_climbs_by_a_tenth() {
        let rungs: Vec<u32> = ladder().collect();
        assert!(rungs.windows(2).all(|pair| pair[1] > pair[0] && f64::from(pair[1]) <= 1.1 * f64::from(pair[0]) + 1.0));
        assert!(rungs[0] == LADDER.0 && rungs.last() > Some(&450));
    }
}
