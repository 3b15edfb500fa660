//! Pictures.

use crate::support::{Place, npy, rgb};

const RIPPLES: &str = "(
    source: Shape(shape: Ripples(amplitude: 3.0, waves_u: 4, waves_v: 1), width: 80, height: 60),
    spacing: (0.5, 0.25), edge: wrap, scene: (), horizon: (directions: 16, radius: 20.0, encoding: f32),
)";

fn baked() -> Place {
    let place = Place::new();
    place.bake(RIPPLES);
    place
}

#[test]
fn pixels_are_square_whatever_the_texels_are() {
    let place = baked();
    for (flags, size) in [("", (160, 60)), ("--scale 2", (320, 120)), ("--compare", (3 * 160 + 2 * 8, 60))] {
        let report = place.json(&format!("render out.barchan -o lit.png {flags}"));
        assert_eq!(rgb(&place.read("lit.png")).dimensions(), size, "{flags}");
        assert_eq!((&report["width"], &report["height"]), (&size.0.into(), &size.1.into()), "{flags}");
    }
}

#[test]
fn at_a_baked_azimuth_the_picture_agrees_with_the_traced_one() {
    let place = Place::new();
    place.bake(
        "(
            source: Shape(
                shape: FractalTerrain(height: 12.0, hurst: 0.85, features_across: 2, octaves: 5, seed: 1),
                width: 80, height: 60,
            ),
            edge: wrap, scene: (), horizon: (directions: 16, radius: 60.0, encoding: f16),
        )",
    );
    for azimuth in ["0", "45", "112.5", "270"] {
        let report = place.json(&format!("render out.barchan --azimuth {azimuth} --elevation 10 --compare -o lit.png"));
        let wrong = report["comparison"]["wrong_share"].as_f64().unwrap();
        assert!(wrong < 0.01, "{wrong} of the pixels are wrong at azimuth {azimuth}");
    }
}

#[test]
fn the_third_panel_counts_what_is_wrong() {
    // Two azimuths are not enough for a sun between them, so that something is wrong.
    let place = Place::new();
    place.bake(&RIPPLES.replace("directions: 16", "directions: 3"));
    let report = place.json("render out.barchan --azimuth 60 --elevation 12 --compare -o lit.png");
    let picture = rgb(&place.read("lit.png"));
    let panel = |x: u32, y: u32| picture.get_pixel(2 * (160 + 8) + x, y).0;
    let count = |wanted: fn([u8; 3]) -> bool| {
        (0..60).flat_map(|y| (0..160).map(move |x| (x, y))).filter(|&(x, y)| wanted(panel(x, y))).count()
    };
    let (red, blue) = (count(|[r, _, b]| r > b), count(|[r, _, b]| b > r));
    let comparison = &report["comparison"];
    assert_eq!((&comparison["false_shadow_pixels"], &comparison["missed_shadow_pixels"]), (&red.into(), &blue.into()));
    assert!(red + blue > 0);
    assert_eq!(comparison["wrong_share"].as_f64(), Some((red + blue) as f64 / (160.0 * 60.0)));
}

#[test]
fn a_lower_sun_casts_longer_shadows() {
    let place = baked();
    let share = |elevation: u32| {
        let report = place.json(&format!("render out.barchan --azimuth 0 --elevation {elevation} -o lit.png"));
        report["shadow_share"].as_f64().unwrap()
    };
    let shares = [5, 15, 30, 60].map(share);
    assert!(shares.is_sorted_by(|lower, higher| lower > higher), "{shares:?}");
    assert_eq!(share(90), 0.0);
}

#[test]
fn a_shadow_points_away_from_the_sun() {
    let mut heights = vec![0.0; 21 * 21];
    heights[10 * 21 + 10] = 4.0;
    let place = Place::with("mast.npy", npy(21, &heights));
    place.ok("bake mast.npy --directions 4 --only height,horizon");
    // Sun at the right, the top, the left, the bottom of the picture.
    for (azimuth, (x, y)) in [("0", (6, 10)), ("90", (10, 14)), ("180", (14, 10)), ("270", (10, 6))] {
        place.ok(&format!("render mast.barchan --azimuth {azimuth} --elevation 20 -o mast.png"));
        let picture = rgb(&place.read("mast.png"));
        let brightness = |x: u32, y: u32| picture.get_pixel(x, y).0.map(u32::from).iter().sum::<u32>();
        assert!(2 * brightness(x, y) < brightness(20 - x, 20 - y), "sun at {azimuth}°");
    }
}

#[test]
fn a_picture_needs_heights_and_a_horizon() {
    let place = Place::with("recipe.ron", RIPPLES);
    place.ok("bake recipe.ron --only horizon -o out.barchan");
    assert_eq!(
        place.fails(2, "render out.barchan -o lit.png"),
        "out.barchan: there is no height table; the file has horizon"
    );
    assert!(!place.names().contains(&"lit.png".to_owned()));
}

#[test]
fn a_sun_outside_the_arc_is_refused_and_one_within_agrees_with_the_traced_one() {
    let place = Place::new();
    place.bake(&RIPPLES.replace("directions: 16", "directions: 9, arc: (-45, 135)"));
    for azimuth in ["-45", "0", "135", "315"] {
        let report = place.json(&format!("render out.barchan --azimuth {azimuth} --elevation 10 --compare -o lit.png"));
        let wrong = report["comparison"]["wrong_share_at_texel_centres"].as_f64().unwrap();
        assert!(wrong < 0.01, "{wrong} of the texels are wrong at azimuth {azimuth}");
    }
    assert_eq!(
        place.fails(1, "render out.barchan --azimuth 200 -o other.png"),
        "out.barchan: --azimuth is 200; its horizon is baked from -45° to 135°"
    );
}

#[test]
fn under_an_overcast_sky_a_hollow_is_darker_than_a_peak() {
    let place = Place::new();
    place.bake(&RIPPLES.replace("scene: ()", "scene: (ambient_light: true)"));
    let report = place.json("render out.barchan --ambient -o overcast.png");
    assert_eq!(report["schema"], "barchan.render_ambient/1");
    let shares = place.array("out.barchan", "sky_visibility");
    let mean = shares.values.iter().sum::<f32>() / shares.values.len() as f32;
    assert!((report["mean_visibility"].as_f64().unwrap() - f64::from(mean)).abs() < 1e-3);
    // Texels are two pixels wide.
    let picture = rgb(&place.read("overcast.png"));
    let brightness = |texel: usize| picture.get_pixel((texel % 80 * 2) as u32, (texel / 80) as u32).0[1];
    let by_share = |a: &usize, b: &usize| shares.values[*a].total_cmp(&shares.values[*b]);
    let (hollow, peak) = ((0..4800).min_by(by_share).unwrap(), (0..4800).max_by(by_share).unwrap());
    assert!(brightness(hollow) + 40 < brightness(peak), "{} {}", brightness(hollow), brightness(peak));
    place.bake(RIPPLES);
    assert_eq!(
        place.fails(2, "render out.barchan --ambient -o other.png"),
        "out.barchan: there is no sky_visibility table; the file has height and horizon"
    );
    assert_eq!(place.run("render out.barchan --ambient --compare -o other.png").code, Some(1));
}
