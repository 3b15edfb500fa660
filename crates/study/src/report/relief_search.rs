//! The table of all methods on all reliefs, what follows from it, and its charts.

use super::numbers::{NONE, distinct, or_none, percent, short};
use super::relief_words::{depth, fetches, fetches_apart, find, relief, title, word};
use crate::chart::{Curve, Legend, LineChart};
use crate::markdown::Table;
use crate::relief_method::{Feed, Method, Search};
use crate::{Record, RecordFile, StudyError};

/// Of each relief that is charted: mean fetches over the angle, and errors over fetches.
const CHARTS: [(&str, [&str; 2]); 2] = [
    ("fractal", ["relief_fetches_fractal", "relief_error_fractal"]),
    ("spikes", ["relief_fetches_spikes", "relief_error_spikes"]),
];

/// The methods of the charts over the angle.
const CURVES: [Method; 6] = [
    Method { search: Search::Linear, feed: Feed::Top },
    Method { search: Search::Linear, feed: Feed::Conservative },
    Method { search: Search::Cones, feed: Feed::Top },
    Method { search: Search::Cones, feed: Feed::Conservative },
    Method { search: Search::MaximumMip, feed: Feed::Top },
    Method { search: Search::MaximumMip, feed: Feed::Conservative },
];

/// How a start fails, as records and as the table have it.
const FAULTS: [(&str, &str); 3] = [
    ("overshoot", "behind the hit"),
    ("tunnel", "out of the relief again"),
    ("wrong_way_back", "led back to a wrong hit"),
];

pub(super) fn render(file: &RecordFile) -> String {
    let records = searches(file);
    let tables: Vec<String> = reliefs(&records).into_iter().map(|name| table(&on(&records, name), name)).collect();
    let samples = records.first().and_then(|record| record.samples).unwrap_or_default();
    format!(
        "Per view elevation: RMS and maximum error of the hit's depth, parts of the relief's thickness, and the share of rays that pass \
         their hit by more than a hundredth of it; mean fetches of heights + of tables, and nanoseconds per ray on one core. {samples} \
         rays each. Bytes per texel are those of the tables beside the height map, compact; bakes are of one core. Measured on {}.\n\n\
         {}\n{}\n{}",
        file.machine,
        tables.join("\n"),
        best(&records),
        faults(file),
    )
}

pub(super) fn charts(file: &RecordFile) -> Result<Vec<(&'static str, String)>, StudyError> {
    let mut charts = Vec::new();
    for (scene, [over_angle, over_fetches]) in CHARTS {
        charts.push((over_angle, fetches_over_angle(&on(&searches(file), scene), scene).svg()?));
        charts.push((over_fetches, error_over_fetches(file, scene).svg()?));
    }
    Ok(charts)
}

fn searches(file: &RecordFile) -> Vec<&Record> {
    file.records.iter().filter(|record| record.technique == "relief_search").collect()
}

fn reliefs<'a>(records: &[&'a Record]) -> Vec<&'a str> {
    distinct(records.iter().map(|record| record.scene.as_str()))
}

fn on<'a>(records: &[&'a Record], scene: &str) -> Vec<&'a Record> {
    records.iter().filter(|record| record.scene == scene).copied().collect()
}

fn elevations<'a>(records: &[&'a Record]) -> Vec<&'a str> {
    distinct(records.iter().map(|record| word(record, "elevation")))
}

/// The record of a method at an elevation.
fn of<'a>(records: &[&'a Record], method: Method, elevation: &str) -> Option<&'a Record> {
    let words = [("search", method.search.name()), ("start", method.feed.name()), ("elevation", elevation)];
    find(records, &words)
}

fn table(records: &[&Record], scene: &str) -> String {
    let elevations = elevations(records);
    let per_elevation = elevations.iter().flat_map(|elevation| [format!("{elevation}°: error"), "cost".to_owned()]);
    let weights = ["bytes per texel", "bake"].map(str::to_owned);
    let mut table = Table::new([relief(scene)].into_iter().chain(per_elevation).chain(weights));
    for method in Method::all() {
        let found: Vec<Option<&Record>> = elevations.iter().map(|elevation| of(records, method, elevation)).collect();
        let Some(any) = found.iter().flatten().next() else { continue };
        let cells =
            found.iter().flat_map(|record| record.map_or([NONE; 2].map(str::to_owned), |r| [error(r), cost(r)]));
        table.push([title(method)].into_iter().chain(cells).chain(weight(any)).collect());
    }
    table.render()
}

fn error(record: &Record) -> String {
    format!("{}, {}, {}", depth(record.rms), depth(record.max), or_none(record.wrong_share, percent))
}

fn cost(record: &Record) -> String {
    format!("{}, {}", fetches_apart(record), nanoseconds(record))
}

fn nanoseconds(record: &Record) -> String {
    or_none(record.core_ns(), |ns| format!("{ns:.0} ns"))
}

fn weight(record: &Record) -> [String; 2] {
    let texels = f64::from(record.width) * f64::from(record.height);
    let bytes = record.bytes.map(|bytes| bytes as f64 / texels);
    [or_none(bytes, short), or_none(record.bake_seconds, |seconds| format!("{} s", short(seconds)))]
}

/// A method that cannot miss, and its record.
type Safe<'a> = (Method, &'a Record);

/// What cannot miss, on one relief at one elevation.
fn safe<'a>(records: &[&'a Record], elevation: &str) -> Vec<Safe<'a>> {
    let proven = Method::all()
        .filter(|method| matches!(method.search, Search::Cones | Search::MaximumMip) && method.feed != Feed::Nearest);
    proven.filter_map(|method| Some((method, of(records, method, elevation)?))).collect()
}

fn least<'a>(safe: &[Safe<'a>], cost: impl Fn(&Record) -> Option<f64>) -> Option<Safe<'a>> {
    let costs = safe.iter().filter_map(|(method, record)| Some((cost(record)?, (*method, *record))));
    costs.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, safe)| safe)
}

/// The best of what cannot miss, and where that is without hemisphere depths.
fn best(records: &[&Record]) -> String {
    let elevations = elevations(records);
    let header =
        elevations.iter().flat_map(|elevation| [format!("{elevation}°: fewest fetches"), "least time".to_owned()]);
    let mut table = Table::new(["of what cannot miss".to_owned()].into_iter().chain(header));
    let (mut fewer, mut faster) = (Vec::new(), Vec::new());
    for scene in reliefs(records) {
        let mut row = vec![relief(scene)];
        for elevation in &elevations {
            let safe = safe(&on(records, scene), elevation);
            let view = format!("{} at {elevation}°", relief(scene));
            let (fewest, fastest) = (least(&safe, fetches), least(&safe, Record::core_ns));
            row.push(fewest.map_or(NONE.to_owned(), |(method, record)| {
                format!("{} {}", title(method), or_none(fetches(record), short))
            }));
            row.push(
                fastest
                    .map_or(NONE.to_owned(), |(method, record)| format!("{} {}", title(method), nanoseconds(record))),
            );
            fewer.extend(without_hemisphere(fewest).map(|_| view.clone()));
            faster.extend(without_hemisphere(fastest).map(|_| view));
        }
        table.push(row);
    }
    let list = |views: &[String]| if views.is_empty() { "nowhere".to_owned() } else { views.join(", ") };
    format!(
        "{}\nA cone map or a maximum mip alone beats both of them from conservative depths in fetches {}; in time {}.\n",
        table.render(),
        in_words(&list(&fewer)),
        in_words(&list(&faster)),
    )
}

fn without_hemisphere(best: Option<Safe<'_>>) -> Option<Method> {
    best.map(|(method, _)| method).filter(|method| method.feed == Feed::Top)
}

fn in_words(list: &str) -> String {
    if list == "nowhere" { list.to_owned() } else { format!("on {list}") }
}

/// What becomes of starts at any angle that maps have.
fn faults(file: &RecordFile) -> String {
    let records: Vec<&Record> = file.records.iter().filter(|record| record.technique == "start_faults").collect();
    let starts = [(Feed::Nearest, "nearest"), (Feed::Conservative, "conservative")];
    let titles = starts.iter().flat_map(|(_, name)| FAULTS.map(|(_, words)| format!("{name}: {words}")));
    let mut table = Table::new(["starts up to 80° from the normal".to_owned()].into_iter().chain(titles));
    for scene in reliefs(&records) {
        let cells = starts.iter().flat_map(|(feed, _)| {
            FAULTS.map(|(fault, _)| {
                let found = find(&on(&records, scene), &[("start", feed.name()), ("fault", fault)]);
                or_none(found.and_then(|record| record.wrong_share), percent)
            })
        });
        table.push([relief(scene)].into_iter().chain(cells).collect());
    }
    table.render()
}

fn fetches_over_angle(records: &[&Record], scene: &str) -> LineChart {
    let elevations = elevations(records);
    let curve = |method: Method| {
        let point = |elevation: &&str| {
            let angle = 90.0 - elevation.parse::<f64>().ok()?;
            Some((angle, fetches(of(records, method, elevation)?)?))
        };
        Curve { name: title(method), points: elevations.iter().filter_map(point).collect() }
    };
    LineChart {
        title: format!("Mean fetches per ray: {}", relief(scene)),
        across: "angle from the normal, °".to_owned(),
        up: "fetches of heights and tables".to_owned(),
        curves: CURVES.map(curve).into(),
        legend: Legend::Above,
    }
}

/// Linear searches by their steps; what is exact is a point on the axis.
fn error_over_fetches(file: &RecordFile, scene: &str) -> LineChart {
    let sweep: Vec<&Record> = file.records.iter().filter(|record| record.technique == "relief_sweep").collect();
    let sweep = on(&sweep, scene);
    let elevation = elevations(&sweep).first().copied().unwrap_or_default();
    let curve = |method: Method| {
        let words = [("search", method.search.name()), ("start", method.feed.name())];
        let of = sweep.iter().filter(|record| super::relief_words::has(record, &words));
        Curve { name: title(method), points: of.filter_map(|record| Some((fetches(record)?, record.rms?))).collect() }
    };
    let methods = Method::all().map(curve).filter(|curve| !curve.points.is_empty());
    LineChart {
        title: format!("Error against fetches: {} at {elevation}°", relief(scene)),
        across: "mean fetches of heights and tables per ray".to_owned(),
        up: "RMS error of depth".to_owned(),
        curves: methods.collect(),
        legend: Legend::UpperRight,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(words: &str, wrong_share: f64, fetches: f64, ns: f64) -> Record {
        Record {
            technique: "relief_search".to_owned(),
            setting: words.parse().unwrap(),
            scene: "white_noise".to_owned(),
            width: 16,
            height: 16,
            wrong_share: Some(wrong_share),
            rms: Some(0.02),
            max: Some(1e-4),
            height_fetches: Some(fetches),
            table_fetches: Some(1.0),
            cpu_ns: Some(ns),
            bytes: Some(512),
            bake_seconds: Some(1.5),
            ..Record::default()
        }
    }

    fn file() -> RecordFile {
        let faults =
            Record { technique: "start_faults".to_owned(), ..record("start=nearest fault=tunnel", 0.25, 0.0, 0.0) };
        let sweep = |words| Record {
            technique: "relief_sweep".to_owned(),
            scene: "fractal".to_owned(),
            ..record(words, 0.0, 4.0, 9.0)
        };
        let records = vec![
            record("search=linear start=top elevation=20", 0.02, 1.0, 5.0),
            record("search=cone_steps start=top elevation=20", 0.0, 9.0, 50.0),
            record("search=cone_steps start=conservative elevation=20", 0.0, 3.0, 60.0),
            faults,
            sweep("search=linear start=top elevation=20 steps=8"),
            sweep("search=linear start=top elevation=20 steps=16"),
        ];
        RecordFile { machine: "a box".to_owned(), records }
    }

    #[test]
    fn methods_are_rows_and_elevations_have_two_columns() {
        let text = render(&file());
        for line in [
            "| white noise | 20°: error | cost | bytes per texel | bake |\n",
            "| linear + bisection | 0.020, 1e-4, 2.00 % | 1.0 + 1.0, 5 ns | 2.00 | 1.50 s |\n",
            "| cone steps | 0.020, 1e-4, 0.00 % | 9.0 + 1.0, 50 ns | 2.00 | 1.50 s |\n",
            "| white noise | – | 25.0 % | – | – | – | – |\n",
        ] {
            assert!(text.contains(line), "{line} in {text}");
        }
    }

    #[test]
    fn the_best_is_of_what_cannot_miss_and_where_no_hemisphere_is_needed_is_said() {
        let text = render(&file());
        assert!(text.contains("| white noise | conservative depths, cone steps 4.00 | cone steps 50 ns |\n"), "{text}");
        assert!(text.contains("in fetches nowhere; in time on white noise at 20°."), "{text}");
    }

    #[test]
    fn errors_are_charted_over_fetches() {
        let chart = error_over_fetches(&file(), "fractal");
        assert_eq!(chart.curves.len(), 1);
        assert_eq!(chart.curves[0].points, [(5.0, 0.02), (5.0, 0.02)]);
        assert_eq!(charts(&file()).unwrap().len(), 4);
    }
}
