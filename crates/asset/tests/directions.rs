//! The cells of a hemisphere: rings between their edges, azimuths around their middles, nothing in between.

use std::f64::consts::{PI, TAU};

use barchan_asset::{Azimuths, HemisphereDirections, ReliefRange, RingSpacing};

const SPACINGS: [RingSpacing; 2] = [RingSpacing::EqualAngles, RingSpacing::SquaredTangents];

fn directions(rings: u32, azimuths: Azimuths, spacing: RingSpacing, degrees: f64) -> HemisphereDirections {
    HemisphereDirections { rings, azimuths, spacing, max_polar_radians: degrees.to_radians() }
}

/// Grids from one cell to as many as a table holds, up to a hair below the right angle.
fn many_rings() -> impl Iterator<Item = HemisphereDirections> {
    let degrees = [1e-6, 10.0, 45.0, 60.0, 75.0, 80.0, 89.9, 90.0 - 1e-9];
    let of = move |rings, spacing| degrees.map(|max| directions(rings, Azimuths::full_circle(1), spacing, max));
    SPACINGS.into_iter().flat_map(move |spacing| [1, 2, 3, 7, 32, 2048].into_iter().flat_map(move |r| of(r, spacing)))
}

#[test]
fn edges_are_the_tangents_of_the_formula() {
    for directions in many_rings() {
        let max = directions.max_polar_radians;
        for ring in (0..=directions.rings).step_by(directions.rings.div_ceil(64) as usize) {
            let part = f64::from(ring) / f64::from(directions.rings);
            let expected = match directions.spacing {
                RingSpacing::EqualAngles => (part * max).tan(),
                RingSpacing::SquaredTangents => part * part * max.tan(),
            };
            let edge = directions.tangent_of_edge(ring);
            assert!((edge - expected).abs() <= 1e-14 * expected, "{directions:?} {ring}: {edge} for {expected}");
        }
        assert_eq!(directions.tangent_of_edge(0), 0.0);
    }
}

#[test]
fn a_ring_holds_its_lower_edge_but_not_its_upper_one() {
    for directions in many_rings() {
        for ring in 0..directions.rings {
            let (low, high) = (directions.tangent_of_edge(ring), directions.tangent_of_edge(ring + 1));
            assert!(low < high);
            for tangent in [low, low.next_up(), 0.5 * (low + high), high.next_down()] {
                assert_eq!(directions.ring_of_tangent(tangent), Some(ring), "{directions:?} {tangent}");
            }
        }
    }
}

#[test]
fn beyond_the_last_edge_and_for_what_is_no_tangent_there_is_no_ring() {
    for directions in many_rings() {
        let end = directions.tangent_of_edge(directions.rings);
        for tangent in [end, end.next_up(), f64::INFINITY, f64::NAN, -1e-300] {
            assert_eq!(directions.ring_of_tangent(tangent), None, "{directions:?} {tangent}");
        }
    }
}

/// How far two azimuths are apart, turns left out.
fn apart(a: f64, b: f64) -> f64 {
    let difference = (a - b).rem_euclid(TAU);
    difference.min(TAU - difference)
}

#[test]
fn azimuth_cells_cover_the_circle_and_the_nearest_middle_wins() {
    for count in [1, 2, 3, 16, 31] {
        let directions = directions(1, Azimuths::full_circle(count), RingSpacing::EqualAngles, 60.0);
        for azimuth in (-9000..9000).map(|i| f64::from(i) * 0.001) {
            let cell = directions.azimuth_cell(azimuth).unwrap();
            let off = apart(azimuth, directions.azimuths.radians(cell));
            assert!(off <= PI / f64::from(count) + 1e-12, "{count} {azimuth}: {off}");
        }
        for cell in 0..count {
            let (middle, half_step) = (directions.azimuths.radians(cell), 0.5 * directions.azimuths.step_radians());
            for azimuth in [middle - half_step + 1e-9, middle, middle + TAU, middle + half_step - 1e-9] {
                assert_eq!(directions.azimuth_cell(azimuth), Some(cell), "{count} {azimuth}");
            }
        }
    }
}

#[test]
fn an_arc_ends_half_a_step_beyond_its_ends() {
    for (first, last, count) in [(-0.5, 0.5, 2), (5.9, 7.7, 4), (-6.0, -0.1, 30), (0.0, 3.0, 7)] {
        let directions = directions(1, Azimuths::arc(first, last, count), RingSpacing::SquaredTangents, 60.0);
        let half_step = 0.5 * directions.azimuths.step_radians();
        let cell = |azimuth| directions.azimuth_cell(azimuth);
        for turn in [-TAU, 0.0, TAU] {
            assert_eq!([cell(first + turn), cell(last + turn)], [Some(0), Some(count - 1)]);
            assert_eq!(cell(first - half_step + 1e-9 + turn), Some(0));
            assert_eq!(cell(last + half_step - 1e-9 + turn), Some(count - 1));
            assert_eq!([cell(first - half_step - 1e-9 + turn), cell(last + half_step + 1e-9 + turn)], [None, None]);
        }
        let inside = (0..=1000).map(|i| first + (last - first) * f64::from(i) / 1000.0);
        for azimuth in inside {
            let off = apart(azimuth, directions.azimuths.radians(cell(azimuth).unwrap()));
            assert!(off <= half_step + 1e-12, "{azimuth}: {off}");
        }
    }
}

#[test]
fn of_an_arc_that_nearly_closes_the_nearer_end_wins() {
    let arc = Azimuths::arc(0.0, 6.0, 5);
    assert_eq!(arc.nearest(6.1), Some(4));
    assert_eq!(arc.nearest(6.2), Some(0));
}

#[test]
fn what_is_no_direction_has_no_cell() {
    let full = directions(4, Azimuths::full_circle(8), RingSpacing::EqualAngles, 60.0);
    for azimuth in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(full.azimuth_cell(azimuth), None);
    }
    let nothing = directions(0, Azimuths::full_circle(0), RingSpacing::EqualAngles, 60.0);
    assert_eq!((nothing.layers(), nothing.azimuth_cell(1.0), nothing.ring_of_tangent(0.0)), (0, None, None));
    let right_angle = directions(4, Azimuths::arc(0.0, 0.0, 1), RingSpacing::EqualAngles, 90.0);
    let _ = (right_angle.ring_of_tangent(1.0), right_angle.azimuth_cell(0.5), right_angle.tangent_of_edge(9));
}

#[test]
fn layers_count_azimuths_first() {
    let directions = directions(3, Azimuths::full_circle(5), RingSpacing::EqualAngles, 60.0);
    assert_eq!(directions.layers(), 15);
    let cells: Vec<_> = (0..15).map(|layer| directions.ring_and_azimuth(layer)).collect();
    assert_eq!((cells[0], cells[4], cells[5], cells[14]), ((0, 0), (0, 4), (1, 0), (2, 4)));
    assert!((0..).zip(cells).all(|(layer, (ring, azimuth))| directions.layer(ring, azimuth) == layer));
}

#[test]
fn depth_runs_from_the_top_down() {
    let relief = ReliefRange { top: 4.0, thickness: 5.0 };
    assert_eq!([relief.depth(4.0), relief.depth(1.5), relief.depth(-1.0)], [0.0, 0.5, 1.0]);
    assert_eq!([relief.height(0.0), relief.height(0.5), relief.height(1.0)], [4.0, 1.5, -1.0]);
    assert_eq!(ReliefRange { top: 4.0, thickness: 0.0 }.depth(4.0), 0.0);
}
