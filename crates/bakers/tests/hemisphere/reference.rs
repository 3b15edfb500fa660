//! The reference against the definition: samples of the surface along the ray.

use barchan_bakers::hemisphere::reference::first_hit;
use barchan_field::{Edge, HeightField};
use glam::DVec3;

use crate::support::{field, fill, grid, noise};

/// How far above the surface the ray is at a depth, in length units.
fn clearance(field: &HeightField, (x, y): (f64, f64), towards: DVec3, depth: f64) -> f64 {
    let (lowest, highest) = field.range();
    let fallen = depth * (f64::from(highest) - f64::from(lowest));
    let along = fallen / towards.z;
    let spacing = field.grid().spacing;
    // The ray moves away from where it comes from; rows are counted downwards.
    let place = (x - along * towards.x / spacing.u(), y + along * towards.y / spacing.v());
    f64::from(highest) - fallen - field.surface(place.0, place.1)
}

#[test]
fn a_ray_is_above_the_surface_before_its_hit_and_on_it_there() {
    for (edge, spacing) in [(Edge::Wrap, (1.0, 1.0)), (Edge::Clamp, (0.6, 1.7)), (Edge::Wrap, (2.5, 0.8))] {
        let field = fill(grid((13, 9), spacing, edge), |column, row| 3.0 * noise(2, column, row));
        for ray in 0..400 {
            let random = |what| f64::from(noise(ray, what, 7));
            let place = (random(0) * 13.0 - 0.5, random(1) * 9.0 - 0.5);
            let (sin, cos) = (random(2) * 6.3).sin_cos();
            let tangent = 6.0 * random(3) * random(3);
            let towards = DVec3::new(tangent * cos, tangent * sin, 1.0).normalize();
            let hit = first_hit(&field, place.0, place.1, towards);
            assert!(clearance(&field, place, towards, hit).abs() < 1e-12, "ray {ray} ends off the surface");
            for sample in 0..500 {
                let depth = hit * f64::from(sample) / 500.0;
                assert!(clearance(&field, place, towards, depth) > -1e-12, "ray {ray} is below the surface at {depth}");
            }
        }
    }
}

#[test]
fn the_length_of_a_direction_does_not_count() {
    let field = field((7, 7), Edge::Wrap, |column, row| noise(4, column, row));
    let towards = DVec3::new(0.3, -0.8, 0.5);
    assert_eq!(first_hit(&field, 2.5, 3.5, towards), first_hit(&field, 2.5, 3.5, 4.0 * towards));
}

#[test]
fn a_ray_from_beside_or_below_stays_at_the_top() {
    let field = field((7, 7), Edge::Wrap, |column, row| noise(4, column, row));
    assert_eq!(first_hit(&field, 2.5, 3.5, DVec3::X), 0.0);
    assert_eq!(first_hit(&field, 2.5, 3.5, -DVec3::Z), 0.0);
}
