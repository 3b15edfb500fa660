//! What goes wrong where a search starts at the depth of another ray, as the paper's does.

use barchan_shade::Relief;

use crate::relief_method::Feed;
use crate::relief_rays::{Sight, TOLERANCE};
use crate::relief_seeker::Seeker;
use crate::{Quantity, Record, Scene, Setting};

/// How a start behind its hit failed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Fault {
    /// It is inside the relief, and the way back out ends at the true hit.
    Inside,
    /// It is inside the relief, and the way back out ends elsewhere.
    WrongWayBack,
    /// It is outside again, behind what the ray should have hit.
    Tunnel,
}

/// The shares of starts that are behind their hits, and of those that are outside there, and that the search leads back to
/// a wrong hit.
pub(crate) fn of(
    feed: Feed,
    seeker: &Seeker<'_>,
    (relief, scene): (&Relief<'_>, &Scene),
    sights: &[Sight],
) -> Vec<Record> {
    let faults: Vec<Fault> = sights.iter().filter_map(|sight| fault(seeker, relief, sight)).collect();
    let share = |kind: &str, counts: fn(&Fault) -> bool| {
        let count = faults.iter().filter(|fault| counts(fault)).count();
        let setting = Setting::default().with("start", feed.name()).with("fault", kind);
        Record {
            quantity: Some(Quantity::StartDepth),
            samples: Some(sights.len() as u64),
            wrong_share: Some(count as f64 / sights.len() as f64),
            ..Record::new("start_faults", setting, scene)
        }
    };
    vec![
        share("overshoot", |_| true),
        share("tunnel", |fault| *fault == Fault::Tunnel),
        share("wrong_way_back", |fault| *fault == Fault::WrongWayBack),
    ]
}

fn fault(seeker: &Seeker<'_>, relief: &Relief<'_>, sight: &Sight) -> Option<Fault> {
    let start = seeker.road().start(&sight.ray).depth;
    if start <= sight.hit {
        return None;
    }
    let (x, y) = sight.ray.at(start);
    if relief.depth_at(x, y) > start {
        return Some(Fault::Tunnel);
    }
    let is_passed = seeker.road().find(&sight.ray).depth > sight.hit + TOLERANCE;
    Some(if is_passed { Fault::WrongWayBack } else { Fault::Inside })
}
