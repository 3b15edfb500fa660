//! Words that the tables of GPUs share.

use super::numbers::distinct;
use crate::Record;

/// The GPUs of some records, in their order.
pub(super) fn devices(records: &[Record]) -> Vec<&str> {
    distinct(records.iter().filter_map(|record| record.device.as_deref()))
}

/// The records of a GPU.
pub(super) fn of_device<'a>(records: &'a [Record], device: &str) -> Vec<&'a Record> {
    records.iter().filter(|record| record.device.as_deref() == Some(device)).collect()
}

/// What is said of a GPU above its table.
pub(super) fn introduction(device: &str, records: &[&Record]) -> String {
    let host = records.iter().find_map(|record| record.host.as_deref()).unwrap_or_default();
    let is_software = records.iter().any(|record| record.is_software == Some(true));
    let warning = if is_software { " Software: all of it runs on the processor." } else { "" };
    format!("**{device}** ({host}).{warning}")
}
