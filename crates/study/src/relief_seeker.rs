//! A start and a search put together, and how far its hits are from the truth.

use barchan_shade::{DepthMapStart, Found, ReliefRoad, ReliefSearch};

use crate::relief_rays::{Sight, TOLERANCE};
use crate::timer::{Contestant, Pace, Timing, race};
use crate::{Item, Norms, Quantity, Record, StudyError};

/// Finds hits by one method.
pub(crate) struct Seeker<'a> {
    pub(crate) search: Box<dyn ReliefSearch + 'a>,
    /// The top plane if there is none.
    pub(crate) start: Option<DepthMapStart<'a>>,
}

impl Seeker<'_> {
    pub(crate) fn road(&self) -> ReliefRoad<'_> {
        ReliefRoad { depth_map: self.start.as_ref(), search: &*self.search }
    }

    /// The record with errors and fetches.
    pub(crate) fn judge(&self, record: Record, sights: &[Sight]) -> Record {
        let road = self.road();
        let found: Vec<Found> = sights.iter().map(|sight| road.find(&sight.ray)).collect();
        let errors: Vec<f64> = found.iter().zip(sights).map(|(found, sight)| found.depth - sight.hit).collect();
        let count = sights.len() as f64;
        let missed = errors.iter().filter(|error| **error > TOLERANCE).count();
        let mean =
            |fetches: fn(&Found) -> u32| found.iter().map(|found| f64::from(fetches(found))).sum::<f64>() / count;
        Record {
            wrong_share: Some(missed as f64 / count),
            height_fetches: Some(mean(|found| found.fetches.heights)),
            table_fetches: Some(mean(|found| found.fetches.tables)),
            ..record.with_norms(Quantity::HitDepth, &Norms::of(&errors))
        }
    }

    /// The RMS error alone.
    pub(crate) fn rms(&self, sights: &[Sight]) -> f64 {
        let road = self.road();
        let squares = sights.iter().map(|sight| {
            let error = road.find(&sight.ray).depth - sight.hit;
            error * error
        });
        (squares.sum::<f64>() / sights.len() as f64).sqrt()
    }
}

/// Times seekers against each other on the same rays.
pub(crate) fn timings(seekers: &[Seeker<'_>], sights: &[Sight], pace: &Pace) -> Result<Vec<Timing>, StudyError> {
    let contestant = |seeker| Contestant { name: String::new(), work: Box::new(move || Ok(run(seeker, sights))) };
    let mut contestants: Vec<Contestant<'_, f64>> = seekers.iter().map(contestant).collect();
    race(&mut contestants, pace, &mut |_| ())
}

/// All hits of one seeker, added up so that none is left out.
fn run(seeker: &Seeker<'_>, sights: &[Sight]) -> f64 {
    let road = seeker.road();
    sights.iter().map(|sight| road.find(&sight.ray).depth).sum()
}

/// Records with the times of their seekers.
pub(crate) fn timed(records: Vec<Record>, timings: &[Timing], rays: usize) -> Vec<Record> {
    let with = |(record, timing): (Record, &Timing)| record.with_timing(timing, Item::Ray, rays as f64);
    records.into_iter().zip(timings).map(with).collect()
}
