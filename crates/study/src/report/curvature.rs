//! The tables of curved bases: how far each way of reading is off, on each relief; and what encodings cost.

use super::numbers::{NONE, degrees, distinct, mean, or_none, short};
use crate::markdown::Table;
use crate::{Record, RecordFile};

/// The columns: how points are read, how many, in words.
const COLUMNS: [(&str, &str, &str); 6] = [
    ("flat", "1", "flat map"),
    ("paper", "1", "paper"),
    ("exact", "1", "K = 1"),
    ("exact", "2", "K = 2"),
    ("exact", "3", "K = 3"),
    ("exact", "4", "K = 4"),
];

/// The rows of either range. The flat base is left to the records, where every reading is right, and the steepest hollow,
/// where one point is all wrong and any further one right.
fn is_shown(range: (&str, &str), curvature: &str) -> bool {
    if range.0 == "0" { curvature != "0" } else { ["-0.005", "0.015"].contains(&curvature) }
}

/// The encoding of the first tables.
const EXACT: &str = "f32";

pub(super) fn render(file: &RecordFile) -> String {
    let ranges = distinct(file.records.iter().map(|record| (value(record, "range_min"), value(record, "range_max"))));
    let tables: Vec<String> = ranges.iter().map(|range| of_range(*range, &file.records)).collect();
    format!("{}\n{}", tables.join("\n"), encodings(&file.records))
}

fn of_range(range: (&str, &str), records: &[Record]) -> String {
    let records: Vec<&Record> = records.iter().filter(|record| is_of(record, range)).collect();
    let titles = COLUMNS.iter().map(|(.., title)| (*title).to_owned());
    let mut table = Table::new(["relief, κ".to_owned()].into_iter().chain(titles));
    let shown = records.iter().filter(|record| is_shown(range, value(record, "curvature")));
    let rows = distinct(shown.map(|record| (record.scene.as_str(), value(record, "curvature"))));
    for (scene, curvature) in rows {
        let rms = |(method, points, _): &(&str, &str, &str)| {
            let is = |record: &&&Record| {
                record.scene == scene
                    && value(record, "curvature") == curvature
                    && reads(record, method, points)
                    && value(record, "encoding") == EXACT
            };
            or_none(records.iter().find(is).and_then(|record| record.rms), degrees)
        };
        let name = format!("{}, {}", scene.replace('_', " "), curvature.replace('-', "−"));
        table.push([name].into_iter().chain(COLUMNS.iter().map(rms)).collect());
    }
    let (min, max) = (range.0.replace('-', "−"), range.1);
    format!("Baked for κ from {min} to {max}:\n\n{}", table.render())
}

/// A row per number of points, a column per encoding: bytes, and the error over all reliefs and curvatures of the first
/// range.
fn encodings(records: &[Record]) -> String {
    let Some(first) = records.first() else { return String::new() };
    let range = (value(first, "range_min"), value(first, "range_max"));
    let records: Vec<&Record> = records.iter().filter(|record| is_of(record, range)).collect();
    let exact = |record: &&Record| value(record, "method") == "exact" && record.bytes.is_some();
    let kept: Vec<&Record> = records.into_iter().filter(exact).collect();
    let names = distinct(kept.iter().map(|record| value(record, "encoding")));
    let title = format!("κ from {} to {}", range.0, range.1);
    let mut table = Table::new([title].into_iter().chain(names.iter().map(|name| (*name).to_owned())));
    for points in distinct(kept.iter().map(|record| value(record, "points"))) {
        let cell = |encoding: &&str| {
            let is = |record: &&&Record| value(record, "points") == points && value(record, "encoding") == *encoding;
            let cell: Vec<&Record> = kept.iter().filter(is).copied().collect();
            let squares: Vec<f64> = cell.iter().filter_map(|record| record.rms).map(|rms| rms * rms).collect();
            let rms = or_none(mean(&squares).map(f64::sqrt), degrees);
            let bytes = cell.first().and_then(|record| bytes_per_direction(record));
            format!("{rms}, {}", or_none(bytes, |bytes| format!("{} B", short_count(bytes))))
        };
        table.push([format!("K = {points}")].into_iter().chain(names.iter().map(cell)).collect());
    }
    format!("RMS over all of them, and bytes per texel and direction:\n\n{}", table.render())
}

fn short_count(number: f64) -> String {
    if number.fract() == 0.0 { format!("{number}") } else { short(number) }
}

fn bytes_per_direction(record: &Record) -> Option<f64> {
    let directions: f64 = value(record, "directions").parse().ok()?;
    Some(record.bytes? as f64 / (f64::from(record.width) * f64::from(record.height) * directions))
}

fn value<'a>(record: &'a Record, name: &str) -> &'a str {
    record.setting.get(name).unwrap_or(NONE)
}

fn is_of(record: &Record, range: (&str, &str)) -> bool {
    (value(record, "range_min"), value(record, "range_max")) == range
}

fn reads(record: &Record, method: &str, points: &str) -> bool {
    value(record, "method") == method && value(record, "points") == points
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(range_min: &str, curvature: &str, read: &str, rms: f64) -> Record {
        let words = format!("range_min={range_min} range_max=0.015 curvature={curvature} directions=2 {read}");
        Record {
            setting: words.parse().unwrap(),
            scene: "reptile_skin".to_owned(),
            width: 4,
            height: 2,
            rms: Some(rms),
            bytes: Some(64),
            ..Record::default()
        }
    }

    #[test]
    fn reliefs_are_rows_and_encodings_a_table_of_their_own() {
        let exact = |points: u32, encoding: &str| format!("method=exact points={points} encoding={encoding}");
        let records = vec![
            record("0", "0.015", "method=flat points=1 encoding=f32", 5.0),
            record("0", "0.015", &exact(2, "f32"), 0.03),
            record("0", "0.015", &exact(2, "u8"), 0.3),
            record("0", "0.005", &exact(2, "u8"), 0.4),
            record("-0.015", "-0.015", &exact(2, "f32"), 7.0),
            record("-0.015", "-0.005", &exact(2, "f32"), 0.02),
        ];
        let text = render(&RecordFile { machine: String::new(), records });
        let header =
            "| relief, κ | flat map | paper | K = 1 | K = 2 | K = 3 | K = 4 |\n|---|---:|---:|---:|---:|---:|---:|\n";
        let convex = "| reptile skin, 0.015 | 5.00° | – | – | 0.030° | – | – |\n\
                      | reptile skin, 0.005 | – | – | – | – | – | – |\n";
        let both = "| reptile skin, −0.005 | – | – | – | 0.020° | – | – |\n";
        let encodings = "| κ from 0 to 0.015 | f32 | u8 |\n|---|---:|---:|\n| K = 2 | 0.030°, 4 B | 0.354°, 4 B |\n";
        assert_eq!(
            text,
            format!(
                "Baked for κ from 0 to 0.015:\n\n{header}{convex}\nBaked for κ from −0.015 to 0.015:\n\n{header}{both}\n\
                 RMS over all of them, and bytes per texel and direction:\n\n{encodings}"
            )
        );
    }
}
