//! The table of all methods on all reliefs, what follows from it, and the charts of it.

use super::numbers::{NONE, distinct, mean, or_none, percent, short};
use super::relief_words::{depth, fetches, fetches_apart, find, relief, title, word};
use crate::chart::{Curve, LineChart};
use crate::markdown::Table;
use crate::relief_method::{Feed, Method, Search};
use crate::relief_search::STEPS_STUDY;
use crate::{Record, RecordFile, StudyError};

pub(super) fn render(file: &RecordFile) -> String {
    let records: Vec<&Record> = file.records.iter().filter(|record| record.technique == "relief_search").collect();
    let tables = reliefs(&records).into_iter().map(|name| table(&on(&records, name), name));
    let samples = records.first().and_then(|record| record.samples).unwrap_or_default();
    format!(
        "Per view elevation: RMS and maximum error of the depth of the hit, as parts of the relief's thickness, and the share of \
         features missed; mean fetches of heights + of tables, and nanoseconds per ray on one core. {samples} rays each. Bytes per \
         texel are those of the tables beside the height map, in the compact encoding; bakes are in seconds of one core. Measured \
         on {}.\n\n{}\n{}",
        file.machine,
        tables.collect::<Vec<_>>().join("\n"),
        verdict(&records)
    )
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

/// The methods there are records of, in the order of the docs.
fn methods(records: &[&Record]) -> Vec<Method> {
    let elevations = elevations(records);
    Method::all().filter(|method| elevations.iter().any(|elevation| of(records, *method, elevation).is_some())).collect()
}

fn table(records: &[&Record], scene: &str) -> String {
    let elevations = elevations(records);
    let per_elevation = elevations.iter().flat_map(|elevation| [format!("{elevation}°: error"), "cost".to_owned()]);
    let header = [relief(scene)].into_iter().chain(per_elevation);
    let mut table = Table::new(header.chain(["bytes per texel", "bake"].map(str::to_owned)));
    for method in methods(records) {
        let found: Vec<Option<&Record>> = elevations.iter().map(|elevation| of(records, method, elevation)).collect();
        let cells = found.iter().flat_map(|record| record.map_or([NONE; 2].map(str::to_owned), |r| [error(r), cost(r)]));
        let first = found.iter().flatten().next();
        table.push([title(method)].into_iter().chain(cells).chain(first.map_or_else(Default::default, |r| weight(r))).collect());
    }
    table.render()
}

fn error(record: &Record) -> String {
    format!("{}, {}, {}", depth(record.rms), depth(record.max), or_none(record.wrong_share, percent))
}

fn cost(record: &Record) -> String {
    format!("{}, {} ns", fetches_apart(record), or_none(record.core_ns(), |ns| format!("{ns:.0}")))
}

fn weight(record: &Record) -> [String; 2] {
    let texels = f64::from(record.width) * f64::from(record.height);
    let bytes = record.bytes.map(|bytes| bytes as f64 / texels);
    [or_none(bytes, short), or_none(record.bake_seconds, |seconds| format!("{} s", short(seconds)))]
}
