//! What the horizon baker promises about its speed, and what was measured.

use barchan_bakers::horizon::Method;

use super::numbers::{NONE, or_none, short};
use crate::markdown::Table;
use crate::{Record, horizon_speed};

/// Million texels × directions per second that one core should bake.
fn promised_rate(method: Method) -> &'static str {
    match method {
        Method::Sweep => "60",
        Method::Accurate => "20",
        Method::Exact => "2",
    }
}

/// A row per promise, a column per method. Ratios are of times, so less is better, but for the gain of threads.
pub(super) fn table(timed: &[&Record]) -> Table {
    let mut table = Table::new(["promise".to_owned()].into_iter().chain(Method::ALL.map(|m| m.name().to_owned())));
    let mut row = |promise: String, cell: &dyn Fn(&[&Record]) -> Option<String>| {
        let cells = Method::ALL.map(|method| cell(&of_method(timed, method)).unwrap_or_else(|| NONE.to_owned()));
        table.push([promise].into_iter().chain(cells).collect());
    };
    let rates = Method::ALL.map(promised_rate).join(", ");
    row(format!("terrain on one core, M/s: at least {rates}"), &rate);
    row("the largest grid against the smallest: at most 1.25".to_owned(), &growth);
    row("the slowest field against terrain: at most 2".to_owned(), &slowest_field);
    row("two threads against one: at least 1.8".to_owned(), &gain);
    table
}

fn of_method<'a>(timed: &[&'a Record], method: Method) -> Vec<&'a Record> {
    timed.iter().copied().filter(|record| record.setting.get("method") == Some(method.name())).collect()
}

fn varied<'a>(records: &[&'a Record], what: &str) -> Vec<&'a Record> {
    records.iter().copied().filter(|record| record.setting.get("varied") == Some(what)).collect()
}

fn with_threads<'a>(records: &[&'a Record], threads: &str) -> Option<&'a Record> {
    varied(records, "threads").into_iter().find(|record| record.setting.get("threads") == Some(threads))
}

fn rate(records: &[&Record]) -> Option<String> {
    Some(short(1e3 / with_threads(records, "1")?.core_ns()?))
}

fn growth(records: &[&Record]) -> Option<String> {
    let mut sizes = varied(records, "size");
    sizes.sort_by_key(|record| record.width);
    let (first, last) = (sizes.first()?, sizes.last()?);
    Some(format!("{}, {}² to {}²", short(last.core_ns()? / first.core_ns()?), first.width, last.width))
}

fn slowest_field(records: &[&Record]) -> Option<String> {
    let fields = varied(records, "field");
    let terrain = fields.iter().find(|record| record.scene == horizon_speed::TERRAIN)?.core_ns()?;
    let others = fields.iter().filter(|record| record.scene != horizon_speed::TERRAIN);
    let slowest = others.max_by(|a, b| a.core_ns().unwrap_or(0.0).total_cmp(&b.core_ns().unwrap_or(0.0)))?;
    Some(format!("{}, {}", or_none(slowest.core_ns().map(|ns| ns / terrain), short), slowest.scene.replace('_', " ")))
}

fn gain(records: &[&Record]) -> Option<String> {
    let (one, two) = (with_threads(records, "1")?, with_threads(records, "2")?);
    Some(short(one.wall_ns? / two.wall_ns?))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(words: &str, scene: &str, width: u32, ns: f64) -> Record {
        Record {
            setting: format!("method=sweep {words}").parse().unwrap(),
            scene: scene.to_owned(),
            width,
            cpu_ns: Some(ns),
            wall_ns: Some(ns),
            ..Record::default()
        }
    }

    #[test]
    fn each_promise_is_read_from_the_heat_that_varies_it() {
        let records = [
            record("varied=field threads=1", "fractal_terrain", 64, 10.0),
            record("varied=field threads=1", "spike", 64, 5.0),
            record("varied=field threads=1", "white_noise", 64, 15.0),
            record("varied=size threads=1", "fractal_terrain", 128, 12.0),
            record("varied=size threads=1", "fractal_terrain", 32, 10.0),
            record("varied=threads threads=1", "fractal_terrain", 64, 16.0),
            record("varied=threads threads=2", "fractal_terrain", 64, 8.0),
        ];
        let rendered = table(&records.iter().collect::<Vec<_>>()).render();
        let cells: Vec<&str> = rendered.lines().skip(2).map(|line| line.split(" | ").nth(1).unwrap()).collect();
        assert_eq!(cells, ["62.5", "1.20, 32² to 128²", "1.50, white noise", "2.00"]);
        assert!(rendered.lines().skip(2).all(|line| line.ends_with("| – | – |")), "{rendered}");
    }
}
