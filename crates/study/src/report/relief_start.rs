//! The tables of starts: what they save beside the experiment, and what size, encoding, directions and safety do.

use super::numbers::{distinct, or_none, percent, short};
use super::relief_words::{fetches, find, relief, word};
use crate::markdown::Table;
use crate::{Record, RecordFile};

/// The reliefs whose fetches are shown.
const SHOWN: [&str; 2] = ["fractal", "spikes"];

/// The searches that go on from tables, as records and as the table have them.
const SEARCHES: [(&str, &str); 2] = [("cone_steps", "cone steps"), ("maximum_mip", "maximum mip")];

/// Mean fetches at 10, 35, 60 and 75°.
type Fetched = [f64; 4];

/// What an early experiment found on other reliefs of these kinds.
const EXPERIMENT: [(&str, [(&str, Fetched); 2]); 2] = [
    (
        "fractal",
        [("conservative depths, cone steps", [3.9, 6.7, 16.0, 54.0]), ("cone steps", [14.0, 48.0, 108.0, 203.0])],
    ),
    ("spikes", [("conservative depths, cone steps", [3.1, 7.1, 20.0, 49.0]), ("cone steps", [6.7, 17.0, 33.0, 60.0])]),
];

/// The table that others differ from by one thing.
const DEFAULT: [(&str, &str); 6] = [
    ("mode", "conservative"),
    ("size", "64"),
    ("rings", "32"),
    ("azimuths", "16"),
    ("spacing", "squared_tangents"),
    ("encoding", "compact"),
];

/// The experiment's directions.
const ITS_GRID: [(&str, &str); 6] = [
    ("mode", "conservative"),
    ("size", "64"),
    ("rings", "16"),
    ("azimuths", "32"),
    ("spacing", "squared_tangents"),
    ("encoding", "compact"),
];

pub(super) fn render(file: &RecordFile) -> String {
    let records: Vec<&Record> = file.records.iter().collect();
    format!("{}\n{}\n{}", saved(&records), varied(&records), overshoots(&records))
}

fn angles<'a>(records: &[&'a Record]) -> Vec<&'a str> {
    distinct(records.iter().map(|record| word(record, "angle")))
}

/// Records of one technique on one relief.
fn of<'a>(records: &[&'a Record], technique: &str, scene: &str) -> Vec<&'a Record> {
    records.iter().filter(|record| record.technique == technique && record.scene == scene).copied().collect()
}

fn saved(records: &[&Record]) -> String {
    let angles = angles(records);
    let titles = angles.iter().map(|angle| format!("{angle}°"));
    let mut table = Table::new(["mean fetches, angle from the normal".to_owned()].into_iter().chain(titles));
    for scene in SHOWN {
        let mut push = |name: String, cell: &dyn Fn(usize, &str) -> String| {
            let cells = angles.iter().enumerate().map(|(index, angle)| cell(index, angle));
            table.push([format!("{scene}: {name}")].into_iter().chain(cells).collect());
        };
        let (searches, starts) = (of(records, "relief_search", scene), of(records, "relief_start", scene));
        let at = |words: &[(&str, &str)], search: &str, angle: &str| {
            let words = [words, &[("search", search), ("angle", angle)]].concat();
            or_none(find(&searches, &words).and_then(fetches), short)
        };
        for (search, name) in SEARCHES {
            push(format!("conservative depths, {name}"), &|_, angle| at(&DEFAULT, search, angle));
            push(format!("conservative depths of 16 × 32, {name}"), &|_, angle| at(&ITS_GRID, search, angle));
        }
        for (search, name) in SEARCHES.into_iter().chain([("linear", "64 linear steps, bisection")]) {
            push(name.to_owned(), &|_, angle| at(&[("mode", "top")], search, angle));
        }
        for (name, found) in EXPERIMENT.iter().filter(|(of, _)| *of == scene).flat_map(|(_, rows)| rows) {
            push(format!("the experiment's {name}"), &|index, _| or_none(found.get(index).copied(), short));
        }
        let mean = |words: &[(&str, &str)], angle: &str| {
            let words = [words, &[("angle", angle)]].concat();
            or_none(find(&starts, &words).and_then(|record| record.mean), |depth| format!("{depth:.3}"))
        };
        push("depth of the start, of the hit".to_owned(), &|_, angle| {
            format!("{}, {}", mean(&DEFAULT, angle), mean(&[("mode", "true")], angle))
        });
    }
    table.render()
}

/// A row for each table: what differs from the default, bytes, fetches on the shown reliefs, and what is wrong.
fn varied(records: &[&Record]) -> String {
    let titles = SHOWN.map(|scene| format!("{scene}: fetches"));
    let last = ["starts behind the hit", "hits missed"].map(str::to_owned);
    let header = ["table", "MB"].map(str::to_owned).into_iter().chain(titles).chain(last);
    let mut table = Table::new(header);
    let angles = angles(records);
    // The first relief shown has all tables, the others but the largest.
    let tables = records.iter().filter(|record| record.setting.get("size").is_some() && record.scene == SHOWN[0]);
    for name in distinct(tables.map(|record| table_of(record))) {
        let own: Vec<&Record> = records.iter().filter(|record| table_of(record) == name).copied().collect();
        let bytes = own.first().and_then(|record| record.bytes);
        let fetched = SHOWN.map(|scene| {
            let searches = of(&own, "relief_search", scene);
            let cells = angles.iter().map(|angle| {
                or_none(find(&searches, &[("search", "maximum_mip"), ("angle", angle)]).and_then(fetches), short)
            });
            cells.collect::<Vec<_>>().join(" / ")
        });
        let wrong = ["relief_start", "relief_search"].map(|technique| {
            let shares = own.iter().filter(|record| record.technique == technique);
            or_none(super::numbers::mean(&shares.filter_map(|record| record.wrong_share).collect::<Vec<_>>()), percent)
        });
        let megabytes = or_none(bytes.map(|bytes| bytes as f64 / 1e6), short);
        let title = own.first().map_or_else(String::new, |record| title(record));
        table.push([title, megabytes].into_iter().chain(fetched).chain(wrong).collect());
    }
    format!(
        "By maximum mips from 32 × 16 directions in squared tangents, 64² and compact unless said, fetches at {}°; wrong shares are over \
         all angles and five reliefs (256²: these two):\n\n{}",
        angles.join(" / "),
        table.render()
    )
}

/// The words of a record's setting that say which table it is of.
fn table_of(record: &Record) -> String {
    record.setting.without("angle").without("search").to_string()
}

fn title(record: &Record) -> String {
    let mut words = vec![word(record, "mode").to_owned(), format!("{}²", word(record, "size"))];
    let grid = (word(record, "rings"), word(record, "azimuths"));
    if grid != ("32", "16") {
        words.push(format!("{} × {}", grid.0, grid.1));
    }
    if word(record, "spacing") != "squared_tangents" {
        words.push(relief(word(record, "spacing")));
    }
    if word(record, "encoding") != "compact" {
        words.push(word(record, "encoding").to_owned());
    }
    words.join(", ")
}

/// Starts of all conservative tables, and how many are behind the hit.
fn overshoots(records: &[&Record]) -> String {
    let words = [("mode", "conservative")];
    let starts = records.iter().filter(|record| record.technique == "relief_start");
    let starts = starts.filter(|record| super::relief_words::has(record, &words));
    let count = |record: &&Record| {
        let samples = record.samples.unwrap_or_default();
        (samples, (record.wrong_share.unwrap_or(1.0) * samples as f64).round() as u64)
    };
    let (all, behind) = starts.map(count).fold((0, 0), |sum, next| (sum.0 + next.0, sum.1 + next.1));
    format!("Of {all} rays that conservative depths started, {behind} began behind their hit.\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(technique: &str, words: &str, mean: f64, wrong_share: f64) -> Record {
        Record {
            technique: technique.to_owned(),
            setting: words.parse().unwrap(),
            scene: "fractal".to_owned(),
            samples: Some(1000),
            mean: Some(mean),
            wrong_share: Some(wrong_share),
            height_fetches: Some(2.0),
            table_fetches: Some(1.5),
            bytes: Some(2_000_000),
            ..Record::default()
        }
    }

    #[test]
    fn tables_name_what_differs_and_overshoots_are_counted() {
        let default =
            "mode=conservative size=64 rings=32 azimuths=16 spacing=squared_tangents encoding=compact angle=10";
        let nearest = "mode=nearest size=16 rings=16 azimuths=32 spacing=equal_angles encoding=f16 angle=10";
        let records = vec![
            record("relief_start", "mode=true angle=10", 0.5, 0.0),
            record("relief_start", default, 0.25, 0.003),
            record("relief_search", &format!("{default} search=cone_steps"), 0.0, 0.0),
            record("relief_search", &format!("{default} search=maximum_mip"), 0.0, 0.0),
            record("relief_search", &format!("{nearest} search=maximum_mip"), 0.0, 0.02),
        ];
        let text = render(&RecordFile { machine: String::new(), records });
        for line in [
            "| fractal: conservative depths, cone steps | 3.50 |\n",
            "| fractal: the experiment's cone steps | 14.0 |\n",
            "| fractal: depth of the start, of the hit | 0.250, 0.500 |\n",
            "| conservative, 64² | 2.00 | 3.50 | – | 0.30 % | 0.00 % |\n",
            "| nearest, 16², 16 × 32, equal angles, f16 | 2.00 | 3.50 | – | – | 2.00 % |\n",
            "Of 1000 rays that conservative depths started, 3 began behind their hit.\n",
        ] {
            assert!(text.contains(line), "{line} in {text}");
        }
    }
}
