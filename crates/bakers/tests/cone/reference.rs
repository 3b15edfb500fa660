//! The baker against the lattice: never wider, and seldom much narrower.

use barchan_bakers::cone::{ConeKind, ConeMap, reference};
use barchan_field::HeightField;

use crate::support::{bake, fields};

/// What is baked over what the lattice says, least and mean.
fn against_lattice(field: &HeightField, map: &ConeMap, kind: ConeKind, parts: u32) -> (f64, f64, f64) {
    let (mut least, mut most, mut sum) = (f64::INFINITY, 0.0_f64, 0.0);
    for (column, row) in (0..map.grid.height).flat_map(|row| (0..map.grid.width).map(move |column| (column, row))) {
        let share = f64::from(map.ratio(column, row)) / reference::ratio(field, kind, column, row, parts);
        (least, most, sum) = (least.min(share), most.max(share), sum + share);
    }
    (least, sum / map.grid.texels() as f64, most)
}

#[test]
fn strict_cones_are_those_of_the_lattice() {
    for (relief, field) in fields((7, 6)) {
        let map = bake(&field, ConeKind::Strict);
        let (least, mean, most) = against_lattice(&field, &map, ConeKind::Strict, 3);
        println!("{relief:?} {:?} {least} {mean} {most}", field.grid().edge);
        assert!(most <= 1.0 + 1e-12, "{relief:?}: {most}");
    }
}

#[test]
fn relaxed_cones_are_those_of_the_lattice() {
    for (relief, field) in fields((7, 6)) {
        let map = bake(&field, ConeKind::Relaxed);
        let (least, mean, most) = against_lattice(&field, &map, ConeKind::Relaxed, 4);
        println!("{relief:?} {:?} {least} {mean} {most}", field.grid().edge);
    }
}
