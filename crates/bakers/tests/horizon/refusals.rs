//! What is refused, in whose words, and what is reported meanwhile.

use std::sync::Mutex;

use barchan_bakers::Exec;
use barchan_bakers::horizon::{self, HorizonParams, reference};
use barchan_field::{Edge, HeightField};

use crate::support::{field, grid, params};

/// What both bakers say.
#[track_caller]
fn refusal(field: &HeightField, params: &HorizonParams) -> String {
    let exec = Exec::new(1).unwrap();
    let said = horizon::bake(field, params, &exec).unwrap_err().to_string();
    assert_eq!(reference::bake(field, params, &exec).unwrap_err().to_string(), said);
    said
}

#[test]
fn a_count_of_directions_out_of_range() {
    let field = field((2, 2), Edge::Wrap, |_, _| 0.0);
    assert_eq!(refusal(&field, &params(0, 1.0)), "directions is 0; 1 to 2048 azimuths are accepted");
    assert_eq!(refusal(&field, &params(2049, 1.0)), "directions is 2049; 1 to 2048 azimuths are accepted");
    assert!(params(2048, 1.0).check(&field).is_ok());
}

#[test]
fn a_radius_out_of_range() {
    let field = crate::support::fill(grid((2, 2), (0.5, 4.0), Edge::Wrap), |_, _| 0.0);
    for (radius, said) in [
        (0.0, "radius is 0; a positive length of at most 131072 texels is accepted"),
        (-2.5, "radius is -2.5; a positive length of at most 131072 texels is accepted"),
        (f64::NAN, "radius is NaN; a positive length of at most 131072 texels is accepted"),
        (f64::INFINITY, "radius is inf; a positive length of at most 131072 texels is accepted"),
        // The finer axis counts.
        (65536.5, "radius is 65536.5; a positive length of at most 131072 texels is accepted"),
    ] {
        assert_eq!(refusal(&field, &params(4, radius)), said);
    }
    assert!(params(4, 65536.0).check(&field).is_ok());
}

#[test]
fn a_field_of_one_texel() {
    let field = field((1, 1), Edge::Clamp, |_, _| 3.0);
    let said = "the height map is 1 × 1 texels; a horizon needs at least 2 texels";
    assert_eq!(refusal(&field, &params(4, 1.0)), said);
}

#[test]
fn a_map_that_would_not_fit_in_memory() {
    let field = field((1 << 22, 1), Edge::Clamp, |_, _| 0.0);
    assert!(params(2048, 1.0).check(&field).is_ok());
    let field = crate::support::field(((1 << 22) + 1, 1), Edge::Clamp, |_, _| 0.0);
    let said = "the horizon map needs 68719493120 bytes; at most 68719476736 are allowed";
    assert_eq!(refusal(&field, &params(2048, 1.0)), said);
}

#[test]
fn every_finished_direction_is_reported_once() {
    let field = field((6, 5), Edge::Wrap, |column, row| (column * row) as f32);
    for threads in [1, 3] {
        let reports = Mutex::new(Vec::new());
        let report = |done, total| reports.lock().unwrap().push((done, total));
        let exec = Exec::new(threads).unwrap().with_progress(&report);
        assert_eq!(exec.threads(), threads);
        horizon::bake(&field, &params(11, 4.0), &exec).unwrap();
        let mut reports = reports.into_inner().unwrap();
        reports.sort_unstable();
        assert_eq!(reports, (1..=11).map(|done| (done, 11)).collect::<Vec<_>>());
    }
}

#[test]
fn no_distance_is_kept_unless_asked_for() {
    let field = field((6, 5), Edge::Wrap, |column, row| (column * row) as f32);
    let exec = Exec::new(1).unwrap();
    let with = horizon::bake(&field, &params(5, 4.0), &exec).unwrap();
    let without = horizon::bake(&field, &HorizonParams { distance: false, ..with.params }, &exec).unwrap();
    assert_eq!(without.distance, None);
    assert_eq!(without.elevation_radians, with.elevation_radians);
}
