//! Reliefs whose depths are known.

use barchan_bakers::hemisphere::HemisphereMap;
use barchan_field::{Edge, HeightField};

use crate::support::{assert_near, bake, directions, field, fill, grid, noise, whole};

/// Eight rings up to 72°: edges at multiples of 9°. Four azimuths: from the right, from the top, from the left, from the bottom.
const RINGS: u32 = 8;

fn tangent(ring: u32) -> f64 {
    (9.0 * f64::from(ring)).to_radians().tan()
}

/// The depths of a ring and azimuth at a texel.
fn at(map: &HemisphereMap, (ring, azimuth): (u32, u32), (column, row): (u32, u32)) -> f32 {
    map.layer(map.params.directions.layer(ring, azimuth))[(row * map.params.width + column) as usize]
}

fn four_sides(field: &HeightField) -> HemisphereMap {
    bake(field, &whole(field, directions(RINGS, 4, 72.0)))
}

#[test]
fn straight_down_the_depth_is_the_texels_own() {
    let field = field((19, 11), Edge::Wrap, |column, row| 7.0 * noise(1, column, row) - 3.0);
    let (lowest, highest) = field.range();
    let map = four_sides(&field);
    for layer in 0..4 {
        for (depth, &height) in map.layer(layer).iter().zip(field.samples()) {
            let expected = (f64::from(highest) - f64::from(height)) / (f64::from(highest) - f64::from(lowest));
            assert_eq!(*depth, expected as f32);
        }
    }
}

#[test]
fn a_flat_relief_is_met_at_the_top() {
    for height in [0.0, -3.5, 1e7, 1e30] {
        let map = four_sides(&field((5, 4), Edge::Wrap, |_, _| height));
        assert_eq!((map.relief.top, map.relief.thickness), (f64::from(height), 0.0));
        assert!(map.depths.iter().all(|&depth| depth == 0.0));
    }
}

/// Texels of 0.5 by 2, so that the columns of a slope are seen apart from its rows.
#[test]
fn a_slope_is_met_where_ray_and_slope_cross() {
    let rise_per_column = 0.25;
    let field = fill(grid((41, 3), (0.5, 2.0), Edge::Clamp), |column, _| rise_per_column * column as f32);
    let slope = f64::from(rise_per_column) / 0.5;
    let map = four_sides(&field);
    for ring in 0..RINGS {
        for column in 0..41 {
            let own = f64::from(40 - column) / 40.0;
            // A ray from the right falls with the slope, maybe until it is as low as the lowest; one from the left meets it.
            let falling =
                if slope * tangent(ring) < 1.0 { (own / (1.0 - slope * tangent(ring))).min(1.0) } else { 1.0 };
            let expected = if own == 0.0 { 0.0 } else { falling };
            assert_near(at(&map, (ring, 0), (column, 1)), expected, 1e-6);
            assert_near(at(&map, (ring, 2), (column, 1)), own / (1.0 + slope * tangent(ring)), 1e-6);
            for along in [1, 3] {
                assert_near(at(&map, (ring, along), (column, 1)), own, 1e-6);
            }
        }
    }
}

/// The ground is at 0 up to row 20 and the wall at 6 from row 21 on; between them is a ramp one row wide.
#[test]
fn a_wall_is_met_on_its_ramp_by_rays_that_reach_it() {
    let field = field((3, 30), Edge::Clamp, |_, row| if row > 20 { 6.0 } else { 0.0 });
    let map = four_sides(&field);
    for ring in 0..RINGS {
        for row in 0..30 {
            // From the top of the picture the rays run to greater rows.
            let reaches = f64::from(row) + 6.0 * tangent(ring) > 20.0;
            let expected = match row {
                21.. => 0.0,
                _ if reaches => f64::from(21 - row) / (1.0 + 6.0 * tangent(ring)),
                _ => 1.0,
            };
            assert_near(at(&map, (ring, 1), (1, row)), expected, 1e-6);
        }
    }
}

/// Along the diagonal through its peak the surface of a single texel of height 1 is (1 − a)², a cells from the peak.
#[test]
fn a_spike_is_met_on_its_flank() {
    let size = 21;
    let field = field((size, size), Edge::Clamp, |column, row| if (column, row) == (10, 10) { 4.0 } else { 0.0 });
    let map = bake(&field, &whole(&field, directions(RINGS, 8, 72.0)));
    for ring in 1..RINGS {
        // From the bottom right, azimuth 315°, to the top left.
        let cells_per_depth = 4.0 * tangent(ring) * std::f64::consts::FRAC_1_SQRT_2;
        for before in 0..=10 {
            // The depth at which the ray is a cells before the peak is 1 − (1 − a)²; a = before − cells · depth.
            let (p, b) = (cells_per_depth, 1.0 - f64::from(before));
            // (b + p d)² = 1 − d, whose root is the greater one: on the near flank.
            let linear = 2.0 * b * p + 1.0;
            let depth = ((linear * linear - 4.0 * p * p * (b * b - 1.0)).max(0.0).sqrt() - linear) / (2.0 * p * p);
            let reaches = f64::from(before) - p < 1.0;
            let expected = if reaches { depth } else { 1.0 };
            assert_near(at(&map, (ring, 7), (10 + before, 10 + before)), expected, 2e-6);
        }
    }
}
