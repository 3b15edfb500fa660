//! What is refused, and in whose words.

use std::sync::Mutex;

use barchan_asset::{Azimuths, DepthMode, HemisphereDirections};
use barchan_bakers::Exec;
use barchan_bakers::hemisphere::{self, HemisphereBaker, HemisphereParams};
use barchan_field::Edge;

use crate::support::{directions, field, whole};

/// What both roads say to a table of a field of 4 by 3 texels.
#[track_caller]
fn refusal(params: HemisphereParams) -> String {
    let (field, exec) = (field((4, 3), Edge::Wrap, |column, row| (column * row) as f32), Exec::new(1).unwrap());
    let said = hemisphere::bake(&field, &params, &exec).unwrap_err().to_string();
    let Err(error) = HemisphereBaker::new(&field, params, &exec) else {
        panic!("one road takes what the other refuses")
    };
    assert_eq!(error.to_string(), said);
    said
}

#[track_caller]
fn refused_directions(directions: HemisphereDirections) -> String {
    refusal(HemisphereParams { directions, width: 2, height: 2, mode: DepthMode::Nearest })
}

#[track_caller]
fn refused_size((width, height): (u32, u32)) -> String {
    refusal(HemisphereParams { directions: directions(2, 4, 80.0), width, height, mode: DepthMode::Conservative })
}

#[test]
fn rings_that_reach_the_horizontal_or_nowhere() {
    let accepted = "more than 0° and less than 90° from the normal are accepted";
    for (degrees, value) in [(90.0, "90"), (135.0, "135"), (0.0, "0"), (-5.0, "-5"), (f64::NAN, "NaN")] {
        let said = refused_directions(directions(2, 4, degrees));
        assert_eq!(said, format!("max_polar is {value}°; {accepted}"));
    }
}

#[test]
fn no_directions_or_too_many() {
    assert_eq!(refused_directions(directions(0, 4, 80.0)), "rings is 0; 1 or more are accepted");
    assert_eq!(
        refused_directions(directions(2, 0, 80.0)),
        "azimuths is 0; 1 or more around the circle, or 2 or more in an arc, are accepted"
    );
    assert_eq!(
        refused_directions(directions(32, 65, 80.0)),
        "rings × azimuths is 32 × 65; at most 2048 directions are accepted"
    );
    // Their product does not fit 32 bits.
    assert_eq!(
        refused_directions(directions(65536, 65536, 80.0)),
        "rings × azimuths is 65536 × 65536; at most 2048 directions are accepted"
    );
}

#[test]
fn an_arc_without_length_or_beyond_a_turn() {
    let arc = |azimuths| refused_directions(HemisphereDirections { azimuths, ..directions(2, 4, 80.0) });
    assert_eq!(
        arc(Azimuths::arc(1.0, 1.0, 1)),
        "azimuths is 1; 2 or more are accepted in an arc, which bakes both its ends"
    );
    assert_eq!(
        arc(Azimuths::arc(0.0, 360_f64.to_radians(), 3)),
        "arc is 0 to 360; degrees from within ±360 to a larger number, less than 360 beyond, are accepted"
    );
    assert_eq!(
        arc(Azimuths::arc(90_f64.to_radians(), 45_f64.to_radians(), 2)),
        "arc is 90 to 45; degrees from within ±360 to a larger number, less than 360 beyond, are accepted"
    );
}

#[test]
fn a_table_without_texels_or_with_more_than_the_field() {
    let accepted = "at least 1 texel along each side is accepted";
    assert_eq!(refused_size((0, 2)), format!("size is 0 × 2; {accepted}"));
    assert_eq!(refused_size((2, 0)), format!("size is 2 × 0; {accepted}"));
    let accepted = "no more texels along a side than the height map has are accepted";
    assert_eq!(refused_size((5, 3)), format!("size is 5 × 3 for a height map of 4 × 3; {accepted}"));
    assert_eq!(refused_size((4, 4)), format!("size is 4 × 4 for a height map of 4 × 3; {accepted}"));
}

#[test]
fn a_table_that_would_not_fit_in_memory() {
    let field = field((1 << 20, 9), Edge::Clamp, |_, _| 0.0);
    let params = whole(&field, directions(32, 64, 80.0));
    let said = hemisphere::bake(&field, &params, &Exec::new(1).unwrap()).unwrap_err().to_string();
    assert_eq!(said, "the hemisphere map needs 77309411328 bytes; at most 68719476736 are allowed");
}

#[test]
fn the_least_that_is_accepted_is_baked() {
    let field = field((4, 3), Edge::Wrap, |column, row| (column * row) as f32);
    let params = HemisphereParams { width: 1, height: 1, ..whole(&field, directions(1, 1, 1.0)) };
    let map = hemisphere::bake(&field, &params, &Exec::new(1).unwrap()).unwrap();
    // The only ray is vertical, and one of the texels is the highest.
    assert_eq!(map.depths, [0.0]);
}

#[test]
fn every_finished_layer_is_reported_once() {
    let field = field((6, 5), Edge::Wrap, |column, row| (column * row) as f32);
    let reports = Mutex::new(Vec::new());
    let report = |done, total| reports.lock().unwrap().push((done, total));
    let exec = Exec::new(2).unwrap().with_progress(&report);
    hemisphere::bake(&field, &whole(&field, directions(3, 4, 70.0)), &exec).unwrap();
    let mut reports = reports.into_inner().unwrap();
    reports.sort_unstable();
    assert_eq!(reports, (1..=12).map(|done| (done, 12)).collect::<Vec<_>>());
}
