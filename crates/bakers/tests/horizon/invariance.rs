//! What must not change a map, and what must change it in a known way.

use barchan_bakers::Exec;
use barchan_bakers::horizon::{self, HorizonMap};
use barchan_field::{Edge, Grid, HeightField, Shape, Spacing};

use crate::support::{at, bake, fill, grid, noise, params};

const EDGES: [Edge; 2] = [Edge::Wrap, Edge::Clamp];

fn rough((width, height): (u32, u32), spacing: (f64, f64), edge: Edge) -> HeightField {
    fill(grid((width, height), spacing, edge), |column, row| 4.0 * noise(11, column, row))
}

#[test]
fn any_number_of_threads_bakes_the_same_bytes() {
    let dunes = Shape::examples().into_iter().find(|shape| shape.name() == "dunes").unwrap();
    let field = dunes.rasterize(grid((48, 48), (256.0 / 48.0, 256.0 / 48.0), Edge::Wrap)).unwrap();
    let bake = |threads| horizon::bake(&field, &params(13, 256.0), &Exec::new(threads).unwrap()).unwrap();
    let alone = bake(1);
    for threads in [2, 3, 5] {
        let map = bake(threads);
        assert!(bits(&map.elevation_radians) == bits(&alone.elevation_radians), "{threads} threads");
        assert!(bits(map.distance.as_ref().unwrap()) == bits(alone.distance.as_ref().unwrap()), "{threads} threads");
    }
}

fn bits(values: &[f32]) -> Vec<u32> {
    values.iter().map(|value| value.to_bits()).collect()
}

/// Column and row, or columns and rows.
type Texel = (u32, u32);

/// A symmetry of the picture: where texel `(column, row)` of a field goes, and where a direction goes.
struct Symmetry {
    name: &'static str,
    swaps_axes: bool,
    texel: fn(Texel, Texel) -> Texel,
    direction: fn(u32, u32) -> u32,
}

const SYMMETRIES: [Symmetry; 4] = [
    Symmetry {
        name: "left for right",
        swaps_axes: false,
        texel: |(width, _), (column, row)| (width - 1 - column, row),
        direction: |count, k| count / 2 + count - k,
    },
    Symmetry {
        name: "top for bottom",
        swaps_axes: false,
        texel: |(_, height), (column, row)| (column, height - 1 - row),
        direction: |count, k| count - k,
    },
    Symmetry {
        name: "a quarter turn counter-clockwise",
        swaps_axes: true,
        texel: |(width, _), (column, row)| (row, width - 1 - column),
        direction: |count, k| k + count / 4,
    },
    Symmetry {
        name: "a half turn",
        swaps_axes: false,
        texel: |(width, height), (column, row)| (width - 1 - column, height - 1 - row),
        direction: |count, k| k + count / 2,
    },
];

impl Symmetry {
    fn apply(&self, field: &HeightField) -> HeightField {
        let Grid { width, height, spacing, edge, .. } = *field.grid();
        let (size, spacing) = if self.swaps_axes {
            ((height, width), (spacing.v(), spacing.u()))
        } else {
            ((width, height), (spacing.u(), spacing.v()))
        };
        let mut samples = vec![0.0; field.samples().len()];
        for row in 0..height {
            for column in 0..width {
                let (to_column, to_row) = (self.texel)((width, height), (column, row));
                samples[(to_row * size.0 + to_column) as usize] = field.texel(i64::from(column), i64::from(row));
            }
        }
        HeightField::new(grid(size, spacing, edge), samples).unwrap()
    }

    fn differences(&self, map: &HorizonMap, moved: &HorizonMap) -> Vec<(u32, u32, u32)> {
        let Grid { width, height, .. } = map.grid;
        let count = map.params.directions();
        let mut differences = Vec::new();
        for direction in 0..count {
            for (column, row) in (0..height).flat_map(|row| (0..width).map(move |column| (column, row))) {
                let to = (self.texel)((width, height), (column, row));
                if at(map, direction, column, row) != at(moved, (self.direction)(count, direction) % count, to.0, to.1)
                {
                    differences.push((direction, column, row));
                }
            }
        }
        differences
    }
}

/// Bit for bit, but for quarter turns at the diagonals of square texels: rows and columns take each other's part there, and
/// the bake, which goes by columns, may be led to another point of the ray.
#[test]
fn a_mirrored_or_turned_field_has_the_mirrored_or_turned_map() {
    for symmetry in &SYMMETRIES {
        for (edge, spacing) in EDGES.into_iter().flat_map(|edge| [(edge, (1.0, 1.0)), (edge, (0.7, 1.3))]) {
            let field = rough((43, 34), spacing, edge);
            let moved = symmetry.apply(&field);
            let with_diagonals = if symmetry.swaps_axes && spacing == (1.0, 1.0) { 20 } else { 8 };
            for directions in [4, 12, with_diagonals] {
                let params = params(directions, 60.0);
                let differences = symmetry.differences(&bake(&field, &params), &bake(&moved, &params));
                assert!(
                    differences.is_empty(),
                    "{}, {edge:?}, {spacing:?}, {directions} directions: {} texels differ, {:?} first",
                    symmetry.name,
                    differences.len(),
                    differences[0]
                );
            }
        }
    }
}

#[test]
fn raising_the_whole_field_changes_nothing() {
    for edge in EDGES {
        // Multiples of 2⁻¹⁶ below 4 stay exact when 64 is added.
        let exact = |column, row| (noise(3, column, row) * 262_144.0).floor() / 65_536.0;
        let grid = grid((19, 22), (1.0, 1.5), edge);
        let params = params(16, 25.0);
        let low = bake(&fill(grid, exact), &params);
        let high = bake(&fill(grid, |column, row| exact(column, row) + 64.0), &params);
        for (low, high) in low.elevation_radians.iter().zip(&high.elevation_radians) {
            assert!((low - high).abs() <= 1e-6, "{low} and {high}");
        }
    }
}

#[test]
fn a_field_twice_as_large_in_every_way_has_the_same_elevations_twice_as_far() {
    for (edge, scale) in [(Edge::Wrap, 1024.0_f32), (Edge::Clamp, 1.0 / 4096.0)] {
        let small = rough((19, 22), (1.0, 1.5), edge);
        let times = f64::from(scale);
        let grid = Grid { spacing: Spacing::new(times, 1.5 * times).unwrap(), ..*small.grid() };
        let large = HeightField::new(grid, small.samples().iter().map(|height| height * scale).collect()).unwrap();
        let (of_small, of_large) = (bake(&small, &params(14, 25.0)), bake(&large, &params(14, 25.0 * times)));
        assert_eq!(bits(&of_small.elevation_radians), bits(&of_large.elevation_radians));
        let farther: Vec<f32> = of_small.distance.unwrap().iter().map(|distance| distance * scale).collect();
        assert_eq!(bits(&farther), bits(&of_large.distance.unwrap()));
    }
}
