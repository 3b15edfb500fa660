//! What values can be, known before any is baked: an encoder wants bounds, and the tighter the better.
//!
//! The slope from a texel to a point of the surface is the mean of the surface's slope along the way, so it is nowhere
//! steeper than the steepest place. And the horizon is a supremum over all distances up to the radius: it is at least
//! the slope to the point at the radius, which is nowhere lower than the lowest texel. On a wide map that is nearly level.
//!
//! A kernel in f32 may miss a bound by its rounding, and a fast one may miss a point. The true horizon keeps the bounds,
//! so cutting to them brings a value nearer to it: [`cut`].

use std::ops::RangeInclusive;

use barchan_asset::{MAX_ELEVATION, f32_at_least, f32_at_most};
use barchan_field::{Edge, HeightField};

/// Bounds of the elevations, in radians within ±[`MAX_ELEVATION`], of points that are highest on relief bent by up to
/// `bend` to the convex side: of height h(s) − bend · s², in 1 / length unit; 0 for the horizon itself. The point at the
/// radius is bent most, so another may stand lower by as much. `steepest` is [`steepest_slope`] of the field.
pub(crate) fn of_elevations(field: &HeightField, steepest: f64, radius: f64, bend: f64) -> RangeInclusive<f32> {
    let (lowest, highest) = field.range();
    let lowest_slope = ((f64::from(lowest) - f64::from(highest)) / radius - bend * radius).max(-steepest);
    // A hair wider than the arctangent may be off; but level is level, which costs an encoder nothing.
    let above = |slope: f64| match slope > 0.0 {
        true => f32_at_least(libm::atan(slope)).next_up().min(MAX_ELEVATION),
        false => 0.0,
    };
    -above(-lowest_slope)..=above(steepest)
}

/// Bounds of distances to the horizon.
pub(crate) fn of_distances(radius: f64) -> RangeInclusive<f32> {
    0.0..=f32_at_most(radius)
}

/// Brings values within bounds that the truth keeps.
pub(crate) fn cut(values: &mut [f32], bounds: &RangeInclusive<f32>) {
    for value in values {
        *value = value.clamp(*bounds.start(), *bounds.end());
    }
}

/// The steepest slope of the bilinear surface in any direction, beyond the edge too. In a cell each component of the
/// gradient is interpolated along the other axis, so the gradient is longest at one of the corners.
pub(crate) fn steepest_slope(field: &HeightField) -> f64 {
    let grid = field.grid();
    let (width, height) = (grid.width as usize, grid.height as usize);
    let (per_u, per_v) = (1.0 / grid.spacing.u(), 1.0 / grid.spacing.v());
    let next = |index: usize, count: usize| match grid.edge {
        _ if index + 1 < count => index + 1,
        Edge::Wrap => 0,
        // Beyond the edge the outermost texels go on: level outwards, and along the edge as they are.
        Edge::Clamp => index,
    };
    let row_of = |row: usize| &field.samples()[row * width..][..width];
    let mut longest_squared = 0.0_f64;
    for row in 0..height {
        let (upper, lower) = (row_of(row), row_of(next(row, height)));
        let cell = |left: usize, right: usize| {
            let along = |from: f32, to: f32, per: f64| {
                let slope = (f64::from(to) - f64::from(from)) * per;
                slope * slope
            };
            let u = along(upper[left], upper[right], per_u).max(along(lower[left], lower[right], per_u));
            let v = along(upper[left], lower[left], per_v).max(along(upper[right], lower[right], per_v));
            u + v
        };
        let inner = (1..width).map(|right| cell(right - 1, right)).fold(0.0, f64::max);
        longest_squared = longest_squared.max(inner).max(cell(width - 1, next(width - 1, width)));
    }
    longest_squared.sqrt()
}

#[cfg(test)]
mod tests {
    use barchan_bakers::Exec;
    use barchan_bakers::horizon::{self, Azimuths, BentLayer, HorizonParams, Method, reference};
    use barchan_field::{Grid, LengthUnit, Spacing};

    use super::*;

    fn horizon_bounds(field: &HeightField, radius: f64) -> RangeInclusive<f32> {
        of_elevations(field, steepest_slope(field), radius, 0.0)
    }

    fn scramble(index: u64) -> u64 {
        crate::accuracy::scramble(index)
    }

    fn fields() -> impl Iterator<Item = (HeightField, f64)> {
        (0..48).map(|seed| {
            let random = |index: u64| scramble(seed * 1000 + index);
            let (width, height) = (2 + random(0) as u32 % 9, 1 + random(1) as u32 % 9);
            let edge = if random(2).is_multiple_of(2) { Edge::Wrap } else { Edge::Clamp };
            let spacing = Spacing::new(0.25 + (random(3) % 8) as f64, 0.5).unwrap();
            let roughness = [1.0, 0.01, 1e4][random(4) as usize % 3];
            let grid = Grid { width, height, spacing, unit: LengthUnit::Metre, edge };
            let texel = |index: u64| (roughness * (random(10 + index) % 1000) as f64 / 1000.0) as f32;
            let samples = (0..grid.texels() as u64).map(texel).collect();
            (HeightField::new(grid, samples).unwrap(), [0.3, 3.0, 40.0][random(5) as usize % 3])
        })
    }

    fn params(radius: f64) -> HorizonParams {
        HorizonParams { azimuths: Azimuths::full_circle(7), radius, distance: false, method: Method::Accurate }
    }

    #[test]
    fn every_exact_horizon_lies_within() {
        for (field, radius) in fields() {
            let bounds = horizon_bounds(&field, radius);
            for (k, row) in (0..7).flat_map(|k| (0..field.grid().height).map(move |row| (k, row))) {
                for column in 0..field.grid().width {
                    let elevation = reference::horizon(&field, &params(radius), k, column, row).elevation_radians();
                    assert!(bounds.contains(&elevation), "{elevation} {bounds:?} {:?}", field.grid());
                }
            }
        }
    }

    #[test]
    fn every_baked_value_lies_within_but_for_rounding() {
        let exec = Exec::new(1).unwrap();
        for (field, radius) in fields() {
            for method in Method::ALL {
                let params = HorizonParams { distance: true, method, ..params(radius) };
                let map = horizon::bake(&field, &params, &exec).unwrap();
                let mut cut_map = map.elevation_radians.clone();
                cut(&mut cut_map, &horizon_bounds(&field, radius));
                let moved = map.elevation_radians.iter().zip(&cut_map).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
                assert!(moved < 2e-6, "{moved} {method:?} {:?}", field.grid());
                assert!(map.distance.unwrap().iter().all(|distance| of_distances(radius).contains(distance)));
            }
        }
    }

    #[test]
    fn every_bent_point_lies_within_but_for_rounding() {
        let exec = Exec::new(1).unwrap();
        for (field, radius) in fields() {
            for bend in [-0.5 / radius, 0.0, 0.1 / radius, 2.0 / radius] {
                let bounds = of_elevations(&field, steepest_slope(&field), radius, bend.max(0.0));
                let mut layer = BentLayer::new(&field).unwrap();
                horizon::bake_bent(&field, &params(radius), 3, bend, &exec, &mut layer).unwrap();
                for slope in layer.slope {
                    let elevation = libm::atanf(slope);
                    let nearest = elevation.clamp(*bounds.start(), *bounds.end());
                    assert!((elevation - nearest).abs() < 2e-6, "{elevation} {bounds:?} {bend} {:?}", field.grid());
                }
            }
        }
    }

    #[test]
    fn a_plane_is_as_steep_as_it_is_and_a_wide_map_nearly_level() {
        let grid = Grid { width: 9, height: 7, spacing: Spacing::UNIT, unit: LengthUnit::Metre, edge: Edge::Clamp };
        let plane = (0..63).map(|index| (3 * (index % 9) + 4 * (index / 9)) as f32).collect();
        assert_eq!(steepest_slope(&HeightField::new(grid, plane).unwrap()), 5.0);
        assert_eq!(horizon_bounds(&HeightField::new(grid, vec![3.5; 63]).unwrap(), 10.0), 0.0..=0.0);
        let mut spike = vec![0.0; 63];
        spike[30] = 10.0;
        let bounds = horizon_bounds(&HeightField::new(grid, spike).unwrap(), 1000.0);
        assert!(*bounds.start() > -0.01001 && *bounds.end() > 1.4, "{bounds:?}");
    }
}
