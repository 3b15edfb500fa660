//! The baker against the lattice: never wider, and not much narrower.

use barchan_bakers::cone::{ConeKind, ConeMap, reference};
use barchan_field::HeightField;

use crate::support::{bake, fields};

/// What is baked over what the lattice says: mean and greatest.
fn against_lattice(field: &HeightField, map: &ConeMap, kind: ConeKind, parts: u32) -> (f64, f64) {
    let (mut most, mut sum) = (0.0_f64, 0.0);
    for (column, row) in (0..map.grid.height).flat_map(|row| (0..map.grid.width).map(move |column| (column, row))) {
        let share = f64::from(map.ratio(column, row)) / reference::ratio(field, kind, column, row, parts);
        (most, sum) = (most.max(share), sum + share);
    }
    (sum / map.grid.texels() as f64, most)
}

/// The summit of a spike is steeper than any chord of so coarse a lattice: a quarter is lost there, elsewhere a tenth.
#[test]
fn strict_cones_are_those_of_the_lattice() {
    for (relief, field) in fields((7, 6)) {
        let map = bake(&field, ConeKind::Strict);
        let (mean, most) = against_lattice(&field, &map, ConeKind::Strict, 3);
        assert!(most <= 1.0 + 1e-12 && mean > 0.72, "{relief:?}: {mean}, {most}");
    }
}

#[test]
fn relaxed_cones_are_those_of_the_lattice() {
    for (relief, field) in fields((7, 6)) {
        let map = bake(&field, ConeKind::Relaxed);
        let (mean, most) = against_lattice(&field, &map, ConeKind::Relaxed, 4);
        // The exits of the reference are found by steps, which may pass a short one.
        assert!(most <= 1.0 + 1e-6 && mean > 0.93, "{relief:?}: {mean}, {most}");
    }
}
