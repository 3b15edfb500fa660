//! Geometry and light of pictures.

use barchan_field::{Edge, Shape};
use barchan_shade::{DirectionalLight, Palette, Picture, Pixels, TracedShadow};

use crate::support::{assert_near, field, surface};

#[test]
fn pixels_are_square_in_length_on_any_texels() {
    let of = |size, spacing, per_texel| {
        let pixels = Pixels::over(&surface(&field(size, spacing, Edge::Clamp, |_, _| 0.0)), per_texel);
        (pixels.width, pixels.height)
    };
    assert_eq!(of((10, 6), (1.0, 1.0), 1), (10, 6));
    assert_eq!(of((10, 6), (1.0, 1.0), 3), (30, 18));
    assert_eq!(of((10, 6), (2.0, 1.0), 1), (20, 6));
    assert_eq!(of((10, 6), (2.0, 3.0), 2), (20, 18));
    // 74 m × 93 m texels.
    assert_eq!(of((403, 344), (74.0, 93.0), 1), (403, 432));
    assert_eq!(of((3, 1), (1e-6, 1.0), 0), (3, 1_000_000));
    assert_eq!(of((1000, 1), (1e-3, 1.0), 1), (1000, 1000));
}

#[test]
fn pixel_centres_cover_the_tile_evenly() {
    let pixels = Pixels::over(&surface(&field((3, 2), (1.0, 2.0), Edge::Clamp, |_, _| 0.0)), 1);
    let places = pixels.map(|x, y| (x, y));
    assert_eq!((pixels.width, pixels.height, places.len()), (3, 4, 12));
    assert_eq!(places[0], (0.0, -0.25));
    assert_eq!(places[5], (2.0, 0.25));
    assert_eq!(places[11], (2.0, 1.25));
}

#[test]
fn pictures_stand_side_by_side_with_a_white_gap() {
    let plain = |width: u32, value: u8| Picture { width, height: 2, rgb: vec![value; 3 * width as usize * 2] };
    let joined = Picture::side_by_side(&[plain(2, 1), plain(1, 2)], 1);
    assert_eq!((joined.width, joined.height), (4, 2));
    let row = [1, 1, 1, 1, 1, 1, 255, 255, 255, 2, 2, 2];
    assert_eq!(joined.rgb, [row, row].concat());
    assert_eq!(Picture::side_by_side(&[plain(2, 1)], 9), plain(2, 1));
    assert_eq!(Picture::side_by_side(&[], 9), Picture { width: 0, height: 0, rgb: vec![] });
}

#[test]
#[should_panic(expected = "pictures of the same height")]
fn pictures_of_different_heights_do_not_fit() {
    let plain = |height: u32| Picture { width: 1, height, rgb: vec![0; 3 * height as usize] };
    let _ = Picture::side_by_side(&[plain(1), plain(2)], 0);
}

#[test]
fn every_channel_is_darker_in_shadow_than_in_light() {
    let level = surface(&field((4, 4), (1.0, 1.0), Edge::Clamp, |_, _| 1.0));
    let pixels = Pixels::over(&level, 1);
    let light = DirectionalLight::from_degrees(40.0, 20.0);
    let lit = |shadow: bool| Picture::lit(&level, &light, &pixels, &[shadow; 16], &Palette::SAND);
    assert_eq!((lit(false).width, lit(false).height, lit(false).rgb.len()), (4, 4, 48));
    assert!(lit(true).rgb.iter().zip(&lit(false).rgb).all(|(dark, bright)| dark < bright));
    assert!(lit(true).rgb.iter().all(|&dark| dark > 0), "the sky still lights it");
}

#[test]
fn level_ground_is_as_bright_at_a_low_sun_as_at_noon() {
    let level = surface(&field((2, 2), (1.0, 1.0), Edge::Clamp, |_, _| 1.0));
    let pixels = Pixels::over(&level, 1);
    let lit = |elevation| {
        Picture::lit(&level, &DirectionalLight::from_degrees(0.0, elevation), &pixels, &[false; 4], &Palette::SAND)
    };
    assert_eq!(lit(15.0), lit(80.0));
}

#[test]
fn ground_that_faces_the_sun_is_brighter() {
    // A ridge along the middle column; the sun stands on the right.
    let ridge =
        surface(&field((9, 3), (1.0, 1.0), Edge::Clamp, |column, _| 4.0 - (f32::from(column as u16) - 4.0).abs()));
    let pixels = Pixels::over(&ridge, 1);
    let picture =
        Picture::lit(&ridge, &DirectionalLight::from_degrees(0.0, 60.0), &pixels, &[false; 27], &Palette::SAND);
    let red = |column: usize, row: usize| picture.rgb[3 * (9 * row + column)];
    assert!(red(6, 1) > red(2, 1), "{} and {}", red(6, 1), red(2, 1));
}

#[test]
fn a_normal_leans_downhill_with_v_up_the_picture() {
    let rising_right = surface(&field((5, 5), (2.0, 1.0), Edge::Clamp, |column, _| column as f32));
    let normal = rising_right.normal(2.0, 2.0);
    assert_near(-normal.x / normal.z, 0.5, 1e-12);
    assert_eq!(normal.y, 0.0);
    let rising_to_the_top = surface(&field((5, 5), (1.0, 2.0), Edge::Clamp, |_, row| 4.0 - row as f32));
    let normal = rising_to_the_top.normal(2.0, 2.0);
    assert_near(-normal.y / normal.z, 0.5, 1e-12);
    assert!(normal.x == 0.0 && (normal.length() - 1.0).abs() < 1e-15);
}

/// Every step is IEEE arithmetic or libm's, so the bytes are the same on every machine. A change of look changes this
/// number on purpose.
#[test]
fn a_small_picture_has_the_bytes_it_always_had() {
    let dunes = Shape::examples().into_iter().find(|shape| shape.name() == "dunes").unwrap();
    let grid = *field((24, 16), (256.0 / 24.0, 16.0), Edge::Wrap, |_, _| 0.0).grid();
    let surface = surface(&dunes.rasterize(grid).unwrap());
    let light = DirectionalLight::from_degrees(160.0, 14.0);
    let pixels = Pixels::over(&surface, 2);
    let traced = TracedShadow::new(&surface, &light, 300.0);
    let shadow = pixels.map(|x, y| traced.in_shadow(x, y));
    assert!(shadow.contains(&true) && shadow.contains(&false));
    let picture = Picture::lit(&surface, &light, &pixels, &shadow, &Palette::SAND);
    assert_eq!((picture.width, picture.height), (48, 48));
    assert_eq!(fnv1a(&picture.rgb), 0x19af5c1c64026bce);
}

fn fnv1a(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xCBF2_9CE4_8422_2325, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01B3))
}
