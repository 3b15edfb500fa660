//! Numbers that look random and are the same on every machine and in every run.

/// A bijection that spreads consecutive numbers: Guy Steele, Doug Lea, Christine Flood, *Fast splittable pseudorandom
/// number generators*, 2014.
pub(crate) fn scramble(index: u64) -> u64 {
    let mut z = index.wrapping_add(1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

/// A number in [0, 1) for an index.
pub(crate) fn unit(index: u64) -> f64 {
    (scramble(index) >> 11) as f64 / (1_u64 << 53) as f64
}

/// A number with mean 0 and standard deviation 1 for an index: George Box, Mervin Muller, *A note on the generation of
/// random normal deviates*, 1958.
pub(crate) fn normal(index: u64) -> f64 {
    let radius = libm::sqrt(-2.0 * libm::log(1.0 - unit(2 * index)));
    radius * libm::cos(std::f64::consts::TAU * unit(2 * index + 1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use barchan_metrics::ErrorStats;

    #[test]
    fn the_moments_are_those_of_the_distributions() {
        let uniform = ErrorStats::of((0..100_000).map(unit));
        assert!((uniform.mean() - 0.5).abs() < 0.005 && (0..100_000).all(|index| unit(index) < 1.0));
        let normal = ErrorStats::of((0..100_000).map(normal));
        assert!(normal.mean().abs() < 0.01 && (normal.rms() - 1.0).abs() < 0.01);
        assert!(normal.max().is_finite());
    }
}
