//! The reference is the supremum: a point of the surface, and none is seen higher.

use barchan_bakers::horizon::reference;
use barchan_field::{Edge, HeightField};
use proptest::prelude::*;

use crate::support::{grid, params};

/// A small rough field, with what a ray in it needs: directions, direction, radius in tiles, texel.
fn scenes() -> impl Strategy<Value = (HeightField, u32, u32, f64, (u32, u32))> {
    let edges = prop_oneof![Just(Edge::Wrap), Just(Edge::Clamp)];
    ((1_u32..8, 2_u32..8), (0.3..3.0, 0.3..3.0), edges, 1_u32..24, 0.05..4.0)
        .prop_flat_map(|(size, spacing, edge, directions, tiles)| {
            let texels = (size.0 * size.1) as usize;
            let heights = prop::collection::vec(-4.0_f32..4.0, texels);
            (Just((size, spacing, edge, directions, tiles)), heights, 0..directions, 0..size.0, 0..size.1)
        })
        .prop_map(|((size, spacing, edge, directions, tiles), heights, direction, column, row)| {
            let field = HeightField::new(grid(size, spacing, edge), heights).unwrap();
            let radius = tiles * field.grid().diagonal();
            (field, directions, direction, radius, (column, row))
        })
}

/// The slope towards the surface at distance `s` along an azimuth, by definition.
fn slope_at(field: &HeightField, azimuth: f64, (column, row): (u32, u32), s: f64) -> f64 {
    let spacing = field.grid().spacing;
    let (x, y) = (f64::from(column), f64::from(row));
    // v points up the picture, rows are counted downwards.
    let there = field.surface(x + s * azimuth.cos() / spacing.u(), y - s * azimuth.sin() / spacing.v());
    (there - field.surface(x, y)) / s
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn nothing_on_the_ray_is_seen_higher((field, directions, direction, radius, texel) in scenes()) {
        const SAMPLES: u32 = 1500;
        let azimuth = std::f64::consts::TAU * f64::from(direction) / f64::from(directions);
        let found = reference::horizon(&field, &params(directions, radius), direction, texel.0, texel.1);
        for k in 1..=SAMPLES {
            let s = radius * f64::from(k) / f64::from(SAMPLES);
            let sampled = slope_at(&field, azimuth, texel, s);
            prop_assert!(sampled <= found.slope + 1e-9, "{sampled} at {s}, above {found:?}");
        }
    }

    #[test]
    fn the_horizon_is_a_point_of_the_surface((field, directions, direction, radius, texel) in scenes()) {
        let azimuth = std::f64::consts::TAU * f64::from(direction) / f64::from(directions);
        let found = reference::horizon(&field, &params(directions, radius), direction, texel.0, texel.1);
        prop_assert!((0.0..=radius).contains(&found.distance), "{found:?}");
        // At distance 0 the slope is the surface's own: a limit, reached up to the bend of the cell.
        let (s, tolerance) = if found.distance > 0.0 { (found.distance, 1e-9) } else { (1e-7, 1e-4) };
        let there = slope_at(&field, azimuth, texel, s);
        prop_assert!((there - found.slope).abs() <= tolerance * (1.0 + there.abs()), "{there} instead of {found:?}");
    }
}
