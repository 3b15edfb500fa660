//! The tables of baked curvature: for each method how far off it is, surface by surface, and how fast that falls.

use super::numbers::{degrees, distinct, or_none, scientific, short};
use crate::markdown::Table;
use crate::{Quantity, Record, RecordFile};

/// The number of vertices that is shown.
const SHOWN: &str = "4000";

/// The meshes that are shown: pattern and noise, and in words.
const MESHES: [(&str, &str, &str); 4] = [
    ("random", "0", "random"),
    ("jittered", "0", "jittered"),
    ("long-thin", "0", "aspect 20"),
    ("random", "0.1", "random, noise 0.1"),
];

pub(super) fn render(file: &RecordFile) -> String {
    let methods = distinct(file.records.iter().filter_map(|record| record.setting.get("method")));
    let tables: Vec<String> = methods.into_iter().rev().map(|method| of_method(&file.records, method)).collect();
    tables.join("\n")
}

fn of_method(records: &[Record], method: &str) -> String {
    let records: Vec<&Record> = records.iter().filter(|record| record.setting.get("method") == Some(method)).collect();
    let titles = MESHES.map(|(.., words)| words.to_owned());
    let more = ["directions, random", "order, random"].map(str::to_owned);
    let mut table = Table::new([format!("{method}: κ, RMS and maximum")].into_iter().chain(titles).chain(more));
    for surface in distinct(records.iter().map(|record| record.scene.as_str())) {
        let find = |mesh: (&str, &str), vertices: &str, quantity| {
            let is = |record: &&&Record| {
                let word = |name| record.setting.get(name);
                record.scene == surface
                    && record.quantity == Some(quantity)
                    && (word("pattern"), word("noise"), word("vertices"))
                        == (Some(mesh.0), Some(mesh.1), Some(vertices))
            };
            records.iter().find(is).copied()
        };
        let both = |(pattern, noise, _): (&str, &str, &str)| {
            let record = find((pattern, noise), SHOWN, Quantity::Curvature);
            let number = |of: fn(&Record) -> Option<f64>| or_none(record.and_then(of), scientific);
            format!("{}, {}", number(|record| record.rms), number(|record| record.max))
        };
        let direction = find(("random", "0"), SHOWN, Quantity::DirectionDegrees).and_then(|record| record.rms);
        let sizes = distinct(records.iter().filter_map(|record| record.setting.get("vertices")));
        let of_size = |vertices: &str| find(("random", "0"), vertices, Quantity::Curvature);
        let order = order(sizes.first().and_then(|size| of_size(size)), sizes.last().and_then(|size| of_size(size)));
        let row = [surface.replace('_', " ")].into_iter().chain(MESHES.map(both));
        table.push(row.chain([or_none(direction, degrees), or_none(order, short)]).collect());
    }
    table.render()
}

/// Errors below are rounding, and follow no power.
const ROUNDING: f64 = 1e-11;

/// By which power of the edge the error falls from one mesh to a finer one; `None` at rounding.
fn order(coarse: Option<&Record>, fine: Option<&Record>) -> Option<f64> {
    let (coarse, fine) = (coarse?, fine?);
    if coarse.rms? < ROUNDING {
        return None;
    }
    let edges = (f64::from(fine.width) / f64::from(coarse.width)).sqrt();
    let errors = coarse.rms? / fine.rms?;
    (edges > 1.0 && errors.is_finite() && errors > 0.0).then(|| libm::log(errors) / libm::log(edges))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_that_falls_by_eight_as_edges_halve_is_of_third_order() {
        let record = |width, rms| Record { width, rms: Some(rms), ..Record::default() };
        assert!((order(Some(&record(1000, 8e-3)), Some(&record(4000, 1e-3))).unwrap() - 3.0).abs() < 1e-12);
        assert_eq!(order(Some(&record(1000, 8e-3)), Some(&record(1000, 8e-3))), None);
        assert_eq!(order(None, Some(&record(1000, 8e-3))), None);
        assert_eq!(order(Some(&record(1000, 1e-14)), Some(&record(4000, 2e-14))), None);
    }

    #[test]
    fn a_surface_is_a_row_of_its_method() {
        let record = |vertices: u32, quantity, rms| Record {
            scene: "wavy_sheet".to_owned(),
            setting: format!("pattern=random noise=0 vertices={vertices} method=fast").parse().unwrap(),
            width: vertices,
            quantity: Some(quantity),
            rms: Some(rms),
            max: Some(10.0 * rms),
            ..Record::default()
        };
        let records = vec![
            record(4000, Quantity::Curvature, 1e-3),
            record(4000, Quantity::DirectionDegrees, 0.25),
            record(16_000, Quantity::Curvature, 1.25e-4),
        ];
        let text = render(&RecordFile { machine: String::new(), records });
        assert!(text.ends_with("| wavy sheet | 1.0e-3, 1.0e-2 | –, – | –, – | –, – | 0.250° | 3.00 |\n"), "{text}");
    }
}
