//! The conservative mode besides its promise: how near the bound is, at the ends of what is accepted, and by any road.

use barchan_asset::{DepthMode, HemisphereDirections};
use barchan_bakers::Exec;
use barchan_bakers::hemisphere::reference::first_hit;
use barchan_bakers::hemisphere::{self, HemisphereBaker, HemisphereMap, HemisphereParams};
use barchan_field::{Edge, HeightField, Shape};
use glam::DVec3;

use crate::support::{bake, directions, field, fill, grid, noise};

/// The deepest value there is.
const DEEPEST: f32 = 254.0 / 255.0;

fn conservative(field: &HeightField, directions: HemisphereDirections, (width, height): (u32, u32)) -> HemisphereMap {
    bake(field, &HemisphereParams { directions, width, height, mode: DepthMode::Conservative })
}

fn fractal(size: u32) -> HeightField {
    let shape = Shape::examples().into_iter().find(|shape| shape.name() == "fractal_terrain").unwrap();
    let field = shape.rasterize(grid((size, size), (1.0, 1.0), Edge::Wrap)).unwrap();
    let (lowest, highest) = field.range();
    let scale = 0.15 * size as f32 / (highest - lowest);
    HeightField::new(*field.grid(), field.samples().iter().map(|height| height * scale).collect()).unwrap()
}

/// The least first hit of rays spread over a texel's footprint and a layer's cell, `steps` along each side.
fn least_of_rays(field: &HeightField, map: &HemisphereMap, layer: u32, texel: (u32, u32), steps: u32) -> f64 {
    let HemisphereParams { directions, width, height, .. } = map.params;
    let (ring, azimuth) = directions.ring_and_azimuth(layer);
    let (inner, outer) = (directions.tangent_of_edge(ring), directions.tangent_of_edge(ring + 1));
    let part = |index: u32| f64::from(index) / f64::from(steps - 1);
    let place = |texel: u32, part: f64, target: u32, source: u32| {
        (f64::from(texel) + part) / f64::from(target) * f64::from(source) - 0.5
    };
    let mut least = 1.0_f64;
    for index in 0..steps.pow(4) {
        let [a, b, c, d] = [1, steps, steps.pow(2), steps.pow(3)].map(|digit| part(index / digit % steps));
        let (x, y) = (place(texel.0, a, width, field.grid().width), place(texel.1, b, height, field.grid().height));
        let tangent = inner + c * (outer - inner);
        let azimuth = directions.azimuths.radians(azimuth) + (d - 0.5) * directions.azimuths.step_radians();
        let (sin, cos) = azimuth.sin_cos();
        least = least.min(first_hit(field, x, y, DVec3::new(tangent * cos, tangent * sin, 1.0)));
    }
    least
}

#[test]
fn the_bound_is_near_the_least_hit_of_many_rays() {
    let field = fractal(128);
    let map = conservative(&field, directions(12, 16, 80.0), (16, 16));
    let (mut start, mut least, mut count) = (0.0, 0.0, 0.0);
    for sample in 0..80 {
        let layer = sample * 37 % map.params.directions.layers();
        let (column, row) = (sample * 7 % 16, sample * 11 / 3 % 16);
        start += f64::from(map.layer(layer)[(row * 16 + column) as usize]);
        least += least_of_rays(&field, &map, layer, (column, row), 5);
        count += 1.0;
    }
    let (start, least) = (start / count, least / count);
    assert!(start <= least && start > 0.3, "{start} of {least}");
    assert!(least - start < 0.03, "{start} of {least}");
}

#[test]
fn relief_without_thickness_starts_at_the_top() {
    for size in [(1, 1), (5, 3)] {
        for edge in [Edge::Wrap, Edge::Clamp] {
            let flat = field(size, edge, |_, _| 3.0);
            assert!(conservative(&flat, directions(3, 4, 80.0), size).depths.iter().all(|&depth| depth == 0.0));
        }
    }
}

#[test]
fn beyond_a_clamped_edge_the_outermost_height_goes_on() {
    // A wall on the left; rays that come from the right leave over its top, those from the left over the floor.
    let wall = field((40, 6), Edge::Clamp, |column, _| if column == 0 { 8.0 } else { 0.0 });
    let directions = directions(8, 4, 88.0);
    let map = conservative(&wall, directions, (40, 6));
    let depth = |azimuth: u32, column: u32| map.layer(directions.layer(7, azimuth))[column as usize];
    for column in 2..40 {
        let from_left = depth(0, column).min(depth(2, column));
        assert!(from_left < DEEPEST - 0.1 && depth(2, column) >= DEEPEST - 1e-5, "column {column}");
    }
    assert_eq!(depth(0, 0), 0.0);
}

#[test]
fn a_smaller_table_is_never_deeper() {
    let relief = fill(grid((48, 48), (1.0, 0.7), Edge::Wrap), |column, row| 9.0 * noise(8, column, row).powi(4));
    let directions = directions(5, 6, 75.0);
    let tables = [48, 24, 12, 6, 3, 1].map(|size| conservative(&relief, directions, (size, size)));
    for pair in tables.windows(2) {
        let (fine, coarse) = (&pair[0], &pair[1]);
        for (index, &depth) in fine.depths.iter().enumerate() {
            let (size, parent) = (fine.params.width as usize, coarse.params.width as usize);
            let (layer, row, column) = (index / (size * size), index / size % size, index % size);
            let (row, column) = (row * parent / size, column * parent / size);
            assert!(coarse.depths[(layer * parent + row) * parent + column] <= depth);
        }
    }
}

#[test]
fn no_overshoot_on_deep_narrow_and_tiny_reliefs() {
    for (size, target) in [((1, 1), (1, 1)), ((2, 1), (1, 1)), ((3, 40), (2, 7)), ((40, 2), (40, 1)), ((9, 9), (4, 9))]
    {
        for (edge, thickness) in [(Edge::Wrap, 100.0), (Edge::Clamp, 100.0), (Edge::Wrap, 4.0), (Edge::Clamp, 1e-3)] {
            let deep = field(size, edge, |column, row| thickness * noise(9, column, row).powi(2));
            let map = conservative(&deep, directions(4, 5, 85.0), target);
            for layer in 0..20 {
                for (index, &start) in map.layer(layer).iter().enumerate() {
                    let texel = (index as u32 % target.0, index as u32 / target.0);
                    let least = least_of_rays(&deep, &map, layer, texel, 3);
                    assert!(f64::from(start) <= least, "{size:?} {edge:?}: start {start} behind {least}");
                }
            }
        }
    }
}

#[test]
fn heights_beyond_all_reason_are_baked() {
    for edge in [Edge::Wrap, Edge::Clamp] {
        let grid = grid((4, 4), (1e-30, 1e-3), edge);
        let absurd = fill(grid, |column, row| if column == row { f32::MAX } else { f32::MIN });
        let map = conservative(&absurd, directions(3, 5, 89.999_999), (4, 4));
        assert!(map.depths.iter().all(|depth| (0.0..=1.0).contains(depth)));
    }
}

#[test]
fn threads_and_layers_change_no_bit() {
    let relief = fill(grid((65, 33), (1.0, 1.0), Edge::Clamp), |column, row| 6.0 * noise(6, column, row));
    let params =
        HemisphereParams { directions: directions(4, 5, 78.0), width: 20, height: 33, mode: DepthMode::Conservative };
    let one = bake(&relief, &params);
    let exec = Exec::new(3).unwrap();
    assert!(one == hemisphere::bake(&relief, &params, &exec).unwrap());
    let baker = HemisphereBaker::new(&relief, params, &exec).unwrap();
    for layer in 0..params.directions.layers() {
        let mut depths = vec![0.0; 20 * 33];
        baker.bake_layer(layer, &exec, &mut depths);
        assert!(depths == one.layer(layer));
    }
}
