//! The levels of maximum heights against each other.

use std::format;
use std::string::String;

use crate::{Semantic, TableView};

/// Reports the first texel that is less than one of the level before which it stands for. Other tables are passed over.
pub(super) fn check(table: &TableView<'_>, mut add: impl FnMut(&'static str, String)) {
    if table.descriptor().semantic != Semantic::MaximumHeight {
        return;
    }
    let too_low = (1..table.descriptor().mips).find_map(|level| too_low(table, level));
    if let Some(message) = too_low {
        add("B0513", message);
    }
}

fn too_low(table: &TableView<'_>, level: u32) -> Option<String> {
    let (width, height) = table.descriptor().picture_extent(level);
    let (finer_width, finer_height) = table.descriptor().picture_extent(level - 1);
    for row in 0..finer_height {
        for column in 0..finer_width {
            let (coarse_column, coarse_row) = ((column / 2).min(width - 1), (row / 2).min(height - 1));
            let coarse = table.value(level, coarse_column, coarse_row);
            let fine = table.value(level - 1, column, row);
            if coarse < fine {
                return Some(format!(
                    "texel ({coarse_column}, {coarse_row}) of level {level} is {coarse}, but ({column}, {row}) of the \
                     level before is {fine}"
                ));
            }
        }
    }
    None
}
