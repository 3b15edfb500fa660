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
    let Selection { table, .. } = selection;
    let descriptor = &table.descriptor;
    let (semantic, (width, height)) = (descriptor.semantic.name(), selection.extent());
    let unit = match descriptor.unit {
        barchan_asset::Unit::Radian => " in degrees".to_owned(),
        barchan_asset::Unit::Length(length) => format!(" in {}", length.symbol()),
        barchan_asset::Unit::None => String::new(),
    };
    let numbers = match selection.numbers() {
        [_] => String::new(),
        numbers => format!(", {} of each texel", numbers.join(", ")),
    };
    let level = if descriptor.mips > 1 { format!(", level {layer}") } else { String::new() };
    let direction = direction_words(selection, layer);
    let _ = writeln!(text, "# {semantic}{unit}{numbers}{level}{direction}, {width} × {height}");
}

/// `, point 1, direction 3, azimuth 33.75°`, `, ring 2 from 12.5°, direction 3, azimuth 67.5°`, or nothing.
fn direction_words(selection: &Selection<'_>, layer: u32) -> String {
    let Selection { table, .. } = selection;
    if !selection.is_directional() {
        return String::new();
    }
    let group = match (table.candidate_or_ring(layer), table.descriptor.candidates, table.descriptor.rings) {
        (_, 0, 0) => String::new(),
        (point, _, 0) => format!(", point {point}"),
        (ring, _, _) => format!(", ring {ring} from {}°", number(table.polar_degrees(ring))),
    };
    let (direction, azimuth) = (table.direction(layer), number(table.azimuth_degrees(layer)));
    format!("{group}, direction {direction}, azimuth {azimuth}°")
}

/// A line per texel; elevations as an angle and as a slope. Numbers are written so that they read back to the bit.
pub(super) fn csv(selection: &Selection<'_>) -> String {
    let descriptor = &selection.table.descriptor;
    let (is_swept, has_rings) = (descriptor.candidates > 0, descriptor.rings > 0);
    let mut text = String::new();
    text.push_str(if is_swept { "point," } else { "" });
    text.push_str(if has_rings { "ring,polar_degrees," } else { "" });
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
            let group = selection.table.candidate_or_ring(layer);
            if is_swept {
                let _ = write!(text, "{group},");
            }
            if has_rings {
                let _ = write!(text, "{group},{},", selection.table.polar_degrees(group));
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
