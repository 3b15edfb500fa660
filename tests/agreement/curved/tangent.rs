//! Lights and normals in charts of all kinds.

use std::f64::consts::TAU;

use barchan_shade::{TangentFrame, TangentLight};
use glam::DVec3;

use super::draw::evaluate;
use super::equations::{agree_in_a_line, least};

/// Pu and Pv as f32 has them, and whether Pu × Pv points into the surface.
fn charts() -> Vec<(DVec3, DVec3, bool)> {
    let vector = |x: f32, y: f32, z: f32| DVec3::new(x.into(), y.into(), z.into());
    let sheared = [vector(2.0, 0.3, 0.5), vector(1.5, 0.4, 0.6)];
    vec![
        (vector(64.0, 0.0, 0.0), vector(0.0, 64.0, 0.0), false),
        (vector(64.0, 0.0, 0.0), vector(0.0, 3.0, 0.0), false),
        (vector(0.2, 1.0, -0.4), vector(-3.0, 0.5, 1.0), false),
        (sheared[0], sheared[1], false),
        (sheared[0], sheared[1], true),
        (sheared[0] * 1e7, sheared[1] * 1e7, false),
        (sheared[0] * 1e-7, sheared[1] * 1e-7, true),
        (vector(-1.0, 0.0, 0.0), vector(0.0, 1.0, 0.0), true),
    ]
    .into_iter()
    .map(|(u, v, mirrored)| (u.as_vec3().as_dvec3(), v.as_vec3().as_dvec3(), mirrored))
    .collect()
}

const EXTENT: (f64, f64) = (24.0, 40.0);

#[test]
fn a_light_is_seen_alike_in_stretched_sheared_and_mirrored_charts() {
    let (mut inputs, mut expected) = (Vec::new(), Vec::new());
    for (along_u, along_v, mirrored) in charts() {
        let frame = TangentFrame::new(along_u, along_v, mirrored).unwrap();
        for azimuth in 0..24 {
            // Behind the terminator, along the surface, and near the zenith.
            for elevation in [-0.7_f64, -0.01, 0.0, 0.3, 1.2, 1.5] {
                let (sin, cos) = libm::sincos(TAU * f64::from(azimuth) / 24.0);
                let across = frame.along_u.normalize();
                let level = across * cos + frame.normal.cross(across) * sin;
                let towards = (level * libm::cos(elevation) + frame.normal * libm::sin(elevation)).as_vec3();
                expected.push(TangentLight::new(&frame, towards.as_dvec3(), EXTENT));
                inputs.push([along_u.as_vec3(), along_v.as_vec3(), towards].map(|v| [v.x, v.y, v.z, 0.0]));
                let normal = frame.normal.as_vec3();
                let input = inputs.last_mut().unwrap();
                (input[0][3], input[1][3], input[2][3]) = (normal.x, normal.y, normal.z);
            }
        }
    }
    let light = |answer: &str| {
        format!(
            "let light = barchan_tangent_light(a.xyz, b.xyz, vec3<f32>(a.w, b.w, c.w), c.xyz, vec2<f32>({:?}, {:?}));
    return {answer};",
            EXTENT.0, EXTENT.1
        )
    };
    let found =
        evaluate(least(), &light("vec4<f32>(light.height, light.level, light.azimuth, light.stretch)"), &inputs);
    let of = |number: fn(&TangentLight) -> f64| expected.iter().map(number).collect::<Vec<_>>();
    eprintln!("height {:e}", agree_in_a_line("light_height", &found, 0, &of(|light| light.height), 2e-7));
    eprintln!("level {:e}", agree_in_a_line("light_level", &found, 1, &of(|light| light.level), 2e-7));
    // Seen from a light 4° from the zenith, azimuths are 14 times as far apart.
    let (found_turns, turns): (Vec<_>, Vec<_>) = found
        .iter()
        .zip(&expected)
        .map(|(found, expected)| {
            let off = f64::from(found[2]) - expected.azimuth_radians;
            (off - TAU * (off / TAU).round(), 0.0)
        })
        .unzip();
    let found_turns: Vec<_> = found_turns.iter().map(|&off| [off as f32, 0.0, 0.0, 0.0]).collect();
    eprintln!("azimuth {:e}", agree_in_a_line("light_azimuth", &found_turns, 0, &turns, 2e-5));
    let relative: Vec<_> = found.iter().zip(&expected).map(|(f, e)| [f[3] / e.stretch as f32, 0.0, 0.0, 0.0]).collect();
    eprintln!("stretch {:e}", agree_in_a_line("light_stretch", &relative, 0, &vec![1.0; relative.len()], 1e-5));
    // The direction may have any length.
    let found = evaluate(least(), &light("vec4<f32>(light.direction / length(light.direction), 0.0, 0.0)"), &inputs);
    for axis in [0, 1] {
        let expected: Vec<_> = expected.iter().map(|light| light.direction.normalize()[axis]).collect();
        eprintln!("direction {:e}", agree_in_a_line("light_direction", &found, axis, &expected, 2e-5));
    }
}

#[test]
fn a_light_at_the_zenith_or_without_a_chart_has_no_azimuth() {
    let frame = |along_u: DVec3, along_v: DVec3| TangentFrame { along_u, along_v, normal: DVec3::Z };
    let none = frame(DVec3::X, DVec3::X * 2.0);
    let oblique = DVec3::new(0.6, 0.0, 0.8).as_vec3().as_dvec3();
    let cases = [(frame(DVec3::X, DVec3::Y), DVec3::Z), (frame(DVec3::X, DVec3::Y), -DVec3::Z), (none, oblique)];
    let inputs = cases.map(|(frame, towards)| {
        [(frame.along_u, 0.0), (frame.along_v, 0.0), (towards, 1.0)].map(|(vector, w)| {
            let vector = vector.as_vec3();
            [vector.x, vector.y, vector.z, w]
        })
    });
    let body = "let light = barchan_tangent_light(a.xyz, b.xyz, vec3<f32>(a.w, b.w, c.w), c.xyz, vec2<f32>(1.0));
    return vec4<f32>(light.height, light.level, light.azimuth, light.stretch);";
    for ((frame, towards), found) in cases.into_iter().zip(evaluate(least(), body, &inputs)) {
        let light = TangentLight::new(&frame, towards, (1.0, 1.0));
        let expected = [light.height, light.level, light.azimuth_radians, light.stretch];
        assert_eq!(expected[2..], [0.0, 1.0]);
        assert!(found.iter().zip(expected).all(|(found, expected)| (f64::from(*found) - expected).abs() < 1e-7));
    }
}

#[test]
fn bump_normals_agree() {
    let (mut inputs, mut expected) = (Vec::new(), Vec::new());
    for (along_u, along_v, mirrored) in charts() {
        let frame = TangentFrame::new(along_u, along_v, mirrored).unwrap();
        // Slopes on the surface of up to 3, whatever the chart.
        for (rise_u, rise_v) in [(0.0, 0.0), (0.5, -0.2), (-3.0, 1.0), (0.01, 2.0)] {
            let per_uv = [rise_u * along_u.length(), rise_v * along_v.length()].map(|per| f64::from(per as f32));
            expected.push(frame.bump_normal(per_uv[0], per_uv[1]));
            let (u, v) = (along_u.as_vec3(), along_v.as_vec3());
            let side = if mirrored { -1.0 } else { 1.0 };
            inputs.push([[u.x, u.y, u.z, per_uv[0] as f32], [v.x, v.y, v.z, per_uv[1] as f32], [side, 0.0, 0.0, 0.0]]);
        }
    }
    let body = "let normal = c.x * normalize(cross(normalize(a.xyz), normalize(b.xyz)));
    return vec4<f32>(barchan_bump_normal(a.xyz, b.xyz, normal, vec2<f32>(a.w, b.w)), 0.0);";
    let found = evaluate(least(), body, &inputs);
    for axis in 0..3 {
        let expected: Vec<_> = expected.iter().map(|normal| normal[axis]).collect();
        eprintln!("bump normal {:e}", agree_in_a_line("bump_normal", &found, axis, &expected, 1e-5));
    }
    let flat = "return vec4<f32>(barchan_bump_normal(a.xyz, b.xyz, c.xyz, vec2<f32>(1.0, 2.0)), 0.0);";
    let without_plane = [[1.0, 0.0, 0.0, 0.0], [2.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];
    assert_eq!(evaluate(least(), flat, &[without_plane]), [[0.0, 0.0, 1.0, 0.0]]);
}
