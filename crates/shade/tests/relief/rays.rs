//! Which rays there are, and where they go.

use barchan_field::Edge;
use barchan_shade::Relief;
use glam::DVec3;

use crate::support::{assert_near, field, surface, towards};

#[test]
fn a_ray_moves_away_from_where_it_comes_from_and_rows_count_down() {
    let surface = surface(&field((4, 4), (2.0, 0.5), Edge::Wrap, |column, _| if column == 0 { 3.0 } else { 1.0 }));
    let relief = Relief::new(&surface);
    assert_eq!(relief.range(), (3.0, 2.0));
    let (polar, azimuth) = (60.0_f64, 30.0_f64);
    let ray = relief.ray(1.0, 2.0, towards(polar, azimuth)).unwrap();
    let run = 0.25 * 2.0 * polar.to_radians().tan();
    let (x, y) = ray.at(0.25);
    assert_near(x, 1.0 - run * azimuth.to_radians().cos() / 2.0, 1e-12);
    assert_near(y, 2.0 + run * azimuth.to_radians().sin() / 0.5, 1e-12);
    assert_near(ray.tangent(), polar.to_radians().tan(), 1e-12);
    assert_near(ray.azimuth_radians(), azimuth.to_radians(), 1e-12);
}

#[test]
fn depth_is_counted_from_the_highest_sample_in_parts_of_the_thickness() {
    let surface = surface(&field((3, 1), (1.0, 1.0), Edge::Clamp, |column, _| [5.0, 1.0, 4.0][column as usize]));
    let relief = Relief::new(&surface);
    assert_eq!((relief.depth_at(0.0, 0.0), relief.depth_at(1.0, 0.0), relief.depth_at(2.0, 0.0)), (0.0, 1.0, 0.25));
    assert_near(relief.depth_at(0.5, 0.0), 0.5, 1e-15);
}

#[test]
fn a_ray_that_does_not_go_down_is_none() {
    let surface = surface(&field((2, 2), (1.0, 1.0), Edge::Wrap, |column, _| column as f32));
    let relief = Relief::new(&surface);
    let level = [DVec3::X, DVec3::new(0.6, 0.0, -0.8), DVec3::ZERO, DVec3::NAN, DVec3::new(1.0, 0.0, 1e-9)];
    assert!(level.iter().all(|&towards| relief.ray(0.0, 0.0, towards).is_none()));
    assert!(relief.ray(1e13, 0.0, DVec3::Z).is_none() && relief.ray(0.0, f64::NAN, DVec3::Z).is_none());
    assert!(relief.ray(1e12, -1e12, DVec3::Z).is_some() && relief.ray(0.0, 0.0, towards(89.99, 7.0)).is_some());
}
