//! The preview.

use barchan_bakers::curvature::CurvatureMethod;
use barchan_field::surfaces::{ParametricSurface, Pattern};

use crate::support::{Case, bake_with};

#[test]
fn the_preview_is_within_its_bounds() {
    for surface in ParametricSurface::examples() {
        for pattern in [Pattern::Jittered, Pattern::Random] {
            let case = Case::of(&surface, pattern, 4000);
            let errors = case.errors(&bake_with(&case.mesh, CurvatureMethod::Fast, 1));
            println!("FAST {} {pattern:?} {errors:?}", surface.name());
            assert!(errors.rms <= 0.03, "{} {pattern:?}: {errors:?}", surface.name());
        }
    }
}
