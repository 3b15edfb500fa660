//! The same samples through Householder's reflections.

use fearless_simd::{Level, dispatch};

use super::super::reference::{least_squares, monomials};
use super::*;

const NEIGHBOURS: usize = 60;

/// From −1 to 1, the same every time.
fn scattered(index: usize, salt: usize) -> f64 {
    let step = (index * 7919 + salt * 104_729 + 1) as f64;
    2.0 * (step * 0.618_033_988_749_894_9).fract() - 1.0
}

/// Neighbours all over the unit disc, on a surface that no polynomial is; another one in every lane.
fn samples() -> Samples {
    let mut samples = Samples::default();
    samples.reset(NEIGHBOURS);
    for lane in 0..LANES {
        let points = (0..10_000).map(|index| [scattered(index, lane), scattered(index * index + 3, lane + 11)]);
        let inside = points.filter(|[x, y]| x * x + y * y <= 1.0);
        for (index, [x, y]) in inside.take(NEIGHBOURS).enumerate() {
            samples.x[index][lane] = x;
            samples.y[index][lane] = y;
            samples.z[index][lane] = libm::sin(1.3 * x + lane as f64) * libm::cos(0.9 * y) + 0.2 * x * y;
            samples.weight[index][lane] = 1.0 - 0.6 * (x * x + y * y);
        }
    }
    samples
}

fn by_reflections(samples: &Samples, lane: usize, degree: usize) -> Vec<f64> {
    // The point itself comes first.
    let mut rows = vec![monomials(degree, 0.0, 0.0).collect()];
    let mut heights = vec![0.0];
    for index in 0..NEIGHBOURS {
        let of_lane = |values: &[[f64; LANES]]| values[index][lane];
        let root = of_lane(&samples.weight).sqrt();
        rows.push(monomials(degree, of_lane(&samples.x), of_lane(&samples.y)).map(|m| root * m).collect());
        heights.push(root * of_lane(&samples.z));
    }
    least_squares(rows, heights).expect("points in general position")
}

#[test]
fn every_degree_is_that_of_householders_reflections() {
    let samples = samples();
    let fits = dispatch!(Level::new(), simd => Solver::new(simd).fit::<MAX_DEGREE>(simd, &samples));
    for (lane, fit) in fits.iter().enumerate() {
        assert_eq!(fit.degrees, MAX_DEGREE);
        for degree in 2..=MAX_DEGREE {
            let expected = by_reflections(&samples, lane, degree);
            for (found, expected) in fit.jet(degree).coefficients.iter().zip(&expected[1..]) {
                assert!((found - expected).abs() < 1e-8, "lane {lane}, degree {degree}: {found}, not {expected}");
            }
        }
    }
}

#[test]
fn the_variance_is_what_unit_noise_of_heights_does() {
    let samples = samples();
    let fits = dispatch!(Level::new(), simd => Solver::new(simd).fit::<4>(simd, &samples));
    // Each height by itself moves the coefficient by its row of the pseudo-inverse; weighted, noise of one height is 1 / its weight.
    let mut variance = 0.0;
    for index in 0..NEIGHBOURS {
        let mut pushed = samples.clone();
        pushed.z[index][0] += 1.0;
        let moved = by_reflections(&pushed, 0, 4)[3] - by_reflections(&samples, 0, 4)[3];
        variance += moved * moved / samples.weight[index][0];
    }
    let mut pushed = samples.clone();
    for index in 0..NEIGHBOURS {
        pushed.z[index][0] -= 1.0;
    }
    // A push of the point itself is one of all others the other way, but for the constant.
    let moved = by_reflections(&pushed, 0, 4)[3] - by_reflections(&samples, 0, 4)[3];
    variance += moved * moved;
    let found = fits[0].jet(4).variances[0];
    assert!((found / variance - 1.0).abs() < 1e-8, "{found}, not {variance}");
}

#[test]
fn too_few_neighbours_end_the_usable_degrees() {
    let mut samples = samples();
    for weight in &mut samples.weight[14..] {
        *weight = [0.0; LANES];
    }
    // Fifteen points with the point itself: as many as a quartic has coefficients.
    let fits = dispatch!(Level::new(), simd => Solver::new(simd).fit::<MAX_DEGREE>(simd, &samples));
    for fit in fits {
        assert_eq!(fit.degrees, 4);
    }
}
