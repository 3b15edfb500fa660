//! The weights of the hemisphere against closed forms.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use barchan_asset::{Azimuths, HemisphereDirections, RingSpacing};
use barchan_shade::HemisphereQuadrature;
use glam::DVec3;

use crate::support::assert_near;

fn directions(spacing: RingSpacing) -> HemisphereDirections {
    HemisphereDirections {
        rings: 32,
        azimuths: Azimuths::full_circle(16),
        spacing,
        max_polar_radians: 80_f64.to_radians(),
    }
}

fn quadratures() -> [HemisphereQuadrature; 5] {
    let [squared, equal] = [RingSpacing::SquaredTangents, RingSpacing::EqualAngles].map(directions);
    [
        HemisphereQuadrature::even(7, 9),
        HemisphereQuadrature::of_cells(&squared),
        HemisphereQuadrature::of_rays(&squared),
        HemisphereQuadrature::of_cells(&equal),
        HemisphereQuadrature::of_rays(&equal),
    ]
}

#[test]
fn the_weights_of_a_level_normal_are_those_of_the_whole_hemisphere() {
    for quadrature in quadratures() {
        let sum: DVec3 = quadrature.cells().iter().map(|cell| cell.integral).sum();
        assert!((sum - DVec3::Z * PI).length() < 1e-12, "{sum}");
    }
}

#[test]
fn a_ring_weighs_what_its_band_of_the_sphere_does() {
    let (quadrature, directions) =
        (HemisphereQuadrature::of_cells(&directions(RingSpacing::EqualAngles)), directions(RingSpacing::EqualAngles));
    for ring in 0..31 {
        let band = |edge: u32| (f64::from(edge) / 32.0 * directions.max_polar_radians).sin().powi(2);
        let cell = quadrature.cells()[directions.layer(ring, 3) as usize];
        assert_near(cell.integral.z, 0.5 * TAU / 16.0 * (band(ring + 1) - band(ring)), 1e-14);
    }
}

#[test]
fn all_occluded_is_one_and_nothing_occluded_is_nothing_for_any_normal() {
    for quadrature in quadratures() {
        for normal in [DVec3::Z, DVec3::new(0.6, 0.0, 0.8), DVec3::new(-0.5, 0.7, 0.2).normalize(), DVec3::Y] {
            assert_eq!(quadrature.occlusion(normal, |_, _| true), 1.0);
            assert_eq!(quadrature.occlusion(normal, |_, _| false), 0.0);
        }
    }
}

/// A wedge: all that is on one side of a vertical plane through the point.
#[test]
fn half_the_sky_is_half_the_light_of_a_level_normal_and_more_of_one_that_leans_to_it() {
    let quadrature = HemisphereQuadrature::even(64, 64);
    let behind = |normal: DVec3| quadrature.occlusion(normal, |_, cell| cell.towards.x > 0.0);
    // 64 azimuths put a column of cells on the plane itself.
    assert_near(behind(DVec3::Z), 0.5, 0.5 / 64.0);
    // Of the sky above an incline of t, π (1 + cos t) / 2 in all; the half that it leans to has (π / 2) cos t + sin t · π / 2 … of it.
    let tilt = 30_f64.to_radians();
    let leaning = 0.5 * PI * tilt.cos() + 0.5 * PI * tilt.sin();
    let all = PI * (1.0 + tilt.cos()) / 2.0;
    assert_near(behind(DVec3::new(tilt.sin(), 0.0, tilt.cos())), leaning / all, 0.02);
}

#[test]
fn the_light_above_an_incline_is_that_of_a_hemisphere_less_its_wedge() {
    let quadrature = HemisphereQuadrature::even(128, 256);
    for tilt in [0.0, 20.0, 45.0, 70.0_f64].map(f64::to_radians) {
        let normal = DVec3::new(tilt.sin(), 0.0, tilt.cos());
        let sum: f64 = quadrature.cells().iter().map(|cell| normal.dot(cell.integral).max(0.0)).sum();
        assert_near(sum, PI * (1.0 + tilt.cos()) / 2.0, 1e-3);
    }
}

#[test]
fn below_the_grid_the_outermost_ring_speaks() {
    let directions = directions(RingSpacing::SquaredTangents);
    let quadrature = HemisphereQuadrature::of_cells(&directions);
    let outermost = directions.layer(31, 0) as usize;
    let share = quadrature.occlusion(DVec3::Z, |index, _| index >= outermost);
    let inner = directions.tangent_of_edge(31).atan();
    assert_near(share, FRAC_PI_2.sin().powi(2) - inner.sin().powi(2), 1e-12);
}
