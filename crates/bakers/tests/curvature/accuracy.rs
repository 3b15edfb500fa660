//! On closed forms, in random triangles.

use barchan_field::surfaces::{ParametricSurface, Pattern};

use crate::support::Case;

const PATTERNS: [Pattern; 2] = [Pattern::Jittered, Pattern::Random];

#[test]
fn every_surface_at_4000_vertices() {
    for surface in ParametricSurface::examples() {
        // Two waves on 63 vertices: a neighbourhood is a quarter of a wave across, and at the border half of one.
        let (most, most_turned) = if surface.name() == "wavy_sheet" { (2.5e-3, 0.5) } else { (8e-4, 0.05) };
        for pattern in PATTERNS {
            let errors = Case::of(&surface, pattern, 4000).clean();
            println!("A4000 {} {pattern:?} {errors:?}", surface.name());
            assert!(errors.rms <= most, "{} {pattern:?}: {errors:?}", surface.name());
            assert!(errors.directions_rms <= most_turned, "{} {pattern:?}: {errors:?}", surface.name());
        }
    }
}

#[test]
fn errors_fall_with_the_third_power_of_an_edge() {
    for surface in ParametricSurface::examples() {
        for pattern in PATTERNS {
            let [coarse, fine] = [1000, 16_000].map(|vertices| Case::of(&surface, pattern, vertices).clean().rms);
            // A quarter of the edge.
            let order = (coarse / fine).log2() / 2.0;
            println!("ORDER {} {pattern:?} {coarse:.2e} {fine:.2e} {order:.2}", surface.name());
            assert!(order >= 3.0 || fine <= 1e-7, "{} {pattern:?}: {coarse}, {fine}: {order}", surface.name());
        }
    }
}

#[test]
fn long_thin_triangles() {
    for surface in ParametricSurface::examples() {
        let errors = Case::of(&surface, Pattern::LongThin { aspect: 20.0 }, 4000).clean();
        println!("THIN {} {errors:?}", surface.name());
        assert!(errors.rms <= 0.05, "{}: {errors:?}", surface.name());
    }
}
