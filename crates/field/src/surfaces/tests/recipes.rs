//! Surfaces and tessellations in recipes, and what is refused.

use super::*;

#[test]
fn surfaces_and_tessellations_survive_a_recipe() {
    for surface in ParametricSurface::examples() {
        let text = ron::to_string(&surface).unwrap();
        assert_eq!(ron::from_str::<ParametricSurface>(&text).unwrap(), surface, "{text}");
    }
    let torus: ParametricSurface = ron::from_str("Torus(major: 2.0, minor: 0.5)").unwrap();
    assert_eq!(torus, ParametricSurface::Torus { major: 2.0, minor: 0.5 });
    let tessellation: Tessellation = ron::from_str("(vertices: 4000, pattern: LongThin(aspect: 20.0))").unwrap();
    let expected =
        Tessellation { vertices: 4000, pattern: Pattern::LongThin { aspect: 20.0 }, seed: 0, uv_seam: false };
    assert_eq!(tessellation, expected);
}

#[test]
fn unknown_fields_are_refused() {
    assert!(ron::from_str::<ParametricSurface>("Sphere(radius: 1.0, colour: 2.0)").is_err());
    assert!(ron::from_str::<Tessellation>("(vertices: 40, pattern: Random, weight: 2)").is_err());
}

#[test]
fn examples_are_accepted() {
    for surface in ParametricSurface::examples() {
        surface.validate().unwrap();
    }
}

#[test]
fn parameters_out_of_range_are_named() {
    use ParametricSurface as S;
    let mut bent = example("bezier_patch");
    if let S::BezierPatch { control } = &mut bent {
        control[2][1].y = f64::NAN;
    }
    let refused = [
        (S::Sphere { radius: 0.0 }, "sphere: radius is 0; a positive length from 1e-9 to 1e9 is needed"),
        (S::Ellipsoid { a: 1.0, b: f64::NAN, c: 1.0 }, "ellipsoid: b is NaN; a positive length"),
        (S::Torus { major: 1.0, minor: 1.0 }, "torus: minor is 1; a radius smaller than the major one"),
        (S::Cylinder { radius: 1.0, height: -1.0 }, "cylinder: height is -1"),
        (S::Cone { base_radius: 1.0, top_radius: 0.0, height: 1.0 }, "cone: top_radius is 0"),
        (S::Saddle { valley_radius: 1.0, ridge_radius: 1e10, size: 1.0 }, "saddle: ridge_radius is 10000000000"),
        (S::MonkeySaddle { scale: 1.0, size: f64::INFINITY }, "monkey_saddle: size is inf"),
        (
            S::Helicoid { inner_radius: 1.0, outer_radius: 1.0, pitch: 1.0, turns: 1.0 },
            "helicoid: inner_radius is 1; a radius of 0 or more, smaller than the outer one",
        ),
        (S::Helicoid { inner_radius: 0.0, outer_radius: 1.0, pitch: 1.0, turns: 1e3 }, "helicoid: turns is 1000"),
        (S::WavySheet { amplitude: 1.0, wavelength: 0.01, size: 1.0 }, "wavy_sheet: wavelength is 0.01"),
        (bent, "bezier_patch: control is NaN"),
        (S::BezierPatch { control: [[DVec3::X; 4]; 4] }, "bezier_patch: the sine between ∂u and ∂v is NaN"),
    ];
    for (surface, expected) in refused {
        let message = surface.validate().unwrap_err().to_string();
        assert!(message.starts_with(expected), "{message}");
        let tessellation = Tessellation { vertices: 100, pattern: Pattern::Jittered, seed: 0, uv_seam: false };
        assert_eq!(surface.tessellate(&tessellation).unwrap_err().to_string(), message);
    }
}

#[test]
fn tessellations_out_of_range_are_named() {
    let sphere = ParametricSurface::Sphere { radius: 1.0 };
    let refused = [
        (15, Pattern::Jittered, "tessellation: vertices is 15; a number from 16 to 4194304 is needed"),
        (u32::MAX, Pattern::Jittered, "tessellation: vertices is 4294967295; a number from 16 to 4194304 is needed"),
        (100, Pattern::LongThin { aspect: f64::NAN }, "tessellation: aspect is NaN; a ratio from 1 to 1000 is needed"),
        (100, Pattern::Regular { aspect: 0.5 }, "tessellation: aspect is 0.5; a ratio from 1 to 1000 is needed"),
    ];
    for (vertices, pattern, expected) in refused {
        let tessellation = Tessellation { vertices, pattern, seed: 0, uv_seam: false };
        assert_eq!(sphere.tessellate(&tessellation).unwrap_err().to_string(), expected);
    }
}
