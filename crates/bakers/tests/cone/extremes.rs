//! Fields at the ends of their ranges: finite, in range, and what they should be.

use barchan_bakers::cone::{ConeKind, ConeMap, MAX_RATIO};
use barchan_field::HeightField;

use crate::support::{EDGES, bake, fill, grid, noise};

const KINDS: [ConeKind; 2] = [ConeKind::Strict, ConeKind::Relaxed];

#[track_caller]
fn assert_in_range(map: &ConeMap) {
    assert_eq!(map.values.len(), 2 * map.grid.texels());
    for texel in map.values.chunks(2) {
        assert!((0.0..=1.0).contains(&texel[0]), "{texel:?}");
        assert!((0.0..=MAX_RATIO as f32).contains(&texel[1]), "{texel:?}");
    }
}

fn rough(size: (u32, u32), spacing: (f64, f64), scale: f32, bake_all: impl Fn(&HeightField)) {
    for edge in EDGES {
        bake_all(&fill(grid(size, spacing, edge), |column, row| scale * (2.0 * noise(6, column, row) - 1.0)));
    }
}

fn both(field: &HeightField) {
    KINDS.iter().for_each(|&kind| assert_in_range(&bake(field, kind)));
}

#[test]
fn one_texel_one_row_one_column() {
    for size in [(1, 1), (37, 1), (1, 37), (2, 1), (1, 2), (2, 2), (300, 1), (3, 2)] {
        for spacing in [(1.0, 1.0), (0.3, 2.0)] {
            rough(size, spacing, 3.0, both);
        }
    }
}

#[test]
fn heights_and_texels_at_the_ends_of_their_ranges() {
    for (spacing, scale) in
        [(1e-3, 1e30), (1e-30, f32::MAX), (1e30, f32::MAX), (1.0, f32::MAX), (1e30, 1e-45), (1e-30, 1e-45)]
    {
        rough((12, 9), (spacing, spacing), scale, both);
    }
}

#[test]
fn texels_far_longer_than_wide() {
    for spacing in [(100.0, 1.0), (1.0, 100.0), (1e30, 1.0), (1e-30, 1e30)] {
        rough((16, 12), spacing, 3.0, both);
    }
}

/// Only the heights' differences count, and those of large heights are exact.
#[test]
fn relief_at_a_great_height_is_the_relief() {
    let relief = |column, row| (8.0 * noise(8, column, row)).floor();
    for (edge, kind) in EDGES.into_iter().flat_map(|edge| KINDS.map(|kind| (edge, kind))) {
        let size = grid((16, 16), (1.0, 1.0), edge);
        let (low, high) = (fill(size, relief), fill(size, |column, row| 1e6 + relief(column, row)));
        assert!(bake(&low, kind).values == bake(&high, kind).values);
    }
}
