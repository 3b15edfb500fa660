//! Numbers for people and for spreadsheets.

use std::fmt::Write;

use super::Selection;
use crate::console::number;

/// A heading per layer, then a line per row.
pub(super) fn text(selection: &Selection<'_>) -> String {
    let mut text = String::new();
    for layer in selection.layers.clone() {
        heading(selection, layer, &mut text);
        for row in selection.layer_values(layer).chunks_exact(selection.width() * selection.numbers().len()) {
            for &value in row {
                let value = if selection.is_elevation() { f64::from(value).to_degrees() } else { f64::from(value) };
                // Writing into a String cannot fail.
                let _ = write!(text, "{:>10}", number(value));
            }
            text.push('\n');
        }
    }
    text
}

fn heading(selection: &Selection<'_>, layer: u32, text: &mut String) {
    let descriptor = &selection.table.descriptor;
    let (semantic, width, height) = (descriptor.semantic.name(), descriptor.width, descriptor.height);
    let unit = match descriptor.unit {
        barchan_asset::Unit::Radian => " in degrees".to_owned(),
        barchan_asset::Unit::Length(length) => format!(" in {}", length.symbol()),
        barchan_asset::Unit::None => String::new(),
    };
    let numbers = match selection.numbers() {
        [_] => String::new(),
        numbers => format!(", {} of each texel", numbers.join(", ")),
    };
    let candidate = match descriptor.candidates {
        0 => String::new(),
        _ => format!(", point {}", selection.table.candidate(layer)),
    };
    let azimuth = match selection.is_directional() {
        true => {
            let (direction, azimuth) = (selection.table.direction(layer), selection.table.azimuth_degrees(layer));
            format!(", direction {direction}, azimuth {}°", number(azimuth))
        }
        false => String::new(),
    };
    let _ = writeln!(text, "# {semantic}{unit}{numbers}{candidate}{azimuth}, {width} × {height}");
}

/// A line per texel; elevations as an angle and as a slope. Numbers are written so that they read back to the bit.
pub(super) fn csv(selection: &Selection<'_>) -> String {
    let is_swept = selection.table.descriptor.candidates > 0;
    let mut text = String::new();
    text.push_str(if is_swept { "point," } else { "" });
    text.push_str(if selection.is_directional() { "direction,azimuth_degrees,row,column," } else { "row,column," });
    let names = match selection.is_elevation() {
        true => "elevation_degrees,slope".to_owned(),
        false => selection.numbers().join(","),
    };
    text += &names;
    text.push('\n');
    for layer in selection.layers.clone() {
        let (numbers, width) = (selection.numbers().len(), selection.width());
        for (texel, values) in selection.layer_values(layer).chunks_exact(numbers).enumerate() {
            if is_swept {
                let _ = write!(text, "{},", selection.table.candidate(layer));
            }
            if selection.is_directional() {
                let (direction, azimuth) = (selection.table.direction(layer), selection.table.azimuth_degrees(layer));
                let _ = write!(text, "{direction},{azimuth},");
            }
            let _ = write!(text, "{},{}", texel / width, texel % width);
            csv_values(selection, values, &mut text);
        }
    }
    text
}

fn csv_values(selection: &Selection<'_>, values: &[f32], text: &mut String) {
    for &value in values {
        let _ = match selection.is_elevation() {
            true => {
                let elevation = f64::from(value);
                write!(text, ",{},{}", elevation.to_degrees(), libm::tan(elevation) as f32)
            }
            false => write!(text, ",{value}"),
        };
    }
    text.push('\n');
}
