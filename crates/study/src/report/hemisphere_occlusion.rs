//! The tables of occlusion and shadow: against traced rays, and against closed forms.

use super::numbers::{NONE, distinct, or_none, percent, short};
use super::relief_words::{fetches, find, relief, word};
use crate::markdown::Table;
use crate::{Record, RecordFile};

/// Roads to the light, as records and as the table have them.
const ROADS: [(&str, &str); 3] = [
    ("linear", "linear + bisection"),
    ("nearest_linear", "nearest depths, linear + bisection"),
    ("conservative_cone_steps", "conservative depths, cone steps"),
];

pub(super) fn render(file: &RecordFile) -> String {
    let of = |technique: &str| -> Vec<&Record> {
        file.records.iter().filter(|record| record.technique == technique).collect()
    };
    format!(
        "Occlusion against 1024 traced rays a point: RMS and maximum error, mean fetches and time per point.\n\n{}\n\
         Closed forms: a wall without ends, and the plane, at a level point.\n\n{}\n\
         Shadow against traced rays: wrong share, mean fetches.\n\n{}\nMeasured on {}.\n",
        occlusion(&of("hemisphere_occlusion")),
        closed_forms(&of("closed_form")),
        shadows(&of("relief_shadow")),
        file.machine,
    )
}

fn scenes<'a>(records: &[&'a Record]) -> Vec<&'a str> {
    distinct(records.iter().map(|record| record.scene.as_str()))
}

/// The ways to an answer but the truth, each by its words.
fn ways<'a>(records: &[&'a Record]) -> Vec<[(&'static str, &'a str); 3]> {
    let tabled = records.iter().filter(|record| record.setting.get("mode").is_some());
    distinct(tabled.map(|record| ["by", "mode", "size"].map(|name| (name, word(record, name)))))
}

fn title([(_, by), (_, mode), (_, size)]: [(&str, &str); 3]) -> String {
    let by = if by == "map" { "map alone" } else { "rays" };
    format!("{mode}, {size}², {by}")
}

fn on<'a>(records: &[&'a Record], scene: &str) -> Vec<&'a Record> {
    records.iter().filter(|record| record.scene == scene).copied().collect()
}

fn occlusion(records: &[&Record]) -> String {
    let scenes = scenes(records);
    let titles = scenes.iter().map(|scene| {
        let truth = find(&on(records, scene), &[("by", "traced")]).and_then(|record| record.mean);
        format!("{} (mean {})", relief(scene), or_none(truth, short))
    });
    let mut table =
        Table::new(["depths".to_owned()].into_iter().chain(titles).chain(["fetches", "time"].map(str::to_owned)));
    for way in ways(records) {
        let found: Vec<Option<&Record>> = scenes.iter().map(|scene| find(&on(records, scene), &way)).collect();
        let cells = found.iter().map(|record| {
            record.map_or(NONE.to_owned(), |record| {
                format!("{}, {}", or_none(record.rms, short), or_none(record.max, short))
            })
        });
        let mean = |of: fn(&Record) -> Option<f64>| {
            let values: Vec<f64> = found.iter().flatten().filter_map(|record| of(record)).collect();
            super::numbers::mean(&values)
        };
        let costs = [
            or_none(mean(fetches), |fetches| format!("{fetches:.0}")),
            or_none(mean(Record::core_ns), |ns| format!("{} µs", short(1e-3 * ns))),
        ];
        table.push([title(way)].into_iter().chain(cells).chain(costs).collect());
    }
    table.render()
}

fn closed_forms(records: &[&Record]) -> String {
    let ratios = distinct(records.iter().map(|record| (record.scene.as_str(), word(record, "height_over_distance"))));
    let titles = ratios.iter().map(|(scene, ratio)| match *scene {
        "plane" => "plane".to_owned(),
        _ => format!("{scene}, H / d = {ratio}"),
    });
    let mut table = Table::new(["occlusion".to_owned()].into_iter().chain(titles));
    let mut push = |name: String, words: &[(&str, &str)]| {
        let cells = ratios.iter().map(|(scene, ratio)| {
            let words: Vec<_> = words.iter().copied().chain([("height_over_distance", *ratio)]).collect();
            or_none(find(&on(records, scene), &words).and_then(|record| record.mean), |share| format!("{share:.3}"))
        });
        table.push([name].into_iter().chain(cells).collect());
    };
    push("closed form".to_owned(), &[("by", "closed_form")]);
    push("traced, 1024 rays".to_owned(), &[("by", "traced")]);
    for way in ways(records) {
        push(title(way), &way);
    }
    table.render()
}

fn shadows(records: &[&Record]) -> String {
    let views = distinct(records.iter().map(|record| (record.scene.as_str(), word(record, "angle"))));
    let titles = ROADS.map(|(_, title)| title.to_owned());
    let mut table = Table::new(["light, degrees from the normal", "dark"].map(str::to_owned).into_iter().chain(titles));
    for (scene, angle) in views {
        let found = ROADS.map(|(road, _)| find(&on(records, scene), &[("road", road), ("angle", angle)]));
        let dark = found[0].and_then(|record| record.mean);
        let cells = found.map(|record| {
            let record = record?;
            Some(format!("{}, {}", or_none(record.wrong_share, percent), or_none(fetches(record), short)))
        });
        let cells = cells.map(|cell| cell.unwrap_or(NONE.to_owned()));
        table.push([format!("{}, {angle}°", relief(scene)), or_none(dark, percent)].into_iter().chain(cells).collect());
    }
    table.render()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ways_are_rows_and_closed_forms_stand_above_them() {
        let record = |technique: &str, scene: &str, words: &str, mean: f64| Record {
            technique: technique.to_owned(),
            setting: words.parse().unwrap(),
            scene: scene.to_owned(),
            mean: Some(mean),
            rms: Some(0.02),
            max: Some(0.1),
            wrong_share: Some(0.01),
            height_fetches: Some(3.0),
            table_fetches: Some(4.0),
            cpu_ns: Some(2500.0),
            ..Record::default()
        };
        let records = vec![
            record("hemisphere_occlusion", "white_noise", "by=traced", 0.5),
            record("hemisphere_occlusion", "white_noise", "mode=nearest size=32 by=map", 0.0),
            record("closed_form", "wall", "by=closed_form height_over_distance=2", 0.2764),
            record("closed_form", "wall", "by=map mode=nearest size=32 height_over_distance=2", 0.25),
            record("relief_shadow", "white_noise", "road=linear angle=60", 0.5),
        ];
        let text = render(&RecordFile { machine: "a box".to_owned(), records });
        for line in [
            "| depths | white noise (mean 0.500) | fetches | time |\n",
            "| nearest, 32², map alone | 0.020, 0.100 | 7 | 2.50 µs |\n",
            "| closed form | 0.276 |\n",
            "| nearest, 32², map alone | 0.250 |\n",
            "| white noise, 60° | 50.0 % | 1.00 %, 7.00 | – | – |\n",
        ] {
            assert!(text.contains(line), "{line} in {text}");
        }
    }
}
