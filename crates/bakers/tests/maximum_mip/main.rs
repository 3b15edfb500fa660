//! What maximum mips promise, through the crate's public face.

use barchan_bakers::Exec;
use barchan_bakers::maximum_mip::{self, MaximumMip, reference};
use barchan_field::{Edge, Grid, HeightField, LengthUnit, Spacing};

const EDGES: [Edge; 2] = [Edge::Wrap, Edge::Clamp];

/// Sizes of one texel, one row, one column, powers of two, odd at every level, and more than one band of rows.
const SIZES: [(u32, u32); 9] = [(1, 1), (5, 1), (1, 6), (2, 2), (8, 8), (7, 11), (31, 6), (13, 27), (3, 150)];

fn rough((width, height): (u32, u32), edge: Edge) -> HeightField {
    let grid = Grid { width, height, spacing: Spacing::UNIT, unit: LengthUnit::SceneUnit, edge };
    let mut state = 1_u32;
    let samples = std::iter::repeat_with(|| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 8) as f32 - 8e6
    });
    HeightField::new(grid, samples.take(grid.texels()).collect()).unwrap()
}

fn bake(field: &HeightField) -> MaximumMip {
    maximum_mip::bake(field, &Exec::new(1).unwrap()).unwrap()
}

#[test]
fn a_bake_is_the_definition() {
    for edge in EDGES {
        for size in SIZES {
            let field = rough(size, edge);
            assert_eq!(bake(&field), reference::bake(&field), "{size:?}, {edge:?}");
        }
    }
}

#[test]
fn any_number_of_threads_bakes_the_same_bytes() {
    let field = rough((70, 300), Edge::Wrap);
    assert_eq!(bake(&field), maximum_mip::bake(&field, &Exec::new(3).unwrap()).unwrap());
}

#[test]
fn extents_are_halved_down_to_one_value_the_highest_of_all() {
    for size in SIZES {
        let field = rough(size, Edge::Clamp);
        let levels = bake(&field).levels;
        for (level, mip) in levels.iter().enumerate() {
            assert_eq!((mip.width, mip.height), ((size.0 >> level).max(1), (size.1 >> level).max(1)));
            assert_eq!(mip.values.len(), mip.width as usize * mip.height as usize);
        }
        let last = levels.last().unwrap();
        assert_eq!((last.width, last.height, last.value(0, 0)), (1, 1, field.range().1), "{size:?}");
    }
}

/// The value of the square of a level that a cell is in, as a run time looks it up.
fn above(mip: &MaximumMip, level: usize, column: u32, row: u32) -> f32 {
    let of = &mip.levels[level];
    of.value((column >> level).min(of.width - 1), (row >> level).min(of.height - 1))
}

#[test]
fn no_point_of_the_surface_is_above_its_square_at_any_level() {
    for edge in EDGES {
        for size in SIZES {
            let field = rough(size, edge);
            let mip = bake(&field);
            for (column, row) in (0..size.1).flat_map(|row| (0..size.0).map(move |column| (column, row))) {
                for part in 0..25 {
                    let place =
                        (f64::from(column) + f64::from(part % 5) / 4.0, f64::from(row) + f64::from(part / 5) / 4.0);
                    let height = field.surface(place.0, place.1);
                    for level in 0..mip.levels.len() {
                        assert!(height <= f64::from(above(&mip, level, column, row)), "{size:?}, {place:?}, {level}");
                    }
                }
            }
        }
    }
}

/// Texels 0 to 4 with a spike on texel 2: the cells to its left and right reach it, and of a pair either does.
#[test]
fn a_spike_raises_the_two_cells_beside_it() {
    let grid = Grid { width: 5, height: 1, spacing: Spacing::UNIT, unit: LengthUnit::SceneUnit, edge: Edge::Clamp };
    let levels = bake(&HeightField::new(grid, vec![0.0, 0.0, 3.0, 0.0, -1.0]).unwrap()).levels;
    let values: Vec<&[f32]> = levels.iter().map(|level| level.values.as_slice()).collect();
    assert_eq!(values, [&[0.0, 3.0, 3.0, 0.0, -1.0][..], &[3.0, 3.0], &[3.0]]);
}

/// The last cell of a row is level with the edge, or leads on to the first texel.
#[test]
fn the_edge_policy_makes_the_last_cell() {
    for (edge, last) in [(Edge::Clamp, 1.0), (Edge::Wrap, 7.0)] {
        let grid = Grid { width: 3, height: 1, spacing: Spacing::UNIT, unit: LengthUnit::SceneUnit, edge };
        let mip = bake(&HeightField::new(grid, vec![7.0, 0.0, 1.0]).unwrap());
        assert_eq!(mip.levels[0].values, [7.0, 1.0, last]);
    }
}
