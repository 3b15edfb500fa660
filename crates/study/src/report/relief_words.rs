//! Words that the tables of relief searches share.

use super::numbers::{NONE, or_none, short};
use crate::Record;
use crate::relief_method::{Feed, Method, Search};

/// A method as the tables call it.
pub(super) fn title(method: Method) -> String {
    let search = match method.search {
        Search::Linear => "linear + bisection",
        Search::Parallax => "parallax occlusion",
        Search::Cones => "cone steps",
        Search::RelaxedCones => "relaxed cone steps",
        Search::MaximumMip => "maximum mip",
    };
    match method.feed {
        Feed::Top => search.to_owned(),
        Feed::Nearest => format!("nearest depths, {search}"),
        Feed::Conservative => format!("conservative depths, {search}"),
    }
}

/// The first record whose setting has all these words.
pub(super) fn find<'a>(records: &[&'a Record], words: &[(&str, &str)]) -> Option<&'a Record> {
    records.iter().find(|record| has(record, words)).copied()
}

/// Whether a record's setting has all these words.
pub(super) fn has(record: &Record, words: &[(&str, &str)]) -> bool {
    words.iter().all(|(name, value)| record.setting.get(name) == Some(value))
}

/// A word of a record's setting.
pub(super) fn word<'a>(record: &'a Record, name: &str) -> &'a str {
    record.setting.get(name).unwrap_or_default()
}

/// Fetches of the height map and of other tables together.
pub(super) fn fetches(record: &Record) -> Option<f64> {
    Some(record.height_fetches? + record.table_fetches?)
}

/// Fetches of both, one after the other.
pub(super) fn fetches_apart(record: &Record) -> String {
    let tenths = |fetches: Option<f64>| or_none(fetches, |fetches| format!("{fetches:.1}"));
    format!("{} + {}", tenths(record.height_fetches), tenths(record.table_fetches))
}

/// A part of the relief's thickness; what three decimals would call 0 but is not is said to be less.
pub(super) fn depth(part: Option<f64>) -> String {
    match part {
        None => NONE.to_owned(),
        Some(part) if part != 0.0 && part.abs() < 5e-6 => "<1e-5".to_owned(),
        Some(part) if part != 0.0 && part.abs() < 0.001 => format!("{part:.0e}"),
        Some(part) => short(part),
    }
}

/// A relief's name as the tables write it.
pub(super) fn relief(name: &str) -> String {
    name.replace('_', " ")
}
