//! The table of how fast curvature is baked.

use super::numbers::{distinct, or_none, short};
use crate::curvature_speed::FAN;
use crate::markdown::Table;
use crate::{Record, RecordFile};

pub(super) fn render(file: &RecordFile) -> String {
    let titles = ["million vertices per second", "of one core's time", "on the wall clock"].map(str::to_owned);
    let mut table = Table::new(titles);
    for record in file.records.iter().filter(|record| record.scene != FAN) {
        let rate = |ns: Option<f64>| or_none(ns.map(|ns| 1e3 / ns), short);
        let threads = record.setting.get("threads").unwrap_or_default();
        let plural = if threads == "1" { "" } else { "s" };
        let words =
            format!("{}, {} vertices, {}, {threads} thread{plural}", record.scene, record.width, method(record));
        table.push(vec![words, rate(record.core_ns()), rate(record.wall_ns)]);
    }
    let methods = distinct(file.records.iter().map(method));
    let gains = methods.iter().map(|name| format!("{name} {}", or_none(gain(&file.records, name), short)));
    let fans = file.records.iter().filter(|record| record.scene == FAN).map(|record| {
        let seconds = record.wall_ns.map(|ns| 1e-9 * ns * f64::from(record.width));
        format!("{} {} s", method(record), or_none(seconds, short))
    });
    format!(
        "{}\nAll threads against one, on the wall clock: {}. A fan of triangles round one vertex: {}. Measured on {}.\n",
        table.render(),
        gains.collect::<Vec<_>>().join(", "),
        fans.collect::<Vec<_>>().join(", "),
        file.machine,
    )
}

fn method(record: &Record) -> &str {
    record.setting.get("method").unwrap_or_default()
}

fn gain(records: &[Record], name: &str) -> Option<f64> {
    let mut timed = records.iter().filter(|record| record.scene != FAN && method(record) == name);
    Some(timed.next()?.wall_ns? / timed.next_back()?.wall_ns?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rates_are_of_vertices_and_the_fan_is_in_seconds() {
        let record = |scene: &str, threads: u32, width, wall_ns| Record {
            scene: scene.to_owned(),
            setting: format!("method=fast threads={threads}").parse().unwrap(),
            width,
            cpu_ns: Some(1000.0),
            wall_ns: Some(wall_ns),
            ..Record::default()
        };
        let records = vec![
            record("torus", 1, 1_000_000, 1000.0),
            record("torus", 2, 1_000_000, 500.0),
            record(FAN, 1, 1000, 1e6),
        ];
        let text = render(&RecordFile { machine: "a box".to_owned(), records });
        assert!(text.contains("| torus, 1000000 vertices, fast, 2 threads | 1.00 | 2.00 |\n"), "{text}");
        assert!(text.contains("wall clock: fast 2.00. A fan of triangles round one vertex: fast 1.00 s."), "{text}");
    }
}
