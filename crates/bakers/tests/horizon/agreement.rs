//! The sweep against the reference: never above, and below by no more than is written here.

use barchan_bakers::horizon::{HorizonMap, HorizonParams, Method, reference};
use barchan_field::{Edge, Grid, HeightField, Shape};
use barchan_metrics::ErrorStats;

use crate::support::{bake, fill, grid, noise, params};

/// How far a stored elevation may be above the reference by rounding, in radians.
const ABOVE: f64 = 4e-5;

/// What is left of the exact method's error by rounding to f32, in degrees.
const EXACT: (f64, f64) = (5e-6, 2e-5);

/// The sweep's elevation less the reference's, in radians, at every `stride`th texel of every direction.
fn errors(field: &HeightField, map: &HorizonMap, stride: usize) -> ErrorStats {
    let (width, params) = (field.grid().width, &map.params);
    let texels = (0..field.grid().texels() as u32).step_by(stride);
    let of_texel = |direction: u32, texel: u32| {
        let expected = reference::horizon(field, params, direction, texel % width, texel / width);
        let error = f64::from(map.elevation_layer(direction)[texel as usize]) - expected.slope.atan();
        assert!(error <= ABOVE, "{error:e} above, direction {direction}, texel {texel}, {params:?}");
        error
    };
    ErrorStats::of(
        (0..params.directions()).flat_map(|k| texels.clone().map(move |t| (k, t))).map(|(k, t)| of_texel(k, t)),
    )
}

fn example(name: &str, size: u32, edge: Edge) -> HeightField {
    let shape = Shape::examples().into_iter().find(|shape| shape.name() == name).unwrap();
    let length = 256.0 / f64::from(size);
    shape.rasterize(grid((size, size), (length, length), edge)).unwrap()
}

fn default_params(grid: &Grid, directions: u32) -> HorizonParams {
    params(directions, HorizonParams::default_radius(grid))
}

/// The table's own numbers are a little above what was measured: RMS and largest error, in degrees, over 16 and 17 azimuths.
#[test]
fn no_example_is_farther_below_the_reference_than_stated() {
    #[rustfmt::skip]
    let table = [
        // field            edge         sweep          accurate
        ("plane",           Edge::Clamp, (0.05, 2.2),   (0.01, 0.7)),
        ("step_wall",       Edge::Clamp, (0.4, 14.7),   (0.096, 2.)),
        ("spike",           Edge::Clamp, (0.53, 44.7),  (0.001, 0.1)),
        ("ripples",         Edge::Wrap,  (0.16, 2.8),   (0.03, 1.)),
        ("ripples",         Edge::Clamp, (0.16, 2.8),   (0.03, 1.)),
        ("gaussian",        Edge::Clamp, (0.07, 1.2),   (0.035, 0.7)),
        ("pyramid",         Edge::Clamp, (0.15, 2.6),   (0.052, 1.3)),
        ("cylinder_bumps",  Edge::Wrap,  (0.12, 2.1),   (0.018, 0.7)),
        ("cylinder_bumps",  Edge::Clamp, (0.12, 2.),    (0.016, 0.8)),
        ("reptile_skin",    Edge::Wrap,  (0.19, 2.8),   (0.018, 0.7)),
        ("reptile_skin",    Edge::Clamp, (0.19, 2.9),   (0.02, 0.9)),
        ("dunes",           Edge::Wrap,  (0.21, 3.8),   (0.058, 1.4)),
        ("dunes",           Edge::Clamp, (0.21, 3.8),   (0.061, 1.9)),
        ("fractal_terrain", Edge::Wrap,  (0.42, 7.5),   (0.056, 1.6)),
        ("fractal_terrain", Edge::Clamp, (0.43, 6.6),   (0.054, 1.5)),
    ];
    let mut exceeded = Vec::new();
    for (name, edge, sweep, accurate) in table {
        let field = example(name, 96, edge);
        for (method, (rms, max)) in [(Method::Sweep, sweep), (Method::Accurate, accurate), (Method::Exact, EXACT)] {
            let mut found = ErrorStats::default();
            for directions in [16, 17] {
                let params = HorizonParams { method, ..default_params(field.grid(), directions) };
                found.merge(&errors(&field, &bake(&field, &params), 11));
            }
            let (found_rms, found_max) = (found.rms().to_degrees(), found.max().to_degrees());
            if found_rms > rms || found_max > max {
                exceeded.push(format!("{name}, {edge:?}, {}: {found_rms:.4}°, {found_max:.4}°", method.name()));
            }
        }
    }
    assert!(exceeded.is_empty(), "farther off than stated:\n{}", exceeded.join("\n"));
}

#[test]
fn no_count_of_directions_lifts_the_sweep_above_the_reference() {
    let field = example("fractal_terrain", 48, Edge::Wrap);
    for directions in [1, 2, 3, 5, 6, 7, 9, 11, 13, 17, 23, 31, 64, 127] {
        let map = bake(&field, &default_params(field.grid(), directions));
        let found = errors(&field, &map, 37);
        assert!(found.rms().to_degrees() < 0.3, "{directions} directions: {}°", found.rms().to_degrees());
    }
}

#[test]
fn no_radius_and_no_texel_shape_lifts_the_sweep_above_the_reference() {
    // White noise is the worst there is: nothing that one line sees tells what the next one does.
    for (edge, spacing, radius, rms) in [
        (Edge::Wrap, (1.0, 1.0), 0.75, 1e-5),
        (Edge::Wrap, (1.0, 1.0), 1.0, 1e-5),
        (Edge::Wrap, (1.0, 1.0), 3.5, 0.01),
        (Edge::Clamp, (1.0, 1.0), 4.0, 0.04),
        (Edge::Clamp, (1.0, 1.0), 4.5, 0.1),
        (Edge::Wrap, (0.7, 1.9), 9.3, 0.3),
        (Edge::Clamp, (3.0, 0.4), 20.0, 0.3),
        (Edge::Wrap, (1.0, 1.0), 117.0, 0.3),
    ] {
        let field = fill(grid((24, 17), spacing, edge), |column, row| 2.0 * noise(5, column, row));
        let map = bake(&field, &params(19, radius));
        let found = errors(&field, &map, 1);
        let found = found.rms().to_degrees();
        assert!(found <= rms, "{edge:?}, texels {spacing:?}, radius {radius}: {found}°");
    }
}

#[test]
fn nine_distances_of_ten_agree() {
    let field = example("dunes", 64, Edge::Wrap);
    let map = bake(&field, &default_params(field.grid(), 12));
    let distances = map.distance.as_ref().unwrap();
    let (mut same, mut total) = (0, 0);
    for direction in 0..12 {
        for texel in (0..field.grid().texels() as u32).step_by(13) {
            let expected = reference::horizon(&field, &map.params, direction, texel % 64, texel / 64);
            let found = f64::from(distances[direction as usize * 64 * 64 + texel as usize]);
            total += 1;
            same += u32::from((found - expected.distance).abs() <= 1e-4 * map.params.radius);
        }
    }
    assert!(f64::from(same) >= 0.9 * f64::from(total), "{same} of {total} distances agree");
}
