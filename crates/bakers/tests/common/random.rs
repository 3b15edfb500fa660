//! Noise that is the same in every test.

/// Reproducible noise in [0, 1) for a texel.
pub(crate) fn noise(seed: u32, column: u32, row: u32) -> f32 {
    let mut hash = seed.wrapping_mul(0x9E37_79B9) ^ column.wrapping_mul(0x85EB_CA6B) ^ row.wrapping_mul(0xC2B2_AE35);
    for _ in 0..2 {
        hash = (hash ^ (hash >> 15)).wrapping_mul(0x2C1B_3C6D);
        hash = (hash ^ (hash >> 12)).wrapping_mul(0x297A_2D39);
    }
    (hash >> 8) as f32 / (1 << 24) as f32
}
