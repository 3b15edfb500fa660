//! The table of interpolation: a row per mesh, a column per way, and what each takes.

use super::numbers::{distinct, mean, or_none, percent, scientific, short};
use crate::curvature_interpolation::Interpolation;
use crate::markdown::Table;
use crate::{Record, RecordFile};

fn title(interpolation: Interpolation) -> &'static str {
    match interpolation {
        Interpolation::Forms => "forms",
        Interpolation::AlignedDirections => "κ1, κ2, V1, V2, signs aligned",
        Interpolation::Directions => "as they are",
        Interpolation::DirectionsAsPrinted => "as they are, eq 1 as printed",
    }
}

pub(super) fn render(file: &RecordFile) -> String {
    let of = |interpolation: Interpolation| {
        let is = move |record: &&Record| record.setting.get("interpolation") == Some(interpolation.name());
        file.records.iter().filter(is)
    };
    let titles = Interpolation::ALL.map(|interpolation| title(interpolation).to_owned());
    let mut table = Table::new(["off by more than 10 %, RMS".to_owned()].into_iter().chain(titles));
    for mesh in distinct(file.records.iter().map(|record| record.scene.as_str())) {
        let cell = |interpolation| {
            let record = of(interpolation).find(|record| record.scene == mesh);
            let wrong = or_none(record.and_then(|record| record.wrong_share), percent);
            format!("{wrong}, {}", or_none(record.and_then(|record| record.rms), scientific))
        };
        table.push([mesh.replace('_', " ")].into_iter().chain(Interpolation::ALL.map(cell)).collect());
    }
    let time = |interpolation| {
        or_none(mean(&of(interpolation).filter_map(Record::core_ns).collect::<Vec<_>>()), |ns| {
            format!("{} ns", short(ns))
        })
    };
    table.push(["a pixel takes".to_owned()].into_iter().chain(Interpolation::ALL.map(time)).collect());
    table.render()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn meshes_are_rows_and_times_are_their_mean() {
        let record = |scene: &str, ns| Record {
            scene: scene.to_owned(),
            setting: "interpolation=forms".parse().unwrap(),
            wrong_share: Some(0.25),
            rms: Some(0.00123),
            cpu_ns: Some(ns),
            ..Record::default()
        };
        let records = vec![record("torus", 10.0), record("scan", 20.0)];
        let text = render(&RecordFile { machine: String::new(), records });
        assert!(text.contains("| torus | 25.0 %, 1.2e-3 | –, – | –, – | –, – |\n"), "{text}");
        assert!(text.ends_with("| a pixel takes | 15.0 ns | – | – | – |\n"), "{text}");
    }
}
