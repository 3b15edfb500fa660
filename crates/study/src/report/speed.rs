//! The table of speeds: a row for each case, a column for each method.

use super::numbers::{or_none, percent, short};
use super::promises;
use crate::markdown::Table;
use crate::{Item, Record, RecordFile};

pub(super) fn render(file: &RecordFile) -> String {
    let timed: Vec<&Record> = file.records.iter().filter(|record| record.per == Some(Item::TexelDirection)).collect();
    let methods = distinct(timed.iter().map(|record| value(record, "method").to_owned()));
    let cases = distinct(timed.iter().map(|record| case(record)));
    let mut table = Table::new(["case", "grid × azimuths"].map(str::to_owned).into_iter().chain(methods.clone()));
    for case_name in cases {
        let records: Vec<&Record> = timed.iter().copied().filter(|record| case(record) == case_name).collect();
        table.push(row(case_name, &records, &methods));
    }
    let promises = promises::table(&timed).render();
    format!("{}\n{}\n{promises}", introduction(file, &timed), table.render())
}

fn introduction(file: &RecordFile, timed: &[&Record]) -> String {
    let spreads = timed.iter().filter_map(|record| relative_spread(record));
    let most = spreads.max_by(f64::total_cmp);
    format!(
        "Million texels × directions per second of one core's time, and what part of the memory's bound that is; with several \
         threads, on the wall clock. Medians; the median absolute deviation is {} at most. Measured on {}; memory: {}.\n",
        or_none(most, percent),
        file.machine,
        bandwidths(&file.records),
    )
}

/// Each once, in the order of the first.
fn distinct<T: PartialEq>(items: impl Iterator<Item = T>) -> Vec<T> {
    items.fold(Vec::new(), |mut known, item| {
        if !known.contains(&item) {
            known.push(item);
        }
        known
    })
}

fn value<'a>(record: &'a Record, name: &str) -> &'a str {
    record.setting.get(name).unwrap_or_default()
}

/// What was varied and to what, in words. Cases of different methods are the same, even where an exact one had less to do.
fn case(record: &Record) -> String {
    match value(record, "varied") {
        "size" => format!("{} × {} texels", record.width, record.height),
        "directions" => format!("{} azimuths", value(record, "directions")),
        "distance" if value(record, "distance") == "true" => "with distances".to_owned(),
        "distance" => "without distances".to_owned(),
        "work" => work(value(record, "work")).to_owned(),
        "threads" if threads(record) == 1 => "1 thread".to_owned(),
        "threads" => format!("{} threads", threads(record)),
        _ => record.scene.replace('_', " "),
    }
}

fn work(name: &str) -> &str {
    match name {
        "map" => "map with distances",
        "bent" => "one bend's points",
        "swept" => "2 points of 5 bends",
        "sky" => "sky, its horizons given",
        other => other,
    }
}

fn threads(record: &Record) -> usize {
    value(record, "threads").parse().unwrap_or(1)
}

fn row(case: String, records: &[&Record], methods: &[String]) -> Vec<String> {
    let grid = |record: &&Record| format!("{}² × {}", record.width, value(record, "directions"));
    let grids = distinct(records.iter().map(grid)).join(", ");
    let of = |method: &String| records.iter().copied().find(|record| value(record, "method") == method);
    [case, grids].into_iter().chain(methods.iter().map(|method| cell(of(method)))).collect()
}

fn cell(record: Option<&Record>) -> String {
    let rate = record.and_then(|record| Some(1e3 / counted_ns(record)?));
    let share = record.and_then(|record| record.bandwidth_share);
    match share {
        Some(share) => format!("{} · {}", or_none(rate, short), percent(share)),
        None => or_none(rate, short),
    }
}

/// Time per item: a core's own, or with several threads the wall's, which says what they gain.
fn counted_ns(record: &Record) -> Option<f64> {
    if threads(record) == 1 { record.core_ns() } else { record.wall_ns }
}

fn relative_spread(record: &Record) -> Option<f64> {
    let spread =
        if threads(record) == 1 { record.cpu_ns_spread.or(record.wall_ns_spread) } else { record.wall_ns_spread };
    Some(spread? / counted_ns(record)?)
}

/// The better of copy and triad, for each number of threads.
fn bandwidths(records: &[Record]) -> String {
    let memory = || records.iter().filter(|record| record.technique == "memory");
    let rate = |count: &str| {
        let rates = memory().filter(|record| value(record, "threads") == count).filter_map(|record| record.wall_ns_min);
        rates.map(|ns| 1.0 / ns).max_by(f64::total_cmp)
    };
    let counts = distinct(memory().map(|record| value(record, "threads")));
    let words = |count: &&str| {
        let plural = if *count == "1" { "thread" } else { "threads" };
        format!("{} GB/s with {count} {plural}", or_none(rate(count), short))
    };
    counts.iter().map(words).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Setting;

    fn record(words: &str, width: u32, ns: f64) -> Record {
        Record {
            setting: words.parse::<Setting>().unwrap(),
            scene: "fractal_terrain".to_owned(),
            width,
            height: width,
            per: Some(Item::TexelDirection),
            cpu_ns: Some(ns),
            cpu_ns_spread: Some(0.01 * ns),
            wall_ns: Some(0.5 * ns),
            wall_ns_spread: Some(0.0),
            bandwidth_share: Some(0.025),
            ..Record::default()
        }
    }

    #[test]
    fn methods_stand_side_by_side_and_threads_by_the_wall() {
        let records = vec![
            record("method=sweep directions=8 varied=field threads=1", 64, 10.0),
            record("method=sweep directions=8 varied=threads threads=2", 64, 10.0),
            record("method=exact directions=8 varied=field threads=1", 32, 1000.0),
        ];
        let memory = crate::bandwidth::Bandwidth { threads: 1, copy: 12.5, triad: 11.0 }.records();
        let file = RecordFile { machine: "a box".to_owned(), records: [memory, records].concat() };
        let text = render(&file);
        assert!(text.contains("is 1.00 % at most. Measured on a box; memory: 12.5 GB/s with 1 thread."), "{text}");
        let table = "| case | grid × azimuths | sweep | exact |\n\
                     |---|---:|---:|---:|\n\
                     | fractal terrain | 64² × 8, 32² × 8 | 100 · 2.50 % | 1.00 · 2.50 % |\n\
                     | 2 threads | 64² × 8 | 200 · 2.50 % | – |\n";
        assert!(text.contains(table), "{text}");
    }
}
