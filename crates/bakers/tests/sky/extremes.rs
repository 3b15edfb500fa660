//! Fields at the ends of their ranges: finite, in range, and what they should be.

use barchan_field::{Edge, HeightField};

use crate::support::{
    EDGES, assert_in_range, assert_near, assert_towards, at, bake, fill, grid, horizons, noise, under_skyline,
};

#[test]
fn one_row_one_column_and_two_texels() {
    for edge in EDGES {
        for size in [(37, 1), (1, 37), (2, 1), (1, 2), (2, 2), (300, 1)] {
            for spacing in [(1.0, 1.0), (0.3, 2.0)] {
                let field = fill(grid(size, spacing, edge), |column, row| 3.0 * noise(1, column, row));
                assert_in_range(&bake(&field, &horizons(11, 8.0)));
            }
        }
    }
}

/// A single texel has no horizon to bake, but under one it has a sky.
#[test]
fn one_texel() {
    for edge in EDGES {
        let sky = under_skyline(&fill(grid((1, 1), (1.0, 1.0), edge), |_, _| 7.0), 5, |_| 0.5);
        assert_near(at(&sky, (0, 0)).visibility, 0.5_f64.cos().powi(2), 1e-6);
    }
}

/// The texels at the foot and at the brink of a wall have a normal that is all but level, and see the quarter sphere
/// before it: visibility ½, and ∫ ω (n·ω) = π/3 outwards and 2/3 up.
#[test]
fn a_wall_of_slope_one_million() {
    let field = fill(grid((33, 3), (1.0, 1.0), Edge::Clamp), |column, _| if column < 16 { 0.0 } else { 1e6 });
    let sky = bake(&field, &horizons(64, 60.0));
    assert_in_range(&sky);
    let length = f64::hypot(std::f64::consts::FRAC_PI_3, 2.0 / 3.0);
    let outwards = [-std::f64::consts::FRAC_PI_3 / length, 0.0, 2.0 / 3.0 / length];
    for column in [15, 16] {
        assert_near(at(&sky, (column, 1)).visibility, 0.5, 1e-3);
        assert_towards(at(&sky, (column, 1)).bent_normal, outwards, 1e-2);
    }
    // Level texels before the wall see the half of the sky that is not behind it, those beyond it all. Of 64
    // azimuths, 31 look at the wall and 2 along it.
    assert_near(at(&sky, (13, 1)).visibility, 33.0 / 64.0, 1e-3);
    assert_near(at(&sky, (20, 1)).visibility, 1.0, 1e-6);
}

#[test]
fn relief_at_a_great_height_is_the_relief() {
    let relief = |column, row| (8.0 * noise(8, column, row)).floor();
    for edge in EDGES {
        let size = grid((16, 16), (1.0, 1.0), edge);
        let (low, high) = (fill(size, relief), fill(size, |column, row| 1e7 + relief(column, row)));
        let (low, high) = (bake(&low, &horizons(12, 24.0)), bake(&high, &horizons(12, 24.0)));
        assert_in_range(&high);
        for (low, high) in low.visibility.unwrap().iter().zip(high.visibility.unwrap()) {
            assert_near(f64::from(*low), f64::from(high), 1e-6);
        }
    }
}

#[test]
fn subnormal_heights() {
    for edge in EDGES {
        for spacing in [1.0, 1e-30] {
            let field = fill(grid((12, 9), (spacing, spacing), edge), |column, row| {
                f32::from_bits((noise(7, column, row) * 1000.0) as u32)
            });
            let sky = bake(&field, &horizons(7, 6.3 * spacing));
            assert_in_range(&sky);
            assert!(sky.visibility.unwrap().iter().all(|&visibility| visibility > 0.999_999));
        }
    }
}

#[test]
fn heights_at_the_ends_of_f32_over_tiny_and_huge_texels() {
    let rough = |edge, spacing, scale: f32| -> HeightField {
        fill(grid((12, 9), (spacing, spacing), edge), |column, row| scale * (2.0 * noise(6, column, row) - 1.0))
    };
    for edge in EDGES {
        for (height, spacing) in [(1e30_f32, 1e-3), (f32::MAX, 1e-30), (f32::MAX, 1e30), (f32::MAX, 1.0)] {
            assert_in_range(&bake(&rough(edge, spacing, height), &horizons(7, 6.3 * spacing)));
        }
        // Slopes of hundreds over texels of 1e30 are slopes of hundreds.
        let (huge, plain) = (rough(edge, 1e30, 3e32), rough(edge, 1.0, 300.0));
        let (huge, plain) = (bake(&huge, &horizons(8, 6.3e30)), bake(&plain, &horizons(8, 6.3)));
        for (huge, plain) in huge.visibility.unwrap().iter().zip(plain.visibility.unwrap()) {
            assert_near(f64::from(*huge), f64::from(plain), 1e-5);
        }
    }
}

#[test]
fn texels_a_hundred_times_as_long_as_wide() {
    for edge in EDGES {
        for spacing in [(100.0, 1.0), (1.0, 100.0), (1e30, 1.0), (1.0, 1e30)] {
            let field = fill(grid((16, 12), spacing, edge), |column, row| 3.0 * noise(10, column, row));
            assert_in_range(&bake(&field, &horizons(10, 30.0)));
        }
    }
}

#[test]
fn any_number_of_directions() {
    let field = fill(grid((6, 5), (1.0, 1.0), Edge::Wrap), |column, row| 3.0 * noise(9, column, row));
    let finest = bake(&field, &horizons(2048, 8.0));
    for directions in [3, 5, 97, 2039] {
        let sky = bake(&field, &horizons(directions, 8.0));
        assert_in_range(&sky);
        let worst = errors(&sky, &finest);
        assert!(worst <= 2.0 / f64::from(directions), "{directions}: {worst}");
    }
}

fn errors(a: &barchan_bakers::sky::SkyMap, b: &barchan_bakers::sky::SkyMap) -> f64 {
    let (a, b) = (a.visibility.as_ref().unwrap(), b.visibility.as_ref().unwrap());
    a.iter().zip(b).map(|(a, b)| f64::from((a - b).abs())).fold(0.0, f64::max)
}
