//! Fields of one texel, of one row, and of absurd heights.

use barchan_bakers::hemisphere::reference::first_hit;
use barchan_field::{Edge, HeightField};

use crate::support::{assert_near, bake, directions, field, fill, grid, towards, whole};

const EDGES: [Edge; 2] = [Edge::Wrap, Edge::Clamp];

/// Every ray ends where the reference ends it.
#[track_caller]
fn assert_agrees(field: &HeightField) {
    let directions = directions(4, 6, 85.0);
    let map = bake(field, &whole(field, directions));
    let width = field.grid().width as usize;
    for layer in 0..directions.layers() {
        for (texel, &depth) in map.layer(layer).iter().enumerate() {
            let (x, y) = ((texel % width) as f64, (texel / width) as f64);
            assert_near(depth, first_hit(field, x, y, towards(&directions, layer)), 1e-5);
        }
    }
}

#[test]
fn one_texel_is_flat() {
    for edge in EDGES {
        let field = field((1, 1), edge, |_, _| 3.0);
        let map = bake(&field, &whole(&field, directions(4, 6, 85.0)));
        assert_eq!(map.depths, [0.0; 24]);
        assert_agrees(&field);
    }
}

#[test]
fn one_row_or_column_is_a_profile() {
    for edge in EDGES {
        for size in [(5, 1), (1, 5), (2, 2), (40, 1)] {
            assert_agrees(&field(size, edge, |column, row| ((3 * column + 2 * row) % 5) as f32));
        }
    }
}

#[test]
fn texels_as_unlike_as_can_be_are_crossed_rightly() {
    for edge in EDGES {
        assert_agrees(&fill(grid((6, 5), (1.0, 1e-2), edge), |column, row| ((2 * column + 3 * row) % 5) as f32));
        assert_agrees(&fill(grid((6, 5), (1e-30, 1e30), edge), |_, row| row as f32 * 1e-30));
    }
}

/// Walls of 10³⁰ texels: a ray that is not vertical and not stopped at once would cross for ever what it has no hit in. It is left
/// after 2¹⁷ texels, hardly below the top.
#[test]
fn walls_without_end_leave_a_ray_where_it_was_given_up() {
    for edge in EDGES {
        let field = field((4, 3), edge, |column, _| if column == 0 { 0.0 } else { -1e30 });
        let directions = directions(2, 4, 60.0);
        let map = bake(&field, &whole(&field, directions));
        assert_eq!(map.relief.thickness, f64::from(1e30_f32));
        assert_eq!(map.layer(0)[..4], [0.0, 1.0, 1.0, 1.0]);
        // From the right to the left the rays come to the wall, at depths of some 10⁻³⁰; up and down they never do.
        assert!(map.layer(4).iter().all(|&depth| depth < 1e-29));
        let given_up = 131_072.0 / (1e30 * 30_f64.to_radians().tan());
        for (column, &depth) in map.layer(5)[..4].iter().enumerate() {
            let expected = if column == 0 { 0.0 } else { given_up };
            assert!((f64::from(depth) - expected).abs() <= 1e-6 * given_up, "{depth:e} instead of {expected:e}");
            assert_eq!(first_hit(&field, column as f64, 0.0, towards(&directions, 5)) as f32, depth);
        }
    }
}

#[test]
fn the_whole_range_of_floats_is_a_thickness() {
    let field = field((3, 3), Edge::Clamp, |column, _| if column == 1 { f32::MAX } else { f32::MIN });
    let map = bake(&field, &whole(&field, directions(3, 4, 80.0)));
    assert_eq!(map.relief.thickness, 2.0 * f64::from(f32::MAX));
    assert!(map.depths.iter().all(|depth| (0.0..=1.0).contains(depth)));
}
