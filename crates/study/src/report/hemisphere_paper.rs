//! The paper's claims beside ours, and the views that they are sums of.

use super::numbers::{NONE, distinct, or_none, percent, short};
use super::relief_words::{depth, fetches, has, relief, word};
use crate::markdown::Table;
use crate::{Record, RecordFile, reliefs};

/// What is held against the baseline: start, at which steps, and the column's title.
const COLUMNS: [(&str, &str, &str); 4] = [
    ("nearest", "equal_step", "ours, equal step"),
    ("nearest", "equal_error", "ours, equal error"),
    ("conservative", "equal_step", "conservative, equal step"),
    ("conservative", "equal_error", "conservative, equal error"),
];

/// What a claim is about.
#[derive(Clone, Copy)]
enum Kind {
    /// Height tests saved, at least this part.
    Saved,
    /// Fetches of heights and depths over the baseline's, at most this part.
    Accesses,
    /// The baseline's time over the accelerated, at least.
    Faster,
}

/// A figure of the paper: in words, over which records, and how large.
struct Claim {
    words: String,
    scene: &'static str,
    over: Vec<(&'static str, String)>,
    kind: Kind,
    paper: f64,
}

/// Cost of the baseline and of what is held against it, over the same views.
struct Sums {
    ratio: f64,
    views: usize,
}

pub(super) fn render(file: &RecordFile) -> String {
    let records: Vec<&Record> = file.records.iter().collect();
    format!("{}\n{}\nMeasured on {}.\n", claimed(&records), views(&records), file.machine)
}

fn claims(records: &[&Record]) -> Vec<Claim> {
    let [first, second] = reliefs::PAPER;
    let claim = |words: &str, scene, over: &[(&'static str, &str)], kind, paper| Claim {
        words: words.to_owned(),
        scene,
        over: over.iter().map(|(name, value)| (*name, (*value).to_owned())).collect(),
        kind,
        paper,
    };
    let mut claims = vec![
        claim("sphere, 64²: height tests saved", first, &[("part", "sphere")], Kind::Saved, 0.51),
        claim("sphere, 64²: times as fast", first, &[("part", "sphere")], Kind::Faster, 1.45),
        claim("plane, 32², first relief: times as fast", first, &[("part", "plane")], Kind::Faster, 1.55),
        claim("plane, 32², relief near its floor: times as fast", second, &[("part", "plane")], Kind::Faster, 1.74),
    ];
    let sizes = records.iter().filter(|record| word(record, "part") == "sizes").map(|record| word(record, "size"));
    for size in distinct(sizes) {
        let words = format!("plane, {size}²: accesses, of the baseline's");
        claims.push(claim(&words, first, &[("part", "sizes"), ("size", size)], Kind::Accesses, 0.5));
    }
    let straight = [("part", "sizes"), ("angle", "0")];
    claims.push(claim("plane, from straight above, all sizes: times as fast", first, &straight, Kind::Faster, 1.8));
    let small = [("part", "sizes"), ("size", "32")];
    claims.push(claim("plane, 32², all angles: times as fast", first, &small, Kind::Faster, 1.5));
    claims
}

fn claimed(records: &[&Record]) -> String {
    let titles = COLUMNS.map(|(_, _, title)| title.to_owned());
    let mut table = Table::new(["claim", "paper"].map(str::to_owned).into_iter().chain(titles));
    for claim in claims(records) {
        let of: Vec<&Record> = records.iter().filter(|record| claim.is_about(record)).copied().collect();
        let all = of.iter().filter(|record| word(record, "at") == "baseline").count();
        let cell = |(start, at, _): (&str, &str, &str)| match sums(&of, claim.kind, (start, at)) {
            Some(sums) if sums.views < all => {
                format!("{} ({} of {all} views)", claim.kind.words(sums.ratio), sums.views)
            }
            Some(sums) => claim.kind.words(sums.ratio),
            None => NONE.to_owned(),
        };
        let first = [claim.words.clone(), claim.kind.words(claim.kind.as_ratio(claim.paper))];
        table.push(first.into_iter().chain(COLUMNS.map(cell)).collect());
    }
    table.render()
}

impl Claim {
    fn is_about(&self, record: &Record) -> bool {
        let over: Vec<(&str, &str)> = self.over.iter().map(|(name, value)| (*name, value.as_str())).collect();
        record.scene == self.scene && has(record, &over)
    }
}

impl Kind {
    fn cost(self, record: &Record) -> Option<f64> {
        match self {
            Self::Saved => record.height_fetches,
            Self::Accesses => fetches(record),
            Self::Faster => record.core_ns(),
        }
    }

    /// The cost over the baseline's that a figure means.
    fn as_ratio(self, figure: f64) -> f64 {
        match self {
            Self::Saved => 1.0 - figure,
            Self::Accesses => figure,
            Self::Faster => 1.0 / figure,
        }
    }

    fn words(self, ratio: f64) -> String {
        match self {
            Self::Saved if ratio > 1.0 => format!("−{}", percent(ratio - 1.0)),
            Self::Saved => percent(1.0 - ratio),
            Self::Accesses => percent(ratio),
            Self::Faster => format!("{:.2}×", 1.0 / ratio),
        }
    }
}

/// Costs summed over the views that have both.
fn sums(records: &[&Record], kind: Kind, (start, at): (&str, &str)) -> Option<Sums> {
    let found = records.iter().filter(|record| has(record, &[("start", start), ("at", at)]));
    let pairs = found.filter_map(|record| Some((kind.cost(record)?, kind.cost(baseline(records, record)?)?)));
    let pairs: Vec<(f64, f64)> = pairs.collect();
    let total = pairs.iter().fold((0.0, 0.0), |sum, pair| (sum.0 + pair.0, sum.1 + pair.1));
    (!pairs.is_empty()).then(|| Sums { ratio: total.0 / total.1, views: pairs.len() })
}

/// The baseline of the view that a record is of.
fn baseline<'a>(records: &[&'a Record], record: &Record) -> Option<&'a Record> {
    let same = |other: &&&Record| {
        let of = |name| other.setting.get(name) == record.setting.get(name);
        other.scene == record.scene && word(other, "at") == "baseline" && ["part", "size", "angle"].into_iter().all(of)
    };
    records.iter().find(same).copied()
}

/// The sphere, and the planes from every angle.
fn views(records: &[&Record]) -> String {
    let titles = COLUMNS.map(|(_, _, title)| format!("{title}: steps, RMS, accesses, time"));
    let header = ["view", "baseline: steps, RMS, tests, time"].map(str::to_owned).into_iter().chain(titles);
    let mut table = Table::new(header);
    let shown = |record: &&&Record| word(record, "at") == "baseline" && word(record, "part") != "sizes";
    for view in records.iter().filter(shown) {
        let first =
            format!("{}, {}, {}, {}", steps(view), depth(view.rms), or_none(view.height_fetches, short), time(view));
        let own: Vec<&Record> = records
            .iter()
            .filter(|record| baseline(records, record).is_some_and(|of| std::ptr::eq(of, *view)))
            .copied()
            .collect();
        let cells = COLUMNS.map(|(start, at, _)| {
            let record = own.iter().find(|record| has(record, &[("start", start), ("at", at)]))?;
            Some(format!(
                "{}, {}, {}, {}",
                steps(record),
                depth(record.rms),
                or_none(fetches(record), short),
                time(record)
            ))
        });
        let cells = cells.map(|cell| cell.unwrap_or(NONE.to_owned()));
        table.push([name(view), first].into_iter().chain(cells).collect());
    }
    table.render()
}

fn name(view: &Record) -> String {
    let angle = view.setting.get("angle").map_or(String::new(), |angle| format!(" from {angle}°"));
    format!("{}, {}², {}{angle}", word(view, "part"), word(view, "size"), relief(&view.scene))
}

fn steps(record: &Record) -> &str {
    word(record, "steps")
}

fn time(record: &Record) -> String {
    or_none(record.core_ns(), |ns| format!("{ns:.0} ns"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(words: &str, height_fetches: f64, ns: f64) -> Record {
        Record {
            setting: words.parse().unwrap(),
            scene: reliefs::PAPER[0].to_owned(),
            rms: Some(0.02),
            height_fetches: Some(height_fetches),
            table_fetches: Some(1.0),
            cpu_ns: Some(ns),
            ..Record::default()
        }
    }

    #[test]
    fn claims_stand_beside_sums_over_the_views_that_reach_an_equal_error() {
        let of = |angle: u32, start: &str, at: &str| {
            format!("part=sizes size=32 angle={angle} start={start} at={at} steps=64")
        };
        let records = vec![
            record("part=sphere size=64 start=top at=baseline steps=64", 40.0, 300.0),
            record("part=sphere size=64 start=nearest at=equal_step steps=64", 30.0, 150.0),
            record(&of(0, "top", "baseline"), 29.0, 200.0),
            record(&of(0, "nearest", "equal_step"), 9.0, 100.0),
            record(&of(0, "nearest", "equal_error"), 19.0, 400.0),
            record(&of(30, "top", "baseline"), 29.0, 200.0),
            record(&of(30, "nearest", "equal_step"), 19.0, 100.0),
        ];
        let text = render(&RecordFile { machine: "a box".to_owned(), records });
        for line in [
            "| sphere, 64²: height tests saved | 51.0 % | 25.0 % | – | – | – |\n",
            "| sphere, 64²: times as fast | 1.45× | 2.00× | – | – | – |\n",
            "| plane, 32²: accesses, of the baseline's | 50.0 % | 50.0 % | 66.7 % (1 of 2 views) | – | – |\n",
            "| plane, 32², all angles: times as fast | 1.50× | 2.00× | 0.50× (1 of 2 views) | – | – |\n",
            "| sphere, 64², pyramids | 64, 0.020, 40.0, 300 ns | 64, 0.020, 31.0, 150 ns | – | – | – |\n",
        ] {
            assert!(text.contains(line), "{line} in {text}");
        }
    }
}
