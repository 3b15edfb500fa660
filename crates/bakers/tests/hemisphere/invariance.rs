//! What must not change a table.

use barchan_bakers::Exec;
use barchan_bakers::hemisphere::{self, HemisphereBaker, HemisphereParams};
use barchan_field::{Edge, Grid, HeightField, Spacing};

use crate::support::{bake, directions, field, fill, grid, noise, whole};

fn bits(depths: &[f32]) -> Vec<u32> {
    depths.iter().map(|depth| depth.to_bits()).collect()
}

fn rough(edge: Edge) -> HeightField {
    fill(grid((37, 26), (0.8, 1.3), edge), |column, row| 3.0 * noise(3, column, row))
}

fn small_table(field: &HeightField) -> HemisphereParams {
    HemisphereParams { width: 9, height: 11, ..whole(field, directions(5, 7, 75.0)) }
}

#[test]
fn any_number_of_threads_bakes_the_same_bytes() {
    let field = rough(Edge::Wrap);
    let params = small_table(&field);
    let [alone, two, three] = [1, 2, 3].map(|threads| {
        let map = hemisphere::bake(&field, &params, &Exec::new(threads).unwrap()).unwrap();
        bits(&map.depths)
    });
    assert!(alone == two && alone == three);
}

#[test]
fn a_layer_alone_is_the_layer_of_the_table() {
    let field = rough(Edge::Clamp);
    let params = small_table(&field);
    let map = bake(&field, &params);
    for threads in [1, 2, 3] {
        let exec = Exec::new(threads).unwrap();
        let baker = HemisphereBaker::new(&field, params, &exec).unwrap();
        let mut depths = vec![f32::NAN; 99];
        for layer in 0..params.directions.layers() {
            baker.bake_layer(layer, &exec, &mut depths);
            assert_eq!(bits(&depths), bits(map.layer(layer)), "layer {layer}");
        }
        assert_eq!(baker.relief(), map.relief);
    }
}

#[test]
fn a_relief_far_above_zero_has_the_same_depths() {
    let steps = |column, row| (8.0 * noise(6, column, row)).floor();
    let [low, high] = [0.0, 1e7].map(|offset| field((21, 14), Edge::Wrap, |column, row| steps(column, row) + offset));
    let [low, high] = [low, high].map(|field| bake(&field, &whole(&field, directions(4, 6, 70.0))));
    assert_eq!(high.relief.top, low.relief.top + 1e7);
    assert_eq!(bits(&low.depths), bits(&high.depths));
}

#[test]
fn a_relief_larger_in_every_way_has_the_same_depths() {
    let small = rough(Edge::Wrap);
    for times in [2_f32.powi(90), 2_f32.powi(-90)] {
        let spacing = Spacing::new(0.8 * f64::from(times), 1.3 * f64::from(times)).unwrap();
        let samples = small.samples().iter().map(|height| height * times).collect();
        let large = HeightField::new(Grid { spacing, ..*small.grid() }, samples).unwrap();
        let [small, large] = [&small, &large].map(|field| bake(field, &small_table(field)));
        assert_eq!(bits(&small.depths), bits(&large.depths));
    }
}

/// A tile beside itself is the same relief.
#[test]
fn a_wrapped_tile_laid_twice_has_every_depth_twice() {
    let once = rough(Edge::Wrap);
    let twice = fill(Grid { width: 74, ..*once.grid() }, |column, row| once.texel(i64::from(column), i64::from(row)));
    let [once, twice] = [&once, &twice].map(|field| bake(field, &whole(field, directions(4, 6, 80.0))));
    for (once, twice) in once.depths.chunks_exact(37).zip(twice.depths.chunks_exact(74)) {
        assert_eq!(bits(&twice[..37]), bits(once));
        assert_eq!(bits(&twice[37..]), bits(once));
    }
}
