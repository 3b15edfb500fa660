//! The table of how long files take to get to a GPU.

use super::gpu_words::{devices, introduction, of_device};
use super::numbers::{distinct, or_none, short};
use super::relief_words::word;
use crate::markdown::Table;
use crate::{Record, RecordFile};

/// Gigabytes per second that are wanted of opening and uploading.
const GOAL: f64 = 2.0;

/// The steps that are rates, and how the table calls them.
const STEPS: [(&str, &str); 6] = [
    ("upload", "open, plan, upload: GB/s"),
    ("checked", "with every checksum"),
    ("check", "checksums alone"),
    ("bare", "bare `write_texture`"),
    ("pieces", "likewise, by 16 MiB"),
    ("fresh", "copied to fresh memory"),
];

pub(super) fn render(file: &RecordFile) -> String {
    let of = |device| of_gpu(device, &of_device(&file.records, device));
    devices(&file.records).into_iter().map(of).collect::<Vec<_>>().join("\n")
}

fn of_gpu(device: &str, records: &[&Record]) -> String {
    let sizes =
        distinct(records.iter().filter(|record| record.technique == "upload").filter_map(|record| record.bytes));
    let titles = ["file", "open and plan: µs"].into_iter().chain(STEPS.map(|(_, title)| title));
    let mut table = Table::new(titles);
    for &bytes in &sizes {
        let ns = |step| step_ns(records, step, bytes);
        let opened = or_none(ns("open").map(|ns| 1e-3 * ns), short);
        let rates = STEPS.map(|(step, _)| or_none(ns(step).map(|ns| 1.0 / ns), short));
        table.push([mebibytes(bytes), opened].into_iter().chain(rates).collect());
    }
    format!("{} {}\n\n{}", introduction(device, records), bounds(records, sizes.last().copied()), table.render())
}

/// What the memory carries, and whether the goal is met with the largest file.
fn bounds(records: &[&Record], largest: Option<u64>) -> String {
    let copy = records.iter().find(|record| record.technique == "memory" && word(record, "kernel") == "copy");
    let copied = or_none(copy.and_then(|record| record.wall_ns_min).map(|ns| 1.0 / ns), short);
    let rate = largest.and_then(|bytes| step_ns(records, "upload", bytes)).map(|ns| 1.0 / ns);
    let verdict = match rate {
        Some(rate) if rate >= GOAL => "is met with the largest file",
        Some(_) => "is missed with the largest file",
        None => "was not measured",
    };
    format!(
        "The memory copies {copied} GB/s on one thread, bytes read and bytes written counted both. The goal of {GOAL} GB/s {verdict}."
    )
}

/// The median of a step of a file of so many bytes, per file or per byte.
fn step_ns(records: &[&Record], step: &str, bytes: u64) -> Option<f64> {
    let found = records.iter().find(|record| word(record, "step") == step && record.bytes == Some(bytes))?;
    found.wall_ns
}

fn mebibytes(bytes: u64) -> String {
    format!("{} MiB", short((bytes >> 20) as f64))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Setting;
    use crate::bandwidth::Bandwidth;

    #[test]
    fn a_file_is_a_row_and_the_goal_is_judged_by_the_largest() {
        let record = |step: &str, bytes, ns| Record {
            technique: "upload".to_owned(),
            setting: format!("step={step} layers=4").parse::<Setting>().unwrap(),
            bytes: Some(bytes),
            wall_ns: Some(ns),
            ..Record::default()
        };
        let measured =
            [record("open", 1 << 20, 2500.0), record("upload", 1 << 20, 0.2), record("upload", 1 << 29, 0.8)];
        let records = Bandwidth { threads: 1, copy: 12.5, triad: 9.0 }.records().into_iter().chain(measured);
        let on_gpu = |record| Record { device: Some("a GPU".to_owned()), is_software: Some(true), ..record };
        let text = render(&RecordFile { machine: String::new(), records: records.map(on_gpu).collect() });
        assert!(
            text.contains(
                "| 1.00 MiB | 2.50 | 5.00 | – | – | – | – | – |\n| 512 MiB | – | 1.25 | – | – | – | – | – |\n"
            ),
            "{text}"
        );
        assert!(text.contains("copies 12.5 GB/s") && text.contains("missed") && text.contains("Software"), "{text}");
    }
}
