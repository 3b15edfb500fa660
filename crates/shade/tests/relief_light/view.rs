//! What a camera sees of relief on a surface.

use barchan_field::Edge;
use barchan_shade::{
    BaseSurface, Camera, Lens, Palette, Plane, Relief, ReliefLight, ReliefPixels, ReliefRoad, ReliefShadow, Sphere,
    SphereChart, Surface, TracedRelief, relief_direction,
};
use glam::{DMat2, DVec2, DVec3};

use crate::support::{assert_near, field, fractal, surface};

fn plane(surface: &Surface) -> Plane {
    Plane { chart: DMat2::from_diagonal(surface.extent().into()) }
}

fn camera(eye: DVec3, target: DVec3, height: f64) -> Camera {
    Camera { eye, target, up: DVec3::Y, lens: Lens::Orthographic { height }, width: 24, height: 24 }
}

fn look<'a>(surface: &'a Surface, base: &impl BaseSurface, camera: &Camera) -> ReliefPixels<'a> {
    let relief = Relief::new(surface);
    ReliefPixels::new(camera, base, &relief, &ReliefRoad { depth_map: None, search: &TracedRelief::new(&relief) })
}

#[test]
fn a_point_that_is_seen_is_on_the_ray_that_sees_it() {
    let surface = surface(&fractal(32));
    let (relief, base) = (Relief::new(&surface), plane(&surface));
    let (top, thickness) = relief.range();
    assert!(top > 0.0);
    let camera = camera(DVec3::new(-40.0, -60.0, 50.0), DVec3::new(16.0, 16.0, 0.0), 20.0);
    let seen = look(&surface, &base, &camera);
    for (ray, pixel) in camera.rays().zip(seen.pixels()) {
        let pixel = pixel.unwrap();
        let (x, y) = pixel.texel;
        assert_near(relief.depth_at(x, y), pixel.depth, 1e-9);
        // The base is the top plane; texels back to lengths.
        let point = DVec3::new(x + 0.5, 32.0 - (y + 0.5), -pixel.depth * thickness);
        let beside = (point - ray.origin).cross(ray.direction).length();
        assert!(beside < 1e-9, "{beside}");
    }
}

#[test]
fn a_clamped_tile_is_seen_once_and_a_wrapped_one_everywhere() {
    let seen_share = |edge| {
        let surface = surface(&field((8, 8), (1.0, 1.0), edge, |column, row| (column * row % 3) as f32));
        // Four tiles across, from straight above.
        let seen =
            look(&surface, &plane(&surface), &camera(DVec3::new(4.0, 4.0, 50.0), DVec3::new(4.0, 4.0, 0.0), 32.0));
        let count = seen.pixels().iter().filter(|pixel| pixel.is_some()).count();
        count as f64 / seen.pixels().len() as f64
    };
    assert_near(seen_share(Edge::Wrap), 1.0, 0.0);
    assert_near(seen_share(Edge::Clamp), 1.0 / 16.0, 0.01);
}

#[test]
fn a_ray_along_the_horizon_sees_nothing() {
    let surface = surface(&fractal(8));
    let level = camera(DVec3::new(0.0, -50.0, 3.0), DVec3::new(0.0, 0.0, 3.0), 2.0);
    assert!(look(&surface, &plane(&surface), &level).pixels().iter().all(Option::is_none));
}

#[test]
fn a_ball_has_its_own_outline_and_no_relief_stands_out_of_it() {
    let surface = surface(&fractal(32));
    let ball =
        Sphere { radius: 60.0, hollow: false, chart: SphereChart::Geographic, tile: DVec2::from(surface.extent()) };
    let view = camera(DVec3::new(500.0, 0.0, 0.0), DVec3::ZERO, 140.0);
    let view = Camera { up: DVec3::Z, ..view };
    let seen = look(&surface, &ball, &view);
    for (ray, pixel) in view.rays().zip(seen.pixels()) {
        assert_eq!(pixel.is_some(), ball.hit(&ray).is_some());
    }
}

#[test]
fn directions_of_a_stretched_chart_are_those_of_its_grid() {
    // Twice as long on the surface as on the grid along u: a slope of one is two there.
    let frame = Plane { chart: DMat2::from_diagonal(DVec2::new(20.0, 10.0)) }.point(DVec2::ZERO).frame;
    let direction = relief_direction(&frame, (10.0, 10.0), DVec3::new(1.0, 0.0, 1.0).normalize());
    assert_near(direction.x / direction.z, 0.5, 1e-15);
    assert_near(direction.length(), 1.0, 1e-15);
}

#[test]
fn shadow_and_occlusion_darken_what_they_are_on() {
    let surface = surface(&fractal(16));
    let relief = Relief::new(&surface);
    let seen = look(&surface, &plane(&surface), &camera(DVec3::new(8.0, 8.0, 90.0), DVec3::new(8.0, 8.0, 0.0), 16.0));
    let (pixels, sun) = (seen.pixels().len(), DVec3::new(0.0, 0.6, 0.8));
    let picture = |shadow: bool, occlusion: f64| {
        let (shadow, occlusion) = (vec![shadow; pixels], vec![occlusion; pixels]);
        seen.picture(&ReliefLight { sun, shadow: &shadow, occlusion: Some(&occlusion) }, &Palette::SAND)
    };
    let brightness = |picture: &barchan_shade::Picture| picture.rgb.iter().map(|&byte| u64::from(byte)).sum::<u64>();
    let [open, dim, dark, black] =
        [picture(false, 0.0), picture(false, 0.5), picture(true, 0.5), picture(true, 1.0)].map(|p| brightness(&p));
    assert!(open > dim && dim > dark && dark > black && black == 0);
    // The sun of a pixel is asked for in the relief's own frame: on a level plane that is the same.
    let search = TracedRelief::new(&relief);
    let shadow = ReliefShadow { relief, road: ReliefRoad { depth_map: None, search: &search }, tolerance: 1e-9 };
    for pixel in seen.pixels().iter().flatten() {
        assert_eq!(seen.in_shadow(pixel, &shadow, sun), shadow.at(pixel.texel, pixel.depth, sun));
    }
}
