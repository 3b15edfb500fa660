//! What must not change a sky, and what must change it in a known way.

use barchan_bakers::Exec;
use barchan_bakers::sky::{self, SkyMap, SkyParams};
use barchan_field::{Edge, Grid, HeightField};

use crate::support::{EDGES, angle, at, bake, fill, grid, horizons, noise};

fn rough((width, height): (u32, u32), spacing: (f64, f64), edge: Edge) -> HeightField {
    fill(grid((width, height), spacing, edge), |column, row| 4.0 * noise(11, column, row))
}

#[test]
fn any_number_of_threads_bakes_the_same_bytes() {
    let field = rough((300, 67), (1.0, 1.0), Edge::Wrap);
    let bake = |threads| sky::bake(&field, &horizons(9, 6.0), SkyParams::ALL, &Exec::new(threads).unwrap()).unwrap();
    let alone = bits(&bake(1));
    for threads in [2, 3, 5] {
        assert!(bits(&bake(threads)) == alone, "{threads} threads");
    }
}

fn bits(map: &SkyMap) -> Vec<u32> {
    let tables = [&map.visibility, &map.bent_normal, &map.aperture_cone];
    tables.into_iter().flat_map(|table| table.as_ref().unwrap()).map(|value| value.to_bits()).collect()
}

/// Column and row, or columns and rows.
type Texel = (u32, u32);

/// A symmetry of the picture: where texel `(column, row)` of a field of a size goes, and where a vector goes.
struct Symmetry {
    name: &'static str,
    swaps_axes: bool,
    texel: fn(Texel, Texel) -> Texel,
    vector: fn([f64; 3]) -> [f64; 3],
}

const SYMMETRIES: [Symmetry; 3] = [
    Symmetry {
        name: "left for right",
        swaps_axes: false,
        texel: |(width, _), (column, row)| (width - 1 - column, row),
        vector: |[u, v, up]| [-u, v, up],
    },
    Symmetry {
        name: "top for bottom",
        swaps_axes: false,
        texel: |(_, height), (column, row)| (column, height - 1 - row),
        vector: |[u, v, up]| [u, -v, up],
    },
    Symmetry {
        name: "a quarter turn counter-clockwise",
        swaps_axes: true,
        texel: |(width, _), (column, row)| (row, width - 1 - column),
        vector: |[u, v, up]| [-v, u, up],
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
        for (column, row) in texels(field.grid()) {
            let to = (self.texel)((width, height), (column, row));
            samples[(to.1 * size.0 + to.0) as usize] = field.texel(i64::from(column), i64::from(row));
        }
        HeightField::new(grid(size, spacing, edge), samples).unwrap()
    }
}

fn texels(grid: &Grid) -> impl Iterator<Item = Texel> {
    let Grid { width, height, .. } = *grid;
    (0..height).flat_map(move |row| (0..width).map(move |column| (column, row)))
}

/// But for the order of the sums, which is by azimuth and so is not turned with the field.
#[test]
fn a_mirrored_or_turned_field_has_the_mirrored_or_turned_sky() {
    for symmetry in &SYMMETRIES {
        for (edge, spacing) in EDGES.into_iter().flat_map(|edge| [(edge, (1.0, 1.0)), (edge, (0.7, 1.3))]) {
            let field = rough((23, 14), spacing, edge);
            let (before, after) =
                (bake(&field, &horizons(12, 20.0)), bake(&symmetry.apply(&field), &horizons(12, 20.0)));
            for texel in texels(field.grid()) {
                let from = at(&before, texel);
                let to = at(&after, (symmetry.texel)((23, 14), texel));
                let off = [
                    (from.visibility - to.visibility).abs(),
                    angle((symmetry.vector)(from.bent_normal), to.bent_normal),
                    angle((symmetry.vector)(from.cone_axis), to.cone_axis),
                    (from.half_angle.cos() - to.half_angle.cos()).abs(),
                ];
                assert!(off.iter().all(|&off| off < 5e-6), "{}, {texel:?}: {off:?}", symmetry.name);
            }
        }
    }
}

/// Of the texels whose normal the raised one does not turn.
#[test]
fn raising_a_texel_shows_no_other_more_of_the_sky() {
    let before = rough((15, 13), (1.0, 1.5), Edge::Clamp);
    for raised in [(7, 6), (0, 0), (14, 3)] {
        for by in [0.01, 1.0, 30.0, 1e6] {
            let after = fill(*before.grid(), |column, row| {
                before.texel(i64::from(column), i64::from(row)) + if (column, row) == raised { by } else { 0.0 }
            });
            let (before, after) = (bake(&before, &horizons(16, 30.0)), bake(&after, &horizons(16, 30.0)));
            for (column, row) in texels(&before.grid) {
                let steps = column.abs_diff(raised.0) + row.abs_diff(raised.1);
                let (less, more) = (at(&after, (column, row)), at(&before, (column, row)));
                assert!(steps < 2 || less.visibility <= more.visibility + 1e-6, "({column}, {row}) sees more");
                assert!(steps < 2 || less.half_angle.cos() >= more.half_angle.cos() - 1e-6);
            }
        }
    }
}

#[test]
fn a_field_twice_as_large_in_every_way_has_the_same_sky() {
    for (edge, scale) in [(Edge::Wrap, 1024.0_f32), (Edge::Clamp, 1.0 / 4096.0)] {
        let small = rough((19, 12), (1.0, 1.5), edge);
        let times = f64::from(scale);
        let large = grid((19, 12), (times, 1.5 * times), edge);
        let large = HeightField::new(large, small.samples().iter().map(|height| height * scale).collect()).unwrap();
        assert!(bits(&bake(&small, &horizons(14, 25.0))) == bits(&bake(&large, &horizons(14, 25.0 * times))));
    }
}
