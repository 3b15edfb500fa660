//! What is refused, and in whose words.

use barchan_bakers::swept::{CurvatureRange, Points, SweptParams, Tie};
use barchan_field::Edge;

use crate::support::grid;

fn refusal(min: f64, max: f64, points: Points) -> String {
    let params = SweptParams { range: CurvatureRange { min, max }, points };
    params.check(&grid((64, 64), Edge::Wrap), 64.0).map_or_else(|error| error.to_string(), |()| "accepted".to_owned())
}

#[test]
fn a_range_that_is_none() {
    let order = "two finite numbers, the smaller first, are accepted";
    for (min, max) in [(0.1, -0.1), (f64::NAN, 0.0), (0.0, f64::INFINITY)] {
        assert_eq!(refusal(min, max, Points::Count(2)), format!("curvature is {min} to {max}; {order}"));
    }
    assert_eq!(refusal(-0.04, 0.04, Points::Count(2)), "accepted");
    assert_eq!(refusal(0.0, 0.0, Points::Count(1)), "accepted");
}

#[test]
fn circles_smaller_than_a_texel_and_hollows_searched_beyond_overhead() {
    assert!(refusal(0.0, 1.001, Points::Count(2)).contains("at least one texel"));
    assert!(refusal(-0.05, 0.0, Points::Count(2)).contains("1/π of the search radius"));
    assert_eq!(refusal(-0.049, 1.0, Points::Count(2)), "accepted");
}

#[test]
fn points_out_of_range() {
    for (points, said) in [
        (Points::Count(0), "points is 0; 1 to 8 points are accepted"),
        (Points::Count(9), "points is 9; 1 to 8 points are accepted"),
        (Points::MaxErrorDegrees(0.0), "max_error is 0; a positive number of degrees is accepted"),
        (Points::MaxErrorDegrees(f64::NAN), "max_error is NaN; a positive number of degrees is accepted"),
    ] {
        assert_eq!(refusal(0.0, 0.01, points), said);
    }
    assert_eq!(refusal(0.0, 0.01, Points::MaxErrorDegrees(0.25)), "accepted");
}

#[test]
fn ties_go_with_the_stronger_side() {
    let tie = |min, max| CurvatureRange { min, max }.tie();
    assert_eq!([tie(0.0, 0.01), tie(-0.01, 0.01), tie(0.0, 0.0)], [Tie::Nearest; 3]);
    assert_eq!([tie(-0.01, 0.0), tie(-0.01, 0.005)], [Tie::Farthest; 2]);
}
