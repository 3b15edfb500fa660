//! Reliefs, rays, and tables as a file holds them.

use barchan_asset::{
    ConeMapTable, ConeMapView, Encoding, HeightTable, HeightView, MaximumMipTable, MaximumMipView, RelaxedConeMapTable,
    RelaxedConeMapView, ReliefRange, TextureTable, f32_at_most,
};
use barchan_bakers::{Exec, maximum_mip};
use barchan_field::{Edge, HeightField};
use barchan_shade::{ConeSteps, MaximumMipTraversal, RelaxedConeSteps, Relief, ReliefRay, Surface};
use glam::DVec3;

use crate::common::table_grid;
pub(crate) use crate::common::{assert_near, field, noise};

pub(crate) fn surface(field: &HeightField) -> Surface {
    let table = HeightTable { grid: table_grid(field.grid()), values: field.samples() }.encode(Encoding::F32).unwrap();
    Surface::new(&HeightView::new(*table.descriptor(), table.payload()).unwrap())
}

/// Towards an eye at a polar angle and an azimuth, in degrees.
pub(crate) fn towards(polar: f64, azimuth: f64) -> DVec3 {
    let ((sin, cos), (y, x)) = (polar.to_radians().sin_cos(), azimuth.to_radians().sin_cos());
    DVec3::new(sin * x, sin * y, cos)
}

/// How far the surface is below a ray at a depth of it.
pub(crate) fn gap(relief: &Relief<'_>, ray: &ReliefRay, depth: f64) -> f64 {
    let (x, y) = ray.at(depth);
    relief.depth_at(x, y) - depth
}

/// Reliefs of many kinds, `size` texels wide and high, lengths in texels, `thickness` deep or a little less.
pub(crate) fn reliefs(size: u32, thickness: f32, edge: Edge) -> [(&'static str, HeightField); 5] {
    let turn = |index: u32| (std::f64::consts::TAU * f64::from(index) / f64::from(size)) as f32;
    let make = |at: &dyn Fn(u32, u32) -> f32| field((size, size), (1.0, 1.0), edge, |u, v| thickness * at(u, v));
    [
        ("noise", make(&|column, row| noise(1, column, row))),
        ("spikes", make(&|column, row| f32::from(noise(2, column, row) > 0.99))),
        ("walls", make(&|column, row| f32::from((column / 5 + row / 7) % 3 == 0))),
        ("smooth", make(&|column, row| 0.25 * (2.0 + turn(2 * column).sin() + turn(3 * row + column).cos()))),
        ("terraces", make(&|column, row| (4.0 * (0.5 + 0.5 * turn(column + row).sin())).floor() / 4.0)),
    ]
}

/// Reproducible rays: a place anywhere in and around the tile, a direction at a polar angle in degrees.
pub(crate) fn rays<'r>(relief: &'r Relief<'_>, polar: f64, count: u32) -> impl Iterator<Item = ReliefRay> + 'r {
    let size = f64::from(relief.surface().heights().width());
    let random = move |seed, index| f64::from(noise(seed, index, polar as u32));
    (0..count).map(move |index| {
        let place = |seed| (1.5 * random(seed, index) - 0.25) * size;
        relief.ray(place(10), place(11), towards(polar, 360.0 * random(12, index))).expect("a ray that goes down")
    })
}

/// A table of maximum mips in f32.
pub(crate) fn mips(field: &HeightField) -> TextureTable {
    let mip = maximum_mip::bake(field, &Exec::new(1).unwrap()).unwrap();
    let levels: Vec<&[f32]> = mip.levels.iter().map(|level| level.values.as_slice()).collect();
    MaximumMipTable { grid: table_grid(field.grid()), levels: &levels }.encode(Encoding::F32).unwrap()
}

pub(crate) fn traversal<'a>(relief: &Relief<'a>, mips: &TextureTable) -> MaximumMipTraversal<'a> {
    MaximumMipTraversal::new(relief, &MaximumMipView::new(*mips.descriptor(), mips.payload()).unwrap()).unwrap()
}

/// A cone map in f32 with one ratio everywhere: of the steepest cell there is. Nothing gets into such a cone.
pub(crate) fn steepest_cones(field: &HeightField) -> TextureTable {
    let (grid, relief) = (field.grid(), relief_range(field));
    let (spacing_u, spacing_v) = (grid.spacing.u(), grid.spacing.v());
    let texels =
        (0..i64::from(grid.height)).flat_map(|row| (0..i64::from(grid.width)).map(move |column| (column, row)));
    let height = |column, row| f64::from(field.texel(column, row));
    let slope = |(column, row)| {
        let here = height(column, row);
        ((height(column + 1, row) - here).abs() / spacing_u, (height(column, row + 1) - here).abs() / spacing_v)
    };
    let steepest = texels.map(slope).fold((0.0_f64, 0.0_f64), |a, b| (a.0.max(b.0), a.1.max(b.1)));
    let ratio = (1.0 / steepest.0.hypot(steepest.1)).min(1e3);
    let depth = |&height: &f32| f32_at_most(relief.depth(height.into()));
    let values: Vec<f32> = field.samples().iter().flat_map(|height| [depth(height), f32_at_most(ratio)]).collect();
    ConeMapTable { grid: table_grid(grid), relief, values: &values }.encode(Encoding::F32).unwrap()
}

/// The same cones, as relaxed ones: what nothing gets into, a ray pierces once at most.
pub(crate) fn steepest_relaxed_cones(field: &HeightField) -> TextureTable {
    let cones = steepest_cones(field);
    let view = ConeMapView::new(*cones.descriptor(), cones.payload()).unwrap();
    let values: Vec<f32> = (0..view.height()).flat_map(|row| view.table().row(0, row)).collect();
    let table = RelaxedConeMapTable { grid: table_grid(field.grid()), relief: relief_range(field), values: &values };
    table.encode(Encoding::F32).unwrap()
}

pub(crate) fn cone_steps<'a>(relief: &Relief<'a>, cones: &TextureTable) -> ConeSteps<'a> {
    ConeSteps::new(relief, &ConeMapView::new(*cones.descriptor(), cones.payload()).unwrap()).unwrap()
}

pub(crate) fn relaxed_cone_steps<'a>(relief: &Relief<'a>, cones: &TextureTable) -> RelaxedConeSteps<'a> {
    let view = RelaxedConeMapView::new(*cones.descriptor(), cones.payload()).unwrap();
    RelaxedConeSteps::new(relief, &view, 12).unwrap()
}

pub(crate) fn relief_range(field: &HeightField) -> ReliefRange {
    let (low, high) = field.samples().iter().fold((f32::MAX, f32::MIN), |(lo, hi), &h| (lo.min(h), hi.max(h)));
    ReliefRange { top: high.into(), thickness: f64::from(high) - f64::from(low) }
}
