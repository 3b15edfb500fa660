//! Numbers for people and for spreadsheets.

use std::fmt::Write;

use super::Selection;
use crate::console::number;

/// A heading per layer, then a line per row.
pub(super) fn text(selection: &Selection<'_>) -> String {
    let mut text = String::new();
    for layer in selection.layers.clone() {
        heading(selection, layer, &mut text);
        let values: Vec<f32> = selection.layer_values(layer).collect();
        for row in values.chunks_exact(selection.width()) {
            for &value in row {
                let value = if selection.is_horizon() { f64::from(value).to_degrees() } else { f64::from(value) };
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
    let unit = if selection.is_horizon() { "degrees" } else { descriptor.length_unit.symbol() };
    let azimuth = match descriptor.semantic.is_directional() {
        true => format!(", direction {layer}, azimuth {}°", number(selection.table.azimuth_degrees(layer))),
        false => String::new(),
    };
    let _ = writeln!(text, "# {semantic} in {unit}{azimuth}, {width} × {height}");
}

/// A line per value; horizons as an angle and as a slope. Numbers are written so that they read back to the bit.
pub(super) fn csv(selection: &Selection<'_>) -> String {
    let directional = selection.table.descriptor.semantic.is_directional();
    let mut text = String::new();
    text.push_str(if directional { "direction,azimuth_degrees,row,column," } else { "row,column," });
    text.push_str(match selection.table.table.name() {
        "horizon" => "elevation_degrees,slope\n",
        name => return csv_lengths(selection, text + name + "\n"),
    });
    each_value(selection, |layer, row, column, value| {
        let elevation = f64::from(value);
        let (azimuth, degrees) = (selection.table.azimuth_degrees(layer), elevation.to_degrees());
        let _ = writeln!(text, "{layer},{azimuth},{row},{column},{degrees},{}", libm::tan(elevation) as f32);
    });
    text
}

fn csv_lengths(selection: &Selection<'_>, mut text: String) -> String {
    let directional = selection.table.descriptor.semantic.is_directional();
    each_value(selection, |layer, row, column, value| {
        if directional {
            let _ = write!(text, "{layer},{},", selection.table.azimuth_degrees(layer));
        }
        let _ = writeln!(text, "{row},{column},{value}");
    });
    text
}

fn each_value(selection: &Selection<'_>, mut visit: impl FnMut(u32, usize, usize, f32)) {
    let width = selection.width();
    for layer in selection.layers.clone() {
        for (index, value) in selection.layer_values(layer).enumerate() {
            visit(layer, index / width, index % width, value);
        }
    }
}
