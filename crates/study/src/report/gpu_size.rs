//! The table of what the reader adds to a program.

use super::numbers::{NONE, or_none, short};
use super::relief_words::word;
use crate::gpu_size::{PROFILE, PROGRAMS};
use crate::markdown::Table;
use crate::{Record, RecordFile};

pub(super) fn render(file: &RecordFile) -> String {
    let mut table = Table::new(["program", "KiB", "the reader adds"]);
    for program in PROGRAMS {
        let kibibytes = |name: &str| bytes(&file.records, name).map(|bytes| bytes as f64 / 1024.0);
        let added = program.against.map(|against| {
            let added = kibibytes(program.example).zip(kibibytes(against)).map(|(with, without)| with - without);
            or_none(added, |kibibytes| format!("{} KiB", short(kibibytes)))
        });
        let added = added.unwrap_or_else(|| NONE.to_owned());
        table.push(vec![words(program.example).to_owned(), or_none(kibibytes(program.example), short), added]);
    }
    format!(
        "The profile `{PROFILE}`: the release profile, stripped, without debug information. Built on {}.\n\n{}",
        file.machine,
        table.render()
    )
}

fn bytes(records: &[Record], program: &str) -> Option<u64> {
    records.iter().find(|record| word(record, "program") == program)?.bytes
}

fn words(program: &str) -> &str {
    match program {
        "size_empty" => "reads a file",
        "size_plan" => "opens it, checks it, plans its upload and composes a shader, without `wgpu`",
        "size_without" => "draws a picture by `wgpu`",
        "size_with" => "draws it of a file that it opens, checks and uploads",
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu_size::record;

    #[test]
    fn what_the_reader_adds_is_the_difference() {
        let records = PROGRAMS.iter().zip([1024, 3 * 1024, 10_240, 12_800]);
        let records = records.map(|(program, bytes)| record(program, bytes)).collect();
        let text = render(&RecordFile { machine: "a box".to_owned(), records });
        assert!(text.contains("without `wgpu` | 3.00 | 2.00 KiB |\n"), "{text}");
        assert!(text.contains("by `wgpu` | 10.0 | – |\n") && text.contains("uploads | 12.5 | 2.50 KiB |\n"), "{text}");
    }
}
