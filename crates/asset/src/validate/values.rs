//! The numbers of a table.

use std::format;
use std::string::String;

use crate::bytes::first_nonzero;
use crate::{Semantic, TableView, Transfer};

/// What a direction's squared length may be off by, besides what its encoding costs.
const UNIT_LENGTH_SLACK: f64 = 1e-6;

/// Reports padding that is not zero, the first value that is not what the format allows, and a range that the values do
/// not reach. A stated range is legal for its semantic, or the descriptor would have been refused.
pub(super) fn check(table: &TableView<'_>, mut add: impl FnMut(&'static str, String)) {
    for layer in 0..table.descriptor().pictures() {
        if let Some(at) = first_nonzero(table.layer_padding(layer)) {
            add("B0504", format!("the padding byte {at} behind layer {layer} is not zero"));
        }
    }
    let mut values = Values::new(table);
    for (layer, row) in rows(table) {
        if let Err((id, message)) = values.check_row(layer, row) {
            return add(id, message);
        }
    }
    if let Err((id, message)) = values.check_ends() {
        add(id, message);
    }
}

fn rows(table: &TableView<'_>) -> impl Iterator<Item = (u32, u32)> + use<> {
    let descriptor = *table.descriptor();
    (0..descriptor.pictures())
        .flat_map(move |layer| (0..descriptor.picture_extent(layer).1).map(move |row| (layer, row)))
}

/// A finding's number and sentence.
type Complaint = (&'static str, String);

/// The values of a table against what its descriptor states.
struct Values<'a, 'b> {
    table: &'a TableView<'b>,
    /// The least and the greatest value that the stated range allows.
    accepted: (f32, f32),
    /// The least and the greatest value that were seen.
    seen: (f32, f32),
}

impl<'a, 'b> Values<'a, 'b> {
    fn new(table: &'a TableView<'b>) -> Self {
        let (min, max) = (table.descriptor().range_min as f32, table.descriptor().range_max as f32);
        // Another writer's arcsine may differ in the last place.
        let accepted = match table.descriptor().transfer {
            Transfer::Sine => (min.next_down(), max.next_up()),
            _ => (min, max),
        };
        Self { table, accepted, seen: (f32::INFINITY, f32::NEG_INFINITY) }
    }

    fn check_row(&mut self, layer: u32, row: u32) -> Result<(), Complaint> {
        let descriptor = *self.table.descriptor();
        let (transfer, channels) = (descriptor.transfer, descriptor.format.channels() as usize);
        let numbers = self.table.row_before_transfer(layer, row).zip(self.table.row(layer, row));
        for (index, (t, value)) in numbers.enumerate() {
            let place = || format!("texel ({}, {row}) of layer {layer} is {value}", index / channels);
            if !value.is_finite() {
                return Err(("B0501", format!("{}; values must be finite", place())));
            }
            if descriptor.semantic.is_plain((index % channels) as u32) {
                if !(0.0..=1.0).contains(&value) {
                    return Err(("B0512", format!("{}; a depth is within 0 to 1", place())));
                }
            } else if !in_domain(transfer, t) {
                return Err(("B0505", format!("{} from {t}, outside the domain of {}", place(), transfer.name())));
            }
            if value < self.accepted.0 || value > self.accepted.1 {
                let (min, max) = (descriptor.range_min, descriptor.range_max);
                return Err(("B0502", format!("{}; the stated range is {min} to {max}", place())));
            }
            self.seen = (self.seen.0.min(value), self.seen.1.max(value));
        }
        self.check_directions(layer, row)
    }

    /// Whether every texel's direction is one, give or take what the encoding costs.
    fn check_directions(&self, layer: u32, row: u32) -> Result<(), Complaint> {
        let descriptor = self.table.descriptor();
        let components = match descriptor.semantic {
            Semantic::BentNormal => 2,
            Semantic::ApertureCone => 3,
            _ => return Ok(()),
        };
        let error = descriptor.worst_case_error;
        for column in 0..descriptor.width {
            let size = |channel| f64::from(self.table.channel(layer, column, row, channel)).abs();
            let squared = |move_by: f64| -> f64 {
                (0..components).map(|channel| (size(channel) + move_by).max(0.0)).map(|size| size * size).sum()
            };
            let (least, greatest) = (squared(-error), squared(error));
            // The height of a bent normal is whatever its two components leave.
            let too_short = components == 3 && greatest < 1.0 - UNIT_LENGTH_SLACK;
            if too_short || least > 1.0 + UNIT_LENGTH_SLACK {
                let length = squared(0.0);
                return Err(("B0506", format!("texel ({column}, {row}) has a direction of squared length {length}")));
            }
        }
        Ok(())
    }

    fn check_ends(&self) -> Result<(), Complaint> {
        let (min, max) = (self.table.descriptor().range_min as f32, self.table.descriptor().range_max as f32);
        let reached = |seen: f32, stated: f32| {
            let exact = self.table.descriptor().transfer != Transfer::Sine;
            seen == stated || !exact && (seen == stated.next_up() || seen == stated.next_down())
        };
        if reached(self.seen.0, min) && reached(self.seen.1, max) {
            return Ok(());
        }
        let (least, greatest) = self.seen;
        Err(("B0503", format!("the values span {least} to {greatest}; the stated range is {min} to {max}")))
    }
}

/// Whether a stored number can be the sine of an elevation or the root of a distance.
fn in_domain(transfer: Transfer, t: f32) -> bool {
    match transfer {
        Transfer::Identity => true,
        Transfer::Sine => (-1.0..=1.0).contains(&t),
        Transfer::Square => t >= 0.0,
    }
}
