//! End to end: the shadow that a shader decides from a stored horizon map, against the ray that asks the surface itself.
//!
//! # What is varied
//!
//! Azimuths of the map, its encoding, and the method of the bake, under lights at three elevations and at azimuths that
//! some maps have baked (0°, 45°) and none has (the others). Each place is decided twice, by [`TracedShadow`] and by
//! [`HorizonShadow`], which interpolates between texels and azimuths as the WGSL does.
//!
//! Places are counted apart: at texel centres the table itself is asked; between them its interpolation too, and a picture's
//! pixels lie anywhere. The wrong share is over all lights of an elevation, `max` that under the worst of them.
//!
//! # What it costs
//!
//! A shader samples two layers of the table, each once: two fetches. The time of a test is the CPU twin's on decoded
//! values, so it is the same for all encodings and is measured once per scene, beside that of tracing.

use barchan_asset::{Encoding, HorizonView, TextureTable};
use barchan_bakers::Exec;
use barchan_bakers::horizon::{self, Azimuths, HorizonMap, HorizonParams, Method};
use barchan_metrics::MaskDisagreement;
use barchan_shade::{DirectionalLight, HorizonShadow, Pixels, Surface, TracedShadow};

use crate::runner::{Observer, Study};
use crate::sample::unit;
use crate::timer::{Contestant, Pace, race};
use crate::{Item, Quantity, Record, Scale, Scene, Setting, Stopwatch, StudyError, run, scenes, tables};

/// Azimuths of the lights, degrees: baked by all maps, and by none.
const AZIMUTHS: [f64; 6] = [0.0, 45.0, 78.5, 140.2, 203.9, 287.3];

/// Elevations of the lights, degrees.
const ELEVATIONS: [f64; 3] = [5.0, 15.0, 30.0];

/// Texture samples per test: the two layers beside the light's azimuth.
const FETCHES: u32 = 2;

/// The study: directions × method, each in every encoding.
pub struct Shadow<'a> {
    /// How many azimuths maps have.
    pub directions: &'static [u32],
    /// How bakes run.
    pub exec: &'a Exec<'a>,
    /// How long tests are timed.
    pub pace: Pace,
}

/// What rays decide.
pub struct Truth {
    radius: f64,
    places: [Places; 2],
    suns: Vec<Sun>,
}

/// Places of one kind: `(x, y)` in texels from the centre of texel (0, 0).
struct Places {
    quantity: Quantity,
    all: Vec<(f64, f64)>,
}

/// A light, and whether each place of each kind is in its shadow.
struct Sun {
    elevation_degrees: f64,
    light: DirectionalLight,
    in_shadow: [Vec<bool>; 2],
}

/// The study and its scenes; `more` are further ones.
///
/// # Errors
/// A scene that cannot be made.
pub fn parts<'a>(scale: Scale, exec: &'a Exec<'a>, more: Vec<Scene>) -> Result<(Shadow<'a>, Vec<Scene>), StudyError> {
    let (size, directions, seconds): (_, &[u32], _) = match scale {
        Scale::Full => (256, &[8, 16, 32, 64], 1.0),
        Scale::Quick => (32, &[8, 16], 0.01),
    };
    let scenes: Result<Vec<_>, _> =
        ["reptile_skin", "dunes", "fractal_terrain"].map(|name| scenes::by_name(name, size)).into_iter().collect();
    let study = Shadow { directions, exec, pace: Pace { seconds, max_rounds: 7 } };
    Ok((study, scenes?.into_iter().chain(more).collect()))
}

/// Runs the study, then times one test by map and by ray on each scene.
///
/// # Errors
/// A bake that is refused.
pub fn measure(study: &Shadow<'_>, scenes: &[Scene], observe: &mut Observer<'_>) -> Result<Vec<Record>, StudyError> {
    let mut records = run(study, scenes, observe)?;
    for scene in scenes {
        records.extend(time_tests(study, scene, observe)?);
    }
    Ok(records)
}

impl Study for Shadow<'_> {
    type Setting = (u32, Method);
    type Truth = Truth;

    fn settings(&self) -> Vec<(u32, Method)> {
        self.directions.iter().flat_map(|&count| Method::ALL.map(|method| (count, method))).collect()
    }

    fn truth(&self, scene: &Scene) -> Result<Truth, StudyError> {
        let surface = tables::surface(&scene.field)?;
        let radius = HorizonParams::default_radius(scene.field.grid());
        let places = places(&surface);
        let lights = ELEVATIONS.iter().flat_map(|&elevation| AZIMUTHS.map(|azimuth| (azimuth, elevation)));
        let suns = lights.map(|(azimuth, elevation_degrees)| {
            let light = DirectionalLight::from_degrees(azimuth, elevation_degrees);
            let traced = TracedShadow::new(&surface, &light, radius);
            let in_shadow = places.each_ref().map(|places| places.decide(|x, y| traced.in_shadow(x, y)));
            Sun { elevation_degrees, light, in_shadow }
        });
        let suns = suns.collect();
        Ok(Truth { radius, places, suns })
    }

    fn measure(
        &self,
        scene: &Scene,
        truth: &Truth,
        &(directions, method): &(u32, Method),
    ) -> Result<Vec<Record>, StudyError> {
        let watch = Stopwatch::start();
        let map = bake(scene, truth.radius, (directions, method), self.exec)?;
        let bake_seconds = Some(watch.elapsed().core_seconds());
        let mut records = Vec::new();
        for encoding in Encoding::ALL {
            let table = tables::horizon(&map, encoding)?;
            let setting = setting((directions, method), encoding, &table);
            for (elevation, quantity, shares) in wrong_shares(&table, truth)? {
                let record = Record::new("horizon", setting.clone().with("elevation", elevation), scene);
                let bytes = Some(table.payload().len() as u64);
                let record = Record { bytes, bake_seconds, fetches: Some(FETCHES), ..record };
                records.push(with_shares(record, quantity, &shares));
            }
        }
        Ok(records)
    }
}

/// The record with what is wrong over all lights, and under the worst of them.
fn with_shares(record: Record, quantity: Quantity, shares: &[MaskDisagreement]) -> Record {
    let mut all = MaskDisagreement::default();
    shares.iter().for_each(|share| all.merge(share));
    Record {
        quantity: Some(quantity),
        samples: Some(all.total),
        wrong_share: Some(all.rate()),
        max: shares.iter().map(MaskDisagreement::rate).max_by(f64::total_cmp),
        ..record
    }
}

fn bake(
    scene: &Scene,
    radius: f64,
    (directions, method): (u32, Method),
    exec: &Exec<'_>,
) -> Result<HorizonMap, StudyError> {
    let params = HorizonParams { azimuths: Azimuths::full_circle(directions), radius, distance: false, method };
    Ok(horizon::bake(&scene.field, &params, exec)?)
}

fn setting((directions, method): (u32, Method), encoding: Encoding, table: &TextureTable) -> Setting {
    Setting::default()
        .with("directions", directions)
        // A compact encoding may store fewer layers than azimuths.
        .with("layers", table.descriptor().layers)
        .with("encoding", encoding.name())
        .with("method", method.name())
}

impl Places {
    /// A decision for each place, in order.
    fn decide(&self, in_shadow: impl Fn(f64, f64) -> bool) -> Vec<bool> {
        self.all.iter().map(|&(x, y)| in_shadow(x, y)).collect()
    }
}

/// The centre of every texel, and for every texel one place anywhere in it.
fn places(surface: &Surface) -> [Places; 2] {
    let centres = Pixels::one_per_texel(surface).map(|x, y| (x, y));
    let anywhere = |(index, &(x, y)): (usize, &(f64, f64))| {
        let index = index as u64;
        (x + unit(2 * index) - 0.5, y + unit(2 * index + 1) - 0.5)
    };
    let between = centres.iter().enumerate().map(anywhere).collect();
    [
        Places { quantity: Quantity::ShadowAtCentres, all: centres },
        Places { quantity: Quantity::ShadowBetweenCentres, all: between },
    ]
}

/// For each elevation and kind of place, the disagreement under each light.
fn wrong_shares(
    table: &TextureTable,
    truth: &Truth,
) -> Result<Vec<(f64, Quantity, Vec<MaskDisagreement>)>, StudyError> {
    let view = HorizonView::new(*table.descriptor(), table.payload())?;
    let wrong = |sun: &Sun| {
        let shadow = HorizonShadow::new(&view, &sun.light);
        let decide = |kind: usize| truth.places[kind].decide(|x, y| shadow.in_shadow(x, y));
        [0, 1].map(|kind| MaskDisagreement::between(&sun.in_shadow[kind], &decide(kind)))
    };
    let wrong: Vec<_> = truth.suns.iter().map(|sun| (sun.elevation_degrees, wrong(sun))).collect();
    let under = |elevation, kind: usize| {
        let at = wrong.iter().filter(|(degrees, _)| *degrees == elevation).map(|(_, kinds)| kinds[kind]).collect();
        (elevation, truth.places[kind].quantity, at)
    };
    Ok(ELEVATIONS.iter().flat_map(|&elevation| [0, 1].map(|kind| under(elevation, kind))).collect())
}

/// The time of a test by map and by ray, at places between texel centres, under a light in the middle of the range.
fn time_tests(study: &Shadow<'_>, scene: &Scene, observe: &mut Observer<'_>) -> Result<Vec<Record>, StudyError> {
    let (azimuth, elevation) = (AZIMUTHS[2], ELEVATIONS[1]);
    let light = DirectionalLight::from_degrees(azimuth, elevation);
    let radius = HorizonParams::default_radius(scene.field.grid());
    let surface = tables::surface(&scene.field)?;
    let map = bake(scene, radius, (study.directions[0], Method::Sweep), study.exec)?;
    let table = tables::horizon(&map, Encoding::F32)?;
    let by_map = HorizonShadow::new(&HorizonView::new(*table.descriptor(), table.payload())?, &light);
    let by_ray = TracedShadow::new(&surface, &light, radius);
    let [_, between] = places(&surface);
    let mut contestants = [
        contestant("horizon", || between.decide(|x, y| by_map.in_shadow(x, y))),
        contestant("traced", || between.decide(|x, y| by_ray.in_shadow(x, y))),
    ];
    let timings = race(&mut contestants, &study.pace, observe)?;
    let setting = Setting::default().with("elevation", elevation).with("azimuth", azimuth);
    let record = |technique, timing, fetches| {
        let record = Record::new(technique, setting.clone(), scene);
        Record { fetches, ..record.with_timing(timing, Item::ShadowTest, between.all.len() as f64) }
    };
    Ok(vec![record("horizon", &timings[0], Some(FETCHES)), record("traced", &timings[1], None)])
}

fn contestant<'a>(technique: &str, decide: impl Fn() -> Vec<bool> + 'a) -> Contestant<'a, Vec<bool>> {
    Contestant { name: format!("{technique} shadow tests"), work: Box::new(move || Ok(decide())) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn records(name: &str) -> Vec<Record> {
        let exec = Exec::new(1).unwrap();
        let study = Shadow { directions: &[8], exec: &exec, pace: Pace { seconds: 0.0, max_rounds: 1 } };
        measure(&study, &[scenes::by_name(name, 16).unwrap()], &mut |_| ()).unwrap()
    }

    #[test]
    fn a_level_field_has_no_shadow_to_get_wrong() {
        let records = records("constant");
        let decided: Vec<_> = records.iter().filter(|record| record.quantity.is_some()).collect();
        assert_eq!(decided.len(), Method::ALL.len() * Encoding::ALL.len() * ELEVATIONS.len() * 2);
        for record in decided {
            assert_eq!((record.wrong_share, record.max), (Some(0.0), Some(0.0)), "{}", record.setting);
            assert_eq!(record.samples, Some(256 * AZIMUTHS.len() as u64));
        }
    }

    #[test]
    fn fewer_bytes_are_said_and_both_techniques_are_timed() {
        let records = records("reptile_skin");
        let bytes = |encoding| {
            let of = |record: &&Record| record.setting.get("encoding") == Some(encoding);
            records.iter().find(of).and_then(|record| record.bytes).unwrap()
        };
        assert!(bytes("f32") == 2 * bytes("f16") && bytes("f16") == 2 * bytes("u8"));
        let timed: Vec<_> = records.iter().filter(|record| record.per == Some(Item::ShadowTest)).collect();
        assert_eq!(timed.iter().map(|record| record.technique.as_str()).collect::<Vec<_>>(), ["horizon", "traced"]);
    }

    #[test]
    fn places_between_centres_stay_in_their_texel() {
        let surface = tables::surface(&scenes::by_name("plane", 8).unwrap().field).unwrap();
        let [centres, between] = places(&surface).map(|places| places.all);
        assert!(centres.iter().zip(&between).all(|(c, b)| (c.0 - b.0).abs() <= 0.5 && (c.1 - b.1).abs() <= 0.5));
    }
}
