//! The numbers of a table.

use std::format;
use std::string::String;

use crate::TableView;
use crate::bytes::first_nonzero;

/// Reports padding that is not zero, the first value that is not finite or outside the stated range, and a range that
/// the values do not reach. A stated range is legal for its semantic, or the descriptor would have been refused.
pub(super) fn check(table: &TableView<'_>, mut add: impl FnMut(&'static str, String)) {
    let descriptor = table.descriptor();
    for layer in 0..descriptor.layers {
        if let Some(at) = first_nonzero(table.layer_padding(layer)) {
            add("B0504", format!("the padding byte {at} behind layer {layer} is not zero"));
        }
    }
    let (stated_min, stated_max) = (descriptor.range_min as f32, descriptor.range_max as f32);
    let (mut min, mut max) = (f32::INFINITY, f32::NEG_INFINITY);
    for (layer, row) in rows(table) {
        for (column, value) in table.row(layer, row).enumerate() {
            let place = || format!("texel ({column}, {row}) of layer {layer} is {value}");
            if !value.is_finite() {
                return add("B0501", format!("{}; values must be finite", place()));
            }
            if value < stated_min || value > stated_max {
                return add("B0502", format!("{}; the stated range is {stated_min} to {stated_max}", place()));
            }
            min = min.min(value);
            max = max.max(value);
        }
    }
    if min != stated_min || max != stated_max {
        add("B0503", format!("the values span {min} to {max}; the stated range is {stated_min} to {stated_max}"));
    }
}

fn rows(table: &TableView<'_>) -> impl Iterator<Item = (u32, u32)> + use<> {
    let height = table.descriptor().height;
    (0..table.descriptor().layers).flat_map(move |layer| (0..height).map(move |row| (layer, row)))
}
