//! The one place that prints: results to stdout, everything else to stderr.

use std::io::{self, Write};
use std::path::Path;

use barchan_asset::TextureDescriptor;
use barchan_pipeline::{HorizonAccuracy, StartAccuracy};
use serde::Serialize;

use crate::failure::Failure;

/// Prints a result. A closed pipe, as under `| head`, is the reader's wish and no error.
pub(crate) fn print(text: &str) -> Result<(), Failure> {
    print_bytes(text.as_bytes())
}

/// [`print()`] for bytes that need not be text.
pub(crate) fn print_bytes(bytes: &[u8]) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(bytes).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(Failure::io(Path::new("standard output"), "cannot be written", &error))
        }
        _ => Ok(()),
    }
}

/// Prints a report: as JSON for machines, or as `describe` words it for people.
pub(crate) fn present<R: Serialize>(report: &R, json: bool, describe: impl Fn(&R) -> String) -> Result<(), Failure> {
    if json { print_json(report) } else { print(&describe(report)) }
}

/// Prints a result for machines.
pub(crate) fn print_json(value: &impl Serialize) -> Result<(), Failure> {
    let text = serde_json::to_string_pretty(value).expect("reports have string keys");
    print(&(text + "\n"))
}

/// One line of an error, to stderr; with `--json` also as an object on stdout.
pub(crate) fn report_failure(failure: &Failure, json: bool) {
    if json {
        // The exit code tells even where stdout is gone.
        let _ = print_error(failure);
    }
    let _ = writeln!(io::stderr(), "barchan: {failure}");
}

/// An error for machines.
pub(crate) fn print_error(failure: &Failure) -> Result<(), Failure> {
    #[derive(Serialize)]
    struct ErrorReport {
        schema: &'static str,
        exit_code: u8,
        error: String,
    }
    let (exit_code, error) = (failure.status() as u8, failure.to_string());
    print_json(&ErrorReport { schema: "barchan.error/1", exit_code, error })
}

/// `512 B`, `4.0 KiB`, `1.5 MiB` …
pub(crate) fn bytes(count: u64) -> String {
    const UNITS: [&str; 4] = ["KiB", "MiB", "GiB", "TiB"];
    if count < 1024 {
        return format!("{count} B");
    }
    let mut amount = count as f64 / 1024.0;
    let mut unit = 0;
    while amount >= 1023.95 && unit + 1 < UNITS.len() {
        amount /= 1024.0;
        unit += 1;
    }
    format!("{amount:.1} {}", UNITS[unit])
}

/// A number for people: three or four figures, no trail of zeros.
pub(crate) fn number(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    if !(1e-4..1e7).contains(&size) {
        return format!("{value:.2e}");
    }
    let decimals = (3 - size.log10().floor() as i32).clamp(0, 7) as usize;
    let text = format!("{value:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// A table of texels' values in the unit people think in: degrees for angles.
pub(crate) fn value_in(unit: barchan_asset::Unit, value: f64) -> String {
    match unit {
        barchan_asset::Unit::Radian => format!("{}°", number(value.to_degrees())),
        barchan_asset::Unit::None => number(value),
        barchan_asset::Unit::Length(length) => format!("{} {}", number(value), length.symbol()),
    }
}

/// A first and a last azimuth, as in `from 180° to 300°`.
pub(crate) fn arc((first, last): (f64, f64)) -> String {
    format!("from {}° to {}°", number(first), number(last))
}

/// An error of a table, by the symbol of its unit: degrees for angles.
pub(crate) fn error_in(unit: &str, error: f64) -> String {
    match unit {
        "rad" => format!("{}°", number(error.to_degrees())),
        "" => number(error),
        unit if unit.starts_with("1/") => format!("{} per {}", number(error), &unit[2..]),
        unit => format!("{} {unit}", number(error)),
    }
}

/// A word as a shell takes it.
pub(crate) fn shell_word(word: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "/\\._-+:,=@%".contains(c);
    if word.chars().all(is_plain) { word.to_owned() } else { format!("'{}'", word.replace('\'', r"'\''")) }
}

/// The first and the last azimuth of a table in degrees; `None` all the way round, or without directions.
pub(crate) fn covered_arc(descriptor: &TextureDescriptor) -> Option<(f64, f64)> {
    let azimuths = descriptor.azimuths().filter(|azimuths| !azimuths.is_full_circle())?;
    let last = azimuths.count().saturating_sub(1);
    let degrees = |index| (azimuths.radians(index).to_degrees() * 1e9).round() / 1e9;
    Some((degrees(0), degrees(last)))
}

/// How far a horizon is from the truth.
pub(crate) fn accuracy(accuracy: &HorizonAccuracy) -> String {
    let HorizonAccuracy { samples, stored_rms_degrees, stored_max_degrees, sweep_rms_degrees, sweep_max_degrees } =
        accuracy;
    format!(
        "as stored {stored_rms_degrees:.3}° RMS, {stored_max_degrees:.2}° at most; before encoding \
         {sweep_rms_degrees:.3}° and {sweep_max_degrees:.2}° ({samples} samples against the exact horizon)"
    )
}

/// How near to the surface rays start.
pub(crate) fn starts(accuracy: &StartAccuracy) -> String {
    let StartAccuracy { samples, mean_start, mean_hit, beyond_share, beyond_max } = accuracy;
    let beyond = match beyond_share {
        0.0 => "none beyond its hit".to_owned(),
        share => format!("{:.2} % beyond their hits, by {beyond_max:.3} at most", 100.0 * share),
    };
    format!("at depth {mean_start:.3} on average where rays hit at {mean_hit:.3}; {beyond} ({samples} rays)")
}

#[cfg(test)]
mod tests {
    use super::{bytes, number};

    #[test]
    fn sizes_and_numbers_are_short() {
        assert_eq!([bytes(0), bytes(1023), bytes(1024), bytes(1_572_864)], ["0 B", "1023 B", "1.0 KiB", "1.5 MiB"]);
        assert_eq!(
            [number(0.0), number(0.25), number(-12.0), number(1234.56), number(2e-9)],
            ["0", "0.25", "-12", "1235", "2.00e-9"]
        );
    }
}
