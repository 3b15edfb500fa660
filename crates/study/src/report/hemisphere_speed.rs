//! The table of how fast hemisphere depths are baked.

use super::numbers::{or_none, short};
use super::relief_words::{find, has, word};
use crate::markdown::Table;
use crate::{Record, RecordFile};

/// Modes, in the order of the columns.
const MODES: [&str; 2] = ["nearest", "conservative"];

/// The wall's bound on the promised bake, seconds.
const PROMISE: f64 = 60.0;

pub(super) fn render(file: &RecordFile) -> String {
    let records: Vec<&Record> = file.records.iter().collect();
    let titles = ["million rays per second", "nearest", "conservative"].map(str::to_owned);
    let mut table = Table::new(titles);
    for record in records.iter().filter(|record| has(record, &[("mode", MODES[0])])) {
        let rates = MODES.map(|mode| {
            let words = ["varied", "size", "threads"].map(|name| (name, word(record, name)));
            let same: Vec<&Record> = records.iter().filter(|other| other.width == record.width).copied().collect();
            let found = find(&same, &[&words[..], &[("mode", mode)]].concat());
            or_none(found.and_then(counted_ns).map(|ns| 1e3 / ns), short)
        });
        table.push([case(record)].into_iter().chain(rates).collect());
    }
    let promised = MODES.map(|mode| {
        let found = find(&records, &[("varied", "promise"), ("mode", mode)]);
        let (wall, cores) = (found.and_then(wall_seconds), found.and_then(|record| record.bake_seconds));
        let kept = wall.map_or("", |seconds| if seconds < PROMISE { "" } else { ", which breaks the promise" });
        let words = |seconds: Option<f64>| or_none(seconds, |seconds| format!("{} s", short(seconds)));
        format!("{mode} {} ({} of all cores' time){kept}", words(wall), words(cores))
    });
    let promise = find(&records, &[("varied", "promise")]);
    let size = promise.map_or(0, |record| record.width);
    let threads = promise.map_or("", |record| word(record, "threads"));
    format!(
        "A ray is one texel of the height map in one direction; one core's time, or with several threads the wall's.\n\n{}\n\
         {size}² heights in 512 directions on {threads} threads, by the wall; less than 60 s are promised: {}. Measured on {}.\n",
        table.render(),
        promised.join(", "),
        file.machine,
    )
}

fn counted_ns(record: &Record) -> Option<f64> {
    if word(record, "threads") == "1" { record.core_ns() } else { record.wall_ns }
}

/// A record is of width × height × layers rays.
fn wall_seconds(record: &Record) -> Option<f64> {
    let layers: f64 = word(record, "layers").parse().ok()?;
    Some(1e-9 * record.wall_ns? * f64::from(record.width) * f64::from(record.height) * layers)
}

fn case(record: &Record) -> String {
    let threads = match word(record, "threads") {
        "1" => "1 thread".to_owned(),
        more => format!("{more} threads"),
    };
    let all = if word(record, "varied") == "promise" { ", all directions" } else { "" };
    format!("{}² heights to {}² depths, {threads}{all}", record.width, word(record, "size"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn modes_are_columns_and_the_promise_is_in_seconds() {
        let record = |words: &str, wall_ns| Record {
            setting: words.parse().unwrap(),
            width: 512,
            height: 512,
            cpu_ns: Some(2.0 * wall_ns),
            wall_ns: Some(wall_ns),
            bake_seconds: Some(20.0),
            ..Record::default()
        };
        let records = vec![
            record("varied=size mode=nearest size=64 threads=1", 50.0),
            record("varied=size mode=conservative size=64 threads=1", 100.0),
            record("varied=promise mode=nearest size=64 layers=512 threads=2", 50.0),
            record("varied=promise mode=conservative size=64 layers=512 threads=2", 1000.0),
        ];
        let text = render(&RecordFile { machine: "a box".to_owned(), records });
        assert!(text.contains("| 512² heights to 64² depths, 1 thread | 10.0 | 5.00 |\n"), "{text}");
        assert!(text.contains("| 512² heights to 64² depths, 2 threads, all directions | 20.0 | 1.00 |\n"), "{text}");
        assert!(
            text.contains("nearest 6.71 s (20.0 s of all cores' time), conservative 134 s (20.0 s of all cores' time), which breaks the promise."),
            "{text}"
        );
    }
}
