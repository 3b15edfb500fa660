//! Pictures of curved surfaces.

use barchan_shade::{Camera, CurvedPixels, DisplacedShadow, Lens, Palette, SphereChart};
use glam::DVec3;

use crate::support::{assert_near, ball, cylinder_bumps, relief, towards};

fn camera(lens: Lens, (width, height): (u32, u32)) -> Camera {
    Camera { eye: DVec3::X * 500.0, target: DVec3::ZERO, up: DVec3::Z, lens, width, height }
}

#[test]
fn rays_spread_as_the_lens_says() {
    let level: Vec<_> = camera(Lens::Orthographic { height: 8.0 }, (3, 4)).rays().collect();
    assert_eq!(level.len(), 12);
    assert!(level.iter().all(|ray| ray.direction == DVec3::NEG_X));
    // Square pixels of length 2; the first is at the upper left, +y to the right as seen from +x.
    assert_eq!(level[0].origin, DVec3::new(500.0, -2.0, 3.0));
    assert_eq!(level[11].origin, DVec3::new(500.0, 2.0, -3.0));
    let wide: Vec<_> = camera(Lens::Perspective { field_of_view: 90.0 }, (1, 2)).rays().collect();
    assert!(wide.iter().all(|ray| ray.origin == DVec3::X * 500.0));
    assert_near(wide[0].direction.z / -wide[0].direction.x, 0.5, 1e-12);
    assert_near((wide[0].direction + wide[1].direction).z, 0.0, 1e-12);
    let upwards = Camera { up: DVec3::X, ..camera(Lens::Orthographic { height: 8.0 }, (2, 2)) };
    assert!(upwards.rays().all(|ray| ray.origin.is_finite() && ray.direction == DVec3::NEG_X));
}

#[test]
fn a_ball_fills_its_disc_and_the_rest_is_dark() {
    let field = cylinder_bumps(64, 8);
    let (relief, base) = (relief(&field), ball(&field, 30.0, SphereChart::Stereographic));
    let pixels = CurvedPixels::new(&camera(Lens::Orthographic { height: 60.0 }, (90, 90)), &base, &relief, DVec3::X);
    let seen = pixels.places().iter().flatten().count() as f64 / 8100.0;
    assert_near(seen, std::f64::consts::FRAC_PI_4, 0.01);
    let lit = pixels.decide(|_| false);
    let picture = pixels.picture(&relief, &lit, &Palette::SAND);
    assert_eq!((picture.width, picture.height, &picture.rgb[..3]), (90, 90, &[16, 18, 22][..]));
    for place in pixels.places().iter().flatten() {
        assert_near(place.position.length(), 30.0, 1e-12);
        assert!(place.frame.normal.x >= 0.0, "the back is not seen");
    }
    // In shadow, every channel of every pixel of the ball is darker or, where it faces away, as dark.
    let dark = pixels.picture(&relief, &pixels.decide(|_| true), &Palette::SAND);
    assert!(dark.rgb.iter().zip(&picture.rgb).all(|(dark, bright)| dark <= bright) && dark != picture);
}

/// Figure 4, left of the middle: no light on the ball there, and yet on its bumps.
#[test]
fn lit_bumps_behind_the_terminator_are_in_the_picture() {
    let field = cylinder_bumps(128, 8);
    let (relief, base) = (relief(&field), ball(&field, 1.0 / 0.015, SphereChart::Stereographic));
    let light = towards(20.0, 15.0);
    let pixels = CurvedPixels::new(&camera(Lens::Orthographic { height: 136.0 }, (128, 128)), &base, &relief, light);
    let oracle = DisplacedShadow::new(&base, &relief, f64::INFINITY);
    let shadow = pixels.decide(|place| oracle.in_shadow(place.uv, light));
    let (picture, dark) = (
        pixels.picture(&relief, &shadow, &Palette::SAND),
        pixels.picture(&relief, &vec![true; shadow.len()], &Palette::SAND),
    );
    let brighter = |k: usize| u32::from(picture.rgb[3 * k]) > u32::from(dark.rgb[3 * k]) + 10;
    let behind = |k: usize| pixels.places()[k].is_some_and(|place| place.light.height < -0.02);
    let lit = (0..shadow.len()).filter(|&k| behind(k) && brighter(k)).count();
    assert!(lit > 20, "{lit} pixels");
}

#[test]
#[should_panic(expected = "one shadow value per pixel")]
fn shadows_of_another_picture_do_not_fit() {
    let field = cylinder_bumps(16, 2);
    let (relief, base) = (relief(&field), ball(&field, 30.0, SphereChart::Geographic));
    let pixels = CurvedPixels::new(&camera(Lens::Orthographic { height: 60.0 }, (4, 4)), &base, &relief, DVec3::X);
    let _ = pixels.picture(&relief, &[false; 15], &Palette::SAND);
}
