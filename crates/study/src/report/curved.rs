//! The tables of shadows on curved surfaces: every figure over all suns, one figure under each, what tables weigh.

use barchan_shade::CurvedMethod;

use super::numbers::{degrees, distinct, mean, or_none, percent, short};
use crate::markdown::Table;
use crate::{Item, Record, RecordFile, reading};

/// Bytes as a person counts them.
const MEGABYTE: f64 = 1e6;

/// Where places lie, and in words.
const KINDS: [(&str, &str); 2] = [("centres", "at centres"), ("anywhere", "anywhere")];

pub(super) fn render(file: &RecordFile) -> String {
    let records: Vec<&Record> = file.records.iter().collect();
    [over_all_suns(&records), under_each_sun(&records), weights(&records), times(file)].join("\n")
}

fn titled(first: &[&str]) -> Table {
    let titles = CurvedMethod::ALL.map(|method| reading::title(method).to_owned());
    Table::new(first.iter().map(|word| (*word).to_owned()).chain(titles))
}

fn figures<'a>(records: &[&'a Record]) -> Vec<&'a str> {
    distinct(records.iter().map(|record| record.scene.as_str()))
}

/// The record of one figure, kind, method and, unless over all, elevation.
fn find<'a>(
    records: &[&'a Record],
    (figure, kind): (&str, &str),
    method: &str,
    elevation: Option<&str>,
) -> Option<&'a Record> {
    let is = |record: &&&Record| {
        let word = |name| record.setting.get(name);
        record.scene == figure
            && (word("places"), word("method"), word("elevation")) == (Some(kind), Some(method), elevation)
    };
    records.iter().find(is).copied()
}

fn over_all_suns(records: &[&Record]) -> String {
    let mut table = titled(&["figure"]);
    for figure in figures(records) {
        for (kind, words) in KINDS {
            let cell = |method: CurvedMethod| {
                let record = find(records, (figure, kind), &method.to_string(), None);
                let wrong = or_none(record.and_then(|record| record.wrong_share), percent);
                format!("{wrong}, {}", or_none(record.and_then(|record| record.rms), degrees))
            };
            table.push([format!("{figure}; {words}")].into_iter().chain(CurvedMethod::ALL.map(cell)).collect());
        }
    }
    format!("Wrong shadows over all suns, and the error of the horizon, RMS:\n\n{}", table.render())
}

/// The first figure, anywhere.
fn under_each_sun(records: &[&Record]) -> String {
    let Some(figure) = figures(records).first().copied() else { return String::new() };
    let place = (figure, KINDS[1].0);
    let untimed = records.iter().filter(|record| record.per.is_none());
    let mut table = titled(&["sun above the base", "lit in truth"]);
    for elevation in distinct(untimed.filter_map(|record| record.setting.get("elevation"))) {
        let lit = find(records, place, "traced", Some(elevation)).and_then(|record| record.mean);
        let cell = |method: CurvedMethod| {
            let record = find(records, place, &method.to_string(), Some(elevation));
            let wrong = or_none(record.and_then(|record| record.wrong_share), percent);
            format!("{wrong}, {}", or_none(record.and_then(|record| record.rms), degrees))
        };
        let words = [format!("{}°", elevation.replace('-', "−")), or_none(lit, percent)];
        table.push(words.into_iter().chain(CurvedMethod::ALL.map(cell)).collect());
    }
    format!(
        "Figure {figure}, anywhere: wrong shadows under each sun, and how far they are from the true edge:\n\n{}",
        table.render()
    )
}

fn weights(records: &[&Record]) -> String {
    let counts = ["paper", "swept-2", "swept-3"];
    let titles = ["figure", "one point", "K = 2", "K = 3"].map(str::to_owned);
    let mut table = Table::new(titles);
    for figure in figures(records) {
        let bytes = counts.map(|method| {
            let record = find(records, (figure, KINDS[0].0), method, None);
            let megabytes = record.and_then(|record| Some(record.bytes? as f64 / MEGABYTE));
            or_none(megabytes, |megabytes| format!("{} MB", short(megabytes)))
        });
        table.push([figure.to_owned()].into_iter().chain(bytes).collect());
    }
    format!(
        "Tables with heights, 8 bit; the paper has 1.0 MB for figures 4 and 5, 2.2 MB for 6 and 7:\n\n{}",
        table.render()
    )
}

fn times(file: &RecordFile) -> String {
    let timed = |method: &str| {
        let of =
            |record: &&Record| record.per == Some(Item::ShadowTest) && record.setting.get("method") == Some(method);
        let times: Vec<f64> = file.records.iter().filter(of).filter_map(Record::core_ns).collect();
        or_none(mean(&times), short)
    };
    let methods = CurvedMethod::ALL.map(|method| format!("{} {}", reading::title(method), timed(&method.to_string())));
    format!(
        "Nanoseconds per pixel, all in, on one core of {}: {}; tracing {}.\n",
        file.machine,
        methods.join(", "),
        timed("traced")
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(words: &str, wrong_share: f64, rms: f64) -> Record {
        Record {
            scene: "4: bumps".to_owned(),
            setting: words.parse().unwrap(),
            wrong_share: Some(wrong_share),
            rms: Some(rms),
            mean: Some(0.75),
            bytes: Some(1_500_000),
            ..Record::default()
        }
    }

    #[test]
    fn figures_are_rows_and_suns_of_the_first_are_another_table() {
        let records = vec![
            record("places=centres method=paper", 0.01, 2.0),
            record("places=anywhere method=paper", 0.02, 3.0),
            record("places=anywhere method=paper elevation=-5", 0.1, 1.0),
            record("places=anywhere method=traced elevation=-5", 0.0, 0.0),
            Record { per: Some(Item::ShadowTest), cpu_ns: Some(50.0), ..record("method=paper elevation=10", 0.0, 0.0) },
        ];
        let text = render(&RecordFile { machine: "a box".to_owned(), records });
        for line in [
            "| 4: bumps; at centres | –, – | –, – | 1.00 %, 2.00° | –, – | –, – | –, – |\n",
            "| 4: bumps; anywhere | –, – | –, – | 2.00 %, 3.00° | –, – | –, – | –, – |\n",
            "| −5° | 75.0 % | –, – | –, – | 10.0 %, 1.00° | –, – | –, – | –, – |\n",
            "| 4: bumps | 1.50 MB | – | – |\n",
            "paper, corrected 50.0",
        ] {
            assert!(text.contains(line), "{line} in {text}");
        }
        // The sun that times are taken under is not one of the table's.
        assert!(!text.contains("| 10° |"), "{text}");
    }
}
