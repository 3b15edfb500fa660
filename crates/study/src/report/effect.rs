//! Where curvature matters: two surfaces over curvature and period, a chart and a table over curvature.

use super::numbers::{degrees, distinct, or_none, percent};
use crate::chart::{Curve, HeatChart, Legend, LineChart};
use crate::markdown::Table;
use crate::{Record, RecordFile, StudyError, reading};
use barchan_shade::CurvedMethod;

/// Bumps are named by their period.
const BUMPS: &str = "bumps of ";

/// The corrections whose gain is plotted, and the picture of each.
const GAINS: [(CurvedMethod, &str); 2] =
    [(CurvedMethod::Paper, "curved_effect_paper"), (CurvedMethod::Exact(3), "curved_effect_swept")];

/// A picture of relief of many scales.
struct Over {
    name: &'static str,
    /// What runs up.
    up: &'static str,
    of: fn(&Record) -> Option<f64>,
}

const SCALES: [Over; 2] = [
    Over { name: "curved_scales_wrong", up: "wrong shadows, %", of: |record| Some(100.0 * record.wrong_share?) },
    Over { name: "curved_scales_rms", up: "error of the horizon, ° RMS", of: |record| record.rms },
];

/// Full colour: this share of shadows, in percent.
const FULL: f64 = 5.0;

pub(super) fn render(file: &RecordFile) -> String {
    let titles = CurvedMethod::ALL.map(|method| reading::title(method).to_owned());
    let mut table = Table::new(["fractal terrain, κ".to_owned()].into_iter().chain(titles));
    for curvature in distinct(scales(file).map(curvature)) {
        let cells = CurvedMethod::ALL.map(|method| {
            let record = find(scales(file), curvature, method);
            let wrong = or_none(record.and_then(|record| record.wrong_share), percent);
            format!("{wrong}, {}", or_none(record.and_then(|record| record.rms), degrees))
        });
        table.push([curvature.to_owned()].into_iter().chain(cells).collect());
    }
    table.render()
}

pub(super) fn charts(file: &RecordFile) -> Result<Vec<(&'static str, String)>, StudyError> {
    let gains = GAINS.map(|(method, name)| Ok((name, gain(file, method).svg()?)));
    let scales = SCALES.map(|over| Ok((over.name, over_curvature(file, &over).svg()?)));
    gains.into_iter().chain(scales).collect()
}

/// What a correction saves: the wrong share without it minus that with it, in percent.
fn gain(file: &RecordFile, method: CurvedMethod) -> HeatChart {
    let curvatures = distinct(bumps(file).map(curvature));
    let periods = distinct(bumps(file).map(|record| record.scene.as_str()));
    let cell = |period: &&str, curvature: &&str| {
        let wrong = |method| find(bumps(file).filter(|record| record.scene == *period), curvature, method)?.wrong_share;
        Some(100.0 * (wrong(CurvedMethod::Flat)? - wrong(method)?))
    };
    let cells = periods.iter().map(|period| curvatures.iter().map(|curvature| cell(period, curvature)).collect());
    HeatChart {
        title: format!("Shadows mended, %: {}", reading::title(method)),
        cells: cells.collect(),
        across: ("curvature κ of the base, per unit".to_owned(), owned(&curvatures)),
        up: ("period of the bumps, units".to_owned(), periods.iter().map(|name| name.replace(BUMPS, "")).collect()),
        full: FULL,
    }
}

fn over_curvature(file: &RecordFile, over: &Over) -> LineChart {
    let curvatures = distinct(scales(file).map(curvature));
    let curve = |method: CurvedMethod| {
        let point =
            |curvature: &&str| Some((curvature.parse().ok()?, (over.of)(find(scales(file), curvature, method)?)?));
        Curve { name: reading::title(method).to_owned(), points: curvatures.iter().filter_map(point).collect() }
    };
    LineChart {
        title: "Fractal terrain on a curved base".to_owned(),
        across: "curvature κ of the base, per unit".to_owned(),
        up: over.up.to_owned(),
        curves: CurvedMethod::ALL.into_iter().map(curve).collect(),
        legend: Legend::UpperLeft,
    }
}

fn bumps(file: &RecordFile) -> impl Iterator<Item = &Record> {
    file.records.iter().filter(|record| record.scene.starts_with(BUMPS))
}

fn scales(file: &RecordFile) -> impl Iterator<Item = &Record> {
    file.records.iter().filter(|record| !record.scene.starts_with(BUMPS))
}

fn curvature(record: &Record) -> &str {
    record.setting.get("curvature").unwrap_or_default()
}

fn find<'a>(mut records: impl Iterator<Item = &'a Record>, kappa: &str, method: CurvedMethod) -> Option<&'a Record> {
    records
        .find(|record| curvature(record) == kappa && record.setting.get("method") == Some(method.to_string().as_str()))
}

fn owned(words: &[&str]) -> Vec<String> {
    words.iter().map(|word| (*word).to_owned()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(scene: &str, curvature: f64, method: CurvedMethod, wrong_share: f64) -> Record {
        Record {
            scene: scene.to_owned(),
            setting: format!("curvature={curvature} method={method}").parse().unwrap(),
            wrong_share: Some(wrong_share),
            rms: Some(2.0),
            ..Record::default()
        }
    }

    fn file() -> RecordFile {
        let records = vec![
            record("bumps of 8", 0.01, CurvedMethod::Flat, 0.25),
            record("bumps of 8", 0.01, CurvedMethod::Exact(3), 0.05),
            record("fractal_terrain", 0.01, CurvedMethod::Flat, 0.1),
            record("fractal_terrain", 0.01, CurvedMethod::Paper, 0.2),
        ];
        RecordFile { machine: String::new(), records }
    }

    #[test]
    fn the_table_is_of_relief_of_many_scales() {
        let text = render(&file());
        assert!(text.ends_with("| 0.01 | 10.0 %, 2.00° | –, – | 20.0 %, 2.00° | –, – | –, – | –, – |\n"), "{text}");
        assert_eq!(text.lines().count(), 3);
    }

    #[test]
    fn a_gain_is_the_difference_in_percent_and_what_is_missing_stays_empty() {
        assert_eq!(gain(&file(), CurvedMethod::Exact(3)).cells, [[Some(20.0)]]);
        assert_eq!(gain(&file(), CurvedMethod::Paper).cells, [[None]]);
        assert_eq!(gain(&file(), CurvedMethod::Paper).up.1, ["8"]);
    }

    #[test]
    fn charts_are_named_and_say_what_they_show() {
        let charts = charts(&file()).unwrap();
        assert_eq!(
            charts.iter().map(|(name, _)| *name).collect::<Vec<_>>(),
            [GAINS[0].1, GAINS[1].1, SCALES[0].name, SCALES[1].name]
        );
        assert!(charts[1].1.contains("20.0") && charts[2].1.contains("paper, corrected"));
    }
}
