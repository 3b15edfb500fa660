//! Forms of surfaces in closed form.

use glam::DVec2;

use super::support::*;

/// RMS and largest error of the first form, then of the second.
fn errors(surface: fn(f64, f64) -> Jet, quads: u32) -> [f64; 4] {
    let case = Case::of(surface, quads);
    let [mut first_squares, mut first_largest, mut second_squares, mut second_largest] = [0.0_f64; 4];
    for (jet, found) in case.jets.iter().zip(case.forms()) {
        let [first, second] = [difference(found.first, jet.first()), difference(found.second, jet.second())];
        first_squares += first * first;
        second_squares += second * second;
        first_largest = first_largest.max(first);
        second_largest = second_largest.max(second);
        assert_eq!(found.flags, barchan_asset::VertexFlags::NONE);
    }
    let rms = |squares: f64| (squares / case.jets.len() as f64).sqrt();
    [rms(first_squares), first_largest, rms(second_squares), second_largest]
}

#[test]
fn errors_fall_with_the_square_of_the_edges_up_to_the_border() {
    for surface in [cylinder, sphere, patch] {
        let [coarse, fine] = [16, 64].map(|quads| errors(surface, quads));
        for (index, (coarse, fine)) in coarse.into_iter().zip(fine).enumerate() {
            // Four times as fine: sixteen times as small. The largest error is that of an odd vertex on the border.
            let (gain, most) = if index % 2 == 0 { (12.0, 3e-4) } else { (4.0, 2e-3) };
            assert!(fine < coarse / gain && fine < most, "{index}: {coarse:.2e} {fine:.2e}");
        }
    }
}

#[test]
fn a_sheared_chart_of_a_plane_is_exact() {
    let plane = |u: f64, v: f64| Jet {
        point: glam::DVec3::new(3.0 * u + 2.0 * v, 0.5 * v, 0.0),
        du: glam::DVec3::X * 3.0,
        dv: glam::DVec3::new(2.0, 0.5, 0.0),
        duu: glam::DVec3::ZERO,
        duv: glam::DVec3::ZERO,
        dvv: glam::DVec3::ZERO,
    };
    for found in Case::of(plane, 8).forms() {
        assert!(difference(found.first, [9.0, 6.0, 4.25]) < 1e-12, "{:?}", found.first);
        assert_eq!(found.second.map(f64::abs), [0.0; 3]);
    }
}

#[test]
fn curvature_along_any_direction_of_the_chart_is_eulers() {
    // SEEDS 000, erratum of eq 1: form (a), by the images of the principal directions, is form (b), by the fundamental forms.
    for surface in [cylinder, sphere, patch] {
        let case = Case::of(surface, 12);
        for (vertex, found) in case.curvature.vertices.iter().zip(case.forms()) {
            let ([e, f, g], [first_e, first_f, first_g]) = (found.second, found.first);
            let images = glam::DMat2::from_cols(found.uv_directions[0], found.uv_directions[1]);
            for step in 0..16 {
                let DVec2 { x: du, y: dv } = DVec2::from_angle(f64::from(step) * 0.4);
                let by_forms = (e * du * du + 2.0 * f * du * dv + g * dv * dv)
                    / (first_e * du * du + 2.0 * first_f * du * dv + first_g * dv * dv);
                let DVec2 { x: a, y: b } = images.inverse() * DVec2::new(du, dv);
                let [k1, k2] = vertex.principal;
                let euler = (k1 * a * a + k2 * b * b) / (a * a + b * b);
                assert!((by_forms - euler).abs() < 1e-11 * (k1.abs() + k2.abs()), "{by_forms} {euler}");
            }
        }
    }
}

#[test]
fn images_of_principal_directions_are_walked_by_unit_steps() {
    let case = Case::of(patch, 64);
    for ((jet, vertex), found) in case.jets.iter().zip(&case.curvature.vertices).zip(case.forms()) {
        for (direction, image) in vertex.directions.into_iter().zip(found.uv_directions) {
            assert!((jet.du * image.x + jet.dv * image.y).distance(direction) < 2e-3);
        }
    }
}

#[test]
fn the_sign_of_directions_means_nothing() {
    let case = Case::of(patch, 8);
    let mut other = Case::of(patch, 8);
    for vertex in &mut other.curvature.vertices {
        vertex.directions[1] = -vertex.directions[1];
    }
    for (a, b) in case.forms().into_iter().zip(other.forms()) {
        assert_eq!(a.flags, b.flags);
        assert!(difference(a.first, b.first) < 1e-12 && difference(a.second, b.second) < 1e-12);
    }
}
