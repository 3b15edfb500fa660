//! Many rays to a texel of the table: the shallowest is kept.

use barchan_bakers::hemisphere::{HemisphereMap, HemisphereParams};
use barchan_field::{Edge, HeightField};

use crate::support::{bake, directions, field, noise, whole};

fn rough(size: (u32, u32)) -> HeightField {
    field(size, Edge::Wrap, |column, row| 3.0 * noise(8, column, row))
}

/// Every ray of a field, and the table of a size.
fn both(field: &HeightField, (width, height): (u32, u32)) -> [HemisphereMap; 2] {
    let all = whole(field, directions(3, 5, 70.0));
    [all, HemisphereParams { width, height, ..all }].map(|params| bake(field, &params))
}

/// Eq 2, once.
fn halved(depths: &[f32], width: usize) -> Vec<f32> {
    let pairs = depths.chunks_exact(2 * width);
    let least = |rows: &[f32], column: usize| {
        let places = [column, column + 1, width + column, width + column + 1];
        places.iter().map(|&place| rows[place]).fold(1.0, f32::min)
    };
    pairs.flat_map(|rows| (0..width).step_by(2).map(|column| least(rows, column)).collect::<Vec<_>>()).collect()
}

#[test]
fn powers_of_two_are_halved_again_and_again() {
    let [all, table] = both(&rough((32, 16)), (8, 4));
    for layer in 0..all.params.directions.layers() {
        assert_eq!(table.layer(layer), halved(&halved(all.layer(layer), 32), 16));
    }
}

#[test]
fn any_size_has_the_least_of_the_source_texels_it_touches() {
    let (width, height) = (23, 17);
    for target in [(1, 1), (7, 5), (11, 16), (22, 9), (23, 1)] {
        let [all, table] = both(&rough((width, height)), target);
        let touches = |source: u32, of: u32, texel: u32, from: u32| {
            // Both cut the same side: source texels into `of` parts, the table's into `from`.
            source * from < (texel + 1) * of && texel * of < (source + 1) * from
        };
        for layer in 0..all.params.directions.layers() {
            for (index, &depth) in table.layer(layer).iter().enumerate() {
                let (column, row) = (index as u32 % target.0, index as u32 / target.0);
                let touched = all.layer(layer).iter().enumerate().filter(|(source, _)| {
                    touches(*source as u32 % width, width, column, target.0)
                        && touches(*source as u32 / width, height, row, target.1)
                });
                let least = touched.map(|(_, &depth)| depth).fold(f32::INFINITY, f32::min);
                assert_eq!(depth, least, "{target:?}, layer {layer}, texel {column}, {row}");
            }
        }
    }
}
