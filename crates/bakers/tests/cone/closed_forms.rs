//! Reliefs whose cones can be written down.

use barchan_bakers::cone::ConeKind;
use barchan_field::Edge;

use crate::support::{bake, fill, grid};

/// Not wider than what is true, and narrower by no more than the tolerance.
#[track_caller]
fn assert_cone(found: f32, expected: f64) {
    let share = f64::from(found) / expected;
    assert!((64.0 / 65.0 - 1e-6..=1.0).contains(&share), "{found} instead of {expected}");
}

/// On a ramp every ascent is of its slope, which is that of lengths: 3/0.5 along u and 2/4 up the picture.
#[test]
fn a_ramp() {
    let field = fill(grid((9, 6), (0.5, 4.0), Edge::Clamp), |column, row| 3.0 * column as f32 - 2.0 * row as f32);
    let map = bake(&field, ConeKind::Strict);
    for (column, row) in (0..6).flat_map(|row| (0..9).map(move |column| (column, row))) {
        assert_cone(map.ratio(column, row), 1.0 / 6.0_f64.hypot(0.5));
        let depth = (3.0 * f64::from(8 - column) + 2.0 * f64::from(row)) / 34.0;
        assert!((f64::from(map.depth(column, row)) - depth).abs() < 1e-7);
    }
}

/// From column n the foot may be at n + 1, and the wall's brink is at column 12.
#[test]
fn level_ground_before_a_wall() {
    let field = fill(grid((20, 5), (0.5, 3.0), Edge::Clamp), |column, _| if column < 12 { 0.0 } else { 4.0 });
    let map = bake(&field, ConeKind::Strict);
    let cap = 10.0_f64.hypot(15.0) / 4.0;
    for row in 0..5 {
        for column in 0..10 {
            assert_cone(map.ratio(column, row), 0.5 * f64::from(11 - column) / 4.0);
        }
        // The wall itself, and what shares a cell with it.
        for column in 10..13 {
            assert_cone(map.ratio(column, row), 0.5 / 4.0);
        }
        for column in 13..20 {
            assert_cone(map.ratio(column, row), cap);
        }
    }
}

/// The nearest corner of the footprint, to the spike or its nearest repetition.
#[test]
fn level_ground_around_a_spike() {
    let (spike, height) = ((5, 4), 3.0);
    for edge in [Edge::Wrap, Edge::Clamp] {
        let field =
            fill(grid((17, 11), (1.0, 2.0), edge), |column, row| if (column, row) == spike { height } else { 0.0 });
        let map = bake(&field, ConeKind::Strict);
        for (column, row) in (0..11_u32).flat_map(|row| (0..17_u32).map(move |column| (column, row))) {
            let away = |index: u32, spike: u32, extent: u32| {
                let straight = index.abs_diff(spike);
                let least = if edge == Edge::Wrap { straight.min(extent - straight) } else { straight };
                f64::from(least)
            };
            let (columns, rows) = (away(column, spike.0, 17), away(row, spike.1, 11));
            if columns > 2.0 || rows > 2.0 {
                let distance = (columns - 1.0).max(0.0).hypot(2.0 * (rows - 1.0).max(0.0));
                assert_cone(map.ratio(column, row), distance / f64::from(height));
            }
        }
    }
}

/// Rays from above level ground never leave a wall that has no far side, and a ridge at its far brink or below.
#[test]
fn relaxed_cones_reach_beyond_the_brink() {
    let cap = 30.0_f64.hypot(3.0) / 4.0;
    let ridge = |from: u32, to: u32| {
        let field = fill(
            grid((30, 3), (1.0, 1.0), Edge::Clamp),
            |column, _| if (from..to).contains(&column) { 4.0 } else { 0.0 },
        );
        bake(&field, ConeKind::Relaxed)
    };
    let wall = ridge(12, 30);
    let wide = ridge(12, 17);
    for column in 0..12 {
        assert_cone(wall.ratio(column, 1), cap);
        assert_cone(wide.ratio(column, 1), f64::from(16 - column) / 4.0);
    }
}

#[test]
fn level_relief_has_the_widest_cone() {
    for kind in [ConeKind::Strict, ConeKind::Relaxed] {
        let map = bake(&fill(grid((5, 4), (1.0, 2.0), Edge::Wrap), |_, _| 7.0), kind);
        assert_eq!((map.relief.top, map.relief.thickness), (7.0, 0.0));
        assert!(map.values.chunks(2).all(|texel| texel[0] == 0.0 && (65503.9..=65504.0).contains(&texel[1])));
    }
}
