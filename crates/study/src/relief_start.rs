//! Where hemisphere depths let a ray start, and what it then takes to find the hit by cone steps: by size, encoding, grid of
//! directions and mode, on the five reliefs.
//!
//! # What is counted
//!
//! Of every table, under rays from anywhere at four angles from the normal: the mean depth of the start beside that of the true
//! hit, and the share of starts behind it, which are overshoots. No tolerance is allowed: a start is behind the hit if its number is
//! larger. Then the error and the fetches of cone steps from there. The same rays without a table, by cone steps, by a
//! maximum mip and by linear search, say what is saved.
//!
//! Only those rings are baked that the angles ask for; the others' depth is 0, and no ray reads them.

use barchan_asset::{Encoding, RingSpacing};
use barchan_bakers::Exec;
use barchan_shade::{Relief, Surface};

use crate::hemisphere_spec::{HemisphereSpec, Layers};
use crate::relief_method::Search;
use crate::relief_rays::{Sight, anywhere};
use crate::relief_seeker::Seeker;
use crate::relief_tables::StoredSearch;
use crate::runner::Study;
use crate::{Norms, Quantity, Record, Scale, Scene, Setting, StudyError, reliefs, tables};

/// Angles of the rays from the normal, degrees.
pub(crate) const ANGLES: [f64; 4] = [10.0, 35.0, 60.0, 75.0];

/// The angle from the normal that tables are baked to, degrees.
const MAX_POLAR: f64 = 80.0;

/// The searches; the first two go on from tables, too.
const SEARCHES: [Search; 3] = [Search::Cones, Search::MaximumMip, Search::Linear];

/// Tables of the most texels take longest, and are baked of these reliefs alone.
const LARGEST_OF: [&str; 2] = ["fractal", "spikes"];

/// The study: every table on every relief.
pub struct Starts<'a> {
    /// Texels along the sides of tables.
    pub sizes: &'static [u32],
    /// Rays per relief and angle.
    pub rays: u64,
    /// How bakes run.
    pub exec: &'a Exec<'a>,
}

/// What is true of a relief's rays, and what does without hemispheres.
pub struct Truth {
    surface: Surface,
    /// Those of [`SEARCHES`].
    searches: Vec<StoredSearch>,
    sights: Vec<(f64, Vec<Sight>)>,
}

/// The study and its reliefs.
///
/// # Errors
/// A relief that cannot be made.
pub fn parts<'a>(scale: Scale, exec: &'a Exec<'a>) -> Result<(Starts<'a>, Vec<Scene>), StudyError> {
    let (texels, sizes, rays): (_, &[u32], _) = match scale {
        Scale::Full => (256, &[16, 32, 64, 128, 256], 10_000),
        Scale::Quick => (32, &[8, 16], 50),
    };
    let scenes = reliefs::FIVE.map(|name| reliefs::by_name(name, texels)).into_iter().collect::<Result<_, _>>()?;
    Ok((Starts { sizes, rays, exec }, scenes))
}

impl Study for Starts<'_> {
    type Setting = Option<HemisphereSpec>;
    type Truth = Truth;

    /// None is no table.
    fn settings(&self) -> Vec<Option<HemisphereSpec>> {
        let at = |spec: HemisphereSpec| move |&size: &u32| HemisphereSpec { size, ..spec };
        let middle = self.sizes[self.sizes.len() / 2];
        let conservative = HemisphereSpec { size: middle, ..HemisphereSpec::conservative(MAX_POLAR) };
        let nearest = HemisphereSpec::paper(MAX_POLAR);
        let half = HemisphereSpec { encoding: Encoding::F16, ..conservative };
        let grids = [
            (32, 16, RingSpacing::EqualAngles),
            (16, 32, RingSpacing::SquaredTangents),
            (16, 32, RingSpacing::EqualAngles),
        ];
        let grids = grids.map(|(rings, azimuths, spacing)| HemisphereSpec { rings, azimuths, spacing, ..conservative });
        let conservatives = self.sizes.iter().map(at(conservative)).chain([half]).chain(grids);
        [None].into_iter().chain(conservatives.chain(self.sizes.iter().map(at(nearest))).map(Some)).collect()
    }

    fn truth(&self, scene: &Scene) -> Result<Truth, StudyError> {
        let surface = tables::surface(&scene.field)?;
        let searches = SEARCHES.map(|search| StoredSearch::bake(search, &scene.field, self.exec));
        let searches = searches.into_iter().collect::<Result<_, _>>()?;
        let relief = Relief::new(&surface);
        let width = scene.field.grid().width;
        let sights = ANGLES.map(|angle| (angle, anywhere(&relief, width, angle, self.rays))).into();
        Ok(Truth { surface, searches, sights })
    }

    fn measure(
        &self,
        scene: &Scene,
        truth: &Truth,
        setting: &Option<HemisphereSpec>,
    ) -> Result<Vec<Record>, StudyError> {
        match setting {
            None => truth.without_table(scene),
            Some(spec) if self.is_left_out(scene, spec) => Ok(Vec::new()),
            Some(spec) => self.by_table(scene, truth, spec),
        }
    }
}

impl Starts<'_> {
    fn by_table(&self, scene: &Scene, truth: &Truth, spec: &HemisphereSpec) -> Result<Vec<Record>, StudyError> {
        let stored = spec.bake(&scene.field, Layers::AtAngles(&ANGLES), self.exec)?;
        let relief = Relief::new(&truth.surface);
        let seeker = |search: &StoredSearch| {
            Ok::<_, StudyError>(Seeker { search: search.of(&relief)?, start: Some(stored.start(&relief)?) })
        };
        let seekers = truth.searches[..2].iter().map(seeker).collect::<Result<Vec<_>, _>>()?;
        let records = truth.sights.iter().flat_map(|(angle, sights)| {
            let setting = spec.setting().with("angle", angle);
            let blank = |what: &str| {
                let record = Record::new(what, setting.clone(), scene);
                Record { bytes: Some(stored.bytes()), ..record }
            };
            let started = starts(blank("relief_start"), &seekers[0], sights);
            let found = SEARCHES.iter().zip(&seekers).map(|(search, seeker)| {
                let record = blank("relief_search");
                seeker.judge(Record { setting: record.setting.clone().with("search", search.name()), ..record }, sights)
            });
            [started].into_iter().chain(found).collect::<Vec<_>>()
        });
        Ok(records.collect())
    }

    fn is_left_out(&self, scene: &Scene, spec: &HemisphereSpec) -> bool {
        Some(&spec.size) == self.sizes.last() && !LARGEST_OF.contains(&scene.name.as_str())
    }
}

impl Truth {
    fn without_table(&self, scene: &Scene) -> Result<Vec<Record>, StudyError> {
        let relief = Relief::new(&self.surface);
        let mut records = Vec::new();
        for (angle, sights) in &self.sights {
            let depths = sights.iter().map(|sight| sight.hit).sum::<f64>() / sights.len() as f64;
            let record =
                Record::new("relief_start", Setting::default().with("mode", "true").with("angle", angle), scene);
            let samples = Some(sights.len() as u64);
            records.push(Record { quantity: Some(Quantity::StartDepth), samples, mean: Some(depths), ..record });
            for search in &self.searches {
                let setting =
                    Setting::default().with("mode", "top").with("search", search.search.name()).with("angle", angle);
                let seeker = Seeker { search: search.of(&relief)?, start: None };
                let bytes = Some(search.weight().0);
                let record = Record { bytes, ..Record::new("relief_search", setting, scene) };
                records.push(seeker.judge(record, sights));
            }
        }
        Ok(records)
    }
}

/// The record with the starts: how deep, and how many behind the true hit.
fn starts(record: Record, seeker: &Seeker<'_>, sights: &[Sight]) -> Record {
    let depths: Vec<f64> = sights.iter().map(|sight| seeker.road().start(&sight.ray).depth).collect();
    let errors: Vec<f64> = depths.iter().zip(sights).map(|(depth, sight)| depth - sight.hit).collect();
    let count = sights.len() as f64;
    let behind = errors.iter().filter(|error| **error > 0.0).count();
    Record {
        wrong_share: Some(behind as f64 / count),
        mean: Some(depths.iter().sum::<f64>() / count),
        ..record.with_norms(Quantity::StartDepth, &Norms::of(&errors))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run;

    fn records() -> Vec<Record> {
        let exec = Exec::new(1).unwrap();
        let (study, mut scenes) = parts(Scale::Quick, &exec).unwrap();
        scenes.retain(|scene| scene.name == "fractal");
        run(&study, &scenes, &mut |_| ()).unwrap()
    }

    fn starts_of<'a>(records: &'a [Record], mode: &'a str) -> impl Iterator<Item = &'a Record> {
        records
            .iter()
            .filter(move |record| record.technique == "relief_start" && record.setting.get("mode") == Some(mode))
    }

    #[test]
    fn no_conservative_start_is_behind_its_hit_and_some_nearest_ones_are() {
        let records = records();
        assert!(starts_of(&records, "conservative").all(|record| record.wrong_share == Some(0.0)));
        assert!(starts_of(&records, "nearest").any(|record| record.wrong_share > Some(0.0)));
    }

    #[test]
    fn starts_are_above_the_truth_on_average_and_finer_tables_start_lower() {
        let records = records();
        let mean = |mode, size: Option<&str>| {
            let of = starts_of(&records, mode).filter(|record| record.setting.get("size") == size);
            of.filter_map(|record| record.mean).sum::<f64>()
        };
        // The finer one comes in another encoding and in three more grids.
        let (coarse, fine) = (mean("conservative", Some("8")), mean("conservative", Some("16")) / 5.0);
        assert!(coarse > 0.0 && coarse < fine && fine < mean("true", None), "{coarse} {fine}");
    }
}
