//! The fast baker against the reference, ray by ray.

use barchan_bakers::hemisphere::reference::first_hit;
use barchan_field::{Edge, HeightField, Shape};

use crate::support::{bake, directions, fill, grid, noise, towards, whole};

/// How far apart two depths of a ray may be, in thicknesses of the relief.
const NEAR: f64 = 1e-5;

/// An example, made `thickness` texels deep.
fn example(name: &str, size: u32, thickness: f64, edge: Edge) -> HeightField {
    let shape = Shape::examples().into_iter().find(|shape| shape.name() == name).unwrap();
    let texel = 256.0 / f64::from(size);
    let field = shape.rasterize(grid((size, size), (texel, texel), edge)).unwrap();
    let (lowest, highest) = field.range();
    let scale = (thickness * texel / f64::from(highest - lowest)) as f32;
    let samples = field.samples().iter().map(|height| height * scale).collect();
    HeightField::new(*field.grid(), samples).unwrap()
}

/// How many rays were compared, and how many of them end elsewhere.
fn apart(field: &HeightField, stride: usize) -> (usize, usize) {
    let directions = directions(6, 10, 80.0);
    let map = bake(field, &whole(field, directions));
    let (texels, width) = (field.grid().texels(), field.grid().width as usize);
    let is_apart = |&index: &usize| {
        let (layer, texel) = (index / texels, index % texels);
        let (x, y) = ((texel % width) as f64, (texel / width) as f64);
        let expected = first_hit(field, x, y, towards(&directions, layer as u32));
        (f64::from(map.depths[index]) - expected).abs() > NEAR
    };
    let compared = (0..map.depths.len()).step_by(stride);
    (compared.len(), compared.filter(is_apart).count())
}

#[test]
fn rays_over_shapes_end_where_the_reference_ends_them() {
    for name in ["plane", "step_wall", "spike", "ripples", "pyramid", "dunes", "reptile_skin", "fractal_terrain"] {
        for edge in [Edge::Wrap, Edge::Clamp] {
            let (compared, apart) = apart(&example(name, 48, 8.0, edge), 29);
            assert_eq!(apart, 0, "of {compared} rays over {name}, {edge:?}");
        }
    }
}

/// White noise has a silhouette in every cell. A ray that grazes one, nearer to it than f32 can tell, may pass in one precision and hit in the
/// other: at most 2 of 102120 rays.
#[test]
fn rays_over_noise_end_elsewhere_only_where_they_graze_a_silhouette() {
    let (mut compared, mut apart) = (0, 0);
    for (edge, spacing) in
        [(Edge::Wrap, (1.0, 1.0)), (Edge::Clamp, (1.0, 1.0)), (Edge::Wrap, (0.7, 1.9)), (Edge::Clamp, (3.0, 0.4))]
    {
        let field = fill(grid((37, 23), spacing, edge), |column, row| 4.0 * noise(5, column, row));
        let (all, some) = self::apart(&field, 2);
        compared += all;
        apart += some;
    }
    assert!(apart <= 2, "{apart} of {compared} rays end elsewhere");
}
