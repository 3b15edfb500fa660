//! From f64 limits to the f32 values that keep them.

/// The greatest f32 that is not above `limit`; how a distance is cut to a radius that f32 does not hold.
///
/// NaN stays NaN.
#[must_use]
pub fn f32_at_most(limit: f64) -> f32 {
    let nearest = limit as f32;
    if f64::from(nearest) > limit { nearest.next_down() } else { nearest }
}

/// The least f32 that is not below `limit`.
///
/// NaN stays NaN.
#[must_use]
pub fn f32_at_least(limit: f64) -> f32 {
    -f32_at_most(-limit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cutting_to_f32_never_passes_the_limit() {
        assert_eq!(f32_at_most(0.1), 0.099_999_994);
        assert_eq!(f32_at_least(0.1), 0.1);
        assert_eq!(f32_at_most(2.0), 2.0);
        assert_eq!(f32_at_least(-1e-60), 0.0);
        assert_eq!(f32_at_least(1e-60), f32::from_bits(1));
        assert_eq!(f32_at_most(f64::MAX), f32::MAX);
    }
}
