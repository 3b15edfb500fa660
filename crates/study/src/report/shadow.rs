//! The table of shadows: a row for each table a user may store, over all scenes and lights; for each method how much is wrong.

use super::numbers::{mean, or_none, percent, short};
use crate::markdown::Table;
use crate::{Item, Quantity, Record, RecordFile};

pub(super) fn render(file: &RecordFile) -> String {
    let methods = names(&file.records, |record| record.setting.get("method").map(str::to_owned));
    let stored = names(&file.records, |record| Some(stored(record)));
    let columns = ["azimuths, encoding", "bytes per texel"].map(str::to_owned);
    let wrong = methods.iter().flat_map(|method| [format!("{method}: at centres"), "between".to_owned()]);
    let mut table = Table::new(columns.into_iter().chain(wrong).chain(["worst light".to_owned()]));
    for stored in &stored {
        table.push(row(stored, &methods, &file.records));
    }
    format!("{}\n{}", introduction(file), table.render())
}

/// What is stored, in words.
fn stored(record: &Record) -> String {
    ["directions", "encoding"].map(|name| record.setting.get(name).unwrap_or_default()).join(", ")
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

fn row(wanted: &str, methods: &[String], records: &[Record]) -> Vec<String> {
    let records: Vec<&Record> =
        records.iter().filter(|record| record.quantity.is_some() && stored(record) == wanted).collect();
    let wrong = |method: &String, quantity| {
        let of = records.iter().filter(|record| record.setting.get("method") == Some(method));
        let of = of.filter(|record| record.quantity == Some(quantity)).filter_map(|record| record.wrong_share);
        or_none(mean(&of.collect::<Vec<_>>()), percent)
    };
    let texels = |record: &Record| f64::from(record.width) * f64::from(record.height);
    let bytes: Vec<f64> = records.iter().filter_map(|record| Some(record.bytes? as f64 / texels(record))).collect();
    let worst = records.iter().filter_map(|record| record.max).max_by(f64::total_cmp);
    let both = [Quantity::ShadowAtCentres, Quantity::ShadowBetweenCentres];
    let mut row = vec![wanted.to_owned(), or_none(mean(&bytes), |bytes| format!("{bytes:.0}"))];
    row.extend(methods.iter().flat_map(|method| both.map(|quantity| wrong(method, quantity))));
    row.push(or_none(worst, percent));
    row
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
        assert!(text.ends_with("| 8, u8 | 8 | 2.00 % | 20.0 % | 40.0 % |\n"), "{text}");
    }
}
