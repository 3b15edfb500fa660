//! Closed-form values, tiling, continuity, pinned digests, and what the natural shapes promise.

use proptest::prelude::*;

use super::*;
use crate::{Edge, LengthUnit, Spacing};

fn grid(width: u32, height: u32, u: f64, v: f64, edge: Edge) -> Grid {
    Grid { width, height, spacing: Spacing::new(u, v).unwrap(), unit: LengthUnit::Metre, edge }
}

/// A tile of 256 × 256 lengths whose texels are not square.
fn oblong() -> Grid {
    grid(64, 48, 4.0, 256.0 / 48.0, Edge::Wrap)
}

fn example(name: &str) -> Shape {
    Shape::examples().into_iter().find(|shape| shape.name() == name).unwrap()
}

fn close(a: f64, b: f64, tolerance: f64) -> bool {
    (a - b).abs() <= tolerance
}

#[test]
fn names_and_examples_go_together() {
    let names: Vec<_> = Shape::examples().iter().map(Shape::name).collect();
    assert_eq!(names, Shape::ALL_NAMES);
}

#[test]
fn v_points_up_the_picture() {
    let field =
        Shape::Plane(Plane { slope_u: 0.25, slope_v: 0.5 }).rasterize(grid(4, 2, 2.0, 3.0, Edge::Clamp)).unwrap();
    // The centre of texel (0, 0) lies 3 lengths left of the middle and 1.5 above it.
    assert_eq!(field.texel(0, 0), 0.25 * -3.0 + 0.5 * 1.5);
    assert_eq!(field.texel(3, 1), 0.25 * 3.0 - 0.5 * 1.5);
}

#[test]
fn a_wall_stands_where_it_is_put() {
    let wall = Shape::StepWall(StepWall { height: 7.0, position: 0.25, across: Axis::V });
    let field = wall.rasterize(grid(1, 8, 1.0, 1.0, Edge::Clamp)).unwrap();
    assert_eq!(field.samples(), [7.0, 7.0, 7.0, 7.0, 7.0, 7.0, 0.0, 0.0]);
    assert_eq!(wall.height_at(field.grid(), 0.5, 0.25), 7.0);
}

#[test]
fn a_spike_is_one_texel_and_its_closed_form_is_the_bilinear_surface() {
    for (width, height) in [(8, 8), (7, 5), (2, 3), (1, 4), (1, 1)] {
        for edge in [Edge::Wrap, Edge::Clamp] {
            let (spike, grid) = (Shape::Spike(Spike { height: 5.0 }), grid(width, height, 1.0, 2.0, edge));
            let field = spike.rasterize(grid).unwrap();
            assert_eq!(field.samples().iter().filter(|&&h| h == 5.0).count(), 1);
            assert_eq!(field.texel(i64::from(width / 2), i64::from(height / 2)), 5.0);
            for (u, v) in [(0.5, 0.5), (0.03, 0.9), (0.61, 0.37), (0.99, 0.01), (0.45, 0.7)] {
                let (x, y) = (u * f64::from(width) - 0.5, (1.0 - v) * f64::from(height) - 0.5);
                let (found, expected) = (spike.height_at(&grid, u, v), field.surface(x, y));
                assert!(
                    close(found, expected, 1e-12),
                    "{width}×{height} {edge:?} at {u}, {v}: {found}, not {expected}"
                );
            }
        }
    }
}

#[test]
fn closed_forms_have_their_textbook_values() {
    let grid = oblong();
    let at = |shape: Shape, u, v| shape.height_at(&grid, u, v);
    let ripples = Ripples { amplitude: 2.0, waves_u: 3, waves_v: -1, phase: 0.25, pattern: RipplePattern::Oblique };
    assert!(close(at(Shape::Ripples(ripples), 0.0, 0.0), 2.0, 1e-15));
    assert!(close(at(Shape::Ripples(ripples), 0.5, 0.5), -2.0 * -1.0, 1e-14));
    let box_of_eggs = Ripples { phase: 0.0, waves_v: 1, pattern: RipplePattern::EggBox, ..ripples };
    assert!(close(at(Shape::Ripples(box_of_eggs), 1.0 / 12.0, 0.25), 2.0, 1e-14));
    let hill = Gaussian { height: 10.0, sigma: 16.0, centre_u: 0.5, centre_v: 0.25 };
    assert_eq!(at(Shape::Gaussian(hill), 0.5, 0.25), 10.0);
    assert!(close(at(Shape::Gaussian(hill), 0.5, 0.25 + 1.0 / 16.0), 10.0 * (-0.5f64).exp(), 1e-14));
    let pyramid = Pyramid { height: 10.0, half_width: 64.0, centre_u: 0.5, centre_v: 0.5 };
    assert_eq!(at(Shape::Pyramid(pyramid), 0.625, 0.5625), 5.0);
    assert_eq!(at(Shape::Pyramid(pyramid), 0.0, 0.5), 0.0);
    let rows = CylinderBumps { height: 8.0, rows: 16, coverage: 1.0, across: Axis::U };
    assert_eq!(at(Shape::CylinderBumps(rows), 0.5 / 16.0, 0.3), 8.0);
    // Half a radius from the ridge of a true half-circle.
    assert!(close(at(Shape::CylinderBumps(rows), 0.75 / 16.0, 0.3), 8.0 * 0.75f64.sqrt(), 1e-12));
}

#[test]
fn symmetric_shapes_are_symmetric_to_the_bit() {
    let centred = ["gaussian", "pyramid", "cylinder_bumps"];
    for shape in Shape::examples().into_iter().filter(|shape| centred.contains(&shape.name())) {
        let field = shape.rasterize(grid(32, 16, 8.0, 16.0, Edge::Clamp)).unwrap();
        for (row, column) in (0..16).flat_map(|row| (0..32).map(move |column| (row, column))) {
            let h = field.texel(column, row);
            assert_eq!(h, field.texel(31 - column, row), "{} is not its own mirror image along u", shape.name());
            assert_eq!(h, field.texel(column, 15 - row), "{} is not its own mirror image along v", shape.name());
        }
    }
}

#[test]
fn values_and_slopes_go_on_across_the_seam() {
    for shape in Shape::examples().into_iter().filter(Shape::tiles) {
        for grid in [oblong(), grid(96, 32, 2.0, 5.0, Edge::Wrap), grid(1, 50, 3.0, 90.0, Edge::Wrap)] {
            if shape.rasterize(grid).is_err() {
                continue; // Dunes refuse a tile too narrow for their height.
            }
            let surface = shape.surface(&grid);
            for (k, delta) in (0..40).flat_map(|k| [-1e-4, 0.0, 1e-4].map(|delta| (k, delta))) {
                let t = f64::from(k) / 40.0 + 0.003;
                for ((u, v), (u2, v2)) in [((delta, t), (1.0 + delta, t)), ((t, delta), (t, 1.0 + delta))] {
                    let (near, far) = (surface(u, v), surface(u2, v2));
                    assert!(close(near, far, 1e-6), "{} is {near} at {u}, {v} but {far} one tile on", shape.name());
                }
            }
        }
    }
}

#[test]
fn the_natural_shapes_have_no_cracks() {
    let irregular = ReptileSkin { scale_height: 4.0, scales_across: 9, irregularity: 1.0, seed: 5 };
    let crescents = Dunes {
        dune_height: 15.0,
        dunes_across: 4,
        ripple_height: 0.3,
        ripples_across: 60,
        sinuosity: 1.0,
        slip_degrees: 32.0,
        seed: 12,
    };
    let grid = oblong();
    let shapes = ["reptile_skin", "dunes", "fractal_terrain"].map(example);
    for shape in shapes.into_iter().chain([Shape::ReptileSkin(irregular), Shape::Dunes(crescents)]) {
        let surface = shape.surface(&grid);
        let step = 1e-6;
        for k in 0..20_000 {
            let (u, v) = ((f64::from(k) * 0.618_033_988_7).fract(), (f64::from(k) * 0.754_877_666_2).fract());
            let (here, beside, above) = (surface(u, v), surface(u + step, v), surface(u, v + step));
            // No slope steeper than 10; a crack would be steeper by orders of magnitude.
            let most = 10.0 * step * 256.0;
            assert!(close(here, beside, most) && close(here, above, most), "{} has a crack at {u}, {v}", shape.name());
        }
    }
}

/// FNV-1a over the bits, byte by byte.
fn digest(field: &HeightField) -> u64 {
    let bytes = field.samples().iter().flat_map(|h| h.to_bits().to_le_bytes());
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

#[test]
fn every_example_has_the_same_bits_everywhere() {
    let pinned: [(&str, u64); 10] = [
        ("plane", 0xb483_16ac_a21b_69a5),
        ("step_wall", 0xe107_a44e_86bb_c325),
        ("spike", 0x1529_459f_deec_17df),
        ("ripples", 0x262c_f3da_d9cb_4725),
        ("gaussian", 0x9334_9833_001e_1235),
        ("pyramid", 0xbf92_4e8e_4241_7555),
        ("cylinder_bumps", 0x2f1f_db4f_024b_5f25),
        ("reptile_skin", 0x534e_b50c_9408_9a6d),
        ("dunes", 0x83da_de72_af9b_f98a),
        ("fractal_terrain", 0xd757_c878_61fb_1e98),
    ];
    let found =
        Shape::examples().iter().map(|s| (s.name(), digest(&s.rasterize(oblong()).unwrap()))).collect::<Vec<_>>();
    assert_eq!(found, pinned, "the bits have changed; {found:#x?}");
}

#[test]
fn seeds_matter() {
    for name in ["reptile_skin", "dunes", "fractal_terrain"] {
        let (one, mut other) = (example(name), example(name));
        match &mut other {
            Shape::ReptileSkin(p) => p.seed = u64::MAX,
            Shape::Dunes(p) => p.seed = u64::MAX,
            Shape::FractalTerrain(p) => p.seed = u64::MAX,
            _ => unreachable!(),
        }
        assert_ne!(one.rasterize(oblong()), other.rasterize(oblong()), "{name} ignores its seed");
    }
}

#[test]
fn slip_faces_lie_at_the_angle_of_repose_and_windward_sides_are_gentle() {
    for degrees in [28.0, 32.0, 36.0] {
        let Shape::Dunes(dunes) = example("dunes") else { unreachable!() };
        let bare = Shape::Dunes(Dunes { ripple_height: 0.0, slip_degrees: degrees, ..dunes });
        let field = bare.rasterize(grid(256, 256, 1.0, 1.0, Edge::Wrap)).unwrap();
        let (mut slips, mut windward) = (Vec::new(), Vec::new());
        for (row, column) in (0..256).flat_map(|row| (0..256).map(move |column| (row, column))) {
            let slope_u = f64::from(field.texel(column + 1, row) - field.texel(column - 1, row)) / 2.0;
            let slope_v = f64::from(field.texel(column, row - 1) - field.texel(column, row + 1)) / 2.0;
            let angle = slope_u.hypot(slope_v).atan().to_degrees();
            if slope_u < 0.0 && angle > degrees - 5.0 { slips.push(angle) } else { windward.push(angle) }
        }
        slips.sort_by(f64::total_cmp);
        windward.sort_by(f64::total_cmp);
        let (median, high) = (slips[slips.len() / 2], slips[slips.len() * 95 / 100]);
        assert!(slips.len() > 65536 / 20, "only {} texels slip", slips.len());
        assert!(close(median, degrees, 1.0) && high < degrees + 2.0, "{degrees}°: median {median}, 95 % {high}");
        assert!(windward[windward.len() * 95 / 100] < 25.0, "windward sides are too steep");
    }
}

#[test]
fn dunes_keep_between_the_ground_and_their_height() {
    let Shape::Dunes(dunes) = example("dunes") else { unreachable!() };
    for seed in 0..8 {
        let field = Shape::Dunes(Dunes { seed, ..dunes }).rasterize(oblong()).unwrap();
        let (lowest, highest) = field.range();
        assert!(lowest >= 0.0 && f64::from(highest) < 1.02 * dunes.dune_height + dunes.ripple_height);
        assert!(f64::from(highest) > 0.8 * dunes.dune_height, "seed {seed}: highest {highest}");
    }
}

#[test]
fn dunes_too_high_for_their_distance_are_refused_in_one_sentence() {
    let Shape::Dunes(dunes) = example("dunes") else { unreachable!() };
    let error = Shape::Dunes(Dunes { dunes_across: 4, ..dunes }).rasterize(oblong()).unwrap_err();
    let said = "dunes: dune_height is 24; at most 0.45 · tan(slip_degrees) of the distance between dunes (the extent along \
                u / dunes_across) is needed";
    assert_eq!(error.to_string(), said);
}

#[test]
fn scales_rise_from_grooves_at_zero() {
    let field = example("reptile_skin").rasterize(grid(256, 256, 1.0, 1.0, Edge::Wrap)).unwrap();
    let (lowest, highest) = field.range();
    assert_eq!(lowest, 0.0);
    assert!((3.5..6.0).contains(&highest), "{highest}");
    let grooves = field.samples().iter().filter(|&&h| h < 0.4).count();
    assert!((0.03..0.3).contains(&(grooves as f64 / 65536.0)), "{grooves} texels of groove");
}

/// Mean squared difference of heights `lag` tile widths apart, over points strewn in every direction.
fn structure(terrain: FractalTerrain, lag: f64) -> f64 {
    let surface = terrain.surface(&oblong());
    let squares = (0..40_000).map(|k| {
        let (u, v) = ((f64::from(k) * 0.618_033_988_7).fract(), (f64::from(k) * 0.754_877_666_2).fract());
        let (sin, cos) = (f64::from(k) * 0.7).sin_cos();
        (surface(u + lag * cos, v + lag * sin) - surface(u, v)).powi(2)
    });
    squares.sum()
}

#[test]
fn the_structure_function_grows_with_the_hurst_exponent() {
    for (hurst, tolerance) in [(0.2, 0.04), (0.5, 0.04), (0.8, 0.04), (1.0, 0.1)] {
        // Features from a whole tile down to 6e-6 of it: the lags lie well between.
        let terrain = FractalTerrain { height: 30.0, hurst, features_across: 1, octaves: 16, seed: 2 };
        let found = 0.5 * (structure(terrain, 5e-3) / structure(terrain, 2e-4)).ln() / 25f64.ln();
        assert!(close(found, hurst, tolerance), "H = {hurst} grows as {found}");
    }
}

#[test]
fn fractal_heights_have_the_deviation_they_promise() {
    let terrain = FractalTerrain { height: 60.0, hurst: 0.5, features_across: 8, octaves: 5, seed: 0 };
    let mut sum = 0.0;
    for seed in 0..16 {
        let field = Shape::FractalTerrain(FractalTerrain { seed, ..terrain }).rasterize(oblong()).unwrap();
        sum += field.samples().iter().map(|&h| f64::from(h).powi(2)).sum::<f64>() / field.samples().len() as f64;
    }
    let deviation = (sum / 16.0).sqrt();
    assert!(close(deviation, 10.0, 0.7), "{deviation}");
}

#[test]
fn bad_parameters_are_refused_by_name() {
    let refused = |shape: Shape| match shape.validate() {
        Err(FieldError::Parameter { shape: found, name, .. }) => {
            assert_eq!(found, shape.name());
            name
        }
        other => panic!("{shape:?} gave {other:?}"),
    };
    let Shape::Dunes(dunes) = example("dunes") else { unreachable!() };
    let Shape::FractalTerrain(terrain) = example("fractal_terrain") else { unreachable!() };
    let Shape::ReptileSkin(skin) = example("reptile_skin") else { unreachable!() };
    let Shape::Ripples(ripples) = example("ripples") else { unreachable!() };
    let Shape::Gaussian(hill) = example("gaussian") else { unreachable!() };
    let Shape::Pyramid(pyramid) = example("pyramid") else { unreachable!() };
    let Shape::CylinderBumps(rows) = example("cylinder_bumps") else { unreachable!() };
    let nan = f64::NAN;
    assert_eq!(refused(Shape::Plane(Plane { slope_u: 0.0, slope_v: nan })), "slope_v");
    assert_eq!(refused(Shape::StepWall(StepWall { height: 1.0, position: 1.5, across: Axis::U })), "position");
    assert_eq!(refused(Shape::Spike(Spike { height: f64::INFINITY })), "height");
    assert_eq!(refused(Shape::Ripples(Ripples { waves_u: 0, waves_v: 0, ..ripples })), "waves_u");
    assert_eq!(refused(Shape::Ripples(Ripples { amplitude: nan, ..ripples })), "amplitude");
    assert_eq!(refused(Shape::Gaussian(Gaussian { sigma: 0.0, ..hill })), "sigma");
    assert_eq!(refused(Shape::Pyramid(Pyramid { half_width: -1.0, ..pyramid })), "half_width");
    assert_eq!(refused(Shape::CylinderBumps(CylinderBumps { rows: 0, ..rows })), "rows");
    assert_eq!(refused(Shape::CylinderBumps(CylinderBumps { coverage: 0.0, ..rows })), "coverage");
    assert_eq!(refused(Shape::ReptileSkin(ReptileSkin { scales_across: 0, ..skin })), "scales_across");
    assert_eq!(refused(Shape::ReptileSkin(ReptileSkin { irregularity: 1.1, ..skin })), "irregularity");
    assert_eq!(refused(Shape::Dunes(Dunes { dune_height: -1.0, ..dunes })), "dune_height");
    assert_eq!(refused(Shape::Dunes(Dunes { dunes_across: 0, ..dunes })), "dunes_across");
    assert_eq!(refused(Shape::Dunes(Dunes { slip_degrees: 90.0, ..dunes })), "slip_degrees");
    assert_eq!(refused(Shape::FractalTerrain(FractalTerrain { hurst: 0.0, ..terrain })), "hurst");
    assert_eq!(refused(Shape::FractalTerrain(FractalTerrain { hurst: 1.01, ..terrain })), "hurst");
    assert_eq!(refused(Shape::FractalTerrain(FractalTerrain { octaves: 0, ..terrain })), "octaves");
}

#[test]
fn an_empty_grid_is_refused() {
    let empty = Grid { width: 0, ..oblong() };
    for shape in Shape::examples() {
        assert_eq!(shape.rasterize(empty), Err(FieldError::Empty { width: 0, height: 48 }));
        let _meaningless_but_no_panic = shape.height_at(&empty, 0.5, 0.5);
    }
}

#[test]
fn shapes_read_well_in_ron() {
    let ron = ron::Options::default().with_default_extension(ron::extensions::Extensions::UNWRAP_VARIANT_NEWTYPES);
    let read = |text: &str| ron.from_str::<Shape>(text);
    let dunes = "Dunes(dune_height: 24.0, dunes_across: 2, ripple_height: 0.6, ripples_across: 48, seed: 7)";
    assert_eq!(read(dunes), Ok(example("dunes")));
    assert_eq!(read("StepWall(height: 32, across: u)"), Ok(example("step_wall")));
    assert_eq!(read("Ripples(amplitude: 4, waves_u: 8, waves_v: 0, pattern: oblique)"), Ok(example("ripples")));
    assert_eq!(read("ReptileSkin(scale_height: 4, scales_across: 12, seed: 3)"), Ok(example("reptile_skin")));
    assert!(read("Spike(height: 1, width: 2)").unwrap_err().to_string().contains("width"));
    for shape in Shape::examples() {
        assert_eq!(read(&ron.to_string(&shape).unwrap()), Ok(shape));
    }
}

/// Any shape within the accepted ranges, and a grid that dunes of that height accept.
fn any_shape() -> impl Strategy<Value = Shape> {
    let (part, height, length) =
        (0.0..=1.0f64, -1e30..=1e30f64, (-30.0..=30.0f64).prop_map(|e| 10f64.powf(e).clamp(1e-30, 1e30)));
    let (count, seed) = (1..=1024u32, any::<u64>());
    let numbers = (height, length, part.clone(), part, count.clone(), count, 1..=16u32, seed);
    (0..10usize, numbers).prop_map(|(kind, (height, length, a, b, m, n, octaves, seed))| {
        let (waves_u, waves_v, across) = (m as i32 * 64, -(n as i32), if a < 0.5 { Axis::U } else { Axis::V });
        match kind {
            0 => Shape::Plane(Plane { slope_u: 2e6 * (a - 0.5), slope_v: 2e6 * (b - 0.5) }),
            1 => Shape::StepWall(StepWall { height, position: b, across }),
            2 => Shape::Spike(Spike { height }),
            3 => Shape::Ripples(Ripples { amplitude: height, waves_u, waves_v, phase: b, pattern: Default::default() }),
            4 => Shape::Gaussian(Gaussian { height, sigma: length, centre_u: a, centre_v: b }),
            5 => Shape::Pyramid(Pyramid { height, half_width: length, centre_u: a, centre_v: b }),
            6 => Shape::CylinderBumps(CylinderBumps { height, rows: m * 64, coverage: a.max(1e-6), across }),
            7 => Shape::ReptileSkin(ReptileSkin { scale_height: length, scales_across: m, irregularity: a, seed }),
            8 => Shape::Dunes(Dunes {
                dune_height: if seed % 8 == 0 { 0.0 } else { 0.079 * a },
                dunes_across: m,
                ripple_height: length,
                ripples_across: n * 64,
                sinuosity: b,
                slip_degrees: 10.0 + 35.0 * a,
                seed,
            }),
            _ => Shape::FractalTerrain(FractalTerrain {
                height: length,
                hurst: a.max(1e-3),
                features_across: m,
                octaves,
                seed,
            }),
        }
    })
}

proptest! {
    #[test]
    fn accepted_parameters_give_finite_heights(
        shape in any_shape(), width in 1..=9u32, height in 1..=9u32, wide in 0.0..=20.0f64, tall in -20.0..=20.0f64,
    ) {
        let mut grid = grid(width, height, 10f64.powf(wide), 10f64.powf(tall), Edge::Wrap);
        if let Shape::Dunes(dunes) = shape {
            // One length from dune to dune.
            grid.spacing = Spacing::new(f64::from(dunes.dunes_across) / f64::from(width), grid.spacing.v()).unwrap();
        }
        prop_assert!(shape.rasterize(grid).is_ok(), "{:?}", shape.rasterize(grid));
    }

    #[test]
    fn ripples_are_odd_under_half_a_wave(t in 0.0..1.0f64, waves in 1..100i32) {
        let shape = Shape::Ripples(Ripples {
            amplitude: 1.0, waves_u: waves, waves_v: 0, phase: 0.0, pattern: RipplePattern::Oblique,
        });
        let half = 0.5 / f64::from(waves);
        let (here, there) = (shape.height_at(&oblong(), t, 0.0), shape.height_at(&oblong(), t + half, 0.0));
        prop_assert!(close(here, -there, 1e-11));
    }
}
