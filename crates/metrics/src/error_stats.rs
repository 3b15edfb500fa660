//! Norms, extremes and percentiles of differences.
//!
//! # Not a number
//!
//! A pair of NaNs agrees: its difference is 0. A NaN on one side only is an infinite error, so that it can never hide
//! in a mean. Equal infinities agree; an infinity against anything else is an infinite error. A NaN *difference* given
//! to [`ErrorStats::add`] counts as an infinite error as well.

use crate::sum::Sum;

/// Running statistics of differences, `b − a`.
///
/// Sums are compensated f64 sums in the order of [`ErrorStats::add`] and [`ErrorStats::merge`]; the same order gives the
/// same bits.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct ErrorStats {
    count: u64,
    squares: Sum,
    absolutes: Sum,
    signed: Sum,
    max: f64,
    worst: Option<u64>,
}

impl ErrorStats {
    /// Statistics of `b − a`, element by element, in f64.
    ///
    /// # Panics
    ///
    /// When the slices differ in length: the caller compares things that do not belong together.
    #[must_use]
    pub fn between(a: &[f32], b: &[f32]) -> Self {
        assert_eq!(a.len(), b.len(), "error between slices of different lengths");
        Self::of(a.iter().zip(b).map(|(&a, &b)| difference(f64::from(a), f64::from(b))))
    }

    /// Statistics of differences, in their order.
    #[must_use]
    pub fn of(differences: impl IntoIterator<Item = f64>) -> Self {
        let mut stats = Self::default();
        for difference in differences {
            stats.add(difference);
        }
        stats
    }

    /// Counts one more difference; a NaN is an infinite error.
    pub fn add(&mut self, difference: f64) {
        let difference = if difference.is_nan() { f64::INFINITY } else { difference };
        let size = difference.abs();
        if self.worst.is_none() || size > self.max {
            (self.max, self.worst) = (size, Some(self.count));
        }
        self.squares.add(difference * difference);
        self.absolutes.add(size);
        // An infinite error has no direction, and +∞ − ∞ would be NaN.
        self.signed.add(if size.is_finite() { difference } else { size });
        self.count += 1;
    }

    /// Appends statistics of the elements that follow. Merging parts in index order gives the same bits every time for the
    /// same parts; other parts may differ in the last one.
    pub fn merge(&mut self, next: &Self) {
        if let Some(worst) = next.worst
            && (self.worst.is_none() || next.max > self.max)
        {
            (self.max, self.worst) = (next.max, Some(self.count + worst));
        }
        self.squares.merge(next.squares);
        self.absolutes.merge(next.absolutes);
        self.signed.merge(next.signed);
        self.count += next.count;
    }

    /// Differences counted.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.count
    }

    /// Root mean square of the differences; 0 for none.
    #[must_use]
    pub fn rms(&self) -> f64 {
        self.mean_of(self.squares).sqrt()
    }

    /// Mean size of the differences; 0 for none.
    #[must_use]
    pub fn mean_absolute(&self) -> f64 {
        self.mean_of(self.absolutes)
    }

    /// Mean of the differences with their signs, the bias; 0 for none, infinite if any difference is.
    #[must_use]
    pub fn mean(&self) -> f64 {
        self.mean_of(self.signed)
    }

    /// The largest size of a difference; 0 for none.
    #[must_use]
    pub fn max(&self) -> f64 {
        self.max
    }

    /// The index of the first difference of that size; `None` if nothing was counted.
    #[must_use]
    pub fn worst(&self) -> Option<u64> {
        self.worst
    }

    fn mean_of(&self, sum: Sum) -> f64 {
        if self.count == 0 { 0.0 } else { sum.value() / self.count as f64 }
    }
}

/// `b − a`, where two NaNs or two equal infinities agree and a NaN on one side is infinitely wrong.
fn difference(a: f64, b: f64) -> f64 {
    if a == b || (a.is_nan() && b.is_nan()) {
        0.0
    } else if a.is_nan() || b.is_nan() {
        f64::INFINITY
    } else {
        b - a
    }
}

/// Two values that differ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Difference {
    /// Where.
    pub index: usize,
    /// The value in the first slice.
    pub a: f32,
    /// The value in the second slice.
    pub b: f32,
}

/// The first index where `a` and `b` differ by more than `tolerance`, if any. A tolerance of 0 asks for equal numbers;
/// +0 and −0 are equal.
///
/// # Panics
///
/// When the slices differ in length.
#[must_use]
pub fn first_difference(a: &[f32], b: &[f32], tolerance: f64) -> Option<Difference> {
    assert_eq!(a.len(), b.len(), "difference between slices of different lengths");
    let beyond = |(&a, &b): (&f32, &f32)| difference(f64::from(a), f64::from(b)).abs() > tolerance;
    let index = a.iter().zip(b).position(beyond)?;
    Some(Difference { index, a: a[index], b: b[index] })
}

/// Exact percentiles of the sizes of differences.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Percentiles {
    /// Half the differences are no larger.
    pub p50: f64,
    /// 95 % are no larger.
    pub p95: f64,
    /// 99 % are no larger.
    pub p99: f64,
}

impl Percentiles {
    /// Percentiles of `b − a`, element by element.
    ///
    /// # Panics
    ///
    /// When the slices differ in length.
    #[must_use]
    pub fn between(a: &[f32], b: &[f32]) -> Self {
        assert_eq!(a.len(), b.len(), "percentiles between slices of different lengths");
        Self::of(a.iter().zip(b).map(|(&a, &b)| difference(f64::from(a), f64::from(b))))
    }

    /// Nearest-rank percentiles of the sizes: the smallest size that at least that part of the differences does not
    /// exceed, so always one of them. A NaN counts as infinite; no differences give 0.
    #[must_use]
    pub fn of(differences: impl IntoIterator<Item = f64>) -> Self {
        let size = |d: f64| if d.is_nan() { f64::INFINITY } else { d.abs() };
        let mut sizes: Vec<f64> = differences.into_iter().map(size).collect();
        sizes.sort_unstable_by(f64::total_cmp);
        Self { p50: rank(&sizes, 50), p95: rank(&sizes, 95), p99: rank(&sizes, 99) }
    }
}

/// The nearest-rank percentile of sorted sizes.
fn rank(sorted: &[f64], percent: usize) -> f64 {
    let at = (sorted.len() * percent).div_ceil(100);
    if at == 0 { 0.0 } else { sorted[at - 1] }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_differences_have_known_norms() {
        let stats = ErrorStats::between(&[1.0, 2.0, 3.0, 4.0], &[1.0, 5.0, 3.0, 0.0]);
        assert_eq!((stats.count(), stats.rms(), stats.mean_absolute(), stats.mean()), (4, 2.5, 1.75, -0.25));
        assert_eq!((stats.max(), stats.worst()), (4.0, Some(3)));
    }

    #[test]
    fn nothing_compared_is_no_error_and_nowhere() {
        let stats = ErrorStats::between(&[], &[]);
        assert_eq!((stats.count(), stats.rms(), stats.max(), stats.worst()), (0, 0.0, 0.0, None));
        assert_eq!(Percentiles::between(&[], &[]), Percentiles::default());
    }

    #[test]
    fn equal_fields_are_exactly_equal() {
        let stats = ErrorStats::between(&[f32::MAX, -0.0, f32::INFINITY], &[f32::MAX, 0.0, f32::INFINITY]);
        assert_eq!((stats.rms(), stats.max(), stats.worst()), (0.0, 0.0, Some(0)));
    }

    #[test]
    fn a_nan_on_one_side_is_infinitely_wrong_and_on_both_sides_right() {
        let nan = f32::NAN;
        let stats = ErrorStats::between(&[1.0, nan, nan], &[2.0, nan, 0.0]);
        assert_eq!(
            (stats.max(), stats.rms(), stats.mean(), stats.worst()),
            (f64::INFINITY, f64::INFINITY, f64::INFINITY, Some(2))
        );
        assert_eq!(ErrorStats::between(&[nan], &[nan]).max(), 0.0);
        assert_eq!(ErrorStats::of([f64::NAN]).max(), f64::INFINITY);
        assert_eq!(ErrorStats::of([f64::NEG_INFINITY, f64::INFINITY]).mean(), f64::INFINITY);
        assert_eq!(Percentiles::of([f64::NAN, 1.0]).p99, f64::INFINITY);
        assert_eq!(first_difference(&[nan, nan], &[nan, 1.0], 1e30).map(|d| d.index), Some(1));
    }

    #[test]
    fn the_first_of_equally_bad_places_is_the_worst() {
        assert_eq!(ErrorStats::of([0.0, -2.0, 2.0]).worst(), Some(1));
        let mut stats = ErrorStats::of([0.5, -2.0]);
        stats.merge(&ErrorStats::of([2.0]));
        assert_eq!(stats.worst(), Some(1));
    }

    #[test]
    fn merged_parts_are_the_whole() {
        let differences: Vec<f64> = (0..1000).map(|k| f64::from((k * 7919) % 1009) * 1e-3 - 0.4).collect();
        let whole = ErrorStats::of(differences.iter().copied());
        for cut in [0, 1, 400, 999, 1000] {
            let mut parts = ErrorStats::of(differences[..cut].iter().copied());
            parts.merge(&ErrorStats::of(differences[cut..].iter().copied()));
            assert_eq!((parts.count(), parts.max(), parts.worst()), (whole.count(), whole.max(), whole.worst()));
            assert!((parts.rms() - whole.rms()).abs() < 1e-15 && (parts.mean() - whole.mean()).abs() < 1e-15);
        }
    }

    #[test]
    fn a_million_small_errors_do_not_drift() {
        let stats = ErrorStats::of((0..1_000_000).map(|_| 0.1));
        assert_eq!((stats.mean_absolute(), stats.mean()), (0.1, 0.1));
        assert!((stats.rms() - 0.1).abs() < 1e-16);
    }

    #[test]
    fn percentiles_are_members_by_nearest_rank() {
        let found = Percentiles::of((1..=100).rev().map(|k| -f64::from(k)));
        assert_eq!(found, Percentiles { p50: 50.0, p95: 95.0, p99: 99.0 });
        assert_eq!(Percentiles::of([3.0]), Percentiles { p50: 3.0, p95: 3.0, p99: 3.0 });
        assert_eq!(Percentiles::of([2.0, 1.0]), Percentiles { p50: 1.0, p95: 2.0, p99: 2.0 });
    }

    #[test]
    fn the_first_difference_carries_both_values() {
        let found = first_difference(&[1.0, 2.0, 3.0], &[1.0, 2.1, 9.0], 0.2);
        assert_eq!(found, Some(Difference { index: 2, a: 3.0, b: 9.0 }));
        assert_eq!(first_difference(&[0.0], &[-0.0], 0.0), None);
    }

    #[test]
    #[should_panic(expected = "different lengths")]
    fn different_lengths_are_a_mistake_of_the_caller() {
        let _ = ErrorStats::between(&[1.0], &[]);
    }
}
