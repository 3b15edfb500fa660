//! The table of errors: a row for each scene, and for each method its norms.

use super::numbers::{NONE, degrees, percent};
use crate::markdown::Table;
use crate::{Quantity, Record, RecordFile};

/// The words of a setting that name the method.
const METHOD: &str = "method";

pub(super) fn render(file: &RecordFile) -> String {
    let mut methods: Vec<&str> = Vec::new();
    let mut scenes: Vec<(&Record, Vec<&Record>)> = Vec::new();
    for record in &file.records {
        let Some(method) = record.setting.get(METHOD) else { continue };
        if !methods.contains(&method) {
            methods.push(method);
        }
        match scenes.iter_mut().find(|(first, _)| same_scene(first, record)) {
            Some((_, records)) => records.push(record),
            None => scenes.push((record, vec![record])),
        }
    }
    let columns = methods.iter().flat_map(|method| [format!("{method}: RMS, maximum"), "wrong points".to_owned()]);
    let mut table = Table::new(["field", "grid"].map(str::to_owned).into_iter().chain(columns));
    for (first, records) in &scenes {
        table.push(row(first, records, &methods));
    }
    table.render()
}

fn same_scene(a: &Record, b: &Record) -> bool {
    let of = |record: &Record| (record.scene.clone(), record.width, record.height, record.setting.without(METHOD));
    of(a) == of(b)
}

fn row(first: &Record, records: &[&Record], methods: &[&str]) -> Vec<String> {
    let of = |method, quantity| {
        let mut records = records.iter();
        records.find(|record| record.setting.get(METHOD) == Some(method) && record.quantity == Some(quantity))
    };
    let mut row = vec![first.scene.replace('_', " "), format!("{} × {}", first.width, first.height)];
    for method in methods {
        let elevation = of(method, Quantity::ElevationDegrees);
        let norms = elevation.and_then(|record| Some((record.rms?, record.max?)));
        row.push(norms.map_or(NONE.to_owned(), |(rms, max)| format!("{}, {}", degrees(rms), degrees(max))));
        let wrong = of(method, Quantity::DistanceShare).and_then(|record| record.wrong_share);
        row.push(wrong.map_or(NONE.to_owned(), percent));
    }
    row
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scene_is_one_row_whatever_the_method() {
        let record = |method: &str, quantity, width| Record {
            setting: format!("method={method} directions=32").parse().unwrap(),
            scene: "step_wall".to_owned(),
            width,
            height: 8,
            quantity: Some(quantity),
            rms: Some(0.0123),
            max: Some(1.5),
            wrong_share: (quantity == Quantity::DistanceShare).then_some(0.001),
            ..Record::default()
        };
        let (elevation, distance) = (Quantity::ElevationDegrees, Quantity::DistanceShare);
        let records = vec![
            record("sweep", elevation, 8),
            record("sweep", distance, 8),
            record("exact", elevation, 8),
            record("exact", elevation, 16),
        ];
        let text = render(&RecordFile { machine: String::new(), records });
        assert_eq!(
            text,
            "| field | grid | sweep: RMS, maximum | wrong points | exact: RMS, maximum | wrong points |\n\
             |---|---:|---:|---:|---:|---:|\n\
             | step wall | 8 × 8 | 0.012°, 1.50° | 0.10 % | 0.012°, 1.50° | – |\n\
             | step wall | 16 × 8 | – | – | 0.012°, 1.50° | – |\n"
        );
    }
}
