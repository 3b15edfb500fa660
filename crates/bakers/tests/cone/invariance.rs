//! What must not change a map.

use barchan_bakers::Exec;
use barchan_bakers::cone::{self, ConeKind};
use barchan_field::{Edge, HeightField};

use crate::support::{Relief, bake, fields, fill, grid};

const KINDS: [ConeKind; 2] = [ConeKind::Strict, ConeKind::Relaxed];

#[test]
fn any_number_of_threads_bakes_the_same_bytes() {
    for relief in Relief::ALL {
        let field = relief.field(grid((41, 29), (0.7, 1.9), Edge::Wrap));
        for kind in KINDS {
            let alone = bake(&field, kind);
            for threads in [2, 3] {
                assert!(cone::bake(&field, kind, &Exec::new(threads).unwrap()).unwrap() == alone, "{relief:?}");
            }
        }
    }
}

/// A ridge runs on into the next repetition as it does within the tile.
#[test]
fn a_tile_that_is_moved_along_itself_has_the_moved_map() {
    for relief in Relief::ALL {
        let size = grid((19, 14), (1.0, 1.5), Edge::Wrap);
        let field = relief.field(size);
        let moved = fill(size, |column, row| field.texel(i64::from(column) + 7, i64::from(row) + 9));
        for kind in KINDS {
            let (still, moved) = (bake(&field, kind), bake(&moved, kind));
            for (column, row) in (0..14).flat_map(|row| (0..19).map(move |column| (column, row))) {
                let (a, b) = (moved.ratio(column, row), still.ratio((column + 7) % 19, (row + 9) % 14));
                // Equally promising squares may be looked at in another order.
                assert!((a / b - 1.0).abs() <= 1.0 / 64.0, "{relief:?}, {kind:?}: {a} and {b}");
            }
        }
    }
}

#[test]
fn a_field_twice_as_large_in_every_way_has_the_same_map() {
    for (relief, field) in fields((19, 12)) {
        let spacing = field.grid().spacing;
        let twice = grid((19, 12), (2.0 * spacing.u(), 2.0 * spacing.v()), field.grid().edge);
        let twice = HeightField::new(twice, field.samples().iter().map(|height| 2.0 * height).collect()).unwrap();
        for kind in KINDS {
            assert!(bake(&field, kind).values == bake(&twice, kind).values, "{relief:?}, {kind:?}");
        }
    }
}
