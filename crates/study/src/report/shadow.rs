//! The table of shadows: a row for each table a user may store, over all scenes and lights.

use super::numbers::{mean, or_none, percent, short};
use crate::markdown::Table;
use crate::{Item, Quantity, Record, RecordFile};

pub(super) fn render(file: &RecordFile) -> String {
    let mut table =
        Table::new(["method, azimuths, encoding", "bytes per texel", "wrong at centres", "between", "worst light"]);
    for setting in settings(&file.records) {
        table.push(row(&setting, &file.records));
    }
    format!("{}\n{}", introduction(file), table.render())
}

fn introduction(file: &RecordFile) -> String {
    let scenes = names(&file.records, |record| Some(record.scene.replace('_', " ")));
    let elevations = names(&file.records, |record| record.setting.get("elevation").map(|words| format!("{words}°")));
    let test = |technique: &str| {
        let tests = file.records.iter().filter(|record| record.per == Some(Item::ShadowTest));
        let times: Vec<f64> =
            tests.filter(|record| record.technique == technique).filter_map(Record::core_ns).collect();
        or_none(mean(&times), short)
    };
    format!(
        "Over {}, under suns at {}. A test takes {} ns by the map and {} ns by the ray on one core of {}.\n",
        scenes.join(", "),
        elevations.join(", "),
        test("horizon"),
        test("traced"),
        file.machine,
    )
}

/// Each once, in the order of the first.
fn names(records: &[Record], name: impl Fn(&Record) -> Option<String>) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for name in records.iter().filter(|record| record.quantity.is_some()).filter_map(name) {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names
}

/// `[method, directions, encoding]` of every table.
fn settings(records: &[Record]) -> Vec<[String; 3]> {
    let mut settings: Vec<[String; 3]> = Vec::new();
    for record in records.iter().filter(|record| record.quantity.is_some()) {
        let setting = setting(record);
        if !settings.contains(&setting) {
            settings.push(setting);
        }
    }
    // A stable sort by the method's first appearance: the table is read one method at a time.
    let methods: Vec<String> = settings.iter().map(|setting| setting[0].clone()).collect();
    settings.sort_by_key(|setting| methods.iter().position(|method| *method == setting[0]));
    settings
}

fn setting(record: &Record) -> [String; 3] {
    ["method", "directions", "encoding"].map(|name| record.setting.get(name).unwrap_or_default().to_owned())
}

fn row(wanted: &[String; 3], records: &[Record]) -> Vec<String> {
    let records: Vec<&Record> = records.iter().filter(|record| setting(record) == *wanted).collect();
    let of = |quantity| records.iter().filter(move |record| record.quantity == Some(quantity));
    let wrong = |quantity| mean(&of(quantity).filter_map(|record| record.wrong_share).collect::<Vec<_>>());
    let worst = of(Quantity::ShadowBetweenCentres).filter_map(|record| record.max).max_by(f64::total_cmp);
    let texels = |record: &Record| f64::from(record.width) * f64::from(record.height);
    let bytes: Vec<f64> = records.iter().filter_map(|record| Some(record.bytes? as f64 / texels(record))).collect();
    vec![
        wanted.join(", "),
        or_none(mean(&bytes), |bytes| format!("{bytes:.0}")),
        or_none(wrong(Quantity::ShadowAtCentres), percent),
        or_none(wrong(Quantity::ShadowBetweenCentres), percent),
        or_none(worst, percent),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(words: &str, quantity: Option<Quantity>, wrong_share: f64) -> Record {
        Record {
            technique: "horizon".to_owned(),
            setting: words.parse().unwrap(),
            scene: "dunes".to_owned(),
            width: 4,
            height: 4,
            quantity,
            wrong_share: Some(wrong_share),
            max: Some(2.0 * wrong_share),
            bytes: Some(128),
            ..Record::default()
        }
    }

    #[test]
    fn scenes_and_lights_are_averaged_and_the_worst_is_kept() {
        let (centres, between) = (Some(Quantity::ShadowAtCentres), Some(Quantity::ShadowBetweenCentres));
        let words = "directions=8 encoding=u8 method=sweep";
        let test = |technique: &str, ns| Record {
            technique: technique.to_owned(),
            per: Some(Item::ShadowTest),
            cpu_ns: Some(ns),
            ..record("elevation=15", None, 0.0)
        };
        let records = vec![
            record(&format!("{words} elevation=5"), centres, 0.01),
            record(&format!("{words} elevation=15"), centres, 0.03),
            record(&format!("{words} elevation=5"), between, 0.2),
            test("horizon", 8.0),
            test("traced", 800.0),
        ];
        let text = render(&RecordFile { machine: "a box".to_owned(), records });
        assert!(
            text.starts_with("Over dunes, under suns at 5°, 15°. A test takes 8.00 ns by the map and 800 ns"),
            "{text}"
        );
        assert!(text.ends_with("| sweep, 8, u8 | 8 | 2.00 % | 20.0 % | 40.0 % |\n"), "{text}");
    }
}
