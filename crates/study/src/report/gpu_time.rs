//! The tables of what techniques cost on GPUs: a row for each technique, a column for each GPU and way to interpolate.

use super::gpu_words::{devices, introduction, of_device};
use super::numbers::{NONE, distinct, or_none, percent, short};
use super::relief_words::{find, has, word};
use crate::gpu_cases::ANGLES;
use crate::markdown::Table;
use crate::relief_method::{Feed, Search};
use crate::{Record, RecordFile};

/// Ways to interpolate, in the order of the columns.
const SAMPLINGS: [&str; 2] = ["filtered", "loaded"];

/// Where searches start, and how the table says it.
const STARTS: [(Feed, &str); 2] = [(Feed::Top, "top"), (Feed::Conservative, "depths")];

pub(super) fn render(file: &RecordFile) -> String {
    let devices = devices(&file.records);
    let gpus = devices.iter().map(|device| said_of(device, &of_device(&file.records, device)));
    let gpus = gpus.collect::<Vec<_>>().join("\n");
    format!("{gpus}\n{}\n{}", places(file, &devices), relief(file, &devices))
}

fn said_of(device: &str, records: &[&Record]) -> String {
    let pixels = records.first().map_or("", |record| word(record, "pixels"));
    let spread = records.iter().filter_map(|record| Some(record.gpu_ns_spread? / record.gpu_ns?));
    let spread = or_none(spread.max_by(f64::total_cmp), percent);
    let clock = match records.iter().all(|record| record.gpu_ns.is_none()) {
        true => "It has no clock of its own, so nothing is said".to_owned(),
        false => format!("The median absolute deviation is {spread} at most"),
    };
    format!("{} {pixels}² pixels. {clock}.\n", introduction(device, records))
}

/// All but relief: of a place, or of a place and a light.
fn places(file: &RecordFile, devices: &[&str]) -> String {
    let columns = || devices.iter().flat_map(|device| SAMPLINGS.map(|sampling| (*device, sampling)));
    let titles = columns().map(|(device, sampling)| format!("{}: {sampling}", short_name(device)));
    let mut table = Table::new(["ns per pixel".to_owned()].into_iter().chain(titles));
    let of_places = file.records.iter().filter(|record| !record.technique.starts_with("relief"));
    for row in distinct(of_places.map(technique)) {
        let cells = columns().map(|(device, sampling)| {
            let same = of_device(&file.records, device).into_iter().filter(|record| technique(record) == row);
            let same: Vec<&Record> = same.collect();
            let any = if same.len() == 1 { same.first().copied() } else { None };
            cell(find(&same, &[("sampling", sampling)]).or(any))
        });
        table.push([row.clone()].into_iter().chain(cells).collect());
    }
    table.render()
}

/// Relief: a column for each start and angle, and for its shadow.
fn relief(file: &RecordFile, devices: &[&str]) -> String {
    let mut titles = vec!["ns per pixel".to_owned()];
    for device in devices {
        let looked = ANGLES.map(|angle| STARTS.map(|(_, start)| format!("{}: {start}, {angle}°", short_name(device))));
        titles.extend(looked.into_iter().flatten());
        titles.extend(STARTS.map(|(_, start)| format!("{}: {start}, with shadow, {}°", short_name(device), ANGLES[0])));
    }
    let mut table = Table::new(titles);
    for search in Search::ALL {
        let mut row = vec![search.name().replace('_', " ")];
        for device in devices {
            let records = of_device(&file.records, device);
            for (technique, angle) in
                ANGLES.map(|angle| ("relief", angle)).into_iter().chain([("relief_shadow", ANGLES[0])])
            {
                row.extend(STARTS.map(|(feed, _)| {
                    let angle = angle.to_string();
                    let words = [("search", search.name()), ("start", feed.name()), ("angle", &angle)];
                    let is_it = |record: &&&Record| record.technique == technique && has(record, &words);
                    both(&records.iter().filter(is_it).copied().collect::<Vec<_>>())
                }));
            }
        }
        table.push(row);
    }
    table.render()
}

/// Filtered and loaded where they differ.
fn both(records: &[&Record]) -> String {
    match records {
        [] => NONE.to_owned(),
        [one] => cell(Some(one)),
        _ => SAMPLINGS.map(|sampling| cell(find(records, &[("sampling", sampling)]))).join(" · "),
    }
}

fn cell(record: Option<&Record>) -> String {
    or_none(record.and_then(|record| record.gpu_ns), short)
}

/// What was timed, in words.
fn technique(record: &Record) -> String {
    let name = record.technique.replace('_', " ");
    match (record.technique.as_str(), word(record, "points")) {
        ("horizon_shadow", _) => format!("{name}, {}", word(record, "encoding")),
        ("curved_shadow", points) => format!("{name}, K = {points}"),
        _ => name,
    }
}

/// A GPU's name without what follows in brackets.
fn short_name(device: &str) -> &str {
    device.split(" (").next().unwrap_or(device)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Setting;

    fn record(device: &str, technique: &str, words: &str, ns: Option<f64>) -> Record {
        Record {
            technique: technique.to_owned(),
            setting: format!("{words} pixels=512").parse::<Setting>().unwrap(),
            device: Some(device.to_owned()),
            is_software: Some(device.starts_with("llvmpipe")),
            gpu_ns: ns,
            gpu_ns_spread: ns.map(|ns| 0.01 * ns),
            ..Record::default()
        }
    }

    #[test]
    fn gpus_stand_side_by_side_and_one_without_a_clock_says_nothing() {
        let of = |device, ns| {
            let shadow = |words, ns| record(device, "horizon_shadow", words, ns);
            vec![
                record(device, "surface", "encoding=compact sampling=loaded", ns),
                shadow("encoding=f16 sampling=filtered", ns),
                shadow("encoding=f16 sampling=loaded", ns.map(|ns| 2.0 * ns)),
                record(device, "relief", "search=linear start=top angle=35 sampling=loaded", ns),
            ]
        };
        let records = [of("llvmpipe (LLVM 19)", Some(10.0)), of("Clockless", None)].concat();
        let text = render(&RecordFile { machine: String::new(), records });
        assert!(
            text.contains("| ns per pixel | llvmpipe: filtered | llvmpipe: loaded | Clockless: filtered |"),
            "{text}"
        );
        assert!(text.contains("| surface | 10.0 | 10.0 | – | – |\n"), "{text}");
        assert!(text.contains("| horizon shadow, f16 | 10.0 | 20.0 | – | – |\n"), "{text}");
        assert!(text.contains("| linear | 10.0 | – | – |") && text.contains("nothing is said"), "{text}");
        assert_eq!(text.matches("runs on the processor").count(), 1);
    }
}
