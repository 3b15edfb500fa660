//! What each number of points loses, and how many keep an error.
//!
//! A texel's error in a direction is the angle by which its stored points fail the highest of all candidates at the
//! worst curvature of the range. Bounding its maximum over a map would let one texel in a million decide for all, and
//! its mean would hide that texels differ: the error asked for is kept by 99 of 100.
//!
//! Errors are counted in bins, 16 to an octave, from whole numbers alone: counts may be merged in any order.

use super::params::MAX_POINTS;

/// Of 100 texels and directions, how many must keep the error asked for.
const PERCENT: u64 = 99;

/// Bits of an f32 that are not its exponent's or its first 4 of the fraction.
const DROPPED_BITS: u32 = 23 - 4;

/// The first bin ends at 2⁻²⁰ rad, 5.5e-5°: below the rounding of any table.
const FIRST_BIN: u32 = (127 - 20) << 4;

/// The last bin begins at 2²⁰, a hair below 90°.
const BINS: usize = 40 << 4;

/// Counts of errors, for every number of points.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SelectionErrors {
    /// `[points − 1][bin]`.
    counts: Vec<[u64; BINS]>,
}

impl Default for SelectionErrors {
    fn default() -> Self {
        Self { counts: vec![[0; BINS]; MAX_POINTS] }
    }
}

impl SelectionErrors {
    /// Counts the losses, tangents of angles, of one texel in one direction with 1, 2, … points.
    pub(super) fn add(&mut self, losses: &[f32; MAX_POINTS]) {
        for (counts, loss) in self.counts.iter_mut().zip(losses) {
            counts[bin(*loss)] += 1;
        }
    }

    /// Adds the counts of other texels.
    pub fn merge(&mut self, others: &Self) {
        for (counts, others) in self.counts.iter_mut().zip(&others.counts) {
            for (count, other) in counts.iter_mut().zip(others) {
                *count += other;
            }
        }
    }

    /// The angle that 99 of 100 errors do not exceed with so many points, in degrees; rounded up, by at most 1/16. 0
    /// where nothing was counted.
    ///
    /// # Panics
    ///
    /// When `points` is not 1 to [`MAX_POINTS`].
    #[must_use]
    pub fn percentile_degrees(&self, points: usize) -> f64 {
        let counts = &self.counts[points - 1];
        let total: u64 = counts.iter().sum();
        let mut below = 0;
        for (bin, count) in counts.iter().enumerate() {
            below += count;
            if 100 * below >= PERCENT * total {
                return if total == 0 || bin == 0 { 0.0 } else { bin_end_degrees(bin) };
            }
        }
        90.0
    }

    /// The fewest points that keep an error, in degrees, for 99 of 100; as many as there may be where none do, in
    /// which case more bends will have to be swept as well.
    #[must_use]
    pub fn points_for(&self, max_error_degrees: f64) -> usize {
        (1..=MAX_POINTS).find(|&points| self.percentile_degrees(points) <= max_error_degrees).unwrap_or(MAX_POINTS)
    }
}

fn bin(loss: f32) -> usize {
    ((loss.to_bits() >> DROPPED_BITS).saturating_sub(FIRST_BIN) as usize).min(BINS - 1)
}

fn bin_end_degrees(bin: usize) -> f64 {
    let end = f32::from_bits((FIRST_BIN + bin as u32 + 1) << DROPPED_BITS);
    libm::atan(f64::from(end)).to_degrees()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bin_ends_at_or_a_little_above_what_it_counts() {
        for loss in [2e-6_f32, 1e-3, 0.1, 1.0, 57.3] {
            let (angle, end) = (f64::from(loss).atan().to_degrees(), bin_end_degrees(bin(loss)));
            assert!(end >= angle && end <= angle * 1.07, "{angle} {end}");
        }
        assert_eq!((bin(0.0), bin(f32::MAX)), (0, BINS - 1));
    }

    #[test]
    fn one_in_a_hundred_may_be_worse() {
        let mut errors = SelectionErrors::default();
        let mut losses = [0.0; MAX_POINTS];
        for texel in 0..200 {
            losses[0] = 0.1;
            losses[1] = if texel < 2 { 1.0 } else { 0.001 };
            losses[2] = if texel < 3 { 1.0 } else { 0.0 };
            errors.add(&losses);
        }
        assert!(errors.percentile_degrees(1) > 5.7 && errors.percentile_degrees(1) < 6.1);
        assert!(errors.percentile_degrees(2) < 0.062);
        assert!(errors.percentile_degrees(3) > 45.0);
        assert_eq!(errors.percentile_degrees(4), 0.0);
        assert_eq!([10.0, 1.0, 0.01].map(|degrees| errors.points_for(degrees)), [1, 2, 4]);
    }

    #[test]
    fn merging_is_counting_together() {
        let (mut one, mut other) = (SelectionErrors::default(), SelectionErrors::default());
        one.add(&[0.25; MAX_POINTS]);
        other.add(&[0.5; MAX_POINTS]);
        let mut both = one.clone();
        both.merge(&other);
        other.merge(&one);
        assert_eq!(both, other);
    }
}
