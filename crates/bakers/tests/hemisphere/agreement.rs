//! The fast baker against the reference, ray by ray.

use barchan_bakers::hemisphere::reference::first_hit;
use barchan_field::{Edge, HeightField, Shape};

use crate::support::{bake, directions, fill, grid, noise, towards, whole};

/// Agreement: within so much of the depth of the relief.
const NEAR: f64 = 1e-5;

/// An example, made `thickness` texels deep.
fn example(name: &str, size: u32, thickness: f64, edge: Edge) -> HeightField {
    let shape = Shape::examples().into_iter().find(|shape| shape.name() == name).unwrap();
    let field = shape.rasterize(grid((size, size), (256.0 / f64::from(size), 256.0 / f64::from(size)), edge)).unwrap();
    let (lowest, highest) = field.range();
    let scale = (thickness * field.grid().spacing.u() / f64::from(highest - lowest)) as f32;
    let samples = field.samples().iter().map(|height| height * scale).collect();
    HeightField::new(*field.grid(), samples).unwrap()
}

#[derive(Default)]
struct Differences {
    rays: usize,
    far: usize,
    greatest: f64,
}

/// Of every `stride`th ray of a table of 6 rings up to 80° and 10 azimuths.
fn differences(field: &HeightField, stride: usize) -> Differences {
    let directions = directions(6, 10, 80.0);
    let map = bake(field, &whole(field, directions));
    let mut found = Differences::default();
    for index in (0..map.depths.len()).step_by(stride) {
        let (layer, texel) = (index / field.grid().texels(), index % field.grid().texels());
        let (column, row) = (texel % field.grid().width as usize, texel / field.grid().width as usize);
        let expected = first_hit(field, column as f64, row as f64, towards(&directions, layer as u32));
        let off = (f64::from(map.depths[index]) - expected).abs();
        found.rays += 1;
        found.far += usize::from(off > NEAR);
        found.greatest = found.greatest.max(if off > NEAR { 0.0 } else { off });
    }
    found
}

#[test]
fn rays_end_where_the_reference_ends_them() {
    for name in
        ["plane", "step_wall", "spike", "ripples", "gaussian", "pyramid", "dunes", "reptile_skin", "fractal_terrain"]
    {
        for edge in [Edge::Wrap, Edge::Clamp] {
            let found = differences(&example(name, 64, 10.0, edge), 7);
            println!("{name} {edge:?} {} of {}, greatest {:e}", found.far, found.rays, found.greatest);
        }
    }
    for (edge, spacing) in [(Edge::Wrap, (1.0, 1.0)), (Edge::Wrap, (0.7, 1.9)), (Edge::Clamp, (3.0, 0.4))] {
        let field = fill(grid((37, 23), spacing, edge), |column, row| 4.0 * noise(5, column, row));
        let found = differences(&field, 1);
        println!("noise {edge:?} {} of {}, greatest {:e}", found.far, found.rays, found.greatest);
    }
}
