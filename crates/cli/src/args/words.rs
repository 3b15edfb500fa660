//! Words and numbers of the command line as values, and what would be accepted instead.

use barchan_field::{Edge, LengthUnit, Spacing};
use barchan_import::{Fill, Integers};
use barchan_pipeline::{Compression, CurvaturePart, HemisphereMode, Table, TableEncoding};

use super::MethodName;

/// A parser of words from a fixed list.
fn word<T: Copy>(text: &str, words: &[(&str, T)]) -> Result<T, String> {
    let found = words.iter().find(|(word, _)| *word == text);
    found.map(|(_, value)| *value).ok_or_else(|| {
        let accepted: Vec<_> = words.iter().map(|(word, _)| *word).collect();
        format!("accepted: {}", accepted.join(", "))
    })
}

pub(super) fn table(text: &str) -> Result<Table, String> {
    word(text, &Table::ALL.map(|table| (table.name(), table)))
}

pub(super) fn part(text: &str) -> Result<CurvaturePart, String> {
    word(text, &CurvaturePart::ALL.map(|part| (part.name(), part)))
}

pub(super) fn edge(text: &str) -> Result<Edge, String> {
    word(text, &[Edge::Wrap, Edge::Clamp].map(|edge| (edge.name(), edge)))
}

pub(super) fn unit(text: &str) -> Result<LengthUnit, String> {
    let units = [
        ("scene_unit", LengthUnit::SceneUnit),
        ("metre", LengthUnit::Metre),
        ("centimetre", LengthUnit::Centimetre),
        ("millimetre", LengthUnit::Millimetre),
        ("kilometre", LengthUnit::Kilometre),
    ];
    word(text, &units)
}

pub(super) fn integers(text: &str) -> Result<Integers, String> {
    word(text, &[("normalised", Integers::Normalised), ("raw", Integers::Raw)])
}

pub(super) fn encoding(text: &str) -> Result<TableEncoding, String> {
    let encodings = [
        ("f32", TableEncoding::F32),
        ("f16", TableEncoding::F16),
        ("u8", TableEncoding::U8),
        ("compact", TableEncoding::Compact),
    ];
    word(text, &encodings)
}

pub(super) fn method(text: &str) -> Result<MethodName, String> {
    word(text, &MethodName::ALL.map(|method| (method.name(), method)))
}

pub(super) fn depth_mode(text: &str) -> Result<HemisphereMode, String> {
    word(text, &[HemisphereMode::Conservative, HemisphereMode::Nearest].map(|mode| (mode.name(), mode)))
}

pub(super) fn size(text: &str) -> Result<(u32, u32), String> {
    let (width, height) = text.split_once(',').unwrap_or((text, text));
    let texels = |text: &str| {
        let texels = text.trim().parse().ok().filter(|&texels| texels > 0);
        texels.ok_or_else(|| "accepted: a number of texels, or two with a comma".to_owned())
    };
    Ok((texels(width)?, texels(height)?))
}

pub(super) fn hard_edge(text: &str) -> Result<f64, String> {
    number(text, "0 to 180 degrees", |value| (0.0..=180.0).contains(&value))
}

pub(super) fn arc(text: &str) -> Result<(f64, f64), String> {
    let accepted = || "accepted: degrees from within ±360 to a larger number, less than 360 beyond".to_owned();
    let (first, last) = text.split_once(',').ok_or_else(accepted)?;
    let (first, last) = (finite(first).map_err(|_| accepted())?, finite(last).map_err(|_| accepted())?);
    let is_arc = first.abs() <= 360.0 && last > first && last - first < 360.0;
    if is_arc { Ok((first, last)) } else { Err(accepted()) }
}

pub(super) fn view(text: &str) -> Result<(f64, f64), String> {
    let accepted = || "accepted: an azimuth within ±360 degrees and an elevation within ±90, such as 30,25".to_owned();
    let (azimuth, elevation) = text.split_once(',').ok_or_else(accepted)?;
    let (azimuth, elevation) = (finite(azimuth).map_err(|_| accepted())?, finite(elevation).map_err(|_| accepted())?);
    let is_view = azimuth.abs() <= 360.0 && elevation.abs() <= 90.0;
    if is_view { Ok((azimuth, elevation)) } else { Err(accepted()) }
}

pub(super) fn compression(text: &str) -> Result<Compression, String> {
    word(text, &[("none", Compression::None), ("zstd", Compression::Zstd)])
}

pub(super) fn fill(text: &str) -> Result<Fill, String> {
    match text {
        "lowest" => Ok(Fill::Lowest),
        "nearest" => Ok(Fill::Nearest),
        length => finite(length).map(Fill::Value).map_err(|_| "accepted: lowest, nearest or a length".to_owned()),
    }
}

pub(super) fn jobs(text: &str) -> Result<usize, String> {
    // Beyond that a machine spends its time on starting threads, or fails to.
    text.parse().ok().filter(|&jobs| jobs <= 1024).ok_or_else(|| "accepted: 0 to 1024".to_owned())
}

pub(super) fn finite(text: &str) -> Result<f64, String> {
    number(text, "a finite number", |value| value.is_finite())
}

pub(super) fn positive(text: &str) -> Result<f64, String> {
    number(text, "a positive number", |value| value > 0.0 && value.is_finite())
}

pub(super) fn not_negative(text: &str) -> Result<f64, String> {
    number(text, "a number that is not negative", |value| value >= 0.0 && value.is_finite())
}

pub(super) fn elevation(text: &str) -> Result<f64, String> {
    number(text, "-90 to 90 degrees", |value| (-90.0..=90.0).contains(&value))
}

pub(super) fn above_horizon(text: &str) -> Result<f64, String> {
    number(text, "more than 0, up to 90 degrees", |value| value > 0.0 && value <= 90.0)
}

fn number(text: &str, accepted: &str, accepts: impl Fn(f64) -> bool) -> Result<f64, String> {
    text.trim().parse().ok().filter(|&value| accepts(value)).ok_or_else(|| format!("accepted: {accepted}"))
}

pub(super) fn spacing(text: &str) -> Result<Spacing, String> {
    let (u, v) = text.split_once(',').unwrap_or((text, text));
    let length = |text: &str| text.trim().parse().map_err(|_| "accepted: a length, or two with a comma".to_owned());
    Spacing::new(length(u)?, length(v)?).map_err(|error| error.to_string())
}
